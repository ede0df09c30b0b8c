/**
 * Where a screen has no room for everything: below 1280 px the inputs fold to a rail, below 800 px one part is in sight
 * at a time, chosen at the foot. What is in sight stands as `data-place` at the host; wider screens pass it over.
 */
import { clicks, element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

const PARTS = ["inputs", "shown", "answer", "rest"];

export function createPlaces({ host, signal }) {
  const root = element(html`<nav class="places" aria-label="${message("places.label")}">${PARTS.map((part) => html`
    <button type="button" data-place="${part}">${message(`places.${part}`)}</button>`)}</nav>`);
  const show = (part) => {
    host.dataset.place = part;
    for (const button of root.children) button.setAttribute("aria-pressed", String(button.dataset.place === part));
  };
  clicks(root, "place", (place) => show(place === "inputs" && host.dataset.place === place ? "shown" : place));
  document.addEventListener("keydown", ({ key }) => {
    if (key === "Escape" && host.dataset.place === "inputs" && !document.querySelector("dialog[open], :popover-open")) show("shown");
  }, { signal });
  show("shown");
  return { root, show };
}
