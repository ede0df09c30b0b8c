/** At the end, folded: what the model leaves out, how exact the numbers are and what that costs, the sources, the papers' errata. */
import { listedOf } from "../lib/checks.js";
import { formatDuration, formatNumber } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { neglectedIn } from "../service_texts.js";
import { following } from "../store.js";

function sectionMarkup([id, { accuracy: { method, method_code: code, relative_error: error, evaluations, run_time_us: time } }]) {
  return html`<li><b>${message(`section.${id}`)}</b>: ${message("results.accuracy", {
    method: said("methods", code) ?? method,
    error: error === 0 ? message("results.none") : formatNumber(error, 2),
    evaluations: formatNumber(evaluations),
    time: formatDuration(time),
  })}</li>`;
}

/** `about` is what the service says of the calculation: `{ model, sources }`; `figures` those of error against run time, none where there is one method. */
export function createAccuracy({ calculator, about, figures }) {
  const list = (items) => html`<ul>${items.map((item) => html`<li>${item}</li>`)}</ul>`;
  const root = element(html`
    <details class="card fold accuracy-fold"><summary><h2>${message("accuracy.title")}</h2></summary>
      <div class="notes">
        <section><h3>${message("accuracy.model")}</h3><p>${message("accuracy.modelWhy")}</p>
          ${list(neglectedIn(about))}</section>
        <section><h3>${message("accuracy.numbers")}</h3><ul class="numbers-of"></ul></section>
        <section><h3>${message("accuracy.sources")}</h3>${list((about?.sources ?? []).map((source) => html`<cite lang="en">${source}</cite>`))}</section>
        <section><h3>${message("notes.title")}</h3>${list(calculator.notes.flatMap((id) => message(`notes.${id}`)))}</section>
      </div>
      ${figures.length > 0 && html`<p class="trade-off">${message("accuracy.tradeOff")}</p>`}
    </details>`);
  root.append(...figures.map((figure) => figure.root));
  const numbers = root.querySelector(".numbers-of");
  return {
    root,
    update: following(({ shown }) => [shown], ({ shown }) => {
      const sections = listedOf(calculator, [shown?.answer]).map((id) => [id, shown?.answer[id]]).filter(([, section]) => section);
      fill(numbers, html`${sections.map(sectionMarkup)}`);
    }),
  };
}
