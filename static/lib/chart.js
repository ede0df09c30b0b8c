/**
 * Figures as the service sends them (Plotly's data and layout, canonical units, English) made ready
 * for the reader: in the language and the units shown, as tables, with other designs laid over. No DOM.
 */
import { message } from "../messages/index.js";
import { figureText } from "../service_texts.js";
import { shownAsIs, shownValue } from "./units.js";

const AXIS = { x: "xaxis", y: "yaxis" };
const NO_BOX = "<extra></extra>"; // ends a hover text: no box with the trace's name beside it

/** The name of the axis that a trace or a shape refers to: `x2` is `xaxis2`. */
function axisOf(reference, direction) {
  const number = /^[xy](\d*)$/.exec(reference ?? direction)?.[1];
  return number === undefined ? null : AXIS[direction] + number;
}

/** Title and canonical unit of an axis. */
function titled({ layout }, reference, direction) {
  const axis = axisOf(reference, direction);
  return layout.meta?.axes?.[axis] ?? { title: layout[axis]?.title?.text ?? "", unit: "" };
}

/** A figure with a text put where a path leads. */
function withText(part, [key, ...rest], text) {
  const copy = Array.isArray(part) ? [...part] : { ...part };
  copy[key] = rest.length > 0 ? withText(part[key], rest, text) : text;
  return copy;
}

/** The texts of a figure in the language and the units of the page; `layout.meta.axes` has title and unit of its axes. */
export function inLanguage(chart) {
  const axes = {};
  let worded = chart;
  for (const [path, id, params] of chart.layout.meta?.words ?? []) {
    const text = figureText(id, params);
    if (text === undefined) continue; // this page does not know it: in English
    worded = withText(worded, path, path.at(-1) === "hovertemplate" ? text + NO_BOX : text);
    if (id === "axis") axes[path[1]] = { title: textOf(params.title), unit: params.unit };
  }
  return { ...worded, layout: { ...worded.layout, meta: { axes } } };
}

const textOf = (title) => (Array.isArray(title) ? figureText(...title) : title);

function scaled(values, unit) {
  return Array.isArray(values)
    ? values.map((value) => (typeof value === "number" ? shownValue(value, unit) : value))
    : typeof values === "number" ? shownValue(values, unit) : values;
}

function placedAnew(part, chart, keys) {
  const moved = { ...part };
  for (const [key, direction] of keys) {
    if (key in part) moved[key] = scaled(part[key], titled(chart, part[`${direction}ref`], direction).unit);
  }
  return moved;
}

/** A figure in the units shown: data, ranges and marks; its texts are already. */
export function inShownUnits(chart) {
  if (shownAsIs("mm")) return chart;
  const { layout } = chart;
  const data = chart.data.map((trace) => ({
    ...trace,
    x: scaled(trace.x, titled(chart, trace.xaxis, "x").unit),
    y: scaled(trace.y, titled(chart, trace.yaxis, "y").unit),
  }));
  const axes = Object.fromEntries(Object.entries(layout)
    .filter(([key, axis]) => /^[xy]axis\d*$/.test(key) && Array.isArray(axis.range))
    .map(([key, axis]) => [key, { ...axis, range: scaled(axis.range, layout.meta?.axes?.[key]?.unit ?? "") }]));
  return {
    data,
    layout: {
      ...layout,
      ...axes,
      shapes: layout.shapes?.map((shape) => placedAnew(shape, chart, [["x0", "x"], ["x1", "x"], ["y0", "y"], ["y1", "y"]])),
      annotations: layout.annotations?.map((note) => placedAnew(note, chart, [["x", "x"], ["y", "y"]])),
    },
  };
}

const TITLE_PX = 44; // the room of a picture's title

/** The layout of a picture for paper: titled; a legend over the figure hangs below the title and gets room for its rows. */
export function onPaper(layout, title, height) {
  const hanging = { yref: "container", y: 1 - TITLE_PX / height, yanchor: "top" };
  return {
    ...layout,
    paper_bgcolor: "#ffffff",
    title: { text: title, yref: "container", y: 1, yanchor: "top", pad: { t: 12 } },
    margin: { ...layout.margin, t: TITLE_PX, b: 56 },
    legend: layout.legend?.y > 1 ? { ...layout.legend, ...hanging } : layout.legend,
  };
}

function grouped(items, keyOf) {
  const groups = new Map();
  for (const item of items) groups.set(keyOf(item), [...(groups.get(keyOf(item)) ?? []), item]);
  return [...groups.values()];
}

const MOST_GROUPS = 3; // more sets of places than this in one panel: a row for each point

/** The numbers behind a figure's curves as tables, in canonical units. */
export function curveTables(chart) {
  const { data } = chart;
  const panels = grouped(data, (trace) => `${trace.xaxis ?? "x"} ${trace.yaxis ?? "y"}`);
  return panels.flatMap((traces) => {
    const across = titled(chart, traces[0].xaxis, "x");
    const up = titled(chart, traces[0].yaxis, "y");
    const groups = grouped(traces, ({ x }) => x.join());
    if (groups.length > MOST_GROUPS) {
      return [{
        title: up.title,
        columns: [{ title: "" }, across, up],
        rows: traces.flatMap(({ name, x, y }) => x.map((place, i) => [name, place, y[i]])),
      }];
    }
    return groups.map((group) => ({
      title: up.title,
      columns: [across, ...group.map(({ name }) => ({ title: name, unit: up.unit }))],
      rows: group[0].x.map((place, i) => [place, ...group.map(({ y }) => y[i])]),
    }));
  });
}

/** Colours of kept designs, in their order; the table of designs has them as `series-1` and on. */
export const SERIES = {
  light: ["#0072b2", "#b35900", "#007a5e", "#a3467f", "#5c6bc0", "#806600"],
  dark: ["#5cb8f0", "#f0a04b", "#34c9a0", "#e39ac4", "#a5b0f5", "#e0cc4d"],
};

const MOST_COLOURS = 6; // of the figures' theme; beyond them colours would come twice

/** Where there are more lines than colours, colours in their order around the wheel. */
export function sequenced(chart, theme) {
  const names = [...new Set(chart.data.filter(({ mode }) => mode === "lines").map(({ name }) => name))];
  if (names.length <= MOST_COLOURS) return chart;
  const colour = (name) => `hsl(${(210 + (300 * names.indexOf(name)) / names.length) % 360} 75% ${theme === "dark" ? 68 : 34}%)`;
  return { ...chart, data: chart.data.map((trace) => (names.includes(trace.name) ? { ...trace, line: { ...trace.line, color: colour(trace.name) } } : trace)) };
}

/** What tells curves apart; level lines by their height alone. */
function key({ x, y, xaxis = "x" }) {
  const level = y.length > 1 && y.every((value) => value === y[0]);
  return level ? `${xaxis} ${y[0]}` : `${xaxis} ${x.join()} ${y.join()}`;
}

/** A level line from edge to edge is a limit: it belongs to the figure, not to a design. */
const isLimit = ({ y }) => y.length === 2 && y[0] === y[1];

/** A range that holds that of another figure too. */
const wider = (range, other) => [Math.min(range[0], other?.[0] ?? range[0]), Math.max(range[1], other?.[1] ?? range[1])];

/**
 * Other designs, `[{ name, chart }]`, over a figure: a colour each, their curves where they differ
 * (the envelope alone where there is one), their points with their names; the axes hold all.
 */
export function overlaid(chart, others, theme = "light") {
  const own = new Set(chart.data.map(key));
  const added = others.flatMap(({ name, chart: { data } }, i) => {
    const color = SERIES[theme][i % SERIES[theme].length];
    const ofDesign = { legendgroup: `design ${name}`, name, showlegend: false };
    const hovered = ({ hovertemplate }) => (hovertemplate ? { hovertemplate: `${name}: ${hovertemplate}` } : {});
    const envelopes = data.filter(({ meta }) => meta === ENVELOPE);
    const lines = (envelopes.length > 0 ? envelopes : data.filter(({ mode }) => mode === "lines"))
      .filter((trace) => !own.has(key(trace)) && !isLimit(trace))
      .map((trace) => ({ ...trace, ...ofDesign, ...hovered(trace), line: { ...trace.line, color, dash: "dash", width: 2 } }));
    const points = data.filter(({ mode }) => mode === "markers").map((trace) => ({
      ...trace, ...ofDesign, ...hovered(trace), mode: "markers+text", text: [name], textposition: "top center", textfont: { color },
      marker: { ...trace.marker, color, size: 9, symbol: "circle" },
    }));
    const all = [...lines, ...points];
    return all.map((trace, at) => (at === 0 ? { ...trace, showlegend: true, legend: undefined } : trace));
  });
  const axes = Object.entries(chart.layout).filter(([name, { range }]) => /^[xy]axis\d*$/.test(name) && Array.isArray(range))
    .map(([name, axis]) => [name, {
      ...axis, range: others.reduce((range, other) => wider(range, other.chart.layout[name]?.range), axis.range),
    }]);
  return { data: [...chart.data, ...added], layout: { ...chart.layout, ...Object.fromEntries(axes) } };
}

const PAIR = /^\d+\.\d+( = \d+\.\d+)*$/;
const ENVELOPE = "envelope";

/** The pairs whose curve a trace is, by satellite and pin; none where it is no pair's. */
export function pairsOf({ name, mode }) {
  return mode === "lines" && PAIR.test(name) ? name.split(" = ") : [];
}

/** Whether a name is that of a pin of the ring with a satellite, `2/14`, not of one of the output, `2.3`. */
export const isOfRing = (name) => name?.includes("/") ?? false;

/** A name of pairs as the reader knows them. */
export function pairNames(name) {
  if (isOfRing(name)) {
    const [satellite, pin] = name.split("/");
    return message("drawing.ringPair", { satellite, pin });
  }
  return name.split(" = ").map((pair) => {
    const [satellite, pin] = pair.split(".");
    return figureText("pair", { satellite, pin });
  }).join(" = ");
}

/** The largest force of all pairs, strong, over the curves of the pairs, thin; those that coincide are one. */
export function enveloped(chart, name) {
  const pairs = chart.data.filter((trace) => pairsOf(trace).length > 0);
  if (pairs.length < 2) return chart;
  const { x } = pairs[0];
  const most = Math.max(...pairs.flatMap(({ y }) => y));
  const close = (one, other) => one.y.every((value, i) => Math.abs(value - other.y[i]) < 1e-5 * most);
  const sets = [];
  for (const pair of pairs) {
    const same = sets.find(([first]) => close(first, pair));
    if (same) same.push(pair);
    else sets.push([pair]);
  }
  const thin = sets.map((set) => {
    const names = set.map((pair) => pair.name).join(" = ");
    const [first] = set;
    return {
      ...first, name: names, showlegend: false, line: { ...first.line, dash: "solid", width: 1 },
      hovertemplate: set.length > 1 ? `${pairNames(names)}<br>${first.hovertemplate}` : first.hovertemplate,
    };
  });
  const envelope = {
    type: "scatter", mode: "lines", name, meta: ENVELOPE, x, y: x.map((_, i) => Math.max(...pairs.map(({ y }) => y[i]))),
    line: { color: chart.layout.font?.color, width: 2.5, simplify: false }, hoverinfo: "skip",
  };
  const shapes = (chart.layout.shapes ?? []).map((shape) => ({ ...shape, line: { ...shape.line, dash: "dot" } }));
  return {
    data: [...thin, envelope, ...chart.data.filter((trace) => pairsOf(trace).length === 0)],
    layout: { ...chart.layout, shapes },
  };
}

/** Whether a figure shows ideal forces beside the real ones. */
export const besideIdeal = ({ data }) => data.some(({ meta }) => meta === "ideal");

/** The sets of pairs whose curves coincide, as the reader knows them. */
export function coinciding({ data }) {
  return data.filter((trace) => pairsOf(trace).length > 1).map(({ name }) => pairNames(name));
}

const LONG_TITLE = 18; // letters

/** An axis with its title in two lines where it is longer than a low panel is high. */
export function inTwoLines(axis) {
  const { text } = axis.title;
  const place = text.lastIndexOf(" ", text.length * 0.6);
  if (text.length <= LONG_TITLE || place <= 0) return axis;
  return { ...axis, title: { ...axis.title, text: `${text.slice(0, place)}<br>${text.slice(place + 1)}` } };
}
