/**
 * The answer first: the word over the whole design, the check that governs, the largest torque. It
 * stays in sight; under it stand the few numbers of the calculator and the line of warnings.
 */
import { assumedIn, checkRow, decisive, judgedOf, levelOfWord, notConsidered, torqueDigits, torqueUnknown, wordNote, wordOf } from "../lib/checks.js";
import { quantityParts } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { following, standing, UNANSWERED } from "../store.js";
import { barMarkup, keepRoom, sign } from "./parts.js";

function cellMarkup({ label, value, unit, note, level }) {
  return html`
    <div class="cell ${level ?? ""}">
      <dt>${label}</dt>
      <dd><span class="figures">${value ?? "–"}</span>${unit && html`<span class="figures-unit">${unit}</span>`}
        <span class="note">${sign(level)}${note ?? message("verdict.missing")}</span></dd>
    </div>`;
}

/** The word, and under it of which inputs the numbers are where they are not of these. */
function wordMarkup({ phase, numbers }, judged) {
  const known = judged && numbers === "fresh";
  const word = known ? wordOf(judged) : null;
  const text = word ? message(`verdictWord.${word}`) : message(`state.${phase}`);
  const level = word ? levelOfWord(word) : ["wrong", "refused", ...UNANSWERED].includes(phase) && "bad";
  return html`<p class="word ${level || ""}">${sign(level)}${text}</p>
    <p class="note">${word ? wordNote(judged) : message(`state.${numbers}Note`)}
      ${UNANSWERED.includes(phase) && html`<button type="button" class="link again">${message("state.again")}</button>`}</p>`;
}

function governingMarkup(judged, titles) {
  const check = judged && decisive(judged);
  if (!check) return html`<p class="label">${message("checks.governing")}</p><p class="note">–</p>`;
  const { title, value, limit, used, level, reason, judged: known } = checkRow(check, titles);
  return html`<p class="label">${message("checks.governing")}: <b>${title}</b></p>
    ${used !== undefined && known && barMarkup(used, level)}
    <p class="note">${value && limit ? html`<b>${value}</b> (${limit})` : reason || value}</p>`;
}

function torqueMarkup({ numbers }, judged) {
  const label = html`<p class="label">${message("checks.torque")}</p>`;
  const { largest_torque_Nm: largest, largest_torque_estimated: estimated } = judged ?? {};
  if (largest === undefined) return html`${label}<p class="note">${judged && numbers !== "part" ? torqueUnknown(judged) : "–"}</p>`;
  const { value, unit } = quantityParts(largest, "N·m", torqueDigits(judged));
  return html`${label}<p><span class="figures">${estimated && "≈\u00a0"}${value}</span> <span class="figures-unit">${unit}</span></p>
    ${estimated && html`<p class="note">${message("checks.estimated")}</p>`}`;
}

/** `on.again()`: the service is to be asked once more. */
export function createVerdict({ calculator, titles, on }) {
  const root = element(html`
    <section class="verdict card" aria-label="${message("verdict.label")}">
      <div class="judged" tabindex="-1"></div><div class="governing"></div><div class="torque"></div>
      <nav class="jumps" aria-label="${message("jumps.label")}">${["answer", "inputs", "shown", "rest"].map((id) => html`
        <button type="button" class="link" data-jump="${id}">${message(`jumps.${id}`)}</button>`)}</nav>
    </section>`);
  root.querySelector(".jumps").addEventListener("click", ({ target }) => {
    document.querySelector(`.workbench .${target.dataset.jump}`)?.scrollIntoView();
  });
  const part = (name) => root.querySelector(`.${name}`);
  root.addEventListener("click", ({ target }) => {
    if (!target.closest(".again")) return;
    part("judged").focus(); // the button goes
    on.again();
  });
  return {
    root,
    update: following(({ shown, typed, phase }) => [shown, typed, phase], (state) => {
      const judged = judgedOf(calculator, state.shown?.answer);
      const stands = standing(state);
      fill(part("judged"), wordMarkup(stands, judged));
      fill(part("governing"), governingMarkup(judged, titles));
      fill(part("torque"), torqueMarkup(stands, judged));
    }),
  };
}

/** The few numbers that the calculator is asked for, the line of problems and warnings, what is not looked at. */
export function createNumbers({ calculator }) {
  const root = element(html`
    <section class="summary card" aria-label="${message("results.label")}">
      <dl class="numbers"></dl>
      <p class="say" data-level=""></p>
      <p class="aside"></p>
    </section>`);
  const numbers = root.querySelector(".numbers");
  const say = root.querySelector(".say");
  const aside = root.querySelector(".aside");
  const keepAside = keepRoom(aside);
  const none = calculator.verdict({});
  return {
    root,
    update: following(({ shown, line }) => [shown, line], ({ shown, line: [level, text] }) => {
      fill(numbers, html`${(shown?.cells ?? none).map(cellMarkup)}`);
      // One line that is always there: the problem, the first warning, or that there is none.
      say.dataset.level = level;
      fill(say, html`${sign(level)}<span>${text}</span>`);
      const judged = shown ? judgedOf(calculator, shown.answer) ?? {} : {};
      aside.textContent = [assumedIn(judged), notConsidered(judged)].filter(Boolean).join(" ");
      keepAside();
    }),
  };
}
