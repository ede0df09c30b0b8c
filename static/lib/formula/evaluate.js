/**
 * Formulas computed, in SI, and what stands for their names. No DOM, no texts.
 *
 * A *value* is `{ value, unit, symbol }` in a canonical unit, `value` a list where there is one for
 * each part; a *definition* `{ formula, symbol }` is a name for a formula over the same values.
 */
import { parse } from "./notation.js";

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
  "mrad/N": 1e-3,
  "°": Math.PI / 180,
  mrad: 1e-3,
  rpm: Math.PI / 30,
  h: 3600,
  W: 1,
  kg: 1,
  "kg·mm": 1e-3,
  "m/s": 1,
  "MPa·m/s": 1e6,
  "mm³/(N·m)": 1e-9,
};

function toSI(value, unit) {
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

const FUNCTIONS = {
  sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, abs: Math.abs, min: Math.min, max: Math.max,
  ln: Math.log, atan: Math.atan, acos: Math.acos,
};
const OPERATORS = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
  "^": (a, b) => a ** b,
  neg: (a) => -a,
};

/** Gauss and Legendre's rule of five nodes from -1 to 1: `[node, weight]`. */
export const NODES = [[0, 128 / 225], ...[-1, 1].flatMap((sign) => [-1, 1].map((other) => [
  (sign * Math.sqrt(5 + other * 2 * Math.sqrt(10 / 7))) / 3,
  (322 - other * 13 * Math.sqrt(70)) / 900,
]))];
const PANELS = 400; // enough for the smooth integrands here

function integral(term, from, to) {
  const half = (to - from) / PANELS / 2;
  let total = 0;
  for (let panel = 0; panel < PANELS; panel += 1) {
    const middle = from + (2 * panel + 1) * half;
    for (const [node, weight] of NODES) total += weight * half * term(middle + half * node);
  }
  return total;
}

/** Names of a tree's values that are lists, definitions looked through. */
function listsIn(tree, values, bound = new Set()) {
  if (tree.name) {
    const value = values[tree.name];
    if (bound.has(tree.name) || value === undefined) return [];
    if (value.formula) return listsIn(parse(value.formula), values, bound);
    return Array.isArray(value.value) ? [tree.name] : [];
  }
  const inner = tree.bound ? new Set([...bound, tree.bound]) : bound;
  return (tree.of ?? []).flatMap((part) => listsIn(part, values, inner));
}

/** The values with the i-th of every list. */
export function picked(values, i) {
  return Object.fromEntries(Object.entries(values).map(([name, one]) =>
    [name, Array.isArray(one.value) ? { ...one, value: one.value[i], index: i } : { index: i, ...one }]));
}

/** How many terms a sum over these values has. */
export function termCount(tree, values) {
  const lengths = new Set(listsIn(tree, values).map((name) => values[name].value.length));
  if (lengths.size !== 1) throw new RangeError(`a sum over ${lengths.size} lengths`);
  return [...lengths][0];
}

/** The number that a tree gives in SI with these values; `bound` are SI numbers of bound names. */
export function evaluate(tree, values, bound = {}) {
  if (tree.number !== undefined) return tree.number;
  if (tree.name) {
    if (tree.name in bound) return bound[tree.name];
    if (tree.name === "π") return Math.PI;
    const value = values[tree.name];
    if (!value) throw new RangeError(`no value for ${tree.name}`);
    return value.formula ? evaluate(parse(value.formula), values, bound) : toSI(value.value, value.unit);
  }
  if (tree.operator) return OPERATORS[tree.operator](...tree.of.map((part) => evaluate(part, values, bound)));
  if (tree.call === "sum") {
    const [term] = tree.of;
    return Array.from({ length: termCount(term, values) }, (_, i) => evaluate(term, picked(values, i), bound))
      .reduce((a, b) => a + b, 0);
  }
  if (tree.call === "integral") {
    const [term, from, to] = tree.of;
    const parsed = inlined(term, values);
    return integral(
      (z) => evaluate(parsed, values, { ...bound, [tree.bound]: z }),
      evaluate(from, values, bound), evaluate(to, values, bound),
    );
  }
  return FUNCTIONS[tree.call](...tree.of.map((part) => evaluate(part, values, bound)));
}

/** The tree with its definitions put in, so that they are read once. */
function inlined(tree, values) {
  if (tree.name) return values[tree.name]?.formula ? inlined(parse(values[tree.name].formula), values) : tree;
  return tree.of ? { ...tree, of: tree.of.map((part) => inlined(part, values)) } : tree;
}
