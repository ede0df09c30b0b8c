/** A result over one input, and inputs that matter: what is asked of the service and what its answer says. No DOM. */
import { SERIES } from "./chart.js";
import { judgedOf, pathOf, titleOf } from "./checks.js";
import { ALL, formatNumber, formatQuantity, tidy, unitOf } from "./format.js";
import { designOf, targetsOf, valueIn } from "./sizing.js";
import { shownUnit, shownValue } from "./units.js";
import { message, quantityTitle, said } from "../messages/index.js";

const GOVERNING = "/checks/governing/utilisation";
const [AROUND, POINTS, COUNTED] = [0.3, 13, 3]; // to both sides: a share of the value, or so many where it is counted
const MOST = 12; // inputs

/** From where to where a field is swept unless something else is said, in canonical units. */
export function rangeOf(field, shown) {
  const value = valueIn(shown, field);
  const within = (number) => Math.min(Math.max(number, field.lowest ?? -Infinity), field.highest ?? Infinity);
  if (field.kind === "integer") return { from: within(value - COUNTED), to: within(value + COUNTED), steps: 2 * COUNTED + 1 };
  const by = AROUND * (Math.abs(value) || 1);
  return { from: within(tidy(value - by)), to: within(tidy(value + by)), steps: POINTS };
}

/** What may be followed over a field: `[{ id, title, pointer, unit, percent? }]`. */
export function followed(calculator, answer, path) {
  const { judgedIn, better = {}, swept = [] } = calculator;
  const numbers = [...new Set([...Object.keys(better), ...swept])].flatMap((name) => {
    const section = Object.keys(answer).find((id) => typeof answer[id]?.[name] === "number");
    if (!section) return [];
    return [{ title: quantityTitle(name, section), pointer: section === judgedIn ? `/${name}` : `/${section}/${name}`, unit: unitOf(name) }];
  });
  const shares = targetsOf(calculator, answer, path).filter(({ percent }) => percent);
  const torque = calculator.limit ? [{ title: message("checks.torque"), pointer: "/largest_torque_Nm", unit: "N·m" }] : [];
  const governing = { title: message("sweep.governing"), pointer: GOVERNING, percent: true };
  return [governing, ...torque, ...numbers, ...shares].map((one, id) => ({ unit: one.percent ? "%" : "", ...one, id: String(id) }));
}

export function sweepBody(calculator, shown, field, { from, to, steps }, { pointer }) {
  const round = field.kind === "integer" ? Math.round : (value) => Number(value.toPrecision(6));
  const values = Array.from({ length: steps }, (_, k) => round(from + ((to - from) * k) / (steps - 1)));
  return {
    calculation: calculator.path.slice(1),
    input: designOf(calculator, shown),
    axes: [{ pointer: `/${field.path.replaceAll(".", "/")}`, values: [...new Set(values)] }],
    outputs: [...new Set([pointer, GOVERNING])],
  };
}

/** The points of an answer: `{ x, y, status, check, used, why }`, where there is one, in canonical units. */
export function pointsOf({ axes: [{ values }], outputs, status, codes, governing, reasons }, { pointer, percent }, titles) {
  const why = new Map(reasons.flatMap(({ code, pointer: at, points }) => points.map((i) => [i, said("checks", code)?.title ?? titles.get(at?.split("/").pop()) ?? code])));
  return values.map((x, i) => ({
    x, y: outputs[pointer][i] === null ? null : outputs[pointer][i] * (percent ? 100 : 1),
    status: status[i], check: codes[governing[i]] && titleOf({ code: codes[governing[i]] }), used: outputs[GOVERNING][i], why: why.get(i),
  }));
}

const wordOf = ({ status }) => message("verdictWord")[status] ?? "";

/** What a point sets, with what follows its input. */
export function setsAt({ axes: [{ pointer, values }], linked }, i, shown) {
  const at = (where) => valueIn(shown, { path: pathOf(where) });
  const moved = values[i] - at(pointer);
  return Object.fromEntries([[pointer, values[i]], ...linked.map((one) => [one, tidy(at(one) + moved * (one.endsWith("diameter_mm") ? 2 : 1))])]);
}

/** A request as it is at the first point: alike whichever of the points the design at hand is. */
export function withPoint({ input, ...asked }, answer) {
  const same = structuredClone(input);
  for (const [pointer, value] of Object.entries(setsAt(answer, 0, { filled: input }))) {
    const keys = pathOf(pointer).split(".");
    const last = keys.pop();
    keys.reduce((part, key) => part?.[key], same)[last] = tidy(value);
  }
  return { ...asked, input: same };
}

/** The points as a table; `button(text, i)` is what loads one. */
export function sweepTable(points, field, quantity, button = (_, i) => points[i].x) {
  return {
    title: `${quantity.title} · ${field.title}`,
    columns: [{ title: field.title, unit: field.unit }, { title: quantity.percent ? message("sweep.used") : quantity.title, unit: quantity.unit }, { title: message("verdict.label") }, { title: message("checks.governing") }],
    rows: points.map((point, i) => [
      button(formatNumber(shownValue(point.x, field.unit)), i), point.y ?? "–", wordOf(point), point.why ?? point.check ?? "–",
    ]),
  };
}

const LOOKS = {
  light: { ink: "#1c2733", grid: "#e3e8ed", line: "#5a6875", bad: "#b3261e" },
  dark: { ink: "#e6edf3", grid: "#2b3642", line: "#9aa7b4", bad: "#ff8a80" },
};

/** The points as a figure: a colour for each check that governs, crosses where one fails or nothing is possible. */
export function sweepChart(points, field, quantity, now, theme) {
  const { ink, grid, line, bad } = LOOKS[theme];
  const across = ({ x }) => shownValue(x, field.unit);
  const known = points.filter(({ y, status }) => y !== null && status !== "impossible");
  const up = ({ y }) => shownValue(y, quantity.unit);
  const [least, most] = [Math.min(0, ...known.map(up)), Math.max(...known.map(up), quantity.percent ? 100 : 0)];
  const hover = (point) => [
    `${formatQuantity(point.x, field.unit)}: ${point.y === null ? "–" : formatQuantity(point.y, quantity.unit)}`,
    [wordOf(point), point.why ?? point.check].filter(Boolean).join(": "),
  ].filter(Boolean).join("<br>");
  const marks = (name, own, color, symbol) => ({
    type: "scatter", mode: "markers", name, x: own.map(across), y: own.map((point) => (point.status === "impossible" ? least : up(point))),
    text: own.map(hover), customdata: own.map((point) => points.indexOf(point)), hovertemplate: "%{text}<extra></extra>", cliponaxis: false,
    marker: { color, size: 10, symbol: own.map(symbol), line: { width: 0 } },
  });
  const checks = [...new Set(known.map(({ check }) => check ?? quantity.title))];
  const impossible = points.filter(({ status }) => status === "impossible");
  const axis = (title, unit) => ({
    title: { text: unit ? `${title}, ${shownUnit(unit)}` : title, font: { size: 13 } }, gridcolor: grid, linecolor: line, zerolinecolor: line, ticks: "outside", tickcolor: line,
    tickformat: ".6~g", automargin: true,
  });
  const shape = (place) => ({ type: "line", xref: "x", yref: "y", line: { color: line, width: 1, dash: "dash" }, ...place });
  return {
    data: [
      { type: "scatter", mode: "lines", x: points.map(across), y: points.map((point) => (known.includes(point) ? up(point) : null)), line: { color: ink, width: 1.5 }, hoverinfo: "skip", showlegend: false },
      ...checks.map((check, i) => marks(check, known.filter((point) => (point.check ?? quantity.title) === check), SERIES[theme][i % SERIES[theme].length], ({ status }) => (status === "fail" ? "x" : "circle"))),
      ...(impossible.length > 0 ? [marks(message("verdictWord.impossible"), impossible, bad, () => "x-open")] : []),
    ],
    layout: {
      font: { color: ink, family: "system-ui, sans-serif", size: 12 }, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      margin: { l: 56, r: 16, t: 16, b: 48 }, hovermode: "closest", showlegend: true, legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 },
      xaxis: axis(field.title, field.unit), yaxis: { ...axis(quantity.percent ? message("sweep.used") : quantity.title, quantity.unit), range: [least, 1.08 * most || 1] },
      shapes: [
        ...(quantity.percent ? [shape({ xref: "paper", x0: 0, x1: 1, y0: 100, y1: 100 })] : []),
        ...(now === undefined ? [] : [shape({ yref: "paper", y0: 0, y1: 1, x0: shownValue(now, field.unit), x1: shownValue(now, field.unit) })]),
      ],
    },
  };
}

/** Which inputs change the utilisation that governs: the usual sizes where the calculation has any, else numbers that the check hangs on. */
export function sensitivityBody(calculator, shown, fieldAt) {
  const { checks = [], governing } = judgedOf(calculator, shown.answer) ?? {};
  const own = (checks.find(({ code }) => code === governing)?.inputs ?? [])
    .filter((pointer) => fieldAt(pathOf(pointer))?.kind === "number" && valueIn(shown, { path: pathOf(pointer) }));
  return { calculation: calculator.path.slice(1), input: designOf(calculator, shown), ...(!calculator.limit && { inputs: own.slice(0, MOST) }) };
}

/** Its rows, the largest change first: `{ path, title, sides: [{ text, share, why }] }`, shares of the largest change. */
export function sensitivityRows({ inputs }, fieldAt) {
  const most = Math.max(...inputs.flatMap(({ minus, plus }) => [minus, plus].map(({ change = 0 }) => Math.abs(change)))) || 1;
  return inputs.map(({ pointer, minus, plus }) => {
    const field = fieldAt(pathOf(pointer));
    return {
      path: pathOf(pointer),
      title: field?.title ?? pointer,
      sides: [minus, plus].map(({ value, change, governing, reason }) => ({
        at: formatQuantity(value, field?.unit ?? "", ALL),
        share: change === undefined ? 0 : change / most,
        text: change === undefined ? said("checks", reason)?.title ?? "–" : `${change > 0 ? "+" : ""}${formatNumber(100 * change, 2)}\u00a0%`,
        check: governing && titleOf({ code: governing }),
      })),
    };
  });
}
