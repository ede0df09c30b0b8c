/** The numbers of an answer, one by one. No DOM. */
import { unitOf } from "./format.js";

const ASIDE = ["accuracy", "warnings", "curves"];

/**
 * Every value of an answer's sections as `{ section, name, value, unit }`, in canonical units;
 * parts of lists and objects by their index or key: `force_N[0]`, `peak_pair.pin`. The warnings of
 * the whole answer stand last, by their codes.
 */
export function flatValues(answer) {
  const found = [];
  const visit = (section, name, value, unit) => {
    if (Array.isArray(value)) {
      value.forEach((one, i) => visit(section, `${name}[${i}]`, one, unit));
    } else if (value !== null && typeof value === "object") {
      for (const [key, one] of Object.entries(value)) visit(section, `${name}.${key}`, one, unitOf(key) || unit);
    } else {
      found.push({ section, name, value, unit });
    }
  };
  for (const [section, values] of Object.entries({ ...answer, warnings: undefined })) {
    for (const [name, value] of Object.entries(values ?? {})) {
      if (!ASIDE.includes(name)) visit(section, name, value, unitOf(name));
    }
  }
  for (const { code, detail } of answer.warnings ?? []) found.push({ section: "warnings", name: code, value: detail, unit: "" });
  return found;
}
