/** Mass and inertia: what is said of the service's answer. No DOM. */
import { quantityCell } from "../../lib/verdict.js";
import { message } from "../../messages/index.js";
import { reasonText } from "../../service_texts.js";

/** Parts that have their names from the sizes of housing and carrier. */
const NAMED = ["housing", "carrier", "second_carrier", "bearing_a", "bearing_b"];

export const path = "/crank-planetary";

/** What is said of a part: how many there are and whether its shape is assumed, or why its mass is not known. */
function noteOf({ count, estimate, reason }) {
  if (reason) return reasonText(reason);
  return [message("mass.pieces", { count }), estimate && message("mass.estimate")].filter(Boolean).join("; ");
}

export function cells(section) {
  return [
    quantityCell(section, "mass_kg", message("mass.of")),
    quantityCell(section, "inertia_kg_m2"),
    ...section.parts.map((part) => quantityCell(part, "mass_kg", noteOf(part), message(`${NAMED.includes(part.code) ? "option" : "mass"}.${part.code}`))),
  ];
}
