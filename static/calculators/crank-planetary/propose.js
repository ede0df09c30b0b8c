/** Reducers from a requirement: what is asked of the service, and what its designs are called. No DOM. */
import { formatNumber } from "../../lib/format.js";
import { message } from "../../messages/index.js";
import { ratioOf } from "./mechanism.js";
import { pictureOf as drawn } from "./picture.js";
import { inputOf } from "./wanted.js";

const MOST = 3; // proposals, side by side

/** How the form is made of the schema (lib/schema_form.js). */
export const FORM = {
  path: "/propose",
  groups: ["propose"],
  inline: ["materials"],
  hidden: ["wanted"],
  arranged: {
    task: ["torque_Nm", "ratio", "outer_diameter_mm", "input_speed_rpm", "life_h", "process"],
    more: ["length_mm", "materials.disc", "application_factor", "ratio_to", "output", "discs", "min_efficiency", "max_backlash_arcmin"],
  },
};

export const asked = (input) => ({ ...input, wanted: MOST });

export const pictureOf = (input) => drawn(input.besides ? input : inputOf(input));

/** The answer; what is found on the way is told at once. */
export async function ask({ client, body, signal, progressed }) {
  const found = [];
  progressed(undefined, { found: [] });
  const answer = await client.post("/propose", body, {
    signal,
    progressed(share, { proposal }) {
      if (proposal) found.push(proposal);
      progressed(share, { found: [...found] });
    },
  });
  progressed(1, { found: answer.proposals });
  return answer;
}

/** Its ratio, the bearing of its satellites, number and diameter of its pins and of those of the ring. */
export function nameOf({ mechanism, bearing, contact, gear }) {
  return message("propose.name", {
    ratio: formatNumber(ratioOf(mechanism) + (mechanism.output === "ring" ? 1 : 0)),
    bearing: bearing?.name ?? "–",
    pins: mechanism.pins,
    diameter: formatNumber(2 * contact.pin_radius_mm),
    teeth: mechanism.ring_teeth,
    roller: formatNumber(2 * gear.ring_pin_radius_mm),
  });
}

const PLACES = ["/pin/satellite_positions_mm", "/pin/span_mm", "/crankshaft/satellite_positions_mm", "/crankshaft/bearing_positions_mm"];

/**
 * A design with the places along its axes that the service takes from housing and carrier: the drawings need them. A
 * life that was not `asked` for is left to the service, which says that it assumes one.
 */
export async function placed(client, { requirements: { life_h: life, ...others }, ...found }, { life_h: asked }) {
  const design = { ...found, requirements: asked === undefined ? others : { life_h: life, ...others } };
  const { assumed = [] } = await client.post("/crank-planetary", { ...design, include: ["checks"] }).catch(() => ({}));
  const places = assumed.filter(({ pointer }) => PLACES.includes(pointer)).map(({ pointer, value }) => [...pointer.slice(1).split("/"), value]);
  return places.reduce((whole, [part, name, value]) => ({ ...whole, [part]: { ...whole[part], [name]: value } }), design);
}
