/** Friction and wear: what is said of the service's answer, and its worked steps. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { torqueOf } from "./bearings.js";
import { diameterOf } from "./strength.js";
import { figureBody, sleeved } from "./wanted.js";

export const figure = { id: "losses", section: "output_efficiency", path: "/output-efficiency/chart", body: lossBody, height: 420 };

const designBody = figureBody("friction");

/** Without the wear, which takes a life and is not drawn. */
function lossBody(input, answer, requests) {
  const { friction: { wear_rate_mm3_per_Nm, ...friction }, ...body } = designBody(input, answer, requests);
  return { ...body, friction };
}

export function cells(section) {
  const title = (name) => message(`quantity.${name}`).title;
  const { efficiency, min_efficiency: least, mean_loss_W: loss, output_power_W: power, peak_pv_MPa_m_per_s: pv, sliding_speed_m_per_s: speed } = section;
  return [
    { label: title("efficiency"), value: formatNumber(efficiency, 4), note: message("losses.least", { value: formatNumber(least, 4) }) },
    { label: title("mean_loss_W"), value: formatQuantity(loss, "W", 4), note: message("losses.of", { power: formatQuantity(power, "W", 4) }) },
    { label: title("peak_pv_MPa_m_per_s"), value: formatQuantity(pv, "MPa·m/s", 3), note: message("losses.at", { speed: formatQuantity(speed, "m/s", 3) }) },
  ];
}

export function steps(section, input) {
  const { mechanism: { ratio, pins, satellites }, load, contact, besides: { friction }, requirements } = input;
  const rolls = sleeved(input);
  const at = (name, symbol, rest) => result(section, name, symbol, rest);
  const n = q("n", section.relative_speed_rpm, "rpm");
  const u = q("u", ratio);
  const n_1 = q("n_1", load.input_speed_rpm, "rpm");
  const e = q("e", contact.eccentricity_mm, "mm");
  const R = q("R", load.pin_circle_radius_mm, "mm");
  const T = q("T", torqueOf(input), "N·m");
  const b = q("b", contact.contact_length_mm, "mm");
  const r = q(rolls ? "r_s" : "r_in", contact.pin_radius_mm, "mm");
  const r_p = q("r_p", diameterOf(input) / 2, "mm");
  const μ = q("μ", friction.coefficient);
  const f = q("f", section.mean_total_force_ratio);
  const F = q("F_max", section.peak_force_N, "N");
  const P = q("P", section.mean_loss_W, "W");
  const P_2 = q("P_2", section.output_power_W, "W");
  const v = q("v", section.sliding_speed_m_per_s, "m/s");
  const slow = rolls ? "*r_p/r" : "";
  const worn = (name, symbol, radius) => (section[name] === undefined ? [] : [at(name, symbol, {
    formula: "k*F/(b*r)*e*n*t/(2*π)",
    values: { k: q("k", friction.wear_rate_mm3_per_Nm, "mm³/(N·m)"), F, b, r: radius, e, n, t: q("t", requirements.life_h, "h") },
    source: "archard", note: "turnsInRadians",
  })]);
  return [
    at("relative_speed_rpm", "n", { formula: "n_1*(1+1/u)", values: { n_1, u } }),
    at("sliding_speed_m_per_s", "v", { formula: `e*n${slow}`, values: { e, n, r_p, r }, note: "turnsInRadians" }),
    ...(section.sleeve_speed_rpm === undefined ? [] : [at("sleeve_speed_rpm", "n_s", { formula: "n*e/r", values: { n, e, r } })]),
    at("peak_force_N", "F_max", { note: "search" }),
    at("mean_total_force_ratio", "f", { note: "meanOfTurn" }),
    at("output_power_W", "P_2", { formula: "T*n_1/u", values: { T, n_1, u }, note: "turnsInRadians" }),
    at("mean_loss_W", "P", { formula: "μ*v*f*T/R", values: { μ, v, f, T, R } }),
    at("efficiency", "η", { formula: "P_2/(P_2+P)", values: { P_2, P } }),
    at("min_efficiency", "η_min", { note: "overTurn" }),
    at("max_efficiency", "η_max", { note: "overTurn" }),
    at("peak_pv_MPa_m_per_s", "p_v", { formula: "F/(2*r*b)*e*n", values: { F, r, b, e, n } }),
    at("mean_pv_MPa_m_per_s", "p_m", {
      formula: "f*T/(R*N*K)/(2*r*b)*e*n", values: { f, T, R, N: q("N", pins), K: q("K", satellites), r, b, e, n },
    }),
    ...worn("pin_wear_mm", "h_in", r),
    ...worn("hole_wear_mm", "h_out", q("r_out", contact.hole_radius_mm, "mm")),
    at("friction_couple", "c", { formula: `μ*f*r/R${slow}`, values: { μ, f, r, R, r_p }, note: "couple" }),
  ];
}
