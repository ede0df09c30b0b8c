import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { flatValues } from "../../static/lib/exports.js";
import calculator from "../../static/calculators/crank-planetary/index.js";
import { useLanguage } from "../../static/messages/index.js";
import { warningsOf } from "../../static/lib/verdict.js";
import { NARROW } from "../../static/calculators/crank-planetary/judgement.js";
import { sentences as sentencesOf } from "../../static/calculators/crank-planetary/sentences.js";

const ACCURACY = { method: "closed form", relative_error: 1e-15, evaluations: 1, run_time_us: 10 };
const CYCLOGRAM = {
  min_driving: 2, max_driving: 4, mean_driving: 3, dead_centres_deg: [], accuracy: ACCURACY,
  pairs: [1, 2].flatMap((satellite) => [1, 2, 3].map((pin) => ({ satellite, pin, driving_deg: [] }))),
};
const { materials } = JSON.parse(readFileSync(new URL("worked_examples.json", import.meta.url)));
const materialOf = (path, given) =>
  (typeof given === "string" ? materials.find(({ name }) => name === given) : given);
const DEFAULT = { pin_material: "steel_bearing", hole_material: "steel_through_hardened" };

/** A design under a pressure as the service answers it: each body by its own limit. */
function judgedDesign(pressure, { bodies = DEFAULT, hertz = {}, warnings, sizes = {} } = {}) {
  const contact = { pin_radius_mm: 8, hole_radius_mm: 10, eccentricity_mm: 2, ...sizes, ...bodies };
  const safety = ["pin", "hole"].flatMap((body) => {
    const limit = materialOf("", contact[`${body}_material`]).allowable_pressure_MPa;
    return limit === undefined ? [] : [{ body, limit_MPa: limit, criterion: "endurance", safety_factor: limit / pressure }];
  });
  const answer = {
    hertz: {
      max_pressure_MPa: pressure, governing_pressure_MPa: pressure, half_width_ratio: 0.03,
      ...(safety.length > 0 && { safety }),
      ...(safety.length === 2 && { safety_factor: Math.min(...safety.map((one) => one.safety_factor)) }),
      accuracy: ACCURACY, ...hertz,
    },
    ...(warnings && { warnings: warnings.map((code) => ({ code, detail: code })) }),
  };
  const context = { input: { contact }, materialOf };
  const cells = calculator.verdict(answer, context);
  return {
    answer,
    context,
    cells,
    pressure: cells[2],
    wanted: calculator.wanted(answer, context),
    impossible: calculator.impossible(answer, context),
    sentences: sentencesOf(answer, context).filter(Boolean),
  };
}

/** The body that the calculator posts. */
function asked(input, sections, tables = new Set()) {
  return calculator.ask({ post: (path, body) => body, input, filled: input, sections, tables });
}

test("only what is shown is asked, and nothing of what a refused section needs", async () => {
  const input = { mechanism: { pins: 3 }, load: { output_torque_Nm: 1 }, contact: { pin_radius_mm: 1 } };
  assert.deepEqual(await asked(input, ["cyclogram"]), { mechanism: { pins: 3 }, include: ["cyclogram"] });
  const all = await asked(input, calculator.sections);
  assert.deepEqual(all.contact, input.contact);
  assert.ok(!all.load.include.includes("curves"));
  const tabled = await asked(input, calculator.sections, new Set(["force"]));
  assert.ok(tabled.load.include.includes("curves"));
});

test("the approximation is asked for only in its range", async () => {
  for (const [pins, satellites, wanted] of [[3, 1, true], [5, 2, true], [6, 1, false], [4, 3, false]]) {
    const input = { mechanism: { pins, satellites }, load: {}, contact: {} };
    assert.equal((await asked(input, calculator.sections)).load.include.includes("approximation"), wanted);
  }
});

test("the verdict says over the limit in words, and what has not been computed", () => {
  const { answer, context } = judgedDesign(1533.8);
  const [peak, pairs, pressure] = calculator.verdict({ ...answer, cyclogram: CYCLOGRAM }, context);
  assert.equal(peak.value, undefined);
  assert.equal(pairs.value, "2–4");
  assert.match(pairs.note, /of 6 pairs, mean 3/);
  assert.equal(pressure.level, "bad");
  assert.match(pressure.note, /Hole over its limit, 581\.9\sMPa; safety 0\.379$/);
  assert.ok(calculator.verdict({}).every(({ label, value, note }) => label && value === undefined && note === undefined));
});

test("every material is judged by its own limit, or not at all", () => {
  for (const body of ["pin", "hole"]) {
    for (const { name, title, allowable_pressure_MPa: limit } of materials) {
      const { pressure, sentences, wanted } = judgedDesign(91.36, { bodies: { ...DEFAULT, [`${body}_material`]: name } });
      const said = [pressure.note, ...sentences.map(([, text]) => text)].join("\n");
      if (limit !== undefined) {
        assert.equal(pressure.level, "good");
        assert.match(pressure.note, / within (its|their) limit, .*; safety [\d.]+$/);
        assert.deepEqual(wanted, []);
        continue;
      }
      assert.equal(pressure.level, "warning", name);
      assert.equal(pressure.value, "91.36");
      assert.equal(pressure.note, `no limit known for the ${body}: ${title}`);
      assert.deepEqual(wanted, [`No limit is known for the ${body}, ${title}: enter one.`]);
      assert.doesNotMatch(said, /safety|torque/i);
      assert.deepEqual(sentences.map(([level]) => level), ["warning", ""]);
      const other = body === "pin" ? "hole" : "pin";
      assert.match(sentences[1][1], new RegExp(`Only the limit of the ${other} is known: .* says nothing of the ${body}`));
    }
  }
});

test("no limit of either, and values of one's own without one", () => {
  const own = { youngs_modulus_GPa: 3, poissons_ratio: 0.35 };
  const { pressure, sentences, wanted } = judgedDesign(50, { bodies: { pin_material: own, hole_material: "brass" } });
  assert.equal(pressure.level, "warning");
  assert.match(pressure.note, /^no limit known for the pin: own values; for the hole: Brass/);
  assert.equal(wanted.length, 2);
  assert.deepEqual(sentences.map(([level]) => level), ["warning"]);
});

test("a body over its own limit fails, whatever is known of the other", () => {
  const { pressure, sentences } = judgedDesign(2329, { bodies: { ...DEFAULT, hole_material: "iron_grey" } });
  assert.equal(pressure.level, "bad");
  assert.match(pressure.note, /^Pin over its limit, 1500\sMPa; no limit known for the hole: Grey/);
  assert.deepEqual(sentences.map(([level]) => level), ["bad", "warning"]);
  assert.doesNotMatch(sentences.flat().join(), /safety|torque/);
});

test("the body that governs is named, and both where they are alike", () => {
  assert.match(judgedDesign(548.6).sentences[0][1], /548\.6\sMPa\. The hole governs: 581\.9\sMPa allowed, safety 1\.06\./);
  const both = { pin_material: "steel_bearing", hole_material: "steel_bearing" };
  assert.match(judgedDesign(1000, { bodies: both }).sentences[0][1], /Pin and hole govern alike: 1500\sMPa allowed, safety 1\.5\./);
  const soft = { pin_material: "bronze_tin_centrifugal", hole_material: "steel_case_hardened" };
  assert.match(judgedDesign(500, { bodies: soft }).pressure.note, /^Pin over its limit, 425/);
});

test("the torque grows by the square of the safety only where Hertz governs from here to the limit", () => {
  const same = { pin_material: "steel_case_hardened", hole_material: "steel_case_hardened" };
  const grown = (pressure, hertz) => judgedDesign(pressure, { bodies: same, hertz }).sentences.map(([, text]) => text).join("\n");
  assert.match(grown(750, {}), /torque may grow to 4 times/);
  assert.match(grown(3000, {}), /With 0\.25 times the torque/);
  assert.doesNotMatch(grown(150, { half_width_ratio: 0.1 }), /torque/); // at the limit it is a/r = 1
  for (const [hertz, governing] of [[182.5, 201.1], [316.1, 406.1], [816.1, 1923]]) {
    const { pressure, sentences } = judgedDesign(governing, {
      bodies: same, hertz: { max_pressure_MPa: hertz, conformal_pressure_MPa: governing, half_width_ratio: 0.5 },
    });
    const sentence = sentences[0][1];
    assert.equal(pressure.value, String(governing));
    for (const text of [pressure.note, sentence]) assert.match(text, /1500\sMPa/);
    assert.ok(sentence.includes(`${governing}\u00a0MPa`), sentence);
    assert.deepEqual([pressure.level, sentences[0][0]], Array(2).fill(governing < 1500 ? "good" : "bad"));
    assert.doesNotMatch(sentences.flat().join(), /torque/);
  }
  const core = readFileSync(new URL("../../core/hertz.py", import.meta.url), "utf8");
  assert.match(core, new RegExp(`^HALF_WIDTH_RATIO_LIMIT = ${NARROW}$`, "m"));
});

test("a clearance, which the force does not count, leaves no tick and no larger torque", () => {
  const { pressure, sentences } = judgedDesign(548.6, { warnings: ["clearance"] });
  assert.equal(pressure.level, "warning");
  assert.match(pressure.note, /safety 1\.06; clearance not counted$/);
  assert.deepEqual(sentences.map(([level]) => level), ["warning"]);
  assert.match(sentences[0][1], /fewer pairs carry more/);
});

test("a pressure beyond its theory gets no tick, and where there is none nothing is judged", () => {
  const wide = judgedDesign(300, { hertz: { half_width_ratio: 0.3 } });
  assert.deepEqual([wide.pressure.level, wide.sentences[0][0], wide.sentences.length], ["warning", "warning", 1]);
  const none = judgedDesign(300, { hertz: { half_width_ratio: 1.2, governing_pressure_MPa: undefined, safety: undefined, safety_factor: undefined } });
  assert.deepEqual([none.pressure.level, none.pressure.value], ["warning", undefined]);
  assert.match(none.pressure.note, /no theory/);
  assert.deepEqual(none.wanted, []);
});

test("what cannot be built is red with the reason, and nothing beside it is good", () => {
  for (const [codes, sizes, reason] of [
    [["interference"], { hole_radius_mm: 9.97 }, /^Not possible: hole radius 9\.97\smm, at least 10\smm needed/],
    [["holes_overlap"], {}, /^Not possible: neighbouring holes/],
    [["holes_overlap", "pins_overlap"], {}, /^Not possible: neighbouring holes/],
  ]) {
    const { answer, context, cells, pressure, impossible, sentences } = judgedDesign(548.6, { warnings: codes, sizes });
    assert.deepEqual([pressure.level, pressure.note], ["bad", "Not possible"]);
    assert.ok(cells.every(({ level }) => level !== "good"));
    assert.equal(impossible.length, codes.length);
    assert.match(impossible[0], reason);
    assert.deepEqual(sentences, impossible.map((text) => ["bad", text]));
    const moving = sentencesOf({ ...answer, cyclogram: CYCLOGRAM }, context).filter(Boolean);
    assert.ok(moving.length > sentences.length && moving.every(([level]) => level !== "good"));
  }
  assert.deepEqual(judgedDesign(548.6, { warnings: ["clearance"] }).impossible, []);
});

test("no part of the page gets the safety of what cannot be built", async () => {
  const ask = (warnings) => calculator.ask({
    post: async () => judgedDesign(548.6, { warnings }).answer,
    input: {}, filled: { mechanism: { pins: 6, satellites: 2 } }, sections: calculator.sections, tables: new Set(),
  });
  const { hertz } = await ask(["holes_overlap"]);
  assert.ok(!("safety" in hertz) && !("safety_factor" in hertz) && hertz.governing_pressure_MPa === 548.6);
  assert.ok("safety_factor" in (await ask(["clearance"])).hertz);
});

test("a notice that stands at the answer and at its section is one, and the file of results has it", () => {
  const twice = { code: "clearance", detail: "The hole" };
  const answer = { geometry: { warnings: [twice] }, warnings: [twice, { code: "pins_overlap", detail: "Pins" }] };
  assert.deepEqual(warningsOf(answer).map(({ code }) => code), ["clearance", "pins_overlap"]);
  assert.deepEqual(flatValues(answer).map(({ section, name, value }) => [section, name, value]), [
    ["warnings", "clearance", "The hole"], ["warnings", "pins_overlap", "Pins"],
  ]);
});

for (const [language, level, unknown] of [["uk", "Отвір: нижче межі", "невідом"], ["ru", "Отверстие: ниже предела", "неизвестн"]]) {
  test(`${language}: the judgement in its words`, async () => {
    await useLanguage(language);
    try {
      assert.match(judgedDesign(500).pressure.note, new RegExp(`^${level}`));
      const { pressure, sentences, wanted } = judgedDesign(91, { bodies: { ...DEFAULT, hole_material: "plastic_pom" } });
      for (const text of [pressure.note, sentences[0][1], wanted[0]]) assert.match(text, new RegExp(unknown));
      assert.doesNotMatch([pressure.note, ...wanted, ...sentences.map(([, text]) => text)].join(), /[a-z]{4,}|\{/);
    } finally {
      await useLanguage("en");
    }
  });
}

test("a dead centre is named with its places, never passed over", () => {
  const dead = { ...CYCLOGRAM, min_driving: 0, dead_centres_deg: [90, 180, 270, 360] };
  const [, pairs] = calculator.verdict({ cyclogram: dead });
  assert.equal(pairs.level, "bad");
  assert.match(pairs.note, /90°, 180°, 270° …/);
});

test("an option starts from the same design", () => {
  const input = { mechanism: { satellites: 3, ratio: 20 }, load: { output_torque_Nm: 50 } };
  assert.deepEqual(calculator.seeds["cranks.list"](input)["mechanism.crank_angles_deg"], [0, 120, 240]);
  const teeth = calculator.seeds["ratio.teeth"](input);
  const [satellite, ring] = [teeth["mechanism.satellite_teeth"], teeth["mechanism.ring_teeth"]];
  assert.equal(satellite / (ring - satellite), 20);
  assert.deepEqual(calculator.seeds["ratio.teeth"]({ mechanism: { ratio: Math.PI } }), {});
  assert.deepEqual(calculator.seeds["ratio.teeth"]({ mechanism: {} }), {});
  const torque = calculator.seeds["torque.input"](input);
  assert.equal(torque["load.input_torque_Nm"] * 20 * torque["load.efficiency"], 50);
});

test("the sizes that the theory gives", () => {
  const { value: hole } = calculator.suggestions["contact.hole_radius_mm"];
  assert.equal(hole({ contact: { pin_radius_mm: 5, eccentricity_mm: 1.1 } }), 6.1);
  assert.ok(!Number.isFinite(hole({ contact: { pin_radius_mm: 5 } })));
  assert.ok(!Number.isFinite(hole({})));
  assert.equal(calculator.suggestions["mechanism.crank_spacing_deg"].value({ mechanism: { satellites: 4 } }), 90);
});
