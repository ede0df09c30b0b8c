/** Plain tables of numbers. */
import { formatNumber } from "../format.js";
import { html } from "../lib/html.js";

function cell(value) {
  return typeof value === "number" ? formatNumber(value) : value;
}

/** `{ title, columns, rows }` as a table with a caption. */
export function tableMarkup({ title, columns, rows }) {
  return html`
    <table class="data">
      <caption>${title}</caption>
      <thead><tr>${columns.map((column) => html`<th scope="col">${column}</th>`)}</tr></thead>
      <tbody>${rows.map((row) => html`<tr>${row.map((value) => html`<td>${cell(value)}</td>`)}</tr>`)}</tbody>
    </table>`;
}
