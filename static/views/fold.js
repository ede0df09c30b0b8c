/** What folds; what is open stays so from visit to visit. */
import { lasting, parsed } from "../lib/storage.js";

const KEPT = "folds";

/** An element that folds by itself, remembered by that `id`. */
export function remembering(details, id) {
  const known = parsed(lasting.getItem(KEPT), {})[id];
  if (known !== undefined) details.open = known;
  details.querySelector("summary").addEventListener("click", () =>
    lasting.setItem(KEPT, JSON.stringify({ ...parsed(lasting.getItem(KEPT), {}), [id]: !details.open })));
  return details;
}
