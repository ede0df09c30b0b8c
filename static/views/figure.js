/** A figure drawn by the service and the table of the same numbers, in one place of fixed height. */
import { newestOnly } from "../api.js";
import { curveTables, inLanguage, inShownUnits, overlaid } from "../chart.js";
import { csvOfTables } from "../csv.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { inSentence } from "../refusals.js";
import { download } from "./download.js";
import { loadPlotly } from "./plotly.js";
import { tableMarkup } from "./table.js";

// With a finger, dragging scrolls the page and does not zoom the figure.
const HOVERS = matchMedia("(hover: hover)").matches;
const NARROW_PX = 520;
const BUTTON_PX = 48; // the room of a figure that is drawn on demand, until it is
const SAVED = { width: 900, scale: 2 }; // of a saved picture: points, and pixels a point
const CONFIG = {
  displaylogo: false,
  displayModeBar: HOVERS ? "hover" : false,
  responsive: true,
  modeBarButtonsToRemove: ["sendChartToCloud", "select2d", "lasso2d", "autoScale2d", "toImage"],
};

/**
 * `words` are the titles of API names. `on.tabled(id, shown)` reports whether the table is wanted,
 * `on.tables(figure)` gives the tables of a figure that has its own, to be saved;
 * `on.charted(id, chart)` tells of what was drawn, and `on.picked(pair)` of a click on a pair in a
 * figure that follows the drawing.
 */
export function createFigure({ figure, client, words, on }) {
  const title = message(`figure.${figure.id}`);
  const saver = (kind) => html`<button type="button" class="toggle save" data-kind="${kind}"
    aria-label="${message("figure.save", { title, kind })}">${kind}</button>`;
  const root = element(html`
    <figure class="card figure" data-figure="${figure.id}">
      <figcaption><h2>${title}</h2><span class="figure-tools">
        <button type="button" class="toggle show-table" aria-pressed="false"
          aria-label="${title}: ${message("figure.showTable")}">${message("figure.table")}</button>
        ${["CSV", "PNG", "SVG"].map(saver)}</span>
      </figcaption>
      <div class="canvas">
        <div class="plot" role="group" aria-label="${message(`figure.${figure.id}Label`)}"></div>
        <div class="figure-table" tabindex="0" role="region" aria-label="${title}" hidden></div>
        <p class="figure-message" hidden></p>
        ${figure.onDemand && html`<button type="button" class="measure">${message("figure.measure")}</button>`}
      </div>
    </figure>`);
  const canvas = root.querySelector(".canvas");
  const plot = root.querySelector(".plot");
  const table = root.querySelector(".figure-table");
  const trouble = root.querySelector(".figure-message");
  const tools = root.querySelector(".figure-tools");
  const toggle = root.querySelector(".show-table");
  const measure = root.querySelector(".measure");
  const newest = newestOnly();
  let tabled = false;
  let latest = null; // { input, answer, theme, others } of what is drawn or to be drawn
  let chart = null; // of `latest`, in the language of the page
  let drawnBy = null;

  /** Have another input to draw, or none: then there is nothing to list or to save either. */
  function take(next) {
    latest = next;
    for (const tool of tools.children) tool.disabled = latest === null;
  }

  function complain(text) {
    trouble.hidden = text === "";
    trouble.textContent = text;
    plot.classList.toggle("absent", text !== "");
  }

  toggle.addEventListener("click", () => {
    tabled = !tabled;
    toggle.setAttribute("aria-pressed", String(tabled));
    table.hidden = !tabled;
    plot.hidden = tabled;
    if (measure) show();
    else on.tabled(figure.id, tabled);
  });

  function reserve(input, open) {
    canvas.style.height = `${open ? figure.height(input) : BUTTON_PX}px`;
  }

  measure?.addEventListener("click", async () => {
    measure.disabled = true;
    measure.textContent = message("figure.measuring");
    reserve(latest.input, true);
    const asked = latest;
    await drawNow();
    if (latest !== asked) return;
    measure.hidden = true;
    tools.hidden = false;
  });

  /** A figure on demand of other inputs than these gives way to its button. */
  function fold() {
    measure.hidden = false;
    measure.disabled = latest === null;
    measure.textContent = message("figure.measure");
    tools.hidden = true;
    newest.cancel();
    drawnBy?.purge(plot);
    fill(table, html``);
    complain("");
  }

  function post({ input, answer }, theme, signal) {
    return client.post(figure.path, figure.body(input, answer), { signal, query: { theme } }).then(inLanguage);
  }

  /** The figure with those of the designs it is compared with, where it has curves to compare. */
  async function ask(signal) {
    const { theme, others } = latest;
    const [own, ...charts] = await Promise.all([latest, ...(figure.compared ? others : [])].map((design) =>
      post(design, theme, signal)));
    return { own, all: overlaid(own, charts.map((one, i) => ({ name: others[i].name, chart: one }))) };
  }

  async function drawNow() {
    const [{ answer, problem, superseded }, Plotly] = await Promise.all([
      newest.ask(ask),
      loadPlotly().catch(() => null),
    ]);
    if (superseded || !root.isConnected) return;
    if (problem || !Plotly) {
      complain(message("figure.failed", {
        detail: problem ? inSentence(problem, words) : message("figure.noPlotly"),
      }));
      return;
    }
    complain("");
    chart = answer.own;
    drawnBy = Plotly;
    on.charted(figure.id, chart);
    await show(answer.all);
  }

  async function show(all = chart) {
    if (tabled) {
      if (!figure.tables) fill(table, html`${curveTables(chart).map(tableMarkup)}`);
      return;
    }
    const { data, layout: { height, width, ...layout } } = inShownUnits(all); // the page's room decides
    if (!HOVERS) layout.dragmode = false;
    layout.separators = `${message("page.decimal")}\u202f`;
    // Half as many labels where they would not fit side by side.
    if (layout.xaxis?.dtick && plot.clientWidth < NARROW_PX) layout.xaxis = { ...layout.xaxis, dtick: layout.xaxis.dtick * 2 };
    const locales = { page: { dictionary: message("plotly"), format: {} } };
    await drawnBy.react(plot, data, { ...layout, autosize: true }, { ...CONFIG, locale: "page", locales });
    if (figure.follows) watch();
  }

  const cursor = figure.follows && element(html`<div class="cursor" hidden></div>`);
  if (cursor) canvas.append(cursor);
  let followed = { angle: 0, pair: null };

  /** Let the drawing know what is clicked, and follow it. */
  function watch() {
    plot.removeAllListeners("plotly_click");
    plot.on("plotly_click", ({ points: [point] }) => {
      const pair = figure.follows(point);
      if (pair) on.picked(pair);
    });
    plot.removeAllListeners("plotly_relayout");
    plot.on("plotly_relayout", moveCursor);
    emphasise();
    moveCursor();
  }

  function moveCursor() {
    const { xaxis, _size: size } = plot._fullLayout ?? {};
    cursor.hidden = !xaxis || tabled || plot.classList.contains("absent");
    if (cursor.hidden) return;
    const x = xaxis.l2p(followed.angle);
    cursor.hidden = x < 0 || x > xaxis._length;
    cursor.style.transform = `translate(${xaxis._offset + x}px, ${size.t}px)`;
    cursor.style.height = `${size.h}px`;
  }

  /** Pale what is not of the pair selected. */
  function emphasise() {
    const { pair } = followed;
    const weight = (name) => (pair === null || name === pair ? 1 : 0.25);
    const bars = plot.data.map((trace) => (trace.type === "bar" ? trace.y.map(weight) : 1));
    const lines = plot.data.map((trace) => (/^\d+\.\d+$/.test(trace.name) ? weight(trace.name) : trace.opacity ?? 1));
    drawnBy.restyle(plot, { "marker.opacity": bars, opacity: lines });
  }

  /** The figure as a picture for paper: light, on white; a data URL. */
  async function picture(format, width = SAVED.width) {
    const [light, Plotly] = await Promise.all([post(latest, "light"), loadPlotly()]);
    const { data, layout } = inShownUnits(light);
    const size = { width, height: figure.height(latest.input) };
    const paper = { paper_bgcolor: "#ffffff", title: { text: title }, margin: { ...layout.margin, t: 72 } };
    return Plotly.toImage(
      { data, layout: { ...layout, ...paper, ...size, separators: `${message("page.decimal")}\u202f` } },
      { format, ...size, scale: format === "png" ? SAVED.scale : 1 },
    );
  }

  tools.addEventListener("click", async (event) => {
    const kind = event.target.closest("[data-kind]")?.dataset.kind.toLowerCase();
    if (!kind) return;
    try {
      if (kind === "csv") {
        const tables = figure.tables ? await on.tables(figure) : curveTables(chart ?? await post(latest, "light"));
        download(`${figure.id}.csv`, csvOfTables(tables), "text/csv");
      } else {
        download(`${figure.id}.${kind}`, await picture(kind));
      }
    } catch (problem) {
      complain(message("figure.failed", { detail: inSentence(problem, words) }));
    }
  });
  if (measure) tools.hidden = true;
  take(null);

  return {
    root,
    id: figure.id,
    section: figure.section,
    picture,
    drawn: () => Boolean(plot.data?.length) && latest !== null,
    /** Fit what is drawn to paper, at once; `fromPaper` undoes it. */
    toPaper(width) {
      if (!plot.data?.length || tabled) return;
      root.dataset.drawn = latest.theme;
      drawnBy.relayout(plot, { autosize: false, width, height: figure.height(latest.input) });
    },
    fromPaper() {
      if (!root.dataset.drawn) return;
      delete root.dataset.drawn;
      drawnBy.relayout(plot, { autosize: true, width: null, height: null });
    },
    /** Follow the drawing: its crank angle, the pair selected. */
    follow(angle, pair) {
      if (!figure.follows) return;
      const other = pair !== followed.pair;
      followed = { angle, pair };
      if (!drawnBy || !plot.data || tabled) return;
      moveCursor();
      if (other) emphasise();
    },
    /** Keep the room that the figure of this input will take. */
    reserve(input) {
      if (measure) {
        take(null);
        fold();
      }
      reserve(input, !measure);
    },
    setTables(answer) {
      if (tabled && figure.tables) fill(table, html`${figure.tables(answer).map(tableMarkup)}`);
    },
    /**
     * Draw the figure of this input, over it the curves of `others`: `[{ name, input, answer }]`;
     * an older request that is still under way is given up.
     */
    async draw(input, answer, theme, others = []) {
      take({ input, answer, theme, others });
      chart = null;
      if (measure) {
        fold();
        reserve(input, false);
      } else if (!tabled || !figure.tables) {
        await drawNow();
      }
    },
    /** Give up the place on the page and what Plotly listens to for it. */
    close() {
      newest.cancel();
      drawnBy?.purge(plot);
    },
    /** Say in the figure's place why there is none. */
    clear(detail) {
      newest.cancel();
      take(null);
      complain(message("figure.failed", { detail }));
    },
  };
}
