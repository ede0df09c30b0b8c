/**
 * The whole input in the address: a link is a design. No DOM.
 *
 * `?calculator=<id>&v=1&<dotted API field name>=<value>`: the names and the canonical units of the
 * REST bodies; what stands at its default is left out. A text that cannot be read as a number is
 * kept as typed, so that a reload loses nothing.
 */
import { readField, shownFields, textIn, textInLink, textOfLink } from "./schema_form.js";

const VERSION = "1";

function canonical(field, text) {
  const { value } = readField(field, text);
  return value === undefined ? text.trim() : textInLink(field, value);
}

/** The parameters of a state. */
export function encodeState(model, state) {
  const parameters = new URLSearchParams();
  for (const field of shownFields(model, state)) {
    const text = canonical(field, state.texts[field.path]);
    if (text !== "" && text !== textInLink(field, field.default)) parameters.append(field.path, text);
  }
  for (const choice of model.choices) {
    const [first] = choice.options;
    const chosen = choice.options.find((option) => option.id === state.chosen[choice.id]);
    // An option is known by its fields: one that would leave no trace is marked by an empty field.
    if (chosen !== first && !chosen.fields.some((field) => parameters.has(field.path))) {
      parameters.append(chosen.fields[0].path, "");
    }
  }
  return parameters;
}

/** What a link may hold besides the fields: which calculator, its version, how it is shown, what the design is called. */
export const LABELS = ["title", "author", "revision", "note"];
const KNOWN = ["calculator", "v", "units", "lang", ...LABELS];

/**
 * The state that the parameters describe, null where they describe none. A link without a version is
 * of the current one; `unknown` lists what this version does not know, or what contradicts the rest.
 */
export function decodeState(model, parameters) {
  const names = [...new Set(parameters.keys())];
  if (names.every((name) => ["calculator", "units", "lang"].includes(name))) return null;
  const texts = {};
  for (const field of model.fields.values()) {
    const given = parameters.get(field.path);
    texts[field.path] = given === null ? textIn(field, field.default) : textOfLink(field, given);
  }
  for (const label of LABELS) texts[label] = parameters.get(label) ?? "";
  const chosen = {};
  for (const choice of model.choices) {
    const given = choice.options.find((o) => o.fields.some((field) => parameters.has(field.path)));
    chosen[choice.id] = (given ?? choice.options[0]).id;
  }
  const shown = new Set(shownFields(model, { chosen }).map(({ path }) => path));
  const version = parameters.get("v") ?? VERSION;
  const unknown = [
    ...(version === VERSION ? [] : [`v=${version}`]),
    ...names.filter((name) => !KNOWN.includes(name) && !shown.has(name)),
  ];
  return { texts, chosen, unknown };
}

/** The query of a calculator's state, as it stands behind the `?`. */
export function query(calculator, model, state) {
  const all = new URLSearchParams({ calculator, v: VERSION });
  for (const [key, value] of encodeState(model, state)) all.append(key, value);
  for (const label of LABELS) if (state.texts[label]) all.append(label, state.texts[label]);
  return all.toString();
}
