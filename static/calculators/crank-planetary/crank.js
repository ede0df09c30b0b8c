/** The crankshaft: what is said and drawn of the service's answer. No DOM. */
import { written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message } from "../../messages/index.js";
import { crankDrawing } from "./along.js";
import { drawnDocument } from "./wanted.js";

export const figure = { id: "crank", section: "crankshaft", path: "/crankshaft/chart", body: drawnDocument };

const LETTERS = ["A", "B"];

export function cells({ bearings, balance }) {
  const lasts = (bearing) => (bearing.basic_life_h === undefined ? message("crank.equivalent", { load: written(bearing, "equivalent_N") })
    : message("crank.life", { life: written(bearing, "basic_life_h") }));
  return [
    ...bearings.map((bearing, i) => quantityCell(bearing, "peak_N", lasts(bearing), message("crank.bearing", { letter: LETTERS[i] }))),
    balance && quantityCell(balance, "unbalance_kg_mm", message("crank.left", {
      force: written(balance, "force_N"), couple: written(balance, "couple_Nm"),
    })),
  ].filter(Boolean);
}

export const lists = { bearings: (i) => LETTERS[i], corrections: (i) => LETTERS[i] };

export const drawing = { create: crankDrawing, section: "crankshaft" };
