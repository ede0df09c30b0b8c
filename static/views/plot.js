/** A figure drawn by Plotly: on the screen, following the drawing's crank angle, on paper, as a picture. */
import { inShownUnits, isOfRing, onPaper, pairsOf } from "../lib/chart.js";
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

// With a finger, dragging scrolls the page and does not zoom the figure.
const HOVERS = matchMedia("(hover: hover)").matches;
const NARROW_PX = 520;
const TITLE_PX = 14; // between rows and the title of their axis
const [TINY_PX, SMALL_PT] = [320, 10]; // a figure so narrow has smaller remarks
const [SIDES_PX, LETTER, LEAST_PX] = [76, 0.66, 9]; // beside the axes; of a title: width over height of a letter, least height
const PICTURE = { width: 900, scale: 2 }; // a saved one: points, and pixels a point
// No toolbar over the legend: dragging zooms, a double click shows all again, as Plotly says on a zoom.
const CONFIG = { displayModeBar: false, responsive: true };

const SOURCE = "static/vendor/plotly/plotly-basic.min.js";

let loading = null;

/**
 * Plotly.js, run once; first.js has it on the way. It writes its rules into a style element, which the
 * page's policy forbids; where a sheet of that id and class is linked, as in index.html, it leaves them
 * to the sheet.
 */
export function loadPlotly() {
  loading ??= globalThis.Plotly ? Promise.resolve(globalThis.Plotly) : new Promise((resolve, reject) => {
    const begun = document.querySelector(`script[src="${SOURCE}"]`);
    const script = begun ?? Object.assign(document.createElement("script"), { src: SOURCE });
    script.addEventListener("load", () => resolve(globalThis.Plotly));
    script.addEventListener("error", () => {
      loading = null; // the next figure tries again
      script.remove();
      reject(new Error("cannot load Plotly"));
    });
    if (!begun) document.head.append(script);
  });
  return loading;
}

const separators = () => `${message("page.decimal")}\u202f`;

/** A figure of this look as a picture for paper: light, on white; a data URL. */
export async function pictureOf(chart, { title, format, height, width = PICTURE.width }) {
  const Plotly = await loadPlotly();
  const { data, layout } = inShownUnits(chart);
  const size = { width, height };
  return Plotly.toImage(
    { data, layout: { ...onPaper(layout, title, height), ...size, separators: separators() } },
    { format, ...size, scale: format === "png" ? PICTURE.scale : 1 },
  );
}

/**
 * `follows(point)` names the pair that a point is of, in a figure that follows the drawing;
 * `picked(pair)` tells of a click on it, `clicked(point)` of any, with the place of the click on the axis.
 */
export function createPlot({ label, follows, picked, clicked }) {
  const root = element(html`<div class="plot" role="group" aria-label="${label}"></div>`);
  const cursor = element(html`<div class="cursor" hidden></div>`);
  let Plotly = null; // once it has drawn
  let turn = { angle: 0, pair: null };

  const drawn = () => Boolean(root.data?.length);

  function moveCursor() {
    const { xaxis, _size: size } = root._fullLayout ?? {};
    cursor.hidden = !xaxis || root.hidden;
    if (cursor.hidden) return;
    const x = xaxis.l2p(turn.angle);
    cursor.hidden = x < 0 || x > xaxis._length;
    cursor.style.transform = `translate(${xaxis._offset + x}px, ${size.t}px)`;
    cursor.style.height = `${size.h}px`;
  }

  /** How strong the traces are, so that what is not of the pair selected is paler. */
  function emphasis(data) {
    const weight = (name) => (turn.pair === null || name === turn.pair ? 1 : 0.25);
    const chosen = data.map((trace) => pairsOf(trace).includes(turn.pair));
    return {
      "marker.opacity": data.map((trace) => (trace.type === "bar" ? trace.y.map(weight) : 1)),
      opacity: data.map((trace, i) => (pairsOf(trace).length > 0 ? (chosen[i] ? 1 : 0.6) : trace.opacity ?? 1)),
      "line.width": data.map((trace, i) => (chosen[i] ? 3 : trace.line?.width ?? 2)),
    };
  }

  /** The traces as strong as they are to be: to restyle them once drawn would draw them again. */
  function emphasised(data) {
    const { opacity, "marker.opacity": markers, "line.width": widths } = emphasis(data);
    return data.map((trace, i) => ({
      ...trace, opacity: opacity[i], marker: { ...trace.marker, opacity: markers[i] }, line: { ...trace.line, width: widths[i] },
    }));
  }

  function listen() {
    root.removeAllListeners("plotly_click");
    root.on("plotly_click", ({ points: [point], event }) => {
      const pair = follows?.(point);
      if (pair) picked(pair);
      const { xaxis } = point;
      const { left, width } = root.getBoundingClientRect();
      clicked({ ...point, x: xaxis.p2d((event.clientX - left) * (root.offsetWidth / width) - xaxis._offset) }); // in the large view it is scaled
    });
    if (!follows) return;
    root.removeAllListeners("plotly_relayout");
    root.on("plotly_relayout", moveCursor);
    moveCursor();
  }

  return {
    root,
    cursor,
    drawn,
    async draw(chart) {
      Plotly = await loadPlotly();
      const { data, layout: { height, width, ...layout } } = inShownUnits(chart); // the page's room decides
      if (!HOVERS) layout.dragmode = false;
      // Half as many labels where they would not fit side by side.
      if (layout.xaxis?.dtick && root.clientWidth < NARROW_PX) layout.xaxis = { ...layout.xaxis, dtick: layout.xaxis.dtick * 2 };
      for (const axis of [layout.xaxis, layout.xaxis2].filter((one) => one?.title?.text)) {
        const [from, to] = axis.domain ?? [0, 1];
        const size = ((root.clientWidth - SIDES_PX) * (to - from)) / (LETTER * axis.title.text.length);
        const { font = {} } = axis.title;
        if (size < font.size) axis.title = { ...axis.title, font: { ...font, size: Math.max(LEAST_PX, size) } };
      }
      if (root.clientWidth < TINY_PX) {
        layout.annotations = layout.annotations?.map((one) => ({ ...one, font: { ...one.font, size: SMALL_PT } }));
      }
      // Names of rows are long: the title of their axis keeps off them.
      if (data[0]?.orientation === "h" && layout.yaxis?.title?.text) {
        layout.yaxis = { ...layout.yaxis, automargin: true, title: { ...layout.yaxis.title, standoff: TITLE_PX } };
      }
      const locales = { page: { dictionary: message("plotly"), format: {} } };
      await Plotly.react(root, follows ? emphasised(data) : data, { ...layout, autosize: true, separators: separators() }, { ...CONFIG, locale: "page", locales });
      listen();
    },
    /** Follow the drawing: its crank angle, the pair selected. */
    follow(next) {
      const pair = isOfRing(next.pair) ? null : next.pair; // of which no figure is
      const other = pair !== turn.pair;
      turn = { ...next, pair };
      if (!follows || !drawn() || root.hidden) return;
      moveCursor();
      if (other) Plotly.restyle(root, emphasis(root.data));
    },
    /** Fit what is drawn to its place. */
    fit: () => Plotly.relayout(root, { autosize: true, width: null, height: null }),
    purge: () => Plotly?.purge(root),
  };
}
