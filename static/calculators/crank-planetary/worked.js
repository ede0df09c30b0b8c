/** Worked steps of the crank-planetary calculator. No DOM, no texts. */
import { definition, quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { pressedBy } from "./index.js";
import { cranksOf, eccentricityOf, ratioOf } from "./mechanism.js";
import { WANTED } from "./wanted.js";

const HALF_TURN = q("180°", 180, "°");
const TURN = q("360°", 360, "°");
const COSINE_ROUNDING = 1e-12;
const MOST_SATELLITES = 6; // whose assembly angle is worked
const SHEAR_DEPTH = Math.sqrt((Math.sqrt(5) - 1) / 2);
const SHEAR_RATIO = SHEAR_DEPTH * (1 - SHEAR_DEPTH ** 2);

const radians = (degrees) => (degrees * Math.PI) / 180;

/** The mechanism's numbers with what follows from them: ratio, crank angles. */
function mechanismOf(mechanism) {
  return { ...mechanism, ratio: ratioOf(mechanism), angles: cranksOf(mechanism) };
}

/** Phases of all pairs against the first, in degrees of the wave, ascending in a turn. */
function phases({ pins, angles }) {
  return angles.flatMap((angle) => Array.from({ length: pins }, (_, n) => (angle + (360 * n) / pins) % 360))
    .map((phase) => (phase + 360) % 360).sort((a, b) => a - b);
}

function largestGap(mechanism) {
  const all = phases(mechanism);
  return Math.max(...all.map((phase, i) => (i ? phase - all[i - 1] : phase + 360 - all.at(-1))));
}

/** Pressure angles within ±180° of these phases at a wave angle, of those that drive. */
function drivingAngles(all, wave) {
  return all.map((phase) => {
    const angle = (((90 + wave + phase) % 360) + 360) % 360;
    return angle > 180 ? angle - 360 : angle;
  }).filter((angle) => Math.cos(radians(angle)) > COSINE_ROUNDING);
}

/** The pressure angles of the driving pairs where their cosines add up to least. */
function leastSupport(mechanism) {
  const all = phases(mechanism);
  const sum = (angles) => angles.reduce((total, angle) => total + Math.cos(radians(angle)), 0);
  const { pins, angles: cranks } = mechanism;
  return cranks.flatMap((crank) => [-crank, 180 - crank]) // where a pair starts or stops driving; all repeats from pin to pin
    .map((wave) => ((wave % (360 / pins)) + 360 / pins) % (360 / pins))
    .map((wave) => drivingAngles(all, wave))
    .reduce((least, angles) => (sum(angles) < sum(least) * (1 - COSINE_ROUNDING) ? angles : least));
}

function ratioSteps({ satellite_teeth: z_2, ring_teeth: z_3 }) {
  if (!z_2 || !z_3) return [];
  return [intermediate("ratio", "u", "", {
    formula: "z_2/(z_3-z_2)",
    values: { z_2: q("z_2", z_2), z_3: q("z_3", z_3) },
    source: "yanchevsky2018",
  })];
}

function assemblySteps(section, mechanism) {
  return (section.assembly ?? []).slice(1, MOST_SATELLITES).map((one) => {
    const { satellite } = one;
    const turned = (mechanism.angles[satellite - 1] - mechanism.angles[0]) / mechanism.ratio;
    return result(one, "hole_rotation_deg", `ψ_${satellite}`, {
      formula: "abs((α_j-α_1)/u-k*t/z_2)",
      values: {
        α_j: q(`α_${satellite}`, mechanism.angles[satellite - 1], "°"),
        α_1: q("α_1", mechanism.angles[0], "°"),
        u: q("u", mechanism.ratio),
        k: q("k", Math.round(turned / (360 / mechanism.satellite_teeth))),
        z_2: q("z_2", mechanism.satellite_teeth),
        t: TURN,
      },
      source: "yanchevskiy2021",
      equation: "11",
      after: true,
      erratum: "assembly",
    });
  });
}

function cyclogramSteps(section, mechanism) {
  const u = q("u", mechanism.ratio);
  const N = q("N", mechanism.pins);
  const repeats = Math.round(section.period_deg / section.pattern_period_deg / mechanism.pins);
  const source = { source: "yanchevskiy2021", equation: "6" };
  const gap = { gap: [largestGap(mechanism), "°"] };
  const counted = { ...source, note: "counted", noteValues: gap };
  return [
    ...ratioSteps(mechanism),
    result(section, "working_phase_deg", "φ_w", {
      formula: "h/(1+1/u)", values: { h: HALF_TURN, u }, ...source, note: "working",
    }),
    result(section, "period_deg", "φ_T", { formula: "t/(1+1/u)", values: { t: TURN, u }, ...source }),
    result(section, "pattern_period_deg", "φ_P", {
      formula: "φ_T/(N*m)",
      values: { φ_T: q("φ_T", section.period_deg, "°"), N, m: q("m", repeats) },
      note: "repeats",
    }),
    result(section, "min_driving", "n_min", counted),
    result(section, "max_driving", "n_max", counted),
    result(section, "mean_driving", "n_m", {
      formula: "K*N/2", values: { K: q("K", mechanism.satellites), N }, note: "half",
    }),
    ...assemblySteps(section, mechanism),
  ];
}

function torqueSteps(load, mechanism) {
  if (load.output_torque_Nm !== undefined) return { T: q("T", load.output_torque_Nm, "N·m"), steps: [] };
  const step = intermediate("torque", "T", "N·m", {
    formula: "T_in*u*η",
    values: {
      T_in: q("T_in", load.input_torque_Nm, "N·m"),
      u: q("u", mechanism.ratio),
      η: q("η", load.efficiency),
    },
    source: "yanchevskiy2021",
  });
  return { T: asValue(step), steps: [step] };
}

function forceSteps(section, mechanism, load) {
  const { T, steps } = torqueSteps(load, mechanism);
  const { force_exponent: exponent } = load;
  const F_0 = q("F_0", section.reference_force_N, "N");
  const F = q("F", section.peak_force_N, "N");
  const N = q("N", mechanism.pins);
  const K = q("K", mechanism.satellites);
  const u = q("u", mechanism.ratio);
  const { satellite, pin } = section.peak_pair;
  const start = mechanism.initial_crank_angle_deg + (load.torque_direction === "reverse" ? 180 : 0); // those carry that would brake
  const wave = section.peak_crank_angle_deg * (1 + 1 / mechanism.ratio) + start;
  const driving = drivingAngles(phases(mechanism), wave);
  const angle = intermediate("pressureAngle", "γ_p", "°", {
    formula: "φ*(1+1/u)+φ_0+α_j+t*(n-1)/N+r-k*t",
    values: {
      φ: q("φ", section.peak_crank_angle_deg, "°"),
      u,
      φ_0: q("φ_0", start, "°"),
      α_j: q(`α_${satellite}`, mechanism.angles[satellite - 1], "°"),
      n: q("n", pin),
      N,
      t: TURN,
      r: q("90°", 90, "°"),
      k: q("k", Math.round((wave + mechanism.angles[satellite - 1] + (360 * (pin - 1)) / mechanism.pins + 90) / 360)),
    },
    source: "yanchevskiy2021",
    equation: "6",
    note: "pressureAngle",
    noteValues: { satellite, pin },
  });
  const v = q("v", exponent);
  const found = [
    ...steps,
    result(section, "reference_force_N", "F_0", {
      formula: "T/R",
      values: { T, R: q("R", load.pin_circle_radius_mm, "mm") },
      source: "yanchevskiy2021",
      equation: "11",
    }),
    result(section, "peak_crank_angle_deg", "φ", { note: "search", method: true }),
    angle,
    result(section, "peak_force_N", "F", {
      formula: exponent === 1 ? "F_0*cos(γ_p)/sum(cos(γ_i)^2)" : exponent === 0
        ? "F_0/sum(cos(γ_i))" : "F_0*cos(γ_p)^v/sum(cos(γ_i)^(1+v))",
      values: { F_0, γ_p: asValue(angle), γ_i: q("γ_i", driving, "°"), v },
      ...(exponent === 1 ? { source: "yanchevsky2018", equation: "4", erratum: "arcsin" } : exponent === 0
        ? { source: "zyl", equation: "1" } : { source: "yanchevskiy2021", equation: "10" }),
      note: "driving",
      noteValues: { count: driving.length },
    }),
    result(section, "peak_force_ratio", "f", {
      formula: "F/F_0", values: { F, F_0 }, source: "yanchevskiy2021", equation: "11", erratum: "below1",
    }),
  ];
  if (section.equal_sharing_peak_N !== undefined) {
    found.push(result(section, "equal_sharing_peak_N", "F_e", {
      formula: "F_0/sum(cos(γ_i))",
      values: { F_0, γ_i: q("γ_i", leastSupport(mechanism), "°") },
      source: "zyl",
      equation: "1",
      erratum: "zyl",
      note: "leastSupport",
    }));
  }
  if (section.approximate_peak_N !== undefined) {
    found.push(
      result(section, "approximate_peak_N", "F_a", {
        formula: "(0.8+0.05*N)^(2-K)*4*F_0/(K*N)",
        values: { N, K, F_0 },
        source: "yanchevsky2018",
        equation: "5",
        erratum: "approximation",
      }),
      result(section, "approximate_peak_error", "ε_a", {
        formula: "F_a/F-1", values: { F_a: q("F_a", section.approximate_peak_N, "N"), F },
      }),
    );
  }
  return found;
}

function hertzSteps(section, { contact, force, edge }, materialOf, turning) {
  const pin = materialOf("contact.pin_material", contact.pin_material);
  const hole = materialOf("contact.hole_material", contact.hole_material);
  const F = q("F", force, "N");
  const b = q("b", contact.contact_length_mm, "mm");
  const r = q("r_in", contact.pin_radius_mm, "mm");
  const R = q("r_out", contact.hole_radius_mm, "mm");
  const load = intermediate("lineLoad", "w", "N/mm", {
    formula: edge === 1 ? "F/b*K_A*K_α" : "F/b*K_A*K_α*K_b",
    values: {
      F, b, K_A: q("K_A", contact.dynamic_factor), K_α: q("K_α", contact.distribution_factor), ...(edge !== 1 && { K_b: q("K_b", edge) }),
    },
    source: "yanchevsky2018",
    equation: "2",
  });
  const w = asValue(load);
  const E = q("E*", section.effective_modulus_GPa, "GPa");
  const ρ = q("ρ", section.reduced_radius_mm, "mm");
  const p = q("p_0", section.max_pressure_MPa, "MPa");
  const a = q("a", section.half_width_mm, "mm");
  const elastic = {
    E_1: q("E_1", pin.youngs_modulus_GPa, "GPa"),
    E_2: q("E_2", hole.youngs_modulus_GPa, "GPa"),
    ν_1: q("ν_1", pin.poissons_ratio),
    ν_2: q("ν_2", hole.poissons_ratio),
  };
  const paper = { source: "yanchevsky2018", equation: "2" };
  const johnson = { source: "johnson" };
  const found = [
    ...(edge === 1 ? [] : [result(section, "line_load_factor", "K_b", { note: "edge" })]),
    load,
    result(section, "reduced_radius_mm", "ρ", {
      formula: "r_out*r_in/(r_out-r_in)", values: { r_out: R, r_in: r }, ...paper,
    }),
    result(section, "effective_modulus_GPa", "E*", {
      formula: "1/((1-ν_1^2)/E_1+(1-ν_2^2)/E_2)", values: elastic, ...paper,
    }),
    result(section, "max_pressure_MPa", "p_0", { formula: "sqrt(w*E/(π*ρ))", values: { w, E, ρ }, ...paper }),
    result(section, "mean_pressure_MPa", "p_m", { formula: "π/4*p_0", values: { p_0: p }, ...johnson }),
    result(section, "half_width_mm", "a", { formula: "sqrt(4*w*ρ/(π*E))", values: { w, ρ, E }, ...johnson }),
    result(section, "half_width_ratio", "a/r", { formula: "a/r_in", values: { a, r_in: r }, note: "narrow" }),
    result(section, "max_shear_MPa", "τ", {
      formula: "k_τ*p_0", values: { k_τ: q("k_τ", SHEAR_RATIO), p_0: p }, ...johnson,
    }),
    result(section, "max_shear_depth_mm", "z", {
      formula: "k_z*a", values: { k_z: q("k_z", SHEAR_DEPTH), a }, ...johnson,
    }),
  ];
  const conformal = section.conformal_pressure_MPa;
  if (conformal !== undefined) found.push(...conformalSteps(section, { w, r, R, ...elastic }));
  found.push(...safetySteps(section, conformal === undefined ? p : q("p_c", conformal, "MPa"), turning));
  return found;
}

/** How the limit of a body falls over the life, where that is known. */
function lifeSteps({ life }, index, { speed, life_h: hours, ratio }) {
  if (!life) return [];
  const loads = intermediate("loads", "N_L", "", {
    formula: "n_1*(1+1/u)*L/(2*π)",
    values: { n_1: q("n_1", speed, "rpm"), u: q("u", ratio), L: q("L", hours, "h") },
    note: "turnsOverLife",
  });
  return [loads, {
    ...intermediate("lifeFactor", `Z_NT${index}`, "", {
      formula: "min(Z_m;(N_k/N_L)^m)",
      values: { Z_m: q("Z_m", life.largest_factor), N_k: q("N_k", life.knee_loads), N_L: asValue(loads), m: q("m", life.exponent) },
      source: "iso6336", note: "lifeOfTeeth",
    }),
    value: life.factor,
  }];
}

/** Each body with a limit by this, under the pressure that governs; the smaller where both have one. */
function safetySteps(section, pressure, turning) {
  const { governing_pressure_MPa: governing, safety = [], conformal_pressure_MPa: conformal } = section;
  if (governing === undefined) return [];
  const found = [result(section, "governing_pressure_MPa", "p_g", {
    formula: "p",
    values: { p: pressure },
    ...(conformal === undefined ? { note: "governsHertz" } : { note: "governsConformal" }),
  })];
  const p_g = q("p_g", governing, "MPa");
  for (const one of safety) {
    const { body, limit_MPa: limit, criterion, source_code: source, safety_factor: value, life } = one;
    const index = body === "pin" ? 1 : 2;
    found.push(...lifeSteps(one, index, turning), result(section, `safety_${body}`, `S_${index}`, {
      value,
      formula: life ? "p_P*Z_NT/p_g" : "p_P/p_g",
      values: { p_P: q(`p_P${index}`, limit, "MPa"), p_g, ...(life && { Z_NT: q(`Z_NT${index}`, life.factor) }) },
      ...(source ? { note: "limit", noteValues: { criterion, source } } : { note: "limitGiven" }),
    }));
  }
  if (section.safety_factor !== undefined) {
    const [S_1, S_2] = safety.map(({ safety_factor: factor }, i) => q(`S_${i + 1}`, factor));
    found.push(result(section, "safety_factor", "S", { formula: "min(S_1;S_2)", values: { S_1, S_2 }, note: "smaller" }));
  }
  return found;
}

/** Persson's contact of bodies of one material: its angle is the root of an equation. */
function conformalSteps(section, { w, r, R, E_1, ν_1 }) {
  const ε = q("ε", section.conformal_half_angle_deg, "°");
  const b = definition("b", "sin(ε/2)/cos(ε/2)");
  const source = { source: "persson" };
  const left = intermediate("conformalLeft", "λ", "", {
    formula: "E_1/(1-ν_1^2)*(r_out-r_in)/w", values: { E_1, ν_1, r_out: R, r_in: r, w }, ...source,
  });
  return [
    left,
    result(section, "conformal_half_angle_deg", "ε", { ...source, note: "conformalAngle" }),
    {
      ...intermediate("conformalRight", "λ", "", {
        formula: "(2-ln(1+b^2)-2*b^4)/(π*b^2*(1+b^2))", values: { b, ε }, ...source, note: "conformalTangent",
      }),
      value: left.value,
    },
    result(section, "conformal_pressure_MPa", "p_c", {
      formula: "w/sqrt(r_out*r_in)*(2*b/(π*sqrt(1+b^2))+ln((sqrt(1+b^2)+b)/(sqrt(1+b^2)-b))/(2*π*b^2*(1+b^2)))",
      values: { w, r_out: R, r_in: r, b, ε },
      ...source,
      note: "conformalTangent",
    }),
  ];
}

function geometrySteps(section, contact) {
  return [result(section, "clearance_mm", "c", {
    formula: "r_out-r_in-e",
    values: {
      r_out: q("r_out", contact.hole_radius_mm, "mm"),
      r_in: q("r_in", contact.pin_radius_mm, "mm"),
      e: q("e", eccentricityOf(contact), "mm"),
    },
    source: "yanchevskiy2021",
    erratum: "intersection",
  })];
}

/** `[{ section, steps }]` of what was answered; `materialOf(path, name or values)` gives values, `more` are the steps of wanted groups by their ids. */
export function workedSteps({ input, answer, materialOf, more = {} }) {
  const mechanism = mechanismOf(input.mechanism);
  const { cyclogram, contact_force: force, hertz, geometry } = answer;
  const pressed = hertz && pressedBy(input.contact, answer);
  const turning = { speed: input.load?.input_speed_rpm, life_h: input.requirements?.life_h, ratio: mechanism.ratio };
  return [
    cyclogram && { section: "cyclogram", steps: cyclogramSteps(cyclogram, mechanism) },
    force && { section: "contact_force", steps: forceSteps(force, mechanism, input.load) },
    hertz && { section: "hertz", steps: hertzSteps(hertz, pressed, materialOf, turning) },
    geometry && { section: "geometry", steps: geometrySteps(geometry, input.contact) },
    ...WANTED.map(({ id, section }) => answer[section] && more[id] && {
      section, steps: more[id](answer[section], { ...input, mechanism }, { materialOf, answer }),
    }),
  ].filter(Boolean);
}
