import assert from "node:assert/strict";
import { test } from "node:test";

import { readState, stateFromInput } from "../../static/lib/schema_form.js";
import { decodeState, encodeState, query } from "../../static/lib/url_state.js";
import { INPUT, MODEL } from "./model.mjs";

const through = (state) => decodeState(MODEL, new URLSearchParams(query("job", MODEL, state)));
const withTexts = (state, texts) => ({ ...state, texts: { ...state.texts, ...texts } });
const withChosen = (state, chosen) => ({ ...state, chosen: { ...state.chosen, ...chosen } });

test("the address has API names and canonical numbers, and no defaults", () => {
  const state = withTexts(stateFromInput(MODEL, INPUT), {
    "mechanism.ratio": "20,50", "mechanism.satellites": " 2 ", "contact.dynamic_factor": "1.0",
  });
  assert.equal(
    query("job", MODEL, state),
    "calculator=job&v=1&mechanism.pins=3&mechanism.ratio=20.5"
    + "&contact.pin_radius_mm=5&contact.pin_material=steel",
  );
});

test("a link reopened is the same body, whatever was chosen", () => {
  for (const input of [
    INPUT,
    { mechanism: { pins: 7, satellites: 3, crank_angles_deg: [0, 0.1, 240], satellite_teeth: 40, ring_teeth: 42 },
      contact: { pin_radius_mm: 0.1 + 0.2, pin_material: { youngs_modulus_GPa: 70 }, dynamic_factor: 1.5 } },
  ]) {
    const state = stateFromInput(MODEL, input);
    assert.deepEqual(readState(MODEL, through(state)), readState(MODEL, state));
    assert.deepEqual(through(state).chosen, state.chosen);
  }
});

test("an option with nothing typed yet is still known by the link", () => {
  const state = withChosen(stateFromInput(MODEL, INPUT), { ratio: "teeth", "contact.pin_material": "own" });
  assert.deepEqual(through(state).chosen, state.chosen);
});

test("what cannot be read is kept as typed, markup and separators included", () => {
  const texts = { "mechanism.pins": "2.5 & <b>", "mechanism.ratio": "1,000.5" };
  const back = through(withTexts(stateFromInput(MODEL, INPUT), texts));
  assert.equal(back.texts["mechanism.pins"], "2.5 & <b>");
  assert.equal(back.texts["mechanism.ratio"], "1,000.5");
});

test("a default that was cleared on purpose stays cleared or means the same", () => {
  const back = through(withTexts(stateFromInput(MODEL, INPUT), { "mechanism.satellites": "" }));
  assert.equal(back.texts["mechanism.satellites"], "2");
});

test("a link without a version is of this one; another version, unknown and contradicting names are said", () => {
  const read = (text) => decodeState(MODEL, new URLSearchParams(text));
  assert.equal(read(""), null);
  assert.equal(read("calculator=job&units=us&lang=uk"), null, "no design, the example will do");
  assert.deepEqual([read("mechanism.pins=5").texts["mechanism.pins"], read("mechanism.pins=5").unknown], ["5", []]);
  assert.deepEqual(read("calculator=job&v=2&mechanism.pins=5&foo=1").unknown, ["v=2", "foo"]);
  assert.deepEqual(read("v=1&mechanism.ratio=20&mechanism.ring_teeth=42").unknown, ["mechanism.ring_teeth"]);
});

test("title, author, revision and note travel in the link", () => {
  const state = withTexts(stateFromInput(MODEL, INPUT), { title: "Hoist & winch", note: "first" });
  assert.match(query("job", MODEL, state), /&title=Hoist\+%26\+winch&note=first$/);
  assert.deepEqual([through(state).texts.title, through(state).texts.author, through(state).unknown], ["Hoist & winch", "", []]);
});

test("names that the form does not know are passed over", () => {
  const state = decodeState(MODEL, new URLSearchParams("v=1&mechanism.pins=3&__proto__=1&nonsense=2"));
  assert.equal(state.texts["mechanism.pins"], "3");
  assert.equal(state.texts.nonsense, undefined);
  assert.ok(!encodeState(MODEL, state).has("nonsense"));
});
