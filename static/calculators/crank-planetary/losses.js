/** Friction and wear: what is said of the service's answer. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";
import { drawnDocument } from "./wanted.js";

export const figure = { id: "losses", section: "output_efficiency", path: "/output-efficiency/chart", body: drawnDocument, height: 420 };

export function cells(section) {
  const { efficiency, min_efficiency: least, mean_loss_W: loss, output_power_W: power, peak_pv_MPa_m_per_s: pv, sliding_speed_m_per_s: speed } = section;
  return [
    { label: quantityTitle("efficiency"), value: formatNumber(efficiency, 4), note: message("losses.least", { value: formatNumber(least, 4) }) },
    { label: quantityTitle("mean_loss_W"), value: formatQuantity(loss, "W", 4), note: message("losses.of", { power: formatQuantity(power, "W", 4) }) },
    { label: quantityTitle("peak_pv_MPa_m_per_s"), value: formatQuantity(pv, "MPa·m/s", 3), note: message("losses.at", { speed: formatQuantity(speed, "m/s", 3) }) },
  ];
}
