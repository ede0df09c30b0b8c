/** The crankshaft: what is said and drawn of the service's answer, and its worked steps. No DOM. */
import { formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { crankDrawing } from "./along.js";
import { crankedBody, lifeStep } from "./bearings.js";
import { cranksOf } from "./mechanism.js";
import { chartOf } from "./wanted.js";

export const figure = {
  id: "crank", section: "crankshaft", path: "/crankshaft/chart",
  body: (input) => ({ ...crankedBody(input), crankshaft: chartOf(input).crankshaft }),
};

const LETTERS = ["A", "B"];

export function cells({ bearings, balance }) {
  const reaction = (bearing, i) => ({
    label: message("crank.bearing", { letter: LETTERS[i] }),
    value: formatQuantity(bearing.peak_N, "N", 4),
    note: bearing.basic_life_h === undefined ? message("crank.equivalent", { load: formatQuantity(bearing.equivalent_N, "N", 4) })
      : message("crank.life", { life: formatQuantity(bearing.basic_life_h, "h", 3) }),
  });
  return [
    ...bearings.map(reaction),
    balance && {
      label: message("quantity.unbalance_kg_mm")[0],
      value: formatQuantity(balance.unbalance_kg_mm, "kg·mm", 3),
      note: message("crank.left", { force: formatQuantity(balance.force_N, "N", 3), couple: formatQuantity(balance.couple_Nm, "N·m", 3) }),
    },
  ].filter(Boolean);
}

export const lists = { bearings: (i) => LETTERS[i], corrections: (i) => LETTERS[i] };

export const drawing = { create: crankDrawing, section: "crankshaft" };

function balanceSteps({ balance }, { mechanism, load, contact, besides: { crankshaft } }) {
  if (!balance) return [];
  const [A, B] = crankshaft.bearing_positions_mm;
  const arms = (symbol, of, unit) => q(symbol, crankshaft.satellite_positions_mm.map(of), unit);
  const values = {
    m: q("m", crankshaft.satellite_mass_kg, "kg"), e: q("e", contact.eccentricity_mm, "mm"), α: q("α_i", cranksOf(mechanism), "°"),
    n_1: q("n_1", load.input_speed_rpm, "rpm"),
  };
  const vector = "sqrt(sum(z*cos(α))^2+sum(z*sin(α))^2)";
  const at = (part, name, symbol, formula, rest) => result(part, name, symbol, { formula, values, ...rest });
  const corrected = (part, letter, of) => [
    at(part, "unbalance_kg_mm", `U_${letter}`, `m*e*${vector}`, { values: { ...values, z: arms("w_i", of) }, note: "carried", noteValues: { letter } }),
    result(part, "angle_deg", `α_${letter}`, { note: "opposite" }),
  ];
  const arm = intermediate("arm", "d", "mm", {
    formula: vector, values: { α: values.α, z: arms("z_i", (z) => z - (A + B) / 2, "mm") }, note: "aboutMiddle",
  });
  const [inA, inB] = balance.corrections;
  return [
    at(balance, "unbalance_kg_mm", "U", "m*e*sqrt(sum(cos(α))^2+sum(sin(α))^2)"),
    at({ balance_force_N: balance.force_N }, "balance_force_N", "F", "U*n_1^2", {
      values: { U: q("U", balance.unbalance_kg_mm, "kg·mm"), n_1: values.n_1 }, note: "turnsInRadians",
    }),
    arm,
    at(balance, "couple_Nm", "M", "m*e*d*n_1^2", { values: { ...values, d: asValue(arm) }, note: "turnsInRadians" }),
    ...corrected(inA, "A", (z) => (B - z) / (B - A)),
    ...corrected(inB, "B", (z) => (z - A) / (B - A)),
  ];
}

export function steps(section, input) {
  const n = q("n_1", input.load.input_speed_rpm, "rpm");
  return [
    ...section.bearings.flatMap((bearing, i) => [
      result(bearing, "peak_N", `R_${LETTERS[i]}`, { note: "reaction" }),
      result(bearing, "equivalent_N", `P_${LETTERS[i]}`, { note: "equivalentReaction" }),
      ...(bearing.basic_life_h === undefined ? [] : [lifeStep(bearing, {
        kind: input.besides.crankshaft.bearings[i].kind, rating: input.besides.crankshaft.bearings[i].dynamic_rating_N, load: bearing.equivalent_N, n,
      })]),
    ]),
    ...balanceSteps(section, input),
  ];
}
