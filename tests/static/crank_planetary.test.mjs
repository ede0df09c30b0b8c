import assert from "node:assert/strict";
import { test } from "node:test";

import calculator from "../../static/calculators/crank_planetary.js";

const ACCURACY = { method: "closed form", relative_error: 1e-15, evaluations: 1, run_time_us: 10 };
const CYCLOGRAM = {
  min_driving: 2, max_driving: 4, mean_driving: 3, dead_centres_deg: [], accuracy: ACCURACY,
  pairs: [1, 2].flatMap((satellite) => [1, 2, 3].map((pin) => ({ satellite, pin, driving_deg: [] }))),
};
const HERTZ = { max_pressure_MPa: 800, safety_factor: 0.5, accuracy: ACCURACY };

/** The body that the calculator posts. */
function asked(input, sections, tables = new Set()) {
  return calculator.ask({ post: (path, body) => body, input, sections, tables });
}

test("only what is shown is asked, and nothing of what a refused section needs", () => {
  const input = { mechanism: { pins: 3 }, load: { output_torque_Nm: 1 }, contact: { pin_radius_mm: 1 } };
  assert.deepEqual(asked(input, ["cyclogram"]), { mechanism: { pins: 3 }, include: ["cyclogram"] });
  const all = asked(input, calculator.sections);
  assert.deepEqual(all.contact, input.contact);
  assert.ok(!all.load.include.includes("curves"));
  assert.ok(asked(input, calculator.sections, new Set(["force"])).load.include.includes("curves"));
});

test("the approximation is asked for only in its range", () => {
  for (const [pins, satellites, wanted] of [[3, 1, true], [5, 2, true], [6, 1, false], [4, 3, false]]) {
    const input = { mechanism: { pins, satellites }, load: {}, contact: {} };
    assert.equal(asked(input, calculator.sections).load.include.includes("approximation"), wanted);
  }
});

test("the verdict says over the limit in words, and what has not been computed", () => {
  const [peak, pairs, pressure] = calculator.verdict({ cyclogram: CYCLOGRAM, hertz: HERTZ });
  assert.equal(peak.value, undefined);
  assert.equal(pairs.value, "2–4");
  assert.match(pairs.note, /of 6 pairs, mean 3/);
  assert.equal(pressure.level, "bad");
  assert.match(pressure.note, /Over the limit.*400.*0\.5/);
});

test("a dead centre is named with its places, never passed over", () => {
  const dead = { ...CYCLOGRAM, min_driving: 0, dead_centres_deg: [90, 180, 270, 360] };
  const [, pairs] = calculator.verdict({ cyclogram: dead });
  assert.equal(pairs.level, "bad");
  assert.match(pairs.note, /90°, 180°, 270° …/);
});

test("an option starts from the same design", () => {
  const input = { mechanism: { satellites: 3, ratio: 20 }, load: { output_torque_Nm: 50 } };
  assert.deepEqual(calculator.seeds["cranks.list"](input)["mechanism.crank_angles_deg"], [0, 120, 240]);
  const teeth = calculator.seeds["ratio.teeth"](input);
  const [satellite, ring] = [teeth["mechanism.satellite_teeth"], teeth["mechanism.ring_teeth"]];
  assert.equal(satellite / (ring - satellite), 20);
  assert.deepEqual(calculator.seeds["ratio.teeth"]({ mechanism: { ratio: Math.PI } }), {});
  assert.deepEqual(calculator.seeds["ratio.teeth"]({}), {});
  const torque = calculator.seeds["torque.input"](input);
  assert.equal(torque["load.input_torque_Nm"] * 20 * torque["load.efficiency"], 50);
});

test("the sizes that the theory gives", () => {
  const { value: hole } = calculator.suggestions["contact.hole_radius_mm"];
  assert.equal(hole({ contact: { pin_radius_mm: 5, eccentricity_mm: 1.1 } }), 6.1);
  assert.ok(!Number.isFinite(hole({ contact: { pin_radius_mm: 5 } })));
  assert.ok(!Number.isFinite(hole({})));
  assert.equal(calculator.suggestions["mechanism.crank_spacing_deg"].value({ mechanism: { satellites: 4 } }), 90);
});
