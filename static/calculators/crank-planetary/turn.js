/**
 * Ideal forces over a turn of the crank against the output, for the worked steps: what is largest, and means of powers.
 * No DOM, no texts.
 *
 * A *turn* has the segments of the wave angle between switching angles, in each of which the same pairs drive; all
 * pins pass through one pitch of them, so that this is all of the turn. A *position* is
 * `{ pairs: [{ satellite, pin, angle, cosine, force, weight }] }` of the driving pairs there, satellites and pins from 0,
 * pressure angles in degrees, forces over T/R.
 */
import { NODES } from "../../lib/formula/evaluate.js";

/** Degrees without the noise of rounding. */
const tidy = (angle) => Math.round(angle * 1e10) / 1e10;

const RADIAN = Math.PI / 180;
const SHORT = 1e-9; // rad: a segment that only rounding makes
const STEPS = 24; // of a segment, between which the largest is sought
const GOLDEN = (Math.sqrt(5) - 1) / 2;
const NARROWINGS = 40;
const PANELS = 4; // of a segment, each with some nodes of a mean

/** Pins, cranks at `angles` in degrees, exponent v, and the weight of each satellite in the sharing. */
export function idealTurn({ pins, angles }, exponent, weights = angles.map(() => 1)) {
  const pitch = (2 * Math.PI) / pins;
  const phased = angles.flatMap((angle, satellite) => Array.from({ length: pins }, (_, pin) =>
    ({ satellite, pin, weight: weights[satellite], phase: angle * RADIAN + pin * pitch + Math.PI / 2 })));
  const within = (wave) => ((wave % pitch) + pitch) % pitch;
  const cuts = [0, ...phased.flatMap(({ phase }) => [within(Math.PI / 2 - phase), within(-Math.PI / 2 - phase)]).sort((a, b) => a - b), pitch];
  const segments = cuts.slice(1).map((to, i) => ({ from: cuts[i], to })).filter(({ from, to }) => to - from > SHORT);
  return {
    pitch,
    segments: segments.map(({ from, to }) => {
      const driving = phased.filter(({ phase }) => Math.cos((from + to) / 2 + phase) > 0);
      return { from, to, at: (wave) => positionOf(driving, wave, exponent) };
    }),
  };
}

function positionOf(driving, wave, exponent) {
  const cosines = driving.map(({ phase }) => Math.max(Math.cos(wave + phase), 0));
  const support = driving.reduce((sum, { weight }, i) => sum + weight * cosines[i] ** (1 + exponent), 0);
  return { pairs: driving.map(({ satellite, pin, weight, phase }, i) => ({
    satellite, pin, weight, cosine: cosines[i], force: (weight * cosines[i] ** exponent) / support,
    angle: tidy(Math.atan2(Math.sin(wave + phase), Math.cos(wave + phase)) / RADIAN),
  })) };
}

/** Of turns the position at which a measure is largest: `{ value, position, turn }`. */
export function largestOf(turns, measure) {
  let best = { value: -Infinity };
  for (const turn of turns) {
    for (const { from, to, at } of turn.segments) {
      const step = (to - from) / STEPS;
      const samples = Array.from({ length: STEPS + 1 }, (_, i) => measure(at(from + i * step)));
      const top = samples.indexOf(Math.max(...samples));
      let [low, high] = [from + Math.max(top - 1, 0) * step, from + Math.min(top + 1, STEPS) * step];
      let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
      let [lefts, rights] = [measure(at(left)), measure(at(right))];
      for (let i = 0; i < NARROWINGS; i += 1) {
        if (lefts >= rights) {
          [high, right, rights] = [right, left, lefts];
          left = high - GOLDEN * (high - low);
          lefts = measure(at(left));
        } else {
          [low, left, lefts] = [left, right, rights];
          right = low + GOLDEN * (high - low);
          rights = measure(at(right));
        }
      }
      for (const wave of [from + top * step, (low + high) / 2]) {
        const position = at(wave);
        const value = measure(position);
        if (value > best.value * (1 + 1e-12)) best = { value, position, turn };
      }
    }
  }
  return best;
}

/** Values of a measure over a turn and the weights, which add up to 1, of their mean: `[{ value, weight }]`. */
export function meanOf({ segments, pitch }, measure) {
  const panels = Array.from({ length: PANELS }, (_, panel) => NODES.map(([node, weight]) =>
    [(2 * panel + 1 + node) / (2 * PANELS), weight / (2 * PANELS)])).flat();
  return segments.flatMap(({ from, to, at }) => panels.map(([t, weight]) => ({ // dense at the ends, where a power begins
    weight: (weight * 6 * t * (1 - t) * (to - from)) / pitch,
    value: measure(at(from + t * t * (3 - 2 * t) * (to - from))),
  })));
}

/** What acts on a satellite: its share of the torque, its pins' resultant over T/R. */
export function onSatellite({ pairs }, satellite) {
  const own = pairs.filter((pair) => pair.satellite === satellite);
  return {
    share: own.reduce((sum, { force, cosine }) => sum + force * cosine, 0),
    pins: own.reduce((sum, { force }) => sum + force, 0),
  };
}
