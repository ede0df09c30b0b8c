/**
 * The form as data, made from the service's OpenAPI schema. No DOM, no texts.
 *
 * A *field* is one box: `{ path, name, title, help, kind, symbol, unit, step, lowest, highest, ...}`
 * with the dotted path of its value in the request body; `kind` is "number", "integer", "numbers"
 * (a list), "records" (a list of objects, whose boxes are `columns`), "name" (a text chosen from a
 * list that the service gives) or "option" (an enumeration).
 * A *choice* is a set of options, each with its own fields, of which one option is shown.
 * The *state* is what the user typed and chose, as text: `{ texts: {path: text}, chosen: {id: option} }`;
 * its texts are in the units shown, its values (and what a request carries) in the canonical ones.
 */
import { parseNumber, parseNumbers, parseSum, tidy, typedText, unitOf } from "./format.js";
import { canonicalValue, DIAMETER, partedUnit, shownStep, shownValue, spell } from "./units.js";

function resolver(openapi) {
  const resolve = (schema) => {
    if (schema.$ref) {
      const target = openapi.components.schemas[schema.$ref.split("/").pop()];
      const { $ref, ...own } = schema;
      return resolve({ ...target, ...own });
    }
    if (schema.allOf?.length === 1) {
      const { allOf, ...own } = schema;
      return resolve({ ...resolve(allOf[0]), ...own });
    }
    const variants = schema.anyOf ?? schema.oneOf;
    if (!variants) return schema;
    const real = variants.filter((variant) => variant.type !== "null");
    if (real.length !== 1) return schema;
    const { anyOf, oneOf, ...own } = schema;
    return { ...resolve(real[0]), ...own };
  };
  return resolve;
}

/** The schema of a POST endpoint's body, and the means to resolve its references. */
function bodySchema(openapi, path, words) {
  const resolve = Object.assign(resolver(openapi), { words });
  const body = openapi.paths[path].post.requestBody.content["application/json"].schema;
  return { schema: resolve(body), resolve };
}

function bounds(schema) {
  const lowest = schema.minimum ?? schema.exclusiveMinimum;
  const highest = schema.maximum ?? schema.exclusiveMaximum;
  return {
    lowest,
    highest,
    lowestAllowed: schema.exclusiveMinimum === undefined,
    highestAllowed: schema.exclusiveMaximum === undefined,
  };
}

function kindOf(schema, resolve) {
  if (schema.enum) return "option";
  if (schema.type === "array" && resolve(schema.items).type === "object") return "records";
  return { number: "number", integer: "integer", array: "numbers", string: "name" }[schema.type];
}

function fieldOf(schema, path, required, resolve) {
  const name = path.split(".").pop();
  const kind = kindOf(schema, resolve);
  const [title, help] = resolve.words(name, schema["x-group"]) ?? [schema.title ?? name, schema.description ?? ""];
  const limited = kind === "numbers" ? resolve(schema.items) : schema;
  return {
    path,
    name,
    kind,
    title,
    help,
    symbol: schema["x-symbol"] ?? "",
    unit: schema["x-unit"] ?? unitOf(name),
    step: schema["x-step"] ?? (kind === "integer" ? 1 : undefined),
    options: schema.enum,
    group: schema["x-group"],
    advanced: schema["x-advanced"] ?? false,
    required,
    default: schema.default ?? undefined,
    ...(kind === "records" && { columns: columnsOf(resolve(schema.items), path, resolve) }),
    ...bounds(limited),
  };
}

/** The boxes of one record of a list. */
function columnsOf(record, path, resolve) {
  return Object.entries(record.properties).map(([key, property]) =>
    fieldOf(resolve(property), `${path}.${key}`, (record.required ?? []).includes(key), resolve));
}

/** A property that is a name or an object of its own: the name, or the object's fields. */
function namedOrOwn(schema, path, required, resolve) {
  const variants = (schema.anyOf ?? schema.oneOf ?? []).map(resolve);
  const named = variants.find((variant) => variant.type === "string");
  const own = variants.find((variant) => variant.type === "object");
  if (!named || !own) return null;
  const { anyOf, oneOf, ...about } = schema;
  const name = fieldOf({ ...named, ...about }, path, required, resolve);
  const fields = Object.entries(own.properties).map(([key, property]) =>
    fieldOf(resolve(property), `${path}.${key}`, (own.required ?? []).includes(key), resolve));
  return {
    id: path,
    title: name.title,
    auto: true,
    options: [{ id: "named", fields: [name] }, { id: "own", fields }],
  };
}

function sectionItems(section, path, resolve, hidden) {
  return Object.entries(section.properties)
    .map(([key, property]) => ({ key, property: resolve(property), at: path ? `${path}.${key}` : key }))
    .filter(({ at, property }) => !hidden.includes(at) && property.type !== "object")
    .map(({ key, property, at }) => {
      const required = (section.required ?? []).includes(key);
      return namedOrOwn(property, at, required, resolve) ?? fieldOf(property, at, required, resolve);
    });
}

/** Gather the fields that belong to a choice where the first of them stands. */
function withChoices(items, choices, optional) {
  const byPath = new Map(items.map((item) => [item.path ?? item.id, item]));
  // What distinguishes an option has to be given, unless it is said to be optional.
  const fieldAt = (path) => {
    const field = byPath.get(path);
    return { ...field, required: !optional.includes(path) && field.default === undefined };
  };
  const placed = new Set();
  return items.flatMap((item) => {
    const path = item.path ?? item.id;
    const [id, options] = Object.entries(choices).find(([, all]) => Object.values(all).flat().includes(path)) ?? [];
    if (!id) return [item];
    if (placed.has(id)) return [];
    placed.add(id);
    return [{ id, options: Object.entries(options).map(([option, paths]) => ({ id: option, fields: paths.map(fieldAt) })) }];
  });
}

/** Groups of a flat body: each field says its own; the objects named `inline` stand among them. */
function groupsByField(schema, { groups, inline, hidden, resolve }) {
  const items = [
    ...sectionItems(schema, "", resolve, hidden),
    ...inline.flatMap((key) => sectionItems(resolve(schema.properties[key]), key, resolve, hidden)),
  ];
  return groups.map((id) => ({ id, items: items.filter((item) => item.group === id) }));
}

/**
 * The model of an endpoint's form.
 *
 * `groups` names the parts of the body in the order shown, or, where `inline` is given, the groups
 * that the fields of a flat body name themselves; `choices` says which fields exclude each other,
 * `{ choice: { option: [path] } }`, and `optional` which of them may be left empty; `hidden` what the
 * page decides for the user; `arranged` puts them in groups of the page's own; `suggestions` says which
 * boxes follow others while they are empty (`linked`); `diameters` has title and help, by name, of
 * radii that are shown as diameters; `words(name, group)` gives title and help of a field, or null for
 * those of the schema.
 */
export function formModel(openapi, {
  path, groups, inline, choices = {}, optional = [], hidden = [], arranged = null, suggestions = {}, diameters = null,
  words = () => null,
}) {
  const { schema, resolve } = bodySchema(openapi, path, words);
  const plain = inline
    ? groupsByField(schema, { groups, inline, hidden, resolve })
    : groups.map((id) => ({ id, items: sectionItems(resolve(schema.properties[id]), id, resolve, hidden) }));
  const parts = plain.map((part) => ({
    ...part,
    items: withChoices(part.items, choices, optional).map((item) => (diameters ? asDiameter(item, diameters) : item)),
  }));
  const items = parts.flatMap((part) => part.items);
  const fields = new Map(items.flatMap(fieldsOf).map((field) => [field.path, field]));
  const linked = Object.entries(suggestions).filter(([at, { linked: follows }]) => follows && fields.has(at));
  return { groups: arranged ? inOrder(items, arranged) : parts, choices: items.filter((item) => !item.path), fields, linked };
}

/** The items in groups of the page's own, `{ group: [path or choice] }`; the last takes what is not named. */
function inOrder(items, arranged) {
  const named = Object.values(arranged).flat();
  const at = (id) => items.find((item) => (item.path ?? item.id) === id);
  const rest = items.filter((item) => !named.includes(item.path ?? item.id));
  return Object.entries(arranged).map(([id, ids], i, all) =>
    ({ id, items: [...ids.map(at).filter(Boolean), ...(i === all.length - 1 ? rest : [])] }));
}

/** A field of a radius that is shown and typed as a diameter. */
function asDiameter(item, words) {
  if (!item.path) return { ...item, options: item.options.map((option) => ({ ...option, fields: option.fields.map((field) => asDiameter(field, words)) })) };
  if (item.kind !== "number" || !(item.name in words)) return item;
  const [title, help] = words[item.name];
  return { ...item, title, help, unit: DIAMETER, symbol: `2${item.symbol}` };
}

/** The fields of an item: itself, or those of all options of a choice. */
function fieldsOf(item) {
  return item.path ? [item] : item.options.flatMap(({ fields }) => fields);
}

function valueAt(input, path) {
  return path.split(".").reduce((part, key) => part?.[key], input);
}

function put(input, path, value) {
  const keys = path.split(".");
  const last = keys.pop();
  let part = input;
  for (const key of keys) part = part[key] ??= {};
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

/** How a value stands in the box of a field, in the unit shown. */
export function textIn(field, value) {
  if (value === undefined || value === null) return "";
  if (field.kind === "records" && Array.isArray(value)) {
    return textOfCells(value.map((record) => field.columns.map((column) => textIn(column, record[column.name]))));
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
    const value = valueAt(input, field.path);
    const given = typeof value === "object" && !Array.isArray(value) ? undefined : value;
    texts[field.path] = textIn(field, given ?? field.default);
  }
  const chosen = {};
  for (const choice of model.choices) {
    const given = choice.options.find((option) => option.fields.some((field) => {
      const value = valueAt(input, field.path);
      return value !== undefined && value !== null
        && (Array.isArray(value) || typeof value !== "object");
    }));
    chosen[choice.id] = (given ?? choice.options[0]).id;
  }
  return { texts, chosen };
}

/** The fields on the screen: all outside choices, and those of the chosen options. */
export function shownFields(model, state) {
  return model.groups.flatMap((group) => group.items).flatMap((item) => (item.path
    ? [item]
    : item.options.find((option) => option.id === state.chosen[item.id]).fields));
}

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
  if (field.kind === "name" || field.kind === "option") return { value: typed };
  if (field.kind === "records") return readRecords(field, typed);
  if (field.kind === "numbers") {
    const { values, problem } = parseNumbers(typed);
    if (problem) return { problem: problem === "number" ? "list" : problem };
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
 * The request body that the shown boxes say: `{ input, filled, readings: {path: reading}, wrong: [path] }`.
 * Boxes that cannot be read are left out of `input`; `filled` has the schema's defaults too.
 */
export function readState(model, state) {
  const [input, filled] = [{}, {}];
  const readings = {};
  for (const field of shownFields(model, state)) {
    const reading = readField(field, state.texts[field.path]);
    readings[field.path] = reading;
    if (reading.value !== undefined) put(input, field.path, reading.value);
    const value = reading.problem ? undefined : reading.value ?? field.default;
    if (value !== undefined) put(filled, field.path, value);
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
  const wrong = Object.keys(readings).filter((path) => readings[path].problem);
  return { input, filled, readings, wrong };
}

/** A state in which the boxes that say what their link gives are empty: they follow the others. */
export function withLinks(model, state) {
  const { filled, readings } = readState(model, state);
  const texts = { ...state.texts };
  for (const [path, { value }] of model.linked) {
    const linked = value(filled);
    if (texts[path] !== "" && Math.abs(readings[path]?.value - linked) <= 1e-12 * Math.abs(linked)) texts[path] = "";
  }
  return { ...state, texts };
}

/** The boxes of a state that say something, by groups: `[{ id, entries: [{ field, value }] }]`. */
export function listedInputs(model, state) {
  const shown = new Set(shownFields(model, state));
  const { filled } = readState(model, state);
  return model.groups.map(({ id, items }) => ({
    id,
    entries: items.flatMap(fieldsOf)
      .filter((field) => shown.has(field))
      .map((field) => ({ field, value: valueAt(filled, field.path) }))
      .filter(({ value }) => value !== undefined),
  })).filter(({ entries }) => entries.length > 0);
}

/** Names and indices of a JSON pointer. */
export function keysOf(pointer) {
  return pointer.replace(/^#?\//, "").split("/").map((key) => key.replace(/~1/g, "/").replace(/~0/g, "~"));
}

/** The shown field that a JSON pointer means: itself, or the one that it lies in. */
export function fieldAtPointer(shown, pointer) {
  const path = keysOf(pointer).join(".");
  return shown.find((field) => field.path === path)
    ?? shown.find((field) => path.startsWith(`${field.path}.`))
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
