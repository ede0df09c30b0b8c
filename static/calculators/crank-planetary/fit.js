/** Whether pins and holes go together and turn, by geometry: what is asked of the service and what its answer says. No DOM. */
import { formatAngle, formatNumber, formatQuantity, tidy } from "../../lib/format.js";
import { DIAMETER, inDiameters } from "../../lib/units.js";
import { message, quantityTitle } from "../../messages/index.js";
import { figureText, warningText } from "../../service_texts.js";
import { MOST_PAIRS, refuseMore } from "./mechanism.js";
import { range } from "./real.js";

const MOST_PLACES = 6; // stretches that are written

export const live = true;

export { documentOf as asked } from "./wanted.js";

export function ask({ client, body, signal }) {
  refuseMore(body.mechanism, MOST_PAIRS.drawn);
  return client.post("/fit", { ...body, include: ["discs", "elastic"] }, { signal });
}

/** Holes that do not hold their pins have no room to draw. */
export const drawable = ({ fit }) => fit.state !== "no_bound";

export const figure = { id: "fit", path: "/fit/chart", height: 420 };

const mm = (value) => formatQuantity(tidy(value), "mm");
const arcmin = (value) => (value === undefined ? "" : message("fit.turns", { angle: formatQuantity(value, "′") }));
const pairText = ({ satellite, pin, side }) => message(`fit.${side}`, { satellite, pin });

/** The pairs that limit the room, those of either sense against each other. */
function bindingText(binding = []) {
  const [one, other] = ["driving", "reverse"].map((side) => binding.filter((pair) => pair.side === side));
  if (one.length > 0 && other.length > 0) {
    return message("fit.between", { one: one.map(pairText).join(", "), other: other.map(pairText).join(", ") });
  }
  return binding.length > 0 ? message("fit.at", { pairs: binding.map(pairText).join(", ") }) : message("fit.all");
}

const stateOf = ({ state, misfit }) => (["pressed_without_load", "fits_by_bearing_clearance"].includes(misfit) ? misfit : state);
const LEVELS = { fits: "good", fits_by_bearing_clearance: "warning", pressed_without_load: "warning" };

/** The numbers that decide, as cells: `{ label, value, level, note }`. */
export function cells({ fit }) {
  const { state, least_room_mm: least, greatest_room_mm: most, least_room_crank_angle_deg: angle } = fit;
  const word = {
    label: message("group.pins"),
    value: message(`fit.${stateOf(fit)}`),
    level: LEVELS[stateOf(fit)] ?? "bad",
    note: state === "fits" || state === "no_bound" ? "" : bindingText(fit.binding),
  };
  if (state === "no_bound") return [word];
  return [
    word,
    {
      label: figureText("least_room"),
      value: mm(least),
      note: [arcmin(fit.least_room_arcmin), angle !== undefined && `φ\u00a0=\u00a0${formatAngle(angle)}`].filter(Boolean).join("; "),
    },
    { label: message("fit.greatest"), value: mm(most), note: arcmin(fit.greatest_room_arcmin) },
  ];
}

/** A crank angle within the turn of the wave, after which all comes again. */
const stretch = ([from, to]) => range(from, to, "°");

/** What the numbers mean, `[level, sentence]`. */
export function sentences({ fit }, body, titles) {
  const { state, misfit, binding, blocked_crank_deg: blocked = [], blocked_share: share, elastic = {} } = fit;
  const size = (radius) => formatQuantity(radius, inDiameters() ? DIAMETER : "mm", 6); // to be made, and a hair decides
  const holes = inDiameters() ? message("fit.diameter") : message("fit.radius");
  const said = (code) => `${warningText({ code, params: {} }, titles)}`.replace(/[^.]$/, "$&.");
  if (state === "no_bound") return [["bad", message("fit.unheld", { holes, size: size(fit.largest_hole_radius_mm) })]];
  const all = [];
  if (state === "fits") all.push(["", message(fit.least_room_crank_angle_deg === undefined ? "fit.evenly" : "fit.limited", { pairs: bindingText(binding) })]);
  else if (misfit === "jams") {
    all.push(["bad", message("fit.jams", {
      share: formatNumber(100 * (1 - share), 3), pairs: bindingText(binding), missing: mm(-fit.least_room_mm),
      places: blocked.slice(0, MOST_PLACES).map(stretch).join("; ") + (blocked.length > MOST_PLACES ? " …" : ""),
      turn: formatAngle(blocked.reduce((sum, [from, to]) => sum + to - from, 0) / share),
    })]);
  } else if (misfit === "cannot_assemble") all.push(["bad", message("fit.misses", { pairs: bindingText(binding), missing: mm(-fit.least_room_mm) })]);
  else all.push([LEVELS[misfit] ?? "bad", said(misfit)]);
  if (fit.needed_hole_radius_mm !== undefined) {
    all.push(["", message("fit.needed", { holes, size: size(fit.needed_hole_radius_mm) })]);
    if (fit.blocked_crank_deg || misfit === "cannot_assemble") all.push(["", message("fit.orPlace")]);
  }
  if (state !== "fits" && elastic.limit_mm !== undefined) {
    all.push(["", message("fit.elastic", { limit: mm(elastic.limit_mm), force: formatQuantity(elastic.limit_force_N, "N") })]);
  }
  return all;
}

/** The rest as rows: `[title, value]`. */
export function rows({ fit }) {
  const { elastic = {}, renumbered } = fit;
  return [
    fit.blocked_share !== undefined && [message("fit.blocked"), `${formatNumber(100 * fit.blocked_share, 3)}\u00a0%`],
    elastic.force_without_load_N !== undefined && [message("fit.force"), formatQuantity(elastic.force_without_load_N, "N")],
    elastic.pressure_without_load_MPa !== undefined && [message("fit.pressure"), formatQuantity(elastic.pressure_without_load_MPa, "MPa")],
    elastic.limit_mm !== undefined && fit.state === "fits" && [message("fit.limit"), `${mm(elastic.limit_mm)}; ${formatQuantity(elastic.limit_force_N, "N")}`],
    renumbered && [message("fit.renumbered"), renumbered.join("; ")],
  ].filter(Boolean);
}

/** Each satellite by itself, where they differ. */
export function tables({ fit: { discs = [], least_room_mm: all } }) {
  if (discs.length < 2 || discs.every(({ least_room_mm: room, turned_deg: turned }) => Math.abs(room - all) < 1e-9 && Math.abs(turned) < 1e-9)) return [];
  return [{
    title: message("fit.discs"),
    columns: [{ title: quantityTitle("satellite") }, { title: figureText("least_room"), unit: "mm" }, { title: message("fit.turned"), unit: "°" }],
    rows: discs.map(({ satellite, least_room_mm: room, turned_deg: turned }) => [String(satellite), tidy(room), Math.abs(turned) < 1e-9 ? 0 : turned]),
  }];
}
