/**
 * The page's texts by key, with `{name}` put in, in the language in use.
 *
 * What the service says in English (titles of fields, figures, refusals) has its words in the
 * files of the other languages; what these don't know stays as the service said it.
 */
import { setDecimal } from "../format.js";
import en from "./en.js";

/** The languages by their own names; a new one is its own file here and a word below. */
export const LANGUAGES = { en: "English" };

let texts = en;

/** Read the texts of a language. */
export async function useLanguage(language) {
  texts = language === "en" ? en : (await import(`./${language}.js`)).default;
  setDecimal(texts.page.decimal);
}

function find(key, where) {
  return key.split(".").reduce((part, name) => part?.[name], where);
}

export function message(key, values = {}) {
  const found = find(key, texts);
  if (found === undefined) throw new Error(`no message "${key}"`);
  if (typeof found !== "string") return found;
  return found.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
}

/** What stands in the service's own words, by kind and name; `said` where the language has none. */
export function translation(kind, name, said) {
  return texts.service?.[kind]?.[name] ?? said;
}

const NO_WORDS = /(%\{[^}]*\}|<[^>]*>|-?\d+(?:\.\d+)?(?:e[+-]?\d+)?|[,:;=]\s)/;

/** A text of a figure: its words in the language in use, its numbers and marks as they are. */
export function chartWords(text) {
  const words = texts.service?.chart;
  if (!words) return text;
  if (words[text]) return words[text];
  return text.split(NO_WORDS).map((part) => {
    const [, before, phrase, after] = /^(\s*)(.*?)(\s*)$/s.exec(part);
    return before + (words[phrase] ?? phrase) + after;
  }).join("");
}
