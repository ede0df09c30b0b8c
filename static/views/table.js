/** Plain tables of numbers, in the units shown. */
import { formatNumber } from "../format.js";
import { html } from "../lib/html.js";
import { shownUnit, shownValue } from "../units.js";

function cell(value, unit) {
  return typeof value === "number" ? formatNumber(shownValue(value, unit)) : value;
}

/** `{ title, columns: [{ title, unit }], rows }`, values in canonical units, as a table with a caption. */
export function tableMarkup({ title, columns, rows }) {
  return html`
    <table class="data">
      <caption>${title}</caption>
      <thead><tr>${columns.map((column) => html`
        <th scope="col">${column.title}${column.unit && `, ${shownUnit(column.unit)}`}</th>`)}</tr></thead>
      <tbody>${rows.map((row) => html`<tr>${row.map((value, i) => html`<td>${cell(value, columns[i].unit)}</td>`)}</tr>`)}</tbody>
    </table>`;
}
