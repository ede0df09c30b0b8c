/** A symbol as the formulas write it: `r_in` has its index set low. */
import { html } from "../lib/html.js";

export function symbolMarkup(symbol) {
  const parts = symbol.split(/_([\p{L}\p{N}]+)/u);
  return html`<var class="symbol">${parts.map((part, i) => (i % 2 ? html`<sub>${part}</sub>` : part))}</var>`;
}
