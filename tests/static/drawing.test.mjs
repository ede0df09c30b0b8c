import assert from "node:assert/strict";
import { test } from "node:test";

import { contactPoint, crankAngles, mechanismAt, ratioOf, valueAt } from "../../static/drawing/geometry.js";

const MECHANISM = { pins: 5, satellites: 3, crank_spacing_deg: 100, ratio: 19 };
const SIZES = { mechanism: MECHANISM, pinCircle: 50, eccentricity: 1.5 };
const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-9, `${value} is not ${wanted}`);

test("at every angle the pins stand on their circle and turn with the output, against the crank", () => {
  for (const angle of [0, 1, 90, 359, 720]) {
    const { pins, turned } = mechanismAt(SIZES, angle);
    near(turned, (angle * Math.PI) / 180 / 19);
    for (const pin of pins) near(Math.hypot(...pin), 50);
    const [x, y] = pins[0];
    near(Math.atan2(-x, y), turned % (2 * Math.PI));
  }
});

test("satellites stand at the eccentricity, the crank turning clockwise", () => {
  const { satellites } = mechanismAt(SIZES, 30);
  for (const { centre, direction } of satellites) {
    near(Math.hypot(...centre), 1.5);
    near(Math.hypot(...direction), 1);
  }
  const [first, second] = satellites;
  near(first.centre[0], 1.5 * Math.sin(Math.PI / 6));
  near(first.centre[1], 1.5 * Math.cos(Math.PI / 6));
  near(second.centre[0], 1.5 * Math.sin((130 * Math.PI) / 180));
});

test("the contact point lies on the pin and on the hole", () => {
  const [radius, hole] = [8, 9.5];
  const { pins, satellites } = mechanismAt(SIZES, 77);
  for (const pin of pins) {
    for (const { centre, direction } of satellites) {
      const touch = contactPoint(pin, direction, radius);
      near(Math.hypot(touch[0] - pin[0], touch[1] - pin[1]), radius);
      near(Math.hypot(touch[0] - pin[0] - centre[0], touch[1] - pin[1] - centre[1]), hole);
    }
  }
});

test("a force turns the output forward just where the pressure angle's cosine is positive", () => {
  // arm of the force about the axis over R = cos(gamma) = -sin(psi + theta), eq. (6) of 2021
  for (let angle = 0; angle < 360; angle += 7) {
    const { pins, satellites } = mechanismAt(SIZES, angle);
    const psi = ((angle * Math.PI) / 180) * (1 + 1 / 19);
    satellites.forEach(({ direction }, j) => pins.forEach((pin, n) => {
      const theta = (j * 100 * Math.PI) / 180 + (2 * Math.PI * n) / 5;
      near((pin[0] * direction[1] - pin[1] * direction[0]) / 50, -Math.sin(psi + theta));
    }));
  }
});

test("cranks and ratio come in every way that the form gives them", () => {
  assert.deepEqual(crankAngles({ satellites: 3 }), [0, 120, 240]);
  assert.deepEqual(crankAngles({ crank_angles_deg: [0, 10] }), [0, 10]);
  assert.equal(ratioOf({ satellite_teeth: 40, ring_teeth: 42 }), 20);
});

test("a curve is read between its points; of two values at a jump the later", () => {
  const curve = { x: [0, 10, 10, 20], y: [0, 5, 8, 10] };
  assert.equal(valueAt(curve, 5), 2.5);
  assert.equal(valueAt(curve, 10), 8);
  assert.equal(valueAt(curve, 15), 9);
  assert.equal(valueAt(curve, 25), 10);
  assert.equal(valueAt(curve, -1), 0);
});
