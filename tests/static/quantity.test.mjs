/** What people write in a box: sums, units, diameters. */
import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { parseSum } from "../../static/lib/format.js";
import { readField, readState, stateFromInput, withLinks } from "../../static/lib/form_state.js";
import { formModel } from "../../static/lib/schema_form.js";
import { DIAMETER, setUnits } from "../../static/lib/units.js";
import { INPUT, OPENAPI } from "./model.mjs";

afterEach(() => setUnits("metric"));

const LENGTH = { kind: "number", name: "contact_length_mm", unit: "mm", lowest: 0 };
const RADIUS = { ...LENGTH, name: "pin_radius_mm" };
const read = (field, text) => readField(field, text).value;

test("sums are worked out, and nothing else is", () => {
  for (const [text, value] of [
    ["10/9", 10 / 9], ["350+20", 370], ["2*(3-0,5)", 5], ["1 1/2", 1.5], ["-3 + 5", 2], ["1e-3*2", 0.002],
    ["2×3÷4", 1.5], ["8−2−1", 5], ["12/2/3", 2],
    ["20:1", 20], ["20/1", 20], ["1 : 20", 0.05],
  ]) assert.equal(parseSum(text).value, Number(value.toPrecision(15)), text);
  for (const text of ["1/0", "1:", "1:0", "1+", "(2", "2)", "3 5", "2**3", "1/2/", "()", "alert(1)", "1,2,3+1", "+", "5-"]) {
    assert.equal(parseSum(text).value, undefined, text);
  }
  assert.equal(parseSum("12").worked, undefined);
});

test("a unit may be written; one of something else is refused", () => {
  for (const [text, value] of [
    ["12 mm", 12], ["1.2cm", 12], ["1/2 in", 12.7], ["0,5\"", 12.7], ["15 µm", 0.015], ["12 мм", 12],
  ]) assert.equal(read(LENGTH, text), value, text);
  assert.equal(readField(LENGTH, "12 N").problem, "unit");
  assert.equal(readField(LENGTH, "abc").problem, "number");
  assert.equal(read({ kind: "number", name: "t_Nm", unit: "N·m" }, "350 Nm"), 350);
  assert.equal(read({ kind: "number", name: "t_Nm", unit: "N·m" }, "0,35 кН·м"), 350);
  assert.equal(read({ kind: "number", name: "p_MPa", unit: "MPa" }, "1.5 GPa"), 1500);
  assert.equal(read({ kind: "integer", name: "pins", unit: "" }, "2*4"), 8);
  assert.equal(readField({ kind: "integer", name: "pins", unit: "" }, "3/2").problem, "integer");
  setUnits("us");
  assert.equal(read(LENGTH, "1/2"), 12.7);
  assert.equal(read(LENGTH, "12.7 mm"), 12.7);
});

test("Ø is a diameter wherever a radius or a diameter is asked, and nowhere else", () => {
  const diameter = { ...RADIUS, unit: DIAMETER };
  assert.deepEqual([read(RADIUS, "Ø12"), read(RADIUS, "⌀ 12 mm"), read(RADIUS, "12")], [6, 6, 12]);
  assert.deepEqual([read(diameter, "Ø12"), read(diameter, "12"), read(diameter, "12 mm"), read(diameter, "1 in")], [6, 6, 6, 12.7]);
  assert.equal(read({ ...LENGTH, name: "shaft_diameter_mm" }, "Ø12"), 12);
  assert.equal(readField(LENGTH, "Ø12").problem, "number");
});

const model = (about = {}) => formModel(OPENAPI, {
  path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"],
  suggestions: { "contact.pin_radius_mm": { linked: true, needs: "mechanism.satellites", value: ({ mechanism }) => mechanism.pins * 2 } },
  ...about,
});

test("radii shown as diameters are the same body", () => {
  const inRadii = model();
  const inDiameters = model({ diameters: { pin_radius_mm: { title: "Pin diameter", help: "" } } });
  const state = stateFromInput(inDiameters, INPUT);
  assert.equal(state.texts["contact.pin_radius_mm"], "10");
  assert.equal(inDiameters.fields.get("contact.pin_radius_mm").title, "Pin diameter");
  assert.deepEqual(readState(inDiameters, state).input, readState(inRadii, stateFromInput(inRadii, INPUT)).input);
});

test("an empty box that is linked follows the others, and what equals its link is linked", () => {
  const form = model();
  const typed = { mechanism: { pins: 3, ratio: 20 }, contact: { pin_radius_mm: 6, pin_material: "steel" } };
  const state = withLinks(form, stateFromInput(form, typed));
  assert.equal(state.texts["contact.pin_radius_mm"], "");
  assert.equal(readState(form, state).input.contact.pin_radius_mm, 6);
  const more = { ...state, texts: { ...state.texts, "mechanism.pins": "4" } };
  assert.equal(readState(form, more).input.contact.pin_radius_mm, 8);
  assert.equal(withLinks(form, stateFromInput(form, INPUT)).texts["contact.pin_radius_mm"], "5");
  const empty = readState(form, { ...state, texts: { ...state.texts, "mechanism.pins": "", "mechanism.satellites": "" } });
  assert.deepEqual(empty.readings["mechanism.satellites"], { problem: "required" }, "what the link needs is asked for instead");
  assert.equal(empty.readings["contact.pin_radius_mm"].problem, undefined);
});

test("groups stand in the page's order, and nothing is lost", () => {
  const form = model({ arranged: { first: ["contact.pin_radius_mm", "mechanism.pins"], rest: [] } });
  assert.deepEqual(form.groups[0].items.map(({ path }) => path), ["contact.pin_radius_mm", "mechanism.pins"]);
  assert.equal(form.groups.flatMap(({ items }) => items).length, model().groups.flatMap(({ items }) => items).length);
});
