/** Ring and bearings of the satellites: what is said of the service's answer. No DOM. */
import { written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
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
  const own = section.satellites[satellite - 1];
  const ratio = written(section, "radial_force_ratio");
  return [
    quantityCell(own, "equivalent_load_N", message("bearings.peak", { satellite, peak: written(own, "peak_load_N") })),
    quantityCell(own, "life_h", own.life_h === undefined ? message("bearings.noRating") : message("bearings.basic", { life: written(own, "basic_life_h") })),
    quantityCell(own, "static_safety_factor", message("bearings.ring", { ratio }), quantityTitle("static_rating_safety")),
  ];
}

export const lists = { satellites: (i) => message("real.satellite", { satellite: i + 1 }) };
