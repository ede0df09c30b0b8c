/** Help behind a button and the `?` key: the keys, what every symbol of the open calculator means, what its model leaves out. */
import { fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { createDialog, symbolMarkup } from "./parts.js";

/** Opened by `button` too. `about()` gives of the open calculator `{ symbols: [[symbol, title, help]], neglected: [text] }`, or null. */
export function createKeys({ button, about }) {
  const rows = ["apply", "step", "undo", "keep", "enlarge", "print", "tabs", "help"].map((key) => message(`keys.${key}`));
  const dialog = createDialog({
    id: "keys",
    title: message("bar.help"),
    content: html`<dl>${rows.map(({ keys, does }) => html`<div><dt><kbd>${keys}</kbd></dt><dd>${does}</dd></div>`)}</dl><div class="about"></div>`,
  });
  const host = dialog.querySelector(".about");

  function show() {
    const { symbols, neglected } = about() ?? { symbols: [], neglected: [] };
    fill(host, symbols.length > 0 ? html`<h3>${message("keys.symbols")}</h3>
      <dl>${symbols.map(([symbol, title, help]) => html`<div><dt>${symbolMarkup(symbol)}</dt><dd>${title}${help && html`<br><span class="note">${help}</span>`}</dd></div>`)}</dl>
      <h3>${message("accuracy.model")}</h3><ul>${neglected.map((text) => html`<li>${text}</li>`)}</ul>` : html``);
    dialog.showModal();
  }

  button.addEventListener("click", show);
  document.addEventListener("keydown", (event) => {
    // No box of the form can hold a question mark, so the key is free everywhere but in free texts.
    if (event.key !== "?" || event.ctrlKey || event.metaKey || event.target.closest?.(".free-text, dialog")) return;
    event.preventDefault();
    show();
  });
}
