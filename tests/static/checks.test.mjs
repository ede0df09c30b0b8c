/** The service's verdict, checks, fixes and sizes in words. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { assumedIn, checkRow, decisive, fixRow, isLimited, judgedOf, lookedAt, notConsidered, partRow, sizedBy, torqueNote, torqueUnknown, unknownIn, verdictSentence, wordNote, wordOf, wordText } from "../../static/lib/checks.js";
import { solutionOf, solveBody, targetsOf } from "../../static/lib/sizing.js";
import { useLanguage } from "./service.mjs";

const PRESSURE = {
  code: "new_pressure", title: "Contact pressure of the hole", status: "fail", value: 548.2, limit: 484.9, unit: "MPa", keep: "below",
  utilisation: 1.13, torque_reserve: 0.78, criterion: "endurance", source: "A book", verified: "secondary", why: "It pits.",
  at: { satellite: 1, pin: 3, crank_angle_deg: 28.57 }, inputs: ["/contact/pin_radius_mm"],
};
const UNKNOWN = {
  code: "new_unknown", title: "Pin", status: "not_checked", keep: "below", unit: "MPa",
  reason: { code: "new_reason", params: {}, detail: "no limit is known" }, missing: ["/contact/pin_material"], inputs: ["/contact/pin_radius_mm"],
};
const JUDGED = { verdict: "fail", governing: "new_pressure", torque_reserve: 0.78, largest_torque_Nm: 218.13, checks: [PRESSURE, UNKNOWN], not_considered: ["clearance"] };
const titles = new Map();

test("the verdict stands at the answer or in the section that a calculator names", () => {
  assert.equal(judgedOf({}, JUDGED), JUDGED);
  assert.equal(judgedOf({ judgedIn: "shaft" }, { shaft: JUDGED }), JUDGED);
  assert.equal(judgedOf({}, {}), null);
  assert.equal(judgedOf({ judgedIn: "shaft" }, undefined), null);
});

test("what is impossible is more than failing", () => {
  assert.equal(wordOf(JUDGED), "fail");
  assert.equal(wordOf({ verdict: "fail", checks: [{ impossible: true }] }), "impossible");
  assert.equal(verdictSentence(JUDGED, titles), "Fails. Contact pressure of the hole: 548.2\u00a0MPa (≤\u00a0484.9\u00a0MPa). Largest torque allowed 218.1\u00a0N·m.");
});

test("a check says value, limit with its sense, share, source and place; one without data what is missing, and never passes", () => {
  const row = checkRow(PRESSURE, titles);
  assert.deepEqual([row.level, row.value, row.limit, row.used], ["bad", "548.2\u00a0MPa", "≤\u00a0484.9\u00a0MPa", 1.13]);
  assert.match(row.source, /: A book: secondary sources$/);
  assert.equal(row.place, "satellite 1, pin 3, φ = 28.57°");
  const { utilisation, ...bare } = PRESSURE; // judged without a share, as what only has to be there
  const plain = checkRow({ ...bare, status: "pass" }, titles);
  assert.deepEqual([plain.used, plain.judged, plain.level], [undefined, true, "good"]);
  assert.deepEqual(sizedBy({ checks: [bare] }), []);
  const unknown = checkRow(UNKNOWN, titles);
  assert.deepEqual([unknown.level, unknown.judged, unknown.reason, unknown.missing], ["warning", false, "No limit is known", ["contact.pin_material"]]);
  for (const status of ["not_asked", "not_applicable", "new"]) assert.equal(checkRow({ ...UNKNOWN, status }, titles).level, undefined);
});

test("of what there should be nothing a check says that there is none, and how much there is", () => {
  const shown = (check) => [checkRow({ code: "dead_centre", status: "pass", limit: 0, ...check }, titles)].map(({ value, limit }) => `${value} (${limit})`)[0];
  assert.equal(shown({ value: 0 }), "none ()");
  assert.equal(shown({ value: 3 }), "3 (none allowed)");
  assert.equal(shown({ value: 0.01, unit: "mm" }), "0.01\u00a0mm (none allowed)");
  assert.equal(shown({ value: 20, unit: "mm", keep: "above" }), "20\u00a0mm (≥\u00a00\u00a0mm)");
});

test("what is not looked at is said", () => {
  assert.match(notConsidered(JUDGED), /^Not looked at: .+\.$/);
  assert.equal(notConsidered({}), "");
});

test("a largest torque that is not known says why", () => {
  assert.equal(torqueUnknown({ verdict: "incomplete", counts: { not_checked: 2 } }), "not known: 2 checks are open");
  const small = { code: "new_room", title: "Room", status: "fail" };
  assert.equal(torqueUnknown({ verdict: "fail", counts: { not_checked: 0 }, checks: [PRESSURE, small] }), "not known: less torque does not cure “Room”");
  assert.equal(torqueUnknown({ verdict: "incomplete", counts: { not_checked: 0 } }), "no check hangs on the torque");
  const solved = { code: "new_pressure", status: "fail", inputs: ["/load/output_torque_Nm"] };
  assert.match(torqueUnknown({ verdict: "fail", counts: { not_checked: 0 }, checks: [solved] }), /^not known: no torque is found/);
});

test("a largest torque that is asked for later is not in the sentence", () => {
  assert.match(verdictSentence(JUDGED, titles), /Largest torque allowed \d+(\.\d)?\u00a0N·m\.$/);
  const { largest_torque_Nm: _, ...unknown } = JUDGED;
  assert.doesNotMatch(verdictSentence(unknown, titles), /torque/);
});

test("the largest torque is asked for of what is judged and can be, with a clearance that is known", () => {
  const asks = (answer, limit = ["largest_torque"]) => isLimited({ limit }, { parts: [{ status: "pass" }, { status: "open" }], ...answer });
  assert.ok(asks({}));
  assert.deepEqual([
    asks({}, null), asks({ parts: [{ status: "open" }] }), asks({ checks: [{ impossible: true }] }), asks({ cold_yield: {} }),
    asks({ parts: [{ status: "fail" }, { status: "open", reason: "clearance_unknown" }] }),
  ], [false, false, false, false, false]);
});

test("a largest torque says what it does not count, and what holds above it", () => {
  const said = { verdict: "marginal", torque_reserve: 1.25, largest_torque_without: ["ring_pieces"] };
  assert.match(torqueNote(said), /^not counted: /);
  assert.match(torqueNote({ verdict: "incomplete", torque_reserve: 0.8 }), /^held for certain/);
  assert.deepEqual([torqueNote({ verdict: "fail", torque_reserve: 0.8 }), torqueNote({ verdict: "pass", torque_reserve: 2 })], ["", ""]);
});

test("what is incomplete counts what is not known, or says that nothing could break", () => {
  const note = (not_checked) => wordNote({ verdict: "incomplete", counts: { not_checked }, checks: [] });
  assert.deepEqual([note(1), note(0)], ["", "nothing that was looked at could break"]);
  const parts = ["pass", "open", "open", "left_out"].map((status) => ({ status }));
  const open = { verdict: "incomplete", counts: { not_checked: 3 } };
  assert.deepEqual([wordText({ ...open, parts }), unknownIn({ ...open, parts }), unknownIn(open)], ["Incomplete (1 of 3)", 2, 3]);
  assert.equal(wordNote({ verdict: "pass", counts: { not_checked: 0 }, checks: [] }), "");
  assert.match(wordNote({ verdict: "fail", counts: { not_checked: 2 }, checks: [{ impossible: true }] }), /cannot be built/);
});

test("of plastic the first yield decides where it uses more than the check that governs and holds", () => {
  const code = (checks, verdict = "incomplete") => decisive({ verdict, governing: "new_life", parts: [], checks })?.code;
  const yields = (utilisation) => ({ code: "new_yield", status: "not_checked", reason: { code: "necessary_only" }, utilisation });
  const life = { code: "new_life", status: "pass", utilisation: 0.2 };
  assert.equal(code([life, yields(0.9), { ...yields(0.5), code: "other_yield" }]), "new_yield");
  assert.equal(code([life, yields(0.1), UNKNOWN]), "new_life");
  assert.equal(code([{ ...life, status: "fail", utilisation: 0.2 }, yields(0.9)], "fail"), "new_life");
  assert.equal(code([yields(0.9)]), "new_yield");
  assert.equal(decisive({ verdict: "incomplete", checks: [life, UNKNOWN] }).code, UNKNOWN.code);
});

test("a marginal verdict says by what it is one; which parts were looked at is said apart", () => {
  const check = { code: "pin_static", status: "marginal", group: "new", because: "margin", reason: { code: "life_without_speed", detail: "…" } };
  const judged = { verdict: "marginal", governing: "pin_static", counts: { not_checked: 0 }, checks: [check] };
  assert.match(wordNote(judged, new Map()), /1\.1 times the torque/);
  const of = (more) => wordNote({ ...judged, checks: [{ ...check, because: undefined, ...more }] }, new Map());
  assert.match(of({ because: "guide" }), /guide value/);
  assert.match(of({ reason: { code: "range_decides", detail: "It holds at one end" } }), /one end/);
  assert.equal(lookedAt(judged), "looked at: new");
});

test("numbers of a formula are written as the language writes them", async () => {
  const formula = () => checkRow({ ...PRESSURE, formula: "p ≤ 2.31·R_e" }, titles).formula;
  assert.equal(formula(), "p ≤ 2.31·R_e");
  await useLanguage("uk");
  try {
    assert.equal(formula(), "p ≤ 2,31·R_e");
  } finally {
    await useLanguage("en");
  }
});

test("a fix says the change, the verdict it leads to and what else it does; one that is not enough cannot be applied", () => {
  const fix = {
    pointer: "/contact/pin_radius_mm", from: 8, to: 12.5, unit: "mm", change: 0.5625, standard: "ISO 8734", status: "solved", verdict: "marginal",
    sets: { "/contact/pin_radius_mm": 12.5 },
    side_effects: [{ code: "new_pressure", status_from: "fail", status_to: "pass", utilisation_from: 1.13, utilisation_to: 0.9 }],
  };
  const fields = new Map([["contact.pin_radius_mm", FIELD]]);
  const fieldAt = (path) => fields.get(path);
  const row = fixRow(fix, fieldAt, JUDGED);
  assert.deepEqual([row.applies, row.text, row.then, row.level], [true, "Pin radius 8\u00a0mm → 12.5\u00a0mm (+56.3\u00a0%)", "Just works", "warning"]);
  assert.equal(row.effects[0].text, "Contact pressure of the hole: 113\u00a0% → 90\u00a0% of the limit");
  assert.equal(fixRow({ ...fix, status: "not_enough", sets: undefined }, fieldAt, {}).applies, false);
  const chosen = { ...fix, pointer: "/contact/fit", title: "Fit", unit: "", from: "H9/f9", to: "H7/f7", change: undefined, sets: { "/contact/fit": "H7/f7" } };
  assert.deepEqual(["applies", "text"].map((name) => fixRow(chosen, fieldAt, JUDGED)[name]), [true, "Fit: H9/f9 → H7/f7"]);
  // What it sets besides is said, in the units of the boxes; and what has no share of a limit by its status.
  fields.set("contact.pin_radius_mm", { title: "Pin diameter", unit: "⌀ mm" }).set("contact.hole_radius_mm", { title: "Hole diameter", unit: "⌀ mm" });
  const sets = { ...fix.sets, "/contact/hole_radius_mm": 15, "/not/here": 1 };
  const wall = { code: "new_wall", status_from: "pass", status_to: "fail", utilisation_from: 0 };
  const wide = fixRow({ ...fix, sets, side_effects: [wall] }, fieldAt, { checks: [{ code: "new_wall", title: "Wall" }] });
  assert.equal(wide.text, "Pin diameter 16\u00a0mm → 25\u00a0mm (+56.3\u00a0%); Hole diameter → 30\u00a0mm");
  assert.deepEqual([wide.effects[0].level, wide.effects[0].text], ["bad", "Wall: met → not met"]);
  // Several inputs together are one click.
  const both = fixRow({ sets: { ...sets, "/mechanism/pins": 7 }, steps: [fix, { ...fix, pointer: "/mechanism/pins", title: "Pins", unit: "", from: 8, to: 7, change: -0.125, sets: {} }], verdict: "incomplete" }, fieldAt, { parts: [] });
  assert.deepEqual([both.applies, both.then, both.effects, both.level], [true, "Incomplete", [], ""]);
  assert.equal(both.text, "Together: Pin diameter 16\u00a0mm → 25\u00a0mm (+56.3\u00a0%); Pins 8 → 7 (−13\u00a0%)");
});

const FIELD = { path: "contact.pin_radius_mm", name: "pin_radius_mm", title: "Pin radius", kind: "number", unit: "mm", lowest: 1e-12, highest: 1e12 };
const calculator = { path: "/job", targets: [{ pointer: "/hertz/safety_factor", quantity: "safety_factor", value: 1.5 }] };
const shown = { input: { contact: { pin_radius_mm: 8 } }, filled: { contact: { pin_radius_mm: 8 } } };

test("a field is sized for the checks that hang on it, about its value", () => {
  const targets = targetsOf(calculator, JUDGED, FIELD.path);
  assert.deepEqual(targets.map(({ pointer, value }) => [pointer, value]), [
    ["/hertz/safety_factor", 1.5], ["/torque_reserve", 1.1], ["/checks/new_pressure/utilisation", 100],
  ]);
  assert.deepEqual(targetsOf(calculator, JUDGED, "mechanism.pins"), []);
  const unjudged = { ...JUDGED, checks: [UNKNOWN] };
  assert.deepEqual([sizedBy(unjudged), targetsOf(calculator, unjudged, FIELD.path)], [[], []], "no size is offered for what is not judged");
  assert.deepEqual(sizedBy(JUDGED), [PRESSURE]);
  assert.deepEqual(solveBody(calculator, FIELD, shown, targets[2], 90, "smallest"), {
    calculation: "job", input: shown.input, variable: { pointer: "/contact/pin_radius_mm", from: 0.4, to: 160, log: true },
    target: { pointer: "/checks/new_pressure/utilisation", at_most: 0.9 }, want: "smallest",
  });
  const pins = { ...FIELD, path: "mechanism.pins", kind: "integer", lowest: 2, highest: 40 };
  assert.deepEqual(solveBody(calculator, pins, { ...shown, filled: { mechanism: { pins: 6 } } }, targets[0], 1.5, "smallest").variable,
    { pointer: "/mechanism/pins", from: 2, to: 40, integer: true });
});

test("the answer of the solver in words, with what a click applies", () => {
  const [target] = targetsOf(calculator, JUDGED, FIELD.path);
  const solved = solutionOf(FIELD, target, "smallest", { status: "solved", value: 8.03, standard_size: 8.5 });
  assert.deepEqual(solved, { text: "Pin radius: at least 8.03\u00a0mm. Next standard size: 8.5\u00a0mm.", sets: { "/contact/pin_radius_mm": 8.03 } });
  const linked = { "/contact/pin_radius_mm": 10.8739458878, "/contact/hole_radius_mm": 12.8739458878 };
  const rounded = solutionOf(FIELD, target, "smallest", { status: "solved", value: 10.8739458878, sets: linked });
  assert.deepEqual(rounded.sets, { "/contact/pin_radius_mm": 10.88, "/contact/hole_radius_mm": 12.88 }, "to the safe side, the hole too");
  assert.equal(solutionOf(FIELD, target, "largest", { status: "solved", value: 10.8739 }).sets["/contact/pin_radius_mm"], 10.87);
  const not = solutionOf(FIELD, target, "smallest", { status: "infeasible", best: { value: 20, target: 1.2 } });
  assert.deepEqual(not, { text: "Not enough: at best 1.2, at 20\u00a0mm." });
  assert.equal(solutionOf(FIELD, target, "largest", { status: "always" }).sets, undefined);
});

for (const language of ["uk", "ru"]) {
  test(`${language}: no English in what the page says of a verdict`, async () => {
    await useLanguage(language);
    try {
      const { title, why, source, ...row } = checkRow({ ...PRESSURE, reason: undefined }, titles);
      const text = [row.limit, row.place, verdictSentence({ ...JUDGED, governing: undefined }, titles)].join();
      assert.doesNotMatch(text, /[a-z]{3,}|\{/);
    } finally {
      await useLanguage("en");
    }
  });
}

test("what is assumed is said with its title, in the user's words", async () => {
  const assumed = [{ pointer: "/mechanism/satellites", value: 2 }, { pointer: "/contact/pin_material", value: "steel_bearing" }];
  assert.equal(assumedIn({}), "");
  assert.equal(assumedIn({ assumed }), "Assumed, as it is not given: Satellites: 2; Pin material: Bearing steel (100Cr6, hardened).");
  const bearing = { assumed: [
    { pointer: "/rollers/kind", value: "ball" }, { pointer: "/crankshaft/bearings/0/dynamic_rating_N", value: 1680 },
  ] };
  assert.equal(assumedIn(bearing), "Assumed, as it is not given: Rolling elements: Balls; Dynamic load rating: 1680\u00a0N.");
  await useLanguage("uk");
  assert.doesNotMatch(assumedIn({ assumed }), /steel|_/);
  await useLanguage("en");
});

test("the chip of a part that nobody asks for leads to what it would need, as one that lacks something does", () => {
  const ask = (part) => partRow(part).ask;
  assert.equal(ask({ code: "losses", status: "not_asked" }), "friction.coefficient");
  assert.equal(ask({ code: "teeth", status: "open", missing: ["/requirements/life_h", "/gear/modification"] }), "gear.modification");
  assert.equal(ask({ code: "pins", status: "pass", governing: "pin_static" }), undefined);
});
