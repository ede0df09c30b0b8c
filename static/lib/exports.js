/**
 * What the user takes along, as text: tables as comma-separated values (RFC 4180; canonical units, a
 * decimal point, all digits), a request as others write it, the numbers of an answer. No DOM.
 */
import { unitOf } from "./format.js";

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

const quoted = (text) => `'${text.replaceAll("'", String.raw`'\''`)}'`;

/** A line for a shell. */
export function curlLine(url, body) {
  return `curl -s ${quoted(url)} -H 'content-type: application/json' -d ${quoted(JSON.stringify(body))}`;
}

function python(value, indent = "") {
  if (value === null) return "None";
  if (typeof value === "boolean") return value ? "True" : "False";
  if (typeof value !== "object") return JSON.stringify(value);
  const deeper = `${indent}    `;
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  const parts = Array.isArray(value)
    ? value.map((one) => python(one, deeper))
    : Object.entries(value).map(([key, one]) => `${JSON.stringify(key)}: ${python(one, deeper)}`);
  const line = `${open}${parts.join(", ")}${close}`;
  if (line.length + indent.length < 80 && !line.includes("\n")) return line;
  return `${open}\n${parts.map((part) => `${deeper}${part},\n`).join("")}${indent}${close}`;
}

/** A program: the request, and its answer as a dict. */
export function pythonCode(url, body) {
  return `import httpx

answer = httpx.post(
    ${JSON.stringify(url)},
    json=${python(body, "    ")},
)
answer.raise_for_status()
print(answer.json())
`;
}

const ASIDE = ["accuracy", "warnings", "curves"];

/**
 * Every value of an answer's sections as `{ section, name, value, unit }`, in canonical units;
 * parts of lists and objects by their index or key: `force_N[0]`, `peak_pair.pin`. The warnings of
 * the whole answer stand last, by their codes.
 */
export function flatValues(answer) {
  const found = [];
  const visit = (section, name, value, unit) => {
    if (Array.isArray(value)) {
      value.forEach((one, i) => visit(section, `${name}[${i}]`, one, unit));
    } else if (value !== null && typeof value === "object") {
      for (const [key, one] of Object.entries(value)) visit(section, `${name}.${key}`, one, unitOf(key) || unit);
    } else {
      found.push({ section, name, value, unit });
    }
  };
  for (const [section, values] of Object.entries({ ...answer, warnings: undefined })) {
    for (const [name, value] of Object.entries(values ?? {})) {
      if (!ASIDE.includes(name)) visit(section, name, value, unitOf(name));
    }
  }
  for (const { code, detail } of answer.warnings ?? []) found.push({ section: "warnings", name: code, value: detail, unit: "" });
  return found;
}
