/** Rolling bearings as rollers on the pins: what is said of the service's answer. No DOM. */
import { written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message, quantityTitle } from "../../messages/index.js";

export const path = "/crank-planetary";

export function cells(section) {
  const { satellite, pin } = section;
  const told = (name, key, none) => (section[name] === undefined ? message(none) : message(`rolling.${key}`, { [key]: written(section, name) }));
  const cell = (name, note, title = name) => quantityCell(section, name, note, quantityTitle(title, "rollers"));
  return [
    cell("equivalent_load_N", message("rolling.peak", { satellite, pin, peak: written(section, "peak_load_N") })),
    cell("life_h", told("dynamic_rating_as_roller_N", "rating", "bearings.noRating")),
    cell("static_safety_factor", told("speed_rpm", "speed", "rolling.noSpeed"), "static_rating_safety"),
  ];
}
