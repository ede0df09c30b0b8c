/** Friction and wear: what is said of the service's answer. No DOM. */
import { written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message } from "../../messages/index.js";
import { drawnDocument } from "./wanted.js";

export const figure = { id: "losses", section: "output_efficiency", path: "/output-efficiency/chart", body: drawnDocument, height: 420 };

export function cells(section) {
  return [
    quantityCell(section, "efficiency", message("losses.least", { value: written(section, "min_efficiency") })),
    quantityCell(section, "mean_loss_W", message("losses.of", { power: written(section, "output_power_W") })),
    quantityCell(section, "peak_pv_MPa_m_per_s", message("losses.at", { speed: written(section, "sliding_speed_m_per_s") })),
  ];
}
