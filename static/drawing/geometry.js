/**
 * Where things stand in the drawings, in mm and radians, Y upwards. No DOM.
 *
 * Frame of the crank-planetary mechanism: pin 1 on the Y axis at crank angle 0, the crank turning
 * clockwise, the output counter-clockwise, as in Yanchevskiy 2021.
 */
export const radians = (degrees) => (degrees * Math.PI) / 180;

/** Crank angle of every satellite, degrees. */
export function crankAngles({ satellites = 2, crank_angles_deg: given, crank_spacing_deg: spacing }) {
  return given ?? Array.from({ length: satellites }, (_, j) => j * (spacing ?? 360 / satellites));
}

/** Ratio of a mechanism, given or by its teeth. */
export function ratioOf({ ratio, satellite_teeth: satellite, ring_teeth: ring }) {
  return ratio ?? satellite / (ring - satellite);
}

/** Place on a circle, the angle counted counter-clockwise from the Y axis. */
function placed(radius, angle) {
  return [-radius * Math.sin(angle), radius * Math.cos(angle)];
}

/**
 * The mechanism at a crank angle: `{ pins: [[x, y]], satellites: [{ centre, direction }] }`;
 * `direction` is that from a pin to the middle of its hole, and that of the force on a pin.
 */
export function mechanismAt({ mechanism, pinCircle, eccentricity }, crankAngle) {
  const turned = radians(crankAngle) / ratioOf(mechanism);
  const start = mechanism.initial_crank_angle_deg ?? 0;
  return {
    turned,
    pins: Array.from({ length: mechanism.pins }, (_, n) => placed(pinCircle, turned + (2 * Math.PI * n) / mechanism.pins)),
    satellites: crankAngles(mechanism).map((angle) => {
      const direction = placed(1, -radians(crankAngle + angle + start));
      return { direction, centre: direction.map((part) => part * eccentricity) };
    }),
  };
}

/** Where a pin touches its hole: on the side away from the hole's middle. */
export function contactPoint(pin, direction, pinRadius) {
  return [pin[0] - pinRadius * direction[0], pin[1] - pinRadius * direction[1]];
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
