/**
 * The crank-planetary mechanism at a crank angle, from the inputs, defaults filled in, and the service's answer. No DOM.
 *
 * Lengths in mm, angles in degrees; Y up through pin 1 at crank angle 0, X to the right. The crank
 * turns clockwise, the pins the other way, as the nomenclature has it.
 */
import { Problem } from "../../lib/api.js";

const RADIAN = Math.PI / 180;

/** Most pairs that the service takes: of a mechanism, of its forces as made over a turn, of a figure. */
export const MOST_PAIRS = { all: 10_000, turned: 1000, drawn: 240 };

/** Refuse more pairs as the service would, without asking it. */
export function refuseMore({ pins, satellites = 1 }, most) {
  if (!(pins * satellites > most)) return;
  const params = { limit: Math.floor(most / satellites), satellites };
  throw new Problem({ status: 422, errors: [{ pointer: "/mechanism/pins", code: "too_many_pairs", params }] });
}

function modulo(value, period) {
  return value - period * Math.floor(value / period);
}

/** The ratio of crank and pins as a number: a sign is that of the pins, which the service takes off; a coupling has no end of it. */
export function ratioOf({ output, ratio, output_ratio: ofRing, satellite_teeth: z2, ring_teeth: z3 }) {
  if (output === "coupling") return Infinity;
  return Math.abs(ratio ?? (ofRing === undefined ? z2 / (z3 - z2) : ofRing - 1));
}

const OF_RINGS = ["ratio", "output_ratio", "satellite_teeth", "ring_teeth", "satellites", "crank_spacing_deg", "crank_angles_deg"];

/** A mechanism as it is asked for: of a coupling without what is about a ring and cranks. */
export function askedOf(mechanism = {}) {
  if (mechanism.output !== "coupling") return mechanism;
  return Object.fromEntries(Object.entries(mechanism).filter(([name]) => !OF_RINGS.includes(name)));
}

/** Angles of the cranks against the first, degrees. */
export function cranksOf({ output, satellites, crank_spacing_deg: spacing, crank_angles_deg: angles }) {
  if (output === "coupling") return [0];
  return angles ?? Array.from({ length: satellites }, (_, j) => j * (spacing ?? 360 / satellites));
}

export function eccentricityOf({ eccentricity_mm: eccentricity, hole_radius_mm: hole, pin_radius_mm: pin }) {
  return eccentricity ?? hole - pin;
}

/** Radius of the pin inside its sleeve or its rollers, which what is assumed may say; none of a bare pin. */
function insideOf({ rolling, rollers, strength, pin } = {}, assumed = []) {
  if (rolling?.on === "on") {
    return (rollers?.bore_diameter_mm ?? assumed.find(({ pointer }) => pointer === "/rollers/bore_diameter_mm")?.value) / 2;
  }
  return strength?.on === "on" && strength.surface === "sleeved" ? pin?.diameter_mm / 2 : NaN;
}

/** Involute teeth of satellites and ring, as the answer draws them. */
function involuteOf(mechanism, { teeth_difference: difference = 1 }, { lobe_mm: lobe, turn_deg: turns, ring_lobe_mm: ringLobe, ring_turn_deg: ringTurn }) {
  const lobes = Math.round(ratioOf(mechanism) * difference);
  const circle = Math.max(...ringLobe.map((point) => Math.hypot(...point)));
  return { circle, radius: 0, lobe, lobes, turns, ringLobe, ringTurn, ringTeeth: lobes + difference, pins: [], peak: 0, widest: 0 };
}

/**
 * The ring of pins and the discs in it: with their profile, forces and gaps where the answer has them, else the pins by
 * their sizes alone; or involute teeth, once their outlines are known; null where they are not given.
 */
function ringOf({ mechanism, besides: { bearings, gear = {} } = {} }, drawing) {
  if (bearings?.on === "on" && gear.kind === "involute") {
    const { satellite_teeth: z2, ring_teeth: z3 } = mechanism;
    return drawing ? involuteOf(mechanism, z2 && z3 ? { teeth_difference: z3 - z2 } : gear, drawing) : null;
  }
  const { kind, ring_pin_circle_radius_mm: circle, ring_pin_radius_mm: radius, pin_support: support = "seat" } = gear;
  const lobes = ratioOf(mechanism);
  const [count, pairs] = [lobes + 1, (lobes + 1) * mechanism.satellites];
  if (bearings?.on !== "on" || kind !== "cycloid" || !(circle > 0 && radius > 0) || !Number.isInteger(count) || pairs > MOST_PAIRS.drawn) return null;
  const own = { circle, radius, lobes, seated: support === "seat", peak: 0, widest: 0 };
  if (drawing) {
    const { lobe_mm: lobe, turn_deg: turns, ring_pins: pins, crank_angle_deg: x, force_N: force, gap_mm: gap } = drawing;
    const { repeats_after_deg: period, pins_further: further } = drawing;
    return {
      ...own, lobe, turns, pins: pins.map(({ centre_mm: centre, radius_mm: size }) => ({ centre, radius: size })),
      ...(x && { x, period, further, force, gap, peak: Math.max(...force.flat(2)), widest: Math.max(...gap.flat(2)) }),
    };
  }
  const step = gear.every_second_pin && count % 2 === 0 ? 2 : 1;
  const centres = evenly(count / step, circle, -(mechanism.initial_crank_angle_deg ?? 0));
  return { ...own, pins: centres.map((centre) => ({ centre, radius })) };
}

/** What of the inputs and their answer the drawing needs; sizes that make no mechanism are left out. */
export function mechanismOf({ mechanism, load = {}, contact = {}, besides }, { cyclogram, assumed, ring_drawing: drawing }) {
  const inside = insideOf(besides, assumed);
  const { pin_radius_mm: pinRadius, hole_radius_mm: holeRadius } = contact;
  const eccentricity = eccentricityOf(contact);
  return {
    pins: mechanism.pins,
    cranks: cranksOf(mechanism),
    ratio: ratioOf(mechanism),
    start: mechanism.initial_crank_angle_deg,
    radius: load.pin_circle_radius_mm,
    ...(holeRadius > pinRadius && eccentricity > 0 && { pinRadius, holeRadius, eccentricity, ...(inside < pinRadius && { inside }) }),
    end: cyclogram.driving_count.at(-1).to_deg,
    period: cyclogram.period_deg,
    ring: ringOf({ mechanism, besides }, drawing),
    involute: besides?.bearings?.on === "on" && besides.gear?.kind === "involute",
    dead: cyclogram.dead_centres_deg ?? [],
    pairs: cyclogram.pairs,
  };
}

/** Radii of the pitch circles of satellite and ring, whose difference is the eccentricity. */
export function pitchRadii({ eccentricity, ratio }) {
  return { satellite: eccentricity * ratio, ring: eccentricity * (ratio + 1) };
}

/** Angle of pin 1 from Y, against the clock. */
export function pinAngle({ ratio }, angle) {
  return Number.isFinite(ratio) ? modulo(angle, 360 * ratio) / ratio : 0;
}

/** Directions of the cranks, from the reducer's centre to the satellites'. */
export function crankDirections({ cranks, start }, angle) {
  return cranks.map((crank) => {
    const turned = modulo(angle + start + crank, 360) * RADIAN;
    return [Math.sin(turned), Math.cos(turned)];
  });
}

/** Places evenly on a circle, against the clock, the first so many degrees from upright. */
export const evenly = (count, radius, first = 0) => Array.from({ length: count }, (_, n) => {
  const turned = (first + (360 * n) / count) * RADIAN;
  return [-radius * Math.sin(turned), radius * Math.cos(turned)];
});

/** Centres of the pins. */
export const pinCentres = (mechanism, angle) => evenly(mechanism.pins, mechanism.radius, pinAngle(mechanism, angle));

/** Sizes of pin and hole as a document says them: a fit, or a clearance that agrees with the radii, stands for the hole. */
export function fitted({ hole_radius_mm: hole, ...sizes }) {
  const { fit, hole_clearance_mm: clearance, pin_radius_mm: pin, eccentricity_mm: e } = sizes;
  const agrees = clearance !== undefined && Math.abs(clearance - (hole - pin - e)) < 1e-9 * hole; // else the service says so, at the hole
  return fit || agrees ? sizes : { ...sizes, ...(hole !== undefined && { hole_radius_mm: hole }) };
}

/** The centre moved by a distance in a direction. */
export function moved([x, y], [across, up], distance) {
  return [x + across * distance, y + up * distance];
}

/** The angle as it lies within the first driving period, as far as the cyclogram reaches. */
function withinPeriod({ end, period }, angle) {
  return end >= period ? modulo(angle, period) : angle;
}

/** Which pairs drive, in the order of the cyclogram's pairs; none at a dead centre. */
export function drivingAt(mechanism, angle) {
  const at = withinPeriod(mechanism, angle);
  const dead = mechanism.dead.some((one) => Math.abs(one - angle) < 1e-9);
  return mechanism.pairs.map(({ driving_deg: phases }) => !dead && phases.some(([from, to]) => from <= at && at < to));
}

/** Value of a curve `{ x, y }` with ascending x at a place; the later of two values at one place. */
export function valueAt({ x, y }, place) {
  let low = 0;
  let high = x.length - 1;
  if (place <= x[0]) return y[0];
  if (place >= x[high]) return y[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= place) low = middle;
    else high = middle;
  }
  return y[low] + ((y[high] - y[low]) * (place - x[low])) / (x[high] - x[low]);
}

/**
 * Forces of all pairs at a crank angle, N, from the curves of the figure of forces: `[{ name, x, y }]`
 * by satellite and pin, with a value on both sides of every switching angle. None without curves. Of ideal ones only the
 * pairs that are `driving` have any.
 */
export function forcesAt(mechanism, curves, angle, driving = null) {
  if (curves.length === 0) return null;
  const at = withinPeriod(mechanism, angle);
  const named = new Map(curves.map((curve) => [curve.name, curve]));
  return mechanism.pairs.map(({ satellite, pin }, i) => {
    const curve = (driving?.[i] ?? true) && named.get(`${satellite}.${pin}`);
    return curve ? valueAt(curve, at) : 0;
  });
}

/** Forces, N, and gaps, mm, of the ring's pins at a crank angle, satellite by satellite: after a period a pin feels what the one so many further on felt. */
export function ringAt({ ring: { x, period, further, force, gap } }, angle) {
  const at = modulo(angle, period);
  const on = further * Math.round((angle - at) / period);
  const all = (values) => values.flatMap((rows) => rows.map((_, k) => valueAt({ x, y: rows[modulo(k + on, rows.length)] }, at)));
  return { force: all(force), gap: all(gap) };
}
