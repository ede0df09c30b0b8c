/** Rolling bearings as rollers on the pins: what is said of the service's answer. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";

export const path = "/crank-planetary";

export function cells({ equivalent_load_N: load, peak_load_N: peak, life_h: life, dynamic_rating_as_roller_N: rating, static_safety_factor: safety, speed_rpm: speed, satellite, pin }) {
  const title = (name) => quantityTitle(name, "rollers");
  return [
    { label: title("equivalent_load_N"), value: formatQuantity(load, "N", 4), note: message("rolling.peak", { satellite, pin, peak: formatQuantity(peak, "N", 4) }) },
    {
      label: title("life_h"),
      value: life === undefined ? "–" : formatQuantity(life, "h", 3),
      note: rating === undefined ? message("bearings.noRating") : message("rolling.rating", { rating: formatQuantity(rating, "N", 4) }),
    },
    {
      label: title("static_rating_safety"),
      value: safety === undefined ? "–" : formatNumber(safety, 3),
      note: speed === undefined ? message("rolling.noSpeed") : message("rolling.speed", { speed: formatQuantity(speed, "rpm", 4) }),
    },
  ];
}
