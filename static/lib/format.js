/** Numbers as people type them and as they read them. No DOM, no texts: problems are codes. */
import { shownUnit, shownValue } from "./units.js";

let decimal = ".";
let times = "\u202f×\u202f";

/** The decimal sign of the language in use, and how it joins a power of ten. */
export function setNumerals(numerals) {
  ({ decimal, times } = numerals);
}

const MINUS = "\u2212";
const NARROW_SPACE = "\u202f";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

// Spaces may only part groups of three digits, so that "3 5" is refused and not read as 35.
const GROUPED = "\\d{1,3}(?:\\s\\d{3})+";
const NUMBER = new RegExp(`^([+-]?)((?:${GROUPED}|\\d+)?)(?:[.,](\\d*))?(?:e([+-]?\\d+))?$`, "i");

/**
 * Read one number: `32,5`, `32.5`, `1e-3`, `1 000,5` (any kind of space, true minus too).
 *
 * Returns `{ value }`, with `ambiguous: true` where a comma might have been meant to part
 * thousands (`1,000`), or `{ problem }`: "required", "separators", "number" or "range".
 */
export function parseNumber(text) {
  const typed = text.trim().replace(/[\u2212\u2013]/g, "-");
  if (typed === "") return { problem: "required" };
  if ((typed.match(/[.,]/g) ?? []).length > 1) return { problem: "separators" };
  const match = NUMBER.exec(typed);
  if (!match || (match[2] === "" && !match[3])) return { problem: "number" };
  const [, sign, whole, fraction = "", exponent = "0"] = match;
  const value = Number(`${sign}${whole.replace(/\s/g, "") || "0"}.${fraction || "0"}e${exponent}`);
  if (!Number.isFinite(value)) return { problem: "range" };
  const ambiguous = /^[+-]?[1-9]\d{0,2},\d{3}$/.test(typed);
  return ambiguous ? { value, ambiguous } : { value };
}

const TOKEN = /\s*(?:([-+*/:×·÷()])|((?:\d[\d\s]*)?(?:[.,]\d*)?(?:e[+-]?\d+)?))/iy;

function tokens(text) {
  const all = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const from = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match || TOKEN.lastIndex === from) return [];
    const [, sign, number] = match;
    if (!sign && number.trim() === "") return [];
    const value = sign ? undefined : parseNumber(number).value;
    if (!sign && value === undefined) return [];
    all.push(sign ?? value);
  }
  return all;
}

/** Read a number or a sum of numbers: `10/9`, `350+20`, `2*(3-0,5)`, `1 1/2`, `20:1`; as `parseNumber`, with `worked` for sums. */
export function parseSum(text) {
  const plain = parseNumber(text);
  const typed = text.trim().replace(/[\u2212\u2013]/g, "-");
  if (plain.value !== undefined || !/[-+*/:×·÷(]/.test(typed.slice(1))) return plain;
  const all = tokens(typed.replace(/^(\d+)\s+(\d+\s*\/\s*\d+)$/, "$1+$2"));
  let at = 0;
  const one = () => {
    const token = all[at];
    at += 1;
    if (token === "-") return -one();
    if (token !== "(") return typeof token === "number" ? token : NaN;
    const value = sum();
    at += 1;
    return all[at - 1] === ")" ? value : NaN;
  };
  const product = () => {
    let value = one();
    while (/^[*/:×·÷]$/.test(all[at])) value = "/:÷".includes(all[at++]) ? value / one() : value * one();
    return value;
  };
  const sum = () => {
    let value = product();
    while (all[at] === "+" || all[at] === "-") value = all[at++] === "+" ? value + product() : value - product();
    return value;
  };
  const value = sum();
  return at === all.length && Number.isFinite(value) ? { value: tidy(value), worked: true } : { problem: "number" };
}

/** Read a list: `0; 120; 240`, `0 120 240` or `0, 120, 240`. Returns `{ values }` or `{ problem }`. */
export function parseNumbers(text) {
  const typed = text.trim().replace(/;$/, "");
  if (typed === "") return { problem: "required" };
  const parts = typed.split(typed.includes(";") ? ";" : /,?\s+/);
  const values = [];
  for (const part of parts) {
    const { value, problem } = parseNumber(part);
    if (problem) return { problem: problem === "required" ? "number" : problem };
    values.push(value);
  }
  return { values };
}

/** The text of a number as one types it in the language in use. */
export function typedText(text) {
  return text.replace(".", decimal);
}

/** The same number without the noise of binary sums: 5 + 1.1 gives 6.1. */
export function tidy(value) {
  return Number(value.toPrecision(15));
}

const SHOWN = 4;
/** Digits of what is typed, pointed at, listed for a figure or saved: without the noise of binary sums. */
export const ALL = 12;

/** How many digits a stated relative error allows to show. */
export function shownDigits(relativeError, most = SHOWN) {
  if (!(relativeError > 0)) return most;
  return Math.max(1, Math.min(most, Math.floor(-Math.log10(relativeError))));
}

/** Results that follow from the request alone: the error of those beside them is not theirs. */
const AS_ASKED = ["relative_speed_rpm"];
/** Results whose models are rougher than their numbers. */
const ROUGH = /_life_h|^life_h|safety|(?:contact|force)_ratio$|inertia|slope|shift|turn_mrad|unbalance|couple|pv_MPa|speed_m_per_s/;

/** How many digits of a result are shown: as many as its model is true to and the error of its numbers allows. */
export function digitsOf(name, { relative_error: error } = {}, most = ROUGH.test(name) ? 3 : SHOWN) {
  return shownDigits(AS_ASKED.includes(name) ? 0 : error, most);
}

function grouped(digits) {
  return digits.length < 5 ? digits : digits.replace(/\B(?=(\d{3})+$)/g, NARROW_SPACE);
}

/** Write a number to so many significant digits; whole numbers are not filled up with noughts. */
export function formatNumber(value, digits = ALL) {
  if (!Number.isFinite(value)) throw new RangeError(`not a finite number: ${value}`);
  if (value === 0) return "0";
  const sign = value < 0 ? MINUS : "";
  const [mantissa, power] = Math.abs(value).toExponential(digits - 1).split("e");
  const exponent = Number(power);
  if (exponent < -3 || exponent > 6) {
    return `${sign}${trimmed(mantissa).replace(".", decimal)}${times}10${superscript(exponent)}`;
  }
  const [whole, fraction] = trimmed(Number(`${mantissa}e${power}`).toFixed(
    Math.max(0, digits - 1 - exponent),
  )).split(".");
  return sign + grouped(whole) + (fraction ? `${decimal}${fraction}` : "");
}

/** A text of the service, its decimal fractions as the language in use writes them. */
export function inNumerals(text) {
  return text.replace(/(?<![\w.])\d+\.\d+(?![\w.])/g, (number) => typedText(number));
}

/** A value of a canonical unit as `{ value, unit }`, texts in the unit shown. */
export function quantityParts(value, unit, digits = SHOWN) {
  return { value: formatNumber(shownValue(value, unit), digits), unit: shownUnit(unit) };
}

/** A value of a canonical unit with the unit shown; degrees and no unit stand close. */
export function formatQuantity(value, unit, digits = SHOWN) {
  const shown = quantityParts(value, unit, digits);
  if (!unit) return shown.value;
  return unit === "°" || unit === "′" ? shown.value + unit : `${shown.value}\u00a0${shown.unit}`;
}

/** A place in a turn. */
export const formatAngle = (degrees, digits) => formatQuantity(Math.round(100 * degrees) / 100, "°", digits);

/** A run time in the unit that suits it. */
export function formatDuration(microseconds) {
  return microseconds < 1000
    ? formatQuantity(microseconds, "µs", 2)
    : formatQuantity(microseconds / 1000, "ms", 2);
}

function trimmed(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

function superscript(exponent) {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => SUPERSCRIPTS[digit]);
  return (exponent < 0 ? "⁻" : "") + digits;
}

const UNITS = {
  _Nm_per_arcmin: "N·m/′", _arcmin: "′", _mm_per_N: "mm/N", _mrad_per_N: "mrad/N", _N_per_mm: "N/mm", _MPa_m_per_s: "MPa·m/s", _mm_per_s: "mm/s", _m_per_s: "m/s", _mm3_per_Nm: "mm³/(N·m)",
  _kg_mm: "kg·mm", _kg_m3: "kg/m³", _kg_m2: "kg·m²", _kg: "kg", _mm: "mm", _Nm: "N·m", _N: "N", _MPa: "MPa", _GPa: "GPa", _deg: "°", _mrad: "mrad",
  _rpm: "rpm", _W: "W", _h: "h", _C: "°C", _percent: "%",
};

/** A value of an answer by its API name, with the unit that ends it. */
export const written = (values, name) => formatQuantity(values[name], unitOf(name), digitsOf(name, values.accuracy));

/** The unit that ends an API field name, "" for a plain number. */
export function unitOf(name) {
  if (/(deflection|error|reaction|slope)_C$/.test(name)) return ""; // a place
  const suffix = Object.keys(UNITS).find((ending) => name.endsWith(ending));
  return suffix ? UNITS[suffix] : "";
}
