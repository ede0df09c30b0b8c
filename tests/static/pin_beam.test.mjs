/** Compliances of a pin under a unit force against the principle of virtual work, and means over a turn against a fine sum. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { complianceSteps } from "../../static/calculators/crank-planetary/pin_beam.js";
import { idealTurn, largestOf, meanOf, onSatellite } from "../../static/calculators/crank-planetary/turn.js";
import { quantity as q } from "../../static/lib/formula/evaluate.js";

const [E, ν, d, b, L] = [210e3, 0.3, 12, 8, 60]; // N, mm
const [I, G] = [(Math.PI * d ** 4) / 64, E / 2 / (1 + ν)];
const A = (Math.PI * d ** 2) / 4;
const PLANES = [9, 30, 33, 48]; // the second and the third overlap

/** Integral by midpoints of each stretch between these places. */
function integral(of, ...places) {
  const ends = [...new Set(places)].sort((one, other) => one - other);
  const count = 4000;
  return ends.slice(1).reduce((sum, to, i) => {
    const step = (to - ends[i]) / count;
    return sum + Array.from({ length: count }, (_, k) => of(ends[i] + (k + 0.5) * step) * step).reduce((x, y) => x + y, 0);
  }, 0);
}

/** Moment and shear at s, positive as a cantilever's, of a force spread over a width about z, by what acts at the carrier. */
const acting = (z, width, [shear, moment]) => {
  const carried = (s) => Math.min(Math.max((s - z + width / 2) / width, 0), 1);
  const beyond = (s) => (s >= z + width / 2 ? s - z : s <= z - width / 2 ? 0 : (s - z + width / 2) ** 2 / 2 / width);
  return { M: (s) => moment - shear * s + beyond(s), V: (s) => shear - carried(s) };
};

/** What acts at the carrier: by equilibrium, and where both ends are built in with no deflection and slope at the other. */
function held(support, z) {
  if (support === "cantilever") return [1, z];
  if (support === "supported") return [(L - z) / L, 0];
  const free = acting(z, b, [1, z]);
  const ends = [0, z - b / 2, z + b / 2, L];
  const [w, θ] = [integral((s) => (free.M(s) * (L - s)) / E / I + ((10 / 9) * free.V(s)) / G / A, ...ends), integral((s) => free.M(s) / E / I, ...ends)];
  const [ww, wθ, θθ] = [L ** 3 / 3 / E / I + ((10 / 9) * L) / G / A, L ** 2 / 2 / E / I, L / E / I];
  const D = ww * θθ - wθ ** 2;
  const [force, couple] = [(w * θθ - θ * wθ) / D, (θ * ww - w * wθ) / D]; // of the far end
  return [1 - force, z - force * L - couple];
}

/** Deflection and slope at x by virtual work: of a unit force and a unit couple there, on the cantilever or between two supports. */
function byVirtualWork(support, x, z) {
  const real = acting(z, b, held(support, z));
  const ends = [0, x, z - b / 2, z + b / 2, support === "supported" ? L : Math.max(x, z + b / 2)];
  const before = (s) => (s < x ? 1 : 0);
  const virtual = support === "supported"
    ? { m: (s) => before(s) * (x - s) - (x / L) * (L - s), v: (s) => before(s) - x / L, turn: (s) => before(s) - (L - s) / L }
    : { m: (s) => before(s) * (x - s), v: before, turn: before };
  return [
    integral((s) => (real.M(s) * virtual.m(s)) / E / I + ((10 / 9) * real.V(s) * virtual.v(s)) / G / A, ...ends),
    1000 * integral((s) => (real.M(s) * virtual.turn(s)) / E / I, ...ends),
  ];
}

for (const support of ["cantilever", "supported", "fixed"]) {
  test(`${support}: deflection and slope by a unit force are those of virtual work`, () => {
    const values = { E: q("E", E / 1000, "GPa"), ν: q("ν", ν), d: q("d", d, "mm"), b: q("b", b, "mm"), L: q("L", L, "mm") };
    for (const [at, x] of PLANES.entries()) {
      for (const [from, z] of PLANES.entries()) {
        const { deflection, slope } = complianceSteps({ support, planes: PLANES, values }, at, from);
        const [w, θ] = byVirtualWork(support, x, z);
        const words = `at ${x} by ${z}`;
        assert.ok(Math.abs(deflection.value - w) < 1e-6 * Math.abs(w), `${words}: ${deflection.value}, not ${w}`);
        assert.ok(Math.abs(slope.value - θ) < 1e-6 * Math.max(Math.abs(θ), 1e-4), `${words}: slope ${slope.value}, not ${θ}`);
      }
    }
  });
}

test("over a turn the torque is shared out whole; largest and mean are those of a fine sum", () => {
  for (const [exponent, weights] of [[1, undefined], [1.5, [3, 1]], [0, [1, 2]]]) {
    const turn = idealTurn({ pins: 5, angles: [0, 130] }, exponent, weights);
    const load = (position) => onSatellite(position, 0).pins;
    const waves = turn.segments.flatMap(({ from, to, at }) => Array.from({ length: 500 }, (_, i) => ({ width: (to - from) / 500, position: at(from + ((i + 0.5) * (to - from)) / 500) })));
    for (const { position } of waves) {
      const shares = [0, 1].map((j) => onSatellite(position, j).share);
      assert.ok(Math.abs(shares[0] + shares[1] - 1) < 1e-12);
    }
    const most = Math.max(...waves.map(({ position }) => load(position)));
    const found = largestOf([turn], load).value;
    assert.ok(found >= most && found < most * (1 + 1e-2), `${found}, ${most}`);
    const mean = waves.reduce((sum, { width, position }) => sum + (width / turn.pitch) * load(position) ** 3, 0);
    const weighted = meanOf(turn, load).reduce((sum, { value, weight }) => sum + weight * value ** 3, 0);
    assert.ok(Math.abs(weighted - mean) < 1e-5 * mean, `${weighted}, ${mean}`);
  }
});
