/**
 * What the service says in words: refusals, warnings and figures, by code, in the language and with
 * the titles of the page. `titles` maps API field names to titles. No DOM.
 */
import { ALL, formatNumber, formatQuantity, shownDigits, unitOf } from "./lib/format.js";
import { fieldAtPointer, keysOf } from "./lib/form_state.js";
import { fieldTexts, symbolsIn } from "./lib/schema_form.js";
import { DIAMETER, inDiameters, shownUnit } from "./lib/units.js";
import { message, said } from "./messages/index.js";

const FIELDS = ["field", "other"]; // parameters that are names of fields
const LIMITS = ["limit", "low", "high", "value"]; // and values of the field that the text is about
const MISSING = ["missing", "needed", "needed_beside", "not_sourced"]; // refusals that ask for something

/** What the descriptions of the service name in English, by kind and code. */
export function namedIn([openapi, { examples }, { materials }, { calculations }]) {
  const named = (list, code, text) => Object.fromEntries(list.map((one) => [one[code], one[text]]));
  return {
    fields: fieldTexts(openapi),
    symbols: () => symbolsIn(openapi),
    materials: named(materials, "name", "title"),
    material_groups: named(materials, "group_code", "group"),
    examples: named(examples, "id", "title"),
    neglected: named(calculations.flatMap(({ model }) => model), "code", "detail"),
  };
}

const quoted = (title) => message("page.quoted", { title });

/** The title of a field: on the page, or as the service has it. */
const titleOf = (name, titles) => titles.get(name) ?? said("fields", name)?.title ?? name;

/** Whether a text tells a value of the field that it is about. */
const tells = (params = {}) => Object.entries(params).some(([name, value]) => typeof value === "number" && (LIMITS.includes(name) || name.endsWith("_mm")));

/** Whether it is of a radius that is shown as a diameter: of the box itself, or of another one that is named. */
const ofRadius = ({ unit }, params) => tells(params) && (unit === DIAMETER || (inDiameters() && FIELDS.some((name) => params[name] in message("diameter"))));

function parameter(name, value, unit, titles) {
  if (FIELDS.includes(name)) return quoted(titleOf(value, titles));
  if (name === "reason" && typeof value === "string") return message(`shares.reason.${value}`);
  if (name === "names") return value.split(", ").map((one) => titleOf(one, titles)).join("; ");
  if (typeof value !== "number") return (name === "material" && said("materials", value)) || String(value);
  if (unitOf(name)) return formatQuantity(value, unitOf(name), ALL);
  return LIMITS.includes(name) ? formatQuantity(value, unit, ALL) : formatNumber(value, Number.isInteger(value) ? ALL : 3);
}

/** What a code says, whichever says it; every code has one place. */
function textOf(code, values) {
  const check = said("checks", code, values);
  return said("refusals", code, values) ?? said("notices", code, values)?.text ?? said("reasons", code, values)
    ?? check?.warning?.text ?? check?.refusal;
}

/**
 * The words of a refusal, a warning or a reason; a code that is new to page and service alike speaks as what it was
 * before, or else as its answer does.
 */
function inWords({ code, was, params, detail }, name, titles) {
  const unit = name ? unitOf(name) : "";
  const values = Object.fromEntries(Object.entries(params ?? {}).map(([key, value]) => [key, parameter(key, value, unit, titles)]));
  const words = textOf(code, values) ?? textOf(was, values) ?? detail;
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** What a warning tests, why it matters, how to mend it; none of a code of a newer service. */
export const explained = (code) => said("notices", code) ?? said("checks", code)?.warning;

/** What is wrong with something that has a title, as part of a sentence. */
export function ofTitle(title, words) {
  return message("verdict.field", { title, words: words.charAt(0).toLowerCase() + words.slice(1) });
}

/** Titles as they stand beside a field: those of its own part first, where others have fields of the same name. */
function titlesBeside(pointer, shown, titles) {
  const part = keysOf(pointer).slice(0, -1).join(".");
  const beside = shown.filter(({ path, name }) => name && path === (part ? `${part}.${name}` : name));
  return new Map([...titles, ...beside.map(({ name, title }) => [name, title])]);
}

/**
 * What the service says of a box: its words, the cell, or the column, of a list of records they are about, and where
 * something is asked for that is no box yet, its path.
 */
function atBox(field, { pointer, params }, words, titles) {
  const keys = keysOf(pointer);
  if (["name", "option"].includes(field.kind) && keys.join(".") !== field.path) {
    return { words: ofTitle(quoted(titleOf(keys.at(-1), titles)), words), ask: keys.join(".") };
  }
  if (ofRadius(field, params)) return { words: message("form.ofRadius", { words }) };
  const about = field.kind === "records" && field.columns.findLast(({ name }) => keys.includes(name));
  if (!about) return { words };
  if (field.covers) return { words: ofTitle(about.title, words) };
  const [row] = keys.slice(-2);
  return {
    words: message("rows.problem", { row: Number(row) + 1, title: about.title, words }),
    place: { row: Number(row), column: about.name },
  };
}

/** Name of the field that a pointer ends at, and the row of a list that it is in; none for the body. */
function named(pointer) {
  const keys = keysOf(pointer);
  const at = keys.findLastIndex((key) => !/^\d*$/.test(key));
  const row = keys[at - 1];
  return { name: keys[at], row: /^\d+$/.test(row) ? Number(row) + 1 : undefined };
}

/** What the service says of a field that is not on the screen. */
function ofPointer({ name, row }, words, titles) {
  if (name === undefined) return words;
  const title = titleOf(name, titles);
  return row === undefined ? ofTitle(title, words) : message("rows.problem", { row, title, words });
}

/** Where a mechanism cannot work, `{API name: value}`, as the end of a sentence. */
function placeText(where) {
  const places = Object.entries(where).map(([name, value]) =>
    `${said("places", name) ?? name} = ${formatQuantity(value, unitOf(name))}`);
  return places.length > 0 ? ` (${places.join("; ")})` : "";
}

/**
 * A refusal in words: `{ at: {path: { words, place?, ask?, code? }}, elsewhere: [sentence] }`, parted into what
 * belongs to the `shown` fields and what does not; `code` is that of a refusal which asks for something.
 */
export function refusalTexts(refusal, shown, titles) {
  const at = {};
  const elsewhere = [];
  for (const error of refusal.errors) {
    const field = fieldAtPointer(shown, error.pointer);
    const about = named(error.pointer);
    const words = inWords(error, about.name, titlesBeside(error.pointer, shown, titles));
    if (field) at[field.path] ??= { ...atBox(field, error, words, titles), ...(MISSING.includes(error.code) && { code: error.code }) };
    else elsewhere.push(ofPointer(about, words, titles) + (error.pointer === "" ? placeText(refusal.where) : ""));
  }
  if (refusal.errors.length === 0) elsewhere.push(refusalOfKind(refusal));
  return { at, elsewhere };
}

/** What a refusal that is about no field says. */
function refusalOfKind({ kind, message: detail }) {
  const words = message("refused")[kind];
  return words ?? detail.charAt(0).toUpperCase() + detail.slice(1);
}

/** Anything that went wrong, as one sentence: no service, a refusal wherever its fields are, an error. */
export function problemText(problem, titles) {
  if (problem.status === 0) return message("page.unreachable");
  return problem.errors ? refusalTexts(problem, [], titles).elsewhere.join("; ") : problem.message;
}

/** The same where the page asks again by itself what may be answered then. */
export function passingText(problem, titles) {
  return [problemText(problem, titles), problem.passing && message("page.again")].filter(Boolean).join(" ");
}

export function warningText(warning, titles) {
  return inWords(warning, warning.params?.field, titles);
}

/** The warnings of an answer as sentences `[level, text]`. */
export const warningSentences = ({ warnings = [] }, titles) => warnings.map((warning) => ["warning", warningText(warning, titles)]);

/** Why a check stands as it does, and of which field that is said. */
export function reasonText(reason, titles) {
  const about = named(reason.pointer ?? "");
  return ofPointer(about, inWords(reason, about.name, titles), titles);
}

/** A number of a figure, or Plotly's placeholder of one, with its unit as it is shown. */
function amount({ value, unit, digits }) {
  if (typeof value === "number") return formatQuantity(value, unit, Math.min(digits, shownDigits(0)));
  return value + (unit === "" || unit === "°" ? unit : `\u00a0${shownUnit(unit)}`);
}

function placed(param) {
  if (Array.isArray(param)) return figureText(...param);
  return typeof param === "object" ? amount(param) : param;
}

/** A text of a figure by its id and parameters: its title, an axis, a legend, what is shown at a point. */
export function figureText(id, params = {}) {
  const [kind, code] = id.includes(".") ? id.split(".") : ["figures", id];
  const values = Object.fromEntries(Object.entries(params).map(([name, value]) =>
    [name, name === "unit" ? shownUnit(value) : placed(value)]));
  return said(kind, code, values);
}

/** What the model of a calculation leaves out, in words. */
export const neglectedIn = (about) => (about?.model ?? []).map(({ code }) => said("neglected", code));
