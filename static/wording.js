/** The service's words in the form's: API names become titles, values get their units. No DOM. */
import { formatNumber, formatQuantity, unitOf } from "./format.js";
import { translated } from "./messages/index.js";

const NAME = /\b([a-z]\w*_\w+|[a-z]{4,})(?: = (-?[\d.]+(?:e[+-]?\d+)?))?/gi;

/** `titles` maps API field names to titles; a sentence begins with a capital. */
export function inWords(detail, titles) {
  const text = translated(detail).replace(NAME, (whole, name, value) => {
    const title = titles.get(name);
    if (title === undefined) return whole;
    const words = title.charAt(0).toLowerCase() + title.slice(1);
    if (value === undefined) return words;
    const unit = unitOf(name);
    return `${words} ${unit ? formatQuantity(Number(value), unit) : formatNumber(Number(value))}`;
  });
  return text.charAt(0).toUpperCase() + text.slice(1);
}
