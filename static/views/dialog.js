/** A modal sheet with a title and a way out. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

export function createDialog({ id, title, content }) {
  const dialog = element(html`
    <dialog class="sheet card" id="${id}" aria-labelledby="${id}-title">
      <h2 id="${id}-title">${title}</h2>
      ${content}
      <form method="dialog"><button>${message("keys.close")}</button></form>
    </dialog>`);
  document.body.append(dialog);
  return dialog;
}
