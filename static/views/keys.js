/** The list of keys, behind a button and the `?` key. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

export function createKeys() {
  const rows = ["apply", "step", "tabs", "help"].map((key) => message(`keys.${key}`));
  const button = element(html`
    <button type="button" class="keys-button" aria-haspopup="dialog" aria-keyshortcuts="?"
      aria-label="${message("page.keys")}" title="${message("page.keys")}">?</button>`);
  const dialog = element(html`
    <dialog class="keys card" aria-labelledby="keys-title">
      <h2 id="keys-title">${message("keys.title")}</h2>
      <dl>${rows.map(([key, does]) => html`<div><dt><kbd>${key}</kbd></dt><dd>${does}</dd></div>`)}</dl>
      <form method="dialog"><button>${message("keys.close")}</button></form>
    </dialog>`);
  document.body.append(dialog);
  button.addEventListener("click", () => dialog.showModal());
  document.addEventListener("keydown", (event) => {
    // No box of the form can hold a question mark, so the key is free everywhere.
    if (event.key !== "?" || event.ctrlKey || event.metaKey || dialog.open) return;
    event.preventDefault();
    dialog.showModal();
  });
  return { button };
}
