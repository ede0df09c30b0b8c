/**
 * The units that people see. Canonical ones stay in requests, links and files; only boxes, tables,
 * figures and texts are shown in the chosen system. No DOM.
 */
const LBF = 4.4482216152605; // N
const INCH = 25.4; // mm
const PSI = LBF / INCH ** 2; // MPa

/** Canonical unit: the unit shown for it and its size in the canonical one. */
const SHOWN = {
  metric: {},
  us: {
    mm: ["in", INCH],
    N: ["lbf", LBF],
    "N·m": ["lbf·in", (LBF * INCH) / 1000],
    "N/mm": ["lbf/in", LBF / INCH],
    "mm/N": ["in/lbf", INCH / LBF],
    MPa: ["psi", PSI],
    GPa: ["Mpsi", PSI * 1000],
  },
};

export const SYSTEMS = Object.keys(SHOWN);

let system = "metric";
let names = {}; // of units in the language in use

export function setUnits(chosen) {
  if (!SHOWN[chosen]) throw new RangeError(`no system of units "${chosen}"`);
  system = chosen;
  spelled.clear();
}

/** Names of units where the language in use has its own. */
export function setUnitNames(own) {
  names = own;
}

function sizeOf(unit) {
  return SHOWN[system][unit]?.[1] ?? 1;
}

export function shownUnit(unit) {
  const shown = SHOWN[system][unit]?.[0] ?? unit;
  return names[shown] ?? shown;
}

/** Whether values of a unit are shown as they are. */
export function shownAsIs(unit) {
  return sizeOf(unit) === 1;
}

export function shownValue(value, unit) {
  return value / sizeOf(unit);
}

// The values that stand behind texts which show only seven of their digits.
const spelled = new Map();

/** A canonical value as the text of a box, which `canonicalValue` reads back to the same value. */
export function spell(value, unit) {
  if (sizeOf(unit) === 1) return String(value);
  for (let digits = 7; digits <= 17; digits += 1) {
    const text = String(Number(shownValue(value, unit).toPrecision(digits)));
    const key = `${unit} ${Number(text)}`;
    if ((spelled.get(key) ?? value) === value) {
      spelled.set(key, value);
      return text;
    }
  }
  return String(shownValue(value, unit));
}

/** The canonical value of a number typed in the shown unit. */
export function canonicalValue(typed, unit) {
  if (sizeOf(unit) === 1) return typed;
  return spelled.get(`${unit} ${typed}`) ?? Number((typed * sizeOf(unit)).toPrecision(15));
}

/** A step of the arrow keys in the shown unit: the nearest of 1, 2 and 5 by tens. */
export function shownStep(step, unit) {
  if (sizeOf(unit) === 1) return step;
  const exact = shownValue(step, unit);
  const decade = 10 ** Math.floor(Math.log10(exact));
  const lead = exact / decade;
  return Number(((lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * decade).toPrecision(12));
}
