/**
 * What is typed into a form (schema_form.js) and what it says. No DOM, no texts.
 *
 * The *state* is what the user typed and chose, as text: `{ texts: {path: text}, chosen: {id: option} }`;
 * its texts are in the units shown, its values (and what a request carries) in the canonical ones.
 */
import { parseNumber, parseNumbers, parseSum, tidy, typedText } from "./format.js";
import { canonicalValue, DIAMETER, partedUnit, shownStep, shownValue, spell } from "./units.js";

function valueAt(input, path) {
  return path.split(".").reduce((part, key) => part?.[key], input);
}

/** Where a field stands in an input: those of wanted groups apart, so that nothing else has to leave them out. */
const placeOf = ({ wanted, path }) => (wanted ? `besides.${path}` : path);

function put(input, path, value) {
  const keys = path.split(".");
  const last = keys.pop();
  let part = input;
  for (const [i, key] of keys.entries()) part = part[key] ??= /^\d+$/.test(keys[i + 1] ?? last) ? [] : {};
  part[last] = value;
}

/** Rows and cells of the text of a list of records: `30; 15; 25 | 60; 15; 25`. */
export function cellsOf(text) {
  if (text.trim() === "") return [];
  return text.split("|").map((row) => row.split(";").map((cell) => cell.trim()));
}

/** The text of rows of cells. */
export function textOfCells(rows) {
  return rows.map((cells) => cells.join("; ")).join(" | ");
}

/** The cell of a list of records that a path of the body means: the list, row and column, and the column with the number of its row. */
export function cellAt(model, path) {
  const [, at, row, name] = /^(.+)\.(\d+)\.(\w+)$/.exec(path) ?? [];
  const list = model.fields.get(at);
  const index = list?.columns?.findIndex((column) => column.name === name) ?? -1;
  if (index < 0) return undefined;
  const column = list.columns[index];
  return { list: at, row: Number(row), index, field: { ...column, title: `${column.title} ${Number(row) + 1}` } };
}

/** How a value stands in the box of a field, in the unit shown. */
export function textIn(field, value) {
  if (value === undefined || value === null) return "";
  if (field.kind === "records" && Array.isArray(value)) {
    return textOfCells(value.map((record) => field.columns.map((column) => textIn(column, record?.[column.name]))));
  }
  if (Array.isArray(value)) return value.map((one) => typedText(spell(one, field.unit))).join("; ");
  return typeof value === "number" ? typedText(spell(value, field.unit)) : String(value);
}

/** A value as links carry it, in canonical units. */
export function textInLink(field, value) {
  if (value === undefined || value === null) return "";
  if (field.kind === "records" && Array.isArray(value)) {
    return value.map((record) => field.columns.map((column) => textInLink(column, record[column.name])).join(";"))
      .join("|");
  }
  return Array.isArray(value) ? value.map(String).join(";") : String(value);
}

/** The text of a box for one that a link carries; what is no number stays as it is. */
export function textOfLink(field, text) {
  if (field.kind === "records") {
    return textOfCells(cellsOf(text).map((cells) =>
      cells.map((cell, at) => (field.columns[at] ? textOfLink(field.columns[at], cell) : cell))));
  }
  if (field.kind === "numbers") {
    const { values } = parseNumbers(text);
    return values ? textIn(field, values) : text;
  }
  if (field.kind !== "number") return text;
  const { value } = parseNumber(text);
  return value === undefined || textIn(field, value) === String(value) ? text : textIn(field, value);
}

/** The state that shows a request body; fields that it leaves out stand at their defaults. */
export function stateFromInput(model, input) {
  const texts = {};
  for (const field of model.fields.values()) {
    const value = valueAt(input, placeOf(field)) ?? valueAt(input, model.moved?.[field.path] ?? "");
    const given = typeof value === "object" && !Array.isArray(value) ? undefined : value;
    texts[field.path] = textIn(field, given ?? field.default);
  }
  const chosen = {};
  for (const choice of model.choices) {
    const given = choice.options.find((option) => option.fields.some((field) => {
      const value = valueAt(input, placeOf(field));
      return value !== undefined && value !== null
        && (Array.isArray(value) || typeof value !== "object");
    }));
    chosen[choice.id] = (given ?? choice.options[0]).id;
  }
  return { texts, chosen };
}

/** Paths of what an input says and the form has no field for. */
export function lostOf(model, input) {
  const known = (path) => [...model.fields.keys()].some((own) => own === path || own.startsWith(`${path}.`));
  const within = (value, path) => (typeof value === "object" && value !== null && !Array.isArray(value)
    ? Object.entries(value).flatMap(([name, one]) => within(one, path ? `${path}.${name}` : name))
    : value === undefined || known(path) ? [] : [path]);
  const { besides, ...own } = input;
  return within({ ...own, ...besides }, "");
}

const isSwitchedOn = (model, id, texts) => texts[`${id}.on`] === "on";

/** Whether a group is on: its switch is, and that of the group that it needs. */
export function isOn(model, id, texts) {
  const { needs } = model.groups.find((group) => group.id === id);
  return isSwitchedOn(model, id, texts) && (!needs || isOn(model, needs, texts));
}

/** Whether a field is to be said beside what others say: its `when` has the word of another one that itself is. */
function applies({ fields }, texts, { when: [path, ...words] = [] }) {
  return !path || words.includes(applies({ fields }, texts, fields.get(path) ?? {}) ? texts[path] : undefined);
}

/** The fields on the screen: all outside choices, those of the chosen options, and of wanted groups those that are `on`. */
export function shownFields(model, state, on = isOn) {
  return model.groups.flatMap((group) => group.items).flatMap((item) => (item.path
    ? [item]
    : item.options.find((option) => option.id === state.chosen[item.id]).fields)).filter((field) =>
    !field.wanted || field.kind === "switch"
      || ([field.wanted, field.needs].every((group) => !group || on(model, group, state.texts)) && applies(model, state.texts, field)));
}

/** The fields that a link says: those too that come back with a group which is off. */
export const linkedFields = (model, state) => shownFields(model, state, isSwitchedOn);

const TINY = 1e-9; // a lowest value so small means: more than nothing

function outside(field, value) {
  const { lowest, highest, unit } = field;
  if (lowest > 0 && lowest < TINY && value <= 0) return { problem: "above", limit: 0 };
  if (lowest !== undefined && (field.lowestAllowed ? value < lowest : value <= lowest)) {
    return { problem: field.lowestAllowed ? "least" : "above", limit: shownValue(lowest, unit) };
  }
  if (highest !== undefined && (field.highestAllowed ? value > highest : value >= highest)) {
    return { problem: field.highestAllowed ? "most" : "below", limit: shownValue(highest, unit) };
  }
  return null;
}

function readRecords(field, typed) {
  const value = [];
  for (const [index, cells] of cellsOf(typed).entries()) {
    const record = {};
    for (const [at, column] of field.columns.entries()) {
      const reading = readField(column, cells[at] ?? "");
      if (reading.problem) return { ...reading, row: index, column };
      if (reading.value !== undefined) record[column.name] = reading.value;
    }
    value.push(record);
  }
  return { value };
}

/** Read one box: `{ value }`, `{}` where it may be empty and is, or `{ problem, limit? }`. */
export function readField(field, text) {
  const typed = text.trim();
  if (typed === "") return field.required ? { problem: "required" } : {};
  if (["name", "option", "switch"].includes(field.kind)) return { value: field.whole ? Number(typed) : typed };
  if (field.kind === "flag") return { value: typed === "true" };
  if (field.kind === "names") return { value: typed.split(/;\s*/) };
  if (field.kind === "records") return readRecords(field, typed);
  if (field.kind === "numbers") {
    const { values, problem } = parseNumbers(typed);
    if (problem) return { problem: ["number", "separators"].includes(problem) ? "list" : problem };
    const value = values.map((one) => canonicalValue(one, field.unit));
    return value.map((one) => outside(field, one)).find(Boolean) ?? { value };
  }
  const [, mark, rest] = /^([⌀Øø∅]?)\s*(.*)$/s.exec(typed);
  const parted = partedUnit(rest, field.unit);
  if (!parted) return { problem: "unit" };
  const { value: number, problem, ambiguous, worked } = parseSum(parted.amount);
  if (problem) return { problem };
  // A radius may be written as a diameter, Ø12; what is shown as one is twice the canonical value.
  const radius = field.name?.endsWith("_radius_mm");
  if (mark && !radius && !field.name?.endsWith("diameter_mm")) return { problem: "number" };
  const halved = radius && (field.unit === DIAMETER || mark) ? 0.5 : 1;
  const value = parted.size === undefined
    ? canonicalValue(number, field.unit) * (mark && field.unit !== DIAMETER ? halved : 1)
    : tidy(number * parted.size * halved);
  if (field.kind === "integer" && !Number.isInteger(value)) return { problem: "integer" };
  const read = { value, ...(ambiguous && { readAs: number }), ...((worked || mark || parted.size !== undefined) && { worked: true }) };
  return outside(field, value) ?? read;
}

/**
 * The request body that the shown boxes say: `{ input, filled, readings: {path: reading}, wrong: [path] }`, and
 * `besides`, the wrong ones of wanted groups on which no verdict hangs, by group: these keep nobody else from an answer. Boxes that cannot be read are left out of `input`; `filled` has the schema's defaults too.
 */
export function readState(model, state) {
  const [input, filled] = [{}, {}];
  const readings = {};
  for (const field of shownFields(model, state)) {
    const reading = readField(field, state.texts[field.path]);
    readings[field.path] = reading;
    if (field.kind === "switch" && !isOn(model, field.wanted, state.texts)) continue;
    if (reading.value !== undefined) put(input, placeOf(field), reading.value);
    const value = reading.problem ? undefined : reading.value ?? field.default;
    if (value !== undefined) put(filled, placeOf(field), value);
  }
  for (const [path, { value, needs }] of model.linked) {
    if (readings[path]?.problem !== "required") continue;
    const linked = value(filled);
    readings[path] = Number.isFinite(linked) ? outside(model.fields.get(path), linked) ?? { value: linked } : {};
    if (readings[path].value !== undefined) {
      put(input, path, linked);
      put(filled, path, linked);
    } else if (readings[needs]?.value === undefined) {
      readings[needs] = readings[needs]?.problem ? readings[needs] : { problem: "required" };
    }
  }
  for (const field of shownFields(model, state).filter(({ path, follows }) => follows && readings[path].problem === "required")) {
    const value = field.follows(filled);
    const numbers = [value].flat();
    if (numbers.length === 0 || !numbers.every(Number.isFinite)) continue;
    if (numbers.some((one) => outside(field, one))) {
      readings[field.path] = {}; // what it follows is wrong, which is said there
      continue;
    }
    readings[field.path] = { value, followed: true };
    put(input, placeOf(field), value);
    put(filled, placeOf(field), value);
  }
  const all = Object.keys(readings).filter((path) => readings[path].problem);
  const apart = model.groups.filter(({ wanted, judged }) => wanted && !judged);
  const besides = Object.fromEntries(apart.map(({ id }) => [id, all.filter((path) => model.fields.get(path).wanted === id)]));
  return { input, filled, readings, wrong: all.filter((path) => !Object.values(besides).flat().includes(path)), besides };
}

/** A state in which the boxes that say what their link gives are empty: they follow the others. */
export function withLinks(model, state) {
  const { filled, readings } = readState(model, state);
  const texts = { ...state.texts };
  for (const [path, { value }] of model.linked) {
    const linked = value(filled);
    if (texts[path] !== "" && Math.abs(readings[path]?.value - linked) <= 1e-12 * Math.abs(linked)) texts[path] = "";
  }
  for (const { path, follows } of model.fields.values()) {
    if (follows && readings[path] && String(follows(filled)) === String(readings[path].value)) texts[path] = "";
  }
  return { ...state, texts };
}

/** Names and indices of a JSON pointer. */
export function keysOf(pointer) {
  return pointer.replace(/^#?\//, "").split("/").map((key) => key.replace(/~1/g, "/").replace(/~0/g, "~"));
}

/** The shown field that a JSON pointer means: itself, or the one that it lies in. */
export function fieldAtPointer(shown, pointer) {
  const path = keysOf(pointer).join(".");
  return shown.find((field) => field.path === path)
    ?? shown.find((field) => path.startsWith(`${field.path}.`) || field.covers?.some((own) => `${path}.`.startsWith(`${own}.`)))
    ?? null;
}

/** The text that an arrow key gives, its value kept inside the field's limits; null if unreadable. */
export function stepped(field, text, direction, factor = 1) {
  if (field.kind !== "number" && field.kind !== "integer") return null;
  const { value = field.default } = readField({ ...field, lowest: undefined, highest: undefined }, text);
  if (value === undefined) return null;
  const from = shownValue(value, field.unit);
  const step = field.step ? shownStep(field.step, field.unit) : decade(from);
  const next = Number((from + direction * step * factor).toPrecision(12));
  return outside(field, canonicalValue(next, field.unit)) ? null : typedText(String(next));
}

function decade(value) {
  return value === 0 ? 0.1 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - 1);
}
