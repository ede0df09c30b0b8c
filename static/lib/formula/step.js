/**
 * A worked step: how one result follows from its formula. No DOM, no texts.
 *
 * `{ name, formula, values, unit, value, symbol, source, equation, erratum, note }`: `name` of the
 * API's result or of an intermediate value (then it has its title in `worked.title`), `source` and
 * `equation` where the formula stands, `erratum` and `note` keys of texts, `note` with its values.
 * A step without formula is said in its note alone.
 */
import { unitOf } from "../format.js";
import { evaluate, fromSI, quantity } from "./evaluate.js";
import { parse } from "./notation.js";

/** A result of a section of the service's answer; `value` of `rest` where it is a part of one. */
export function result(section, name, symbol, rest) {
  return { name, symbol, value: section[name], unit: unitOf(name), values: {}, ...rest };
}

/** A value on the way that the service does not give; it is computed from its formula. */
export function intermediate(name, symbol, unit, { formula, values, ...rest }) {
  return { name, symbol, unit, formula, values, intermediate: true, value: valueOf({ formula, values, unit }), ...rest };
}

/** What the formula of a step gives with the numbers put in, in the step's unit. */
function valueOf({ formula, values, unit }) {
  return fromSI(evaluate(parse(formula), values), unit);
}

/** A step's result as a value for later formulas. */
export function asValue({ symbol, value, unit }) {
  return quantity(symbol, value, unit);
}
