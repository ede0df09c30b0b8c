/** What a verdict is made of: its cells, and the warnings of an answer. No DOM. */
import { quantityTitle } from "../messages/index.js";
import { quantityParts, shownDigits, unitOf, written } from "./format.js";

const IMPOSSIBLE = ["interference", "wall_holes", "pins_apart"];

/**
 * A cell, `{ label, value, unit, note, level }`; of a section without answer the label alone.
 * `about(section)` gives what an answered section says.
 */
export function cell(label, section, about) {
  return { label, ...(section && about(section)) };
}

/** A cell of a group beside the results: a quantity by its name among these values, – where it is not known. */
export function quantityCell(values, name, digits, note, label = quantityTitle(name)) {
  return { label, value: values[name] === undefined ? "–" : written(values, name, digits), note };
}

/** Value and unit of a quantity of a section, or of a part of it, with at most so many digits, and no more than the accuracy allows. */
export function stated(section, name, most, value = section[name]) {
  return quantityParts(value, unitOf(name), shownDigits(section.accuracy.relative_error, most));
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
