/** The crankshaft: what is said and drawn of the service's answer. No DOM. */
import { formatQuantity } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";
import { crankDrawing } from "./along.js";
import { drawnDocument } from "./wanted.js";

export const figure = { id: "crank", section: "crankshaft", path: "/crankshaft/chart", body: drawnDocument };

const LETTERS = ["A", "B"];

export function cells({ bearings, balance }) {
  const reaction = (bearing, i) => ({
    label: message("crank.bearing", { letter: LETTERS[i] }),
    value: formatQuantity(bearing.peak_N, "N", 4),
    note: bearing.basic_life_h === undefined ? message("crank.equivalent", { load: formatQuantity(bearing.equivalent_N, "N", 4) })
      : message("crank.life", { life: formatQuantity(bearing.basic_life_h, "h", 3) }),
  });
  return [
    ...bearings.map(reaction),
    balance && {
      label: quantityTitle("unbalance_kg_mm"),
      value: formatQuantity(balance.unbalance_kg_mm, "kg·mm", 3),
      note: message("crank.left", { force: formatQuantity(balance.force_N, "N", 3), couple: formatQuantity(balance.couple_Nm, "N·m", 3) }),
    },
  ].filter(Boolean);
}

export const lists = { bearings: (i) => LETTERS[i], corrections: (i) => LETTERS[i] };

export const drawing = { create: crankDrawing, section: "crankshaft" };
