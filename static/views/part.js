/** A section of the answer that is off until wanted: its numbers, its drawing, its figure, what it leaves out. */
import { flattened } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { neglectedIn } from "../service_texts.js";
import { following, stale } from "../store.js";
import { createBounds } from "./bounds.js";
import { createDrawingView } from "./drawing.js";
import { createFigure } from "./figure.js";
import { cellsMarkup, listMarkup } from "./parts.js";
import { valuesMarkup } from "./results.js";

const [HEIGHT, TALL] = [420, 720]; // of a figure, and of one whose panels stand under each other
const NARROW = matchMedia("(width < 700px)");

/** A figure of two panels beside each other, under each other where there is no room. */
function stacked({ data, layout }) {
  const { xaxis, yaxis, xaxis2, yaxis2 } = layout;
  if (!NARROW.matches || !xaxis2) return { data, layout };
  return {
    data,
    layout: {
      ...layout,
      xaxis: { ...xaxis, domain: [0, 1] }, yaxis: { ...yaxis, domain: [0.58, 1] },
      xaxis2: { ...xaxis2, domain: [0, 1] }, yaxis2: { ...yaxis2, domain: [0, 0.42] },
    },
  };
}

export function createView({ id, section, store, client, titles, calculations, logic }) {
  const root = element(html`<div class="part"><p class="state"></p><dl class="numbers"></dl><div class="all"></div>
    <p class="left-out note"></p></div>`);
  const path = logic.figure?.path ?? `${store.state.about.calculator.path}/`;
  const { model } = calculations.find(({ name }) => path.startsWith(`/${name}/`));
  const part = (name) => root.querySelector(`.${name}`);
  const figure = logic.figure && createFigure({
    figure: { id, section, shape: stacked, height: NARROW.matches ? TALL : HEIGHT, ...logic.figure }, client, titles,
  });
  const { lists = {} } = logic;
  const calculator = { id, drawing: { create: logic.drawing, section }, figures: [], elsewhere: ["locus", "curves", "forces", ...Object.keys(lists)] };
  const drawing = logic.drawing && createDrawingView({ calculator, on: {} });
  if (drawing) part("all").before(drawing.root);
  if (figure) part("left-out").before(figure.root);
  const bounds = logic.bounds && createBounds({ bounds: logic.bounds, client, titles });
  if (bounds) part("left-out").before(bounds.root);

  const numbers = following(({ shown }) => [shown], ({ shown }) => {
    const answer = shown?.answer[section];
    fill(part("numbers"), cellsMarkup(answer ? logic.cells(answer, shown.filled) : []));
    part("left-out").textContent = message("besides.leftOut", { what: neglectedIn({ model }).join("; ") });
    const values = answer && new Map(flattened(answer));
    fill(part("all"), html`${answer && [
      valuesMarkup(section, answer, calculator.elsewhere, titles),
      ...Object.keys(lists).filter((name) => values.has(name)).map((name) => listMarkup(name, values.get(name), lists[name])),
    ]}`);
  });

  return {
    root,
    update(state) {
      const old = stale(state);
      root.dataset.stale = String(old);
      part("state").textContent = old && state.phase !== "computing" && state.shown ? message("besides.older")
        : state.shown?.answer[section] ? "" : message("results.missing");
      numbers(state);
      drawing?.update({ ...state, about: { ...state.about, calculator } });
      figure?.update(state);
      bounds?.update(state);
    },
    close() {
      bounds?.close();
      drawing?.close();
      figure?.close();
    },
  };
}
