/** A figure or a drawing over the whole screen, larger in its type too: for a projector. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

/** Show a card with all that it can do; Escape and a button put it back, and the focus where it was. */
export function enlarge(card) {
  const before = document.activeElement;
  const dialog = element(html`<dialog class="large" aria-label="${card.querySelector("h2").textContent}">
    <form method="dialog"><button class="toggle">${message("keys.close")}</button></form></dialog>`);
  const place = element(html`<div></div>`);
  place.style.height = `${card.offsetHeight}px`; // nothing moves meanwhile
  const host = card.closest(".workbench");
  card.before(place);
  dialog.prepend(card);
  host.append(dialog);
  dialog.showModal();
  dialog.querySelector("form button").focus();
  card.dispatchEvent(new Event("resized"));
  dialog.addEventListener("close", () => {
    place.replaceWith(card);
    dialog.remove();
    card.dispatchEvent(new Event("resized"));
    before?.focus({ preventScroll: true });
  });
}
