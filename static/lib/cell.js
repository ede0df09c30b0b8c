/** The cells of a verdict: `{ label, value, unit, note, level }`, of a section without answer the label alone. */
import { message } from "../messages/index.js";
import { quantityParts, shownDigits } from "./format.js";

/** `about(section)` gives what an answered section says. */
export function cell(name, section, about) {
  return { label: message(`verdict.${name}`), ...(section && about(section)) };
}

/** Value and unit with at most so many digits, and no more than the section's accuracy allows. */
export function stated({ accuracy }, value, unit, most) {
  return quantityParts(value, unit, shownDigits(accuracy.relative_error, most));
}
