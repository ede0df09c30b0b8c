import assert from "node:assert/strict";
import { test } from "node:test";

import {
  crankDirections, drivingAt, forcesAt, mechanismOf, moved, pinCentres, pitchRadii, valueAt,
} from "../../static/calculators/crank-planetary/mechanism.js";
import { roundBelow } from "../../static/lib/svg.js";

const RADIAN = Math.PI / 180;
const close = (a, b, within = 1e-9) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);
const distance = ([x1, y1], [x2, y2]) => Math.hypot(x2 - x1, y2 - y1);

/** Zyl's mechanism, its pairs' phases counted from the wave, independently of the service. */
function design({ pins = 6, satellites = 1, ratio = 20, start = 0, end = 360 } = {}) {
  const period = 360 / (1 + 1 / ratio);
  const pairs = [];
  for (let j = 0; j < satellites; j += 1) {
    for (let n = 0; n < pins; n += 1) {
      // -sin(psi + theta) > 0: psi + theta from half a turn to a whole one
      const theta = start + (j * 360) / satellites + (n * 360) / pins;
      const first = (180 - theta) / 360;
      const driving = [];
      for (let turn = -10; turn < 10; turn += 1) {
        const from = Math.max(0, (first + turn) * period);
        const to = Math.min(end, (first + turn + 0.5) * period);
        if (to > from) driving.push([from, to]);
      }
      pairs.push({ satellite: j + 1, pin: n + 1, driving_deg: driving });
    }
  }
  return mechanismOf({
    mechanism: { pins, satellites, ratio, initial_crank_angle_deg: start },
    load: { pin_circle_radius_mm: 32.5 },
    contact: { pin_radius_mm: 5, hole_radius_mm: 6.5 },
  }, { cyclogram: { pairs, period_deg: period, driving_count: [{ to_deg: end }] } });
}

/** cos(gamma) of every pair, from the angle between the pin's way and the force on it. */
function cosines(m, angle) {
  return crankDirections(m, angle).flatMap((direction) =>
    pinCentres(m, angle).map(([x, y]) => (direction[0] * -y + direction[1] * x) / m.radius));
}

const ANGLES = [0, 1, 33.3, 90, 171.4, 200, 359, 360];

test("every pin lies in its hole, off its centre by e, and touches it at the contact point", () => {
  const m = design({ satellites: 3 });
  for (const angle of ANGLES) {
    const directions = crankDirections(m, angle);
    for (const pin of pinCentres(m, angle)) {
      close(Math.hypot(...pin), 32.5);
      for (const direction of directions) {
        const hole = moved(pin, direction, m.eccentricity);
        const touch = moved(pin, direction, -m.pinRadius);
        close(distance(pin, hole), 1.5);
        close(distance(touch, pin), 5); // on the pin
        close(distance(touch, hole), 6.5); // and on the wall of the hole
      }
    }
  }
});

test("pin 1 starts on Y, crank 1 too, and they turn opposite ways, the pins u times slower", () => {
  const m = design();
  close(pinCentres(m, 0)[0][1], 32.5);
  close(crankDirections(m, 0)[0][1], 1);
  close(crankDirections(m, 90)[0][0], 1);
  const [x, y] = pinCentres(m, 90)[0];
  close(x, -32.5 * Math.sin((90 / 20) * RADIAN));
  close(y, 32.5 * Math.cos((90 / 20) * RADIAN));
});

test("a pair drives exactly where its force helps the pin along", () => {
  for (const m of [design(), design({ pins: 3, satellites: 2, start: 180 }), design({ pins: 3, satellites: 4, ratio: 0.5 })]) {
    for (let angle = 0.37; angle < 360; angle += 3.1) {
      assert.deepEqual(drivingAt(m, angle), cosines(m, angle).map((cosine) => cosine > 0), `at ${angle}`);
    }
  }
});

test("the cyclogram goes on past one turn and may end before one", () => {
  for (const end of [90, 1080]) {
    const m = design({ pins: 3, satellites: 2, end });
    for (let angle = 0.37; angle < end; angle += 7.3) {
      assert.deepEqual(drivingAt(m, angle), cosines(m, angle).map((cosine) => cosine > 0), `at ${angle}`);
    }
  }
});

/** Forces by the law of the theory, of which the figure's curves are samples. */
function theory(m, angle, exponent) {
  const positive = cosines(m, angle).map((cosine) => (cosine > 1e-12 ? cosine : 0));
  const sum = positive.reduce((all, cosine) => all + (cosine && cosine ** (1 + exponent)), 0);
  return positive.map((cosine) => (cosine ? (1000 * cosine ** exponent) / sum : 0));
}

/** Curves as the service draws them: every degree, and both sides of every switching angle. */
function curvesOf(m, exponent) {
  const switching = [...new Set(m.pairs.flatMap(({ driving_deg: phases }) => phases.flat()))];
  const x = [...Array(361).keys(), ...switching.flatMap((place) => [place - 1e-6, place + 1e-6])]
    .filter((place) => place >= 0 && place <= 360).sort((a, b) => a - b);
  const rows = x.map((angle) => theory(m, angle, exponent));
  return m.pairs.map(({ satellite, pin }, i) => ({ name: `${satellite}.${pin}`, x, y: rows.map((row) => row[i]) }));
}

for (const exponent of [0, 1, 1.5]) {
  test(`forces between the samples and past one turn, jumps at switching angles included (v = ${exponent})`, () => {
    const m = design({ pins: 5, end: 1080 });
    const curves = curvesOf(m, exponent);
    for (let angle = 0.11; angle < 1080; angle += 0.37) {
      const expected = theory(m, angle, exponent);
      forcesAt(m, curves, angle, drivingAt(m, angle)).forEach((force, i) => close(force, expected[i], 2));
    }
  });
}

test("without curves there are no forces", () => {
  assert.equal(forcesAt(design(), [], 10), null);
});

test("a curve is read between its points; of two values at a jump the later", () => {
  const curve = { x: [0, 10, 10, 20], y: [0, 5, 8, 10] };
  assert.deepEqual([5, 10, 15, 25, -1].map((place) => valueAt(curve, place)), [2.5, 8, 9, 10, 0]);
});

test("sizes that make no mechanism are left out, not guessed", () => {
  const { eccentricity, radius } = mechanismOf(
    { mechanism: { pins: 3, ratio: 20 }, load: { pin_circle_radius_mm: 50 }, contact: { pin_radius_mm: 8, hole_radius_mm: 4 } },
    { cyclogram: { pairs: [], period_deg: 1, driving_count: [{ to_deg: 360 }] } },
  );
  assert.equal(eccentricity, undefined);
  assert.equal(radius, 50);
});

test("pitch circles roll on each other: their radii differ by e, their ratio is that of the teeth", () => {
  const { satellite, ring } = pitchRadii({ eccentricity: 2, ratio: 20 });
  close(ring - satellite, 2);
  close(ring / satellite, 42 / 40);
});

test("round numbers for a scale", () => {
  assert.deepEqual([1, 1.99, 2, 4.9, 5, 9.9, 3333, 0.07].map(roundBelow), [1, 1, 2, 2, 5, 5, 2000, 0.05]);
});

test("the pin inside its sleeve or its rollers is drawn, of a bearing by name as thick as that says", () => {
  const cyclogram = { pairs: [], period_deg: 360, driving_count: [{ to_deg: 360 }] };
  const input = { mechanism: { pins: 6, satellites: 1, ratio: 20 }, load: {}, contact: { pin_radius_mm: 6.5, hole_radius_mm: 8 } };
  const inside = (besides, assumed) => mechanismOf({ ...input, besides }, { cyclogram, assumed }).inside;
  const named = [{ pointer: "/rollers/width_mm", value: 5 }, { pointer: "/rollers/bore_diameter_mm", value: 6 }];
  assert.equal(inside(), undefined);
  assert.equal(inside({ rolling: { on: "on" }, rollers: { bore_diameter_mm: 8 } }, named), 4);
  assert.equal(inside({ rolling: { on: "on" }, rollers: { name: "686" } }, named), 3);
  assert.equal(inside({ rolling: { on: "off" }, rollers: { bore_diameter_mm: 8 } }), undefined);
  const pin = { diameter_mm: 10 };
  assert.equal(inside({ strength: { on: "on", surface: "sleeved" }, pin }), 5);
  assert.equal(inside({ strength: { on: "on", surface: "bare" }, pin }), undefined);
});
