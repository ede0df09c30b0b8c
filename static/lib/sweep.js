/** A result over one input or two, and inputs that matter: what is asked of the service and what its answer says. No DOM. */
import { judgedOf, pathOf, titleOf } from "./checks.js";
import { ALL, formatNumber, formatQuantity, tidy, unitOf } from "./format.js";
import { fieldsOf } from "./schema_form.js";
import { designOf, targetsOf, valueIn } from "./sizing.js";
import { shownValue } from "./units.js";
import { message, quantityTitle, said } from "../messages/index.js";

export const GOVERNING = "/checks/governing/utilisation";
const [AROUND, POINTS, COUNTED] = [0.3, 13, 3]; // to both sides: a share of the value, or so many where it is counted
const FEW = 5; // of a second input: the value at hand in the middle
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

/** From where to where a field is swept unless something else is said, in canonical units; `few` values of it. */
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
  const torque = calculator.limit ? [{ title: quantityTitle("largest_torque_Nm"), pointer: "/largest_torque_Nm", unit: "N·m" }] : [];
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

export const wordOf = ({ status }) => message("verdictWord")[status] ?? "";

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
