/** Teeth of satellites and ring, cycloid discs on pins or involute ones: what is said of the service's answer. No DOM. */
import { inTwoLines } from "../../lib/chart.js";
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";

/** The service's figure, its titles no longer than its panels are high, where there are several. */
const shape = ({ data, layout }) => (!layout.yaxis4 ? { data, layout } : {
  data,
  layout: { ...layout, ...Object.fromEntries(["yaxis", "yaxis2", "yaxis3", "yaxis4"].map((axis) => [axis, inTwoLines(layout[axis])])) },
});

const [PATH, PANELS] = [420, 760]; // heights of the figures of involute teeth, and of discs on pins

export const figure = {
  id: "teeth", section: "ring_mesh", path: "/crank-planetary/chart", shape,
  height: ({ besides } = {}) => (besides?.gear?.kind === "cycloid" ? PANELS : PATH),
  body: (input, answer, [{ body }]) => ({ ...body, include: ["ring_mesh"] }),
};

const arcmin = (value) => formatQuantity(value, "′", 4);

const lost = (efficiency) => (efficiency === undefined ? message("teeth.noFriction")
  : message("teeth.efficiency", { efficiency: formatNumber(efficiency.efficiency, 4) }));

/** How the tips of involute teeth pass each other. */
function tipsOf({ tips_overlap_all_round: overlap, tip_interference_G: room }) {
  if (overlap) return message("teeth.overlap");
  return room === undefined ? message("teeth.apart") : message("teeth.tips", { room: formatNumber(room, 3) });
}

function involuteCells({ geometry, stresses, efficiency }) {
  const { pressure_one_pair_start_MPa: pressure, normal_force_N: force } = stresses;
  return [
    {
      label: quantityTitle("pressure_one_pair_start_MPa"),
      value: pressure === undefined ? "–" : formatQuantity(pressure, "MPa", 4),
      note: message("teeth.start", { force: formatQuantity(force, "N", 4) }),
    },
    { label: quantityTitle("contact_ratio"), value: formatNumber(geometry.contact_ratio, 3), note: tipsOf(geometry) },
    { label: quantityTitle("geometry_backlash_arcmin"), value: arcmin(geometry.backlash_arcmin), note: lost(efficiency) },
  ];
}

export function cells({ over_turn: turn, ideal, efficiency, ...involute }) {
  if (turn === undefined) return involuteCells({ ...involute, efficiency });
  const { satellite, pin } = turn.peak_pair;
  const pressure = {
    label: quantityTitle("max_pressure_MPa"),
    value: formatQuantity(turn.max_pressure_MPa, "MPa", 4),
    note: message("teeth.peak", { satellite, pin, force: formatQuantity(turn.peak_force_N, "N", 4), times: formatNumber(turn.peak_force_ratio, 3) }),
  };
  if (turn.backlash_max_arcmin === undefined) { // both meshes in series, whose play and stiffness are elsewhere
    const lag = Math.max(turn.lag_max_arcmin, -turn.lag_min_arcmin);
    return [
      pressure,
      { label: message("teeth.lag"), value: arcmin(lag), note: message("teeth.both") },
      ...(efficiency === undefined ? [] : [{ label: quantityTitle("efficiency"), value: formatNumber(efficiency.efficiency, 4), note: message("teeth.alone") }]),
    ];
  }
  return [
    pressure,
    {
      label: quantityTitle("backlash_max_arcmin"),
      value: arcmin(turn.backlash_max_arcmin),
      note: ideal.backlash_arcmin === undefined ? message("teeth.jams") : message("teeth.many", { backlash: arcmin(ideal.backlash_arcmin) }),
    },
    {
      label: quantityTitle("transmission_error_arcmin"),
      value: arcmin(turn.transmission_error_arcmin),
      note: lost(efficiency),
    },
  ];
}
