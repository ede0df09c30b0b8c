import assert from "node:assert/strict";
import { test } from "node:test";

import calculator from "../../static/calculators/rollers/index.js";

const SECTION = {
  max_force_N: 3500, mean_force_N: 875, load_nonuniformity: 4, loaded_rollers: 1, forces_N: [3500, 0, 0, 0],
  bending_stress_MPa: 1800.25, bending_moment_Nm: 88.2, accuracy: { relative_error: 1e-15 },
};

test("the verdict says how many rollers carry, and that one alone is bad", () => {
  const level = (loaded) =>
    calculator.verdict({ roller_strength: { ...SECTION, loaded_rollers: loaded } })[1].level;
  assert.deepEqual([level(1), level(3), level(4)], ["bad", "warning", undefined]);
  const [force, sharing, stress] = calculator.verdict({ roller_strength: SECTION });
  assert.match(sharing.note, /1 of 4/);
  assert.deepEqual([force.value, stress.value], ["3500", "1800"]);
  assert.ok(calculator.verdict({}).every(({ label, value }) => label && value === undefined));
});

test("gaps and shear modulus start from the same design", () => {
  assert.deepEqual(
    calculator.seeds["errors.gaps"]({ rollers: 3, position_tolerance_mm: 0.002 }),
    { gaps_mm: [0, 0.008, 0.008] },
  );
  assert.deepEqual(
    calculator.seeds["shear.modulus"]({ youngs_modulus_GPa: 210, poissons_ratio: 0.25 }),
    { shear_modulus_GPa: 84 },
  );
});
