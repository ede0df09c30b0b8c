/** What a link or a stored design says that does not hold here: unknown parts, an older version, a verdict that has moved. */
import { wordIn } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { following } from "../store.js";

/** `on.closed()` tells that it has been read. */
export function createNotice({ calculator, on }) {
  const root = element(html`<div class="notice card" role="status" hidden><div></div>
    <button type="button" class="toggle" aria-label="${message("keys.close")}">×</button></div>`);
  const host = root.querySelector("div");
  root.querySelector("button").addEventListener("click", () => on.closed());
  let moved = null; // the words of the verdict that was claimed and of that found, while the claim stands

  function movedText({ typed, verdict }, shown) {
    const now = shown && shown.typed === typed ? wordIn(calculator, shown.answer) : undefined;
    if (!message("verdictWord")[verdict] || !now || now === verdict) return null;
    return message("notice.moved", { was: message(`verdictWord.${verdict}`), now: message(`verdictWord.${now}`) });
  }

  return {
    root,
    update: following(({ claim, shown }) => [claim, shown], ({ claim, shown }) => {
      if (claim !== moved?.claim) moved = { claim, text: null };
      moved.text ??= movedText(claim, shown);
      const { unknown = [], older } = claim;
      const texts = [
        unknown.length > 0 && message("page.unknown", { names: unknown.join(", ") }), older && message("notice.older"), moved.text,
      ].filter(Boolean);
      root.hidden = texts.length === 0;
      fill(host, html`${texts.map((text) => html`<p>${text}</p>`)}`);
    }),
  };
}
