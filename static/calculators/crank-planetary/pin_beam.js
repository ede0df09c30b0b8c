/** Worked steps of a pin as a beam: its compliance under a unit force, and how bent pins share the load. No DOM. */
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate } from "../../lib/formula/step.js";
import { eccentricityOf } from "./mechanism.js";
import { idealTurn } from "./turn.js";
import { partsOf } from "./wanted.js";

const MOST_PAIRS = 100; // whose turn is worked
const ALIKE = 1e-13; // difference of stiffnesses that only rounding makes
const BENT = { // E·I times deflection and slope by what holds the pin, and the force sheared there
  cantilever: ["z*x^2/2-x^3/6", "z*x-x^2/2", "x"],
  supported: ["(V*L^2/6-(L-z)*((L-z)^2+b^2/4)/(6*L))*x-V*x^3/6", "V*L^2/6-(L-z)*((L-z)^2+b^2/4)/(6*L)-V*x^2/2", "V*x"],
  fixed: ["M*x^2/2-V*x^3/6", "M*x-V*x^2/2", "V*x"],
};
const LOAD = { // what the load before x adds to them
  before: ["", "", ""],
  own: ["+b^3/384", "+b^2/48", "-b/8"],
  within: ["+(x-z+b/2)^4/(24*b)", "+(x-z+b/2)^3/(6*b)", "-(x-z+b/2)^2/(2*b)"],
  beyond: ["+(x-z)*((x-z)^2+b^2/4)/6", "+(x-z)^2/2+b^2/24", "-(x-z)"],
};
const HELD = { // shear force and moment at the carrier under a unit force
  supported: { shear: "(L-z)/L" },
  fixed: {
    shear: "(((L-z)^2/2+b^2/24)*L/2-(L-z)*((L-z)^2+b^2/4)/6+10/9*(1+ν)*d^2/8*(L-z))/(L^3/12+10/9*(1+ν)*d^2/8*L)",
    moment: "V*L/2-((L-z)^2/2+b^2/24)/L",
  },
};

/** The pin of the inputs, with its own material or the contact's. */
export function beamOf(input, materialOf) {
  const { contact } = input;
  const { pin } = partsOf(input, ["pin_strength"]);
  const { youngs_modulus_GPa: E, poissons_ratio: ν } = pin.material === undefined
    ? materialOf("contact.pin_material", contact.pin_material) : materialOf("pin.material", pin.material);
  return {
    support: pin.support ?? "cantilever",
    planes: pin.satellite_positions_mm,
    values: {
      E: q("E", E, "GPa"), ν: q("ν", ν), d: q("d", pin.diameter_mm ?? 2 * contact.pin_radius_mm, "mm"), b: q("b", contact.contact_length_mm, "mm"),
      ...(pin.support !== "cantilever" && pin.span_mm && { L: q("L", pin.span_mm, "mm") }),
    },
  };
}

/** The steps to deflection and slope at a satellite by a unit force at one: `{ steps, bent, turned }`. */
export function complianceSteps({ support, planes, values }, at, from) {
  const known = { ...values, x: q(`z_${at + 1}`, planes[at], "mm"), z: q(`z_${from + 1}`, planes[from], "mm") };
  const beyond = planes[at] - planes[from];
  const place = beyond === 0 ? "own" : Math.abs(beyond) < values.b.value / 2 ? "within" : beyond < 0 ? "before" : "beyond";
  const steps = [];
  for (const [name, formula] of Object.entries(HELD[support] ?? {})) {
    const step = name === "shear" ? intermediate("unitShear", "V", "", { formula, values: known })
      : intermediate("unitMoment", "M", "mm", { formula, values: known });
    steps.push(step);
    known[step.symbol] = asValue(step);
  }
  const [bent, turned, sheared] = BENT[support].map((part, i) => part + LOAD[place][i]);
  const noteValues = { at: at + 1, from: from + 1 };
  const deflection = intermediate("unitDeflection", `c_${at + 1}${from + 1}`, "mm/N", {
    formula: `64*(${bent})/(π*E*d^4)+10/9*8*(1+ν)*(${sheared})/(π*E*d^2)`, values: known, note: "unitForce", noteValues,
  });
  const slope = intermediate("unitSlope", `s_${at + 1}${from + 1}`, "mrad/N", { formula: `64*(${turned})/(π*E*d^4)`, values: known });
  return { steps, deflection, slope };
}

/** Approach of the contact over its force, by the contact law of the sharing. */
function contactSteps({ contact, answer, materialOf }) {
  const [pin, hole] = ["pin", "hole"].map((part) => materialOf(`contact.${part}_material`, contact[`${part}_material`]));
  const { pin_radius_mm: r, hole_radius_mm: hole_radius, contact_length_mm: length, dynamic_factor: factor } = contact;
  const values = {
    F: q("F", answer.contact_force.peak_force_N, "N"), K_A: q("K_A", factor), b: q("b", length, "mm"), r_in: q("r_in", r, "mm"),
    r_out: q("r_out", hole_radius ?? r + eccentricityOf(contact), "mm"), ν_1: q("ν_1", pin.poissons_ratio), ν_2: q("ν_2", hole.poissons_ratio),
    E_1: q("E_1", pin.youngs_modulus_GPa, "GPa"), E_2: q("E_2", hole.youngs_modulus_GPa, "GPa"),
  };
  const width = intermediate("contactWidth", "a_c", "mm", {
    formula: "sqrt(4*K_A*F/(π*b)*r_out*r_in/(r_out-r_in)*((1-ν_1^2)/E_1+(1-ν_2^2)/E_2))", values, source: "johnson", note: "level",
  });
  return [width, intermediate("contactCompliance", "c_c", "mm/N", {
    formula: "((1-ν_1^2)/E_1*(2*ln(4*r_in/a)-1)+(1-ν_2^2)/E_2*(2*ln(2*r_out/a)-ν_2/(1-ν_2)))/(π*b)",
    values: { ...values, a: asValue(width) }, source: "johnson",
  })];
}

/** How the satellites may share an ideal load: alike, and by the stiffness of bent pins; the steps to the latter. Null for forces that are solved or too many. */
export function sharings(input, { materialOf, answer }) {
  const { mechanism, load } = input;
  if (answer.load_sharing || mechanism.pins * mechanism.satellites > MOST_PAIRS) return null;
  const alike = { ...idealTurn(mechanism, load.force_exponent), weighed: false };
  if (!partsOf(input, ["pin_strength"]).pin || mechanism.satellites === 1) return { turns: [alike], steps: [] };
  const beam = beamOf(input, materialOf);
  const contact = contactSteps({ contact: input.contact, answer, materialOf });
  const c_c = asValue(contact.at(-1));
  const each = mechanism.angles.flatMap((_, j) => {
    const { steps, deflection } = complianceSteps(beam, j, j);
    const stiffness = intermediate("pairStiffness", `k_${j + 1}`, "N/mm", { formula: "1/(c_c+c)", values: { c_c, c: asValue(deflection) } });
    return [...steps, deflection, stiffness];
  });
  const weights = each.filter(({ name }) => name === "pairStiffness").map(({ value }) => value);
  if (Math.max(...weights) - Math.min(...weights) <= ALIKE * Math.max(...weights)) return { turns: [alike], steps: [] };
  return { turns: [alike, { ...idealTurn(mechanism, load.force_exponent, weights), weighed: true }], steps: [...contact, ...each] };
}

/** Steps without those on the way that stand before already. */
export function once(steps) {
  const known = steps.map(({ symbol, value }) => `${symbol} ${value.toPrecision(9)}`);
  return steps.filter(({ intermediate }, i) => !intermediate || known.indexOf(known[i]) === i);
}

/**
 * How the force of a satellite's pairs is written at a position found: a pair's over that of all the torque is
 * `own` times `once` of its cosine, over `support`; `twice` is its part of the torque.
 */
export function sharingOf({ position, turn }, { force_exponent: v }, satellite) {
  const [twice, single] = { 0: ["", "^0"], 1: ["^2", ""] }[v] ?? ["^(1+v)", "^v"];
  const list = (symbol, pairs) => q(symbol, pairs.map(({ angle }) => angle), "°");
  const own = position.pairs.filter((pair) => pair.satellite === satellite);
  const weight = (pair) => pair.weight;
  return {
    own: turn.weighed ? "k_j*" : "",
    twice: (angle) => `cos(${angle})${twice}`,
    once: (angle) => `cos(${angle})${single}`,
    support: `sum(${turn.weighed ? "k_i*" : ""}cos(γ_i)${twice})`,
    values: {
      v: q("v", v), γ_i: list("γ_i", position.pairs), γ_j: list(`γ_${satellite + 1},i`, own),
      ...(turn.weighed && { k_i: q("k_i", position.pairs.map(weight), "N/mm"), k_j: q(`k_${satellite + 1}`, weight(own[0] ?? { weight: 0 }), "N/mm") }),
    },
    said: turn.weighed ? { note: "byStiffness" } : { note: "alike" },
  };
}
