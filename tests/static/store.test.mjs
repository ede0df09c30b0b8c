/** A calculator at work, step by step, without a page and without a service. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { Problem } from "../../static/lib/api.js";
import { stateFromInput } from "../../static/lib/form_state.js";
import * as next from "../../static/store.js";
import { INPUT, MODEL } from "./model.mjs";

const ACCURACY = { relative_error: 1e-15 };
const ANSWER = { force: { value: 5, accuracy: ACCURACY } };
const catalogues = { "contact.pin_material": [{ name: "steel", youngs_modulus_GPa: 210 }] };

function opened(input = INPUT, calculator = {}) {
  const about = {
    model: MODEL,
    calculator: {
      id: "job", sections: ["force", "hertz"], seeds: {}, drawing: { section: "force" }, figures: [],
      verdict: ({ force }) => [{ label: "Force", ...(force && { value: force.value, unit: "N", note: "all" }) }],
      ...calculator,
    },
    catalogues,
    titles: new Map([["pins", "Pins"]]),
    materialOf: (path, given) => catalogues[path].find(({ name }) => name === given) ?? given,
  };
  return next.opened(about, stateFromInput(MODEL, input), "light");
}

const answeredWith = (state, { answer = ANSWER, refusal = null } = {}) =>
  next.answered(next.asked(state), { answer, refusal, requests: [] });
const refusal = (...errors) => new Problem({ status: 422, detail: "no", errors });

test("a state is opened, asked for and answered", () => {
  let state = opened();
  assert.deepEqual([state.phase, next.standing(state).numbers, next.stale(state)], ["computing", "none", true]);
  state = next.asked(state);
  assert.match(state.address, /^calculator=job&v=2&mechanism\.pins=3/);
  assert.equal(state.pending, state.reading.filled);
  state = answeredWith(state);
  assert.deepEqual(next.standing(state), { phase: "fresh", numbers: "fresh" });
  assert.deepEqual(state.line, ["", "No warnings"]);
  assert.match(state.said, /Force 5 N, all/);
  assert.equal(state.shown.input, state.reading.input);
});

test("what is typed makes the numbers on the screen those of older inputs", () => {
  const before = answeredWith(opened());
  const state = next.typedIn(before, "mechanism.pins", "4", 0);
  assert.equal(state.reading.input.mechanism.pins, 4);
  assert.deepEqual(next.standing(state), { phase: "computing", numbers: "older" });
  assert.equal(before.typed.texts["mechanism.pins"], "3", "nothing is changed in place");
  const back = next.steppedBack(state);
  assert.equal(back.typed, before.typed);
  assert.equal(next.steppedOn(back).typed, state.typed);
  assert.equal(next.steppedBack(back), back);
});

test("an empty field asks until the user has been there; then, or after Enter, it is wrong", () => {
  const empty = opened({ mechanism: {}, contact: { pin_material: "steel" } });
  assert.deepEqual([empty.phase, empty.line], ["incomplete", ["", "Still needed: Pins, Ratio, Pin radius"]]);
  assert.deepEqual(next.unread(empty), { wrong: [], missing: ["mechanism.pins", "mechanism.ratio", "contact.pin_radius_mm"] });
  assert.equal(next.asked(empty).said, empty.line[1]);

  const left = next.left(empty, "mechanism.ratio");
  assert.deepEqual([left.phase, left.line], ["wrong", ["bad", "Ratio: needs a value; Still needed: Pins, Pin radius"]]);
  assert.equal(next.left(left, "mechanism.ratio"), left);
  const begun = next.typedIn(empty, "mechanism.pins", "3", 0);
  assert.equal(begun.line[1], "Still needed: Ratio, Pin radius");
  assert.equal(next.typedIn(begun, "mechanism.pins", "", 0).phase, "wrong");
  assert.deepEqual(next.unread(next.insisted(empty)).missing, []);
  // What a link says wrongly is wrong at once, and what is left full stays as it is.
  assert.equal(next.typedIn(opened(), "mechanism.pins", "x", 0).line[1], "Pins: not a number: write 32.5, 32,5 or 1e-3");
  const fresh = answeredWith(opened());
  assert.equal(next.left(fresh, "mechanism.pins").phase, "fresh");
  assert.equal(next.insisted(fresh).phase, "fresh");
  assert.equal(next.taken(left, stateFromInput(MODEL, { mechanism: {}, contact: {} }), {}, 0).phase, "incomplete");
});

test("a refusal stands at its box until something is typed there, beside what was answered", () => {
  const error = { pointer: "/mechanism/pins", detail: "must be odd" };
  let state = answeredWith(opened(), { refusal: refusal(error) });
  assert.deepEqual(next.standing(state), { phase: "wrong", numbers: "part" });
  assert.equal(state.refusal.at["mechanism.pins"].words, "Must be odd");
  assert.deepEqual(state.line, ["bad", "Pins: must be odd"]);
  state = next.typedIn(state, "mechanism.pins", "5", 0);
  assert.deepEqual(state.refusal.at, {});
  const none = answeredWith(answeredWith(opened()), { answer: null, refusal: refusal({ pointer: "", code: "new_one", params: {}, detail: "cannot work" }) });
  assert.deepEqual([none.phase, none.said, none.shown.answer], ["refused", "Cannot work", ANSWER]);
});

test("a refusal that asks for what nobody has filled in yet calls nothing wrong; after Enter, or where somebody was, it does", () => {
  const needed = refusal({ pointer: "/mechanism/pins", code: "needed", params: { field: "ratio" }, detail: "is needed" });
  const phaseOf = (state, problem = needed) => answeredWith(state, { refusal: problem }).phase;
  assert.equal(phaseOf(opened()), "incomplete");
  assert.deepEqual([phaseOf(next.insisted(opened())), phaseOf(next.left(opened(), "mechanism.pins"))], ["wrong", "wrong"]);
  const lacks = refusal({ pointer: "/contact/pin_material/poissons_ratio", code: "not_sourced", params: { material: "steel" }, detail: "" });
  const lacking = answeredWith(next.insisted(opened()), { refusal: lacks });
  assert.deepEqual([lacking.phase, lacking.line[0]], ["incomplete", ""], "a name of the table is not wrong");
});

test("without the service the numbers count as older, and the reason is said", () => {
  const state = next.failed(next.asked(answeredWith(opened())), new Problem({ title: "unreachable" }));
  assert.deepEqual(next.standing(state), { phase: "offline", numbers: "older" });
  assert.match(state.line[1], /cannot be reached/);
  const long = next.failed(next.asked(answeredWith(opened())), new Problem({ status: 503, kind: "too-long", detail: "not within 10 s" }));
  assert.deepEqual(next.standing(long), { phase: "long", numbers: "older" });
  assert.match(long.line[1], /^The calculation takes longer than the service allows\. Switch off sections/);
  const stopped = (status, kind) => next.failed(next.asked(answeredWith(opened())), new Problem({ status, kind, title: "x" }));
  const [busy, failed] = [stopped(503, "unavailable"), stopped(500, "failure")];
  assert.deepEqual([busy, failed].map(next.standing), [{ phase: "busy", numbers: "older" }, { phase: "failed", numbers: "older" }]);
  assert.match(busy.line[1], /^The service is busy, .*asks again by itself/);
  assert.match(failed.line[1], /^The service failed: this is no error of the input\.$/);
});

test("warnings are said in the line", () => {
  const warned = { ...ANSWER, warnings: [{ code: "new_one", params: {}, detail: "a clearance" }] };
  assert.deepEqual(answeredWith(opened(), { answer: warned }).line, ["warning", "Warning: A clearance"]);
});

test("what cannot be built stands as not possible, and is said with its check", () => {
  const check = { code: "x", title: "Hole too small", status: "fail", impossible: true, value: 7.97, limit: 8, unit: "mm", keep: "above" };
  const answer = { ...ANSWER, verdict: "fail", governing: "x", checks: [check] };
  const state = answeredWith(opened(), { answer });
  assert.deepEqual([state.phase, next.standing(state).phase], ["fresh", "refused"]);
  assert.ok(state.said.startsWith("Impossible. Hole too small: 7.97\u00a0mm (≥\u00a08\u00a0mm)."));
});

test("a fix is applied as one step, and one of another design is passed over", () => {
  const state = answeredWith(opened());
  const mended = next.mended(state, state.shown, [{ sets: { "/mechanism/pins": 5 } }]);
  assert.equal(mended.fixes.of, mended.shown);
  assert.equal(next.mended(state, {}, []), state);
  const named = next.labelled(state, "title", "Wheel", 0); // while it was looked for
  assert.equal(next.mended(named, state.shown, []).fixes.of.answer, named.shown.answer);
  const applied = next.applied(mended, { "/mechanism/pins": 5, "/not/here": 1 }, 0);
  assert.equal(applied.reading.input.mechanism.pins, 5);
  assert.equal(next.steppedBack(applied).reading.input.mechanism.pins, 3);
});

test("an option starts from the same design, from the table, and not over what was typed", () => {
  const seeds = { "cranks.list": ({ mechanism }) => ({ "mechanism.crank_angles_deg": [0, 360 / mechanism.satellites] }) };
  const list = next.chose(opened(INPUT, { seeds }), "cranks", "list", 0);
  assert.equal(list.typed.texts["mechanism.crank_angles_deg"], "0; 180"); // the schema's 2 satellites
  const own = next.chose(opened(), "contact.pin_material", "own", 0);
  assert.equal(own.typed.texts["contact.pin_material.youngs_modulus_GPa"], "210");
  const typed = next.typedIn(own, "contact.pin_material.youngs_modulus_GPa", "70", 0);
  const again = next.chose(next.chose(typed, "contact.pin_material", "named", 0), "contact.pin_material", "own", 0);
  assert.equal(again.typed.texts["contact.pin_material.youngs_modulus_GPa"], "70");
});

test("the drawing waits for the curves of its figure, unless that has none or is a table", () => {
  const calculator = {
    drawing: { section: "force", figure: "force", curves: () => ["own"] }, figures: [{ id: "force", section: "force" }],
  };
  assert.equal(next.drawable(opened(INPUT, calculator)), null);
  const state = answeredWith(opened(INPUT, calculator));
  assert.equal(next.drawable(state), null);
  assert.equal(next.charted(state, "another", []), state);
  const drawn = next.charted(state, "force", [{ mode: "lines", name: "1.1" }, { mode: "markers" }]);
  assert.deepEqual(next.drawable(drawn).curves.map(({ name }) => name), ["1.1"]);
  assert.equal(next.drawable(answeredWith(drawn)), null, "those are of older results");
  assert.deepEqual(next.drawable(next.tabled(state, "force", true)).curves, ["own"]);
  assert.equal(next.drawable(next.tabled(next.tabled(state, "force", true), "force", false)), null);
});

test("the drawing opens at the place that decides, until the user turns it", () => {
  const drawing = { section: "force", start: ({ force }) => force.value };
  const first = answeredWith(opened(INPUT, { drawing }));
  assert.equal(first.turn.angle, 5);
  const turned = answeredWith(next.turned(first, 40));
  assert.equal(turned.turn.angle, 40);
  assert.equal(answeredWith(next.taken(turned, stateFromInput(MODEL, INPUT), 0)).turn.angle, 5);
});

test("a title is no input: it leaves the numbers fresh, stands in the link and can be undone", () => {
  const titled = next.addressed(next.labelled(answeredWith(opened()), "title", "Hoist", 0));
  assert.deepEqual(next.standing(titled), { phase: "fresh", numbers: "fresh" });
  assert.match(titled.address, /&title=Hoist$/);
  assert.equal(next.steppedBack(titled).typed.texts.title, undefined);
});

test("views are told of every state, and act only on what they follow", () => {
  const store = next.createStore(opened());
  const seen = [];
  const view = { update: next.following(({ turn }) => [turn], ({ turn }) => seen.push(turn.angle)) };
  store.show([view]);
  store.apply(next.turned, 30);
  store.apply(next.themed, "dark");
  store.apply(next.selected, "1.2");
  assert.deepEqual(seen, [0, 30, 30]);
  assert.deepEqual(store.state.turn, { angle: 30, pair: "1.2", own: true });
});

test("a view that follows a list hears of what joins it", () => {
  const seen = [];
  const update = next.following(({ parts }) => parts, ({ parts }) => seen.push(parts.join("")));
  for (const parts of [["a"], ["a"], ["a", "b"], ["a"]]) update({ parts });
  assert.deepEqual(seen, ["a", "ab", "a"]);
});
