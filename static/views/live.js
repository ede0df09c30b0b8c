/** A group beside the results, asked for with them: its numbers in cells, sentences, rows, and its figure. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { warningSentences } from "../service_texts.js";
import { following } from "../store.js";
import { createFigure } from "./figure.js";
import { cellsMarkup, sentencesMarkup, tableMarkup } from "./parts.js";

const NONE = []; // no kept design is drawn over it

/**
 * The calculator's `logic` has the `figure`, of the body that was asked and only where its answer can be drawn (`drawable`),
 * its `note`, and `cells`, `sentences`, `rows` and `tables` of an answer; `more` stands under all.
 */
export function createView({ id, client, titles, logic, more = null }) {
  const root = element(html`
    <div class="${id}"><p class="state"></p>
      <dl class="numbers"></dl><ul class="sentences"></ul>
      <table class="quantities"><tbody></tbody></table><div class="tables"></div>
    </div>`);
  const part = (name) => root.querySelector(name);
  const figure = createFigure({ figure: { section: logic.figure.id, ...logic.figure }, client, titles });
  root.append(figure.root);
  if (logic.note) root.append(element(html`<p class="figure-note">${message(logic.note)}</p>`));
  if (more) root.append(more);
  let drawn = {}; // of the figure: the body, and the results in the shape that it takes

  const numbers = following(({ answer, of }) => [answer, of], ({ answer, body }) => {
    if (!answer) return;
    fill(part(".numbers"), cellsMarkup(logic.cells(answer)));
    fill(part(".sentences"), sentencesMarkup([...logic.sentences(answer, body, titles), ...warningSentences(answer, titles)]));
    fill(part(".quantities tbody"), html`${logic.rows(answer, body).map(([title, value]) => html`
      <tr><th scope="row">${title}</th><td class="value">${value}</td></tr>`)}`);
    fill(part(".tables"), html`${(logic.tables?.(answer) ?? []).map(tableMarkup)}`);
  });

  return {
    root,
    update(state) {
      const now = state.besides[id] ?? {};
      const { phase = "computing", answer, body, refusal, typed } = now;
      root.dataset.stale = String(phase !== "fresh" || typed !== state.typed);
      root.dataset.state = phase;
      const older = typed !== state.typed && state.phase !== "computing" && answer;
      part(".state").textContent = older ? message("besides.older")
        : { computing: message("state.computing"), refused: refusal?.text, failed: refusal?.text }[typed === state.typed ? phase : state.phase] ?? "";
      part(".state").classList.toggle("bad", phase === "refused" || phase === "failed");
      numbers({ ...now, body: body ?? {} });
      // Its figure, which takes longest, comes behind the results.
      if (phase === "fresh") figure.root.hidden = logic.drawable?.(answer) === false;
      if (phase === "fresh" && drawn.body !== body && !figure.root.hidden) drawn = { body, shown: { input: body, filled: body, answer: { [figure.id]: true } } };
      figure.update({ ...state, pending: drawn.body ?? null, shown: drawn.shown ?? null, kept: NONE, refusal: null });
    },
    close() {
      figure.close();
    },
  };
}
