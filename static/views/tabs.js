/** The calculators as tabs: arrow keys and Home/End move among them, Alt+1… opens one from anywhere. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

/** Arrow keys, Home and End open the tabs of a list by their own click. */
export function arrows(host) {
  host.addEventListener("keydown", (event) => {
    const tabs = [...host.querySelectorAll("[role=tab]:not([hidden])")];
    const here = tabs.indexOf(document.activeElement);
    const to = { ArrowRight: here + 1, ArrowLeft: here - 1, Home: 0, End: tabs.length - 1 }[event.key];
    if (here < 0 || to === undefined) return;
    event.preventDefault();
    const next = tabs[(to + tabs.length) % tabs.length];
    next.focus();
    next.click();
  });
}

export function createTabs({ host, panel, ids, on }) {
  const buttons = ids.map((id, i) => element(html`
    <button type="button" role="tab" id="tab-${id}" aria-controls="${panel.id}"
      aria-keyshortcuts="Alt+${i + 1}">${message(`calculator.${id}`)}</button>`));
  host.setAttribute("aria-label", message("page.calculators"));
  host.append(...buttons);
  let current = null;

  function choose(id) {
    if (id !== current) on.opened(id);
  }

  host.addEventListener("click", (event) => {
    const button = event.target.closest("[role=tab]");
    if (button) choose(ids[buttons.indexOf(button)]);
  });
  arrows(host);
  document.addEventListener("keydown", (event) => {
    const number = /^Digit([1-9])$/.exec(event.code)?.[1];
    if (!event.altKey || event.ctrlKey || event.metaKey || !number || number > ids.length) return;
    event.preventDefault();
    buttons[number - 1].focus();
    choose(ids[number - 1]);
  });
  return {
    /** Show which is open; none after a failure, so that any may be tried again. */
    setOpen(open) {
      current = open;
      if (open === null) return;
      ids.forEach((id, i) => {
        buttons[i].setAttribute("aria-selected", String(id === open));
        buttons[i].tabIndex = id === open ? 0 : -1;
      });
      // On a narrow screen the tabs scroll: the open one is brought into sight.
      buttons[ids.indexOf(open)].scrollIntoView({ block: "nearest", inline: "nearest" });
      panel.setAttribute("aria-labelledby", `tab-${open}`);
    },
  };
}
