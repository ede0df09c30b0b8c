/**
 * The answer first: the word over the whole design, the check that governs, the largest torque. It
 * stays in sight; under it stand the few numbers of the calculator and the line of warnings.
 */
import {
  assumedIn, checkRow, coldYield, decisive, isLimited, judgedOf, levelOfWord, lookedAt, notConsidered, partRow, torqueNote, torqueUnknown, unknownIn, usuallyOf, wordNote, wordOf, wordText,
} from "../lib/checks.js";
import { ALL, formatQuantity, quantityParts } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { shownUnit } from "../lib/units.js";
import { message, quantityTitle } from "../messages/index.js";
import { answerNow, following, standing, UNANSWERED } from "../store.js";
import { barMarkup, sign } from "./parts.js";

function cellMarkup({ label, value, exact, unit, note, level }) {
  return html`
    <div class="cell ${level ?? ""}">
      <dt>${label}</dt>
      <dd><span class="figures" title="${exact ?? ""}">${value ?? "–"}</span>${unit && html`<span class="figures-unit">${unit}</span>`}
        <span class="note">${sign(level)}${note ?? message("verdict.missing")}</span></dd>
    </div>`;
}

/** The word, and under it of which inputs the numbers are where they are not of these. */
function wordMarkup({ phase, numbers }, judged, titles) {
  const known = judged && numbers === "fresh";
  const word = known ? wordOf(judged) : null;
  const text = word ? wordText(judged) : message(`state.${phase}`);
  const soFar = word === "incomplete" && Boolean(judged.parts); // neither good nor bad
  const level = word ? !soFar && levelOfWord(word) : ["wrong", "refused", ...UNANSWERED].includes(phase) && "bad";
  const unknown = word === "incomplete" && unknownIn(judged);
  return html`<p class="word ${level || ""} ${soFar && "so-far"}">${sign(level)}${text}</p>
    ${unknown > 0 && html`<p class="note"><button type="button" class="link unknown">${message("checks.unknown", { count: unknown })}</button></p>`}
    <p class="note">${word ? wordNote(judged, titles) : message(`state.${numbers}Note`)}
      ${UNANSWERED.includes(phase) && html`<button type="button" class="link again">${message("state.again")}</button>`}</p>`;
}

function governingMarkup(judged, titles) {
  const check = judged && decisive(judged);
  if (!check) return html`<p class="label">${message("checks.governing")}</p><p class="note">–</p>`;
  const { title, value, limit, used, level, reason, cause } = checkRow(check, titles);
  const numbers = value && limit && html`<b>${value}</b> (${limit})`;
  const says = numbers && check.status !== "not_checked" ? judged.verdict !== "marginal" && cause : reason;
  return html`<p class="label">${message("checks.governing")}: <b>${title}</b></p>
    ${used !== undefined && barMarkup(used, level)}
    <p class="note">${numbers || (!says && value)} ${says}</p>`;
}

/** Largest torque and verdict of the design with what is usual. */
const becomes = ({ largest_torque_Nm: torque, verdict }) =>
  [torque !== undefined && formatQuantity(torque, "N·m"), wordText({ verdict })].filter(Boolean).join(", ");

/** What becomes of the design with a usual clearance, and with a usual ring of pins; or that it is looked for. */
function usualMarkup({ sought, fit, ring }) {
  if (sought) return html`<p class="note usual">${message("checks.usualSought")}</p>`;
  return html`${fit && html`<p class="note usual">${message("checks.usual", {
    fit: fit.class === "printed" ? message("checks.printed") : fit.class, clearance: formatQuantity(fit.hole_clearance_mm, "mm", 3), result: becomes(fit),
  })}</p>`}${ring && html`<details class="note usual"><summary>${message("checks.usualRing", { made: message(`checks.rings.${ring.class}`), result: becomes(ring) })}</summary>
    ${message("checks.usualRingMade", {
      modification: formatQuantity(ring.equidistant_mm, "mm", 3), zone: formatQuantity(ring.pin_zone_diameter_mm, "mm", 3),
      pressure: formatQuantity(ring.max_pressure_MPa.percent_90, "MPa"),
    })}</details>`}`;
}

function usualOf({ shown, usual }, calculator) {
  if (usual?.of.answer === shown.answer) return usual;
  return usuallyOf(calculator, shown.answer).length > 0 && { sought: true };
}

/** Of plastic: when it first yields, in place of a largest torque, which nobody knows. */
const coldOf = ({ numbers }, judged) => judged && numbers !== "part" && coldYield(judged);

const coldMarkup = (cold) => html`${cold && html`<details class="cold"><summary>${cold.short}</summary>${cold.sentence} ${cold.by}</details>`}`;

/** `sought`: it is not known yet. */
function torqueMarkup({ numbers }, judged, usual, sought, cold) {
  const label = html`<p class="label">${quantityTitle("largest_torque_Nm")}</p>`;
  const { largest_torque_Nm: largest } = judged ?? {};
  if (cold) {
    const { value, unit } = quantityParts(cold.torque, "N·m", 3);
    return html`${label}<p><span class="figures">${value}</span> <span class="figures-unit">${unit}</span></p>${usual && usualMarkup(usual)}`;
  }
  if (sought) return html`${label}<p class="sought"><span class="figures">…</span> <span class="figures-unit">${shownUnit("N·m")}</span></p>${usual && usualMarkup(usual)}`;
  if (largest === undefined) return html`${label}<p class="note">${judged && numbers !== "part" ? torqueUnknown(judged) : "–"}</p>${usual && usualMarkup(usual)}`;
  const { value, unit } = quantityParts(largest, "N·m");
  const reserve = judged.torque_reserve && barMarkup(1 / judged.torque_reserve, judged.torque_reserve < 1 ? levelOfWord(judged.verdict) : "good");
  return html`${label}<p><span class="figures" title="${formatQuantity(largest, "N·m", ALL)}">${value}</span> <span class="figures-unit">${unit}</span></p>${reserve}
    <p class="note">${torqueNote(judged)}</p>${usual && usualMarkup(usual)}`;
}

/** A chip for each part: its mark, its name; a click leads to its check or to what it lacks. */
function partsMarkup(parts, known) {
  const judged = parts.filter(({ status }) => status !== "left_out");
  const rows = parts.map(partRow);
  return html`<ul>${rows.map(({ code, title, status, level, mark, words, ask, leaves }) => html`
    <li class="chip ${status}" data-part-of="${code}"><button type="button" data-part="${code}" data-ask="${ask ?? ""}" data-takes="${leaves ? "" : code}" title="${title}: ${words}">
      <span class="mark ${level || ""}" aria-hidden="true">${mark}</span>${message(`parts.short.${code}`)}<span class="unseen">: ${words}</span></button><button
      type="button" class="scope" ${(!known || (leaves && judged.length < 2)) && html`disabled`} data-leaves="${leaves ? code : ""}" data-takes="${leaves ? "" : code}" aria-label="${message(leaves ? "parts.leave" : "parts.take", { part: title })}"
      title="${message(leaves ? "parts.leave" : "parts.take", { part: title })}">${leaves ? "×" : "+"}</button></li>`)}
    <li><button type="button" class="link only" ${!known && html`disabled`} ${judged.length < 2 && html`hidden`}>${message("parts.only")}</button></li>
    <li><button type="button" class="link every" ${!known && html`disabled`} ${judged.length === parts.length && html`hidden`}>${message("parts.all")}</button></li></ul>`;
}

/**
 * `on.again()`: the service is to be asked once more; `on.unknown(judged)` leads to what is not known, `on.asked(path)` leads to a field, `on.shown(code)` to a check,
 * `on.scoped(parts)` judges these parts alone; `scope` are all there are, of a calculator that has any.
 */
export function createVerdict({ calculator, titles, scope: all = [], on }) {
  const root = element(html`
    <section class="verdict card" aria-label="${message("verdict.label")}">
      <div class="judged" tabindex="-1"></div><div class="torque"></div><div class="yields"></div><div class="governing"></div>
      ${all.length > 0 && html`<div class="parts" role="group" aria-label="${message("parts.label")}"></div>`}
    </section>`);
  const part = (name) => root.querySelector(`.${name}`);
  let judgedNow = null;
  const scope = () => judgedNow.parts.filter(({ status }) => status !== "left_out").map(({ code }) => code);
  root.addEventListener("click", ({ target }) => {
    const button = target.closest("button");
    if (!button || (!judgedNow && !button.matches(".again"))) return;
    const { part: code, ask, leaves, takes } = button.dataset;
    if (button.matches(".again")) {
      part("judged").focus(); // the button goes
      on.again();
    } else if (button.matches(".unknown")) on.unknown(judgedNow);
    else if (ask) on.asked(ask);
    else if (leaves) on.scoped(scope().filter((one) => one !== leaves));
    else if (takes) on.scoped(judgedNow.parts.map((one) => one.code).filter((one) => one === takes || scope().includes(one)));
    else if (code) on.shown(judgedNow.parts.find((one) => one.code === code).governing);
    else if (button.matches(".only")) on.scoped(["contact"]);
    else if (button.matches(".every")) on.scoped(judgedNow.parts.map((one) => one.code));
  });
  return {
    root,
    update: following(({ shown, typed, phase, usual, limit }) => [shown, typed, phase, usual, limit], (state) => {
      const judged = judgedOf(calculator, answerNow(state));
      const sought = judged && isLimited(calculator, judged) && state.limit?.of.answer !== state.shown.answer;
      const stands = standing(state);
      const cold = coldOf(stands, judged);
      fill(part("judged"), wordMarkup(stands, judged, titles));
      fill(part("governing"), governingMarkup(judged, titles));
      fill(part("torque"), torqueMarkup(stands, judged, stands.numbers === "fresh" && usualOf(state, calculator), sought, cold));
      fill(part("yields"), coldMarkup(cold));
      judgedNow = judged;
      if (all.length === 0) return;
      const parts = stands.numbers !== "part" && judged?.parts;
      const focused = document.activeElement?.closest?.(".chip")?.dataset.partOf; // its button is made anew
      fill(part("parts"), partsMarkup(parts || all.map((code) => ({ code, status: "not_asked" })), Boolean(parts)));
      if (focused && document.activeElement === document.body) part("parts").querySelector(`[data-part-of="${focused}"] .scope`)?.focus();
    }),
  };
}

/** The few numbers that the calculator is asked for, the line of problems and warnings, what is not looked at. */
export function createNumbers({ calculator }) {
  const root = element(html`
    <section class="summary card" aria-label="${message("results.label")}">
      <dl class="numbers"></dl>
      <p class="say" data-level=""></p>
      <details class="more aside"><summary>${message("checks.rests")}</summary><p></p></details>
    </section>`);
  const numbers = root.querySelector(".numbers");
  const say = root.querySelector(".say");
  const aside = root.querySelector(".aside p");
  const none = calculator.verdict({});
  return {
    root,
    update: following(({ shown, line }) => [shown, line], ({ shown, line: [level, text] }) => {
      fill(numbers, html`${(shown?.cells ?? none).map(cellMarkup)}`);
      // One line that is always there: the problem, the first warning, or that there is none.
      say.dataset.level = level;
      fill(say, html`${sign(level)}<span>${text}</span>`);
      say.title = level === "warning" ? text : "";
      const judged = shown ? judgedOf(calculator, shown.answer) ?? {} : {};
      const looked = ["pass", "marginal"].includes(judged.verdict) && `${lookedAt(judged)}.`;
      aside.textContent = [looked, assumedIn(judged), notConsidered(judged)].filter(Boolean).join(" ");
    }),
  };
}
