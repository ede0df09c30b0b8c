/** The page's texts by key, with `{name}` put in. */
import en from "./en.js";

export function message(key, values = {}) {
  const found = key.split(".").reduce((part, name) => part?.[name], en);
  if (found === undefined) throw new Error(`no message "${key}"`);
  if (typeof found !== "string") return found;
  return found.replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
}
