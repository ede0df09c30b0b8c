/** What a verdict is made of: its cells, and the warnings of an answer. No DOM. */
import { quantityParts, shownDigits } from "./format.js";

const IMPOSSIBLE = ["interference", "wall_holes", "pins_apart"];

/**
 * A cell, `{ label, value, unit, note, level }`; of a section without answer the label alone.
 * `about(section)` gives what an answered section says.
 */
export function cell(label, section, about) {
  return { label, ...(section && about(section)) };
}

/** Value and unit with at most so many digits, and no more than the section's accuracy allows. */
export function stated({ accuracy }, value, unit, most) {
  return quantityParts(value, unit, shownDigits(accuracy.relative_error, most));
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
