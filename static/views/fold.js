/** What folds; what is open stays so from visit to visit. */
import { element, html } from "../lib/html.js";
import { lasting, parsed } from "../lib/storage.js";

const KEPT = "folds";

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

/** An element that folds by itself, remembered by that `id`. */
export function remembering(details, id) {
  const known = parsed(lasting.getItem(KEPT), {})[id];
  if (known !== undefined) details.open = known;
  details.querySelector("summary").addEventListener("click", () =>
    lasting.setItem(KEPT, JSON.stringify({ ...parsed(lasting.getItem(KEPT), {}), [id]: !details.open })));
  return details;
}
