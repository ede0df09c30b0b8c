/** The figures of a sweep, by Plotly: lines over a field, or a map of the check that governs over two. No DOM. */
import { SERIES } from "./chart.js";
import { formatNumber, formatQuantity } from "./format.js";
import { GOVERNING, wordOf } from "./sweep.js";
import { shownUnit, shownValue } from "./units.js";
import { message } from "../messages/index.js";

const LOOKS = {
  light: { ink: "#1c2733", grid: "#e3e8ed", line: "#5a6875", bad: "#b3261e" },
  dark: { ink: "#e6edf3", grid: "#2b3642", line: "#9aa7b4", bad: "#ff8a80" },
};
const LIMIT = 100; // %, of a utilisation
const [PALE, DEEP] = [0.12, 0.5]; // a cell of which nothing is used, and one at its limit: its text is to be read
const TEXT_PX = 9; // least height of a cell's text
const HATCHES = [["marginal", "."], ["fail", "/"], ["impossible", "x"]]; // over the cells of a status

const isKnown = ({ y, status }) => y !== null && status !== "impossible";
const colorOf = (theme, i) => SERIES[theme][i % SERIES[theme].length];

/** Whether the figure of a result over these fields is a map. */
export const isMap = (fields, { pointer }) => fields.length > 1 && pointer === GOVERNING;

/** What a point says under the pointer: where it is, its result, its verdict and why. */
const hoverOf = (places, point, unit) => [
  `${places.join(", ")}: ${point.y === null ? "–" : formatQuantity(point.y, unit)}`,
  [wordOf(point), point.why ?? point.check].filter(Boolean).join(": "),
].filter(Boolean).join("<br>");

function axisOf({ title, unit }, { grid, line }) {
  return {
    title: { text: unit ? `${title}, ${shownUnit(unit)}` : title, font: { size: 13 } }, gridcolor: grid, linecolor: line, zerolinecolor: line, ticks: "outside", tickcolor: line,
    tickformat: ".6~g", automargin: true,
  };
}

const layoutOf = ({ ink }, more) => ({
  font: { color: ink, family: "system-ui, sans-serif", size: 12 }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
  margin: { l: 56, r: 16, t: 16, b: 48 }, hovermode: "closest", showlegend: true, legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 }, ...more,
});

/**
 * The points as a figure over one field or two; `now` are the values of the design at hand there. Utilisations of the
 * check that governs over two fields are a map, others lines.
 */
export function sweepChart(points, fields, quantity, now, theme) {
  return (isMap(fields, quantity) ? mapOf : linesOf)(points, fields, quantity, now, theme);
}

/**
 * A line for each value of a second field; a colour for each of these, else for each check that governs; crosses where
 * one fails or nothing is possible.
 */
function linesOf(points, [field, beside], quantity, [now], theme) {
  const look = LOOKS[theme];
  const { ink, line, bad } = look;
  const across = ({ x }) => shownValue(x, field.unit);
  const known = points.filter(isKnown);
  const up = ({ y }) => shownValue(y, quantity.unit);
  const [least, most] = [Math.min(0, ...known.map(up)), Math.max(...known.map(up), quantity.percent ? LIMIT : 0)];
  const hover = (point) => hoverOf([formatQuantity(point.x, field.unit), ...(beside ? [nameOf(point)] : [])], point, quantity.unit);
  const marks = (name, own, color, symbol) => ({
    type: "scatter", mode: "markers", name, x: own.map(across), y: own.map((point) => (point.status === "impossible" ? least : up(point))),
    text: own.map(hover), customdata: own.map((point) => points.indexOf(point)), hovertemplate: "%{text}<extra></extra>", cliponaxis: false,
    marker: { color, size: 10, symbol: own.map(symbol), line: { width: 0 } },
  });
  const nameOf = ({ z, check }) => (beside ? `${beside.title} ${formatQuantity(z, beside.unit)}` : check ?? quantity.title);
  const names = [...new Set(known.map(nameOf))];
  const lines = beside ? [...new Set(points.map(({ z }) => z))].map((z) => points.filter((point) => point.z === z)) : [points];
  const impossible = points.filter(({ status }) => status === "impossible");
  const symbolOf = ({ status }) => (status === "fail" ? "x" : "circle");
  const meant = (status) => ({ ...marks(message(`status.${status}`), [], ink, symbolOf), x: [null], y: [null], marker: { color: ink, size: 10, symbol: symbolOf({ status }) }, hoverinfo: "skip" });
  const shape = (place) => ({ type: "line", xref: "x", yref: "y", line: { color: line, width: 1, dash: "dash" }, ...place });
  return {
    data: [
      ...lines.map((own) => ({
        type: "scatter", mode: "lines", x: own.map(across), y: own.map((point) => (known.includes(point) ? up(point) : null)),
        line: { color: beside ? colorOf(theme, Math.max(0, names.indexOf(nameOf(own[0])))) : ink, width: 1.5 }, hoverinfo: "skip", showlegend: false,
      })),
      ...names.map((name, i) => marks(name, known.filter((point) => nameOf(point) === name), colorOf(theme, i), symbolOf)),
      ...(known.some(({ status }) => status === "fail") ? ["pass", "fail"].map(meant) : []), // in the legend alone
      ...(impossible.length > 0 ? [marks(message("verdictWord.impossible"), impossible, bad, () => "x-open")] : []),
    ],
    layout: layoutOf(look, {
      xaxis: axisOf(field, look),
      yaxis: { ...axisOf({ title: quantity.percent ? message("sweep.used") : quantity.title, unit: quantity.unit }, look), range: [least, 1.08 * most || 1] },
      shapes: [
        ...(quantity.percent ? [shape({ xref: "paper", x0: 0, x1: 1, y0: LIMIT, y1: LIMIT })] : []),
        ...(now === undefined ? [] : [shape({ yref: "paper", y0: 0, y1: 1, x0: shownValue(now, field.unit), x1: shownValue(now, field.unit) })]),
      ],
    }),
  };
}

/** From where to where each value of an axis reaches: half way to its neighbours. */
function spansOf(values) {
  const ordered = [...new Set(values)].sort((one, other) => one - other);
  const [first, last] = [ordered[0], ordered.at(-1)];
  const half = ordered.length > 1 ? [(ordered[1] - first) / 2, (last - ordered.at(-2)) / 2] : [0.5, 0.5];
  const ends = [first - half[0], ...ordered.slice(1).map((value, i) => (value + ordered[i]) / 2), last + half[1]];
  return { ends, reach: [ends[0], ends.at(-1)], of: new Map(ordered.map((value, i) => [value, [ends[i], ends[i + 1]]])) };
}

/** Where results pass a limit between points that have them, as `[x, z]` of pieces: two triangles between any four points. */
function contourOf(points, columns, limit) {
  const found = [];
  for (let i = 0; i + columns + 1 < points.length; i++) {
    if ((i + 1) % columns === 0) continue; // the last of its row
    const [a, b, c, d] = [i, i + 1, i + columns, i + columns + 1].map((k) => points[k]);
    for (const corners of [[a, b, c], [b, d, c]]) {
      if (!corners.every(isKnown)) continue;
      const passed = corners.map((one, k) => [one, corners[(k + 1) % 3]]).filter(([one, other]) => one.y > limit !== other.y > limit);
      const at = ([one, other], key) => one[key] + ((other[key] - one[key]) * (limit - one.y)) / (other.y - one.y);
      if (passed.length > 0) found.push(...passed.map((side) => [at(side, "x"), at(side, "z")]), []);
    }
  }
  return found;
}

/**
 * A cell for each point: its colour is the check that governs, the deeper the more is used, its text how much in %.
 * Hatches tell cells that just work, fail or are impossible; a line is where all of the limit is used, a frame the cell of
 * the design at hand.
 */
function mapOf(points, fields, { unit }, now, theme) {
  const look = LOOKS[theme];
  const { ink, bad } = look;
  const place = (values) => values.map((value, k) => (value === undefined ? null : shownValue(value, fields[k].unit)));
  const [across, up] = ["x", "z"].map((key, k) => spansOf(points.map((point) => shownValue(point[key], fields[k].unit))));
  const known = points.filter(isKnown);
  const hatched = HATCHES.map(([status]) => status);
  const cells = (name, own, marker, texts) => {
    const [x, y] = [across, up].map((spans, k) => own.map((point) => spans.of.get(place([point.x, point.z])[k])));
    const size = (spans) => spans.map(([from, to]) => to - from);
    return {
      type: "bar", name, x: x.map(([from, to]) => (from + to) / 2), width: size(x), base: y.map(([from]) => from), y: size(y),
      marker: { line: { width: 0 }, ...marker }, text: own.map((point) => (texts(point) ? formatNumber(Math.round(point.y)) : "")),
      textposition: "inside", insidetextanchor: "middle", textangle: 0, insidetextfont: { color: ink },
      hovertext: own.map((point) => hoverOf([point.x, point.z].map((value, k) => formatQuantity(value, fields[k].unit)), point, unit)),
      customdata: own.map((point) => points.indexOf(point)), hovertemplate: "%{hovertext}<extra></extra>",
    };
  };
  const clear = "rgba(0,0,0,0)";
  const hatch = (shape, color) => ({ color: clear, pattern: { shape, size: 8, solidity: 0.2, fgcolor: color, fgopacity: 0.5, bgcolor: clear } });
  const depth = ({ y }) => PALE + (DEEP - PALE) * Math.min(1, y / LIMIT);
  const names = [...new Set(known.map(({ check }) => check))];
  const contour = contourOf(points, up.of.size, LIMIT).map(place);
  const within = (own, at) => [across, up].every(({ of }, k) => at[k] !== null && of.get(own[k])[0] <= at[k] && at[k] <= of.get(own[k])[1]);
  const here = points.find((point) => within(place([point.x, point.z]), place(now)));
  const placed = (places) => ({ x: places.map(([x = null]) => x), y: places.map(([, y = null]) => y) });
  return {
    data: [
      ...names.map((name, i) => {
        const own = known.filter(({ check }) => check === name);
        return cells(name, own, { color: colorOf(theme, i), opacity: own.map(depth) }, ({ status }) => !hatched.includes(status));
      }),
      ...HATCHES.map(([status, shape]) =>
        cells(wordOf({ status }), points.filter((point) => point.status === status), hatch(shape, status === "impossible" ? bad : ink), isKnown)),
      { type: "scatter", mode: "lines", name: message("sweep.limit"), ...placed(contour), line: { color: ink, width: 2.5 }, hoverinfo: "skip" },
      cells(message("sweep.now"), here ? [here] : [], { color: clear, line: { color: ink, width: 3 } }, () => false),
    ].filter((trace) => trace.x.length > 0),
    layout: layoutOf(look, {
      barmode: "overlay", uniformtext: { minsize: TEXT_PX, mode: "hide" },
      xaxis: { ...axisOf(fields[0], look), range: across.reach, showgrid: false, zeroline: false },
      yaxis: { ...axisOf(fields[1], look), range: up.reach, showgrid: false, zeroline: false },
    }),
  };
}
