/** All results as tables, a section each; warnings above, accuracy and cost below. */
import { formatDuration, formatNumber, quantityParts, shownDigits, unitOf } from "../format.js";
import { element, fill, html } from "../lib/html.js";
import { message, translated } from "../messages/index.js";
import { shownUnit } from "../units.js";
import { inWords } from "../wording.js";
import { IMPOSSIBLE } from "../worked/contact.js";
import { symbolMarkup } from "./symbol.js";
import { tableMarkup } from "./table.js";

const ASIDE = ["accuracy", "warnings"]; // have their own place in each section

function isScalar(value) {
  return ["number", "boolean", "string"].includes(typeof value);
}

/** Short lists of numbers and pairs read as one value; what is longer has its table or figure. */
function asText(value, digits, unit = "") {
  if (typeof value === "number") {
    const whole = Number.isInteger(value) && shownUnit(unit) === unit;
    return quantityParts(value, unit, whole ? 15 : digits).value;
  }
  if (typeof value === "boolean") return message(value ? "results.yes" : "results.no");
  if (typeof value === "string") return translated(value);
  if (Array.isArray(value) && value.every(isScalar)) {
    return value.length === 0 ? message("results.none") : value.map((one) => asText(one, digits, unit)).join("; ");
  }
  if (value && "satellite" in value && "pin" in value && Object.keys(value).length === 2) {
    return message("results.pair", value);
  }
  if (value && !Array.isArray(value) && Object.values(value).every((one) => typeof one === "number")) {
    return Object.entries(value)
      .map(([name, one]) => `${message(`quantity.${name}`)[0]}\u00a0${quantityParts(one, unit, digits).value}`).join("; ");
  }
  return null;
}

function row([name, value], digits) {
  const unit = unitOf(name);
  const text = asText(value, digits, unit);
  if (text === null) return null;
  const [title, symbol = ""] = message(`quantity.${name}`);
  return html`<tr data-name="${name}"><th scope="row">${title}</th><td class="symbol-cell">${symbolMarkup(symbol)}</td>
    <td class="value ${text.length > 20 && "long"}">${text}</td><td class="unit-cell">${value.length !== 0 && shownUnit(unit)}</td></tr>`;
}

/** A list of flat records that no figure shows, as a table of its own. */
function records([name, value], elsewhere) {
  const isRecord = (one) => typeof one === "object" && !Array.isArray(one);
  if (value.length === 0 || !value.every(isRecord)) return null;
  const columns = [...new Set(value.flatMap(Object.keys))].filter((column) => !elsewhere.includes(column));
  return tableMarkup({
    title: message(`quantity.${name}`)[0],
    columns: columns.map((column) => ({ title: message(`quantity.${column}`)[0], unit: unitOf(column) })),
    rows: value.map((record) => columns.map((column) =>
      (typeof record[column] === "number" ? record[column] : asText(record[column], 6, unitOf(column)) ?? "–"))),
  });
}

function accuracyMarkup({ method, relative_error: error, evaluations, run_time_us: time }) {
  return html`<p class="accuracy">${message("results.accuracy", {
    method: translated(method),
    error: error === 0 ? message("results.exact") : formatNumber(error, 2),
    evaluations: formatNumber(evaluations, 15),
    time: formatDuration(time),
  })}</p>`;
}

function warningsMarkup(warnings = [], words) {
  if (warnings.length === 0) return "";
  return html`<ul class="warnings">${warnings.map(({ code, detail }) => {
    const bad = IMPOSSIBLE.includes(code);
    return html`<li><span class="sign ${bad ? "bad" : "warning"}" aria-hidden="true">${bad ? "✕" : "▲"}</span><span>${inWords(detail, words)}</span></li>`;
  })}</ul>`;
}

function sectionMarkup(id, section, elsewhere, words) {
  if (!section) {
    return html`<section class="card result" data-section="${id}"><h2>${message(`section.${id}`)}</h2>
      <p class="missing">${message("results.missing")}</p></section>`;
  }
  const digits = shownDigits(section.accuracy.relative_error);
  const entries = Object.entries(section)
    .filter(([name]) => !ASIDE.includes(name) && !elsewhere.includes(name));
  const lists = entries.filter(([, value]) => Array.isArray(value));
  return html`
    <section class="card result" data-section="${id}">
      <h2>${message(`section.${id}`)}</h2>
      ${warningsMarkup(section.warnings, words)}
      <table class="quantities">
        <thead class="unseen"><tr><th scope="col">${message("results.quantity")}</th>
          <th scope="col">${message("results.symbol")}</th><th scope="col">${message("results.value")}</th>
          <th scope="col">${message("results.unit")}</th></tr></thead>
        <tbody>${entries.map((entry) => row(entry, digits))}</tbody>
      </table>
      ${lists.map((list) => records(list, elsewhere))}
      ${accuracyMarkup(section.accuracy)}
    </section>`;
}

/** What of the cited papers cannot be right as printed, and what is computed instead. */
function notesMarkup(notes) {
  return html`<section class="card result notes"><h2>${message("notes.title")}</h2>
    <ul>${notes.flatMap((id) => message(`notes.${id}`)).map((note) => html`<li>${note}</li>`)}</ul></section>`;
}

/**
 * `calculator.elsewhere` names the values that are shown elsewhere or not at all; `words` the
 * titles that stand for API names in warnings.
 */
export function createResults({ calculator, words }) {
  const root = element(html`<div class="results" aria-label="${message("results.label")}" role="region"></div>`);
  return {
    root,
    update: (answer) => fill(root, html`${calculator.sections.map((id) =>
      sectionMarkup(id, answer[id], calculator.elsewhere, words))}${notesMarkup(calculator.notes)}`),
  };
}

/** Every warning of an answer and of its sections, once. */
export function warningsOf(answer) {
  const all = [answer, ...Object.values(answer)].flatMap((part) => part?.warnings ?? []);
  return [...new Map(all.map((warning) => [`${warning.code} ${warning.detail}`, warning])).values()];
}
