/** A figure made by the service and the table of the same numbers, in one place of fixed height. */
import { newestOnly } from "../lib/api.js";
import { besideIdeal, coinciding, curveTables, enveloped, inLanguage, overlaid, sequenced } from "../lib/chart.js";
import { clicks, element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { passingText, problemText } from "../service_texts.js";
import { following } from "../store.js";
import { busy, enlargeButton, olderMark, saveButtons, tableMarkup } from "./parts.js";
import { createPlot, loadPlotly, pictureOf } from "./plot.js";

const NONE = [];
const AGAIN_MS = 4000; // until a figure that the service could not give is asked for again
const LATE_MS = 300; // until a figure of other inputs gives way to the word that it is computed
const ALONE = { charted() {}, turned() {}, set() {}, picked() {} }; // what a figure reports that nobody follows
const BUTTON_PX = 48; // the room of a figure that is drawn on demand, until it is

/** What a calculator says of a figure, completed; one that `measures` a calculation is drawn on demand only. */
function completed({ measures, body = ({ besides, ...input }) => input, ...figure }) {
  if (!measures) return { ...figure, body };
  const measured = (input) => ({ calculation: measures, input: body(input) });
  return { ...figure, onDemand: true, path: "/work-precision/chart", height: 620, body: measured };
}

/**
 * `titles` are those of API names. `on.tabled(id, shown)` reports whether the table is wanted,
 * `on.tables(figure)` gives the tables of a figure that has its own, to be saved;
 * `on.charted(id, data)` tells of what was drawn, `on.picked(pair)` of a click on a pair, `on.turned(angle)`
 * of the crank angle of a click, `on.set([path, value])` of the input that it means. What is folded away is asked for and
 * drawn when it is opened; a figure that `leads` the drawing is asked for at once; one that is `noted` has room for a note
 * on solved forces.
 */
export function createFigure({ figure: about, client, titles, on = ALONE }) {
  const figure = completed(about);
  const title = message(`figure.${figure.id}`);
  const root = element(html`
    <figure class="card figure" data-figure="${figure.id}">
      <figcaption><h2>${title}</h2><span class="figure-tools">
        <button type="button" class="toggle show-table" aria-pressed="false"
          aria-label="${title}: ${message("figure.showTable")}">${message("figure.table")}</button>
        ${saveButtons(title, ["CSV", "PNG", "SVG"])}${enlargeButton(title)}</span>
      </figcaption>
      <div class="canvas">
        <div class="figure-table" tabindex="0" role="region" aria-label="${title}" hidden></div>
        <p class="figure-message" hidden></p>
        ${olderMark()}
        ${figure.onDemand && html`<button type="button" class="measure">${message("figure.measure")}</button>`}
      </div>
      ${(figure.enveloped || figure.noted) && html`<p class="figure-note"></p>`}
    </figure>`);
  const canvas = root.querySelector(".canvas");
  const table = root.querySelector(".figure-table");
  const trouble = root.querySelector(".figure-message");
  const tools = root.querySelector(".figure-tools");
  const toggle = root.querySelector(".show-table");
  const measure = root.querySelector(".measure");
  const plot = createPlot({ label: message(`figure.${figure.id}Label`), follows: figure.follows, picked: on.picked, clicked });
  canvas.prepend(plot.root);
  if (figure.follows) canvas.append(plot.cursor);
  const newest = newestOnly();
  let tabled = false;
  let latest = null; // { input, filled, answer, requests, theme, others } of what is drawn or to be drawn
  let chart = null; // of `latest`, in the language of the page
  let drawing = Promise.resolve(); // until the latest is drawn
  let drawnOf = null; // the answer that is drawn
  let again = 0; // the timer after a failure of the service
  let waiting = false; // folded away, until it is opened
  let ahead = null; // the chart of what is asked, `{ filled, theme, chart, stop }`, until it is drawn

  const heightOf = (input) => (typeof figure.height === "function" ? figure.height(input) : figure.height);

  /** Have another input to draw, or none: then there is nothing to list or to save either. */
  function take(next) {
    latest = next;
    for (const tool of tools.children) tool.disabled = latest === null;
  }

  function complain(text) {
    trouble.hidden = text === "";
    trouble.textContent = text;
    plot.root.classList.toggle("absent", text !== "");
  }

  function reserve(height) {
    canvas.style.height = `${height}px`;
    canvas.style.setProperty("--own", `${height}px`);
  }

  async function post({ input, answer, requests }, theme, signal) {
    return client.post(figure.path, figure.body(input, answer, requests), { signal, query: { theme } }).then(inLanguage).then(figure.shape ?? ((chart) => chart));
  }

  /** The first chart is asked for beside the answer, where its body does not hang on that; later ones of what is not refused. */
  function askAhead({ shown, pending, phase, theme, reading: { input, filled } }) {
    ahead?.stop.abort();
    ahead = null;
    if (shown || phase !== "computing" || pending !== filled || measure || (tabled && figure.tables) || figure.body.length > 1) return;
    if (canvas.clientWidth === 0 && !figure.leads) return;
    const stop = new AbortController();
    ahead = { filled: pending, theme, stop, chart: post({ input }, theme, stop.signal) };
    ahead.chart.catch(() => {}); // said where it is drawn
  }

  function chartOf(design, theme, signal) {
    if (design === latest && chart) return chart; // asked for while its tab was not open
    if (!ahead || ahead.filled !== design.filled || ahead.theme !== theme) return post(design, theme, signal);
    const { chart: asked } = ahead;
    ahead = null;
    return asked.catch(() => post(design, theme, signal)); // the service may be back with the answer
  }

  /** A click sets the crank angle where the figure follows the drawing, else what the calculator says. */
  function clicked(point) {
    if (figure.follows) on.turned(point.x);
    else if (figure.sets && latest) on.set(figure.sets(point, latest.filled));
  }

  const shaped = (one, theme) => {
    if (figure.enveloped) return enveloped(one, message(besideIdeal(one) ? "figure.largestReal" : "figure.largest"));
    return figure.sequenced ? sequenced(one, theme) : one;
  };

  /** The figure with those of the designs it is compared with, where it has curves to compare. */
  async function ask(signal) {
    const { theme, others } = latest;
    const [own, ...charts] = await Promise.all([latest, ...others].map((design) =>
      chartOf(design, theme, signal)));
    return { own, all: overlaid(shaped(own, theme), charts.map((one, i) => ({ name: others[i].name, chart: shaped(one, theme) })), theme) };
  }

  /** Draw the latest; the problem where it has none. */
  async function draw() {
    clearTimeout(again);
    const asked = latest;
    waiting = canvas.clientWidth === 0;
    root.dataset.stale = String(asked.answer !== drawnOf);
    if (waiting && !figure.leads) return undefined;
    const loading = loadPlotly().catch(() => null);
    const late = !measure && asked.answer !== drawnOf && setTimeout(() => {
      complain(message("state.computing")); // nothing of other inputs stands beside the numbers
      on.charted(figure.id, []);
    }, LATE_MS);
    const { answer, problem, superseded } = await newest.ask(ask);
    clearTimeout(late);
    if (superseded) return undefined;
    if (answer) chart = answer.own;
    on.charted(figure.id, answer ? chart.data : []); // the drawing does without it
    const Plotly = await loading;
    if (latest !== asked || !root.isConnected) return undefined;
    complain(problem || !Plotly
      ? message("figure.failed", { detail: problem ? (measure ? problemText : passingText)(problem, titles) : message("figure.noPlotly") }) : "");
    if (answer && Plotly && !waiting) {
      await show(answer.all);
      drawnOf = asked.answer;
    }
    root.dataset.stale = String(waiting);
    if (problem?.passing && !measure) again = setTimeout(() => latest === asked && (drawing = draw()), Math.max(problem.wait, AGAIN_MS));
    return problem;
  }

  async function show(all = chart) {
    const same = figure.enveloped ? coinciding(all) : [];
    const note = root.querySelector(".figure-note");
    if (note) note.textContent = [
      besideIdeal(all) ? message(`figure.${figure.id}Real`) : figure.enveloped && message("figure.switching"),
      same.length > 0 && message("figure.coinciding", { pairs: same.slice(0, 8).join("; ") + (same.length > 8 ? " …" : "") }),
    ].filter(Boolean).join(" ");
    if (!tabled) await plot.draw(all);
    else if (!figure.tables) fill(table, html`${curveTables(chart).map(tableMarkup)}`);
  }

  toggle.addEventListener("click", () => {
    tabled = !tabled;
    toggle.setAttribute("aria-pressed", String(tabled));
    table.hidden = !tabled;
    plot.root.hidden = tabled;
    if (figure.tables) on.tabled(figure.id, tabled);
    else if (measure) show();
    else drawing = draw();
  });

  measure?.addEventListener("click", async () => {
    measure.disabled = true;
    measure.textContent = message("figure.measuring");
    const asked = latest;
    reserve(heightOf(asked.filled));
    const problem = await draw();
    if (latest !== asked) return;
    measure.hidden = !problem;
    tools.hidden = Boolean(problem);
    measure.disabled = false;
    measure.textContent = message("figure.measure");
  });

  /** A figure on demand of other inputs than these gives way to its button. */
  function fold() {
    measure.hidden = false;
    measure.disabled = latest === null;
    measure.textContent = message("figure.measure");
    tools.hidden = true;
    newest.cancel();
    plot.purge();
    fill(table, html``);
    complain("");
    reserve(BUTTON_PX);
  }

  const sizes = new ResizeObserver(() => {
    if (!waiting || canvas.clientWidth === 0 || !latest) return;
    drawing = draw();
  });
  sizes.observe(canvas);
  root.addEventListener("resized", () => plot.drawn() && plot.fit());

  const picture = async (format) =>
    pictureOf(shaped(await post(latest, "light"), "light"), { title, format, height: heightOf(latest.filled) });

  async function fileOf(kind) {
    if (kind !== "csv") return [await picture(kind)];
    const tables = figure.tables ? await on.tables(figure) : curveTables(chart ?? await post(latest, "light"));
    const { csvOfTables } = await import("../lib/exports.js");
    return [csvOfTables(tables), "text/csv"];
  }

  clicks(tools, "kind", async (name, button) => {
    const kind = name.toLowerCase();
    try {
      const [{ download }, file] = await busy(button, () => Promise.all([import("./files.js"), fileOf(kind)]));
      download(`${figure.id}.${kind}`, ...file);
    } catch (problem) {
      complain(message("figure.failed", { detail: problemText(problem, titles) }));
    }
  });
  take(null);

  const updates = [
    /** Keep the room that the figure of what is asked will take. */
    following(({ pending }) => [pending], (state) => {
      askAhead(state);
      if (!measure) return reserve(heightOf(state.pending));
      take(null);
      return fold();
    }),
    /** Draw the results, over them those of the designs that are kept. */
    following(({ shown, kept, theme }) => [shown, figure.compared && kept?.length > 0 ? kept : NONE, theme], ({ shown, kept, theme }) => {
      if (!shown?.answer[figure.section]) return;
      take({ ...shown, theme, others: (figure.compared && kept ? kept : NONE).filter(({ answer }) => answer?.[figure.section]) });
      chart = null;
      if (tabled && figure.tables) fill(table, html`${figure.tables(shown.answer).map(tableMarkup)}`);
      if (measure) fold();
      else if (!tabled || !figure.tables) drawing = draw();
    }),
    /** Say in the figure's place why there is none. */
    following(({ shown, refusal, phase }) => [shown, refusal, phase], ({ shown, refusal, phase }) => {
      if (shown?.answer[figure.section] || (!refusal && (shown || phase !== "incomplete"))) return;
      newest.cancel();
      root.dataset.stale = "false";
      take(null);
      complain(message("figure.none"));
    }),
    following(({ turn }) => [turn], ({ turn }) => plot.follow(turn)),
  ];

  return {
    root,
    id: figure.id,
    /** When what is to be drawn is drawn. */
    settled: () => drawing,
    update(state) {
      for (const update of updates) update(state);
    },
    /** Give up the place on the page and what Plotly listens to for it. */
    close() {
      clearTimeout(again);
      sizes.disconnect();
      newest.cancel();
      ahead?.stop.abort();
      plot.purge();
    },
  };
}
