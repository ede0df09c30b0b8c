/** Ring and bearings of the satellites: what is said of the service's answer, and its worked steps. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { chartOf } from "./wanted.js";

const ROUNDING = 1e-9;

export const figure = {
  id: "bearings", section: "satellite_bearing", path: "/satellite-bearing/chart",
  body: (input) => ({ ...crankedBody(input), bearing: input.besides.bearing }),
};

/** What loads the crank: mechanism, load, eccentricity, ring. */
export function crankedBody(input) {
  const { mechanism, load, gear } = chartOf(input);
  return { mechanism, load, contact: { eccentricity_mm: input.contact.eccentricity_mm }, gear };
}

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
  const title = (name) => message(`quantity.${name}`)[0];
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
    values: { n, C: q("C", rating, "N"), P: q("P", load, "N"), p: q("p", kind === "ball" ? 3 : 10 / 3) },
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

export function steps(section, input, { answer }) {
  const { bearing } = input.besides;
  const index = worstOf(section);
  const worst = section.satellites[index];
  const n = q("n", section.relative_speed_rpm, "rpm");
  const noteValues = { satellite: index + 1 };
  return [
    speedStep(section, input),
    ...ringSteps(section, input),
    ...Object.entries({ peak_load_N: "Q_max", min_load_N: "Q_min", peak_ring_force_N: "F_r" }).map(([name, symbol]) =>
      result(worst, name, symbol, { note: "bearingLoad", noteValues })),
    result(worst, "equivalent_load_N", "P", { note: "equivalentLoad", noteValues }),
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
