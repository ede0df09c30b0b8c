/**
 * Figures as the service sends them (Plotly's data and layout, canonical units, English) made ready
 * for the reader: in the language and the units shown, as tables, with other designs laid over. No DOM.
 */
import { figureText } from "../service_texts.js";
import { formatNumber } from "./format.js";
import { shownUnit, shownValue } from "./units.js";

const UNITS = ["N/mm", "N·m", "mm", "MPa", "GPa", "N", "°", "µs"];
const TITLE = new RegExp(`^(.*), (${UNITS.join("|")})$`);
const QUANTITY = /(%\{[^}]*\}|-?\d+(?:\.\d+)?(?:e[+-]?\d+)?)[ \u00a0](N\/mm|N·m|mm|MPa|GPa|N)(?![\p{L}/·])/gu;
const AXIS = { x: "xaxis", y: "yaxis" };

/** Title and canonical unit of an axis title. */
function titled(text = "") {
  const [, title = text, unit = ""] = TITLE.exec(text) ?? [];
  return { title, unit };
}

/** The axis of a layout that a trace or a shape refers to: `x2` is `xaxis2`. */
function axisOf(layout, reference, direction) {
  const number = /^[xy](\d*)$/.exec(reference ?? direction)?.[1];
  return number === undefined ? null : layout[AXIS[direction] + number];
}

function unitAt(layout, reference, direction) {
  return titled(axisOf(layout, reference, direction)?.title?.text).unit;
}

function mapTexts(chart, change) {
  const texts = (part, keys) => Object.fromEntries(
    keys.filter((key) => typeof part[key] === "string").map((key) => [key, change(part[key])]),
  );
  const layout = { ...chart.layout };
  for (const [key, axis] of Object.entries(layout)) {
    if (/^[xy]axis\d*$/.test(key) && axis.title) layout[key] = { ...axis, title: { ...axis.title, ...texts(axis.title, ["text"]) } };
  }
  layout.annotations = layout.annotations?.map((note) => ({ ...note, ...texts(note, ["text"]) }));
  return {
    data: chart.data.map((trace) => ({ ...trace, ...texts(trace, ["name", "hovertemplate"]) })),
    layout,
  };
}

/** The texts of a figure in the language of the page. */
export function inLanguage(chart) {
  return mapTexts(chart, figureText);
}

function inWordsOfUnits(text) {
  const axis = titled(text);
  if (axis.unit) return `${axis.title}, ${shownUnit(axis.unit)}`;
  return text.replace(QUANTITY, (_, amount, unit) => {
    const value = amount.startsWith("%") ? amount : formatNumber(shownValue(Number(amount), unit), 4);
    return `${value} ${shownUnit(unit)}`;
  });
}

function scaled(values, unit) {
  return Array.isArray(values)
    ? values.map((value) => (typeof value === "number" ? shownValue(value, unit) : value))
    : typeof values === "number" ? shownValue(values, unit) : values;
}

function placedAnew(part, layout, keys) {
  const moved = { ...part };
  for (const [key, direction] of keys) {
    if (key in part) moved[key] = scaled(part[key], unitAt(layout, part[`${direction}ref`] ?? direction, direction));
  }
  return moved;
}

/** A figure in the units shown: data, ranges, marks and words. */
export function inShownUnits(chart) {
  if (shownUnit("mm") === "mm") return chart;
  const { layout } = chart;
  const data = chart.data.map((trace) => {
    const units = { x: unitAt(layout, trace.xaxis, "x"), y: unitAt(layout, trace.yaxis, "y") };
    return { ...trace, x: scaled(trace.x, units.x), y: scaled(trace.y, units.y) };
  });
  const axes = Object.fromEntries(Object.entries(layout)
    .filter(([key, axis]) => /^[xy]axis\d*$/.test(key) && Array.isArray(axis.range))
    .map(([key, axis]) => [key, { ...axis, range: scaled(axis.range, titled(axis.title?.text).unit) }]));
  return mapTexts({
    data,
    layout: {
      ...layout,
      ...axes,
      shapes: layout.shapes?.map((shape) => placedAnew(shape, layout, [["x0", "x"], ["x1", "x"], ["y0", "y"], ["y1", "y"]])),
      annotations: layout.annotations?.map((note) => placedAnew(note, layout, [["x", "x"], ["y", "y"]])),
    },
  }, inWordsOfUnits);
}

function grouped(items, keyOf) {
  const groups = new Map();
  for (const item of items) groups.set(keyOf(item), [...(groups.get(keyOf(item)) ?? []), item]);
  return [...groups.values()];
}

const MOST_GROUPS = 3; // more sets of places than this in one panel: a row for each point

/** The numbers behind a figure's curves as tables, in canonical units. */
export function curveTables({ data, layout }) {
  const panels = grouped(data, (trace) => `${trace.xaxis ?? "x"} ${trace.yaxis ?? "y"}`);
  return panels.flatMap((traces) => {
    const across = titled(axisOf(layout, traces[0].xaxis, "x")?.title?.text);
    const up = titled(axisOf(layout, traces[0].yaxis, "y")?.title?.text);
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
