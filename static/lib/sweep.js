/** A result over one input or two, and inputs that matter: what is asked of the service and what its answer says. No DOM. */
import { SERIES } from "./chart.js";
import { judgedOf, pathOf, titleOf } from "./checks.js";
import { ALL, formatNumber, formatQuantity, tidy, unitOf } from "./format.js";
import { fieldsOf } from "./schema_form.js";
import { designOf, targetsOf, valueIn } from "./sizing.js";
import { shownUnit, shownValue } from "./units.js";
import { message, quantityTitle, said } from "../messages/index.js";

const GOVERNING = "/checks/governing/utilisation";
const [AROUND, POINTS, COUNTED] = [0.3, 13, 3]; // to both sides: a share of the value, or so many where it is counted
const FEW = 4; // lines of a second input
const MOST = 12; // inputs
const [PIN, ECCENTRICITY] = ["/contact/pin_radius_mm", "/contact/eccentricity_mm"];
/** How much inputs move with those that vary. */
const LINKED = { "/contact/hole_radius_mm": { [PIN]: 1, [ECCENTRICITY]: 1 }, "/pin/diameter_mm": { [PIN]: 2 } };

const pointerOf = ({ path }) => `/${path.replaceAll(".", "/")}`;

/** Fields that may be swept beside another one, by their groups: `[title, fields]`. */
export function sweptBeside(model, shown, field) {
  const swept = (one) => one !== field && ["number", "integer"].includes(one.kind) && valueIn(shown, one) !== undefined;
  return model.groups.map(({ id, wanted, items }) => [wanted ? items[0].title : message(`group.${id}`), items.flatMap(fieldsOf).filter(swept)])
    .filter(([, fields]) => fields.length > 0);
}

/** From where to where a field is swept unless something else is said, in canonical units; `few` lines of it. */
export function rangeOf(field, shown, few) {
  const value = valueIn(shown, field);
  const within = (number) => Math.min(Math.max(number, field.lowest ?? -Infinity), field.highest ?? Infinity);
  const counted = few ? 1 : COUNTED;
  if (field.kind === "integer") return { from: within(value - counted), to: within(value + counted), steps: 2 * counted + 1 };
  const by = AROUND * (Math.abs(value) || 1);
  return { from: within(tidy(value - by)), to: within(tidy(value + by)), steps: few ? FEW : POINTS };
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

function axisOf({ field, from, to, steps }) {
  const round = field.kind === "integer" ? Math.round : (value) => Number(value.toPrecision(6));
  const values = Array.from({ length: steps }, (_, k) => round(from + ((to - from) * k) / (steps - 1)));
  return { pointer: pointerOf(field), values: [...new Set(values)] };
}

/** `ranges` are one or two, `{ field, from, to, steps }`. */
export function sweepBody(calculator, shown, ranges, { pointer }) {
  return {
    calculation: calculator.path.slice(1),
    input: designOf(calculator, shown),
    axes: ranges.map(axisOf),
    outputs: [...new Set([pointer, GOVERNING])],
  };
}

/** Values of the axes at each point, of which the last varies first. */
const placesOf = ([{ values }, ...others]) => (others.length === 0 ? values.map((x) => [x]) : values.flatMap((x) => placesOf(others).map((more) => [x, ...more])));

/** The points of an answer: `{ x, z, y, status, check, used, why }`, `z` of the second input, in canonical units. */
export function pointsOf({ axes, outputs, status, codes, governing, reasons }, { pointer, percent }, titles) {
  const why = new Map(reasons.flatMap(({ code, pointer: at, points }) => points.map((i) => [i, said("checks", code)?.title ?? titles.get(at?.split("/").pop()) ?? code])));
  return placesOf(axes).map(([x, z], i) => ({
    x, z, y: outputs[pointer][i] === null ? null : outputs[pointer][i] * (percent ? 100 : 1),
    status: status[i], check: codes[governing[i]] && titleOf({ code: codes[governing[i]] }), used: outputs[GOVERNING][i], why: why.get(i),
  }));
}

const wordOf = ({ status }) => message("verdictWord")[status] ?? "";

/** What a point sets, with what follows its inputs. */
export function setsAt({ axes, linked }, i, shown) {
  const at = (where) => valueIn(shown, { path: pathOf(where) });
  const set = placesOf(axes)[i].map((value, k) => [axes[k].pointer, value]);
  const moved = (one) => set.reduce((sum, [pointer, value]) => sum + (LINKED[one][pointer] ?? 0) * (value - at(pointer)), 0);
  return Object.fromEntries([...set, ...linked.map((one) => [one, tidy(at(one) + moved(one))])]);
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

/** The points as a table over one field or two; `button(text, i)` is what loads one. */
export function sweepTable(points, fields, quantity, button = (_, i) => points[i].x) {
  const [field, beside] = fields;
  return {
    title: `${quantity.title} · ${fields.map(({ title }) => title).join(" · ")}`,
    columns: [...fields.map(({ title, unit }) => ({ title, unit })), { title: quantity.percent ? message("sweep.used") : quantity.title, unit: quantity.unit }, { title: message("verdict.label") }, { title: message("checks.governing") }],
    rows: points.map((point, i) => [
      button(formatNumber(shownValue(point.x, field.unit)), i), ...(beside ? [point.z] : []), point.y ?? "–", wordOf(point), point.why ?? point.check ?? "–",
    ]),
  };
}

const LOOKS = {
  light: { ink: "#1c2733", grid: "#e3e8ed", line: "#5a6875", bad: "#b3261e" },
  dark: { ink: "#e6edf3", grid: "#2b3642", line: "#9aa7b4", bad: "#ff8a80" },
};

/**
 * The points as a figure: a line for each value of a second field; a colour for each of these, else for each check that
 * governs; crosses where one fails or nothing is possible.
 */
export function sweepChart(points, [field, beside], quantity, now, theme) {
  const { ink, grid, line, bad } = LOOKS[theme];
  const across = ({ x }) => shownValue(x, field.unit);
  const known = points.filter(({ y, status }) => y !== null && status !== "impossible");
  const up = ({ y }) => shownValue(y, quantity.unit);
  const [least, most] = [Math.min(0, ...known.map(up)), Math.max(...known.map(up), quantity.percent ? 100 : 0)];
  const hover = (point) => [
    `${[formatQuantity(point.x, field.unit), ...(beside ? [nameOf(point)] : [])].join(", ")}: ${point.y === null ? "–" : formatQuantity(point.y, quantity.unit)}`,
    [wordOf(point), point.why ?? point.check].filter(Boolean).join(": "),
  ].filter(Boolean).join("<br>");
  const marks = (name, own, color, symbol) => ({
    type: "scatter", mode: "markers", name, x: own.map(across), y: own.map((point) => (point.status === "impossible" ? least : up(point))),
    text: own.map(hover), customdata: own.map((point) => points.indexOf(point)), hovertemplate: "%{text}<extra></extra>", cliponaxis: false,
    marker: { color, size: 10, symbol: own.map(symbol), line: { width: 0 } },
  });
  const nameOf = ({ z, check }) => (beside ? `${beside.title} ${formatQuantity(z, beside.unit)}` : check ?? quantity.title);
  const names = [...new Set(known.map(nameOf))];
  const colorOf = (i) => SERIES[theme][i % SERIES[theme].length];
  const lines = beside ? [...new Set(points.map(({ z }) => z))].map((z) => points.filter((point) => point.z === z)) : [points];
  const impossible = points.filter(({ status }) => status === "impossible");
  const axis = (title, unit) => ({
    title: { text: unit ? `${title}, ${shownUnit(unit)}` : title, font: { size: 13 } }, gridcolor: grid, linecolor: line, zerolinecolor: line, ticks: "outside", tickcolor: line,
    tickformat: ".6~g", automargin: true,
  });
  const shape = (place) => ({ type: "line", xref: "x", yref: "y", line: { color: line, width: 1, dash: "dash" }, ...place });
  return {
    data: [
      ...lines.map((own) => ({
        type: "scatter", mode: "lines", x: own.map(across), y: own.map((point) => (known.includes(point) ? up(point) : null)),
        line: { color: beside ? colorOf(Math.max(0, names.indexOf(nameOf(own[0])))) : ink, width: 1.5 }, hoverinfo: "skip", showlegend: false,
      })),
      ...names.map((name, i) => marks(name, known.filter((point) => nameOf(point) === name), colorOf(i), ({ status }) => (status === "fail" ? "x" : "circle"))),
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
