/**
 * What the user takes along, as text: tables as comma-separated values (RFC 4180; canonical units, a
 * decimal point, all digits), a request as others write it, the numbers of an answer. No DOM.
 */
import { tidy, unitOf } from "./format.js";

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

/** A figure's tables in one text, without the noise of binary sums: several each under its title, parted by an empty line. */
export function csvOfTables(tables) {
  const plain = tables.map((table) => ({ ...table, rows: table.rows.map((row) => row.map((one) => (typeof one === "number" ? tidy(one) : one))) }));
  if (plain.length === 1) return csvOf(plain[0]);
  return plain.map((table) => `${cell(table.title)}\r\n${csvOf(table)}`).join("\r\n");
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

const ASIDE = ["accuracy", "warnings", "curves", "checks", "fixes", "not_considered", "counts", "assumed", "fit", "ring_drawing"];

/** Every value of an object as `[name, value, unit]`; parts of lists and objects by their index or key. */
function leaves(name, value, unit) {
  if (Array.isArray(value)) return value.flatMap((one, i) => leaves(`${name}[${i}]`, one, unit));
  if (value === null || typeof value !== "object") return [[name, value, unit]];
  return Object.entries(value).flatMap(([key, one]) => leaves(name ? `${name}.${key}` : key, one, unitOf(key) || unit));
}

const isSection = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

/**
 * What was asked and answered as `{ section, name, value, unit }`, in canonical units: the inputs, defaults
 * filled in; every value of the answer's sections, `force_N[0]`, `peak_pair.pin`; the verdict, the checks with
 * their limits and where these are from; last the warnings, by their codes.
 */
export function flatValues(input, answer) {
  const found = leaves("", input, "").map(([name, value, unit]) => ({ section: "inputs", name: name.replace(/^besides\./, ""), value, unit }));
  const sections = Object.entries(answer).filter(([name, value]) => isSection(value) && !ASIDE.includes(name));
  for (const [section, values] of sections) {
    for (const [name, value] of Object.entries(values).filter(([key]) => !ASIDE.includes(key))) {
      found.push(...leaves(name, value, unitOf(name)).map(([path, one, unit]) => ({ section, name: path, value: one, unit })));
    }
  }
  const judged = [answer, ...sections.map(([, values]) => values)].find(({ checks }) => checks);
  for (const { code, status, value, limit, unit = "", source = "" } of judged?.checks ?? []) {
    for (const [part, one] of Object.entries({ value, limit, status, source })) {
      if (one !== undefined && one !== "") found.push({ section: "checks", name: `${code}.${part}`, value: one, unit: typeof one === "number" ? unit : "" });
    }
  }
  for (const { code, detail } of answer.warnings ?? []) found.push({ section: "warnings", name: code, value: detail, unit: "" });
  return found;
}
