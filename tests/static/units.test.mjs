import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { formatQuantity, quantityParts } from "../../static/lib/format.js";
import { readField, readState, stateFromInput, stepped, textIn } from "../../static/lib/form_state.js";
import { canonicalValue, setUnits, shownStep, shownUnit, shownValue, spell } from "../../static/lib/units.js";
import { decodeState, encodeState, query } from "../../static/lib/url_state.js";
import { INPUT, MODEL } from "./model.mjs";

afterEach(() => setUnits("metric"));

const near = (value, wanted, relative = 1e-12) =>
  assert.ok(Math.abs(value - wanted) <= relative * Math.abs(wanted), `${value} is not ${wanted}`);

test("the sizes of the units are those of their definitions", () => {
  setUnits("us");
  assert.equal(shownValue(25.4, "mm"), 1);
  near(shownValue(1000, "N"), 224.80894309971);
  near(shownValue(1, "N·m"), 8.850745791327185);
  near(shownValue(1, "MPa"), 145.03773773, 1e-10);
  near(shownValue(210, "GPa"), 30.457924923, 1e-10);
  near(shownValue(1, "N/mm"), 5.7101471547, 1e-10);
  assert.equal(shownValue(30, "°"), 30);
  assert.equal(shownUnit("°"), "°");
});

test("a value is shown with few digits and read back whole", () => {
  setUnits("us");
  for (const value of [10, 0.1, 7, 32.5, 1e-3, 123456.789, 1 / 3]) {
    const text = spell(value, "mm");
    assert.equal(canonicalValue(Number(text), "mm"), value);
  }
  assert.equal(spell(10, "mm"), "0.3937008");
});

test("a value typed in other units is shown in few digits after them, and is still the same", () => {
  setUnits("us");
  const torque = canonicalValue(1000, "N·m");
  assert.equal(torque, 112.984829027617);
  setUnits("metric");
  assert.equal(spell(torque, "N·m"), "112.984829");
  assert.equal(canonicalValue(112.984829, "N·m"), torque);
  assert.equal(canonicalValue(112.98483, "N·m"), 112.98483);
  for (const value of [5, 123456.789012, 1e-12, 0.1]) assert.equal(spell(value, "mm"), String(value));
});

test("two values that look alike keep their difference", () => {
  setUnits("us");
  const texts = [10, 10.0000001].map((value) => spell(value, "mm"));
  assert.notEqual(texts[0], texts[1]);
  assert.deepEqual(texts.map((text) => canonicalValue(Number(text), "mm")), [10, 10.0000001]);
});

test("a text of the form says canonical values whatever units are shown", () => {
  setUnits("us");
  const state = stateFromInput(MODEL, INPUT);
  assert.equal(state.texts["contact.pin_radius_mm"], "0.1968504");
  assert.deepEqual(readState(MODEL, state).input.contact.pin_radius_mm, 5);
  const typed = { ...state, texts: { ...state.texts, "contact.pin_radius_mm": "0.5" } };
  assert.equal(readState(MODEL, typed).input.contact.pin_radius_mm, 12.7);
});

test("links are the same in all units, and open in any", () => {
  const metric = query("job", MODEL, stateFromInput(MODEL, INPUT));
  setUnits("us");
  const state = stateFromInput(MODEL, INPUT);
  assert.equal(query("job", MODEL, state), metric);
  const { state: back } = decodeState(MODEL, new URLSearchParams(metric));
  assert.deepEqual(readState(MODEL, back).input, readState(MODEL, state).input);
  const unreadable = new URLSearchParams({ v: "2", "contact.pin_radius_mm": "5 mm?" });
  assert.equal(decodeState(MODEL, unreadable).state.texts["contact.pin_radius_mm"], "5 mm?");
  assert.equal(encodeState(MODEL, decodeState(MODEL, unreadable).state).get("contact.pin_radius_mm"), "5 mm?");
});

test("limits are checked in canonical units and said in those shown", () => {
  const field = { ...MODEL.fields.get("contact.pin_radius_mm"), lowest: 25.4, lowestAllowed: true };
  setUnits("us");
  assert.deepEqual(readField(field, "0.9"), { problem: "least", limit: 1 });
  assert.deepEqual(readField(field, "1"), { value: 25.4 });
});

test("arrow keys step by round numbers of the shown unit", () => {
  setUnits("us");
  assert.equal(shownStep(0.5, "mm"), 0.02);
  assert.equal(shownStep(10, "N"), 2);
  assert.equal(stepped(MODEL.fields.get("contact.pin_radius_mm"), "0.5", 1), "0.52");
});

test("quantities change their unit, numbers without one do not", () => {
  setUnits("us");
  assert.deepEqual(quantityParts(25.4, "mm"), { value: "1", unit: "in" });
  assert.equal(formatQuantity(100, "MPa", 5), "14\u202f504\u00a0psi");
  assert.equal(formatQuantity(2.5, ""), "2.5");
  assert.equal(textIn({ kind: "number", unit: "" }, 20), "20");
});
