import assert from "node:assert/strict";
import { test } from "node:test";

import { inWords } from "../../static/wording.js";

const TITLES = new Map([["pin_radius_mm", "Pin radius"], ["crank_angle_deg", "Crank angle"], ["ratio", "Ratio"]]);

test("API names become the titles of the form", () => {
  assert.equal(inWords("must be larger than pin_radius_mm", TITLES), "Must be larger than pin radius");
});

test("a place gets its unit and the digits that people read", () => {
  assert.equal(
    inWords("no pair drives at crank_angle_deg = 85.714285714", TITLES),
    "No pair drives at crank angle 85.7143°",
  );
  assert.equal(inWords("impossible at ratio = 1e-3", TITLES), "Impossible at ratio 0.001");
});

test("what is no field stays as it is, markup too", () => {
  assert.equal(inWords("must be < b & not_a_field = 3", TITLES), "Must be < b & not_a_field = 3");
});
