/**
 * The whole input in the address: a link is a design. No DOM.
 *
 * `?calculator=<id>&v=2&<dotted API field name>=<value>&lengths=diameter&verdict=<word>`, the last but one where radii are
 * shown as diameters: the names and the canonical units of the
 * REST bodies; what stands at its default is left out. A text that cannot be read as a number is
 * kept as typed, so that a reload loses nothing.
 */
import { linkedFields, readField, textIn, textInLink, textOfLink } from "./form_state.js";

const VERSION = "2"; // since 2, a link says its verdict
const VERSIONS = ["1", VERSION];

function canonical(field, text) {
  const { value } = readField(field, text);
  return value === undefined ? text.trim() : textInLink(field, value);
}

/** The parameters of a state. */
export function encodeState(model, state) {
  const parameters = new URLSearchParams();
  for (const field of linkedFields(model, state)) {
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

/** What a link may hold besides the fields: which calculator, its version and verdict, how it is shown, what the design is called. */
export const LABELS = ["title", "author", "revision", "note"];
const KNOWN = ["calculator", "v", "verdict", "units", "lang", "lengths", ...LABELS];

/**
 * `{ state, claim }`: the state that the parameters describe, null where they describe none, and what they say besides: `unknown` lists
 * what this version does not know or what contradicts the rest, `older` says that the link was made before
 * links said their `verdict`. A link without a version is of the current one.
 */
export function decodeState(model, link, calculator = link.get("calculator")) {
  const parameters = new URLSearchParams(link);
  for (const [path, older] of Object.entries(model.moved ?? {})) {
    if (link.has(older) && !link.has(path)) parameters.set(path, link.get(older));
    parameters.delete(older);
  }
  const names = [...new Set(parameters.keys())];
  const another = (parameters.get("calculator") ?? calculator) !== calculator;
  const described = names.some((name) => name === "v" || LABELS.includes(name) || model.fields.has(name));
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
  const shown = new Set(linkedFields(model, { texts, chosen }).map(({ path }) => path));
  const version = parameters.get("v") ?? VERSION;
  const unknown = [
    ...(another ? [`calculator=${parameters.get("calculator")}`] : []),
    ...(VERSIONS.includes(version) ? [] : [`v=${version}`]),
    ...names.filter((name) => !KNOWN.includes(name) && !shown.has(name)),
  ];
  if (!described) return { state: null, claim: { unknown } };
  const claim = { unknown, older: version === "1", verdict: parameters.get("verdict") ?? undefined };
  return { state: { texts, chosen }, claim };
}

/** The query of a calculator's state, as it stands behind the `?`. */
export function query(calculator, model, state) {
  const all = new URLSearchParams({ calculator, v: VERSION });
  for (const [key, value] of encodeState(model, state)) all.append(key, value);
  if (model.diameters) all.append("lengths", "diameter");
  for (const label of LABELS) if (state.texts[label]) all.append(label, state.texts[label]);
  return all.toString();
}

/** A query that says the verdict, where there is one: who opens it later learns whether it has moved. */
export function withVerdict(address, verdict) {
  return verdict ? `${address}&verdict=${verdict}` : address;
}
