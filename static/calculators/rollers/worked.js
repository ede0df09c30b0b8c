/** Worked steps of the calculator of swinging rollers. No DOM, no texts. */
import { cycleSteps } from "../../lib/formula/fatigue.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { gapsOf } from "./index.js";

const SOURCE = "ovsyannikov2019";

function modulusSteps(input, E) {
  if (input.shear_modulus_GPa !== undefined) return { G: q("G", input.shear_modulus_GPa, "GPa"), steps: [] };
  const step = intermediate("shearModulus", "G", "GPa", {
    formula: "E/(2*(1+μ))", values: { E, μ: q("μ", input.poissons_ratio) }, source: SOURCE,
  });
  return { G: asValue(step), steps: [step] };
}

function complianceSteps({ l, b, D, d, k, E, G }) {
  const source = { source: SOURCE, equation: "9", erratum: "compliance" };
  return [
    intermediate("bendingCompliance", "s_M", "mm/N", {
      formula: "64*l/(π*E*d^4)*((k*D+b)*l/4+l^2/3+b*(l+k*D+b)/4)", values: { l, E, d, k, D, b }, ...source,
    }),
    intermediate("shearCompliance", "s_Q", "mm/N", {
      formula: "4*1.11/(π*G*d^2)*(l+b/2)", values: { G, d, l, b }, ...source,
    }),
  ];
}

/** Forces from a tolerance. */
function toleranceSteps(section, { n, c, F_m, tolerance }) {
  const δ = q("δ", section.relative_position_error);
  const Ψ = q("Ψ", section.load_nonuniformity);
  return [
    result(section, "relative_position_error", "δ", {
      formula: "c*χ/F_m", values: { c, χ: q("χ", tolerance, "mm"), F_m }, source: SOURCE,
    }),
    result(section, "load_nonuniformity", "Ψ", {
      formula: "min(n,1+4*(n-1)/n*δ)", values: { n, δ }, source: SOURCE, equation: "6", erratum: "single",
    }),
    result(section, "max_force_N", "F_1", { formula: "Ψ*F_m", values: { Ψ, F_m }, source: SOURCE, equation: "6" }),
  ];
}

/** Forces from a list of gaps: the contacts close one after the other. */
function gapSteps(section, { n, c, F_m, gaps, Δ }) {
  const first = Math.min(...gaps);
  return [
    result(section, "relative_position_error", "δ", {
      formula: gaps.length > 1 ? "c*sum(g_i-g_min)/(4*(n-1))/F_m" : "c*sum(g_i-g_min)/4/F_m",
      values: { c, g_i: q("g_i", gaps, "mm"), g_min: q("g_min", first, "mm"), n, F_m },
      source: SOURCE,
      equation: "6",
      note: "meanGap",
    }),
    result(section, "max_force_N", "F_1", {
      formula: "c*(Δ-g_min)", values: { c, Δ, g_min: q("g_min", first, "mm") }, source: SOURCE, equation: "5",
    }),
    result(section, "load_nonuniformity", "Ψ", {
      formula: "F_1/F_m", values: { F_1: q("F_1", section.max_force_N, "N"), F_m }, source: SOURCE, equation: "6",
    }),
  ];
}

/** The cycle at the middle sphere; the stress concentration counts once, in the stress or in the limit. */
function fatigueSteps({ fatigue: cycle, bending_stress_MPa: stress }, input) {
  if (!cycle) return [];
  const { fatigue: asked, tensile_strength_MPa: R_m, roller_rotates: rotates } = input.besides;
  const σ = q("σ", stress, "MPa");
  const σ_max = q("σ_max", cycle.max_stress_MPa, "MPa");
  return [
    result(cycle, "max_stress_MPa", "σ_max", cycle.factors
      ? { formula: "σ", values: { σ } }
      : { formula: "σ/K_σ", values: { σ, K_σ: q("K_σ", input.stress_concentration) } }),
    result(cycle, "min_stress_MPa", "σ_min", rotates ? { formula: "-σ_max", values: { σ_max } } : { note: "comesAndGoes" }),
    ...cycleSteps(cycle, {
      asked, d: input.diameter_mm, R_m, R_e: input.yield_strength_MPa, inStress: input.stress_concentration > 1,
    }),
  ];
}

function strengthSteps(section, input) {
  const E = q("E", input.youngs_modulus_GPa, "GPa");
  const sizes = {
    l: q("l", input.cylinder_length_mm, "mm"),
    b: q("b", input.sphere_width_mm, "mm"),
    D: q("D", input.sphere_diameter_mm, "mm"),
    d: q("d", input.diameter_mm, "mm"),
    k: q("k", input.friction_coefficient),
  };
  const { l, b, D, d, k } = sizes;
  const n = q("n", input.rollers);
  const { G, steps } = modulusSteps(input, E);
  const [bending, shear] = complianceSteps({ ...sizes, E, G });
  const c = q("c", section.stiffness_N_per_mm, "N/mm");
  const F_m = q("F_m", section.mean_force_N, "N");
  const F_1 = q("F_1", section.max_force_N, "N");
  const Δ = q("Δ", section.displacement_mm, "mm");
  const tolerance = input.position_tolerance_mm;
  const gaps = input.gaps_mm ?? gapsOf(input.rollers, tolerance);
  const carrying = [...gaps].sort((one, other) => one - other).slice(0, section.loaded_rollers);
  return [
    ...steps,
    bending,
    shear,
    result(section, "stiffness_N_per_mm", "c", {
      formula: "1/(s_M+s_Q)", values: { s_M: asValue(bending), s_Q: asValue(shear) }, source: SOURCE, equation: "9",
    }),
    result(section, "relative_stiffness", "c_r", {
      formula: "c/(b*E)", values: { c, b, E }, source: SOURCE, equation: "10",
    }),
    result(section, "mean_force_N", "F_m", {
      formula: "T/(2*R*n)",
      values: { T: q("T", input.output_torque_Nm, "N·m"), R: q("R", input.hole_circle_radius_mm, "mm"), n },
      source: SOURCE,
      equation: "2",
    }),
    result(section, "loaded_rollers", "m", { note: "sharing", source: SOURCE, equation: "5" }),
    result(section, "displacement_mm", "Δ", {
      formula: "(n*F_m/c+sum(g_i))/m",
      values: { n, F_m, c, g_i: q("g_i", carrying, "mm"), m: q("m", section.loaded_rollers) },
      source: SOURCE,
      equation: "5, 7",
      note: "gaps",
    }),
    ...(input.gaps_mm
      ? gapSteps(section, { n, c, F_m, gaps, Δ })
      : toleranceSteps(section, { n, c, F_m, tolerance })),
    result(section, "centre_force_N", "F_0", { formula: "2*F_1", values: { F_1 }, source: SOURCE, equation: "1, 2" }),
    result(section, "bending_moment_Nm", "M", {
      formula: "(l+b/2+k*D/2)*F_1", values: { l, b, k, D, F_1 }, source: SOURCE, equation: "3, 4",
    }),
    result(section, "bending_stress_MPa", "σ", {
      formula: "K_σ*32*M/(π*d^3)",
      values: {
        K_σ: q("K_σ", input.stress_concentration), M: q("M", section.bending_moment_Nm, "N·m"), d,
      },
      source: SOURCE,
      equation: "12",
      erratum: "compliance",
    }),
    result(section, "relative_stress", "σ_r", {
      formula: "σ/E", values: { σ: q("σ", section.bending_stress_MPa, "MPa"), E }, source: SOURCE, equation: "12",
    }),
    ...fatigueSteps(section, input),
  ];
}

/** `[{ section, steps }]` of what was answered. */
export function workedSteps({ input, answer }) {
  const section = answer.roller_strength;
  return section ? [{ section: "roller_strength", steps: strengthSteps(section, input) }] : [];
}
