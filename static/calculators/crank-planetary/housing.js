/** Housing and carrier: what is said of the service's answer. No DOM. */
import { quantityCell } from "../../lib/verdict.js";
import { message } from "../../messages/index.js";

export const path = "/crank-planetary";

export function cells(section) {
  const [around, near, far] = section.of.map((part) => message(`option.${part}`));
  return [
    quantityCell(section, "outer_diameter_mm", message("housing.around", { around })),
    quantityCell(section, "length_mm", message("housing.along", { near, far })),
  ];
}
