import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { formatNumber } from "../../static/lib/format.js";
import { evaluate } from "../../static/lib/formula/evaluate.js";
import { mathml, plainText } from "../../static/lib/formula/mathml.js";
import { parse } from "../../static/lib/formula/notation.js";
import { definition, fromSI, quantity as q } from "../../static/lib/formula/evaluate.js";
import { WANTED } from "../../static/calculators/crank-planetary/wanted.js";
import { ASIDE, flattened } from "../../static/lib/checks.js";
import { message, quantityWords } from "../../static/messages/index.js";
import { filled } from "./model.mjs";

// What the service answers to its examples and some more; kept up by a test of the service.
const { materials, cases } = JSON.parse(readFileSync(new URL("worked_examples.json", import.meta.url)));

const materialOf = (path, given) =>
  (typeof given === "string" ? materials.find(({ name }) => name === given) : given);

async function stepsOf({ calculator, input, answer }) {
  const { workedSteps } = await import(`../../static/calculators/${calculator}/worked.js`);
  const wanted = WANTED.filter(({ id, section }) => section && input.besides?.[id]);
  const more = Object.fromEntries(await Promise.all(wanted.map(async ({ id }) =>
    [id, (await import(`../../static/calculators/crank-planetary/${id}.js`)).steps])));
  return workedSteps({ input: filled(calculator, input), answer, materialOf, more });
}

/** The values as they are written, rounded to their digits. */
function rounded(values) {
  const round = (value) => (Array.isArray(value) ? value.map(round) : Number(value.toPrecision(6)));
  return Object.fromEntries(Object.entries(values)
    .map(([name, one]) => [name, one.formula ? one : { ...one, value: round(one.value) }]));
}

function near(found, wanted, tolerance, words, floor = 1e-3) {
  assert.ok(Math.abs(found - wanted) <= tolerance * Math.max(Math.abs(wanted), floor), `${words}: ${found}, not ${wanted}`);
}

for (const [i, one] of cases.entries()) {
  test(`every step gives what the service answers: ${one.calculator}, case ${i + 1}`, async () => {
    let count = 0;
    for (const { section, steps } of await stepsOf(one)) {
      for (const { name, symbol, formula, values, value, unit } of steps) {
        if (!formula) continue;
        const words = `${section} ${name} ${symbol}`;
        near(fromSI(evaluate(parse(formula), values), unit), value, 1e-9, words);
        near(fromSI(evaluate(parse(formula), rounded(values)), unit), value, 5e-4, `${words}, as written`, unit === "°" ? 1 : undefined);
        count += 1;
      }
    }
    assert.ok(count >= 12, `${count} steps`);
  });

  test(`every result has its step: ${one.calculator}, case ${i + 1}`, async () => {
    const groups = await stepsOf(one);
    const judged = ["verdict", "governing", "torque_reserve", "largest_torque_Nm", "largest_torque_estimated", "counts", "not_considered"];
    const notWorked = ["warnings", "load_sharing", "fit", "assumed", ...judged]; // what is solved over the turn is not worked
    const sections = Object.entries(one.answer).filter(([name]) => !notWorked.includes(name));
    for (const [section, values] of sections) {
      const { steps } = groups.find((group) => group.section === section);
      const worked = new Set(steps.map(({ name }) => name));
      const aside = ["accuracy", "warnings", "lines", "forces_N", "peak_pair", "dead_centres_deg", "assembly", "crank_angle_deg", "forces",
        "slope_B_mrad", "slope_C_mrad", "conformal_error", ...judged];
      const again = section === "meshing_load" ? ["total_length_mm"] : []; // worked with the lines
      const bodies = (values.safety ?? []).map(({ body }) => `safety_${body}`);
      const isList = (value) => Array.isArray(value) && typeof value[0] === "object"; // the steps are of the worst, or of all
      const names = flattened(values).filter(([name, value]) => !isList(value) && !["deflection_satellite", "slope_satellite"].includes(name)).map(([name]) => name);
      for (const name of [...names, ...bodies]) {
        if (![...aside, ...again].includes(name)) assert.ok(worked.has(name), `${section} ${name}`);
      }
    }
  });
}

test("a wrong formula is found", () => {
  const values = { T: q("T", 50, "N·m"), R: q("R", 32.5, "mm") };
  near(evaluate(parse("T/R"), values), 50 / 0.0325, 1e-15, "F_0");
  assert.throws(() => near(evaluate(parse("T*R"), values), 50 / 0.0325, 1e-9, "F_0"));
});

test("notation: precedence, powers to the right, calls, what is wrong", () => {
  const at = (text, values = {}) => evaluate(parse(text), values);
  assert.equal(at("1-2-3"), -4);
  assert.equal(at("2^3^2"), 512);
  assert.equal(at("-2^2"), -4);
  assert.equal(at("8/4/2"), 1);
  assert.equal(at("2*(3+4)"), 14);
  assert.equal(at("min(3;1+1;7)"), 2);
  assert.equal(at("sqrt(abs(-16))"), 4);
  near(at("integral(z^2*k;z;0;3)", { k: q("k", 2) }), 18, 1e-12, "integral");
  const list = { x_i: q("x_i", [1, 2, 3]), y: definition("y", "x_i^2") };
  assert.equal(at("sum(y)", list), 14);
  for (const wrong of ["", "1+", "(1", "1)", "f(1", "*2"]) assert.throws(() => parse(wrong), SyntaxError, wrong);
  assert.throws(() => at("x+1"), RangeError);
});

test("the life of the pins' fatigue is its own where it has one, else that of the requirements", async () => {
  const one = cases.find(({ answer }) => answer.pin_strength?.fatigue?.finite_strength_MPa);
  const { requirements: { life_h }, besides } = one.input;
  const apart = { ...one.input, requirements: { life_h: 100 * life_h }, besides: { ...besides, fatigue: { ...besides.fatigue, life_h } } };
  const stepsFor = async (input) => (await stepsOf({ ...one, input })).find(({ section }) => section === "pin_strength").steps;
  assert.deepEqual(await stepsFor(apart), await stepsFor(one.input));
});

test("formulas are written with symbols and with numbers and units", () => {
  const values = { F_i: q("F_i", [1.5, -2, 3, 4, 5], "N"), d: q("d", 10, "mm"), E: q("E*", 210, "GPa") };
  const written = (text, withNumbers) => plainText(parse(text), { values, withNumbers });
  assert.equal(written("(d+d)*E"), "(d + d) · E*");
  assert.equal(written("d^2", true), "(10 mm)^(2)");
  assert.equal(written("d-(d-E)"), "d − (d − E*)");
  assert.equal(written("2*d/E", true), "(2 · 10 mm) / (210 GPa)");
  assert.equal(written("sum(F_i)", true), "1.5 N + (−2 N) + … + 5 N");
  assert.equal(written("sum(F_i)"), "∑ F i");
  const markup = mathml(parse("sqrt(E/d)"), { values }).toString();
  assert.match(markup, /^<msqrt><mfrac><mrow><msup><mi>E<\/mi><mo>\*<\/mo><\/msup><\/mrow><mrow><mi>d<\/mi>/);
  assert.match(mathml(parse("d"), { values, withNumbers: true }).toString(), /<mn>10<\/mn><mtext>\u202fmm<\/mtext>/);
});

test("a longer sum shows its first two terms and its last", () => {
  const values = { x_i: q("x_i", [1, 2, 3, 4, 5, 6]) };
  assert.equal(plainText(parse("sum(x_i)"), { values, withNumbers: true }), `1 + 2 + … + ${formatNumber(6)}`);
});

for (const [i, one] of cases.entries()) {
  test(`every result has its words: ${one.calculator}, case ${i + 1}`, async () => {
    const { default: { elsewhere, sections } } = await import(`../../static/calculators/${one.calculator}/index.js`);
    const aside = [...ASIDE, ...elsewhere];
    const parts = sections.map((id) => one.answer[id]).filter(Boolean);
    for (const [name, value] of parts.flatMap(flattened).filter(([name]) => !aside.includes(name))) {
      assert.ok(message("quantity")[name], name);
      const records = Array.isArray(value) ? value.filter((each) => typeof each === "object" && !Array.isArray(each)) : [];
      for (const column of records.flatMap(Object.keys)) assert.ok(aside.includes(column) || message("quantity")[column], `${name} ${column}`);
    }
    const titled = new Map(); // numbers of one name are one number
    for (const id of sections.filter((each) => one.answer[each])) {
      for (const [name, value] of flattened(one.answer[id]).filter(([name, value]) => !aside.includes(name) && typeof value === "number")) {
        const { title } = quantityWords(name, id);
        assert.ok(Math.abs((titled.get(title) ?? value) - value) <= 1e-9 * Math.abs(value), `${id}: ${title}`);
        titled.set(title, value);
      }
    }
  });
}

test("the steps of 5,000 pins take no square of them", async () => {
  const one = cases.find(({ calculator, answer: { contact_force: force } }) => calculator === "crank-planetary" && force?.equal_sharing_peak_N);
  const many = { ...one, input: { ...one.input, mechanism: { ...one.input.mechanism, pins: 5000 } } };
  const { cos } = Math;
  let count = 0;
  Math.cos = (angle) => {
    count += 1;
    return cos(angle);
  };
  await stepsOf(many).finally(() => { Math.cos = cos; });
  assert.ok(count > 5000 && count < 1e6, String(count));
});
