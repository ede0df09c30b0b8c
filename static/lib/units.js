/**
 * The units that people see. Canonical ones stay in requests, links and files; only boxes, tables,
 * figures and texts are shown in the chosen system. No DOM.
 */
const LBF = 4.4482216152605; // N
const INCH = 25.4; // mm
const FOOT = 0.3048; // m
const POUND = 0.45359237; // kg
const PSI = LBF / INCH ** 2; // MPa

/** The unit of a radius in mm that is shown and typed as a diameter. */
export const DIAMETER = "⌀ mm";

/** Canonical unit: the unit shown for it and its size in the canonical one. */
const SHOWN = {
  metric: { [DIAMETER]: ["mm", 0.5] },
  us: {
    [DIAMETER]: ["in", INCH / 2],
    mm: ["in", INCH],
    N: ["lbf", LBF],
    "N·m": ["lbf·in", (LBF * INCH) / 1000],
    "N·m/′": ["lbf·in/′", (LBF * INCH) / 1000],
    "N/mm": ["lbf/in", LBF / INCH],
    "mm/N": ["in/lbf", INCH / LBF],
    "mrad/N": ["mrad/lbf", 1 / LBF],
    MPa: ["psi", PSI],
    GPa: ["Mpsi", PSI * 1000],
    "m/s": ["ft/s", FOOT],
    "MPa·m/s": ["psi·ft/min", (PSI * FOOT) / 60],
    "mm³/(N·m)": ["in²/lbf", (INCH ** 3 * 1000) / (LBF * INCH)],
    kg: ["lb", POUND],
    "kg·mm": ["lb·in", POUND * INCH],
    "kg/m³": ["lb/in³", POUND / (INCH / 1000) ** 3],
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

let diameters = false;

/** Whether radii are shown and typed as diameters. */
export function setDiameters(chosen) {
  diameters = chosen;
}

export const inDiameters = () => diameters;

/** Names of units where the language in use has its own. */
export function setUnitNames(own) {
  names = own;
}

const DEGREE = Math.PI / 180;
const NEWTON = { n: 1, kn: 1000, lbf: LBF, "н": 1, "кн": 1000 };
const METRE = { mm: 1, cm: 10, m: 1000, "µm": 0.001, um: 0.001, in: INCH, inch: INCH, '"': INCH, "мм": 1, "см": 10, "м": 1000, "мкм": 0.001 };
// Units that people write, by the canonical one, with their sizes in it; lower case, Cyrillic ones too.
const WRITTEN = {
  mm: METRE,
  N: NEWTON,
  "N·m": {
    nm: 1, knm: 1000, nmm: 0.001, lbfin: (LBF * INCH) / 1000, lbfft: (12 * LBF * INCH) / 1000, "нм": 1, "кнм": 1000,
  },
  "N/mm": { "n/mm": 1, "lbf/in": LBF / INCH, "н/мм": 1 },
  MPa: { mpa: 1, gpa: 1000, "n/mm²": 1, "n/mm2": 1, psi: PSI, ksi: 1000 * PSI, "мпа": 1, "гпа": 1000 },
  GPa: { gpa: 1, mpa: 0.001, mpsi: 1000 * PSI, "гпа": 1, "мпа": 0.001 },
  "°": { "°": 1, deg: 1, "град": 1, rad: 1 / DEGREE, "рад": 1 / DEGREE },
  "": { "%": 0.01 },
};

/**
 * A typed text parted into amount and unit, `{ amount, size }`: the size of the unit in the canonical
 * one, undefined where none is written; null where it is a unit of something else.
 */
export function partedUnit(text, unit) {
  const [, amount, written] = /^(.*?)((?:[a-zа-яµ"°%²·*.\s]|n\/mm[²2]?|lbf\/in|н\/мм)*)$/is.exec(text);
  const named = written.toLowerCase().replace(/[·*.\s]/g, "");
  if (named === "") return { amount: text };
  const size = WRITTEN[unit === DIAMETER ? "mm" : unit]?.[named];
  if (size !== undefined) return { amount: amount.trim(), size };
  return Object.values(WRITTEN).some((units) => named in units) ? null : { amount: text };
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

// The values that stand behind texts which show only some of their digits.
const spelled = new Map();
const LONG = 12; // more digits than anybody types: a value converted from other units

/** A canonical value as the text of a box, which `canonicalValue` reads back to the same value. */
export function spell(value, unit) {
  const asIs = shownAsIs(unit);
  if (asIs && (typeof value !== "number" || Number(value.toPrecision(LONG)) === value)) return String(value);
  for (let digits = asIs ? 9 : 7; digits <= 17; digits += 1) {
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
  return spelled.get(`${unit} ${typed}`) ?? (shownAsIs(unit) ? typed : Number((typed * sizeOf(unit)).toPrecision(15)));
}

/** A step of the arrow keys in the shown unit: the nearest of 1, 2 and 5 by tens. */
export function shownStep(step, unit) {
  if (sizeOf(unit) === 1) return step;
  const exact = shownValue(step, unit);
  const decade = 10 ** Math.floor(Math.log10(exact));
  const lead = exact / decade;
  return Number(((lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * decade).toPrecision(12));
}
