/** The sheet behind a field's "size for": what is wanted, the value that gives it, applied by a click. */
import { newestOnly } from "../lib/api.js";
import { parseNumber, typedText } from "../lib/format.js";
import { fill, html } from "../lib/html.js";
import { solutionOf, solveBody, targetsOf } from "../lib/sizing.js";
import { message } from "../messages/index.js";
import { problemText } from "../service_texts.js";
import { createDialog } from "./parts.js";

const DEBOUNCE_MS = 150;

/** `on.applied(sets)` takes `{pointer: value}` over. */
export function createSizing({ calculator, client, titles, on }) {
  const dialog = createDialog({ id: "sizing", title: message("sizing.title"), content: html`<div class="sizing"></div>` });
  const content = dialog.querySelector(".sizing");
  const newest = newestOnly();
  let about = null; // { field, shown, targets }
  let solution = null;
  let timer = 0;
  const part = (name) => content.querySelector(`[data-part="${name}"]`);

  async function solve() {
    const { field, shown, targets } = about;
    const target = targets[part("target").value];
    const { value: amount, problem: unreadable } = parseNumber(part("amount").value);
    const result = part("result");
    const apply = part("apply");
    apply.disabled = true;
    if (unreadable) {
      newest.cancel(); // an answer for the number before would be taken for one for this
      result.textContent = message(`problem.${unreadable}`);
      return;
    }
    const want = part("want").value;
    result.textContent = message("state.computing");
    const { answer, problem, superseded } = await newest.ask((signal) =>
      client.post("/solve", solveBody(calculator, field, shown, target, amount, want), { signal }));
    if (superseded) return;
    solution = answer ? solutionOf(field, target, want, answer) : { text: problemText(problem, titles) };
    const refused = answer?.refused && message("sizing.refused", { why: problemText({ errors: answer.refused }, titles) });
    result.textContent = [solution.text, refused].filter(Boolean).join(" ");
    apply.disabled = !solution.sets;
  }

  function sense() {
    part("sense").textContent = message(`sizing.${about.targets[part("target").value].sense}`);
  }

  function soon() {
    clearTimeout(timer);
    newest.cancel();
    part("apply").disabled = true;
    timer = setTimeout(solve, DEBOUNCE_MS);
  }

  content.addEventListener("input", ({ target }) => {
    if (target.dataset.part === "target") {
      part("amount").value = typedText(String(about.targets[target.value].value));
      sense();
    }
    soon();
  });
  content.addEventListener("click", ({ target }) => {
    if (target.dataset.part !== "apply") return;
    dialog.close();
    on.applied(solution.sets);
  });

  return {
    /** Open it for a field and the results on the screen. */
    open(field, shown) {
      clearTimeout(timer);
      about = { field, shown, targets: targetsOf(calculator, shown.answer, field.path) };
      solution = null;
      const load = field.name.endsWith("_Nm");
      fill(content, html`
        <p class="sizing-field">${field.title}</p>
        <label>${message("sizing.want")} <select class="box" data-part="want">
          <option value="smallest" ${!load && html`selected`}>${message("sizing.least")}</option>
          <option value="largest" ${load && html`selected`}>${message("sizing.most")}</option></select></label>
        <label>${message("sizing.for")} <select class="box" data-part="target">${about.targets.map(({ id, title }) => html`<option value="${id}">${title}</option>`)}</select></label>
        <label><span data-part="sense"></span> <input class="box free-text" data-part="amount" inputmode="decimal" autocomplete="off" value="${typedText(String(about.targets[0].value))}"></label>
        <p data-part="result" role="status"></p>
        <button type="button" class="primary" data-part="apply" disabled>${message("sizing.apply")}</button>`);
      sense();
      dialog.showModal();
      part("amount").select();
      solve();
    },
    close() {
      clearTimeout(timer);
      newest.cancel();
      dialog.remove();
    },
  };
}
