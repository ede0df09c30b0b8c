import assert from "node:assert/strict";
import { test } from "node:test";

import { Problem } from "../../static/lib/api.js";
import { message, useLanguage } from "../../static/messages/index.js";
import { problemText, refusalTexts, warningText } from "../../static/service_texts.js";

const TITLES = new Map([
  ["pins", "Number of pins"], ["crank_angles_deg", "Crank angles"],
  ["pin_radius_mm", "Pin radius"], ["crank_angle_deg", "Crank angle"], ["ratio", "Ratio"],
]);
const refusalOf = (...errors) => new Problem({ status: 422, detail: "as a program reads it", errors });

test("a refusal of a field on the screen goes to its box", () => {
  const shown = [{ path: "mechanism.pins", kind: "integer" }];
  const { at, elsewhere } = refusalTexts(
    refusalOf({ pointer: "/mechanism/pins", detail: "must be at least 1" }), shown, TITLES,
  );
  assert.deepEqual(at, { "mechanism.pins": { words: "Must be at least 1" } });
  assert.deepEqual(elsewhere, []);
});

test("a refusal of other fields is a sentence with their titles", () => {
  const refusal = refusalOf(
    { pointer: "/mechanism/pins", detail: "must be at most 80 for 3 satellites to be drawn (240 pairs)" },
    { pointer: "/crank_angles_deg/3", detail: "must be a finite number" },
    { pointer: "/rollers/1/pins", detail: "must be a number" },
    { pointer: "/a~0b~1c", detail: "is not a known field" },
    { pointer: "", detail: "must be an object" },
  );
  assert.equal(problemText(refusal, TITLES), [
    "Number of pins: must be at most 80 for 3 satellites to be drawn (240 pairs)",
    "Crank angles: must be a finite number",
    "Row 2, Number of pins: Must be a number",
    "a~b/c: is not a known field",
    "Must be an object",
  ].join("; "));
});

test("its words are those of the language in use", async () => {
  await useLanguage("uk");
  const refusal = refusalOf({ pointer: "/pins", detail: "must be at most 80 for 3 satellites to be drawn (240 pairs)" });
  assert.equal(problemText(refusal, TITLES), "Number of pins: для рисунка має бути не більше ніж 80 за 3 сателітів (пар: 240)");
  await useLanguage("en");
});

test("what is no refusal of a field says what it says", () => {
  assert.equal(problemText(new Error("Plotly failed"), TITLES), "Plotly failed");
  assert.equal(problemText(new Problem({ status: 500, title: "failed" }), TITLES), "Failed");
  assert.equal(problemText(new Problem({ title: "unreachable" }), TITLES), message("page.unreachable"));
});

test("API names become the titles of the form", () => {
  assert.equal(warningText({ detail: "must be larger than pin_radius_mm" }, TITLES), "Must be larger than pin radius");
});

test("a place gets its unit and the digits that people read", () => {
  assert.equal(
    warningText({ detail: "no pair drives at crank_angle_deg = 85.714285714" }, TITLES),
    "No pair drives at crank angle 85.7143°",
  );
  assert.equal(warningText({ detail: "impossible at ratio = 1e-3" }, TITLES), "Impossible at ratio 0.001");
});

test("what is no field stays as it is, markup too", () => {
  assert.equal(warningText({ detail: "must be < b & not_a_field = 3" }, TITLES), "Must be < b & not_a_field = 3");
});
