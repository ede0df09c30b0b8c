/** The crankshaft: what is said and drawn of the service's answer, and its worked steps. No DOM. */
import { formatQuantity } from "../../lib/format.js";
import { quantity as q } from "../../lib/formula/evaluate.js";
import { asValue, intermediate, result } from "../../lib/formula/step.js";
import { message } from "../../messages/index.js";
import { crankDrawing } from "./along.js";
import { equivalentStep, exponentOf, lifeStep, satelliteLoads } from "./bearings.js";
import { cranksOf } from "./mechanism.js";
import { once, sharings } from "./pin_beam.js";
import { largestOf } from "./turn.js";
import { figureBody } from "./wanted.js";

export const figure = { id: "crank", section: "crankshaft", path: "/crankshaft/chart", body: figureBody("gear", "crankshaft") };

const LETTERS = ["A", "B"];
const MOST_SATELLITES = 4; // whose forces are worked

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

const WAYS = { driving: [1], reverse: [-1], alternating: [1, -1] }; // of the force across the cranks

/** Reactions under the ideal forces: shaft and cranks in equilibrium, in the frame of the first crank. */
function idealSteps({ bearings }, input, { turns }, { radial_force_ratio: ρ }) {
  const { mechanism: { angles }, load: { torque_direction: direction = "driving" }, besides: { crankshaft } } = input;
  const loads = satelliteLoads(input);
  const [A, B] = crankshaft.bearing_positions_mm;
  const places = crankshaft.satellite_positions_mm;
  const shares = places.map((z) => [(B - z) / (B - A), (z - A) / (B - A)]);
  return bearings.map((bearing, i) => {
    const measure = (way) => (position) => Math.hypot(...angles.reduce(([x, y], angle, j) => {
      const { W, S } = loads.of(position, j);
      const [along, across, share, α] = [ρ * W + S, way * W, shares[j][i], (angle * Math.PI) / 180];
      return [x + share * (along * Math.cos(α) - across * Math.sin(α)), y + share * (along * Math.sin(α) + across * Math.cos(α))];
    }, [0, 0]));
    const found = WAYS[direction].map((way) => ({ way, ...largestOf(turns, measure(way)) }));
    const { way, ...peak } = found.reduce((most, one) => (one.value > most.value ? one : most));
    const [minus, plus] = way > 0 ? ["-", "+"] : ["+", "-"];
    const each = angles.map((_, j) => {
      const [torque, pins] = loads.steps(peak, j);
      return [torque, loads.across(torque, j), pins];
    });
    const share = i === 0 ? "(B-z_i)/(B-A)" : "(z_i-A)/(B-A)";
    return [
      ...each.slice(0, MOST_SATELLITES).flat(),
      result(bearing, "peak_N", `R_${LETTERS[i]}`, {
        formula: `sqrt(sum(${share}*((ρ*W_i+S_i)*cos(α_i)${minus}W_i*sin(α_i)))^2+sum(${share}*((ρ*W_i+S_i)*sin(α_i)${plus}W_i*cos(α_i)))^2)`,
        values: {
          A: q("A", A, "mm"), B: q("B", B, "mm"), z_i: q("z_i", places, "mm"), α_i: q("α_i", angles, "°"), ρ: q("ρ", ρ),
          W_i: q("W_i", each.map(([, across]) => across.value), "N"), S_i: q("S_i", each.map(([, , pins]) => pins.value), "N"),
        },
        note: "equilibrium",
      }),
      equivalentStep(bearing, "equivalent_N", `P_${LETTERS[i]}`, {
        turns, measures: WAYS[direction].map(measure), p: exponentOf(crankshaft.bearings?.[i].kind ?? "ball"), of: "R",
      }),
    ];
  });
}

export function steps(section, input, context) {
  const n = q("n_1", input.load.input_speed_rpm, "rpm");
  const shared = sharings(input, context);
  const loaded = shared ? idealSteps(section, input, shared, context.answer.satellite_bearing) : section.bearings.map((bearing, i) => [
    result(bearing, "peak_N", `R_${LETTERS[i]}`, { note: "reaction" }),
    result(bearing, "equivalent_N", `P_${LETTERS[i]}`, { note: "equivalentReaction" }),
  ]);
  return once([
    ...section.bearings.flatMap((bearing, i) => [
      ...loaded[i],
      ...(bearing.basic_life_h === undefined ? [] : [lifeStep(bearing, {
        kind: input.besides.crankshaft.bearings[i].kind, rating: input.besides.crankshaft.bearings[i].dynamic_rating_N, load: bearing.equivalent_N, n,
      })]),
    ]),
    ...balanceSteps(section, input),
  ]);
}
