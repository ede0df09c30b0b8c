/** What a section of the answer is between, asked for when it is opened: a list of the same quantities, each in a column. */
import { newestOnly } from "../lib/api.js";
import { flattened } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { message, quantityTitle } from "../messages/index.js";
import { problemText } from "../service_texts.js";
import { following } from "../store.js";
import { listMarkup } from "./parts.js";

/** `bounds` says of which answers there is one (`of`), what is asked, and which of its quantities are `shown`. */
export function createBounds({ bounds: { path, list, of, body, shown: names, nameOf }, client, titles }) {
  const root = element(html`<details class="more bounds" hidden><summary>${quantityTitle(list)}</summary><div></div></details>`);
  const host = root.querySelector("div");
  const newest = newestOnly();
  let latest = null; // the results on the screen
  let asked = null; // those that it is of

  async function ask() {
    if (root.hidden || !root.open || asked === latest) return;
    asked = latest;
    const { filled, answer, requests } = latest;
    const { answer: found, problem, superseded } = await newest.ask((signal) => client.post(path, body(filled, answer, requests), { signal }));
    if (superseded) return;
    if (problem) {
      asked = null; // opened again, it asks again
      fill(host, html`<p class="state bad">${problemText(problem, titles)}</p>`);
      return;
    }
    const records = found[list].map((one) => Object.fromEntries(flattened(one).filter(([name]) => names.includes(name))));
    fill(host, listMarkup(list, records, (i) => nameOf(found[list][i])));
  }

  root.addEventListener("toggle", ask);
  return {
    root,
    update: following(({ shown }) => [shown], ({ shown }) => {
      latest = shown;
      newest.cancel();
      asked = null;
      root.hidden = !shown || !of(shown.answer, shown.filled);
      if (root.hidden) root.open = false;
      fill(host, html`<p class="state">${message("state.computing")}</p>`);
      ask();
    }),
    close: newest.cancel,
  };
}
