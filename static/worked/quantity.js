/**
 * What stands for the names of a formula. No DOM, no texts.
 *
 * A *value* is `{ value, unit, symbol }` in a canonical unit, `value` a list where there is one for
 * each part; a *definition* `{ formula, symbol }` is a name for a formula over the same values.
 */

/** The canonical units and the derived ones of the worked steps, in SI. */
const IN_SI = {
  "": 1,
  mm: 1e-3,
  N: 1,
  "N·m": 1,
  "N/mm": 1e3,
  MPa: 1e6,
  GPa: 1e9,
  "mm/N": 1e-3,
  "°": Math.PI / 180,
};

export function toSI(value, unit) {
  return value * IN_SI[unit];
}

export function fromSI(value, unit) {
  return value / IN_SI[unit];
}

/** A value in a canonical unit; `symbol` as it is written, its index after `_`. */
export function quantity(symbol, value, unit = "") {
  if (!(unit in IN_SI)) throw new RangeError(`no unit "${unit}"`);
  return { symbol, value, unit };
}

/** A name for a formula, written as its symbol also where numbers are put in. */
export function definition(symbol, formula) {
  return { symbol, formula };
}
