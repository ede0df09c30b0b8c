/** Strength of the pins: what is said and drawn of the service's answer. No DOM. */
import { formatNumber, written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message, quantityTitle } from "../../messages/index.js";
import { pinDrawing } from "./along.js";
import { drawnDocument } from "./wanted.js";

export const figure = { id: "pinStrength", section: "pin_strength", path: "/pin-strength/chart", body: drawnDocument };

/** The same pin in the supports between which the truth of a cage lies, asked for where it is held at both ends. */
export const bounds = {
  path: "/pin-strength",
  list: "support_bounds",
  of: ({ pin_strength: strength }, { besides }) => strength && besides?.pin?.span_mm !== undefined && besides.pin.support !== "tie_ring",
  body: (input, answer, requests) => ({ ...drawnDocument(input, answer, requests), include: ["support_bounds", "deflection"] }),
  shown: [
    "peak_bending_stress_MPa", "peak_equivalent_stress_MPa", "static_safety_factor", "fatigue_safety_factor", "deflection_mm", "slope_mrad",
  ],
  nameOf: ({ support }) => message("option")[support],
};

export function cells(section) {
  const { static_safety_factor: yields, fatigue, deflection, tie_ring: ring, bolt } = section;
  const stress = yields === undefined ? message("strength.noYield") : message("strength.yield", { safety: formatNumber(yields, 3) });
  const cycle = fatigue ? message("strength.cycle", { from: written(fatigue, "min_stress_MPa"), to: written(fatigue, "max_stress_MPa") })
    : message("strength.noFatigue");
  const opens = bolt?.opening_moment_Nm === undefined ? message("strength.noPreload")
    : message(bolt.holds ? "strength.boltHolds" : "strength.boltAlone", { opens: written(bolt, "opening_moment_Nm") });
  return [
    quantityCell(section, "peak_equivalent_stress_MPa", stress),
    quantityCell(fatigue ?? {}, "safety_factor", cycle, quantityTitle("fatigue_safety_factor")),
    deflection && quantityCell(deflection, "deflection_mm", message("strength.slope", {
      satellite: deflection.satellite, sloping: deflection.slope_satellite, slope: written(deflection, "slope_mrad"),
    })),
    ring && quantityCell(ring, "peak_force_N", message("strength.ringMoves", {
      shift: written(ring, "shift_mm"), turn: written(ring, "turn_mrad"),
    }), quantityTitle("tie_ring_peak_force_N")),
    bolt && quantityCell(bolt, "moment_Nm", opens, message("strength.bolt")),
  ].filter(Boolean);
}

export const drawing = { create: pinDrawing, section: "pin_strength" };
