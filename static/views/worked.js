/** Every result worked from its formula: a section each, folded, built when it is opened. */
import { formatNumber, formatQuantity, quantityParts, resultDigits } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { message, quantityWords, said } from "../messages/index.js";
import { mathml, mathSymbol, plainSymbol, plainText } from "../lib/formula/mathml.js";
import { parse } from "../lib/formula/notation.js";
import { shownAsIs } from "../lib/units.js";
import { following } from "../store.js";

function math(content, said) {
  return html`<math aria-label="${said}"><mrow>${content}</mrow></math>`;
}

/** `symbol = formula`, `= numbers`, `= value`: a formula each, so that lines break between them. */
function formulas({ symbol, formula, values, value, unit }, digits) {
  const name = mathSymbol(symbol);
  const spoken = plainSymbol(symbol);
  const shown = quantityParts(value, unit, Number.isInteger(value) && shownAsIs(unit) ? 15 : digits);
  const result = html`<mn>${shown.value}</mn>${unit && html`<mtext>${unit === "°" ? "°" : `\u202f${shown.unit}`}</mtext>`}`;
  const resultSaid = formatQuantity(value, unit, digits);
  const equal = html`<mo form="infix">=</mo>`;
  if (!formula) return math(html`${name}${equal}${result}`, `${spoken} = ${resultSaid}`);
  const tree = parse(formula);
  const numbers = { values, withNumbers: true, digits };
  return html`
    ${math(html`${name}${equal}${mathml(tree, { values })}`, `${spoken} = ${plainText(tree, { values })}`)}
    ${!tree.name && math(html`${equal}${mathml(tree, numbers)}`, `= ${plainText(tree, numbers)}`)}
    ${math(html`${equal}${result}`, `= ${resultSaid}`)}`;
}

function noteText({ note, noteValues = {} }) {
  const texts = {
    object: (value) => formatQuantity(...value),
    number: (value) => formatNumber(value, 15),
    string: (value, name) => said({ criterion: "criteria", source: "sources" }[name], value) ?? value,
  };
  const values = Object.entries(noteValues).map(([name, value]) => [name, texts[typeof value](value, name)]);
  return message(`worked.note.${note}`, Object.fromEntries(values));
}

function sourceText({ source, equation: number, after }) {
  const words = message(`worked.source.${source}`);
  return number ? message(after ? "worked.after" : "worked.equation", { source: words, number }) : words;
}

function stepMarkup(step, section, accuracy) {
  const { name, intermediate, source, erratum, note } = step;
  const title = intermediate ? message(`worked.value.${name}`) : quantityWords(name, section).title;
  return html`
    <li class="step" data-name="${name}">
      <p class="step-head"><span class="step-title">${title}</span>
        ${source && html`<span class="step-source">${sourceText(step)}</span>`}</p>
      <div class="formulas">${formulas(step, resultDigits(name, accuracy))}</div>
      ${note && html`<p class="step-note">${noteText(step)}</p>`}
      ${erratum && html`<p class="step-note erratum">${message("worked.corrected", {
        words: message(`worked.erratum.${erratum}`),
      })}</p>`}
    </li>`;
}

/** Steps of a section, with as many digits as its accuracy allows. */
export function groupMarkup({ section, steps }, accuracy) {
  const { relative_error: error, method, method_code: code } = accuracy;
  return html`<ol class="steps">${steps.map((step) => stepMarkup(step, section, accuracy))}</ol>
    <p class="accuracy">${message("worked.accuracy", {
      error: error === 0 ? message("results.exact") : formatNumber(error, 2), method: said("methods", code) ?? method,
    })}</p>`;
}

/** `on.print()` and `on.save()` ask for the report; `materialOf(path, given)` gives a material's values. */
export function createWorked({ workedSteps, materialOf, on }) {
  const root = element(html`
    <section class="card worked" aria-label="${message("worked.title")}">
      <div class="worked-head"><h2>${message("worked.title")}</h2>
        <button type="button" class="toggle print">${message("report.print")}</button>
        <button type="button" class="toggle save-report">${message("report.save")}</button></div>
      <div class="worked-groups"></div>
    </section>`);
  const host = root.querySelector(".worked-groups");
  root.querySelector(".print").addEventListener("click", () => on.print());
  root.querySelector(".save-report").addEventListener("click", () => on.save());
  let shown = null; // { answer, groups } of the results on the screen
  let opened = []; // for paper only

  function build(details) {
    const group = shown.groups.find(({ section }) => section === details.dataset.section);
    fill(details.querySelector(".worked-steps"), groupMarkup(group, shown.answer[group.section].accuracy));
  }

  host.addEventListener("toggle", ({ target }) => {
    if (target.open) build(target);
  }, true);

  const all = () => [...host.querySelectorAll("details")];

  return {
    root,
    update: following(({ shown, besides }) => [shown, ...Object.values(besides).map(({ steps }) => steps)], ({ shown: now, besides }) => {
      if (!now) return;
      const { filled: input, answer } = now;
      const open = new Set(all().filter((details) => details.open).map(({ dataset }) => dataset.section));
      const more = Object.fromEntries(Object.entries(besides).map(([id, { steps }]) => [id, steps]));
      shown = { answer, groups: workedSteps({ input, answer, materialOf, more }) };
      fill(host, html`${shown.groups.map(({ section, steps }) => html`
        <details data-section="${section}"><summary>${message("worked.group", {
          section: message(`section.${section}`), count: steps.length,
        })}</summary><div class="worked-steps"></div></details>`)}`);
      for (const details of all()) {
        details.open = open.has(details.dataset.section);
        if (details.open) build(details);
        else fill(details.querySelector(".worked-steps"), html``);
      }
    }),
    /** Build and open everything for paper; `fold` undoes it. */
    unfold() {
      opened = all().filter((details) => !details.open);
      for (const details of opened) {
        build(details);
        details.open = true;
      }
    },
    fold() {
      for (const details of opened) details.open = false;
      opened = [];
    },
  };
}
