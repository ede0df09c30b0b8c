/** Strength of the pins: what is said and drawn of the service's answer, and its worked steps. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { pinDrawing } from "./along.js";
import { staticStep, torqueOf } from "./bearings.js";
import { chartOf, sleeved } from "./wanted.js";

export const figure = { id: "pinStrength", section: "pin_strength", path: "/pin-strength/chart", body: pinBody };

/** Diameter of the steel pin: that inside its sleeve where it has one. */
export const diameterOf = (input) => (sleeved(input) ? input.besides.pin.diameter_mm : 2 * input.contact.pin_radius_mm);

function pinBody(input) {
  const { mechanism, load, pin, fatigue } = chartOf(input);
  const { contact_length_mm, pin_material: material, dynamic_factor: factor = 1 } = input.contact;
  const torque = load.output_torque_Nm === undefined ? "input_torque_Nm" : "output_torque_Nm";
  return {
    mechanism,
    load: { ...load, [torque]: factor * load[torque] },
    pin: { contact_length_mm, material, ...pin, diameter_mm: diameterOf(input) },
    ...(fatigue && { fatigue }),
  };
}

export function cells({ peak_equivalent_stress_MPa: stress, static_safety_factor: yields, fatigue, deflection }) {
  const title = (name) => message(`quantity.${name}`)[0];
  return [
    {
      label: title("peak_equivalent_stress_MPa"),
      value: formatQuantity(stress, "MPa", 4),
      note: yields === undefined ? message("strength.noYield") : message("strength.yield", { safety: formatNumber(yields, 3) }),
    },
    {
      label: title("fatigue_safety_factor"),
      value: fatigue ? formatNumber(fatigue.safety_factor, 3) : "–",
      note: fatigue ? message("strength.cycle", { from: formatQuantity(fatigue.min_stress_MPa, "MPa", 4), to: formatQuantity(fatigue.max_stress_MPa, "MPa", 4) })
        : message("strength.noFatigue"),
    },
    deflection && {
      label: title("deflection_mm"),
      value: formatQuantity(deflection.deflection_mm, "mm", 3),
      note: message("strength.slope", { satellite: deflection.satellite, slope: formatQuantity(deflection.slope_mrad, "mrad", 3) }),
    },
  ].filter(Boolean);
}

export const drawing = { create: pinDrawing, section: "pin_strength" };

const SURFACES = { // a and b of a·R_m^b, by edition of Shigley
  shigley_9: { ground: [1.58, -0.085], machined: [4.51, -0.265], hot_rolled: [57.7, -0.718], forged: [272, -0.995] },
  shigley_11: { ground: [1.38, -0.067], machined: [3.04, -0.217], hot_rolled: [38.6, -0.65], forged: [54.9, -0.758] },
};

function factorSteps({ factors, ...own }, { fatigue = {} }, d, R_m) {
  if (!factors) return [];
  const strength = q("R_m", R_m); // the fits take its number in MPa
  const shigley = { source: "shigley" };
  const [a, b] = SURFACES[fatigue.edition ?? "shigley_11"][fatigue.surface] ?? [];
  const [c, k] = d > 51 ? [1.51, -0.157] : [1.24, -0.107];
  const of = (name, symbol, rest) => result({ [name]: factors[name] }, name, symbol, rest);
  const { theoretical_factor: K_t, radius_mm: radius } = fatigue.notch ?? {};
  const root = K_t && intermediate("neuber", "s", "", {
    formula: "1.24-0.00225*R_m+0.0000016*R_m^2-0.000000000411*R_m^3", values: { R_m: strength }, ...shigley,
  });
  return [
    of("surface", "k_a", a ? { formula: "min(1;a*R_m^b)", values: { a: q("a", a), b: q("b", b), R_m: strength }, ...shigley } : { note: "given" }),
    of("size", "k_b", { formula: "min(1;c*d^k)", values: { c: q("c", c), d: q("d", d), k: q("k", k) }, ...shigley, note: "inMm" }),
    of("reliability", "k_e", { note: "tabled" }),
    ...(root ? [root] : []),
    of("notch", "K_f", root ? {
      formula: "1+(K_t-1)/(1+s/sqrt(r))", values: { K_t: q("K_t", K_t), s: q("s", root.value), r: q("r", radius) }, ...shigley,
    } : { note: "given" }),
    result(own, "endurance_limit_MPa", "S_e", {
      formula: "k_a*k_b*k_e*min(R_m/2;S)/K_f",
      values: {
        k_a: q("k_a", factors.surface), k_b: q("k_b", factors.size), k_e: q("k_e", factors.reliability), K_f: q("K_f", factors.notch),
        R_m: q("R_m", R_m, "MPa"), S: q("S", 700, "MPa"),
      },
      ...shigley,
    }),
  ];
}

const KPSI = 6.894757293168361;

/** The strength for the cycles of the life, where these are so few that it is above the endurance limit. */
function finiteSteps(fatigue, { load, mechanism, requirements }, R_m) {
  if (fatigue.finite_strength_MPa === undefined) return [];
  const cycles = intermediate("lifeCycles", "N_L", "", {
    formula: "max(1000;n_1*(1+1/u)*L/(2*π))",
    values: { n_1: q("n_1", load.input_speed_rpm, "rpm"), u: q("u", mechanism.ratio), L: q("L", requirements.life_h, "h") },
    note: "turnsOverLife",
  });
  const fraction = intermediate("strengthFraction", "f", "", {
    formula: "1.06-0.0028*S+0.0000069*S^2", values: { S: q("S", Math.min(Math.max(R_m / KPSI, 70), 200)) }, source: "shigley", note: "inKpsi",
  });
  return [cycles, fraction, result(fatigue, "finite_strength_MPa", "S_f", {
    formula: "S_e*(f*R_m/S_e)^(2-ln(N_L)/ln(1000))",
    values: { S_e: q("S_e", fatigue.endurance_limit_MPa, "MPa"), f: asValue(fraction), R_m: q("R_m", R_m, "MPa"), N_L: asValue(cycles) },
    source: "shigley",
  })];
}

function fatigueSteps(fatigue, input, d, { tensile_strength_MPa: R_m, yield_strength_MPa: R_e }) {
  if (!fatigue) return [];
  const { besides, load, mechanism } = input;
  const lasting = fatigue.finite_strength_MPa;
  const at = (name, symbol, rest) => result(fatigue, name, symbol, rest);
  const [top, low] = [q("σ_max", fatigue.max_stress_MPa, "MPa"), q("σ_min", fatigue.min_stress_MPa, "MPa")];
  const criterion = besides.fatigue.criterion ?? "goodman";
  return [
    at("position_mm", "x", { note: "worstCycle" }),
    ...(fatigue.direction_deg === undefined ? [] : [at("direction_deg", "χ", { note: "worstCycle" })]),
    at("max_stress_MPa", "σ_max", { note: "worstCycle" }),
    at("min_stress_MPa", "σ_min", { note: "worstCycle" }),
    at("amplitude_MPa", "σ_a", { formula: "(σ_max-σ_min)/2", values: { σ_max: top, σ_min: low } }),
    at("mean_MPa", "σ_m", { formula: "(σ_max+σ_min)/2", values: { σ_max: top, σ_min: low } }),
    ...factorSteps(fatigue, besides, d, R_m),
    ...(fatigue.factors ? [] : [at("endurance_limit_MPa", "S_e", { note: "given" })]),
    ...finiteSteps(fatigue, input, R_m),
    result({ fatigue_safety_factor: fatigue.safety_factor }, "fatigue_safety_factor", "n", ["goodman", "soderberg"].includes(criterion) ? {
      formula: lasting === undefined ? "1/(σ_a/S_e+max(σ_m;0)/R)" : "1/(σ_a/S_f+max(σ_m;0)/R)",
      values: {
        σ_a: q("σ_a", fatigue.amplitude_MPa, "MPa"), σ_m: q("σ_m", fatigue.mean_MPa, "MPa"),
        ...(lasting === undefined ? { S_e: q("S_e", fatigue.endurance_limit_MPa, "MPa") } : { S_f: q("S_f", lasting, "MPa") }), R: criterion === "soderberg" ? q("R_e", R_e, "MPa") : q("R_m", R_m, "MPa"),
      },
      source: "shigley",
    } : { note: "criterion" }),
    ...(fatigue.cycles === undefined ? [] : [at("cycles", "N", { note: "finiteLife" })]),
    ...(fatigue.life_h === undefined ? [] : [result({ fatigue_life_h: fatigue.life_h }, "fatigue_life_h", "L", {
      formula: "2*π*N/(n_1*(1+1/u))",
      values: { N: q("N", fatigue.cycles), n_1: q("n_1", load.input_speed_rpm, "rpm"), u: q("u", mechanism.ratio) },
      note: "turnsInRadians",
    })]),
  ];
}

/** The worked steps; `input` with the ratio. */
export function steps(section, input, { materialOf, answer }) {
  const { contact, besides } = input;
  const d = diameterOf(input);
  const own = besides.pin.material;
  const material = own === undefined ? materialOf("contact.pin_material", contact.pin_material) : materialOf("pin.material", own);
  const D = q("d", d, "mm");
  const M = q("M", section.peak_moment_Nm, "N·m");
  const at = (name, symbol, rest) => result(section, name, symbol, rest);
  return [
    at("peak_force_N", "F_max", { note: "shared" }),
    at("peak_moment_position_mm", "x", { note: "section" }),
    at("peak_moment_Nm", "M", { note: "section" }),
    at("peak_bending_stress_MPa", "σ_b", { formula: "32*M/(π*d^3)", values: { M, d: D } }),
    at("peak_shear_force_N", "V", { note: "section" }),
    at("peak_shear_stress_MPa", "τ", { formula: "16*V/(3*π*d^2)", values: { V: q("V", section.peak_shear_force_N, "N"), d: D } }),
    at("peak_equivalent_stress_MPa", "σ_v", { note: "equivalent" }),
    ...(section.static_safety_factor === undefined ? [] : [staticStep(section, "static_safety_factor", "S", {
      limit: q("R_e", material.yield_strength_MPa, "MPa"), load: q("σ_v", section.peak_equivalent_stress_MPa, "MPa"), answer,
      share: input.load.peak_torque_Nm === undefined ? 1 : input.load.peak_torque_Nm / (contact.dynamic_factor * torqueOf(input)),
    })]),
    ...fatigueSteps(section.fatigue, input, d, material),
    ...(section.deflection ? Object.entries({ deflection_mm: "w", slope_mrad: "θ" }).map(([name, symbol]) =>
      result(section.deflection, name, symbol, { note: "deflected", noteValues: { satellite: section.deflection.satellite } })) : []),
  ];
}
