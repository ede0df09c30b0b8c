/**
 * What stands under the drawing, a tab each: only what is open is asked for. On a low screen, or where it is `tall`, the
 * drawing is the first of them, so that it and a figure share one box.
 */
import { clicks, element, html } from "../lib/html.js";
import { lasting } from "../lib/storage.js";
import { message } from "../messages/index.js";
import { arrows } from "./tabs.js";

const LOW = matchMedia("(height < 800px)");
const DRAWING = "drawing";

/** `id` is the calculator's, by which the open tab is remembered; `on.opened(tab)` tells of each that opens. */
export function createPanels({ id, drawing, tall = false, on }) {
  const shares = () => tall || LOW.matches;
  const kept = `tab-${id}`;
  const root = element(html`<div class="shown">
    <div class="strip tabs" role="tablist" aria-label="${message("panels.label")}"></div><div class="besides"></div></div>`);
  const [strip, besides] = root.children;
  const all = new Map(); // by name, `{ tab, panel, offered }`
  let wished = lasting.getItem(kept);
  let open = null;

  /** Show the tab that is wanted. */
  function show() {
    const names = [...all].filter(([, { offered }]) => offered).map(([name]) => name);
    const next = names.includes(wished) ? wished : names.find((name) => name !== DRAWING || shares());
    for (const [name, { tab, panel, offered }] of all) {
      tab.hidden = !offered || (name === DRAWING && !shares());
      tab.setAttribute("aria-selected", String(name === next));
      tab.tabIndex = name === next ? 0 : -1;
      panel.hidden = name !== next && (name !== DRAWING || shares());
    }
    if (next === open) return;
    open = next;
    on.opened(open);
  }

  /** A tab; one that is not `offered` is hidden until it is. */
  function add(name, title, content, { offered = true, beside = false } = {}) {
    const tab = element(html`<button type="button" role="tab" id="tab-of-${name}" data-tab="${name}" aria-controls="panel-${name}">${title}</button>`);
    const panel = element(html`<div class="panel" role="tabpanel" tabindex="0" id="panel-${name}" aria-labelledby="tab-of-${name}"></div>`);
    panel.append(content);
    strip.append(tab);
    if (beside) besides.append(panel);
    else besides.before(panel);
    all.set(name, { tab, panel, offered });
    show();
  }

  /** Open a tab, remembered where the user has `chosen` it. */
  function choose(name, chosen = true) {
    wished = name;
    if (chosen) lasting.setItem(kept, name);
    show();
    all.get(open)?.tab.scrollIntoView({ block: "nearest", inline: "nearest" });
  }
  clicks(strip, "tab", (name) => choose(name));
  arrows(strip);

  /** The drawing above the tabs, or as the first of them. */
  function place() {
    const { panel } = all.get(DRAWING);
    if (shares()) strip.after(panel);
    else root.prepend(panel);
    if (!shares() && wished === DRAWING) wished = null;
    show();
  }
  add(DRAWING, message("panels.drawing"), drawing.root);
  place();
  LOW.addEventListener("change", place);

  return {
    root,
    add,
    open: choose,
    /** Whether there is something behind a tab. */
    offer(name, offered) {
      if (all.get(name).offered === offered) return;
      all.get(name).offered = offered;
      show();
    },
    close: () => LOW.removeEventListener("change", place),
  };
}
