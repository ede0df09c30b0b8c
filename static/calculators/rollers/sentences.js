/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message } from "../../messages/index.js";

const say = (key, values) => message(`words.${key}`, values);

/** Sentences `[level, text]`. */
export function sentences({ roller_strength: section }, { input }) {
  if (!section) return [];
  const { loaded_rollers: loaded, load_nonuniformity: ratio, relative_position_error: delta } = section;
  const all = section.forces_N.length;
  const tolerance = input.position_tolerance_mm;
  return [
    [loaded === all ? "good" : "warning", say(loaded === all ? "allCarry" : "someCarry", {
      loaded, all, ratio: formatNumber(ratio, 4),
    })],
    tolerance > 0 && all > 1 && ["", say("tolerance", {
      limit: formatQuantity((tolerance * all) / 4 / delta, "mm", 3),
      tolerance: formatQuantity(tolerance, "mm", 3),
    })],
  ];
}
