/** A small menu at a button: arrow keys move in it, Escape closes it. */
import { clicks, element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

/** `acts` are what it offers; `on(act, about)` tells of the one that is chosen. */
export function createMenu({ acts, on }) {
  const root = element(html`<div class="menu" popover role="menu" aria-label="${message("menu.label")}">${acts.map((act) => html`
    <button type="button" role="menuitem" data-act="${act}">${message(`menu.${act}`)}</button>`)}</div>`);
  const items = [...root.children];
  let about = null;
  clicks(root, "act", (act) => {
    root.hidePopover();
    on(act, about);
  });
  root.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    items[(items.indexOf(document.activeElement) + by + items.length) % items.length].focus();
  });
  return {
    root,
    /** Show it at a button. */
    open(button, next) {
      about = next;
      root.showPopover();
      const { left, bottom, top } = button.getBoundingClientRect();
      const { offsetHeight: height, offsetWidth: width } = root;
      root.style.left = `${Math.min(left, innerWidth - width - 8)}px`;
      root.style.top = `${bottom + height > innerHeight ? top - height : bottom}px`;
      items[0].focus();
    },
  };
}
