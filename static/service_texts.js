/**
 * What the service says in words: refusals, warnings and figures, in the language and with the titles
 * of the page. `titles` maps API field names to titles. No DOM.
 */
import { formatNumber, formatQuantity, unitOf } from "./lib/format.js";
import { fieldAtPointer, keysOf } from "./lib/schema_form.js";
import { chartWords, message, translated } from "./messages/index.js";

const NAME = /\b([a-z]\w*_\w+|[a-z]{4,})(?: = (-?[\d.]+(?:e[+-]?\d+)?))?/gi;

/** A sentence of the service: API names become titles, values get their units. */
function inWords(detail, titles) {
  const text = translated(detail).replace(NAME, (whole, name, value) => {
    const title = titles.get(name);
    if (title === undefined) return whole;
    const words = title.charAt(0).toLowerCase() + title.slice(1);
    if (value === undefined) return words;
    const unit = unitOf(name);
    return `${words} ${unit ? formatQuantity(Number(value), unit) : formatNumber(Number(value))}`;
  });
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** What is wrong with something that has a title, as part of a sentence. */
export function ofTitle(title, words) {
  return message("verdict.field", { title, words: words.charAt(0).toLowerCase() + words.slice(1) });
}

/** What the service says of a box: its words, and the cell of a list of records they are about. */
function atBox(field, pointer, words) {
  const [row, column] = keysOf(pointer).slice(-2);
  const about = field.kind === "records" && field.columns.find(({ name }) => name === column);
  if (!about) return { words };
  return {
    words: message("rows.problem", { row: Number(row) + 1, title: about.title, words }),
    place: { row: Number(row), column },
  };
}

/** What the service says of a field that is not on the screen. */
function ofPointer(pointer, words, titles) {
  const keys = keysOf(pointer);
  const at = keys.findLastIndex((key) => !/^\d*$/.test(key));
  if (at < 0) return words;
  const title = titles.get(keys[at]) ?? keys[at];
  const row = keys[at - 1];
  return /^\d+$/.test(row) ? message("rows.problem", { row: Number(row) + 1, title, words }) : ofTitle(title, words);
}

/**
 * A refusal in words: `{ at: {path: { words, place? }}, elsewhere: [sentence] }`, parted into what
 * belongs to the `shown` fields and what does not.
 */
export function refusalTexts(refusal, shown, titles) {
  const at = {};
  const elsewhere = [];
  for (const { pointer = "", detail } of refusal.errors) {
    const field = fieldAtPointer(shown, pointer);
    const words = inWords(detail, titles);
    if (field) at[field.path] ??= atBox(field, pointer, words);
    else elsewhere.push(ofPointer(pointer, words, titles));
  }
  if (refusal.errors.length === 0) elsewhere.push(inWords(refusal.message, titles));
  return { at, elsewhere };
}

/** Anything that went wrong, as one sentence: no service, a refusal wherever its fields are, an error. */
export function problemText(problem, titles) {
  if (problem.status === 0) return message("page.unreachable");
  return problem.errors ? refusalTexts(problem, [], titles).elsewhere.join("; ") : problem.message;
}

export function warningText({ detail }, titles) {
  return inWords(detail, titles);
}

/** A text of a figure: its title, an axis, a legend, what is shown at a point. */
export const figureText = chartWords;
