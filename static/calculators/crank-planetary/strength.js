/** Strength of the pins: what is said and drawn of the service's answer. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message } from "../../messages/index.js";
import { pinDrawing } from "./along.js";
import { figureBody } from "./wanted.js";

const strengthBody = figureBody("fatigue");

export const figure = { id: "pinStrength", section: "pin_strength", path: "/pin-strength/chart", body: strengthBody };

/** The same pin in the supports between which the truth of a cage lies, asked for where it is held at both ends. */
export const bounds = {
  path: "/pin-strength",
  list: "support_bounds",
  of: ({ pin_strength: strength }, { besides }) => strength && besides?.pin?.span_mm !== undefined,
  body(input, answer, requests) {
    const { fatigue, ...body } = strengthBody(input, answer, requests);
    const life = fatigue && { fatigue: { life_h: input.requirements.life_h, ...fatigue } };
    return { ...body, ...life, include: ["support_bounds", "deflection"] };
  },
  shown: [
    "peak_bending_stress_MPa", "peak_equivalent_stress_MPa", "static_safety_factor", "fatigue_safety_factor", "deflection_mm", "slope_mrad",
  ],
  nameOf: ({ support }) => message("option")[support],
};

export function cells({ peak_equivalent_stress_MPa: stress, static_safety_factor: yields, fatigue, deflection }) {
  const title = (name) => message(`quantity.${name}`).title;
  return [
    {
      label: title("peak_equivalent_stress_MPa"),
      value: formatQuantity(stress, "MPa", 4),
      note: yields === undefined ? message("strength.noYield") : message("strength.yield", { safety: formatNumber(yields, 3) }),
    },
    {
      label: title("fatigue_safety_factor"),
      value: fatigue ? formatNumber(fatigue.safety_factor, 3) : "–",
      note: fatigue ? message("strength.cycle", { from: formatQuantity(fatigue.min_stress_MPa, "MPa", 4), to: formatQuantity(fatigue.max_stress_MPa, "MPa", 4) })
        : message("strength.noFatigue"),
    },
    deflection && {
      label: title("deflection_mm"),
      value: formatQuantity(deflection.deflection_mm, "mm", 3),
      note: message("strength.slope", {
        satellite: deflection.satellite, sloping: deflection.slope_satellite, slope: formatQuantity(deflection.slope_mrad, "mrad", 3),
      }),
    },
  ].filter(Boolean);
}

export const drawing = { create: pinDrawing, section: "pin_strength" };
