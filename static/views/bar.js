/** The bar over the page: what the design is called, whether the address has it, and the tools, each an icon and a word. */
import { clicks, element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

const ICONS = {
  new: "M8 3v10M3 8h10",
  undo: "M6 3 3 6l3 3M3 6h6.5a3.5 3.5 0 0 1 0 7H6",
  redo: "m10 3 3 3-3 3M13 6H6.5a3.5 3.5 0 0 0 0 7H10",
  compare: "M2.5 3h4.5v10H2.5zM9 3h4.5v10H9z",
  share: "M6.5 9.5l3-3M7.5 4 9 2.6a3 3 0 0 1 4.3 4.3L12 8.5M8.5 12 7 13.4a3 3 0 0 1-4.3-4.3L4 7.5",
  export: "M8 2.5v7.5M5 7l3 3 3-3M3 13.5h10",
  settings: "M2.5 5h3M8.5 5h5M2.5 11h6M11.5 11h2M5.5 3.5h3v3h-3zM8.5 9.5h3v3h-3z",
  help: "M5.8 6a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.7M8 12v.6",
};
const DIALOGS = ["new", "export", "settings", "help"];
const KEYS = { undo: "Control+Z", redo: "Control+Y", compare: "Alt+K", help: "?" };

/** `on.named(text)` tells what the design is called from now on, `on[tool]()` that a tool is wanted; those of `idle` wait until they are set. */
export function createBar({ naming, tools, idle, on }) {
  const buttons = new Map(Object.entries(ICONS).map(([id, lines]) => [id, element(html`
    <button type="button" class="tool" data-tool="${id}" title="${message(`bar.${id}Why`)}"${KEYS[id] && html` aria-keyshortcuts="${KEYS[id]}"`}
      ${DIALOGS.includes(id) && html`aria-haspopup="dialog"`} ${idle.includes(id) && html`disabled`}>
      <svg class="icon" viewBox="0 0 16 16" aria-hidden="true"><path d="${lines}"/></svg><span>${message(`bar.${id}`)}</span></button>`)]));
  tools.append(...buttons.values());
  clicks(tools, "tool", (id) => on[id]?.());
  naming.append(
    element(html`<input class="free-text" data-label="title" maxlength="80" autocomplete="off" spellcheck="false" aria-label="${message("bar.name")}">`),
    element(html`<span title="${message("bar.savedWhy")}">${message("bar.saved")}</span>`),
  );
  const [box] = naming.children;
  box.addEventListener("input", () => on.named(box.value));
  return {
    tool: (id) => buttons.get(id),
    /** `usual` stands where there is no name, `why` says where that is from. */
    name(text, usual, why) {
      if (box.value !== text) box.value = text;
      Object.assign(box, { placeholder: usual, title: why });
    },
    saved(is) {
      naming.dataset.saved = String(is);
    },
  };
}
