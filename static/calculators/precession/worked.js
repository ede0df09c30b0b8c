/** Worked steps of the calculator of the precessional gear. No DOM, no texts. */
import { cycleSteps } from "../../lib/formula/fatigue.js";
import { definition, quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";

const SOURCE = "khatetovsky2020";
// The unrolled line's length per length of axis, and the directions of the load over its arm.
const STRETCH = "sqrt(1+(ρ*A*sin(φ_1)/(A^2+2*A*z*cos(φ_1)+z^2))^2)";

function scaleStep(input) {
  return intermediate("scale", "A", "mm", {
    formula: "R_C*(cos(θ)-u_12)/sin(θ)",
    values: {
      R_C: q("R_C", input.roller_circle_radius_mm, "mm"),
      θ: q("θ", input.nutation_angle_deg, "°"),
      u_12: q("u_12", input.ratio_u12),
    },
    source: SOURCE,
    equation: "1",
  });
}

/** Values of all lines, for sums over them. */
function lineValues(input, lines, A) {
  return {
    A,
    ρ: q("ρ", input.roller_radius_mm, "mm"),
    φ_1: q("φ_1,i", lines.map((line) => line.position_angle_deg), "°"),
    z_a: q("z_a,i", lines.map((line) => line.z_min_mm), "mm"),
    z_b: q("z_b,i", lines.map((line) => line.z_max_mm), "mm"),
    f: definition("s′_i", STRETCH),
    y: definition("y_i", "z+A*cos(φ_1)"),
  };
}

/** The first roller's line worked: the others go the same way. */
function firstLine(input, line, A) {
  const φ_1 = q("φ_1", line.position_angle_deg, "°");
  const given = (input.rollers ?? [input.wheel])[0];
  const byAngle = given.phi_min_deg !== undefined;
  const values = { A, ρ: q("ρ", input.roller_radius_mm, "mm"), φ_1 };
  const ends = byAngle
    ? endsByAngle(line, values)
    : endsByLength(line, values);
  return [
    ...ends,
    result(line, "length_mm", "s_1", {
      formula: `integral(${STRETCH};z;z_a;z_b)`,
      values: { ...values, z_a: q("z_a", line.z_min_mm, "mm"), z_b: q("z_b", line.z_max_mm, "mm") },
      source: SOURCE,
      equation: "4, 5",
      erratum: "slope",
      note: "quadrature",
      method: true,
    }),
  ];
}

function endsByLength(line, { A, φ_1 }) {
  // Half-turns between the branch of the arctangent and the flank that carries.
  return [["phi_min_deg", "φ_min"], ["phi_max_deg", "φ_max"]].map(([name, symbol]) => {
    const z = [line.z_min_mm, line.z_max_mm].find((end) => lies(end, line[name], A.value, φ_1.value)) ?? line.z_min_mm;
    const angle = (Math.atan((-z * sine(φ_1.value)) / (A.value + z * cosine(φ_1.value))) * 180) / Math.PI;
    return result(line, name, symbol, {
      formula: "atan(-z*sin(φ_1)/(A+z*cos(φ_1)))+k*h",
      values: {
        z: q("z", z, "mm"), φ_1, A, k: q("k", Math.round((line[name] - angle) / 180)), h: q("180°", 180, "°"),
      },
      source: SOURCE,
      equation: "1",
      note: "flank",
    });
  });
}

const sine = (degrees) => Math.sin((degrees * Math.PI) / 180);
const cosine = (degrees) => Math.cos((degrees * Math.PI) / 180);

/** Whether the contact point at z has this polar angle, up to half-turns. */
function lies(z, phi, scale, position) {
  const angle = (Math.atan((-z * sine(position)) / (scale + z * cosine(position))) * 180) / Math.PI;
  return Math.abs(sine(phi - angle)) < 1e-9;
}

function endsByAngle(line, { A, φ_1 }) {
  return [["z_min_mm", "z_a"], ["z_max_mm", "z_b"]].map(([name, symbol]) => {
    const at = (phi) => (-A.value * sine(phi)) / sine(phi + φ_1.value);
    const phi = [line.phi_min_deg, line.phi_max_deg]
      .reduce((one, other) => (Math.abs(at(other) - line[name]) < Math.abs(at(one) - line[name]) ? other : one));
    return result(line, name, symbol, {
      formula: "-A*sin(φ)/sin(φ+φ_1)", values: { A, φ: q("φ", phi, "°"), φ_1 }, source: SOURCE, equation: "1",
    });
  });
}

function lineSteps(section, input) {
  const scale = scaleStep(input);
  const { lines } = section;
  return [
    scale,
    ...firstLine(input, lines[0], asValue(scale)),
    result(section, "total_length_mm", "S", {
      formula: "sum(s_i)",
      values: { s_i: q("s_i", lines.map((line) => line.length_mm), "mm") },
      source: SOURCE,
      equation: "8",
      note: "others",
    }),
  ];
}

function loadSteps(section, { lines }, input) {
  const scale = scaleStep(input);
  const [Fx, Fy] = section.force_N;
  const [Mx, My, Mz] = section.moment_Nm;
  const M_1 = q("M_1", input.torque_Nm, "N·m");
  const S = q("S", section.total_length_mm, "mm");
  const R_C = q("R_C", input.roller_circle_radius_mm, "mm");
  const l = q("l", input.reference_z_mm, "mm");
  const full = intermediate("fullArm", "q_C", "N/mm", {
    formula: "M_1/(S*R_C)", values: { M_1, S, R_C }, source: SOURCE, equation: "8",
  });
  const sum = (term, lever) => ({
    formula: `q_C*sum(integral(${term};z;z_a;z_b))`,
    values: { q_C: asValue(full), ...lineValues(input, lines, asValue(scale)), ...(lever && { l }) },
    source: SOURCE,
    erratum: "normal",
    note: "stretch",
  });
  const along = "A/z*f";
  const across = "y/(z*sin(φ_1))*f";
  const least = lines.flatMap((line) => [line.phi_min_deg, line.phi_max_deg])
    .reduce((one, other) => (Math.abs(sine(other)) < Math.abs(sine(one)) ? other : one));
  return [
    full,
    result(section, "force_N", "F_x", { value: Fx, ...sum(along), equation: "12" }),
    result(section, "force_N", "F_y", { value: Fy, ...sum(`-${across}`), equation: "13" }),
    result(section, "force_N", "F_z", { value: section.force_N[2], note: "noAxial", source: SOURCE, equation: "14" }),
    result(section, "moment_Nm", "M_Cx", { value: Mx, ...sum(`${across}*(z-l)`, true), equation: "15" }),
    result(section, "moment_Nm", "M_Cy", { value: My, ...sum(`${along}*(z-l)`, true), equation: "16" }),
    result(section, "moment_Nm", "M_Cz", { value: Mz, formula: "M_1", values: { M_1 }, source: SOURCE, equation: "17" }),
    result(section, "max_line_load_N_per_mm", "q", {
      formula: "abs(M_1)/(S*R_C*abs(sin(φ)))",
      values: { M_1, S, R_C, φ: q("φ", least, "°") },
      source: SOURCE,
      equation: "8",
      note: "leastArm",
    }),
  ];
}

/** The shaft's stretches of one diameter from C on, cut at B. */
function pieces(input) {
  const a = input.bearing_distance_mm;
  const sections = input.shaft_sections
    ?? [{ length_mm: a + input.overhang_mm, diameter_mm: input.shaft_diameter_mm }];
  const found = [];
  let at = 0;
  for (const { length_mm: length, diameter_mm: diameter } of sections) {
    const end = at + length;
    if (at < a && end > a * (1 + 1e-12)) found.push([at, a, diameter], [a, end, diameter]);
    else found.push([at, end, diameter]);
    at = end;
  }
  return found.map(([from, to, d]) => ({ from, to, d, loaded: from >= a * (1 - 1e-9) }));
}

/** Mohr's integrals of one diameter in closed form, or summed over the stretches. */
const ONE_DIAMETER = {
  B: "-64/(π*E*d^4)*(C_i*(b^3/3+a*b^2/2)+B_i*b^3/3)",
  C: "-64/(π*E*d^4)*(C_i*(a+b)^3/3+B_i*(b^3/3+a*b^2/2))",
};
const STEPPED = {
  B: "-64/(π*E)*sum((C_i*((t^3-s^3)/3-a*(t^2-s^2)/2)+B_i*((t-a)^3-(s-a)^3)/3)/d^4)",
  C: "-64/(π*E)*(C_i*sum((v^3-u^3)/(3*h^4))+B_i*sum(((t^3-s^3)/3-a*(t^2-s^2)/2)/d^4))",
};

function shaftValues(input, stepped) {
  const common = {
    E: q("E", input.youngs_modulus_GPa, "GPa"),
    a: q("a", input.bearing_distance_mm, "mm"),
    b: q("b", input.overhang_mm, "mm"),
  };
  const all = pieces(input);
  if (!stepped) return { ...common, d: q("d", Math.min(...all.map(({ d }) => d)), "mm") };
  const loaded = all.filter((piece) => piece.loaded);
  const list = (symbol, some, name) => q(symbol, some.map((piece) => piece[name]), "mm");
  return {
    ...common,
    u: list("s_i", all, "from"), v: list("t_i", all, "to"), h: list("d_i", all, "d"),
    s: list("s_i", loaded, "from"), t: list("t_i", loaded, "to"), d: list("d_i", loaded, "d"),
  };
}

function deflectionSteps(section, input, at, { simplified = false } = {}) {
  const stepped = !simplified && new Set(pieces(input).map(({ d }) => d)).size > 1;
  const name = `${simplified ? "simplified_" : ""}deflection_${at}_mm`;
  const deflection = section[name];
  const shared = shaftValues(input, stepped);
  const prime = simplified ? "′" : "";
  const parts = ["x", "y"].map((axis, i) => result(section, name, `${axis}${prime}_${at}`, {
    value: deflection[axis],
    formula: (stepped ? STEPPED : ONE_DIAMETER)[at],
    values: {
      ...shared,
      B_i: q(`B_${axis}`, section.reaction_B_N[i], "N"),
      C_i: q(`C_${axis}`, section.reaction_C_N[i], "N"),
    },
    source: SOURCE,
    equation: axis === "x" ? "35, 36" : "33, 34",
    erratum: "mohr",
    ...(stepped ? { note: "stretches" } : simplified && { note: "smallest" }),
  }));
  return [...parts, result(section, name, `Δ${prime}_${at}`, {
    value: deflection.total,
    formula: "sqrt(x^2+y^2)",
    values: { x: asValue(parts[0]), y: asValue(parts[1]) },
    source: SOURCE,
    equation: "32",
  })];
}

function shaftSteps(section, load, input) {
  const a = q("a", input.bearing_distance_mm, "mm");
  const [Fx, Fy] = load.force_N;
  const [Mx, My] = load.moment_Nm;
  const [Bx, By] = section.reaction_B_N;
  const [Cx, Cy] = section.reaction_C_N;
  const source = { source: SOURCE };
  const found = [
    result(section, "reaction_B_N", "B_x", {
      value: Bx, formula: "-M_Cy/a", values: { M_Cy: q("M_Cy", My, "N·m"), a }, ...source, equation: "30",
    }),
    result(section, "reaction_B_N", "B_y", {
      value: By, formula: "M_Cx/a", values: { M_Cx: q("M_Cx", Mx, "N·m"), a }, ...source, equation: "31",
    }),
    result(section, "reaction_C_N", "C_x", {
      value: Cx, formula: "-F_x-B_x", values: { F_x: q("F_x", Fx, "N"), B_x: q("B_x", Bx, "N") },
      ...source, equation: "28", erratum: "reaction",
    }),
    result(section, "reaction_C_N", "C_y", {
      value: Cy, formula: "-F_y-B_y", values: { F_y: q("F_y", Fy, "N"), B_y: q("B_y", By, "N") }, ...source, equation: "29",
    }),
    ...deflectionSteps(section, input, "B"),
    ...deflectionSteps(section, input, "C"),
  ];
  if (section.simplified_deflection_C_mm === undefined) return found;
  for (const at of ["B", "C"]) {
    found.push(...deflectionSteps(section, input, at, { simplified: true }));
    if (section[`simplification_error_${at}`] === undefined) continue;
    found.push(result(section, `simplification_error_${at}`, `ε_${at}`, {
      formula: "D/Δ-1",
      values: {
        D: q(`Δ′_${at}`, section[`simplified_deflection_${at}_mm`].total, "mm"),
        Δ: q(`Δ_${at}`, section[`deflection_${at}_mm`].total, "mm"),
      },
    }));
  }
  return found;
}

/** The shaft's diameter at a place, from C: of two that meet there the smaller. */
function diameterAt(input, place) {
  const meeting = pieces(input).filter(({ from, to }) => from <= place * (1 + 1e-9) && place <= to * (1 + 1e-9));
  return Math.min(...meeting.map(({ d }) => d));
}

function strengthSteps({ strength, reaction_B_N: [Bx, By], reaction_C_N: [Cx, Cy] }, input) {
  if (!strength) return [];
  const { fatigue: cycle, cycle_position_mm: place, peak_stress_position_mm: bent } = strength;
  const { besides = {}, yield_strength_MPa: R_e } = input;
  const [a, b] = [q("a", input.bearing_distance_mm, "mm"), q("b", input.overhang_mm, "mm")];
  const C = { C_x: q("C_x", Cx, "N"), C_y: q("C_y", Cy, "N") };
  const σ = q("σ", strength.peak_stress_MPa, "MPa");
  const [M_B, M_A] = [q("M_B", strength.bending_moment_B_Nm, "N·m"), q("M_A", strength.bending_moment_clamp_Nm, "N·m")];
  const at = (name, symbol, rest) => result(strength, name, symbol, rest);
  return [
    at("bending_moment_B_Nm", "M_B", { formula: "sqrt(C_x^2+C_y^2)*a", values: { ...C, a } }),
    at("bending_moment_clamp_Nm", "M_A", {
      formula: "sqrt((C_x*(a+b)+B_x*b)^2+(C_y*(a+b)+B_y*b)^2)", values: { ...C, B_x: q("B_x", Bx, "N"), B_y: q("B_y", By, "N"), a, b },
    }),
    at("peak_stress_position_mm", "x", { note: "mostBent" }),
    at("peak_stress_MPa", "σ", input.shaft_sections ? { note: "mostBent" } : {
      formula: "32*max(M_B;M_A)/(π*d^3)", values: { M_B, M_A, d: q("d", diameterAt(input, bent), "mm") },
    }),
    ...(strength.static_safety_factor === undefined ? [] : [at("static_safety_factor", "S", {
      formula: "R_e/σ", values: { R_e: q("R_e", R_e, "MPa"), σ },
    })]),
    ...(!cycle ? [] : [
      at("cycle_position_mm", "x", { note: "worstSection" }),
      result(cycle, "max_stress_MPa", "σ_max", { note: "worstSection" }),
      result(cycle, "min_stress_MPa", "σ_min", { formula: "-σ_max", values: { σ_max: q("σ_max", cycle.max_stress_MPa, "MPa") } }),
      ...cycleSteps(cycle, { asked: besides.fatigue, d: diameterAt(input, place), R_m: besides.tensile_strength_MPa, R_e }),
    ]),
  ];
}

function contactSteps(contact, load, input, materialOf) {
  if (!contact) return [];
  const { mating_radius_mm: r_m, roller_material: roller, mating_material: mating } = input.besides.line_contact;
  const [one, other] = [materialOf("line_contact.roller_material", roller), materialOf("line_contact.mating_material", mating)];
  const w = q("q", load.max_line_load_N_per_mm, "N/mm");
  const ρ = q("ρ_c", contact.reduced_radius_mm, "mm");
  const E = q("E*", contact.effective_modulus_GPa, "GPa");
  const johnson = { source: "johnson" };
  return [
    result(contact, "reduced_radius_mm", "ρ_c", {
      formula: "r_m*ρ/(r_m+ρ)", values: { r_m: q("r_m", r_m, "mm"), ρ: q("ρ", input.roller_radius_mm, "mm") }, ...johnson,
    }),
    result(contact, "effective_modulus_GPa", "E*", {
      formula: "1/((1-ν_1^2)/E_1+(1-ν_2^2)/E_2)",
      values: {
        E_1: q("E_1", one.youngs_modulus_GPa, "GPa"), E_2: q("E_2", other.youngs_modulus_GPa, "GPa"),
        ν_1: q("ν_1", one.poissons_ratio), ν_2: q("ν_2", other.poissons_ratio),
      },
      ...johnson,
    }),
    result(contact, "max_pressure_MPa", "p_0", { formula: "sqrt(w*E/(π*ρ_c))", values: { w, E, ρ_c: ρ }, ...johnson }),
    result(contact, "half_width_mm", "a", { formula: "sqrt(4*w*ρ_c/(π*E))", values: { w, ρ_c: ρ, E }, ...johnson }),
    ...Object.entries({ roller_safety: one, mating_safety: other }).filter(([name]) => contact[name] !== undefined).map(([name, body]) =>
      result(contact, name, "S", {
        formula: "p_P/p_0", values: { p_P: q("p_P", body.allowable_pressure_MPa, "MPa"), p_0: q("p_0", contact.max_pressure_MPa, "MPa") },
      })),
  ];
}

/** `[{ section, steps }]` of what was answered; `materialOf(path, name or values)` gives values. */
export function workedSteps({ input, answer, materialOf }) {
  const { contact_line: line, meshing_load: load, shaft_deflection: shaft } = answer;
  return [
    line && { section: "contact_line", steps: lineSteps(line, input) },
    load && { section: "meshing_load", steps: loadSteps(load, line, input) },
    shaft && {
      section: "shaft_deflection",
      steps: [...shaftSteps(shaft, load, input), ...strengthSteps(shaft, input), ...contactSteps(shaft.line_contact, load, input, materialOf)],
    },
  ].filter(Boolean);
}
