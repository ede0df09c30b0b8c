import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { Problem } from "../../static/lib/api.js";
import { DIAMETER, setDiameters } from "../../static/lib/units.js";
import { LANGUAGES, message } from "../../static/messages/index.js";
import { explained, problemText, reasonText, refusalTexts, warningText } from "../../static/service_texts.js";
import { english, useLanguage } from "./service.mjs";

afterEach(() => useLanguage("en"));

const TITLES = new Map([
  ["pins", "Number of pins"], ["crank_angles_deg", "Crank angles"],
  ["pin_radius_mm", "Pin radius"], ["crank_angle_deg", "Crank angle"], ["ratio", "Ratio"],
]);
const refusalOf = (...errors) => new Problem({ status: 422, detail: "as a program reads it", errors });
const least = (pointer, limit = 1) => ({ pointer, code: "greater_than_equal", params: { limit }, detail: `must be at least ${limit}` });

test("a refusal of a field on the screen goes to its box", () => {
  const shown = [{ path: "mechanism.pins", kind: "integer" }];
  const { at, elsewhere } = refusalTexts(refusalOf(least("/mechanism/pins")), shown, TITLES);
  assert.deepEqual(at, { "mechanism.pins": { words: "Must be at least 1" } });
  assert.deepEqual(elsewhere, []);
});

test("a refusal of what is no box yet names it at the box that it lies in, and says where it is entered", () => {
  const shown = [{ path: "contact.hole_material", name: "hole_material", kind: "option", title: "Hole material" }];
  const lacks = { pointer: "/contact/hole_material/poissons_ratio", code: "not_sourced", params: { material: "plastic_petg_printed" }, detail: "" };
  assert.deepEqual(refusalTexts(refusalOf(lacks), shown, TITLES).at["contact.hole_material"], {
    words: "“Poisson's ratio”: is needed beside the name: no source has that of PETG, printed",
    ask: "contact.hole_material.poissons_ratio", code: "not_sourced",
  });
});

test("another field has the title that it has beside the one that is refused", () => {
  const named = (path, title) => ({ path, name: path.split(".").at(-1), kind: "number", title });
  const shown = [named("rollers.bore_diameter_mm", "Bore"), named("rollers.name", "Bearing"), named("contact.pin_material.name", "Otherwise as")];
  const error = { pointer: "/rollers/bore_diameter_mm", code: "needed", params: { field: "name" }, detail: "" };
  const { at } = refusalTexts(refusalOf(error), shown, new Map([["name", "Otherwise as"]]));
  assert.equal(at["rollers.bore_diameter_mm"].words, "Is needed: this or “Bearing”");
});

test("where radii are shown as diameters, limits are said to be of the radius", () => {
  setDiameters(true);
  const shown = [
    { path: "pin_radius_mm", name: "pin_radius_mm", kind: "number", title: "Pin diameter", unit: DIAMETER },
    { path: "eccentricity_mm", name: "eccentricity_mm", kind: "number", title: "Eccentricity", unit: "mm" },
  ];
  const beyond = { pointer: "/eccentricity_mm", code: "smaller_than", params: { field: "pin_radius_mm", limit: 3 }, detail: "" };
  const { at } = refusalTexts(refusalOf(least("/pin_radius_mm", 0.5), beyond), shown, new Map([["pin_radius_mm", "Pin diameter"]]));
  setDiameters(false);
  assert.equal(at.pin_radius_mm.words, "Must be at least 0.5\u00a0mm (on the radius)");
  assert.equal(at.eccentricity_mm.words, "Must be smaller than “Pin diameter”, 3\u00a0mm (on the radius)");
});

test("a refusal of other fields is a sentence with their titles", () => {
  const refusal = refusalOf(
    { pointer: "/mechanism/pins", code: "too_many_pairs", params: { limit: 80, satellites: 3 }, detail: "" },
    { pointer: "/crank_angles_deg/3", code: "finite_number", params: {}, detail: "" },
    { pointer: "/rollers/1/pins", code: "float_type", params: {}, detail: "" },
    { pointer: "/a~0b~1c", code: "extra_forbidden", params: {}, detail: "" },
    { pointer: "", code: "dict_type", params: {}, detail: "" },
  );
  assert.equal(problemText(refusal, TITLES), [
    "Number of pins: must be at most 80, with 3 satellites",
    "Crank angles: must be a finite number",
    "Row 2, Number of pins: Must be a number",
    "a~b/c: is not a known field",
    "Must be an object",
  ].join("; "));
});

test("limits get the unit of their field, other fields their titles", () => {
  const refusal = refusalOf(
    least("/pin_radius_mm", 0.5), { pointer: "/x", code: "larger_than", params: { field: "pin_radius_mm", limit: 3 }, detail: "" },
  );
  assert.equal(problemText(refusal, TITLES), "Pin radius: must be at least 0.5\u00a0mm; x: must be larger than “Pin radius”, 3");
});

test("a mechanism that cannot work is a sentence with its place", async () => {
  const refusal = new Problem({
    status: 422, where: { crank_angle_deg: 85.714285714 },
    errors: [{ pointer: "", code: "dead_centre", params: { crank_angle_deg: 85.714285714 }, detail: "no pair drives" }],
  });
  const text = "The mechanism cannot transmit torque (RV drives, whose output two or three crankshafts turn, are not calculated): "
    + "no pair drives (crank angle = 85.71°)";
  assert.equal(problemText(refusal, TITLES), text);
  assert.deepEqual(refusalTexts(refusal, [], TITLES), { at: {}, elsewhere: [text] });
  await useLanguage("uk");
  assert.match(problemText(refusal, TITLES), /^Мертве положення.*85,71°\)$/);
});

test("every place of a refusal is said in words, in every language, whether or not the page has such a field", async () => {
  const places = Object.keys(english.places);
  assert.ok(places.includes("roller") && places.includes("z_mm"));
  for (const language of Object.keys(LANGUAGES)) {
    await useLanguage(language);
    for (const code of Object.keys(english.refusals)) {
      const where = Object.fromEntries(places.map((name) => [name, 1]));
      const refusal = new Problem({ status: 422, where, errors: [{ pointer: "", code, params: {}, detail: "" }] });
      const text = problemText(refusal, new Map()).replace(/\{\w+\}/g, ""); // parameters, of which there are none
      assert.doesNotMatch(text, /\w+_\w+/, `${language} ${code}: ${text}`);
      if (language !== "en") assert.doesNotMatch(text, /[a-z]{3,} =/, text);
    }
  }
});

test("every refusal, warning and reason has words in every language, with all its places filled", async () => {
  for (const language of Object.keys(LANGUAGES)) {
    await useLanguage(language);
    const { refusals, notices, reasons, checks } = english;
    const warnings = { ...notices, ...Object.fromEntries(Object.entries(checks).flatMap(([code, { warning }]) => (warning ? [[code, warning]] : []))) };
    for (const [table, say] of [
      [{ ...refusals, dead_centre: checks.dead_centre.refusal }, (one) => problemText(refusalOf({ ...one, pointer: "" }), TITLES)],
      [warnings, (one) => warningText(one, TITLES)],
      [{ ...reasons, ...refusals, ...warnings }, (one) => reasonText(one, TITLES)],
    ]) {
      for (const [code, text] of Object.entries(table).map(([code, words]) => [code, words.text ?? words])) {
        const params = Object.fromEntries([...text.matchAll(/\{(\w+)\}/g)].map(([, name]) =>
          [name, ["field", "other"].includes(name) ? "ratio" : name === "names" || name === "section" || name === "error" || name === "expected" ? "x" : 2.5]));
        const words = say({ code, params, detail: "" });
        assert.ok(words.length > 5 && !/[{}]|undefined/.test(words), `${language} ${code}: ${words}`);
        if (language !== "en") assert.doesNotMatch(words.replaceAll("Ratio", ""), /2\.5/);
      }
    }
  }
});

test("a code without words is said as its answer does", () => {
  assert.equal(warningText({ code: "new_one", params: { limit: 1.5 }, detail: "must be < 1.5" }, TITLES), "Must be < 1.5");
});

test("a code is said by its old name where the new one is not known, and explained whatever it is of", () => {
  const told = { code: "a_newer_name", was: "short_pin", params: {}, detail: "in English" };
  assert.equal(warningText(told, TITLES), english.notices.short_pin.text);
  assert.equal(explained("short_pin").mend, english.notices.short_pin.mend);
  assert.equal(explained("wall_holes").mend, english.checks.wall_holes.warning.mend);
  assert.equal(explained("pin_static"), undefined);
});

test("a material of the table is said by its title", async () => {
  await useLanguage("uk");
  const told = { code: "one_source", params: { material: "plastic_pla_printed" }, detail: "" };
  assert.match(warningText(told, TITLES), /матеріалу PLA, друк —/);
  await useLanguage("en");
});

test("a reason that is about a field says its title", () => {
  const reason = { code: "too_many_pairs", pointer: "/mechanism/pins", params: { limit: 50, satellites: 2 }, detail: "" };
  assert.equal(reasonText(reason, TITLES), "Number of pins: must be at most 50, with 2 satellites");
  assert.equal(reasonText({ code: "steep_mesh", params: {}, detail: "" }, TITLES), english.notices.steep_mesh.text);
});

test("what is no refusal of a field says what it says", async () => {
  assert.equal(problemText(new Error("Plotly failed"), TITLES), "Plotly failed");
  assert.equal(problemText(new Problem({ status: 500, title: "failed" }), TITLES), "Failed");
  assert.equal(problemText(new Problem({ title: "unreachable" }), TITLES), message("page.unreachable"));
  await useLanguage("uk");
  const busy = new Problem({ status: 503, kind: "unavailable", detail: "busy" });
  const long = new Problem({ status: 503, kind: "too-long", detail: "not within 10 s" });
  assert.match(problemText(busy, TITLES), /^Сервіс зайнятий/);
  assert.match(problemText(long, TITLES), /довше, ніж дозволяє сервіс/);
  assert.deepEqual([busy.passing, long.passing], [true, false]); // the same would take as long again
});
