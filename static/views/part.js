/** A section of the answer that is off until wanted: its numbers, its drawing, its figure, what it leaves out. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { following, stale } from "../store.js";
import { neglectedIn } from "./accuracy.js";
import { createDrawingView } from "./drawing.js";
import { createFigure } from "./figure.js";
import { valuesMarkup } from "./results.js";

export function createView({ id, section, client, titles, figures, calculations, logic }) {
  const root = element(html`<div class="part"><p class="state"></p><dl class="numbers"></dl><div class="all"></div>
    <p class="left-out note">${message("besides.leftOut", {
      what: neglectedIn(calculations.find(({ name }) => logic.figure.path.startsWith(`/${name}/`))).join("; "),
    })}</p></div>`);
  const part = (name) => root.querySelector(`.${name}`);
  const figure = createFigure({
    figure: logic.figure, client, titles,
    on: { charted() {}, turned() {}, set() {}, picked() {} },
  });
  const calculator = { id, drawing: logic.drawing, figures: [], elsewhere: ["locus", "curves"] };
  const drawing = logic.drawing && createDrawingView({ calculator, on: {} });
  if (drawing) part("all").before(drawing.root);
  part("left-out").before(figure.root);
  figures.push(figure);

  const numbers = following(({ shown }) => [shown], ({ shown }) => {
    const answer = shown?.answer[section];
    fill(part("numbers"), html`${answer && logic.cells(answer, shown.filled).map((cell) => html`
      <div class="cell"><dt>${cell.label}</dt><dd><span class="figures">${cell.value}</span><span class="note">${cell.note}</span></dd></div>`)}`);
    fill(part("all"), html`${answer && valuesMarkup(answer, calculator.elsewhere, titles)}`);
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
      figure.update(state);
    },
    close() {
      drawing?.close();
      figure.close();
    },
  };
}
