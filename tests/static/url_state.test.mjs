import assert from "node:assert/strict";
import { test } from "node:test";

import { readState, stateFromInput } from "../../static/lib/form_state.js";
import { decodeState, encodeState, query, withVerdict } from "../../static/lib/url_state.js";
import { INPUT, MODEL } from "./model.mjs";

const through = (state) => decodeState(MODEL, new URLSearchParams(query("job", MODEL, state))).state;
const withTexts = (state, texts) => ({ ...state, texts: { ...state.texts, ...texts } });
const withChosen = (state, chosen) => ({ ...state, chosen: { ...state.chosen, ...chosen } });

test("the address has API names and canonical numbers, and no defaults", () => {
  const state = withTexts(stateFromInput(MODEL, INPUT), {
    "mechanism.ratio": "20,50", "mechanism.satellites": " 2 ", "contact.dynamic_factor": "1.0",
  });
  assert.equal(
    query("job", MODEL, state),
    "calculator=job&v=2&mechanism.pins=3&mechanism.ratio=20.5"
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

test("a field that has moved is read from its older place in links and designs, and its own place counts", () => {
  const model = { ...MODEL, moved: { "mechanism.pins": "contact.pin_count" } };
  const link = new URLSearchParams("contact.pin_count=7&mechanism.ratio=20");
  const { state, claim } = decodeState(model, link);
  assert.equal(state.texts["mechanism.pins"], "7");
  assert.deepEqual(claim.unknown, []);
  assert.equal(link.get("contact.pin_count"), "7", "the link itself stays");
  link.set("mechanism.pins", "5");
  assert.equal(decodeState(model, link).state.texts["mechanism.pins"], "5");
  assert.equal(stateFromInput(model, { contact: { pin_count: 9 } }).texts["mechanism.pins"], "9");
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
  assert.equal(read("").state, null);
  assert.equal(read("calculator=job&units=us&lang=uk").state, null, "no design, the example will do");
  assert.deepEqual(read("calculator=job&utm=1"), { state: null, claim: { unknown: ["utm"] } });
  assert.deepEqual([read("mechanism.pins=5").state.texts["mechanism.pins"], read("mechanism.pins=5").claim.unknown], ["5", []]);
  assert.deepEqual(read("calculator=job&v=3&mechanism.pins=5&foo=1").claim.unknown, ["v=3", "foo"]);
  assert.deepEqual(decodeState(MODEL, new URLSearchParams("calculator=other"), "job").claim.unknown, ["calculator=other"]);
  assert.deepEqual(read("v=1&mechanism.ratio=20&mechanism.ring_teeth=42").claim.unknown, ["mechanism.ring_teeth"]);
});

test("title, author, revision and note travel in the link", () => {
  const state = withTexts(stateFromInput(MODEL, INPUT), { title: "Hoist & winch", note: "first" });
  assert.match(query("job", MODEL, state), /&title=Hoist\+%26\+winch&note=first$/);
  assert.deepEqual([through(state).texts.title, through(state).texts.author], ["Hoist & winch", ""]);
});

test("a link says its verdict; one from before links did is an older one", () => {
  const claim = (text) => decodeState(MODEL, new URLSearchParams(text)).claim;
  const link = withVerdict(query("job", MODEL, stateFromInput(MODEL, INPUT)), "pass");
  assert.deepEqual(claim(link), { unknown: [], older: false, verdict: "pass" });
  assert.deepEqual(claim("v=1&mechanism.pins=5"), { unknown: [], older: true, verdict: undefined });
  assert.doesNotMatch(withVerdict("v=2", undefined), /verdict/);
});

test("names that the form does not know are passed over", () => {
  const { state } = decodeState(MODEL, new URLSearchParams("v=2&mechanism.pins=3&__proto__=1&nonsense=2"));
  assert.equal(state.texts["mechanism.pins"], "3");
  assert.equal(state.texts.nonsense, undefined);
  assert.ok(!encodeState(MODEL, state).has("nonsense"));
});
