/** The strip over the results: the few numbers that decide, and whether they match the inputs. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { following, standing } from "../store.js";
import { sign } from "./parts.js";

// A tick judges a design: that numbers and inputs belong together gets none.
const PHASE_SIGNS = { wrong: "bad", refused: "bad", offline: "bad" };

function cellMarkup({ label, value, unit, note, level }) {
  return html`
    <div class="cell ${level ?? ""}">
      <dt>${label}</dt>
      <dd><span class="figures">${value ?? "–"}</span>${unit && html`<span class="figures-unit">${unit}</span>`}
        <span class="note">${sign(level)}${note ?? message("verdict.missing")}</span></dd>
    </div>`;
}

function phaseMarkup({ phase, numbers }) {
  const mark = phase === "computing" ? html`<span class="sign" aria-hidden="true">…</span>` : sign(PHASE_SIGNS[phase]);
  return html`
    <div class="cell state ${phase}">
      <dt>${message("state.label")}</dt>
      <dd><span class="figures">${mark}${message(`state.${phase}`)}</span>
        <span class="note">${message(`state.${numbers}Note`)}</span></dd>
    </div>`;
}

export function createVerdict({ calculator }) {
  const root = element(html`
    <section class="verdict card" aria-label="${message("verdict.label")}">
      <div class="cells"><dl class="numbers"></dl><dl class="now"></dl></div>
      <p class="say" data-level=""></p>
    </section>`);
  const numbers = root.querySelector(".numbers");
  const now = root.querySelector(".now");
  const say = root.querySelector(".say");
  const none = calculator.verdict({});
  return {
    root,
    update: following(({ shown, typed, phase, line }) => [shown, typed, phase, line], (state) => {
      fill(numbers, html`${(state.shown?.cells ?? none).map(cellMarkup)}`);
      fill(now, phaseMarkup(standing(state)));
      // One line that is always there: the problem, the first warning, or that there is none.
      const [level, text] = state.line;
      say.dataset.level = level;
      fill(say, html`${sign(level)}<span>${text}</span>`);
    }),
  };
}
