/** Results that fold: a button in the heading, and what is open stays so from visit to visit. */
import { element, html } from "../lib/html.js";
import { lasting, parsed } from "../lib/storage.js";

const KEPT = "folds";

function remember(id, open) {
  lasting.setItem(KEPT, JSON.stringify({ ...parsed(lasting.getItem(KEPT), {}), [id]: open }));
}

/** A card whose first child has its heading folds to that; `id` is that by which it is remembered, `open` how it starts. */
export function foldable(root, id, { open = false } = {}) {
  const heading = root.querySelector("h2");
  const button = element(html`<button type="button" class="folding"></button>`);
  button.append(...heading.childNodes);
  heading.append(button);
  const fold = {
    set(wanted, kept = true) {
      root.dataset.folded = String(!wanted);
      button.setAttribute("aria-expanded", String(wanted));
      if (kept) remember(id, wanted);
    },
    open: () => root.dataset.folded === "false" || fold.set(true),
  };
  button.addEventListener("click", () => fold.set(root.dataset.folded === "true"));
  fold.set(parsed(lasting.getItem(KEPT), {})[id] ?? open, false);
  return fold;
}

/** The same of an element that folds by itself. */
export function remembering(details, id) {
  const known = parsed(lasting.getItem(KEPT), {})[id];
  if (known !== undefined) details.open = known;
  details.querySelector("summary").addEventListener("click", () => remember(id, !details.open));
  return details;
}
