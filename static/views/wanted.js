/**
 * The places of the groups that are off until wanted, and of those that show by themselves: hidden until then; what is
 * shown there is loaded when one is.
 */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { besided, wants } from "../store.js";
import { foldable } from "./fold.js";

/**
 * The rest are `{ store, inputs, client, titles, figures, calculations }` for the views; a figure of theirs joins `figures`,
 * those of the report. What starts a group that is run stands with its fields, in `inputs`.
 */
export function createWanted({ calculator, ...parts }) {
  const root = element(html`<div class="besides"></div>`);
  const all = [...calculator.beside ?? [], ...calculator.wanted ?? []].filter(({ load }) => load);
  const groups = all.map(({ id, section, load, shows = (state) => wants(state, id) }) => {
    const place = element(html`<section class="card beside-card" data-wanted="${id}" aria-labelledby="wanted-${id}" hidden>
      <h2 id="wanted-${id}">${message(section ? `section.${section}` : `${id}.title`)}</h2></section>`);
    root.append(place);
    const fold = foldable(place, `wanted-${id}`);
    return { id, section, load, shows, place, fold, loading: null, asking: null, view: null };
  });
  let closed = false;

  async function open(group) {
    const loading = [group.load(), group.section ? {} : import("../besides.js")];
    const loaded = await Promise.all(loading).catch(() => null);
    if (!loaded) group.loading = null; // the next change tries again
    if (!loaded || closed) return;
    const [[logic, { createView }], { createBeside }] = loaded;
    group.asking = createBeside?.({ ...parts, ...group, logic });
    group.view = createView({ ...parts, ...group, logic });
    group.place.append(group.view.root);
    if (group.view.controls) parts.inputs.querySelector(`[data-group="${group.id}"] .wanted-fields`).append(group.view.controls);
    parts.store.apply(besided, group.id, {});
  }

  function update(state) {
    for (const group of groups) {
      const on = group.shows(state);
      group.place.hidden = !on;
      if (on) group.loading ??= open(group);
      group.asking?.update(state);
      if (on) group.view?.update(state);
    }
  }

  return {
    root,
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
