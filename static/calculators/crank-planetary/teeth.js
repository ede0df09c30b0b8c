/** Teeth of satellites and ring, cycloid discs on pins or involute ones: what is said of the service's answer. No DOM. */
import { inTwoLines } from "../../lib/chart.js";
import { formatNumber, written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
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

const lost = (efficiency) => (efficiency === undefined ? message("teeth.noFriction")
  : message("teeth.efficiency", { efficiency: written(efficiency, "efficiency") }));

/** How the tips of involute teeth pass each other. */
function tipsOf({ tips_overlap_all_round: overlap, tip_interference_G: room }) {
  if (overlap) return message("teeth.overlap");
  return room === undefined ? message("teeth.apart") : message("teeth.tips", { room: formatNumber(room, 3) });
}

function involuteCells({ geometry, stresses, efficiency }) {
  return [
    quantityCell(stresses, "pressure_one_pair_start_MPa", message("teeth.start", { force: written(stresses, "normal_force_N") })),
    quantityCell(geometry, "contact_ratio", tipsOf(geometry)),
    quantityCell(geometry, "backlash_arcmin", lost(efficiency), quantityTitle("geometry_backlash_arcmin")),
  ];
}

export function cells({ over_turn: turn, ideal, efficiency, ...involute }) {
  if (turn === undefined) return involuteCells({ ...involute, efficiency });
  const pressure = quantityCell(turn, "max_pressure_MPa", message("teeth.peak", {
    ...turn.peak_pair, force: written(turn, "peak_force_N"), times: written(turn, "peak_force_ratio"),
  }));
  if (turn.backlash_max_arcmin === undefined) { // both meshes in series, whose play and stiffness are elsewhere
    const lag = { lag_arcmin: Math.max(turn.lag_max_arcmin, -turn.lag_min_arcmin) };
    return [
      pressure,
      quantityCell(lag, "lag_arcmin", message("teeth.both"), message("teeth.lag")),
      ...(efficiency === undefined ? [] : [quantityCell(efficiency, "efficiency", message("teeth.alone"))]),
    ];
  }
  const play = ideal.backlash_arcmin === undefined ? message("teeth.jams") : message("teeth.many", { backlash: written(ideal, "backlash_arcmin") });
  return [
    pressure,
    quantityCell(turn, "backlash_max_arcmin", play),
    quantityCell(turn, "transmission_error_arcmin", lost(efficiency)),
  ];
}
