/** Teeth of cycloid discs on the pins of their ring: what is said of the service's answer. No DOM. */
import { inTwoLines } from "../../lib/chart.js";
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message } from "../../messages/index.js";

/** The service's figure, its titles no longer than its panels are high. */
const shape = ({ data, layout }) => ({
  data,
  layout: { ...layout, ...Object.fromEntries(["yaxis", "yaxis2", "yaxis3", "yaxis4"].map((axis) => [axis, inTwoLines(layout[axis])])) },
});

export const figure = {
  id: "teeth", section: "ring_mesh", path: "/crank-planetary/chart", height: 760, shape,
  body: (input, answer, [{ body }]) => ({ ...body, include: ["ring_mesh"] }),
};

const arcmin = (value) => formatQuantity(value, "′", 4);

export function cells({ over_turn: turn, ideal, efficiency }) {
  const title = (name) => message(`quantity.${name}`).title;
  const { satellite, pin } = turn.peak_pair;
  return [
    {
      label: title("max_pressure_MPa"),
      value: formatQuantity(turn.max_pressure_MPa, "MPa", 4),
      note: message("teeth.peak", { satellite, pin, force: formatQuantity(turn.peak_force_N, "N", 4), times: formatNumber(turn.peak_force_ratio, 3) }),
    },
    {
      label: title("backlash_max_arcmin"),
      value: arcmin(turn.backlash_max_arcmin),
      note: ideal.backlash_arcmin === undefined ? message("teeth.jams") : message("teeth.many", { backlash: arcmin(ideal.backlash_arcmin) }),
    },
    {
      label: title("transmission_error_arcmin"),
      value: arcmin(turn.transmission_error_arcmin),
      note: efficiency === undefined ? message("teeth.noFriction") : message("teeth.efficiency", { efficiency: formatNumber(efficiency.efficiency, 4) }),
    },
  ];
}
