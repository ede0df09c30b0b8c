/** Groups that are off until wanted: their fields, what they ask of the service, what their answers say. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { createBeside } from "../../static/besides.js";
import { Problem } from "../../static/lib/api.js";
import { isOn, lostOf, readState, shownFields, stateFromInput, withLinks } from "../../static/lib/form_state.js";
import { formModel } from "../../static/lib/schema_form.js";
import { decodeState, encodeState } from "../../static/lib/url_state.js";
import * as next from "../../static/store.js";
import { fieldWords, ownWords } from "../../static/messages/index.js";
import calculator from "../../static/calculators/crank-planetary/index.js";
import * as real from "../../static/calculators/crank-planetary/real.js";
import * as study from "../../static/calculators/crank-planetary/study.js";
import { documentOf, inputOf, WANTED, wantedSections } from "../../static/calculators/crank-planetary/wanted.js";
import { pasted } from "../../static/views/rows.js";
import { INPUT, OPENAPI } from "./model.mjs";
import { examples, openapi } from "./service.mjs";

const number = { type: "number", minimum: -10, maximum: 10 };
const list = { type: "array", items: number, "x-unit": "mm", "x-group": "deviations" };
const posting = (properties) => ({
  post: { requestBody: { content: { "application/json": { schema: { type: "object", properties } } } } },
});
const SERVICE = {
  ...OPENAPI,
  paths: {
    ...OPENAPI.paths,
    "/api/v1/real": posting({
      law: { type: "string", enum: ["hertz", "linear"], default: "hertz" },
      stiffness_N_per_mm: { anyOf: [{ type: "number", minimum: 1 }, { type: "null" }] },
      tolerance: { oneOf: [{ ...number, minimum: 0 }, { type: "object" }], title: "Tolerance", "x-unit": "mm" },
      size: { type: "object", properties: { class: { type: "string", pattern: "^(g|h)(6|7)$" } } },
      parts: { type: "object", properties: { pin_mm: { ...list, title: "Pins" }, hole_mm: { ...list, items: list, title: "Holes" } } },
      quantities: { type: "array", items: { type: "string", enum: ["peak_force_N", "max_pressure_MPa"] }, default: ["peak_force_N"] },
    }),
  },
};

const GROUP = {
  id: "real",
  view: "real",
  judged: false,
  starts: () => ({ tolerance: 0.5 }),
  fields: {
    law: {},
    stiffness_N_per_mm: { when: ["law", "linear"], required: true },
    tolerance: {},
    "size.class": { options: [""] },
    "parts.table": { columns: ["parts.pin_mm", "parts.hole_mm"], rows: () => ["1", "2"] },
    quantities: {},
    "real.play": { options: ["radial", "fits"], default: "radial" },
  },
};
const MODEL = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [GROUP], words: ownWords });

function opened(typed = stateFromInput(MODEL, INPUT)) {
  const calculator = { id: "job", wanted: [GROUP], sections: [], seeds: {}, drawing: {}, figures: [], verdict: () => [] };
  return next.opened({ model: MODEL, calculator, catalogues: {}, titles: new Map() }, typed, "light");
}

const field = (path) => MODEL.fields.get(path);

test("fields are made of the schema of an endpoint of its own, and of what is said besides", () => {
  assert.deepEqual([field("tolerance").kind, field("tolerance").unit, field("tolerance").lowest], ["number", "mm", 0]);
  assert.deepEqual(field("size.class").options, ["", "g6", "g7", "h6", "h7"]);
  assert.deepEqual([field("quantities").kind, field("real.play").kind, field("real.on").kind], ["names", "option", "switch"]);
  assert.equal(field("real.on").title, "Clearance and errors");
  assert.deepEqual(field("parts.table").columns.map(({ name, kind, lowest }) => [name, kind, lowest]), [["pin_mm", "number", -10], ["hole_mm", "number", -10]]);
});

test("in English a box says what its own request does, whatever another one says of a field of this name", () => {
  const [title, help] = ["Pins", "Of this job."];
  assert.notEqual(fieldWords("pins", "mechanism").help, help);
  const asked = structuredClone(OPENAPI);
  Object.assign(asked.components.schemas.Mechanism.properties.pins, { title, description: help });
  const made = formModel(asked, { path: "/api/v1/job", groups: ["mechanism"], words: ownWords }).fields.get("mechanism.pins");
  assert.deepEqual([made.title, made.help], [title, help]);
});

test("fields are needed that the schema of an endpoint beside the form's own says so of", () => {
  const described = structuredClone(OPENAPI);
  described.paths["/api/v1/other"] = structuredClone(described.paths["/api/v1/job"]);
  described.paths["/api/v1/other"].post.requestBody.content["application/json"].schema = { "x-needs": ["/mechanism/satellites"], type: "object", properties: {} };
  const asked = { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"] };
  const needed = (more) => formModel(described, { ...asked, ...more }).fields.get("mechanism.satellites").required;
  assert.deepEqual([needed({}), needed({ neededBy: ["other"] })], [false, true]);
});

test("what follows another box is said even where the service could do without", () => {
  const suggestions = { "contact.pin_radius_mm": { linked: true, needs: "mechanism.ratio", value: ({ mechanism }) => mechanism.ratio / 4 } };
  const made = formModel(OPENAPI, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], suggestions });
  const typed = stateFromInput(made, { ...INPUT, contact: { pin_material: "steel" } });
  assert.equal(readState(made, typed).input.contact.pin_radius_mm, 5);
});

test("an empty list follows the other boxes, in the input too, until it is typed", () => {
  const group = { ...GROUP, fields: { "parts.pin_mm": { required: true, follows: ({ mechanism: { pins } }) => Array(pins).fill(1.5) } }, starts: () => ({}) };
  const made = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [group], words: ownWords });
  const typed = stateFromInput(made, { ...INPUT, besides: { real: { on: "on" } } });
  const { input, besides } = readState(made, typed);
  assert.deepEqual([input.besides.parts.pin_mm, besides.real], [[1.5, 1.5, 1.5], []]);
  assert.ok(!encodeState(made, typed).has("parts.pin_mm"));
  assert.equal(withLinks(made, stateFromInput(made, input)).texts["parts.pin_mm"], "");
  const own = { ...typed, texts: { ...typed.texts, "parts.pin_mm": "1; 2; 3" } };
  assert.deepEqual(readState(made, own).input.besides.parts.pin_mm, [1, 2, 3]);
  assert.equal(withLinks(made, own).texts["parts.pin_mm"], "1; 2; 3");
});

test("a number follows the other boxes too, where it is known, until it is typed", () => {
  const group = { ...GROUP, fields: { tolerance: { required: true, follows: ({ mechanism: { pins } }) => (pins > 2 ? pins / 10 : NaN) } }, starts: () => ({}) };
  const made = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [group], words: ownWords });
  const read = (pins, tolerance) => readState(made, stateFromInput(made, { ...INPUT, mechanism: { ...INPUT.mechanism, pins }, besides: { real: { on: "on" }, tolerance } }));
  assert.deepEqual([read(3).input.besides.tolerance, read(3, 0.7).input.besides.tolerance], [0.3, 0.7]);
  assert.deepEqual(read(2).besides.real, ["tolerance"]);
  assert.equal(withLinks(made, stateFromInput(made, read(3).input)).texts.tolerance, "");
});

test("with another option a number that others give follows them, one whose others go keeps its value", () => {
  const group = { ...GROUP, starts: () => ({ tolerance: 1 }), fields: { tolerance: { required: true, follows: ({ mechanism: { crank_angles_deg: angles } }) => angles?.[1] / 90 } } };
  const made = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [group], words: ownWords, choices: { cranks: { spacing: ["mechanism.crank_spacing_deg"], list: ["mechanism.crank_angles_deg"] } } });
  const seeds = { "cranks.list": () => ({ "mechanism.crank_angles_deg": [0, 90] }) };
  const about = { model: made, calculator: { id: "job", wanted: [group], sections: [], seeds, drawing: {}, figures: [], verdict: () => [] }, catalogues: {}, titles: new Map() };
  const even = next.switched(next.opened(about, stateFromInput(made, INPUT), "light"), "real", true, 0);
  const said = ({ typed, reading }) => [typed.texts.tolerance, reading.readings.tolerance.value, reading.besides.real];
  assert.deepEqual(said(even), ["1", 1, []]);
  const listed = next.chose(even, "cranks", "list", 0);
  assert.deepEqual(said(listed), ["", 1, []]);
  const wider = next.typedIn(listed, "mechanism.crank_angles_deg", "0; 270", 0);
  assert.deepEqual(said(wider), ["", 3, []]);
  assert.deepEqual(said(next.chose(wider, "cranks", "spacing", 0)), ["3", 3, []]);
  const wrong = next.typedIn(listed, "mechanism.crank_angles_deg", "0; -90", 0); // said there, not at what follows
  assert.deepEqual(said(wrong), ["", undefined, []]);
});

test("a group that is off is not shown, asked for or linked", () => {
  const state = stateFromInput(MODEL, INPUT);
  assert.ok(!isOn(MODEL, "real", state.texts));
  assert.deepEqual(shownFields(MODEL, state).filter(({ wanted }) => wanted).map(({ path }) => path), ["real.on"]);
  assert.equal(readState(MODEL, state).input.besides, undefined);
  assert.ok(![...encodeState(MODEL, state).keys()].some((key) => MODEL.fields.get(key).wanted));
});

test("switched on, it starts from values, goes apart into the input, and into links and kept designs and back", () => {
  let state = next.switched(opened(), "real", true, 0);
  assert.equal(state.typed.texts.tolerance, "0.5");
  state = next.typedIn(next.typedIn(state, "parts.table", "0.01;  | ; -0.02", 0), "law", "linear", 0);
  state = next.typedIn(state, "stiffness_N_per_mm", "5e4", 0);
  const { input } = state.reading;
  assert.deepEqual(input.mechanism, readState(MODEL, stateFromInput(MODEL, INPUT)).input.mechanism);
  assert.deepEqual(input.besides, {
    real: { on: "on", play: "radial" }, law: "linear", stiffness_N_per_mm: 5e4, tolerance: 0.5,
    parts: { table: [{ pin_mm: 0.01 }, { hole_mm: -0.02 }] }, quantities: ["peak_force_N"],
  });
  const { state: linked, claim } = decodeState(MODEL, encodeState(MODEL, state.typed), "job");
  assert.deepEqual(claim.unknown, []);
  assert.deepEqual(readState(MODEL, linked).input, input);
  assert.deepEqual(readState(MODEL, stateFromInput(MODEL, input)).input, input);
  const off = next.switched(state, "real", false, 0);
  assert.equal(off.reading.input.besides, undefined);
  assert.deepEqual(next.steppedBack(off).reading.input, input);
  assert.equal(next.switched(off, "real", true, 0).typed.texts.tolerance, "0.5");
});

test("a group goes off with the one that it needs, and comes back with it where it was on", () => {
  const plain = { view: GROUP.view };
  const wanted = [{ ...plain, id: "real", fields: {} }, { ...plain, id: "crank", needs: "real", fields: { stiffness_N_per_mm: {} } }];
  const model = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted, words: ownWords });
  const about = { model, calculator: { wanted, drawing: {} } };
  const turned = (state, id, on) => next.switched(state, id, on, 0);
  const on = (state) => wanted.map(({ id }) => next.wants(state, id));
  const first = turned(next.opened(about, stateFromInput(model, INPUT), "light"), "crank", true);
  const both = next.typedIn(first, "stiffness_N_per_mm", "7000", 0);
  assert.deepEqual(on(both), [true, true]);
  const off = turned(both, "real", false);
  assert.deepEqual([on(off), on(turned(off, "real", true)), on(next.steppedBack(off))], [[false, false], [true, true], [true, true]]);
  const ring = turned(both, "crank", false);
  assert.deepEqual(on(turned(turned(ring, "real", false), "real", true)), [true, false]);
  // Off, it is not asked for; a link brings it back with its values as the form does.
  assert.deepEqual([both.reading.input.besides, off.reading.input.besides], [{ real: { on: "on" }, crank: { on: "on" }, stiffness_N_per_mm: 7000 }, undefined]);
  const { state: linked, claim } = decodeState(model, encodeState(model, off.typed), "job");
  assert.deepEqual(claim.unknown, []);
  const again = next.opened(about, linked, "light");
  assert.deepEqual([on(again), again.reading.input], [[false, false], off.reading.input]);
  assert.deepEqual(turned(again, "real", true).reading.input, both.reading.input);
});

test("what belongs to a box that goes goes with it, and comes back as it was typed", () => {
  const fields = { ...GROUP.fields, tolerance: { when: ["stiffness_N_per_mm", "7000"], required: true } };
  const model = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [{ ...GROUP, fields }], words: ownWords });
  const said = (law) => {
    const texts = { "real.on": "on", law, stiffness_N_per_mm: "7000", tolerance: "0.25" };
    const { input: { besides }, wrong } = readState(model, { texts: { ...stateFromInput(model, INPUT).texts, ...texts }, chosen: stateFromInput(model, INPUT).chosen });
    return [besides.stiffness_N_per_mm, besides.tolerance, wrong.length];
  };
  assert.deepEqual(["linear", "hertz", "linear"].map(said), [[7000, 0.25, 0], [undefined, undefined, 0], [7000, 0.25, 0]]);
});

test("a field that needs another group goes with that, too", () => {
  const fields = { ...GROUP.fields, tolerance: { when: ["law", "linear"], needs: "bearings" } };
  const wanted = [{ ...GROUP, fields }, { id: "bearings", fields: {} }];
  const model = formModel(SERVICE, { path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted, words: ownWords });
  const { texts, chosen } = stateFromInput(model, INPUT);
  const shown = (on) => shownFields(model, { texts: { ...texts, "real.on": "on", law: "linear", "bearings.on": on }, chosen }).map(({ path }) => path);
  assert.deepEqual(["on", "off"].map((on) => shown(on).includes("tolerance")), [true, false]);
});

test("what cannot be read in it keeps nobody else from an answer, and says where it is", () => {
  const wanted = next.switched(opened(), "real", true, 0);
  const state = next.typedIn(wanted, "parts.table", "0,01; | x; ", 0);
  assert.deepEqual([state.phase, state.reading.wrong, state.reading.besides.real], ["computing", [], ["parts.table"]]);
  assert.match(next.hinderedBesides(state, "real"), /row 2, Pins: Not a number/);
  assert.equal(state.typed.texts["parts.table"], "0,01; | x; ");
});

test("where the verdict hangs on a group, what cannot be read in it waits for everything", () => {
  const judged = formModel(SERVICE, {
    path: "/api/v1/job", groups: ["mechanism", "contact"], hidden: ["mechanism.include"], wanted: [{ ...GROUP, judged: true }], words: ownWords,
  });
  const typed = stateFromInput(judged, { ...INPUT, besides: { real: { on: "on" } } });
  const { wrong, besides } = readState(judged, { ...typed, texts: { ...typed.texts, tolerance: "x" } });
  assert.deepEqual([wrong, besides], [["tolerance"], {}]);
});

test("a refusal of it stands at its boxes until something is typed", () => {
  let state = next.switched(opened(), "real", true, 0);
  state = next.besided(state, "real", { typed: state.typed });
  const errors = [{ pointer: "/parts/pin_mm", code: "different_length", params: { expected: 3, actual: 2 } }];
  state = next.refusedBesides(state, "real", new Problem({ status: 422, errors }));
  assert.match(next.refusedAt(state, "parts.table").words, /3 entries, has 2/);
  assert.equal(state.besides.real.phase, "refused");
  assert.equal(next.refusedAt(next.typedIn(state, "tolerance", "1", 0), "parts.table"), undefined);
});

test("what is asked: after an answer or when run, once for the same inputs, stopped where it is stopped", async () => {
  const store = next.createStore(next.switched(opened(), "real", true, 0));
  const asked = [];
  let finish;
  const logic = {
    asked: ({ besides }) => ({ tolerance: besides.tolerance }),
    ask: ({ body, progressed }) => new Promise((resolve, reject) => {
      asked.push(body.tolerance);
      progressed(0.5);
      finish = { resolve, reject };
    }),
  };
  const beside = createBeside({ store, client: {}, id: "real", logic });
  const ready = () => new Promise((resolve) => setTimeout(resolve, 1));
  const first = beside.ask();
  await ready();
  assert.deepEqual([store.state.besides.real.phase, store.state.besides.real.progress], ["computing", 0.5]);
  beside.stop();
  finish.resolve("late");
  await first;
  assert.deepEqual([store.state.besides.real.phase, store.state.besides.real.answer], ["stopped", undefined]);
  const second = beside.ask();
  await ready();
  finish.resolve("answer");
  await second;
  await beside.ask();
  assert.deepEqual([store.state.besides.real.phase, store.state.besides.real.answer, asked], ["fresh", "answer", [0.5, 0.5]]);
  store.apply(next.typedIn, "tolerance", "-1", 0);
  await beside.ask();
  assert.deepEqual([store.state.besides.real.phase, store.state.besides.real.answer, asked.length], ["incomplete", "answer", 2]);
});

const DESIGN = {
  mechanism: { pins: 3, satellites: 2, ratio: 20, revolutions: 1 },
  load: { output_torque_Nm: 100, pin_circle_radius_mm: 40, force_exponent: 1.1 },
  contact: { pin_radius_mm: 5, eccentricity_mm: 2, hole_radius_mm: 7.03, contact_length_mm: 10 },
};
const ask = (besides, contact = {}) => real.asked({
  ...DESIGN, contact: { ...DESIGN.contact, ...contact }, load: { ...DESIGN.load, input_speed_rpm: 1500, torque_direction: "reverse" }, besides,
});

test("the document of the form: a clearance in the place of the hole, and the parts whose groups are on", () => {
  const body = ask({ real: { on: "on" }, contact_law: { kind: "hertz" } });
  assert.deepEqual(body, {
    mechanism: DESIGN.mechanism,
    load: { ...DESIGN.load, input_speed_rpm: 1500, torque_direction: "reverse" },
    contact: DESIGN.contact,
    contact_law: { kind: "hertz" },
    lost_motion_torque_share: undefined,
  });
  const { hole_radius_mm: _, ...others } = DESIGN.contact;
  assert.deepEqual(ask({}, { hole_clearance_mm: 0.03 }).contact, { ...others, hole_clearance_mm: 0.03 });
  assert.equal(ask({}, { hole_clearance_mm: 0.05 }).contact.hole_radius_mm, 7.03); // they disagree: the service says so
  assert.deepEqual(ask({}, { fit: "H7/f7" }).contact, { ...others, fit: "H7/f7" });
  const pin = { support: "cantilever", satellite_positions_mm: [5, 15], rotates: false };
  assert.deepEqual(ask({ strength: { on: "on" }, pin }).pin, pin);
  assert.equal(ask({ pin }).pin, undefined);
  const rollers = { bore_diameter_mm: 6, radial_clearance_mm: 0.01 };
  assert.deepEqual(ask({ rolling: { on: "on" }, rollers }).rollers, rollers);
  assert.equal(ask({ rollers }).rollers, undefined);
});

test("the verdict is of the design as it is made: its clearance, deviations, contacts and pins, nothing else of the page", async () => {
  const post = async (path, body) => body;
  const contact = { ...DESIGN.contact, hole_clearance_mm: 0.03 };
  const parts = { mechanism: DESIGN.mechanism, load: { ...DESIGN.load, torque_direction: "reverse" }, contact };
  const besides = {
    real: { on: "on" },
    deviations: { pins: [{ pin_radial_mm: 0.01 }, {}, {}] }, study: { on: "on" }, samples: 200,
  };
  const asked = (input, sections = ["contact_force", "hertz"]) => calculator.ask({ post, input, filled: DESIGN, sections, tables: new Set() });
  const { load: { include, ...load }, ...body } = await asked({ ...parts, besides });
  assert.deepEqual(load, { ...DESIGN.load, torque_direction: "reverse" });
  assert.deepEqual([body.contact.hole_clearance_mm, body.deviations], [0.03, { pin_radial_mm: [0.01, 0, 0] }]);
  assert.deepEqual(Object.keys(body).sort(), ["contact", "contact_law", "deviations", "include", "mechanism"]);
  assert.ok(!("deviations" in await asked({ ...parts, besides }, ["contact_force"])));
  assert.ok(!("deviations" in await asked({ ...parts, besides: { ...besides, real: undefined } })));
});

test("a figure of strength and life asks with the document that its numbers are of", async () => {
  const besides = {
    real: { on: "on" }, contact_law: { kind: "palmgren" },
    deviations: { pins: [{ pin_radial_mm: 0.01 }, {}, {}] }, satellite_coupling: { shares: [0.4, 0.6] },
    strength: { on: "on", surface: "sleeved" }, pin: { support: "cantilever", satellite_positions_mm: [5, 15], diameter_mm: 8 },
    fatigue: { reliability_percent: 99 }, losses: { on: "on" }, friction: { coefficient: 0.08, wear_rate_mm3_per_Nm: 1e-8 },
    bearings: { on: "on" }, gear: { kind: "ratio", radial_force_ratio: 0.4 }, bearing: { kind: "ball" },
    crank: { on: "on" }, crankshaft: { bearing_positions_mm: [0, 20] }, requirements: { min_efficiency: 0.9 },
  };
  const load = { input_torque_Nm: 6, efficiency: 0.9, pin_circle_radius_mm: 40, input_speed_rpm: 1500, peak_torque_Nm: 200, torque_direction: "alternating" };
  const contact = { ...DESIGN.contact, pin_radius_mm: 6, hole_radius_mm: 8, fit: "H7/h6", dynamic_factor: 1.25 };
  const requests = [];
  await calculator.ask({
    post: async (path, body) => {
      requests.push({ path, body });
      return {};
    },
    input: { ...DESIGN, load, contact, satellite_body: { bore_radius_mm: 20 }, besides }, filled: DESIGN, sections: calculator.sections, tables: new Set(),
  });
  const [{ body: { include, ...document } }] = requests;
  const { hole_radius_mm: _, ...others } = contact;
  const { load: { include: optional, ...sent }, pin, friction, gear } = document;
  assert.deepEqual([sent, document.contact, document.contact_law], [load, others, { kind: "palmgren" }]);
  assert.deepEqual([document.deviations, document.satellite_coupling], [{ pin_radial_mm: [0.01, 0, 0] }, { kind: "shares", shares: [0.4, 0.6] }]);
  assert.deepEqual([pin, friction, gear], [besides.pin, { ...besides.friction, sleeve: true }, { radial_force_ratio: 0.4 }]);
  for (const id of ["strength", "losses", "bearings", "crank"]) {
    const { [id]: { figure } } = await import("../../static/calculators/crank-planetary/parts.js");
    assert.deepEqual(figure.body({}, {}, requests), document, id);
    assert.ok(figure.body.length > 1, id); // it is not asked for before the numbers
  }
});

test("measured pins of the ring are of the teeth alone: beside those of the output, and forces of the output stay ideal", async () => {
  const ring = { ring_pin_radial_mm: [0.01, 0, 0], ring_pin_radius_mm: [0, -0.002, 0] };
  const gear = { kind: "cycloid", ring_pin_circle_radius_mm: 60, modification: { equidistant_mm: 0.02 } };
  const { besides } = inputOf({ ...DESIGN, gear, bearing: { kind: "ball" }, deviations: ring });
  assert.deepEqual(besides.deviations, { ring_pins: [[0.01, 0], [0, -0.002], [0, 0]].map(([ring_pin_radial_mm, ring_pin_radius_mm]) => ({ ring_pin_radial_mm, ring_pin_radius_mm })) });
  const pins = { pins: [{ pin_radial_mm: 0.01 }, {}, {}] };
  const asked = async (more, sections = calculator.sections) => {
    const requests = [];
    const perfect = { ...DESIGN.contact, pin_radius_mm: 5, eccentricity_mm: 2, hole_radius_mm: 7 };
    const input = { ...DESIGN, contact: perfect, besides: { ...besides, ...more, deviations: { ...besides.deviations, ...more.deviations } } };
    await calculator.ask({ post: async (path, body) => requests.push({ path, body }), input, filled: DESIGN, sections, tables: new Set() });
    return requests;
  };
  const [alone] = await asked({});
  assert.deepEqual(alone.body.deviations, ring);
  assert.ok(alone.body.include.includes("ring_drawing") && !alone.body.include.includes("load_sharing"));
  const both = await asked({ real: { on: "on" }, deviations: pins });
  assert.deepEqual(both[0].body.deviations, { ...ring, pin_radial_mm: [0.01, 0, 0] });
  assert.ok(both[0].body.include.includes("load_sharing"));
  assert.equal((await asked({ teeth: {} }))[0].body.deviations, undefined);
  const [{ body: half }] = await asked({ gear: { ...gear, every_second_pin: true } });
  assert.ok(half.gear.every_second_pin && !half.include.includes("ring_mesh"), "no method knows its forces: the check says so");
  const involute = { kind: "involute", module_mm: 3, teeth_difference: 2, satellite_profile_shift: 0, ring_profile_shift: 0.4 };
  const [{ body: { include } }] = await asked({ gear: involute });
  assert.ok(include.includes("ring_mesh") && include.includes("ring_drawing"));
  const { teeth } = await import("../../static/calculators/crank-planetary/parts.js");
  assert.deepEqual(teeth.figure.body({}, {}, [alone]), { ...alone.body, include: ["ring_mesh"] });
  const { rows } = WANTED.find(({ id }) => id === "teeth").fields["deviations.ring_pins"];
  assert.deepEqual([{ ratio: 20 }, { satellite_teeth: 19, ring_teeth: 20 }].map((mechanism) => rows({ mechanism }).length), [21, 20]);
});

test("discs are drawn of which all is known, each with its own crank", async () => {
  const drawn = async (gear, mechanism = {}) => {
    const filled = { ...DESIGN, mechanism: { ...DESIGN.mechanism, ...mechanism }, besides: { bearings: { on: "on" }, gear } };
    const requests = [];
    await calculator.ask({
      post: async (path, body) => {
        requests.push({ path: `/api/v1${path}`, body });
        return {};
      },
      input: filled, filled, sections: calculator.sections, tables: new Set(),
    });
    return calculator.files({ requests }, 40);
  };
  const cycloid = { kind: "cycloid", ring_pin_circle_radius_mm: 60, ring_pin_radius_mm: 5 };
  const modification = { equidistant_mm: 0.02 };
  for (const gear of [cycloid, { ...cycloid, ring_pin_radius_mm: undefined, modification }, { kind: "involute", module_mm: 2 }]) {
    assert.deepEqual(await drawn(gear), []);
  }
  const files = await drawn({ ...cycloid, modification }, { crank_angles_deg: [0, 100, 230], satellites: 3 });
  const [{ body: { design } }] = files;
  const drawing = (id, more) => ({ id, path: "/export/dxf", titled: true, body: { design, ...more } });
  assert.deepEqual(files, [
    drawing("dxf", { crank_angle_deg: 40 }),
    drawing("dxf_assembly", { parts: ["assembly"], crank_angle_deg: 40 }),
    ...["carrier", "shaft", "housing"].map((part) => drawing(`dxf_${part}`, { parts: [part] })),
    ...["build123d", "step"].map((id) => ({ id, path: `/export/${id}`, body: { design } })),
  ]);
  assert.deepEqual(design.gear, { ...cycloid, modification });
  assert.equal(design.include, undefined);
});

test("more pairs than the service takes are refused without it: of a mechanism, made forces, figures", async () => {
  const { MOST_PAIRS } = await import("../../static/calculators/crank-planetary/mechanism.js");
  const design = (pairs, made = {}) => ({
    ...DESIGN, mechanism: { pins: pairs / 2, satellites: 2, ratio: 20 }, contact: { ...DESIGN.contact, hole_radius_mm: 7, ...made }, besides: {},
  });
  const ask = (input, sections) => calculator.ask({ post: async () => ({}), input, filled: input, sections, tables: new Set() });
  const refused = (limit) => ({ status: 422, errors: [{ pointer: "/mechanism/pins", code: "too_many_pairs", params: { limit, satellites: 2 } }] });
  const made = { hole_clearance_mm: 0.03 };
  await ask(design(MOST_PAIRS.all), calculator.sections);
  await ask(design(MOST_PAIRS.turned, made), calculator.sections);
  await ask(design(MOST_PAIRS.all, made), ["cyclogram", "contact_force"]);
  await assert.rejects(ask(design(MOST_PAIRS.all + 2), ["cyclogram"]), refused(MOST_PAIRS.all / 2));
  await assert.rejects(ask(design(MOST_PAIRS.turned + 2, made), calculator.sections), refused(MOST_PAIRS.turned / 2));
  const turn = { client: { post: async () => ({}) }, body: real.asked(design(MOST_PAIRS.turned + 2, made)) };
  assert.throws(() => real.ask(turn), refused(MOST_PAIRS.turned / 2));
  assert.throws(() => real.drawn(turn.body), refused(MOST_PAIRS.drawn / 2));
  const figures = calculator.figures.filter(({ id }) => ["cyclogram", "force"].includes(id));
  for (const { body } of figures) {
    body(design(MOST_PAIRS.drawn));
    assert.throws(() => body(design(MOST_PAIRS.drawn + 2)), refused(MOST_PAIRS.drawn / 2));
  }
  for (const id of ["strength", "losses", "bearings", "crank"]) {
    const { [id]: { figure } } = await import("../../static/calculators/crank-planetary/parts.js");
    assert.throws(() => figure.body({}, {}, [{ body: design(MOST_PAIRS.drawn + 2) }]), refused(MOST_PAIRS.drawn / 2), id);
  }
});

test("the tables of a measured part as lists, holes by satellites, what is not said as 0", () => {
  const holes = Array.from({ length: 6 }, (_, i) => (i === 4 ? { hole_radius_mm: 0.02 } : {}));
  const said = (deviations) => documentOf({ ...DESIGN, besides: { real: { on: "on" }, deviations } }).deviations;
  assert.deepEqual(said({ pins: [{}, { pin_radial_mm: -0.01 }, {}], holes }), {
    pin_radial_mm: [0, -0.01, 0], hole_radius_mm: [[0, 0, 0], [0, 0.02, 0]],
  });
  assert.equal(said({}), undefined);
});

const quantity = {
  nominal: 100, mean: 110, percentiles: [{ percent: 50, value: 120, low: 118, high: 122 }, { percent: 95, value: 200, low: 190, high: 210 }],
  histogram: { edges: [110, 150, 230], counts: [3, 1] },
  contributions: [
    { source: "hole_position_mm", total: 0.9, total_error: 0.05, first: 0.3, first_error: 0.1, percentile_without: { percent: 95, value: 195, low: 190, high: 199 } },
    { source: "disc_phase_deg", total: 0.6, total_error: 0.05, first: -0.1, first_error: 0.1, percentile_without: { percent: 95, value: 150, low: 140, high: 160 } },
    { source: "crank_phase_deg", total: 0.01, total_error: 0.01, first: 0, first_error: 0.1, percentile_without: { percent: 95, value: 200, low: 190, high: 210 } },
  ],
};

test("the study: what to tighten is what lowers the percentile most, not what has the largest share", () => {
  const words = study.advice("peak_force_N", quantity).map(([, text]) => text).join(" ");
  assert.match(words, /Tighten first: Disc phase\. Without it P95 .* 150\s*N, by 25\s*% better/);
  assert.match(words, /hardly anything .*: Crank phase/);
  assert.match(words, /add up to more than 100/);
  assert.equal(study.ranked("peak_force_N", quantity)[1].alone, "0\u00a0%");
  const stiffer = { ...quantity, contributions: [{ ...quantity.contributions[1], percentile_without: { percent: 95, value: 260, low: 250, high: 270 } }] };
  assert.match(study.advice("stiffness_min_Nm_per_arcmin", stiffer)[0][1], /Tighten first/); // more is better
  assert.match(study.advice("peak_force_N", stiffer)[0][1], /no single/);
});

test("the two errors are those of the quantity that is spoken of", () => {
  const answer = { samples: 40, cannot_assemble: { value: 0.1, low: 0.05, high: 0.2 }, cannot_work: 2, accuracy: { sampling_error: 1 } };
  const words = study.exactness("peak_force_N", { ...quantity, angle_grid_error: 0.02 }, answer);
  assert.deepEqual(words.map(([level]) => level), ["", "", "warning", "bad"]);
  assert.match(words[0][1], /Real peak force.* ±5\s*% with 40 pieces/);
  assert.match(words[1][1], /positions 2\s*% of/);
});

test("the histogram has room for all marks", () => {
  const { marks } = study.quantityOf("peak_force_N", quantity);
  const { bars, marks: lines, low, high } = study.barsOf(quantity.histogram, marks);
  assert.deepEqual([low, high, bars[0].height, lines[0].x], [100, 230, 1, 0]);
  assert.ok(Math.abs(bars[1].x + bars[1].width - 1) < 1e-12);
  assert.deepEqual(marks.map(({ value }) => value), ["100\u00a0N", "120\u00a0N", "200\u00a0N"]);
});

test("the study asks with the design document, its ring too, and leaves a number of samples that is not said to the service", () => {
  const gear = { kind: "cycloid", ring_pin_circle_radius_mm: 60, ring_pin_radius_mm: 4, modification: { equidistant_mm: 0.02 } };
  const tolerances = { equidistant_mm: 0.003, ring_pin_diameter: { class: "h6" } };
  const input = { ...DESIGN, besides: { bearings: { on: "on" }, gear, study: { on: "on", ranked: "ranked" }, tolerances, quantities: ["ring_peak_force_N"] } };
  const body = JSON.parse(JSON.stringify(study.asked(input)));
  const include = ["histogram", "contributions"];
  assert.deepEqual(body, { ...documentOf(input), tolerances, quantities: ["ring_peak_force_N"], include });
  assert.deepEqual([body.gear, body.satellite_coupling, body.samples], [gear, undefined, undefined]);
  assert.ok(!("tolerances" in documentOf(input))); // what nobody runs keeps nothing from an answer
});

test("what is pasted becomes rows of cells; one value is left to the box", () => {
  assert.deepEqual(pasted("0,01\t0\r\n-0.02\t\r\n"), [["0,01", "0"], ["-0.02", ""]]);
  assert.equal(pasted("0.01"), null);
});

test("the calculator's own groups have words for all that they add", () => {
  for (const { id, fields } of WANTED) {
    for (const { words } of [{ words: ["on", id] }, ...Object.values(fields)]) if (words) assert.ok(fieldWords(...words), words.join());
  }
});

test("the friction of a plastic is asked, that of metals starts from a usual value", () => {
  const table = { pla: { youngs_modulus_GPa: 3 }, steel: { youngs_modulus_GPa: 206 } };
  const { starts } = WANTED.find(({ id }) => id === "losses");
  const friction = (pin, hole) => starts({ contact: { pin_material: pin, hole_material: hole } }, (_, given) => table[given] ?? given)["friction.coefficient"];
  assert.deepEqual([friction("steel", "steel"), friction("steel", "pla")], [0.08, undefined]);
  assert.deepEqual([friction({ name: "pla", poissons_ratio: 0.38 }, "steel"), friction("steel", { youngs_modulus_GPa: 70, poissons_ratio: 0.3 })], [undefined, 0.08]);
});

test("a pin has one material, unless it was typed apart", () => {
  const pin = { satellite_positions_mm: [9, 23] };
  const of = (material, pin_material = "tough") => inputOf({ contact: { pin_material }, pin: { ...pin, material } }).besides.pin;
  assert.deepEqual(of("tough"), pin);
  assert.deepEqual(of({ yield_strength_MPa: 1 }, { yield_strength_MPa: 1 }), pin);
  assert.deepEqual(of("hard"), { ...pin, material: "hard" });
  assert.deepEqual(Object.keys(WANTED.find(({ id }) => id === "strength").starts({})), ["fatigue.reliability_percent"]);
});

test("what is typed of housing and carrier is asked for, and places follow the gap", async () => {
  const build = { gap_mm: 3 };
  const input = inputOf({ mechanism: { satellites: 2 }, contact: { contact_length_mm: 20 }, build });
  assert.deepEqual(wantedSections(input), ["envelope"]);
  assert.deepEqual(documentOf(input).build, build);
  assert.deepEqual(documentOf({ ...input, besides: { housing: { on: "on" } } }).build, {});
  const { follows } = WANTED.find(({ id }) => id === "strength").fields["pin.satellite_positions_mm"];
  assert.deepEqual([follows(input), follows({ ...input, besides: { build } })], [[13, 36], [12, 34]]);
  const { housing: { cells } } = await import("../../static/calculators/crank-planetary/parts.js");
  const [around, along] = cells({ outer_diameter_mm: 152, length_mm: 74.8, of: ["housing", "carrier", "bearing_b"] });
  assert.match(`${around.value} ${around.note}`, /152.*Ring housing/);
  assert.match(`${along.value} ${along.note}`, /74\.8.*Carrier; Bearing B/);
});

test("mass and inertia are asked for where they are wanted, and say of each part what is known", async () => {
  const input = inputOf({ mechanism: { satellites: 2 }, contact: {} });
  assert.deepEqual(wantedSections({ ...input, besides: { ...input.besides, mass: { on: "on" } } }), ["mass"]);
  const { mass: { cells } } = await import("../../static/calculators/crank-planetary/parts.js");
  const parts = [{ code: "discs", count: 2, mass_kg: 2.88, estimate: false }, { code: "housing", count: 1, mass_kg: 1.569, estimate: true }];
  const lacks = { code: "bearing_a", reason: { code: "bearing_unnamed", detail: "Only" }, missing: ["/crankshaft/bearings"] };
  const [whole, inertia, discs, housing, bearing] = cells({ mass_kg: 6.852, inertia_kg_m2: 5.6e-5, parts: [...parts, lacks] });
  assert.match(`${whole.value} ${whole.note}`, /6\.852.*kg without motor/);
  assert.match(inertia.value, /kg·m²/);
  assert.match(`${discs.label} ${discs.value} ${discs.note}`, /^Discs 2\.88\s*kg pieces: 2$/);
  assert.match(`${housing.label} ${housing.note}`, /^Ring housing pieces: 1; estimate$/);
  assert.match(`${bearing.label} ${bearing.value} ${bearing.note}`, /^Bearing A – Only bearings of the table/);
});

test("rollers say load, life and safety, and what they lack", async () => {
  const { rolling: { cells } } = await import("../../static/calculators/crank-planetary/parts.js");
  const found = { equivalent_load_N: 33.55, peak_load_N: 56.25, satellite: 1, pin: 2 };
  const [load, life, safety] = cells({ ...found, life_h: 3.24e6, dynamic_rating_as_roller_N: 815.8, static_safety_factor: 4.889, speed_rpm: 73.85 });
  assert.match(load.note, /56.25/);
  assert.match(life.label, /90/);
  assert.match(`${life.value} ${life.note}`, /815.8/);
  assert.match(`${safety.value} ${safety.note}`, /4.89.*73.85/);
  assert.deepEqual(cells(found).slice(1).map(({ value }) => value), ["–", "–"]);
});

test("a design document switches on the groups whose parts it has, and is asked for as it was", () => {
  const document = {
    pin: { diameter_mm: 11, satellite_positions_mm: [9, 23] },
    fatigue: { surface: "ground", notch: { theoretical_factor: 2, radius_mm: 0.5 } },
    friction: { coefficient: 0.08, sleeve: true },
    gear: { kind: "ratio", radial_force_ratio: 0.4 },
    bearing: { kind: "ball", dynamic_rating_N: 9000 },
    crankshaft: { bearing_positions_mm: [0, 40] },
    requirements: { life_h: 900, bending_safety: 2 },
  };
  const mechanism = { pins: 6 };
  const { gear: { kind, ...ratio } } = document;
  const input = inputOf({ mechanism, ...document });
  assert.deepEqual(wantedSections(input), ["pin_strength", "output_efficiency", "satellite_bearing", "crankshaft"]);
  assert.deepEqual(documentOf(input), { mechanism, ...document, gear: ratio });
  assert.deepEqual(input.besides.strength, { on: "on", surface: "sleeved", fatigue: "notch" });
  const rollers = { name: "686", radial_clearance_mm: 0.02 };
  const rolling = inputOf({ mechanism, ...document, friction: undefined, rollers });
  assert.deepEqual(wantedSections(rolling), ["pin_strength", "rollers", "satellite_bearing", "crankshaft"]);
  assert.deepEqual(documentOf(rolling).rollers, rollers);
  const rubbing = inputOf({ ...document, rollers });
  assert.equal(documentOf(rubbing).friction, undefined, "rollers have a friction of their own");
  for (const [part, section] of [["pin", "pin_strength"], ["friction", "output_efficiency"], ["bearing", "satellite_bearing"]]) {
    assert.deepEqual(wantedSections(inputOf({ [part]: document[part] })), [section]);
  }
  assert.deepEqual(wantedSections(inputOf({ mechanism })), []);
});

test("satellites along the shaft are as far apart as along the pins until they are typed", () => {
  const { fields } = WANTED.find(({ id }) => id === "crank");
  const { follows } = fields["crankshaft.satellite_positions_mm"];
  const { follows: bearings } = fields["crankshaft.bearing_positions_mm"];
  const input = (pins, shaft) => ({
    mechanism: { satellites: 2 }, contact: { contact_length_mm: 20 },
    besides: { ...(pins && { pin: { satellite_positions_mm: pins } }), crankshaft: { satellite_positions_mm: shaft } },
  });
  assert.deepEqual(follows(input()), [20, 42]);
  assert.deepEqual([[15, 45], [45, 15], [15]].map((pins) => follows(input(pins))), [[20, 50], [50, 20], [20, 42]]);
  assert.deepEqual(bearings(input([15, 45], [50, 20])), [0, 70]);
});

test("the difference of teeth follows their numbers, and is asked for with a ratio alone", () => {
  const { fields, starts } = WANTED.find(({ id }) => id === "bearings");
  const { follows } = fields["gear.teeth_difference"];
  const [byTeeth, byRatio] = [{ satellite_teeth: 38, ring_teeth: 40 }, { ratio: 19 }].map((mechanism) => ({ mechanism, contact: { eccentricity_mm: 2 } }));
  assert.deepEqual([follows(byTeeth), follows(byRatio)], [2, NaN]);
  assert.deepEqual([starts(byTeeth)["gear.teeth_difference"], starts(byRatio)["gear.teeth_difference"]], [undefined, 1]);
});

test("a field stands in one group: in two, what is left empty in one would be said by the other", () => {
  const groups = WANTED.flatMap(({ fields }) => Object.keys(fields));
  assert.deepEqual(groups.filter((path, index) => groups.indexOf(path) !== index), []);
});

test("the ideal force is measured with what its endpoint knows of a load, whatever the design says of it", () => {
  const at = (schema) => schema.$ref ? openapi.components.schemas[schema.$ref.split("/").pop()] : schema;
  const fieldsOf = (path) => Object.keys(at(openapi.paths[`/api/v1${path}`].post.requestBody.content["application/json"].schema).properties);
  const every = Object.fromEntries(Object.keys(openapi.components.schemas.DesignLoadFields.properties).map((name) => [name, 1]));
  const ideal = calculator.figures.find(({ measures }) => measures === "contact-force").body({ ...DESIGN, load: every });
  assert.ok("output_torque_Nm" in ideal);
  assert.deepEqual(Object.keys(ideal).filter((name) => name in every && !fieldsOf("/contact-force").includes(name)), []);
});

test("tolerances of a design open the study by the way in which they are said, and a verdict knows where ring pins may stand", () => {
  const sizesOf = (tolerances) => inputOf({ mechanism: { satellites: 2 }, tolerances }).besides.study.sizes;
  assert.equal(sizesOf({ process: "ground" }), "process");
  assert.equal(sizesOf({ hole_diameter: { class: "H7" } }), "class");
  assert.equal(sizesOf({ hole_diameter: { lower_mm: -0.4, upper_mm: 0 } }), "limits");
  const input = inputOf({ mechanism: { satellites: 2 }, tolerances: { ring_pin_position_mm: 0.01, hole_position_mm: 0.02 } });
  assert.deepEqual(documentOf(input).tolerances, { ring_pin_position_mm: 0.01 });
  const off = { ...input, besides: { ...input.besides, study: {} } };
  assert.equal(documentOf(off).tolerances, undefined);
});

test("a request that is opened keeps all that has a field, and what has none is named", () => {
  const model = formModel(openapi, { ...calculator, path: `/api/v1${calculator.path}`, words: ownWords });
  const opened = (request) => {
    const { include, ...input } = inputOf(request);
    const { input: taken } = readState(model, withLinks(model, stateFromInput(model, input)));
    return { lost: lostOf(model, input), asked: documentOf(taken) };
  };
  const ours = examples.examples.filter(({ calculation }) => calculation === "crank-planetary");
  for (const { id, input } of ours) assert.deepEqual(opened(input).lost, [], id);
  const { input: whole } = ours.find(({ id }) => id === "cycloid");
  const more = {
    contact_law: { kind: "linear", stiffness_N_per_mm: 50000 },
    crank_support: { stiffness_N_per_mm: 80000, radial_clearance_mm: 0.01 },
    deviations: { pin_radial_mm: Array(whole.mechanism.pins).fill(0.01), ring_pin_radial_mm: [0.002, 0, 0.001] },
  };
  const { lost, asked } = opened({ ...whole, ...more });
  assert.deepEqual([lost, asked.contact_law, asked.crank_support], [[], more.contact_law, more.crank_support]);
  assert.deepEqual(asked.deviations.pin_radial_mm, more.deviations.pin_radial_mm);
  assert.deepEqual(opened({ ...whole, satellite_coupling: { kind: "ring" } }).lost, ["satellite_coupling.kind"]);
});
