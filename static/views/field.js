/** One box of the form: title, symbol, box, unit, and under it a line kept free for its message; its help is in the form's line. */
import { element, fill, html } from "../lib/html.js";
import { shortOf } from "../lib/outline.js";
import { message, said } from "../messages/index.js";
import { shownUnit } from "../lib/units.js";
import { symbolMarkup } from "./parts.js";

function box(field, id) {
  if (["name", "option", "flag"].includes(field.kind)) {
    return html`<select id="${id}" class="box" aria-describedby="${id}-message"></select>`;
  }
  const mode = field.kind === "integer" ? "numeric" : field.kind === "numbers" ? "text" : "decimal";
  return html`<input id="${id}" class="box" type="text" inputmode="${mode}" autocomplete="off"
    spellcheck="false" aria-describedby="${id}-unit ${id}-message">`;
}

function labelMarkup(field, id) {
  const name = shortOf(field.title);
  return html`<label for="${id}" title="${name === field.title ? field.help : message("rows.help", field)}"><span
    class="field-name">${name}</span>${field.symbol && symbolMarkup(field.symbol)}</label>`;
}

/**
 * `on.typed(text)` follows the typing, `on.step(direction, factor)` the arrow keys, `on.suggest()`
 * the suggestion's button, `on.asked(path)` leads to a field.
 */
export function createField(field, { suggestion, sizable, on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const root = element(html`
    <div class="field kind-${field.kind}" data-path="${field.path}">
      ${labelMarkup(field, id)}
      <span class="entry">
        ${suggestion && html`<button type="button" class="suggest"></button>`}
        ${box(field, id)}
        ${sizable && html`<button type="button" class="size" aria-haspopup="menu" aria-label="${message("menu.of", { field: field.title })}"
          title="${message("menu.of", { field: field.title })}">⋮</button>`}
        <span class="unit" id="${id}-unit">${shownUnit(field.unit)}</span>
      </span>
      <p class="field-message" id="${id}-message"><span></span> <button type="button" class="link" hidden></button></p>
    </div>`);
  const input = root.querySelector(".box");
  const line = root.querySelector(".field-message span");
  const button = root.querySelector(".suggest");
  const link = root.querySelector(".field-message .link");
  let asked = null;

  input.addEventListener("input", () => on.typed(input.value));
  input.addEventListener("keydown", (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!direction || event.altKey || event.ctrlKey || event.metaKey) return;
    if (field.kind !== "number" && field.kind !== "integer") return;
    event.preventDefault();
    on.step(direction, event.shiftKey ? 10 : 1);
  });
  const size = root.querySelector(".size");
  size?.addEventListener("click", () => on.menu(size));
  button?.addEventListener("click", () => on.suggest());
  link.addEventListener("click", () => on.asked(asked));

  return {
    root,
    focus: () => input.focus(),
    setText(text) {
      if (input.value !== text) input.value = text;
    },
    /** The message of an error, or the quiet note that takes its place; `ask`, the field that it asks for. */
    setMessage({ error = "", note = "", ask }) {
      asked = ask?.path;
      link.hidden = !asked;
      if (asked) link.textContent = `${message("checks.enter")} ${ask.title}`;
      const shown = error || note || field.help;
      if (line.textContent !== shown) line.textContent = shown;
      root.classList.toggle("wrong", error !== "");
      root.classList.toggle("noted", error === "" && note !== "");
      if (error) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    },
    /** Whether a value may be looked for here. */
    setSizable(possible) {
      if (size) size.classList.toggle("idle", !possible);
      if (size) size.disabled = !possible;
    },
    setPlaceholder(text) {
      input.placeholder = text;
    },
    /** What stands for it while it is empty. */
    setAssumed(text) {
      const [none] = input.options ?? [];
      if (none?.value === "") none.textContent = text || "–";
      else input.placeholder = text;
      if (text) root.dataset.origin = "usual";
    },
    setSuggestion({ formula, label, possible, pressed }) {
      if (button.dataset.formula !== formula) fill(button, symbolMarkup(formula));
      button.dataset.formula = formula;
      button.disabled = !possible;
      button.setAttribute("aria-pressed", String(pressed));
      button.setAttribute("aria-label", label);
      button.title = label;
    },
    /** The names to choose from: `[{ name, title, group }]`; a name not among them stays selectable. */
    setNames(names, current) {
      const known = names.some(({ name }) => name === current) || current === "";
      const all = known ? names : [...names, { name: current, title: current }];
      const option = ({ name, title }) => html`<option value="${name}">${said("materials", name) ?? title ?? name}</option>`;
      const groups = [...new Set(all.map(({ group_code: group }) => group ?? ""))];
      fill(input, html`${groups.map((group) => {
        const members = all.filter((one) => (one.group_code ?? "") === group).map(option);
        return group === "" ? members : html`<optgroup label="${said("material_groups", group) ?? group}">${members}</optgroup>`;
      })}`);
      input.value = current;
    },
  };
}
