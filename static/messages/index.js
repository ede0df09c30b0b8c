/**
 * The page's texts by key, with `{name}` put in, in the language in use.
 *
 * What the service says in English (titles of fields, figures, refusals) has its words in the
 * files of the other languages, under `service`; what these don't know stays as it was said.
 */
import { setDecimal } from "../lib/format.js";
import en from "./en.js";

/** The languages by their own names; a new one is its own file here and a word below. */
export const LANGUAGES = { en: "English", uk: "Українська", ru: "Русский" };

let texts = en;
let templates = [];

/** `must be at least {1}` as what recognises it. */
function recogniser(template) {
  const parts = template.split(/\{\d\}/).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return new RegExp(`^${parts.join("(.+?)")}$`, "s");
}

/** Read the texts of a language. */
export async function useLanguage(language) {
  texts = language === "en" ? en : (await import(`./${language}.js`)).default;
  templates = (texts.service?.sentences ?? []).map(([said, words]) => [recogniser(said), words]);
  setDecimal(texts.page.decimal);
}

export function message(key, values = {}) {
  const found = key.split(".").reduce((part, name) => part?.[name], texts);
  if (found === undefined) throw new Error(`no message "${key}"`);
  if (typeof found !== "string") return found;
  return found.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
}

/** A title or a sentence of the service in the language in use. */
export function translated(said) {
  const words = texts.service?.words[said];
  if (words !== undefined) return words;
  for (const [pattern, sentence] of templates) {
    const found = pattern.exec(said);
    if (found) return sentence.replace(/\{(\d)\}/g, (_, i) => found[i]);
  }
  return said;
}

const NO_WORDS = /(%\{[^}]*\}|<[^>]*>|-?\d+(?:\.\d+)?(?:e[+-]?\d+)?|[,:;=](?=\s|$))/;

/** A text of a figure: its words in the language in use, its numbers and marks as they are. */
export function chartWords(text) {
  const words = texts.service?.words;
  if (!words) return text;
  const [, title, unit] = /^(.*?)(, [^,]+)?$/s.exec(text);
  const whole = words[text] ?? (title in words ? words[title] + (unit ?? "") : undefined);
  return whole ?? text.split(NO_WORDS).map((part) => {
    const [, before, phrase, after] = /^(\s*)(.*?)(\s*)$/s.exec(part);
    return before + (words[phrase] ?? phrase) + after;
  }).join("");
}
