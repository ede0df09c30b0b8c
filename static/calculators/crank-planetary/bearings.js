/** Ring and bearings of the satellites: what is said of the service's answer, and its worked steps. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { sharingOf, sharings } from "./pin_beam.js";
import { largestOf, meanOf, onSatellite } from "./turn.js";
import { figureBody } from "./wanted.js";

const ROUNDING = 1e-9;

export const figure = { id: "bearings", section: "satellite_bearing", path: "/satellite-bearing/chart", body: figureBody("gear", "bearing") };

export const torqueOf = ({ load, mechanism }) => load.output_torque_Nm ?? load.input_torque_Nm * mechanism.ratio * load.efficiency;

/** A static safety, a limit over a load, under the peak torque; `share` is that over the torque of the load. Real forces do not grow with it. */
export function staticStep(part, name, symbol, { limit, load, share, answer, source }) {
  if (answer.load_sharing && share !== 1) return result(part, name, symbol, { note: "underPeak" });
  return result(part, name, symbol, {
    formula: share === 1 ? "R/s" : "R/(k*s)", values: { R: limit, s: load, k: q("k", share) }, ...(share !== 1 && { note: "peakTorque" }), ...(source && { source }),
  });
}

/** The satellite whose bearing has the largest equivalent load. */
export function worstOf({ satellites }) {
  return satellites.reduce((worst, one, i) => (one.equivalent_load_N > satellites[worst].equivalent_load_N * (1 + ROUNDING) ? i : worst), 0);
}

export function cells(section) {
  const title = (name) => message(`quantity.${name}`).title;
  const satellite = worstOf(section) + 1;
  const { equivalent_load_N: load, peak_load_N: peak, life_h: life, basic_life_h: basic, static_safety_factor: safety } = section.satellites[satellite - 1];
  return [
    { label: title("equivalent_load_N"), value: formatQuantity(load, "N", 4), note: message("bearings.peak", { satellite, peak: formatQuantity(peak, "N", 4) }) },
    {
      label: title("life_h"),
      value: life === undefined ? "–" : formatQuantity(life, "h", 3),
      note: life === undefined ? message("bearings.noRating") : message("bearings.basic", { life: formatQuantity(basic, "h", 3) }),
    },
    {
      label: title("static_rating_safety"),
      value: safety === undefined ? "–" : formatNumber(safety, 3),
      note: message("bearings.ring", { ratio: formatNumber(section.radial_force_ratio, 3) }),
    },
  ];
}

export const lists = { satellites: (i) => message("real.satellite", { satellite: i + 1 }) };

/** Basic life of a bearing of some rolling elements under its equivalent load. */
export function lifeStep(part, { kind, rating, load, n }) {
  return result(part, "basic_life_h", "L_10", {
    formula: "1000000*2*π/n*(C/P)^p",
    values: { n, C: q("C", rating, "N"), P: q("P", load, "N"), p: q("p", exponentOf(kind)) },
    source: "iso281", note: "turnsInRadians",
  });
}

export const speedStep = (section, input) => result(section, "relative_speed_rpm", "n", {
  formula: "n_1*(1+1/u)", values: { n_1: q("n_1", input.load.input_speed_rpm, "rpm"), u: q("u", input.mechanism.ratio) },
});


function ringSteps(section, { mechanism, contact, besides: { gear } }) {
  const ρ = (rest) => result(section, "radial_force_ratio", "ρ", rest);
  if (gear.kind === "cycloid") {
    const k = q("k", (contact.eccentricity_mm * (mechanism.ratio + 1)) / gear.ring_pin_circle_radius_mm);
    return [ρ({ formula: "-(2-(1-k^2)/k*ln((1+k)/(1-k)))/(π*k)", values: { k }, note: "shortened" })];
  }
  if (gear.kind !== "involute") return [ρ({ note: "given" })];
  return [
    result(section, "operating_pressure_angle_deg", "α_w", {
      formula: "acos(m*z*cos(α)/(2*e))",
      values: {
        m: q("m", gear.module_mm, "mm"), z: q("Δz", gear.teeth_difference), α: q("α", gear.reference_pressure_angle_deg ?? 20, "°"),
        e: q("e", contact.eccentricity_mm, "mm"),
      },
    }),
    ρ({ formula: "sin(α_w)/cos(α_w)", values: { α_w: q("α_w", section.operating_pressure_angle_deg, "°") } }),
  ];
}

/** What the ideal forces do at a satellite: its part of a step's formula, the steps to force across its crank and of its pins, and both in N. */
export function satelliteLoads(input) {
  const { load, contact, mechanism } = input;
  const values = {
    T: q("T", torqueOf(input), "N·m"), R: q("R", load.pin_circle_radius_mm, "mm"), e: q("e", contact.eccentricity_mm, "mm"), u: q("u", mechanism.ratio),
  };
  const [across, pins] = [contact.eccentricity_mm * mechanism.ratio, load.pin_circle_radius_mm].map((arm) => (1000 * values.T.value) / arm);
  const shared = (found, j) => {
    const { own, twice, once, support, values: angles, said } = sharingOf(found, load, j);
    return { share: `${own}sum(${twice("γ_j")})/${support}`, sum: `${own}sum(${once("γ_j")})/${support}`, values: { ...values, ...angles }, said };
  };
  return {
    of: (position, j) => {
      const { share, pins: sum } = onSatellite(position, j);
      return { W: across * share, S: pins * sum };
    },
    shared,
    steps(found, j) {
      const { share, sum, values: known, said } = shared(found, j);
      return [
        intermediate("satelliteTorque", `T_${j + 1}`, "N·m", { formula: `T*${share}`, values: known, ...said }),
        intermediate("pinsForce", `S_${j + 1}`, "N", { formula: `T/R*${sum}`, values: known }),
      ];
    },
    across: (torque, j) => intermediate("acrossForce", `W_${j + 1}`, "N", { formula: "T_j/(e*u)", values: { ...values, T_j: asValue(torque) } }),
  };
}

/** The mean of a load to a power, its root: the largest of these measures and turns. */
export function equivalentStep(part, name, symbol, { turns, measures, p, factor = 1, of }) {
  const means = turns.flatMap((turn) => measures.map((measure) => meanOf(turn, measure)));
  const power = (mean) => mean.reduce((sum, { value, weight }) => sum + weight * value ** p, 0);
  const mean = means.reduce((most, one) => (power(one) > power(most) ? one : most));
  return result(part, name, symbol, {
    formula: `${factor === 1 ? "" : "V*"}sum(g_i*${of}_i^p)^(1/p)`,
    values: { V: q("V", factor), p: q("p", p), g_i: q("g_i", mean.map(({ weight }) => weight)), [`${of}_i`]: q(`${of}_i`, mean.map(({ value }) => value), "N") },
    note: "meanPower",
  });
}

export const exponentOf = (kind) => (kind === "ball" ? 3 : 10 / 3);

/** Loads of the worst bearing under the ideal forces, pins and ring together. */
function idealSteps(worst, j, section, input, { turns }) {
  const { bearing } = input.besides;
  const loads = satelliteLoads(input);
  const ρ = section.radial_force_ratio;
  const size = (position) => {
    const { W, S } = loads.of(position, j);
    return Math.hypot(W, ρ * W + S);
  };
  const peak = largestOf(turns, size);
  const [torque, pins] = loads.steps(peak, j);
  const across = loads.across(torque, j);
  const ring = loads.shared(largestOf(turns, (position) => loads.of(position, j).W), j);
  const noteValues = { satellite: j + 1 };
  return [
    torque, across, pins,
    result(worst, "peak_load_N", "Q_max", {
      formula: "sqrt(W^2+(ρ*W+S)^2)", values: { W: asValue(across), S: asValue(pins), ρ: q("ρ", ρ) }, note: "bearingLoad", noteValues,
    }),
    result(worst, "min_load_N", "Q_min", { note: "bearingLoad", noteValues }),
    result(worst, "peak_ring_force_N", "F_r", {
      formula: `T/(e*u)*${ring.share}*sqrt(1+ρ^2)`, values: { ...ring.values, ρ: q("ρ", ρ) }, ...ring.said,
    }),
    equivalentStep(worst, "equivalent_load_N", "P", {
      turns, measures: [size], p: exponentOf(bearing.kind), factor: bearing.ring_factor, of: "Q",
    }),
  ];
}

export function steps(section, input, context) {
  const { answer } = context;
  const { bearing } = input.besides;
  const index = worstOf(section);
  const worst = section.satellites[index];
  const n = q("n", section.relative_speed_rpm, "rpm");
  const noteValues = { satellite: index + 1 };
  const shared = sharings(input, context);
  return [
    speedStep(section, input),
    ...ringSteps(section, input),
    ...(shared ? idealSteps(worst, index, section, input, shared) : [
      ...Object.entries({ peak_load_N: "Q_max", min_load_N: "Q_min", peak_ring_force_N: "F_r" }).map(([name, symbol]) =>
        result(worst, name, symbol, { note: "bearingLoad", noteValues })),
      result(worst, "equivalent_load_N", "P", { note: "equivalentLoad", noteValues }),
    ]),
    ...(worst.basic_life_h === undefined ? [] : [
      lifeStep(worst, { kind: bearing.kind, rating: bearing.dynamic_rating_N, load: worst.equivalent_load_N, n }),
      result(worst, "life_h", "L_n", { note: "reliable", noteValues: { percent: bearing.reliability_percent } }),
    ]),
    ...(worst.static_safety_factor === undefined ? [] : [staticStep({ static_rating_safety: worst.static_safety_factor }, "static_rating_safety", "S_0", {
      limit: q("C_0", bearing.static_rating_N, "N"), load: q("Q_max", worst.peak_load_N, "N"), answer, source: "iso76",
      share: (input.load.peak_torque_Nm ?? input.contact.dynamic_factor * torqueOf(input)) / torqueOf(input),
    })]),
    ...(section.system_life_h === undefined ? [] : [result(section, "system_life_h", "L_s", { note: "together" })]),
  ];
}
