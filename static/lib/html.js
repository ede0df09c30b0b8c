/** A template tag that escapes what is put in, so that a text can never become markup. */

class Markup {
  constructor(text) {
    this.text = text;
  }
  toString() {
    return this.text;
  }
}

const ESCAPES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };

function piece(value) {
  if (value instanceof Markup) return value.text;
  if (Array.isArray(value)) return value.map(piece).join("");
  if (value === null || value === undefined || value === false) return "";
  return String(value).replace(/[&<>"']/g, (character) => ESCAPES[character]);
}

/** Only the template's own text is markup; nested `html` pieces and lists of them are kept. */
export function html(strings, ...values) {
  return new Markup(strings.reduce((all, part, i) => all + piece(values[i - 1]) + part));
}

/** The single element that the markup describes. */
export function element(markup) {
  const template = document.createElement("template");
  template.innerHTML = markup.toString().trim();
  return template.content.firstElementChild;
}

/** Put the markup into `host`, leaving the document alone when nothing would change. */
export function fill(host, markup) {
  const text = markup.toString();
  if (host.filledWith === text) return;
  host.filledWith = text;
  host.innerHTML = text;
}

/** Tells `act(value, part)` of clicks in parts of `host` that have a value of that data attribute. */
export function clicks(host, name, act) {
  host.addEventListener("click", ({ target }) => {
    const part = target.closest(`[data-${name}]`);
    if (part?.dataset[name]) act(part.dataset[name], part);
  });
}
