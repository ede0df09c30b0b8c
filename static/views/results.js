/** All results as tables, a section each; warnings above. */
import { ASIDE, flattened, listedOf } from "../lib/checks.js";
import { ALL, digitsOf, quantityParts, unitOf } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { shownAsIs, shownUnit } from "../lib/units.js";
import { levelOf } from "../lib/verdict.js";
import { message, quantityTitle, said, symbolOf } from "../messages/index.js";
import { warningText } from "../service_texts.js";
import { following } from "../store.js";
import { sign, symbolMarkup, tableMarkup } from "./parts.js";


function isScalar(value) {
  return ["number", "boolean", "string"].includes(typeof value);
}

/** A word of the answer in the language in use. */
function wordOf(name, value) {
  if (["torque_direction", "method"].includes(name)) return message(`option.${value}`);
  const kind = { body: "figures", criterion: "criteria" }[name];
  return (kind && said(kind, value)) ?? value;
}

/** Short lists of numbers and pairs read as one value; what is longer has its table or figure. */
function asText(value, digits, unit = "", name = "") {
  if (typeof value === "number") {
    const whole = Number.isInteger(value) && shownAsIs(unit);
    return quantityParts(value, unit, whole ? ALL : digits).value;
  }
  if (typeof value === "boolean") return message(value ? "results.yes" : "results.no");
  if (typeof value === "string") return wordOf(name, value);
  if (Array.isArray(value) && value.every(isScalar)) {
    return value.length === 0 ? message("results.none") : value.map((one) => asText(one, digits, unit)).join("; ");
  }
  if (value && "satellite" in value && "pin" in value && Object.keys(value).length === 2) {
    return message("results.pair", value);
  }
  if (value && !Array.isArray(value) && Object.values(value).every((one) => typeof one === "number")) {
    return Object.entries(value)
      .map(([name, one]) => `${quantityTitle(name)}\u00a0${quantityParts(one, unit, digits).value}`).join("; ");
  }
  return null;
}

function row([name, value], accuracy, id) {
  const unit = unitOf(name);
  const text = asText(value, digitsOf(name, accuracy), unit, name);
  if (text === null) return null;
  return html`<tr data-name="${name}"><th scope="row">${quantityTitle(name, id)}</th><td class="symbol-cell">${symbolMarkup(symbolOf(name, id))}</td>
    <td class="value ${text.length > 20 && "long"}" title="${asText(value, ALL, unit, name)}">${text}</td><td class="unit-cell">${value.length !== 0 && shownUnit(unit)}</td></tr>`;
}

/** A list of flat records that no figure shows, as a table of its own. */
function records([name, value], elsewhere) {
  const isRecord = (one) => typeof one === "object" && !Array.isArray(one);
  if (value.length === 0 || !value.every(isRecord)) return null;
  const columns = [...new Set(value.flatMap(Object.keys))].filter((column) => !elsewhere.includes(column));
  return tableMarkup({
    title: quantityTitle(name),
    columns: columns.map((column) => ({ title: quantityTitle(column), unit: unitOf(column), digits: digitsOf(column) })),
    rows: value.map((record) => columns.map((column) =>
      (typeof record[column] === "number" ? record[column] : asText(record[column], digitsOf(column), unitOf(column), column) ?? "–"))),
  });
}

function warningsMarkup(warnings = [], titles) {
  return warnings.length > 0 && html`<ul class="warnings">${warnings.map((warning) =>
    html`<li>${sign(levelOf(warning.code))}<span>${warningText(warning, titles)}</span></li>`)}</ul>`;
}

/** Warnings and values of a section, which has that `id`. */
export function valuesMarkup(id, section, elsewhere, titles) {
  const entries = flattened(section).filter(([name]) => !ASIDE.includes(name) && !elsewhere.includes(name));
  const lists = entries.filter(([, value]) => Array.isArray(value));
  return html`
    ${warningsMarkup(section.warnings, titles)}
    <table class="quantities">
      <thead class="unseen"><tr><th scope="col">${message("results.quantity")}</th>
        <th scope="col">${message("results.symbol")}</th><th scope="col">${message("results.value")}</th>
        <th scope="col">${message("results.unit")}</th></tr></thead>
      <tbody>${entries.map((entry) => row(entry, section.accuracy, id))}</tbody>
    </table>
    ${lists.map((list) => records(list, elsewhere))}`;
}

function sectionMarkup(id, section, elsewhere, titles) {
  return html`<section class="card result" data-section="${id}"><h2>${message(`section.${id}`)}</h2>
    ${section ? valuesMarkup(id, section, elsewhere, titles) : html`<p class="missing">${message("results.missing")}</p>`}</section>`;
}

/**
 * `calculator.elsewhere` names the values that are shown elsewhere or not at all; `titles` stand for
 * API names in warnings.
 */
export function createResults({ calculator, titles }) {
  const root = element(html`<section class="all-results" aria-label="${message("results.all")}"><div class="results"></div></section>`);
  const host = root.querySelector(".results");
  return {
    root,
    update: following(({ shown }) => [shown], ({ shown }) => {
      if (!shown) return;
      const own = listedOf(calculator, [shown.answer]).filter((id) => !calculator.wanted?.some(({ section }) => section === id));
      fill(host, html`${own.map((id) =>
        sectionMarkup(id, shown.answer[id], calculator.elsewhere, titles))}`);
    }),
  };
}
