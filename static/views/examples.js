/** The papers' examples to start from, and where the chosen one comes from. */
import { element, html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { following } from "../store.js";

/** `queries` are those of the examples' inputs, as in the address. */
export function createExamples({ examples, queries, on }) {
  const root = element(html`
    <div class="examples card">
      <label for="example">${message("examples.label")}</label>
      <select id="example" class="box">
        <option value="">${message("examples.own")}</option>
        ${examples.map(({ id, title }) => html`<option value="${id}">${said("examples", id) ?? title}</option>`)}
      </select>
      <p class="field-message" id="example-source"></p>
    </div>`);
  const select = root.querySelector("select");
  const source = root.querySelector(".field-message");
  select.setAttribute("aria-describedby", "example-source");
  select.addEventListener("change", () => {
    const example = examples.find(({ id }) => id === select.value);
    if (example) on.picked(example);
  });
  return {
    root,
    /** The example that the inputs are, if they are one. */
    update: following(({ address }) => [address], ({ address }) => {
      const example = examples[queries.indexOf(address)];
      select.value = example?.id ?? "";
      source.textContent = example ? message("examples.source", { source: example.source }) : "";
    }),
  };
}
