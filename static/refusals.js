/** Refusals of the service, sorted by the boxes on the screen that they are about. */
import { message } from "./messages/index.js";
import { fieldAtPointer, keysOf } from "./schema_form.js";
import { inWords } from "./wording.js";

/** What the service says of a field: its words, and the box of a list of records they are about. */
function refusalAt(field, pointer, words) {
  const [row, column] = keysOf(pointer).slice(-2);
  const about = field.kind === "records" && field.columns.find(({ name }) => name === column);
  if (!about) return { words };
  return {
    words: message("rows.problem", { row: Number(row) + 1, title: about.title, words }),
    place: { row: Number(row), column },
  };
}

/** What is wrong with something that has a title, as part of a sentence. */
export function ofTitle(title, words) {
  return message("verdict.field", { title, words: words.charAt(0).toLowerCase() + words.slice(1) });
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

/** Part a refusal into what belongs to boxes on the screen, by path, and what does not. */
export function placed(refusal, shown, titles) {
  const refused = {};
  const elsewhere = [];
  for (const { pointer = "", detail } of refusal?.errors ?? []) {
    const field = fieldAtPointer(shown, pointer);
    const words = inWords(detail, titles);
    if (field) refused[field.path] ??= refusalAt(field, pointer, words);
    else elsewhere.push(ofPointer(pointer, words, titles));
  }
  if (refusal && refusal.errors.length === 0) elsewhere.push(inWords(refusal.message, titles));
  return { refused, elsewhere };
}

/** What went wrong, in words: a refusal wherever its fields are, or any other error. */
export function inSentence(problem, titles) {
  if (problem.status === 0) return message("page.unreachable");
  return problem.errors ? placed(problem, [], titles).elsewhere.join("; ") : problem.message;
}
