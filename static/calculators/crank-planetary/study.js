/** What tolerances do to the pieces: what is asked of the service and what its answer says. No DOM. */
import { formatNumber, formatQuantity, shownDigits, unitOf } from "../../lib/format.js";
import { fieldWords, message, quantityTitle } from "../../messages/index.js";
import { range } from "./real.js";
import { documentOf } from "./wanted.js";

const LOWER = "stiffness_min_Nm_per_arcmin"; // of which less is worse: all else is worse above
const CLEAR = 0.02; // the share of a percentile that a tolerance has to move to be worth tightening

/** What the boxes ask: the body of the request. */
export function asked(input) {
  const { study: { ranked } = {}, tolerances = {}, quantities, samples, seed, crank_angles, percentiles, limits, lost_motion_torque_share } = input.besides ?? {};
  const include = ["histogram", ...ranked === "ranked" ? ["contributions"] : []];
  return { ...documentOf(input), tolerances, quantities, samples, seed, crank_angles, percentiles, limits, lost_motion_torque_share, include };
}

export const ask = ({ client, body, signal, progressed }) => client.post("/tolerance-study", body, { signal, progressed });

export const titleOf = (name) => quantityTitle(name, "load_sharing");

const share = (value, digits = 3) => `${formatNumber(100 * value, digits)}\u00a0%`;
const digitsOf = ({ value, low, high }) => Math.max(3, shownDigits((high - low) / 2 / Math.abs(value), 4) + 2);

function estimate(one, unit) {
  const digits = digitsOf(one);
  return { value: formatQuantity(one.value, unit, digits), interval: range(one.low, one.high, unit, digits) };
}

/** A quantity for its table and figure. */
export function quantityOf(name, of) {
  const unit = unitOf(name);
  const amount = (value) => formatQuantity(value, unit);
  const marks = [
    ...(of.nominal === undefined ? [] : [
      { id: "nominal", title: message("study.nominal"), at: of.nominal, value: amount(of.nominal), interval: "" },
    ]),
    ...of.percentiles.map((one) => ({
      id: `p${one.percent}`, title: message("study.percentile", { percent: formatNumber(one.percent) }), at: one.value, ...estimate(one, unit),
    })),
    ...(of.yield ? [{
      id: "limit",
      title: message("study.yield", { limit: amount(of.yield.limit) }),
      at: of.yield.limit,
      value: share(of.yield.value),
      interval: message("real.range", { from: formatNumber(100 * of.yield.low, 3), to: share(of.yield.high) }),
    }] : []),
  ];
  return { name, title: titleOf(name), unit, marks, histogram: of.histogram, contributions: of.contributions };
}

/** How the histogram is drawn: bars and marks as shares of its width and height. */
export function barsOf({ edges, counts }, marks) {
  const [low, high] = marks.reduce(([from, to], { at }) => [Math.min(from, at), Math.max(to, at)], [edges[0], edges.at(-1)]);
  const width = high - low || 1;
  const most = Math.max(...counts);
  const along = (value) => (value - low) / width;
  return {
    low,
    high,
    bars: counts.map((count, i) => ({ x: along(edges[i]), width: along(edges[i + 1]) - along(edges[i]), height: count / most, count })),
    marks: marks.map(({ id, at }) => ({ id, x: along(at) })),
  };
}

/** The ranked contributions: `{ title, total, error, alone, without, change }`, of the first quantity. */
export function ranked(name, { contributions = [], percentiles }) {
  const unit = unitOf(name);
  const at = ({ percent }) => percentiles.find((one) => one.percent === percent)?.value;
  return contributions.map(({ percentile_without: without, ...one }) => ({
    ...rowOf(one),
    percent: without.percent,
    without: estimate(without, unit).value,
    change: at(without) ? without.value / at(without) - 1 : 0,
    clear: at(without) !== undefined && (name === LOWER ? without.value > at(without) : without.value < at(without)),
  }));
}

const rowOf = ({ source, total, total_error: error, first }) => ({
  source,
  title: sourceTitle(source),
  total: Math.max(total, 0),
  text: `${share(Math.max(total, 0), 2)} ± ${share(1.96 * error, 2)}`,
  alone: share(Math.max(first, 0), 2),
});

/** The same of whether the pieces fit, where too few do to ask it of a quantity. */
export const rankedFit = ({ fit_contributions: contributions = [] }) =>
  contributions.map(({ fits_without: fits, ...one }) => ({ ...rowOf(one), without: share(fits.value) }));

/** A tolerance by its name in the request. */
export const sourceTitle = (source) => fieldWords(source, "tolerances")?.title ?? source;

/** What to tighten first, and what does hardly anything, `[level, sentence]`. */
export function advice(name, of) {
  const rows = ranked(name, of);
  if (rows.length === 0) return [];
  const [best] = rows.filter(({ clear, change }) => clear && Math.abs(change) > CLEAR).sort((one, other) => Math.abs(other.change) - Math.abs(one.change));
  const quantity = titleOf(name);
  const idle = rows.filter(({ change, total }) => Math.abs(change) < CLEAR / 2 && total < 0.1).map(({ title }) => title);
  return [
    best ? ["", message("study.tighten", { quantity, source: best.title, percent: formatNumber(best.percent), without: best.without, change: share(Math.abs(best.change), 2) })]
      : ["", message("study.none", { quantity })],
    idle.length > 0 && ["", message("study.idle", { quantity, sources: idle.join("; ") })],
    rows.reduce((sum, { total }) => sum + total, 0) > 1.2 && ["", message("study.together")],
  ].filter(Boolean);
}

/** How the parts are made, and which tolerances that stands for, in words. */
function processOf({ code, pin_code: ofPins, source, pin_source: pinSource, filled, mean_clearance_mm: clearance }) {
  return {
    process: [code, ofPins].filter(Boolean).map((one) => message(`option.${one}`)).join("; "),
    filled: filled.map((pointer) => sourceTitle(pointer.split("/").pop())).join("; "),
    clearance: formatQuantity(clearance, "mm", 3),
    source: [source, pinSource].filter(Boolean).join("; "),
  };
}

/** How exact the numbers of a quantity are, in words, and which pieces are no good. */
export function exactness(name, of, { process: made, samples, cannot_assemble: pressed, binds_in_turning: binds = 0, cannot_work: broken }) {
  const error = Math.max(...of.percentiles.map(({ value, low, high }) => Math.min((high - low) / 2 / Math.abs(value), 1) || 0));
  const quantity = titleOf(name);
  return [
    made && ["warning", message("study.process", processOf(made))],
    of.percentiles.length > 0 && ["", message("study.sampling", { quantity, error: share(error, 2), samples })],
    ["", message("study.grid", { quantity, error: share(of.angle_grid_error, 2) })],
    pressed.value > 0 && ["warning", message("study.pressed", { share: share(pressed.value), low: formatNumber(100 * pressed.low, 2), high: share(pressed.high, 2), binds })],
    broken > 0 && ["bad", message("study.broken", { count: broken })],
  ].filter(Boolean);
}
