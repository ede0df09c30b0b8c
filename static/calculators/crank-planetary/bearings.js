/** Ring and bearings of the satellites: what is said of the service's answer. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";
import { drawnDocument } from "./wanted.js";

const ROUNDING = 1e-9;

export const figure = { id: "bearings", section: "satellite_bearing", path: "/satellite-bearing/chart", body: drawnDocument };

/** The satellite whose bearing has the largest equivalent load. */
function worstOf({ satellites }) {
  return satellites.reduce((worst, one, i) => (one.equivalent_load_N > satellites[worst].equivalent_load_N * (1 + ROUNDING) ? i : worst), 0);
}

export function cells(section) {
  const satellite = worstOf(section) + 1;
  const { equivalent_load_N: load, peak_load_N: peak, life_h: life, basic_life_h: basic, static_safety_factor: safety } = section.satellites[satellite - 1];
  return [
    { label: quantityTitle("equivalent_load_N"), value: formatQuantity(load, "N", 4), note: message("bearings.peak", { satellite, peak: formatQuantity(peak, "N", 4) }) },
    {
      label: quantityTitle("life_h"),
      value: life === undefined ? "–" : formatQuantity(life, "h", 3),
      note: life === undefined ? message("bearings.noRating") : message("bearings.basic", { life: formatQuantity(basic, "h", 3) }),
    },
    {
      label: quantityTitle("static_rating_safety"),
      value: safety === undefined ? "–" : formatNumber(safety, 3),
      note: message("bearings.ring", { ratio: formatNumber(section.radial_force_ratio, 3) }),
    },
  ];
}

export const lists = { satellites: (i) => message("real.satellite", { satellite: i + 1 }) };
