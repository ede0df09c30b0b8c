/** A figure drawn by the service and the table of the same numbers, in one place of fixed height. */
import { newestOnly } from "../api.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { loadPlotly } from "./plotly.js";
import { tableMarkup } from "./table.js";

// With a finger, dragging scrolls the page and does not zoom the figure.
const HOVERS = matchMedia("(hover: hover)").matches;
const NARROW_PX = 520;
const BUTTON_PX = 48; // the room of a figure that is drawn on demand, until it is
const CONFIG = {
  displaylogo: false,
  displayModeBar: HOVERS ? "hover" : false,
  responsive: true,
  modeBarButtonsToRemove: ["sendChartToCloud", "select2d", "lasso2d", "autoScale2d"],
};

export function createFigure({ figure, client, on }) {
  const title = message(`figure.${figure.id}`);
  const root = element(html`
    <figure class="card figure" data-figure="${figure.id}">
      <figcaption><h3>${title}</h3>${figure.tables && html`
        <button type="button" class="toggle" aria-pressed="false"
          aria-label="${title}: ${message("figure.showTable")}">${message("figure.table")}</button>`}
      </figcaption>
      <div class="canvas">
        <div class="plot" role="img" aria-label="${message(`figure.${figure.id}Label`)}"></div>
        <div class="figure-table" tabindex="0" role="region" aria-label="${title}" hidden></div>
        <p class="figure-message" hidden></p>
        ${figure.onDemand && html`<button type="button" class="measure">${message("figure.measure")}</button>`}
      </div>
    </figure>`);
  const canvas = root.querySelector(".canvas");
  const plot = root.querySelector(".plot");
  const table = root.querySelector(".figure-table");
  const trouble = root.querySelector(".figure-message");
  const toggle = root.querySelector(".toggle");
  const measure = root.querySelector(".measure");
  const newest = newestOnly();
  let tabled = false;
  let latest = null; // what to draw when a figure on demand is asked for
  let drawnBy = null;

  function complain(text) {
    trouble.hidden = text === "";
    trouble.textContent = text;
    plot.classList.toggle("absent", text !== "");
  }

  toggle?.addEventListener("click", () => {
    tabled = !tabled;
    toggle.setAttribute("aria-pressed", String(tabled));
    table.hidden = !tabled;
    plot.hidden = tabled;
    on.tabled(figure.id, tabled);
  });

  function reserve(input, open) {
    canvas.style.height = `${open ? figure.height(input) : BUTTON_PX}px`;
  }

  measure?.addEventListener("click", async () => {
    measure.disabled = true;
    measure.textContent = message("figure.measuring");
    reserve(latest[0], true);
    const asked = latest;
    await drawNow(...asked);
    if (latest === asked) measure.hidden = true;
  });

  /** A figure on demand of other inputs than these gives way to its button. */
  function fold() {
    measure.hidden = false;
    measure.disabled = latest === null;
    measure.textContent = message("figure.measure");
    newest.cancel();
    drawnBy?.purge(plot);
    complain("");
  }

  async function drawNow(input, answer, theme) {
    const [{ answer: chart, problem, superseded }, Plotly] = await Promise.all([
      newest.ask((signal) =>
        client.post(figure.path, figure.body(input, answer), { signal, query: { theme } })),
      loadPlotly().catch(() => null),
    ]);
    if (superseded || !root.isConnected) return;
    if (problem || !Plotly) {
      complain(message("figure.failed", { detail: problem?.message ?? message("figure.noPlotly") }));
      return;
    }
    complain("");
    const { height, width, ...layout } = chart.layout; // the room kept on the page decides
    if (!HOVERS) layout.dragmode = false;
    // Half as many labels where they would not fit side by side.
    if (layout.xaxis?.dtick && plot.clientWidth < NARROW_PX) layout.xaxis.dtick *= 2;
    drawnBy = Plotly;
    await Plotly.react(plot, chart.data, { ...layout, autosize: true }, CONFIG);
  }

  return {
    root,
    id: figure.id,
    section: figure.section,
    /** Keep the room that the figure of this input will take. */
    reserve(input) {
      if (measure) {
        latest = null;
        fold();
      }
      reserve(input, !measure);
    },
    setTables(answer) {
      if (tabled) fill(table, html`${figure.tables(answer).map(tableMarkup)}`);
    },
    /** Draw the figure of this input; an older request that is still under way is given up. */
    async draw(input, answer, theme) {
      if (measure) {
        latest = [input, answer, theme];
        fold();
        reserve(input, false);
      } else if (!tabled) {
        await drawNow(input, answer, theme);
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
      complain(message("figure.failed", { detail }));
    },
  };
}
