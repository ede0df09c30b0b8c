/** Small pieces that many views have: signs, symbols, tables, sheets. */
import { ALL, digitsOf, formatNumber, formatQuantity, quantityParts, unitOf } from "../lib/format.js";
import { element, html } from "../lib/html.js";
import { shownUnit, shownValue } from "../lib/units.js";
import { message, quantityTitle } from "../messages/index.js";

const SIGNS = { good: "✓", bad: "✕", warning: "▲" };

/** The sign of a level, so that its colour is never the only one; nothing where there is no level. */
export function sign(level) {
  return SIGNS[level] && html`<span class="sign ${level}" aria-hidden="true">${SIGNS[level]}</span>`;
}

const BAR = 1.5; // the share of a limit at which a bar is full

/** How much of a limit is used, its mark at the limit; the number stands beside it. */
export function barMarkup(used, level) {
  return html`<svg class="bar-of ${level ?? ""}" viewBox="0 0 150 8" preserveAspectRatio="none" aria-hidden="true">
    <rect class="whole" width="150" height="8"/><rect class="used" width="${Math.round((150 * Math.min(Math.max(used, 0), BAR)) / BAR)}" height="8"/>
    <path d="M100 0v8"/></svg>`;
}

/** Sentences `[level, text]` as the items of a list. */
export const sentencesMarkup = (sentences) => html`${sentences.map(([level, text]) => html`<li>${sign(level)}${text}</li>`)}`;

/** The numbers of a group beside the results, `[{ label, value, exact?, note, level? }]`. */
export function cellsMarkup(cells) {
  return html`${cells.map(({ label, value, exact, note, level }) => html`
    <div class="cell"><dt>${label}</dt><dd><span class="figures" title="${exact ?? ""}">${sign(level)}${value}</span><span class="note">${note}</span></dd></div>`)}`;
}

/** Says of what is drawn that it is of older inputs, while it is. */
export const olderMark = () => html`<p class="older">${message("figure.older")}</p>`;

/** What saves a figure or a drawing as files of these kinds. */
export const saveButtons = (title, kinds) => kinds.map((kind) => html`<button type="button" class="toggle save" data-kind="${kind}"
  aria-label="${message("figure.save", { title, kind })}">${kind}</button>`);

/** What opens a figure's large view (views/large.js). */
export const enlargeButton = (title) => html`<button type="button" class="toggle enlarge" aria-label="${message("figure.enlarge", { title })}"
  title="${message("figure.enlarge", { title })}"><svg class="icon" viewBox="0 0 16 16" aria-hidden="true"><path d="M9.5 2.5h4v4M6.5 13.5h-4v-4M13.5 2.5l-4.5 4.5M2.5 13.5l4.5-4.5"/></svg></button>`;

/** A symbol as the formulas write it: `r_in` has its index set low. */
export function symbolMarkup(symbol) {
  const parts = symbol.split(/_([\p{L}\p{N}]+)/u);
  return html`<var class="symbol">${parts.map((part, i) => (i % 2 ? html`<sub>${part}</sub>` : part))}</var>`;
}

/** A cell of a table; where its column is shown to some digits, it has all for who points at it. */
function cell(value, { unit, digits }) {
  if (typeof value !== "number") return html`<td>${value}</td>`;
  const [all, shown] = [ALL, digits ?? ALL].map((count) => formatNumber(shownValue(value, unit), count));
  return html`<td ${digits && html`title="${all}"`}>${shown}</td>`;
}

/** `{ title, columns: [{ title, unit, digits? }], rows }`, values in canonical units, as a table with a caption. */
export function tableMarkup({ title, columns, rows }) {
  return html`
    <table class="data">
      <caption>${title}</caption>
      <thead><tr>${columns.map((column) => html`
        <th scope="col">${column.title}${column.unit && `, ${shownUnit(column.unit)}`}</th>`)}</tr></thead>
      <tbody>${rows.map((row) => html`<tr>${row.map((value, i) => cell(value, columns[i]))}</tr>`)}</tbody>
    </table>`;
}

/** A modal sheet with a title and a way out. */
export function createDialog({ id, title, content }) {
  const dialog = element(html`
    <dialog class="sheet card" id="${id}" aria-labelledby="${id}-title">
      <h2 id="${id}-title" tabindex="-1" autofocus>${title}</h2>
      ${content}
      <form method="dialog"><button>${message("keys.close")}</button></form>
    </dialog>`);
  document.body.append(dialog);
  return dialog;
}

/** Have a button say that it works, until that is done. */
export async function busy(button, work) {
  button.setAttribute("aria-busy", "true");
  try {
    return await work();
  } finally {
    button.removeAttribute("aria-busy");
  }
}

/** A list of records, each in a column under its name, a row a quantity; not all of them have every one. */
export function listMarkup(name, records, nameOf) {
  const keys = [...new Set(records.flatMap(Object.keys))];
  return html`<div class="grid-rows"><table class="data"><caption>${quantityTitle(name)}</caption>
    <thead><tr><td></td>${records.map((_, i) => html`<th scope="col">${nameOf(i)}</th>`)}</tr></thead>
    <tbody>${keys.map((key) => html`<tr><th scope="row">${quantityTitle(key)}${unitOf(key) && `, ${shownUnit(unitOf(key))}`}</th>
      ${records.map(({ [key]: value }) => (value === undefined ? html`<td>–</td>`
    : html`<td title="${formatQuantity(value, unitOf(key), ALL)}">${quantityParts(value, unitOf(key), digitsOf(key)).value}</td>`))}</tr>`)}</tbody></table></div>`;
}
