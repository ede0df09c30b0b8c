/** Designs from a requirement: its form, what is asked and told on the way, the design that is opened. */
import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import calculator from "../../static/calculators/crank-planetary/index.js";
import { ask, FORM, nameOf, placed } from "../../static/calculators/crank-planetary/propose.js";
import { documentOf } from "../../static/calculators/crank-planetary/wanted.js";
import { readState, stateFromInput } from "../../static/lib/form_state.js";
import { fieldsOf, formModel } from "../../static/lib/schema_form.js";
import { LANGUAGES, ownWords, quantityTitle } from "../../static/messages/index.js";
import { openapi, useLanguage } from "./service.mjs";

afterEach(() => useLanguage("en"));

const MODEL = formModel(openapi, { ...FORM, path: "/api/v1/propose", words: ownWords });
const PLACES = { "/pin/satellite_positions_mm": [6.6, 18.7], "/pin/span_mm": 25.3, "/crankshaft/satellite_positions_mm": [6.6, 18.7], "/crankshaft/bearing_positions_mm": [-3.5, 28.8] };
const DESIGN = {
  mechanism: { pins: 8, satellites: 2, satellite_teeth: 20, ring_teeth: 21, output: "pins" },
  load: { output_torque_Nm: 20, input_speed_rpm: 1500, pin_circle_radius_mm: 25 },
  contact: { eccentricity_mm: 0.9, pin_radius_mm: 2.5, contact_length_mm: 11, hole_clearance_mm: 0.03, pin_material: "steel_bearing", hole_material: "steel_case_hardened" },
  pin: { support: "supported", diameter_mm: 5 },
  gear: { kind: "cycloid", ring_pin_circle_radius_mm: 34.8, ring_pin_radius_mm: 1.5, modification: { equidistant_mm: 0.01 }, pin_material: "steel_bearing" },
  bearing: { name: "NU202E" },
  crankshaft: { shaft_diameter_mm: 8, bearings: [{ name: "608" }, { name: "608" }] },
  build: { housing_diameter_mm: 80 },
  tolerances: { process: "precise" },
  requirements: { life_h: 5000, max_outer_diameter_mm: 80 },
};

function inputFrom(texts) {
  const state = stateFromInput(MODEL, {});
  return readState(MODEL, { ...state, texts: { ...state.texts, ...texts } });
}

test("the form has every field of the request but the number of proposals, in this order", () => {
  const paths = MODEL.groups.flatMap(({ items }) => items).flatMap(fieldsOf).map(({ path }) => path);
  assert.deepEqual(paths.slice(0, 5), ["torque_Nm", "ratio", "outer_diameter_mm", "input_speed_rpm", "life_h"]);
  const { wanted, ...properties } = openapi.components.schemas.ProposeRequest.properties;
  assert.deepEqual([...new Set(paths.map((path) => path.split(".")[0]))].sort(), Object.keys(properties).sort());
  assert.deepEqual(inputFrom({}).wrong, ["torque_Nm", "ratio", "outer_diameter_mm"]);
  const given = { torque_Nm: "20", outer_diameter_mm: "80" };
  const one = inputFrom({ ...given, ratio: "20", discs: "3", "materials.disc": "steel_bearing" });
  assert.deepEqual([one.wrong, one.input.ratio, one.input.discs, one.input.materials], [[], 20, 3, { disc: "steel_bearing" }]);
  const range = inputFrom({ ...given, ratio: "18", ratio_to: "20" });
  assert.deepEqual([range.wrong, range.input.ratio, range.input.ratio_to], [[], 18, 20]);
  assert.deepEqual(inputFrom({ ...given, ratio: "200" }).readings.ratio, { problem: "most", limit: 119 });
});

test("what is found is told at once, and stands for itself once all is said", async () => {
  const told = [];
  const client = {
    async post(path, body, { progressed }) {
      assert.deepEqual([path, body], ["/propose", { torque_Nm: 20 }]);
      progressed(0.2, {});
      progressed(0.5, { proposal: "a" });
      return { proposals: ["a", "b"] };
    },
  };
  await ask({ client, body: { torque_Nm: 20 }, progressed: (share, { found }) => told.push([share, found]) });
  assert.deepEqual(told, [[undefined, []], [0.2, []], [0.5, ["a"]], [1, ["a", "b"]]]);
});

test("a design is named by what tells it apart, in every language", async () => {
  assert.equal(nameOf(DESIGN), "20:1 · NU202E · pins 8×5 · ring 21×3");
  const mechanism = { ...DESIGN.mechanism, satellite_teeth: 19, ring_teeth: 20, output: "ring" };
  assert.match(nameOf({ ...DESIGN, mechanism }), /^20:1 /);
  const { properties } = openapi.components.schemas.ColumnsOut;
  for (const language of Object.keys(LANGUAGES)) {
    await useLanguage(language);
    assert.match(nameOf(DESIGN), /NU202E.*8×5/);
    for (const column of Object.keys(properties)) assert.ok(quantityTitle(column, "propose"));
  }
});

test("a design is opened whole: with the places that the service takes, and how it is made", async () => {
  const assumed = [...Object.entries({ ...PLACES, "/build/gap_mm": 1.1 })].map(([pointer, value]) => ({ pointer, value }));
  const client = { post: async () => ({ assumed }) };
  const model = formModel(openapi, { ...calculator, path: "/api/v1/crank-planetary", words: ownWords });
  const opened = readState(model, stateFromInput(model, calculator.inputOf(await placed(client, DESIGN, { life_h: 5000 }))));
  assert.deepEqual(opened.wrong, []);
  const { pin, crankshaft, build, gear, bearing } = documentOf(opened.input);
  for (const [pointer, value] of Object.entries(PLACES)) {
    const [part, name] = pointer.slice(1).split("/");
    assert.deepEqual({ pin, crankshaft }[part][name], value, pointer);
  }
  assert.deepEqual([build, opened.input.besides.tolerances, bearing.name], [DESIGN.build, DESIGN.tolerances, "NU202E"]);
  assert.equal(gear.modification.equidistant_mm, 0.01);
  const lost = { post: () => Promise.reject(new Error("lost")) };
  assert.deepEqual(await placed(lost, DESIGN, { life_h: 5000 }), DESIGN);
  assert.deepEqual((await placed(lost, DESIGN, {})).requirements, { max_outer_diameter_mm: 80 }); // the life is assumed
});
