/** "Size for ...": what is asked of the solver at a field, and what its answer says. No DOM. */
import { ALL, formatNumber, formatQuantity, tidy } from "./format.js";
import { isLimited, judgedOf, pathOf, percent, sizedBy, titleOf } from "./checks.js";
import { message, quantityTitle } from "../messages/index.js";

const WIDEST = 20; // times the value at hand, up and down
const MOST_COUNTED = 60;

/** What a value may be looked for: `[{ id, title, pointer, sense, value, percent? }]`, those of the calculator first. */
export function targetsOf(calculator, answer, path) {
  const judged = judgedOf(calculator, answer);
  const checks = sizedBy(judged).filter(({ inputs = [] }) => inputs.some((pointer) => pathOf(pointer) === path));
  const own = (calculator.targets ?? []).map(({ pointer, quantity, value }) =>
    ({ title: quantityTitle(quantity), pointer, sense: "at_least", value }));
  const reserve = judged?.torque_reserve === undefined && !isLimited(calculator, judged) ? []
    : [{ title: message("checks.reserve"), pointer: "/torque_reserve", sense: "at_least", value: 1.1 }];
  const shares = checks.map((check) => ({
    title: message("sizing.used", { check: titleOf(check) }), pointer: `/checks/${check.code}/utilisation`, sense: "at_most", value: 100, percent: true,
  }));
  return checks.length === 0 ? [] : [...own, ...reserve, ...shares].map((target, id) => ({ id: String(id), ...target }));
}

/** The design as it was asked about, with all that is wanted of it; without what the answer is to contain. */
export function designOf(calculator, { input: { besides, ...input }, requests = [] }) {
  const { include, load, ...design } = requests.findLast(({ path }) => path.endsWith(calculator.path))?.body ?? input;
  return { ...design, ...(load && { load: { ...load, include: undefined } }) };
}

const valueAt = (part, path) => path.split(".").reduce((inner, key) => inner?.[key], part);

/** What the results on the screen are of in a field. */
export const valueIn = ({ filled }, { path }) => valueAt(filled, path) ?? valueAt(filled.besides, path);

/** The request: the value is looked for about the one at hand, within the field's own limits. */
export function solveBody(calculator, field, shown, target, amount, want) {
  const input = designOf(calculator, shown);
  const value = valueIn(shown, field);
  const counted = field.kind === "integer";
  const within = (number) => Math.min(Math.max(number, field.lowest ?? -Infinity), field.highest ?? Infinity);
  const range = counted ? [1, Math.max(MOST_COUNTED, value ?? 1)] : [(value ?? 1) / WIDEST, (value ?? 1) * WIDEST];
  const [from, to] = range.map(within);
  return {
    calculation: calculator.path.slice(1),
    input,
    variable: { pointer: `/${field.path.replaceAll(".", "/")}`, from, to, ...(counted ? { integer: true } : from > 0 && { log: true }) },
    target: { pointer: target.pointer, [target.sense]: target.percent ? amount / 100 : amount },
    want,
  };
}

const DIGITS = 4;

/** A value a workshop can read: few digits, rounded to the side that still keeps the target. */
function rounded(value, want) {
  const step = 10 ** (Math.floor(Math.log10(Math.abs(value))) + 1 - DIGITS);
  const near = Math.round(value / step) * step;
  if (value === 0 || Math.abs(near - value) < 1e-9 * Math.abs(value)) return value;
  return tidy((want === "largest" ? Math.floor(value / step) : Math.ceil(value / step)) * step);
}

/** The answer in words, `{ text, sets }`; without `sets` where there is nothing to apply. */
export function solutionOf(field, target, want, { status, value, sets, standard_size: standard, best }) {
  const shown = (number) => formatQuantity(number, field.unit, ALL);
  const names = { field: field.title, target: target.title };
  if (status === "always") return { text: message("sizing.always", names) };
  if (status === "infeasible" || value === undefined) {
    if (!best) return { text: message("sizing.never", names) };
    const reached = target.percent ? percent(best.target) : formatNumber(best.target, 4);
    return { text: message("sizing.notEnough", { ...names, at: shown(best.value), value: reached }) };
  }
  const taken = rounded(value, want);
  const text = [
    message(`sizing.${want}`, { ...names, value: shown(taken) }),
    standard !== undefined && message("sizing.standard", { size: shown(standard) }),
  ].filter(Boolean).join(" ");
  // What follows the value by a sum, as the hole does, follows its rounding too.
  const all = Object.entries(sets ?? { [`/${field.path.replaceAll(".", "/")}`]: value });
  return { text, sets: Object.fromEntries(all.map(([pointer, one]) => [pointer, taken === value ? one : tidy(one + taken - value)])) };
}
