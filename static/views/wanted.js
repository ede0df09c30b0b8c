/**
 * The groups that are off until wanted, and those that show by themselves: a tab each, once they are on; what is shown
 * there is loaded then, and what is asked for it alone when its tab is open.
 */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { besided, wants } from "../store.js";

/**
 * The rest are `{ store, inputs, client, titles, calculations }` for the views. What starts a group that is run stands with its fields, in `inputs`.
 */
export function createWanted({ calculator, panels, ...parts }) {
  const all = [...calculator.beside ?? [], ...calculator.wanted ?? []].filter(({ load }) => load);
  const groups = all.map(({ id, section, load, shows = (state) => wants(state, id), urgent = () => false }) => {
    const title = message(section ? `section.${section}` : `${id}.title`);
    const place = element(html`<section class="beside-card" data-wanted="${id}" aria-label="${title}"><h2>${title}</h2></section>`);
    panels.add(id, message(`tab.${id}`), place, { offered: false, beside: true });
    return { id, section, load, shows, urgent, place, loading: null, asking: null, view: null, urged: false };
  });
  let closed = false;

  async function open(group) {
    const loading = [group.load(), group.section ? {} : import("../besides.js")];
    const [[logic, { createView }], { createBeside }] = await Promise.all(loading);
    if (closed) return;
    const shows = (state) => group.shows(state) && group.id === state.tab;
    group.asking = createBeside?.({ ...parts, ...group, logic, shows });
    group.view = createView({ ...parts, ...group, logic, open: () => panels.open(group.id) });
    group.place.append(group.view.root);
    if (group.view.controls) parts.inputs.querySelector(`[data-group="${group.id}"] .wanted-fields`).append(group.view.controls);
    parts.store.apply(besided, group.id, {});
  }

  function update(state) {
    for (const group of groups) {
      const on = group.shows(state);
      panels.offer(group.id, on);
      const urges = on && group.urgent(state);
      if (urges && !group.urged) panels.open(group.id, false);
      group.urged = urges;
      if (on) group.loading ??= open(group);
      group.asking?.update(state);
      if (on) group.view?.update(state);
    }
  }

  return {
    update,
    close() {
      closed = true;
      for (const { asking, view } of groups) {
        asking?.cancel();
        view?.close();
      }
    },
  };
}
