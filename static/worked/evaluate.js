/** Formulas computed, in SI. No DOM, no texts. */
import { parse } from "./notation.js";
import { toSI } from "./quantity.js";

const FUNCTIONS = {
  sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, abs: Math.abs, min: Math.min, max: Math.max,
  ln: Math.log, atan: Math.atan,
};
const OPERATORS = {
  "+": (a, b) => a + b,
  "-": (a, b) => a - b,
  "*": (a, b) => a * b,
  "/": (a, b) => a / b,
  "^": (a, b) => a ** b,
  neg: (a) => -a,
};

// Gauss and Legendre's rule of five nodes, on panels enough for the smooth integrands here.
const NODES = [[0, 128 / 225], ...[-1, 1].flatMap((sign) => [-1, 1].map((other) => [
  (sign * Math.sqrt(5 + other * 2 * Math.sqrt(10 / 7))) / 3,
  (322 - other * 13 * Math.sqrt(70)) / 900,
]))];
const PANELS = 400;

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
export function listsIn(tree, values, bound = new Set()) {
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
