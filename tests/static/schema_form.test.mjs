import assert from "node:assert/strict";
import { test } from "node:test";

import { fieldAtPointer, readField, readState, shownFields, stateFromInput, stepped } from "../../static/lib/form_state.js";
import { INPUT, MODEL } from "./model.mjs";
import { readingText } from "../../static/store.js";

const field = (path) => MODEL.fields.get(path);
const withTexts = (state, texts) => ({ ...state, texts: { ...state.texts, ...texts } });

test("fields take name, unit, limits, step and default from the schema", () => {
  const pins = field("mechanism.pins");
  assert.equal(pins.kind, "integer");
  assert.equal(pins.symbol, "N");
  assert.deepEqual([pins.lowest, pins.highest, pins.step, pins.required], [1, 40, 1, true]);
  assert.equal(field("contact.pin_radius_mm").unit, "mm");
  assert.equal(field("mechanism.crank_angles_deg").unit, "°");
  assert.equal(field("mechanism.satellites").default, 2);
  assert.equal(field("contact.dynamic_factor").advanced, true);
  assert.equal(field("mechanism.include"), undefined);
});

test("a choice stands where its first field would, and its fields nowhere else", () => {
  const [mechanism] = MODEL.groups;
  assert.deepEqual(
    mechanism.items.map((item) => item.path ?? item.id),
    ["mechanism.pins", "mechanism.satellites", "cranks", "ratio"],
  );
});

test("a name or own values become a choice without being told", () => {
  const choice = MODEL.choices.find(({ id }) => id === "contact.pin_material");
  assert.deepEqual(choice.options.map(({ id }) => id), ["named", "own"]);
  assert.deepEqual(
    choice.options[1].fields.map(({ path, required }) => [path, required]),
    [["contact.pin_material.youngs_modulus_GPa", true], ["contact.pin_material.allowable_pressure_MPa", false], ["contact.pin_material.layers", false]],
  );
  assert.deepEqual(field("contact.pin_material.layers").options, ["", "flat", "upright"], "what need not be said can be unsaid");
});

test("a body becomes a state and the state the same body", () => {
  const inputs = [
    INPUT,
    { mechanism: { pins: 4, satellites: 3, crank_angles_deg: [0, 100, 250.5], satellite_teeth: 40, ring_teeth: 42 },
      contact: { pin_radius_mm: 1e-3, pin_material: { youngs_modulus_GPa: 70.5 } } },
    { mechanism: { pins: 5, ratio: 0.5, crank_spacing_deg: 90 },
      contact: { pin_radius_mm: 5, pin_material: { youngs_modulus_GPa: 70, allowable_pressure_MPa: 0 } } },
  ];
  for (const input of inputs) {
    const { input: read, wrong } = readState(MODEL, stateFromInput(MODEL, input));
    assert.deepEqual(wrong, []);
    assert.deepEqual(read, {
      mechanism: { satellites: 2, ...input.mechanism },
      contact: { dynamic_factor: 1, ...input.contact },
    });
  }
});

test("only the chosen option's fields are shown, read and required", () => {
  const state = withTexts(stateFromInput(MODEL, INPUT), { "mechanism.satellite_teeth": "x" });
  assert.deepEqual(readState(MODEL, state).wrong, []);
  const teeth = { ...state, chosen: { ...state.chosen, ratio: "teeth" } };
  assert.deepEqual(readState(MODEL, teeth).wrong, ["mechanism.satellite_teeth", "mechanism.ring_teeth"]);
  assert.ok(!shownFields(MODEL, teeth).some(({ path }) => path === "mechanism.ratio"));
  assert.equal(readState(MODEL, teeth).input.mechanism.ratio, undefined);
});

test("what the theory can supply may be left empty, what distinguishes an option may not", () => {
  const state = stateFromInput(MODEL, INPUT);
  assert.equal(state.texts["mechanism.crank_spacing_deg"], "");
  assert.deepEqual(readState(MODEL, withTexts(state, { "mechanism.ratio": " " })).wrong, ["mechanism.ratio"]);
});

test("boxes are checked against the schema's limits, open and closed", () => {
  const problems = (path, text) => readField(field(path), text);
  assert.deepEqual(problems("mechanism.pins", "0"), { problem: "least", limit: 1 });
  assert.deepEqual(problems("mechanism.pins", "41"), { problem: "most", limit: 40 });
  assert.deepEqual(problems("mechanism.pins", "2,5"), { problem: "integer" });
  assert.deepEqual(problems("mechanism.pins", ""), { problem: "required" });
  assert.deepEqual(problems("mechanism.ratio", "0"), { problem: "above", limit: 0 });
  assert.deepEqual(problems("mechanism.ratio", "1,000.5"), { problem: "separators" });
  assert.deepEqual(problems("mechanism.crank_angles_deg", "0; -400"), { problem: "least", limit: -360 });
  assert.deepEqual(problems("mechanism.crank_angles_deg", "0; one"), { problem: "list" });
  assert.deepEqual(problems("mechanism.crank_angles_deg", "15,45,75"), { problem: "list" });
  assert.match(readingText({ problem: "list" }), /part them by ; or a space/);
  assert.deepEqual(problems("mechanism.pins", "1e0"), { value: 1 });
});

test("a pointer finds its box, or the box it lies in, or none", () => {
  const shown = shownFields(MODEL, stateFromInput(MODEL, INPUT));
  assert.equal(fieldAtPointer(shown, "/mechanism/pins").path, "mechanism.pins");
  assert.equal(fieldAtPointer(shown, "#/mechanism/pins").path, "mechanism.pins");
  assert.equal(fieldAtPointer(shown, "/contact/pin_material/youngs_modulus_GPa").path, "contact.pin_material");
  assert.equal(fieldAtPointer(shown, "/mechanism/crank_angles_deg/1"), null);
  assert.equal(fieldAtPointer(shown, "/mechanism"), null);
  assert.equal(fieldAtPointer(shown, ""), null);
});

test("arrow keys step within the limits and without binary noise", () => {
  assert.equal(stepped(field("mechanism.pins"), "3", 1), "4");
  assert.equal(stepped(field("mechanism.pins"), "1", -1), null);
  assert.equal(stepped(field("mechanism.pins"), "30", 1, 10), "40");
  assert.equal(stepped(field("contact.pin_radius_mm"), "5,1", 1), "5.6");
  assert.equal(stepped(field("mechanism.ratio"), "0.3", -1), "0.29");
  assert.equal(stepped(field("mechanism.ratio"), "x", 1), null);
  assert.equal(stepped(field("mechanism.satellites"), "", 1), "3");
  assert.equal(stepped(field("mechanism.crank_angles_deg"), "0; 90", 1), null);
});

test("a lowest value next to nothing reads as: more than nothing", () => {
  const size = { ...field("contact.pin_radius_mm"), lowest: 1e-12, lowestAllowed: true };
  assert.deepEqual(readField(size, "-3"), { problem: "above", limit: 0 });
  assert.deepEqual(readField(size, "1e-13"), { problem: "least", limit: 1e-12 });
  assert.deepEqual(readField(size, "1e-12"), { value: 1e-12 });
});
