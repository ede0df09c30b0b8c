/** Boxes of groups that are off until wanted: the switch, a set of choices. */
import { element, html } from "../lib/html.js";
import { quantityTitle, said } from "../messages/index.js";

/** The switch of a group; what it says is its title. */
export function createSwitch(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const root = element(html`
    <div class="switch" data-path="${field.path}" title="${field.help}">
      <input type="checkbox" role="switch" aria-label="${field.title}" aria-describedby="${id}-message">
      <span class="unseen" id="${id}-message">${field.help}</span></div>`);
  const input = root.querySelector("input");
  input.addEventListener("change", () => on.switched(input.checked));
  // A box that is left may change its height, and the switch would move from under the pointer.
  input.addEventListener("mousedown", (event) => event.preventDefault());
  return {
    root,
    focus: () => input.focus(),
    setText(text) {
      input.checked = text === "on";
    },
    setMessage() {},
  };
}

/** Some of a list of names. */
export function createNames(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const title = (name) => said("not_considered", name) ?? quantityTitle(name, field.section);
  const root = element(html`
    <fieldset class="field kind-names" data-path="${field.path}"><legend>${field.title}</legend>
      ${field.options.map((name) => html`<label><input type="checkbox" value="${name}" aria-describedby="${id}-message"><span>${title(name)}</span></label>`)}
      <p class="field-message" id="${id}-message"><span></span></p></fieldset>`);
  const boxes = [...root.querySelectorAll("input")];
  const line = root.querySelector(".field-message span");
  root.addEventListener("change", () => on.typed(boxes.filter(({ checked }) => checked).map(({ value }) => value).join("; ")));
  return {
    root,
    focus: () => boxes[0].focus(),
    setText(text) {
      const names = text.split(/;\s*/);
      for (const box of boxes) box.checked = names.includes(box.value);
    },
    setMessage({ error = "" }) {
      line.textContent = error || field.help;
      root.classList.toggle("wrong", error !== "");
    },
  };
}
