/** The strip over the results: the few numbers that decide, and whether they match the inputs. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";

const SIGNS = { good: "✓", bad: "✕", warning: "▲" };
// A tick judges a design: that numbers and inputs belong together gets none.
const STATE_SIGNS = { computing: "…", wrong: "✕", refused: "✕", offline: "✕" };

function cellMarkup({ label, value, unit, note, level }) {
  const sign = level && html`<span class="sign ${level}" aria-hidden="true">${SIGNS[level]}</span>`;
  return html`
    <div class="cell ${level ?? ""}">
      <dt>${label}</dt>
      <dd><span class="figures">${value ?? "–"}</span>${unit && html`<span class="figures-unit">${unit}</span>`}
        <span class="note">${sign}${note ?? message("verdict.missing")}</span></dd>
    </div>`;
}

function stateMarkup(state, note) {
  const sign = STATE_SIGNS[state] && html`<span class="sign ${state === "computing" ? "" : "bad"}" aria-hidden="true">${STATE_SIGNS[state]}</span>`;
  return html`
    <div class="cell state ${state}">
      <dt>${message("state.label")}</dt>
      <dd><span class="figures">${sign}${message(`state.${state}`)}</span>
        <span class="note">${message(`state.${note}Note`)}</span></dd>
    </div>`;
}

export function createVerdict() {
  const root = element(html`
    <section class="verdict card" aria-label="${message("verdict.label")}">
      <div class="cells"><dl class="numbers"></dl><dl class="now"></dl></div>
      <p class="say" data-level=""></p>
    </section>`);
  const numbers = root.querySelector(".numbers");
  const now = root.querySelector(".now");
  const say = root.querySelector(".say");
  return {
    root,
    setCells: (cells) => fill(numbers, html`${cells.map(cellMarkup)}`),
    /** How it stands, and what the numbers are of: these inputs, a part, older ones, none yet. */
    setState: (state, note) => fill(now, stateMarkup(state, note)),
    /** One line that is always there: the problem, the first warning, or that there is none. */
    setMessage(level, text) {
      say.dataset.level = level;
      fill(say, html`<span class="sign ${level}" aria-hidden="true">${SIGNS[level] ?? ""}</span><span>${text}</span>`);
    },
  };
}

/** The verdict in one sentence, for those who hear it. */
export function spoken(cells) {
  const words = cells.filter(({ note }) => note !== undefined)
    .map(({ label, value, unit, note }) => `${[label, value, unit].filter(Boolean).join(" ")}, ${note}`);
  return message("verdict.announce", { cells: `${words.join(". ")}.` });
}
