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

const opened = new Set(); // ids of what is open on this page, however often it is built anew
const AGAIN_MS = 4000; // until what could not be loaded is asked for again

/** An element that folds by itself; what stands in it is made, by `make()`, when it is opened. Returns what ends that. */
export function madeWhenOpened(details, id, make) {
  let view = null;
  let closed = false;
  async function fill() {
    view ??= make();
    const made = await view.catch(() => null);
    if (closed) return;
    if (made && !made.root.isConnected) details.append(made.root);
    if (made) return;
    view = null;
    setTimeout(() => details.open && !view && fill(), AGAIN_MS);
  }
  details.addEventListener("toggle", () => {
    opened[details.open ? "add" : "delete"](id);
    if (details.open) fill();
  });
  details.open = opened.has(id);
  return () => {
    closed = true;
    view?.then((made) => made.close(), () => {});
  };
}

/** The same of an element that folds by itself. */
export function remembering(details, id) {
  const known = parsed(lasting.getItem(KEPT), {})[id];
  if (known !== undefined) details.open = known;
  details.querySelector("summary").addEventListener("click", () => remember(id, !details.open));
  return details;
}
