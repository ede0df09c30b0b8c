/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatNumber, formatQuantity, quantityParts } from "../../lib/format.js";
import { message } from "../../messages/index.js";

const say = (key, values) => message(`words.${key}`, values);

/** Sentences `[level, text]`. */
export function sentences({ contact_line: line, meshing_load: load, shaft_deflection: shaft }, { input }) {
  const arms = (line?.lines ?? []).flatMap(({ phi_min_deg: from, phi_max_deg: to }) => [from, to])
    .map((phi) => Math.abs(Math.sin((phi * Math.PI) / 180)));
  return [
    line && ["good", say("mesh", { count: line.lines.length, length: formatQuantity(line.total_length_mm, "mm") })],
    load && ["", say("evenLoad", { ratio: formatNumber(Math.max(...arms) / Math.min(...arms), 3) })],
    shaft && ["", say("bends", {
      deflection: formatQuantity(shaft.deflection_C_mm.total, "mm", 3),
      part: quantityParts(
        Math.round((input.bearing_distance_mm + input.overhang_mm) / shaft.deflection_C_mm.total), "", 3,
      ).value,
    })],
  ];
}
