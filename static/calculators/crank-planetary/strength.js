/** Strength of the pins: what is said and drawn of the service's answer, and its worked steps. No DOM. */
import { cycleSteps } from "../../lib/formula/fatigue.js";
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { pinDrawing } from "./along.js";
import { staticStep, torqueOf } from "./bearings.js";
import { beamOf, complianceSteps, once, sharingOf, sharings } from "./pin_beam.js";
import { largestOf } from "./turn.js";
import { figureBody, sleeved } from "./wanted.js";

const strengthBody = figureBody("fatigue");

export const figure = { id: "pinStrength", section: "pin_strength", path: "/pin-strength/chart", body: strengthBody };

/** The same pin in the supports between which the truth of a cage lies, asked for where it is held at both ends. */
export const bounds = {
  path: "/pin-strength",
  list: "support_bounds",
  of: ({ pin_strength: strength }, { besides }) => strength && besides?.pin?.span_mm !== undefined,
  body(input, answer, requests) {
    const { fatigue, ...body } = strengthBody(input, answer, requests);
    const life = fatigue && { fatigue: { life_h: input.requirements.life_h, ...fatigue } };
    return { ...body, ...life, include: ["support_bounds", "deflection"] };
  },
  shown: [
    "peak_bending_stress_MPa", "peak_equivalent_stress_MPa", "static_safety_factor", "fatigue_safety_factor", "deflection_mm", "slope_mrad",
  ],
  nameOf: ({ support }) => message("option")[support],
};

/** Diameter of the steel pin: that inside its sleeve where it has one. */
export const diameterOf = (input) => (sleeved(input) ? input.besides.pin.diameter_mm : 2 * input.contact.pin_radius_mm);

export function cells({ peak_equivalent_stress_MPa: stress, static_safety_factor: yields, fatigue, deflection }) {
  const title = (name) => message(`quantity.${name}`).title;
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
      note: message("strength.slope", {
        satellite: deflection.satellite, sloping: deflection.slope_satellite, slope: formatQuantity(deflection.slope_mrad, "mrad", 3),
      }),
    },
  ].filter(Boolean);
}

export const drawing = { create: pinDrawing, section: "pin_strength" };

const KPSI = 6.894757293168361;

/** The strength for the cycles of the life, where these are so few that it is above the endurance limit. */
function finiteSteps(fatigue, { load, mechanism, requirements, besides }, R_m) {
  if (fatigue.finite_strength_MPa === undefined) return [];
  const cycles = intermediate("lifeCycles", "N_L", "", {
    formula: "max(1000;n_1*(1+1/u)*L/(2*π))",
    values: { n_1: q("n_1", load.input_speed_rpm, "rpm"), u: q("u", mechanism.ratio), L: q("L", besides.fatigue.life_h ?? requirements.life_h, "h") },
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
  const at = (name, symbol) => result(fatigue, name, symbol, { note: "worstCycle" });
  return [
    at("position_mm", "x"),
    ...(fatigue.direction_deg === undefined ? [] : [at("direction_deg", "χ")]),
    at("max_stress_MPa", "σ_max"),
    at("min_stress_MPa", "σ_min"),
    ...cycleSteps(fatigue, { asked: besides.fatigue, d, R_m, R_e, finite: finiteSteps(fatigue, input, R_m) }),
    ...(fatigue.life_h === undefined ? [] : [result({ fatigue_life_h: fatigue.life_h }, "fatigue_life_h", "L", {
      formula: "2*π*N/(n_1*(1+1/u))",
      values: { N: q("N", fatigue.cycles), n_1: q("n_1", load.input_speed_rpm, "rpm"), u: q("u", mechanism.ratio) },
      note: "turnsInRadians",
    })]),
  ];
}

/** Deflection and slope in the middle of satellites, each where it is largest, by unit forces of those that load the pin there. */
function deflectionSteps({ deflection }, input, context) {
  if (!deflection) return [];
  const found = { deflection_mm: ["w", deflection.satellite], slope_mrad: ["θ", deflection.slope_satellite] };
  const shared = sharings(input, context);
  if (!shared) {
    return Object.entries(found).map(([name, [symbol, satellite]]) => result(deflection, name, symbol, { note: "deflected", noteValues: { satellite } }));
  }
  const { load, contact } = input;
  const beam = beamOf(input, context.materialOf);
  const loading = ({ pairs }, n) => pairs.filter(({ pin }) => pin === n);
  const sizeOf = (unit, part) => {
    const onPin = (position, n) => Math.hypot(...["cos", "sin"].map((way) => loading(position, n).reduce((sum, { satellite: j, force, angle }) =>
      sum + unit[j][part].value * force * Math[way]((angle * Math.PI) / 180), 0)));
    const pinsOf = ({ pairs }) => [...new Set(pairs.map(({ pin }) => pin))];
    return { onPin, most: (position) => Math.max(...pinsOf(position).map((n) => onPin(position, n))), pinsOf };
  };
  const partSteps = (name, part) => {
    const at = found[name][1] - 1;
    const unit = beam.planes.map((_, j) => complianceSteps(beam, at, j));
    const { onPin, most, pinsOf } = sizeOf(unit, part);
    const peak = largestOf(shared.turns, most);
    const n = pinsOf(peak.position).reduce((worst, one) => (onPin(peak.position, one) > onPin(peak.position, worst) ? one : worst));
    const pairs = loading(peak.position, n);
    const forces = pairs.map(({ satellite: j, angle }) => {
      const { own, once: cosine, support, values, said } = sharingOf(peak, load, j);
      return intermediate("pinForce", `F_${j + 1}`, "N", {
        formula: `K_A*T/R*${own}${cosine("γ_p")}/${support}`,
        values: {
          ...values, K_A: q("K_A", contact.dynamic_factor), T: q("T", torqueOf(input), "N·m"), R: q("R", load.pin_circle_radius_mm, "mm"), γ_p: q("γ_p", angle, "°"),
        },
        ...said,
      });
    });
    const [c, F, γ] = [pairs.map(({ satellite: j }) => unit[j][part].value), forces.map(({ value }) => value), pairs.map(({ angle }) => angle)];
    const { symbol, unit: per } = unit[at][part];
    const letter = symbol.split("_")[0];
    return [
      ...pairs.flatMap(({ satellite: j }) => [...unit[j].steps, unit[j][part]]),
      ...forces,
      result(deflection, name, found[name][0], pairs.length === 1
        ? { formula: "abs(c)*F", values: { c: asValue(unit[pairs[0].satellite][part]), F: asValue(forces[0]) } }
        : {
          formula: "sqrt(sum(c_i*F_i*cos(γ_i))^2+sum(c_i*F_i*sin(γ_i))^2)",
          values: { c_i: q(`${letter}_i`, c, per), F_i: q("F_i", F, "N"), γ_i: q("γ_i", γ, "°") },
        }),
    ];
  };
  return once([...shared.steps, ...partSteps("deflection_mm", "deflection"), ...partSteps("slope_mrad", "slope")]);
}

/** The worked steps; `input` with the ratio. */
export function steps(section, input, context) {
  const { materialOf, answer } = context;
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
    ...deflectionSteps(section, input, context),
  ];
}
