import assert from "node:assert/strict";
import { test } from "node:test";

import { CALCULATORS, calculatorOf } from "../../static/calculators/index.js";
import { readState, shownFields, stateFromInput } from "../../static/lib/form_state.js";
import { lineOf, shortOf } from "../../static/lib/outline.js";
import { fieldsOf, formModel } from "../../static/lib/schema_form.js";
import { LANGUAGES, message, ownWords } from "../../static/messages/index.js";
import { openapi, useLanguage } from "./service.mjs";

const modelOf = (calculator, diameters = null) => formModel(openapi, { ...calculator, path: `/api/v1${calculator.path}`, words: ownWords, diameters });

for (const language of Object.keys(LANGUAGES)) {
  test(`${language}: names of fields and sections are short, and apart`, async () => {
    await useLanguage(language);
    for (const id of CALCULATORS) {
      const calculator = await calculatorOf(id);
      for (const model of [modelOf(calculator), modelOf(calculator, message("diameter"))]) {
        for (const { items } of model.groups) {
          const titles = [...new Set(items.flatMap(fieldsOf).filter(({ kind }) => kind !== "records").map(({ title }) => title))];
          const names = titles.map(shortOf);
          for (const name of names) assert.ok(name.replaceAll("\u00ad", "").length <= 26, name);
          assert.equal(new Set(names).size, titles.length, names.join("; "));
        }
      }
    }
    await useLanguage("en");
  });
}

test("the line of a section is said as one says it", async () => {
  const calculator = await calculatorOf("crank-planetary");
  const model = modelOf(calculator);
  const linesOf = (input) => {
    const state = stateFromInput(model, input);
    const shown = shownFields(model, state);
    const { readings } = readState(model, state);
    const valueOf = (path) => shown.includes(model.fields.get(path)) && state.texts[path] !== "" && [model.fields.get(path), readings[path].value];
    return (id) => lineOf(calculator.lines[id], valueOf);
  };
  const input = {
    mechanism: { pins: 8, satellites: 2, ratio: 20 }, load: { output_torque_Nm: 500, input_speed_rpm: 1500, pin_circle_radius_mm: 38 },
    contact: { pin_radius_mm: 8, eccentricity_mm: 2.5, fit: "H7/f7", pin_material: "steel_bearing" },
  };
  assert.equal(linesOf(input)("pins"), "8 pins Ø16 on Ø76, H7/f7");
  assert.equal(linesOf(input)("load"), "500\u00a0N·m, 1500\u00a0rpm");
  assert.equal(linesOf(input)("reducer"), "20:1, 2 satellites, e 2.5");
  assert.equal(linesOf(input)("losses"), "");
  await useLanguage("uk");
  assert.equal(linesOf(input)("pins"), "8 цівок Ø16 на Ø76; H7/f7");
  assert.equal(linesOf(input)("reducer"), "20:1; 2 сателіти; e 2,5");
  await useLanguage("en");
});

test("every field that a line names is one of its form", async () => {
  for (const id of CALCULATORS) {
    const calculator = await calculatorOf(id);
    const { fields, groups } = modelOf(calculator);
    for (const [section, line] of Object.entries(calculator.lines)) {
      assert.ok(groups.some((group) => group.id === section), section);
      for (const path of line.split(/,? /)) assert.ok(fields.has(path), path);
    }
  }
});
