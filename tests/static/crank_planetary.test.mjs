import assert from "node:assert/strict";
import { test } from "node:test";

import { flatValues } from "../../static/lib/exports.js";
import calculator from "../../static/calculators/crank-planetary/index.js";
import { listedOf } from "../../static/lib/checks.js";
import { LANGUAGES, quantityTitle } from "../../static/messages/index.js";
import { codesOf, warningsOf } from "../../static/lib/verdict.js";

const ACCURACY = { method: "closed form", relative_error: 1e-15, evaluations: 1, run_time_us: 10 };
const CYCLOGRAM = {
  min_driving: 2, max_driving: 4, mean_driving: 3, dead_centres_deg: [], accuracy: ACCURACY,
  pairs: [1, 2].flatMap((satellite) => [1, 2, 3].map((pin) => ({ satellite, pin, driving_deg: [] }))),
};

/** The body that the calculator posts. */
function asked(input, sections, tables = new Set()) {
  return calculator.ask({ post: (path, body) => body, input, filled: input, sections, tables });
}

test("only what is shown is asked, and nothing of what a refused section needs", async () => {
  const input = { mechanism: { pins: 3 }, load: { output_torque_Nm: 1 }, contact: { pin_radius_mm: 1 } };
  assert.deepEqual(await asked(input, ["cyclogram"]), { mechanism: { pins: 3 }, include: ["cyclogram", "checks"] });
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

test("the cells say the numbers, and what has not been computed", () => {
  const hertz = { governing_pressure_MPa: 548.6, safety_factor: 1.4, accuracy: ACCURACY };
  const [peak, pairs, pressure] = calculator.verdict({ hertz, cyclogram: CYCLOGRAM }, { input: { requirements: { pitting_safety: 1.2 } } });
  assert.equal(peak.value, undefined);
  assert.equal(pairs.value, "2–4");
  assert.match(pairs.note, /of 6 pairs, mean 3/);
  assert.deepEqual([pressure.value, pressure.note, pressure.level], ["548.6", "safety 1.4; 1.2 asked", undefined]);
  assert.ok(calculator.verdict({}).every(({ label, value, note }) => label && value === undefined && note === undefined));
});

test("with real forces the pairs are those that are loaded", () => {
  const real = { loaded_pairs_min: 1, loaded_pairs_max: 3, peak_force_N: 9, peak_crank_angle_deg: 0, peak_pair: {}, accuracy: ACCURACY };
  const answer = { cyclogram: CYCLOGRAM, load_sharing: real, contact_force: { peak_force_N: 8 } };
  const [peak, pairs] = calculator.verdict(answer, { input: {} });
  assert.deepEqual([peak.label, peak.value], ["Real peak force", "9"]);
  assert.deepEqual([pairs.label, pairs.value, pairs.note], ["Pairs loaded at once", "1–3", "of 6 pairs loaded; ideally 2–4"]);
  assert.match(calculator.sentences(answer)[0][1], /1 to 3 of 6 pairs are loaded/);
  const dead = { ...answer, cyclogram: { ...CYCLOGRAM, dead_centres_deg: [10] } };
  assert.equal(calculator.verdict(dead, { input: {} })[1].level, "bad");
});

test("the peak force is said to be without the load factors, and with them", () => {
  const force = { peak_force_N: 1000, peak_crank_angle_deg: 30, peak_pair: { satellite: 1, pin: 2 }, equal_sharing_peak_N: 500, accuracy: ACCURACY };
  const said = (contact, hertz = {}) => {
    const answer = { contact_force: force, hertz };
    const input = { contact, load: { application_factor: contact.factor } };
    const [peak] = calculator.verdict({ contact_force: force }, { input });
    return [peak.note, ...calculator.sentences(answer, { input }).filter(Boolean).slice(1).map(([, words]) => words)];
  };
  assert.deepEqual(said({ factor: 1.5, distribution_factor: 1.2 }), [
    "at 30°, satellite 1, pin 2; without the load factors, × 1.8",
    "The contact pressure is that of 1800\u00a0N: the peak force times application factor and load-sharing factor, 1.8.",
  ]);
  assert.deepEqual(said({}), ["at 30°, satellite 1, pin 2"]);
  const bent = { line_load_factor: 2 };
  assert.match(said({ factor: 1.5 }, bent)[1], /that of 3000\u00a0N spread evenly .* factor, 1.5, and times 2 for bent pins/);
  assert.match(said({}, bent)[1], /that of 2000\u00a0N spread/);
});

test("no part of the page gets the safety of what cannot be built", async () => {
  const ask = (checks) => calculator.ask({
    post: async () => ({ hertz: { governing_pressure_MPa: 548.6, safety_factor: 1.4, safety: [] }, checks }),
    input: {}, filled: { mechanism: { pins: 6, satellites: 2 } }, sections: calculator.sections, tables: new Set(),
  });
  assert.deepEqual((await ask([{ impossible: true }])).hertz, { governing_pressure_MPa: 548.6 });
  assert.equal((await ask([{ status: "fail" }])).hertz.safety_factor, 1.4);
});

test("a small clearance and an interference are said at the hole", () => {
  const { note } = calculator.suggestions["contact.hole_radius_mm"];
  const at = (hole) => note({ contact: { pin_radius_mm: 6, hole_radius_mm: hole, eccentricity_mm: 2 } });
  assert.deepEqual([at(8), at(8.03), at(7.97)], ["", "radial clearance 0.03\u00a0mm", "too small by 0.03\u00a0mm"]);
});

test("a notice that stands at the answer and at its section is one, and the file of results has it", () => {
  const twice = { code: "clearance", detail: "The hole" };
  const answer = { geometry: { warnings: [twice] }, warnings: [twice, { code: "pins_apart", detail: "Pins" }] };
  assert.deepEqual(warningsOf(answer).map(({ code }) => code), ["clearance", "pins_apart"]);
  assert.deepEqual(flatValues({}, answer).map(({ section, name, value }) => [section, name, value]), [
    ["warnings", "clearance", "The hole"], ["warnings", "pins_apart", "Pins"],
  ]);
});

test("what is explained is warned of, or is why a check is not kept", () => {
  const checks = [
    { code: "pins_apart", impossible: true }, { code: "wall_holes" }, { code: "pin_fatigue", reason: { code: "notch_unknown" } },
    { code: "interference", impossible: true, reason: { code: "jams" } },
  ];
  const answer = { warnings: [{ code: "short_pin", detail: "" }], hertz: { warnings: [{ code: "short_pin", detail: "" }] } };
  assert.deepEqual(codesOf(answer, checks), ["short_pin", "pins_apart", "notch_unknown", "jams"]);
  assert.deepEqual(codesOf({}), []);
});

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
  const known = { output_efficiency: { total_efficiency: 0.80004 } };
  assert.deepEqual(calculator.seeds["torque.input"](input, known), { "load.efficiency": 0.8, "load.input_torque_Nm": 3.125 });
  const ofRing = { ...input, mechanism: { ...input.mechanism, output: "ring" } };
  assert.equal(calculator.seeds["torque.input"](ofRing, known)["load.input_torque_Nm"], 2.97619);
});

test("the sizes that the theory gives", () => {
  const { value: hole } = calculator.suggestions["contact.hole_radius_mm"];
  assert.equal(hole({ contact: { pin_radius_mm: 5, eccentricity_mm: 1.1 } }), 6.1);
  assert.ok(!Number.isFinite(hole({ contact: { pin_radius_mm: 5 } })));
  assert.ok(!Number.isFinite(hole({})));
  assert.equal(calculator.suggestions["mechanism.crank_spacing_deg"].value({ mechanism: { satellites: 4 } }), 90);
});

test("the pressure's figure is of the force that the pressure is judged under: the peak, or the real one", () => {
  const { body } = calculator.figures.find(({ id }) => id === "hertz");
  const contact = { contact_length_mm: 10, eccentricity_mm: 2 }, load = { application_factor: 1.5 };
  const ideal = { contact_force: { peak_force_N: 1000 }, hertz: {} };
  assert.deepEqual(body({ contact, load }, ideal), { contact_length_mm: 10, dynamic_factor: 1.5, force_N: 1000 });
  const real = body({ contact, load }, { ...ideal, load_sharing: { judged_force_N: 2370 } });
  assert.deepEqual(real, { contact_length_mm: 10, dynamic_factor: 1, distribution_factor: 1, force_N: 2370 });
});

test("in words the most loaded pair carries its force as made, and the ideal one is said to be ideal", () => {
  const section = { min_driving: 3, max_driving: 3, mean_driving: 3, dead_centres_deg: [], pairs: [] };
  const force = { peak_force_N: 2963, equal_sharing_peak_N: 2577 };
  const words = (real) => calculator.sentences({ cyclogram: section, contact_force: force, ...(real && { load_sharing: { peak_force_N: real } }) })
    .filter(Boolean).map(([, text]) => text).slice(1);
  assert.deepEqual(words(), ["The most loaded pair carries 2963\u00a0N, 1.15 times the peak with equal sharing among the driving pairs."]);
  assert.match(words(7683)[0], /^Really the most loaded pair carries 7683.N; ideally, .* it would carry 2963.N\.$/);
});

test("the direction of the torque goes with ideal forces too, to every section that it matters for", async () => {
  const input = {
    mechanism: { pins: 6 }, load: { output_torque_Nm: 100, torque_direction: "alternating" }, contact: { eccentricity_mm: 2 },
  };
  assert.equal((await asked(input, calculator.sections)).load.torque_direction, "alternating");
  const [ideal] = calculator.figures.filter(({ measures }) => measures === "contact-force").map(({ body }) => body(input));
  assert.ok(!("torque_direction" in ideal));
});

test("no two forces have one name: the ideal ones, the real ones, those with the factor, in every language", async () => {
  const names = ["peak_force_N", "peak_force_ratio", "peak_crank_angle_deg", "peak_pair", "max_pressure_MPa"];
  for (const language of Object.keys(LANGUAGES)) {
    const { default: { quantity } } = await import(`../../static/messages/${language}.json`, { with: { type: "json" } });
    const title = (section, name) => quantity[`${section}.${name}`] ?? quantity[name];
    for (const name of names) assert.notEqual(title("load_sharing", name), title("contact_force", name), `${language}: ${name}`);
    const peaks = ["contact_force", "load_sharing", "pin_strength", "output_efficiency"].map((section) => title(section, "peak_force_N"));
    assert.equal(new Set([...peaks, title("load_sharing", "judged_force_N")]).size, peaks.length + 1);
  }
});

test("solved forces are listed, and stand beside the ideal ones of other designs", () => {
  assert.deepEqual(listedOf(calculator, [{ contact_force: {} }, null]), calculator.sections);
  assert.deepEqual(listedOf(calculator, [null, { load_sharing: {} }]), ["load_sharing", ...calculator.sections]);
  assert.equal(quantityTitle("loaded_pairs_max", "load_sharing"), "Most pairs loaded");
});

const [cyclogramFigure, forceFigure] = ["cyclogram", "force"].map((one) => calculator.figures.find(({ id }) => id === one));

test("figures are of the document by which the numbers were asked; before these, of what the form says", () => {
  const input = { mechanism: { pins: 3, revolutions: 2 }, load: { torque_direction: "reverse" }, contact: { pin_radius_mm: 5 }, besides: { real: { on: "on" } } };
  const asked = { mechanism: { pins: 3 }, load: { torque_direction: "reverse" } };
  for (const [figure, section] of [[cyclogramFigure, "cyclogram"], [forceFigure, "contact_force"]]) {
    const { path, body } = figure;
    assert.equal(path, "/crank-planetary/chart");
    assert.ok(body.length < 2); // it is asked for beside the first answer
    const { besides, ...parts } = input;
    assert.deepEqual(body(input), { ...parts, contact_law: {}, include: [section] });
    assert.deepEqual(body(input, {}, [{ body: { ...asked, include: ["checks", "hertz"] } }]), { ...asked, include: [section] });
    assert.throws(() => body(input, {}, [{ body: { mechanism: { pins: 300 } } }]), { status: 422 });
  }
});

test("tables are of the forces that are solved, and these are asked for only where the table is", async () => {
  const input = { mechanism: { pins: 3 }, load: {}, contact: { pin_radius_mm: 1, hole_clearance_mm: 0.02 } };
  assert.ok(!(await asked(input, calculator.sections)).include.includes("real_cyclogram"));
  assert.ok((await asked(input, calculator.sections, new Set(["cyclogram"]))).include.includes("real_cyclogram"));
  const perfect = { ...input, contact: { pin_radius_mm: 1 } };
  assert.ok(!(await asked(perfect, calculator.sections, new Set(["cyclogram"]))).include.includes("real_cyclogram"));

  const cyclogram = { pairs: [{ satellite: 1, pin: 1, driving_deg: [[0, 170]] }], driving_count: [{ from_deg: 0, to_deg: 360, pairs: 4 }] };
  const real = { pairs: [{ satellite: 1, pin: 1, loaded_deg: [[20, 90]] }], loaded_count: [{ from_deg: 0, to_deg: 360, pairs: 2 }] };
  assert.deepEqual(cyclogramFigure.tables({ cyclogram }).map(({ title, rows }) => [title, rows[0]]), [["Driving phases", [1, 1, 0, 170]], ["Number of pairs driving", [0, 360, 4]]]);
  assert.deepEqual(cyclogramFigure.tables({ cyclogram, real_cyclogram: real }).map(({ title, rows }) => [title, rows[0]]), [
    ["Phases in which pairs really carry", [1, 1, 20, 90]], ["Number of pairs that really carry", [0, 360, 2]],
  ]);
  const curves = (force) => ({ curves: { crank_angle_deg: [0], pairs: [{ satellite: 1, pin: 1 }], force_N: [[force]] }, peak_crank_angle_deg: force });
  const answer = { contact_force: curves(5), load_sharing: curves(9) };
  const [table] = forceFigure.tables(answer);
  assert.deepEqual([table.title, table.rows], ["Real force of each pair", [[0, 9]]]);
  assert.deepEqual(calculator.drawing.curves(answer), [{ name: "1.1", x: [0], y: [9] }]);
  assert.equal(calculator.drawing.start(answer), 9);
});

test("what the input needs stands beside what is typed there", () => {
  const losses = { efficiency: 0.9, total_efficiency: 0.736, input_torque_Nm: 0.5434, accuracy: { relative_error: 1e-9 } };
  const cellOf = (answer, input) => calculator.verdict(answer, { input })[3];
  assert.equal(cellOf({}, {}), undefined);
  const { value, note, level } = cellOf({ output_efficiency: losses }, {});
  assert.deepEqual([value, note, level], ["0.5434\u00a0N·m", "efficiency 0.736, pins and teeth only", false]);
  const ofPins = { ...losses, efficiency: 0.736 };
  assert.equal(cellOf({ output_efficiency: ofPins }, {}).note, "efficiency 0.736, pins only");
  const typed = { load: { input_torque_Nm: 0.4, efficiency: 1 } };
  const more = cellOf({ output_efficiency: losses }, typed);
  assert.deepEqual([more.note, more.level], ["more than the 0.4\u00a0N·m typed; efficiency 0.736, pins and teeth only", "warning"]);
  assert.deepEqual(cellOf({}, typed), { label: "Needed at the input", value: "0.4\u00a0N·m", note: "as typed, efficiency 1; losses are not known" });
  assert.equal(cellOf({ output_efficiency: { efficiency: 0.9 } }, {}), undefined);
});

test("the mass stands beside the other numbers once it is known", () => {
  assert.equal(calculator.verdict({ mass: { parts: [] } }).length, 3);
  assert.equal(calculator.verdict({ mass: { mass_kg: 3.21456, parts: [] } }).at(-1).value, "3.215\u00a0kg");
});
