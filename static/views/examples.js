/** Where a design starts: the papers' examples or empty; what it is called, and by whom it is. */
import { element, html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { following } from "../store.js";

/**
 * `queries` are those of the examples' inputs, as in the address; `labels` what may be said of a
 * design. `on.picked(example)`, `on.cleared()`, `on.labelled(label, text)`.
 */
export function createExamples({ examples, queries, labels, on }) {
  const box = (label) => html`<label>${message(`label.${label}`)}
    <input class="box free-text" data-label="${label}" maxlength="${label === "note" ? 500 : 80}" autocomplete="off"></label>`;
  const root = element(html`
    <div class="examples card">
      <div class="start"><label for="example">${message("examples.label")}</label>
        <button type="button" class="toggle new">${message("form.new")}</button></div>
      <select id="example" class="box">
        <option value="">${message("examples.own")}</option>
        ${examples.map(({ id }) => html`<option value="${id}">${said("examples", id)}</option>`)}
      </select>
      <p class="field-message" id="example-source"></p>
      <details class="more labels"><summary>${message("form.design")}</summary>${labels.map(box)}</details>
    </div>`);
  const select = root.querySelector("select");
  const source = root.querySelector(".field-message");
  const boxes = [...root.querySelectorAll("[data-label]")];
  select.setAttribute("aria-describedby", "example-source");
  select.addEventListener("change", () => {
    const example = examples.find(({ id }) => id === select.value);
    if (example) on.picked(example);
  });
  root.querySelector(".new").addEventListener("click", () => on.cleared());
  root.querySelector(".labels").addEventListener("input", ({ target }) => on.labelled(target.dataset.label, target.value));
  const name = following(({ typed }) => [typed], ({ typed: { texts } }) => {
    for (const one of boxes) if (one.value !== (texts[one.dataset.label] ?? "")) one.value = texts[one.dataset.label] ?? "";
  });
  /** The example that the inputs are, if they are one. */
  const find = following(({ address }) => [address], ({ address }) => {
    const example = examples[queries.indexOf(address)];
    select.value = example?.id ?? "";
    source.textContent = example ? message("examples.source", { source: example.source }) : "";
  });
  return {
    root,
    update(state) {
      name(state);
      find(state);
    },
  };
}
