/** A section of the inputs: a line with its values and the worst of what hangs on them, and the rows that it opens. */
import { element, fill, html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { sign, symbolMarkup } from "./parts.js";

const ROWS = 18; // in sight; more are folded
const VALUES = 5;
const WORST = ["bad", "warning", "good"];

/** What a box says, with its symbol; nothing where it is empty or a list. */
function valueMarkup({ kind, symbol, path }, text) {
  if (text === "" || ["records", "switch", "names", "numbers", "flag"].includes(kind)) return null;
  if (kind === "number" || kind === "integer") return symbol && html`${symbolMarkup(symbol)}\u00a0${text}`;
  return said("materials", text) ?? (path.endsWith("name") ? text : message("option")[text]);
}

/** `title` names it; what it holds is added. */
export function createSection({ id, title }) {
  const root = element(html`<div class="group" data-group="${id}"><details class="section">
    <summary><h2>${title}</h2><span class="values"></span><span class="mark"></span></summary>
    <fieldset class="rows" aria-label="${title}"></fieldset><button type="button" class="link beyond-rows" hidden></button></details></div>`);
  const details = root.firstElementChild;
  const [values, mark] = root.querySelectorAll(".values, .mark");
  const rows = root.querySelector(".rows");
  const button = root.querySelector(".beyond-rows");
  let whole = false; // all rows are in sight

  /** Rows that are neither typed nor among the first wait behind a button. */
  function limit() {
    const shown = [...rows.querySelectorAll(":scope > .field, :scope > .choice, .wanted-fields > .field, .wanted-fields > .choice")].filter((row) => !row.hidden);
    const beyond = shown.slice(ROWS).filter(({ dataset, classList }) => !whole && dataset.origin !== "typed" && !classList.contains("wrong"));
    for (const row of shown) row.classList.toggle("beyond", beyond.includes(row));
    button.hidden = beyond.length === 0;
    button.textContent = message("form.more", { count: beyond.length });
  }
  function reveal() {
    whole = true;
    limit();
  }
  button.addEventListener("click", reveal);
  return {
    root,
    details,
    rows,
    reveal,
    /** Items of which those that are `rare` fold. */
    add(items, rare, addItem, host = rows) {
      const rest = items.filter(rare);
      for (const item of items.filter((one) => !rare(one))) addItem(item, host);
      if (rest.length === 0) return;
      const more = element(html`<details class="more"><summary>${message("form.more", { count: rest.length })}</summary></details>`);
      for (const item of rest) addItem(item, more);
      host.append(more);
    },
    /** `typed` are the fields that are shown, with their texts. */
    summarise(typed) {
      const known = typed.map(([field, text]) => valueMarkup(field, text)).filter(Boolean).slice(0, VALUES);
      values.hidden = known.length === 0;
      limit();
      fill(values, html`${known.map((value, i) => [i > 0 && ", ", value])}`);
    },
    /** The worst level of what hangs on it. */
    judge(levels) {
      const worst = WORST.find((level) => levels.includes(level));
      fill(mark, html`${sign(worst)}${worst && html`<span class="unseen">${message(`form.worst.${worst}`)}</span>`}`);
    },
  };
}
