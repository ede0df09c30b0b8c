/** Lists of records in the form: text, reading, link, and what the service says of a row. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { cellAt, fieldAtPointer, readState, stateFromInput } from "../../static/lib/form_state.js";
import { formModel } from "../../static/lib/schema_form.js";
import { decodeState, encodeState } from "../../static/lib/url_state.js";

const number = (title, more = {}) => ({ type: "number", title, "x-group": "rollers", ...more });
const OPENAPI = {
  paths: {
    "/gear": { post: { requestBody: { content: { "application/json": { schema: { $ref: "#/components/schemas/Gear" } } } } } },
  },
  components: {
    schemas: {
      Gear: {
        type: "object",
        required: ["radius_mm"],
        properties: {
          radius_mm: { ...number("Radius"), "x-group": "gear" },
          rollers: {
            anyOf: [{ type: "array", items: { $ref: "#/components/schemas/Roller" } }, { type: "null" }],
            title: "Rollers",
            "x-group": "rollers",
          },
          wheel: { anyOf: [{ $ref: "#/components/schemas/Wheel" }, { type: "null" }], title: "Wheel" },
        },
      },
      Roller: {
        type: "object",
        required: ["position_angle_deg"],
        properties: { position_angle_deg: number("Position"), z_min_mm: number("From", { minimum: -100 }) },
      },
      Wheel: { type: "object", required: ["rollers_total"], properties: { rollers_total: number("Total") } },
    },
  },
};
const model = formModel(OPENAPI, {
  path: "/gear",
  groups: ["gear", "rollers"],
  inline: ["wheel"],
  choices: { by: { list: ["rollers"], wheel: ["wheel.rollers_total"] } },
});
const INPUT = {
  radius_mm: 50,
  rollers: [{ position_angle_deg: 30, z_min_mm: 15 }, { position_angle_deg: 60.5 }],
};

test("fields of a flat body stand in the groups that they name, an inline object among them", () => {
  assert.deepEqual(model.groups.map(({ id, items }) => [id, items.length]), [["gear", 1], ["rollers", 1]]);
  assert.deepEqual(model.fields.get("rollers").columns.map(({ name }) => name), ["position_angle_deg", "z_min_mm"]);
  assert.equal(model.fields.get("wheel.rollers_total").title, "Total");
});

test("records become text and the same records again", () => {
  const state = stateFromInput(model, INPUT);
  assert.equal(state.texts.rollers, "30; 15 | 60.5; ");
  assert.deepEqual(readState(model, state), { ...readState(model, state), input: INPUT, wrong: [] });
});

test("a link carries records", () => {
  const state = stateFromInput(model, INPUT);
  const parameters = new URLSearchParams({ v: "2", ...Object.fromEntries(encodeState(model, state)) });
  assert.equal(parameters.get("rollers"), "30;15|60.5;");
  assert.deepEqual(readState(model, decodeState(model, parameters).state).input, INPUT);
});

test("a cell that cannot be read is named by row and column, and kept as typed", () => {
  for (const [text, problem, row, column] of [
    ["30; 15 | 6o; 1", "number", 1, "position_angle_deg"],
    ["; 15", "required", 0, "position_angle_deg"],
    ["30; -101", "least", 0, "z_min_mm"],
  ]) {
    const state = stateFromInput(model, INPUT);
    state.texts.rollers = text;
    const { readings, wrong, input } = readState(model, state);
    assert.deepEqual(wrong, ["rollers"]);
    assert.ok(!("rollers" in input));
    const reading = readings.rollers;
    assert.deepEqual([reading.problem, reading.row, reading.column.name], [problem, row, column]);
    const parameters = new URLSearchParams({ v: "2", ...Object.fromEntries(encodeState(model, state)) });
    assert.deepEqual(readState(model, decodeState(model, parameters).state).readings.rollers.problem, problem);
  }
});

test("a decimal comma is read in a cell", () => {
  const state = stateFromInput(model, INPUT);
  state.texts.rollers = "32,5; 1";
  assert.deepEqual(readState(model, state).input.rollers, [{ position_angle_deg: 32.5, z_min_mm: 1 }]);
});

test("the service's pointer into a record means its list", () => {
  const shown = [...model.fields.values()];
  assert.equal(fieldAtPointer(shown, "/rollers/1/z_min_mm").path, "rollers");
});

test("a pointer into a list means a cell, whose title says the row", () => {
  const { list, row, index, field } = cellAt(model, "rollers.1.z_min_mm");
  assert.deepEqual([list, row, index, field.title], ["rollers", 1, 1, "From 2"]);
  assert.deepEqual(["rollers.1.colour", "radius_mm", "gear.1.z_min_mm"].map((path) => cellAt(model, path)), [undefined, undefined, undefined]);
});
