/** What a verdict is made of: its cells, and the warnings of an answer. No DOM. */
import { quantityTitle } from "../messages/index.js";
import { ALL, digitsOf, formatQuantity, quantityParts, unitOf, written } from "./format.js";

const IMPOSSIBLE = ["interference", "wall_holes", "pins_apart"];

/**
 * A cell, `{ label, value, exact, unit, note, level }`; of a section without answer the label alone.
 * `about(section)` gives what an answered section says.
 */
export function cell(label, section, about) {
  return { label, ...(section && about(section)) };
}

/** A cell of a quantity of a section by its name; `note(section)` says more of it. */
export const statedCell = (section, name, note, label = quantityTitle(name)) =>
  cell(label, section, () => ({ ...stated(section, name), note: note(section) }));

/** A cell of a group beside the results: a quantity by its name among these values, – where it is not known. */
export function quantityCell(values, name, note, label = quantityTitle(name)) {
  const { [name]: value } = values;
  if (value === undefined) return { label, value: "–", note };
  return { label, value: written(values, name), exact: formatQuantity(value, unitOf(name), ALL), note };
}

/** Value and unit of a quantity of a section, or of a part of it, as it is shown and with all its digits. */
export function stated(section, name, value = section[name]) {
  return { ...quantityParts(value, unitOf(name), digitsOf(name, section.accuracy)), exact: formatQuantity(value, unitOf(name), ALL) };
}

/** Every warning of an answer and of its sections, once. */
export function warningsOf(answer) {
  const all = [answer, ...Object.values(answer)].flatMap((part) => part?.warnings ?? []);
  return [...new Map(all.map((warning) => [`${warning.code} ${warning.detail}`, warning])).values()];
}

/** Codes that an answer warns of, and those by which its checks could not be made or cannot be kept. */
export function codesOf(answer, checks = []) {
  const said = checks.flatMap(({ code, impossible, reason }) => reason?.code ?? (impossible ? code : []));
  return [...new Set([...warningsOf(answer).map(({ code }) => code), ...said])];
}

/** How bad it is: "bad" for what cannot be built, else "warning". */
export function levelOf(code) {
  return IMPOSSIBLE.includes(code) ? "bad" : "warning";
}
