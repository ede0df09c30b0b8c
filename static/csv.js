/** Tables as comma-separated values (RFC 4180): canonical units, a decimal point, all digits. No DOM. */

function cell(value) {
  const text = value === undefined || value === null ? "" : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** The title of a column with its canonical unit. */
function heading({ title, unit }) {
  return unit ? `${title}, ${unit}` : title;
}

/** `{ columns: [{ title, unit }], rows }` as the text of a file. */
export function csvOf({ columns, rows }) {
  return [columns.map(heading), ...rows].map((row) => `${row.map(cell).join(",")}\r\n`).join("");
}

/** Several tables in one text: each under its title, parted by an empty line. */
export function csvOfTables(tables) {
  if (tables.length === 1) return csvOf(tables[0]);
  return tables.map((table) => `${cell(table.title)}\r\n${csvOf(table)}`).join("\r\n");
}
