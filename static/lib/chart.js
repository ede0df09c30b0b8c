/**
 * Figures as the service sends them (Plotly's data and layout, canonical units, English) made ready
 * for the reader: in the language and the units shown, as tables, with other designs laid over. No DOM.
 */
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

const OVERLAID = 0.55;

/** The curves of other designs, `[{ name, chart }]`, dashed over those of a figure. */
export function overlaid(chart, others) {
  const lines = others.flatMap(({ name, chart: { data } }) => data
    .filter(({ mode }) => mode === "lines")
    .map((trace, i) => ({
      ...trace,
      name,
      legendgroup: `design ${name}`,
      showlegend: i === 0,
      opacity: OVERLAID,
      line: { ...trace.line, dash: "dash", width: 1.5 },
      hovertemplate: trace.hovertemplate && `${name}: ${trace.hovertemplate}`,
    })));
  return { ...chart, data: [...chart.data, ...lines] };
}
