/** A segmented choice: radio buttons of which one is chosen, and its fields shown under them. */
import { element, html } from "../lib/html.js";

export function createChoice({ id, title, options }, { on }) {
  const name = `choice-${id.replaceAll(".", "-")}`;
  const root = element(html`
    <fieldset class="choice" data-choice="${id}">
      <legend>${title}</legend>
      <div class="segments">${options.map((option) => html`
        <label class="segment"><input type="radio" name="${name}" value="${option.id}"><span>${option.title}</span></label>`)}
      </div>
      ${options.map((option) => html`<div class="option" data-option="${option.id}"></div>`)}
    </fieldset>`);
  root.querySelector(".segments").addEventListener("change", (event) => on.chosen(event.target.value));
  const parts = [...root.querySelectorAll(".option")];
  return {
    root,
    part: (option) => parts.find((part) => part.dataset.option === option),
    setChosen(chosen) {
      for (const radio of root.querySelectorAll("input[type=radio]")) {
        if (radio.name === name) radio.checked = radio.value === chosen;
      }
      for (const part of parts) part.hidden = part.dataset.option !== chosen;
    },
  };
}
