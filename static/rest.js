/**
 * What of a calculator at work stands behind tabs and folds or is opened by hand: the wanted groups, designs compared, all
 * results, worked steps, accuracy, sizing. Loaded once the first figures are drawn (workbench.js).
 */
import { element, html } from "./lib/html.js";
import { message } from "./messages/index.js";
import { following } from "./store.js";
import { createAccuracy } from "./views/accuracy.js";
import { createCompare } from "./views/compare.js";
import { nameFiles } from "./views/files.js";
import { remembering } from "./views/fold.js";
import { createResults } from "./views/results.js";
import { createSizing } from "./views/sizing.js";
import { createWanted } from "./views/wanted.js";
import { createWorked } from "./views/worked.js";

/**
 * `on.opened(input, labels, claim)` takes a design over, `on.applied(sets)` values, `on.compared()` follows the kept designs.
 */
export function createRest({ store, inputs, outputs, panels, client, designs, version, calculation, calculations, figureOf, on }) {
  const { calculator, model, titles } = store.state.about;
  const sizing = createSizing({ calculator, client, titles, on: { applied: on.applied } });
  const wanted = createWanted({ calculator, store, panels, inputs, client, titles, calculations });
  const compare = createCompare({
    model,
    calculator,
    on: {
      open: ({ input, labels, results }) => on.opened(input, labels, { verdict: results.verdict }),
      rename(design, name) {
        designs.rename(design, name);
        on.compared();
      },
      remove(design) {
        designs.remove(design);
        on.compared();
      },
      export: () => compare.save(designs.exported(version)),
    },
  });
  const results = createResults({ calculator, titles });
  const worked = createWorked({ calculator, client, titles });
  const compared = new Set(calculations.filter((each) => each.compared).map(({ name }) => name));
  const measured = calculator.figures.filter(({ measures }) => compared.has(measures)).map(figureOf);
  const accuracy = createAccuracy({ calculator, about: calculation, figures: measured });
  panels.add("results", message("results.all"), results.root);
  panels.add("compare", message("compare.title"), compare.root);
  remembering(worked.root, "worked");
  remembering(accuracy.root, "accuracy");
  const rest = element(html`<div class="rest"></div>`);
  rest.append(worked.root, accuracy.root);
  outputs.append(rest);
  let exploring = null; // once a field's menu has asked for it
  let closed = false;
  /** Sweeps and sensitivities, loaded when the first is opened. */
  function explore() {
    exploring ??= import("./views/explore.js").then(({ createExplore }) => {
      const view = createExplore({ store, panels, client, on: { applied: on.applied } });
      if (!closed) store.show([view]);
      return view;
    });
    return exploring;
  }
  store.show([
    wanted, compare, results, worked, ...measured, accuracy,
    { update: following(({ typed }) => [typed.texts.title ?? ""], ({ typed }) => nameFiles(typed.texts.title ?? "")) },
  ]);
  return {
    /** Show the designs side by side. */
    compare: () => panels.open("compare"),
    /** What a field's menu offers. */
    async act(act, path) {
      if (!store.state.shown) return;
      if (act === "size") sizing.open(model.fields.get(path), store.state.shown);
      else (await explore())[act](model.fields.get(path));
    },
    close() {
      closed = true;
      sizing.close();
      exploring?.then(({ close }) => close(), () => {});
      wanted.close();
      worked.close();
      for (const figure of measured) figure.close();
    },
  };
}
