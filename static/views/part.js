/** A section of the answer that is off until wanted: its numbers, its drawing, its figure, what it leaves out. */
import { flattened } from "../lib/checks.js";
import { quantityParts, unitOf } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { shownUnit } from "../lib/units.js";
import { message } from "../messages/index.js";
import { neglectedIn } from "../service_texts.js";
import { following, stale } from "../store.js";
import { createDrawingView } from "./drawing.js";
import { createFigure } from "./figure.js";
import { valuesMarkup } from "./results.js";

const DIGITS = 5;
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

/** A list of records, each in a column under its name, a row a quantity; not all of them have every one. */
function listMarkup(name, records, nameOf) {
  const cell = (value, unit) => (value === undefined ? "–" : quantityParts(value, unit, DIGITS).value);
  const keys = [...new Set(records.flatMap(Object.keys))];
  return html`<div class="grid-rows"><table class="data"><caption>${message(`quantity.${name}`)[0]}</caption>
    <thead><tr><td></td>${records.map((_, i) => html`<th scope="col">${nameOf(i)}</th>`)}</tr></thead>
    <tbody>${keys.map((key) => html`<tr><th scope="row">${message(`quantity.${key}`)[0]}${unitOf(key) && `, ${shownUnit(unitOf(key))}`}</th>
      ${records.map((record) => html`<td>${cell(record[key], unitOf(key))}</td>`)}</tr>`)}</tbody></table></div>`;
}

export function createView({ id, section, client, titles, figures, calculations, logic }) {
  const root = element(html`<div class="part"><p class="state"></p><dl class="numbers"></dl><div class="all"></div>
    <p class="left-out note"></p></div>`);
  const { model } = calculations.find(({ name }) => logic.figure.path.startsWith(`/${name}/`));
  const part = (name) => root.querySelector(`.${name}`);
  const figure = createFigure({
    figure: { shape: stacked, height: NARROW.matches ? TALL : HEIGHT, ...logic.figure }, client, titles,
    on: { charted() {}, turned() {}, set() {}, picked() {} },
  });
  const { lists = {} } = logic;
  const calculator = { id, drawing: logic.drawing, figures: [], elsewhere: ["locus", "curves", "forces", ...Object.keys(lists)] };
  const drawing = logic.drawing && createDrawingView({ calculator, on: {} });
  if (drawing) part("all").before(drawing.root);
  part("left-out").before(figure.root);
  figures.push(figure);

  const numbers = following(({ shown }) => [shown], ({ shown }) => {
    const answer = shown?.answer[section];
    fill(part("numbers"), html`${answer && logic.cells(answer, shown.filled).map((cell) => html`
      <div class="cell"><dt>${cell.label}</dt><dd><span class="figures">${cell.value}</span><span class="note">${cell.note}</span></dd></div>`)}`);
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
      figure.update(state);
    },
    close() {
      drawing?.close();
      figure.close();
    },
  };
}
