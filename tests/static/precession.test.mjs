import assert from "node:assert/strict";
import { test } from "node:test";

import calculator from "../../static/calculators/precession/index.js";

const rollersAt = (...angles) =>
  angles.map((angle) => ({ position_angle_deg: angle, z_min_mm: 15, z_max_mm: 25 }));
const INPUT = {
  roller_circle_radius_mm: 50, roller_radius_mm: 4, nutation_angle_deg: 6, ratio_u12: 0.96,
  rollers: rollersAt(30, 60), torque_Nm: -10, reference_z_mm: 20,
  bearing_distance_mm: 30, overhang_mm: 40, shaft_diameter_mm: 20, youngs_modulus_GPa: 210,
};

test("each endpoint is asked its own fields, in the order of need, and none after a refusal", async () => {
  const asked = [];
  const post = async (path, body) => {
    asked.push([path, body]);
    return { path };
  };
  const answer = await calculator.ask({ post, input: INPUT, sections: calculator.sections });
  assert.deepEqual(Object.keys(answer), calculator.sections);
  const [[, line], [, load], [, shaft]] = asked;
  assert.equal(line.torque_sign, -1);
  assert.ok(!("torque_Nm" in line) && !("shaft_diameter_mm" in line));
  assert.equal(load.torque_Nm, -10);
  assert.ok(!("torque_sign" in load) && !("overhang_mm" in load));
  assert.deepEqual(shaft, { ...INPUT, include: ["checks"] });

  asked.length = 0;
  const refuse = async (path) => {
    asked.push(path);
    throw new Error("refused");
  };
  await assert.rejects(calculator.ask({ post: refuse, input: INPUT, sections: calculator.sections }));
  assert.deepEqual(asked, ["/precession/contact-line"]);
});

test("a wheel starts from evenly spaced rollers, and leaves open what a list does not say", () => {
  const wheel = (rollers) => calculator.seeds["rollersBy.wheel"]({ rollers });
  assert.deepEqual(wheel(rollersAt(30, 60, 90)), {
    "wheel.rollers_total": 12, "wheel.rollers_in_mesh": 3, "wheel.position_angle_deg": 30,
    "wheel.z_min_mm": 15, "wheel.z_max_mm": 25,
  });
  assert.equal(wheel(rollersAt(0, 360 / 7, 720 / 7))["wheel.rollers_total"], 7);
  assert.equal(wheel(rollersAt(30, 60, 100))["wheel.rollers_total"], undefined);
  assert.equal(wheel(rollersAt(30))["wheel.rollers_total"], undefined);
  assert.equal(wheel([])["wheel.z_min_mm"], undefined);
  const differing = rollersAt(30, 60);
  differing[1].z_max_mm = 24;
  assert.equal(wheel(differing)["wheel.z_max_mm"], undefined);
});

test("a list starts from the wheel, a stepped shaft from the plain one", () => {
  const wheel = { rollers_total: 24, rollers_in_mesh: 3, position_angle_deg: 30, z_min_mm: 15, z_max_mm: 25 };
  assert.deepEqual(calculator.seeds["rollersBy.list"]({ wheel }), { rollers: rollersAt(30, 45, 60) });
  assert.deepEqual(calculator.seeds["shaftBy.sections"](INPUT).shaft_sections, [
    { length_mm: 30, diameter_mm: 20 }, { length_mm: 40, diameter_mm: 20 },
  ]);
});

test("the verdict gives deflections and the sizes of the reactions", () => {
  const accuracy = { relative_error: 1e-14 };
  const [, , cell] = calculator.verdict({
    shaft_deflection: {
      accuracy, deflection_B_mm: { total: 0.0104 }, deflection_C_mm: { total: 0.02625 },
      reaction_B_N: [3, -4], reaction_C_N: [0, 12],
    },
  });
  assert.equal(cell.value, "0.02625");
  assert.match(cell.note, /0\.0104.*B 5\u00a0N, C 12\u00a0N/);
});
