/** The warnings of an answer, and which of them say that a design cannot be built. No DOM. */

const IMPOSSIBLE = ["interference", "holes_overlap", "pins_overlap"];

/** Every warning of an answer and of its sections, once. */
export function warningsOf(answer) {
  const all = [answer, ...Object.values(answer)].flatMap((part) => part?.warnings ?? []);
  return [...new Map(all.map((warning) => [`${warning.code} ${warning.detail}`, warning])).values()];
}

/** How bad it is: "bad" for what cannot be built, else "warning". */
export function levelOf(code) {
  return IMPOSSIBLE.includes(code) ? "bad" : "warning";
}
