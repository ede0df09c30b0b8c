/** The list of keys, behind a button and the `?` key. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { createDialog } from "./parts.js";

export function createKeys() {
  const rows = ["apply", "step", "undo", "tabs", "help"].map((key) => message(`keys.${key}`));
  const button = element(html`
    <button type="button" class="tool" aria-haspopup="dialog" aria-keyshortcuts="?"
      aria-label="${message("page.keys")}" title="${message("page.keys")}">?</button>`);
  const dialog = createDialog({
    id: "keys",
    title: message("keys.title"),
    content: html`<dl>${rows.map(([key, does]) => html`<div><dt><kbd>${key}</kbd></dt><dd>${does}</dd></div>`)}</dl>`,
  });
  button.addEventListener("click", () => dialog.showModal());
  document.addEventListener("keydown", (event) => {
    // No box of the form can hold a question mark, so the key is free everywhere but in free texts.
    if (event.key !== "?" || event.ctrlKey || event.metaKey || event.target.closest?.(".free-text, dialog")) return;
    event.preventDefault();
    dialog.showModal();
  });
  return { button };
}
