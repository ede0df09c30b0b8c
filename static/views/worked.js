/** Every result worked from its formula: a section each, folded; asked of the service and built when it is opened. */
import { newestOnly } from "../lib/api.js";
import { ALL, digitsOf, formatNumber, formatQuantity, quantityParts, unitOf } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { message, quantityTitle, said } from "../messages/index.js";
import { mathml, mathSymbol, plainSymbol, plainText } from "../lib/formula/mathml.js";
import { parse } from "../lib/formula/notation.js";
import { shownAsIs } from "../lib/units.js";
import { passingText } from "../service_texts.js";
import { following } from "../store.js";

const WORKED = 6; // digits of what is to be calculated again by hand
const CODES = { criterion: "criteria", source: "sources" }; // parameters of a note that have words of their own
const AFTER = "after "; // before the number of an equation that a formula follows

function math(content, said) {
  return html`<math aria-label="${said}"><mrow>${content}</mrow></math>`;
}

const EQUAL = html`<mo form="infix">=</mo>`;

/** `= value`, written and spoken. */
function equals(value, unit, digits) {
  const shown = quantityParts(value, unit, Number.isInteger(value) && shownAsIs(unit) ? ALL : digits);
  const own = unit && html`<mtext>${unit === "°" ? "°" : `\u202f${shown.unit}`}</mtext>`;
  return [html`${EQUAL}<mn>${shown.value}</mn>${own}`, `= ${formatQuantity(value, unit, digits)}`];
}

function stated(symbol, [written, spoken]) {
  return math(html`${mathSymbol(symbol)}${written}`, `${plainSymbol(symbol)} ${spoken}`);
}

/** `symbol = formula`, `= numbers`, `= value`: a formula each, so that lines break between them; of a method its numbers. */
function formulas({ symbol, formula, names, values: given, code, result: value }, digits) {
  const result = equals(value, unitOf(code), digits);
  if (!formula) {
    const numbers = Object.entries(given).map(([own, amount]) => stated(own, equals(amount, unitOf(names[own]), digits)));
    return html`${stated(symbol, result)}${numbers.length > 0 && html`<span class="step-given">${message("worked.given")} ${numbers}</span>`}`;
  }
  const tree = parse(formula);
  const values = Object.fromEntries(Object.entries(given).map(([own, amount]) => [own, { value: amount, unit: unitOf(names[own]) }]));
  const numbers = { values, withNumbers: true, digits };
  return html`
    ${stated(symbol, [html`${EQUAL}${mathml(tree)}`, `= ${plainText(tree)}`])}
    ${math(html`${EQUAL}${mathml(tree, numbers)}`, `= ${plainText(tree, numbers)}`)}
    ${math(...result)}`;
}

function noteText(code, params = {}) {
  const words = ([name, value]) => {
    if (typeof value === "string") return said(CODES[name], value) ?? value;
    return unitOf(name) ? formatQuantity(value, unitOf(name)) : formatNumber(value);
  };
  return said("worked_notes", code, Object.fromEntries(Object.entries(params).map((param) => [param[0], words(param)])));
}

function sourceText({ source, equation = "" }) {
  const words = said("worked_sources", source);
  const after = equation.startsWith(AFTER);
  const number = after ? equation.slice(AFTER.length) : equation;
  return number ? message(after ? "worked.after" : "worked.equation", { source: words, number }) : words;
}

function stepMarkup(step, section, accuracy) {
  const { code, source, erratum, params } = step;
  const note = step.note ?? step.method;
  return html`
    <li class="step" data-name="${code}">
      <p class="step-head"><span class="step-title">${said("worked_values", code) ?? quantityTitle(code, section)}</span>
        ${source && html`<span class="step-source">${sourceText(step)}</span>`}</p>
      <div class="formulas">${formulas(step, digitsOf(code, accuracy, WORKED))}</div>
      ${note && html`<p class="step-note">${noteText(note, params)}</p>`}
      ${erratum && html`<p class="step-note erratum">${message("worked.corrected", {
        words: said("worked_errata", erratum),
      })}</p>`}
    </li>`;
}

/** Steps of a section, with as many digits as its accuracy allows. */
export function groupMarkup({ section, steps }, accuracy) {
  const { relative_error: error, method, method_code: code } = accuracy;
  return html`<ol class="steps">${steps.map((step) => stepMarkup(step, section, accuracy))}</ol>
    <p class="accuracy">${message("worked.accuracy", {
      error: error === 0 ? message("results.none") : formatNumber(error, 2), method: said("methods", code) ?? method,
    })}</p>`;
}

/** What was asked for the results on the screen, once more for the steps of some of their sections. */
export async function askSteps({ requests }, sections, client, signal) {
  const answers = await Promise.all(requests.map(({ path, body }) => client.post(path.slice(client.base.length), {
    ...body, include: [...(body.include ?? []).filter((id) => sections.includes(id)), "worked"],
  }, { signal })));
  return answers.flatMap(({ worked = [] }) => worked);
}

export function createWorked({ calculator, client, titles }) {
  const root = element(html`
    <details class="card fold worked"><summary><h2>${message("worked.title")}</h2></summary>
      <div class="worked-groups"></div>
    </details>`);
  const host = root.querySelector(".worked-groups");
  const newest = newestOnly();
  let shown = null; // the results on the screen
  let known = new Map(); // their steps, by section

  const all = () => [...host.querySelectorAll("details")];
  const sectionOf = ({ dataset }) => dataset.section;

  function build(details) {
    const section = sectionOf(details);
    details.removeAttribute("aria-busy");
    fill(details.querySelector(".worked-steps"), groupMarkup({ section, steps: known.get(section) }, shown.answer[section].accuracy));
  }

  /** Ask for the steps of these that are not known yet, and build them; what was not to be had is said there. */
  async function show(groups) {
    const missing = groups.filter((details) => !known.has(sectionOf(details)));
    for (const details of groups) {
      if (known.has(sectionOf(details))) build(details);
      else details.setAttribute("aria-busy", "true");
    }
    if (missing.length === 0) return;
    const sections = missing.map(sectionOf);
    const { answer, problem, superseded } = await newest.ask((signal) => askSteps(shown, sections, client, signal));
    if (superseded) return;
    const found = answer?.filter((step) => calculator.worked?.(step, shown.answer) ?? true);
    for (const section of answer ? [...sections, ...answer.map((step) => step.section)] : []) {
      known.set(section, found.filter((step) => step.section === section));
    }
    for (const details of missing.filter((each) => each.isConnected)) {
      details.removeAttribute("aria-busy");
      if (answer) build(details);
      else fill(details.querySelector(".worked-steps"), html`<p class="note">${passingText(problem, titles)}</p>`);
    }
  }

  const unfolded = () => all().filter((details) => details.open);
  host.addEventListener("toggle", ({ target }) => {
    if (target.open) show(unfolded());
  }, true);

  return {
    root,
    update: following(({ shown }) => [shown], ({ shown: now }) => {
      if (!now) return;
      [shown, known] = [now, new Map()];
      newest.cancel();
      const sections = calculator.sections.filter((id) => now.answer[id]);
      if (all().map(sectionOf).join() !== sections.join()) {
        const open = unfolded().map(sectionOf);
        fill(host, html`${sections.map((section) => html`
          <details data-section="${section}"><summary>${message(`section.${section}`)}</summary><div class="worked-steps" tabindex="0" role="group" aria-label="${message(`section.${section}`)}"></div></details>`)}`);
        for (const details of all()) details.open = open.includes(sectionOf(details));
      }
      for (const details of all().filter(({ open }) => !open)) fill(details.querySelector(".worked-steps"), html``);
      show(unfolded());
    }),
    close: () => newest.cancel(),
  };
}
