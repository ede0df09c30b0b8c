/**
 * The mechanism as it is made, with clearance, errors and elasticity: what is asked of the service and what its answer
 * says. No DOM.
 */
import { inTwoLines } from "../../lib/chart.js";
import { formatAngle, formatNumber, formatQuantity, quantityParts, written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message, quantityTitle } from "../../messages/index.js";
import { eccentricityOf, MOST_PAIRS, refuseMore } from "./mechanism.js";
import { documentOf } from "./wanted.js";

/** What is left between pin and hole by their sizes, without the noise of binary differences. */
function playOf(contact) {
  return Number((contact.hole_radius_mm - contact.pin_radius_mm - eccentricityOf(contact)).toFixed(10));
}

export const live = true;

/** What the boxes ask: the body. */
export const asked = (input) => ({ ...documentOf(input), lost_motion_torque_share: input.besides?.lost_motion_torque_share });

/** The body of the figure. */
export function drawn(body) {
  refuseMore(body.mechanism, MOST_PAIRS.drawn);
  return body;
}

export function ask({ client, body, signal }) {
  refuseMore(body.mechanism, MOST_PAIRS.turned);
  return client.post("/load-sharing", { ...body, include: ["over_turn", "ideal"] }, { signal })
    .then((answer) => ({ ...answer, clearance_mm: body.contact.fit ? answer.fit.least_room_mm : body.contact.hole_clearance_mm ?? playOf(body.contact) }));
}

/** From one value to another, with the unit once; one value where both read the same. */
export function range(from, to, unit, digits) {
  const [least, most] = [from, to].map((value) => quantityParts(value, unit, digits).value);
  const last = formatQuantity(to, unit, digits);
  return least === most ? last : message("real.range", { from: least, to: last });
}

const DOMAINS = { yaxis2: [0.66, 1], yaxis3: [0.38, 0.58], yaxis4: [0, 0.25] };

/** The service's figure without its forces, which have a figure of their own. */
function shape({ data, layout: { yaxis, ...layout } }) {
  return {
    data: data.filter((trace) => trace.yaxis),
    layout: {
      ...layout,
      ...Object.fromEntries(Object.entries(DOMAINS).map(([axis, domain]) => [axis, {
        ...inTwoLines(layout[axis]), domain,
      }])),
    },
  };
}

/** Its figure. */
export const figure = { id: "real", path: "/load-sharing/chart", body: drawn, shape, height: 680 };

export const note = "real.lines";

/** The numbers that decide, as cells: `{ label, value, note }`. */
export function cells({ over_turn: turn, ideal }) {
  const at = message("verdict.peakAt", { angle: formatAngle(turn.peak_crank_angle_deg), ...turn.peak_pair });
  return [
    quantityCell(turn, "peak_force_N", at, quantityTitle("peak_force_N", "load_sharing")),
    quantityCell(ideal, "ratio", message("real.ideal", { force: written(ideal, "peak_force_N") }), message("real.ratio")),
    quantityCell(turn, "backlash_max_arcmin", message("real.least", { value: written(turn, "backlash_min_arcmin") })),
  ];
}

/** The rest as rows: `[title, value]`. */
export function rows({ over_turn: turn, clearance_mm: clearance }, { lost_motion_torque_share: share = 0.03 }) {
  const own = (name) => [quantityTitle(name, "load_sharing"), written(turn, name)];
  return [
    [message("choice.play.radial"), formatQuantity(clearance, "mm")],
    [message("real.lostMotion", { share: formatNumber(100 * share, 3) }), written(turn, "lost_motion_arcmin")],
    own("transmission_error_arcmin"),
    own("unloaded_transmission_error_arcmin"),
    [message("real.stiffness"), range(turn.stiffness_min_Nm_per_arcmin, turn.stiffness_max_Nm_per_arcmin, "N·m/′")],
    [message("real.loaded"), range(turn.loaded_pairs_min, turn.loaded_pairs_max, "")],
    own("max_pressure_MPa"),
    own("input_torque_ripple_Nm"),
  ];
}

/** What the numbers mean, `[level, sentence]`. */
export function sentences({ over_turn: turn, ideal }, { mechanism: { pins, satellites = 1 } }) {
  return [
    ["", message(ideal.ratio > 1.001 ? "real.more" : "real.alike", {
      ratio: formatNumber(ideal.ratio, 3), loaded: range(turn.loaded_pairs_min, turn.loaded_pairs_max, ""), all: pins * satellites,
    })],
    turn.pressed_without_load && ["warning", message("real.pressed")],
  ].filter(Boolean);
}
