/** Worked steps of a stress cycle: what the endurance limit is made of, and the safety factor. */
import { quantity as q } from "./evaluate.js";
import { intermediate, result } from "./step.js";

const SURFACES = { // a and b of a·R_m^b, by edition of Shigley
  shigley_9: { ground: [1.58, -0.085], machined: [4.51, -0.265], hot_rolled: [57.7, -0.718], forged: [272, -0.995] },
  shigley_11: { ground: [1.38, -0.067], machined: [3.04, -0.217], hot_rolled: [38.6, -0.65], forged: [54.9, -0.758] },
};

function factorSteps({ factors, ...own }, { asked, d, R_m, inStress }) {
  if (!factors) return [];
  const strength = q("R_m", R_m); // the fits take its number in MPa
  const shigley = { source: "shigley" };
  const [a, b] = SURFACES[asked.edition ?? "shigley_11"][asked.surface] ?? [];
  const [c, k] = d > 51 ? [1.51, -0.157] : [1.24, -0.107];
  const of = (name, symbol, rest) => result({ [name]: factors[name] }, name, symbol, rest);
  const { theoretical_factor: K_t, radius_mm: radius } = asked.notch ?? {};
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
    } : { ...(inStress ? { note: "inStress" } : { note: "given" }) }),
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

/**
 * Of `cycle` in the answer; `asked` is what it is judged by, `inStress` whether the stress has the notch in it
 * already, `finite` the steps of the strength over a life that is short.
 */
export function cycleSteps(cycle, { asked = {}, d, R_m, R_e, inStress, finite = [] }) {
  const at = (name, symbol, rest) => result(cycle, name, symbol, rest);
  const ends = { σ_max: q("σ_max", cycle.max_stress_MPa, "MPa"), σ_min: q("σ_min", cycle.min_stress_MPa, "MPa") };
  const criterion = asked.criterion ?? "goodman";
  const { endurance_limit_MPa: endless, finite_strength_MPa: short } = cycle;
  const lasting = short === undefined ? q("S_e", endless, "MPa") : q("S_f", short, "MPa");
  return [
    at("amplitude_MPa", "σ_a", { formula: "(σ_max-σ_min)/2", values: ends }),
    at("mean_MPa", "σ_m", { formula: "(σ_max+σ_min)/2", values: ends }),
    ...factorSteps(cycle, { asked, d, R_m, inStress }),
    ...(cycle.factors ? [] : [at("endurance_limit_MPa", "S_e", { note: "given" })]),
    ...finite,
    result({ fatigue_safety_factor: cycle.safety_factor }, "fatigue_safety_factor", "n", ["goodman", "soderberg"].includes(criterion) ? {
      formula: `1/(σ_a/${lasting.symbol}+max(σ_m;0)/R)`,
      values: {
        σ_a: q("σ_a", cycle.amplitude_MPa, "MPa"), σ_m: q("σ_m", cycle.mean_MPa, "MPa"),
        [lasting.symbol]: lasting, R: criterion === "soderberg" ? q("R_e", R_e, "MPa") : q("R_m", R_m, "MPa"),
      },
      source: "shigley",
    } : { note: "criterion" }),
    ...(cycle.cycles === undefined ? [] : [at("cycles", "N", { note: "finiteLife" })]),
  ];
}
