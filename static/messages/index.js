/**
 * The page's texts by key, from a file for each language that the service's reports read too, with `{name}` put in, in the language in use; and what
 * the service says, by kind and code.
 */
import { formatNumber, setNumerals } from "../lib/format.js";
import { setUnitNames } from "../lib/units.js";
import en from "./en.json" with { type: "json" };

/** The languages by their own names; a new one is its own file here and a word below. */
export const LANGUAGES = { en: "English", uk: "Українська", ru: "Русский" };

let texts = en;
let words = {}; // of the service, in the language in use
let described = {}; // and in English, of things that it has words for in other languages alone
let symbols = null; // of the quantities, once one is asked for
let plural = new Intl.PluralRules("en");

/** Read the texts of a language. */
export async function useLanguage(language) {
  texts = language === "en" ? en : (await import(`./${language}.json`, { with: { type: "json" } })).default;
  plural = new Intl.PluralRules(language);
  setNumerals(texts.page);
  setUnitNames(texts.unit);
}

/** Take what the service says, `{ kind: { code: words } }`; what it says in English also gives its symbols by section and name, `symbols()`. */
export function setWords(inLanguage, inEnglish) {
  [words, described, symbols] = [inLanguage, inEnglish, null];
}

const wordsOf = (kind, code) => words[kind]?.[code] ?? described[kind]?.[code];

/** A text with its places filled; one with forms of a noun takes that of `count`. */
function filled(text, values) {
  const one = typeof text === "string" ? text : text[plural.select(values.count)];
  return one.replace(/\{(\w+)\}/g, (whole, name) => {
    const value = values[name] ?? whole;
    return typeof value === "number" ? formatNumber(value) : value;
  });
}

export function message(key, values = {}) {
  const found = key.split(".").reduce((part, name) => part?.[name], texts);
  if (found === undefined) throw new Error(`no message "${key}"`);
  return typeof found === "string" || found.other ? filled(found, values) : found;
}

/** Words of the service by kind and code, a record of them where there are several; undefined for a code without words. */
export function said(kind, code, values = {}) {
  const allOf = (text) => {
    if (typeof text !== "object" || text.other) return text && filled(text, values);
    return Object.fromEntries(Object.entries(text).map(([name, one]) => [name, allOf(one)]));
  };
  return allOf(wordsOf(kind, code));
}

/**
 * Title of a quantity of an answer by its name, or by section and name where sections differ; one that is worked or
 * asked for too has that title.
 */
export function quantityTitle(name, section) {
  const { quantity } = texts;
  return quantity[`${section}.${name}`] ?? quantity[name] ?? said("worked_values", name) ?? fieldWords(name)?.title
    ?? message(`quantity.${name}`);
}

/** Symbol of a quantity of a section, "" for one that has none. */
export function symbolOf(name, section) {
  symbols ??= described.symbols();
  return symbols[section]?.[name] ?? "";
}

/**
 * Title and help of a field by its name, or by group and name where groups differ, in the language in use; null for one
 * that has no words there: in English the schemas have them, each of its own request.
 */
export function ownWords(name, group, values = {}) {
  const named = `${group}.${name}`;
  const { fields = {} } = words;
  const { title, help } = fields[named] ?? texts.own[named] ?? fields[name] ?? {};
  return title === undefined ? null : { title: filled(title, values), help: filled(help, values) };
}

/** The same where no schema is at hand; null for a field that neither page nor service knows. */
export function fieldWords(name, group) {
  const { fields = {} } = described;
  return ownWords(name, group) ?? fields[`${group}.${name}`] ?? fields[name] ?? null;
}
