/** What the outline of the inputs says in little room: the line of a section, and a field's name in short. No DOM. */
import { ALL, formatNumber, formatQuantity, tidy } from "./format.js";
import { message, said } from "../messages/index.js";
import { DIAMETER, shownValue } from "./units.js";

const LONGEST = 26; // letters of a name

const length = (name) => name.replaceAll("\u00ad", "").length;

/** A name as short as it has to be: words of it give way to shorter ones, in their order. */
export const shortOf = (name) => message("form.short").split("; ").map((pair) => pair.split("="))
  .reduce((shorter, [long, short]) => (length(shorter) > LONGEST ? shorter.replace(long, short) : shorter), name);

/** A number as one says it: a radius as its diameter, a length without its unit, a name without what stands in brackets. */
function valueText({ name, unit }, value) {
  if (typeof value === "string") return (said("materials", value) ?? message("option")[value] ?? value).split(" (")[0];
  const number = (times = 1) => formatNumber(tidy(times * shownValue(value, unit === DIAMETER ? "mm" : unit)));
  const most = name.startsWith("max_") ? "≤ " : "";
  if (name.endsWith("_radius_mm")) return `Ø${number(2)}`;
  if (name.endsWith("diameter_mm")) return `${most}Ø${number()}`;
  if (/ratio(_u12)?$/.test(name)) return `${number()}:1`;
  return most + (unit === "mm" ? number() : formatQuantity(value, unit, ALL));
}

/**
 * The values of a section as one says them, "8 pins Ø16 on Ø76, H7/f7": of `line`, paths of fields with a comma where one is
 * said, those that have a value other than 0; `valueOf(path)` gives the field that is shown there with its value.
 */
export function lineOf(line, valueOf) {
  const piece = (path) => {
    const [field, value] = valueOf(path) || [];
    if (!value || !["number", "string"].includes(typeof value)) return "";
    const text = valueText(field, value);
    if (message("line")[field.name]) return message(`line.${field.name}`, { count: value, value: text });
    return ["", "mm"].includes(field.unit) && /^\d/.test(text) && !text.endsWith(":1") ? `${field.symbol.replace("_", "")} ${text}` : text;
  };
  return line.split(", ").map((part) => part.split(" ").map(piece).filter(Boolean).join(" ")).filter(Boolean).join(message("form.between"));
}
