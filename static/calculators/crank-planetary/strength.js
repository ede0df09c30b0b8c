/** Strength of the pins: what is said and drawn of the service's answer. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
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

export function cells({ peak_equivalent_stress_MPa: stress, static_safety_factor: yields, fatigue, deflection, tie_ring: ring, bolt }) {
  return [
    {
      label: quantityTitle("peak_equivalent_stress_MPa"),
      value: formatQuantity(stress, "MPa", 4),
      note: yields === undefined ? message("strength.noYield") : message("strength.yield", { safety: formatNumber(yields, 3) }),
    },
    {
      label: quantityTitle("fatigue_safety_factor"),
      value: fatigue ? formatNumber(fatigue.safety_factor, 3) : "–",
      note: fatigue ? message("strength.cycle", { from: formatQuantity(fatigue.min_stress_MPa, "MPa", 4), to: formatQuantity(fatigue.max_stress_MPa, "MPa", 4) })
        : message("strength.noFatigue"),
    },
    deflection && {
      label: quantityTitle("deflection_mm"),
      value: formatQuantity(deflection.deflection_mm, "mm", 3),
      note: message("strength.slope", {
        satellite: deflection.satellite, sloping: deflection.slope_satellite, slope: formatQuantity(deflection.slope_mrad, "mrad", 3),
      }),
    },
    ring && {
      label: quantityTitle("tie_ring_peak_force_N"),
      value: formatQuantity(ring.peak_force_N, "N", 4),
      note: message("strength.ringMoves", { shift: formatQuantity(ring.shift_mm, "mm", 3), turn: formatQuantity(ring.turn_mrad, "mrad", 3) }),
    },
    bolt && {
      label: message("strength.bolt"),
      value: formatQuantity(bolt.moment_Nm, "N·m", 4),
      note: bolt.opening_moment_Nm === undefined ? message("strength.noPreload")
        : message(bolt.holds ? "strength.boltHolds" : "strength.boltAlone", { opens: formatQuantity(bolt.opening_moment_Nm, "N·m", 4) }),
    },
  ].filter(Boolean);
}

export const drawing = { create: pinDrawing, section: "pin_strength" };
