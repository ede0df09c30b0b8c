/**
 * What of a calculator at work stands behind tabs and folds or is opened by hand: the wanted groups, designs compared, all
 * results, worked steps, accuracy, the report, sizing. Loaded once the first figures are drawn (workbench.js).
 */
import { element, html } from "./lib/html.js";
import { message } from "./messages/index.js";
import { problemText } from "./service_texts.js";
import { following, tabbed } from "./store.js";
import { createAccuracy } from "./views/accuracy.js";
import { createCompare } from "./views/compare.js";
import { nameFiles } from "./views/files.js";
import { remembering } from "./views/fold.js";
import { createReport } from "./views/report.js";
import { createResults } from "./views/results.js";
import { createSizing } from "./views/sizing.js";
import { ALL, createWanted } from "./views/wanted.js";
import { createWorked } from "./views/worked.js";

const LOOK_MS = 50;

/**
 * `figures` are those of the report, which the wanted groups join. `on.opened(input, labels,
 * claim)` takes a design over, `on.applied(sets)` values, `on.compared()` follows the kept designs, `on.told(text)`
 * says what was done, `on.themed(theme)` has the figures drawn anew, with none given as they were.
 */
export function createRest({ store, inputs, outputs, panels, client, designs, version, calculation, calculations, figures, figureOf, on }) {
  const { calculator, model, titles, catalogues } = store.state.about;
  const sizing = createSizing({ calculator, client, titles, on: { applied: on.applied } });
  const wanted = createWanted({ calculator, store, panels, inputs, client, titles, figures, calculations });
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
  const explored = ["sweep", "sensitivity"];
  const apart = ["compare", "results", ...explored];
  const busy = () => Object.values(store.state.besides).some(({ phase }) => phase === "computing");
  /** Have all that stands behind the tabs asked for and drawn. */
  async function whole() {
    panels.all(apart);
    store.apply(tabbed, ALL);
    while (busy()) await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))); // then the figures see that they have room
    await Promise.all(figures.map((figure) => figure.settled()));
  }
  let exploring = null; // once a field's menu has asked for it
  let closed = false;
  /** Sweeps and sensitivities, loaded when the first is opened. */
  function explore() {
    exploring ??= import("./views/explore.js").then(({ createExplore }) => {
      const view = createExplore({ store, panels, client, on: { applied: on.applied } });
      if (!closed) store.show([view]);
      return view;
    });
    exploring.catch(() => {
      exploring = null; // the next click tries again
    });
    return exploring;
  }
  const report = createReport({
    calculator, model, catalogues, version, outputs, figures, worked,
    shown: () => store.state.shown,
    whole,
    light: () => {
      on.themed("light");
      return whole();
    },
    open: (whole) => panels.all(whole ? ["compare", ...explored] : apart),
    back() {
      on.themed();
      panels.show(true);
    },
    failed: (problem) => on.told(message("report.failed", { detail: problemText(problem, titles) })),
  });
  store.show([
    wanted, compare, results, worked, ...measured, accuracy,
    { update: following(({ typed }) => [typed.texts.title ?? ""], ({ typed }) => nameFiles(typed.texts.title ?? "")) },
  ]);
  return {
    print: (ready) => report.print(ready),
    save: () => report.save(),
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
      exploring?.then(({ close }) => close());
      report.close();
      wanted.close();
      worked.close();
      for (const figure of measured) figure.close();
    },
  };
}
