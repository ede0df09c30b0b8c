/**
 * What of a calculator at work stands under the figures or is opened by hand: the wanted groups, designs compared, all
 * results, worked steps, accuracy, the report, sizing. Loaded once the first figures are drawn (workbench.js).
 */
import { element, html } from "./lib/html.js";
import { message } from "./messages/index.js";
import { problemText } from "./service_texts.js";
import { following } from "./store.js";
import { createAccuracy } from "./views/accuracy.js";
import { createCompare } from "./views/compare.js";
import { nameFiles } from "./views/files.js";
import { foldable, remembering } from "./views/fold.js";
import { createReport } from "./views/report.js";
import { createResults } from "./views/results.js";
import { createSizing } from "./views/sizing.js";
import { createWanted } from "./views/wanted.js";
import { createWorked } from "./views/worked.js";

/**
 * `figures` are those of the report, which the wanted groups join. `on.opened(input, labels,
 * claim)` takes a design over, `on.applied(sets)` values, `on.compared()` follows the kept designs, `on.told(text)`
 * says what was done, `on.themed(theme)` has the figures drawn anew, with none given as they were.
 */
export function createRest({ store, inputs, outputs, client, designs, version, calculation, calculations, figures, figureOf, on }) {
  const { calculator, model, titles, catalogues } = store.state.about;
  const sizing = createSizing({ calculator, client, titles, on: { applied: on.applied } });
  const wanted = createWanted({ calculator, store, inputs, client, titles, figures, calculations });
  const compare = createCompare({
    model,
    calculator,
    on: {
      open: ({ input, labels, verdict }) => on.opened(input, labels, { verdict }),
      rename(design, name) {
        designs.rename(design, name);
        on.compared();
      },
      remove(design) {
        designs.remove(design);
        on.compared();
      },
      export: () => compare.save(designs.exported()),
      import(text) {
        const count = designs.imported(text);
        on.compared();
        on.told(count === null ? message("compare.notOurs") : message("compare.imported", { count }));
      },
    },
  });
  const results = createResults({ calculator, titles });
  const worked = createWorked({ calculator, client, titles });
  const compared = new Set(calculations.filter((each) => each.compared).map(({ name }) => name));
  const measured = calculator.figures.filter(({ measures }) => compared.has(measures)).map(figureOf);
  const accuracy = createAccuracy({ calculator, about: calculation, figures: measured });
  const comparing = foldable(compare.root, "compare");
  foldable(worked.root, "worked");
  remembering(results.root, "results");
  remembering(accuracy.root, "accuracy");
  const rest = element(html`<div class="rest"></div>`);
  rest.append(...[compare, results, worked, accuracy].map(({ root }) => root));
  outputs.append(wanted.root, rest);
  const report = createReport({
    calculator, model, catalogues, version, outputs, figures, worked,
    shown: () => store.state.shown,
    light: () => {
      on.themed("light");
      return Promise.all(figures.map((figure) => figure.settled()));
    },
    back: () => on.themed(),
    failed: (problem) => on.told(message("report.failed", { detail: problemText(problem, titles) })),
  });
  store.show([
    wanted, compare, results, worked, ...measured, accuracy,
    { update: following(({ typed }) => [typed.texts.title ?? ""], ({ typed }) => nameFiles(typed.texts.title ?? "")) },
  ]);
  return {
    print: () => report.print(),
    save: () => report.save(),
    /** Show the designs side by side. */
    compare: () => comparing.open(),
    size: (path) => store.state.shown && sizing.open(model.fields.get(path), store.state.shown),
    close() {
      sizing.close();
      report.close();
      wanted.close();
      worked.close();
      for (const figure of measured) figure.close();
    },
  };
}
