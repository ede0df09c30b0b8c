/** Worked steps as the page writes them: formulas of the service, read and typeset; all of them have words. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { afterEach, test } from "node:test";
import { fileURLToPath } from "node:url";

import { CALCULATORS, calculatorOf } from "../../static/calculators/index.js";
import { listedOf } from "../../static/lib/checks.js";
import { mathml, plainSymbol, plainText } from "../../static/lib/formula/mathml.js";
import { parse } from "../../static/lib/formula/notation.js";
import { setUnits } from "../../static/lib/units.js";
import { LANGUAGES } from "../../static/messages/index.js";
import { valuesMarkup } from "../../static/views/results.js";
import { askSteps, groupMarkup } from "../../static/views/worked.js";
import { useLanguage } from "./service.mjs";

const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const ASK = `
import json
import orjson
from pydantic import TypeAdapter
from app.registry import CALCULATIONS
from core.drive import compiled
from tests.app.worked_designs import REQUESTS

compiled.load()
found = {}
for word, (name, body) in REQUESTS.items():
    asked = CALCULATIONS[name]
    read = TypeAdapter(asked.request).validate_json
    work = body | {"include": [*body.get("include", []), "worked"]}
    found[word] = name, asked.answered(read(json.dumps(body))), asked.answered(read(json.dumps(work)))["worked"]
print(orjson.dumps(found, option=orjson.OPT_SERIALIZE_NUMPY).decode())
`;
const answers = JSON.parse(execFileSync(`${ROOT}.venv/bin/python`, ["-c", ASK], { cwd: ROOT, encoding: "utf8", maxBuffer: 2 ** 27 }));
const steps = Object.fromEntries(Object.entries(answers).map(([word, [, , worked]]) => [word, worked]));
const accuracy = { relative_error: 1e-12, method: "closed form", method_code: "closed_form" };

afterEach(async () => {
  setUnits("metric");
  await useLanguage("en");
});

const grouped = (list) => [...new Set(list.map(({ section }) => section))].map((id) => [id, list.filter(({ section }) => section === id)]);

for (const language of Object.keys(LANGUAGES)) {
  test(`${language}: every step is written, with its title, its formula and its words`, async () => {
    await useLanguage(language);
    for (const [word, list] of Object.entries(steps)) {
      for (const [section, own] of grouped(list)) {
        const markup = groupMarkup({ section, steps: own }, accuracy).toString();
        assert.doesNotMatch(markup, /undefined|NaN|\[object|\{\w+\}/, `${word} ${section}`);
        assert.equal(markup.match(/<li /g).length, own.length);
        assert.doesNotMatch(markup, /<mi>[^<]*(alpha|gamma|delta|eps|eta|lambda|mu|nu|rho|sigma|tau|phi|chi|psi|star|prime)/i, `${word} ${section}`);
      }
    }
  });
}

/** The sections that a calculator lists of an answer: parts of the whole design's, its mesh as that has it, and of the others all. */
function listed(calculator, name, { kind, positions, ...answer }) {
  const sections = name === "crank-planetary" ? answer : { [name.split("/").at(-1).replaceAll("-", "_")]: answer };
  const own = ["crank-planetary", "ring-mesh"].includes(name) === (calculator.id === "crank-planetary");
  return own ? listedOf(calculator, [sections]).filter((id) => sections[id]).map((id) => [id, sections[id]]) : [];
}

for (const calculator of CALCULATORS) {
  test(`every result that is listed has its words: ${calculator}`, async () => {
    const own = await calculatorOf(calculator);
    const sections = Object.values(answers).flatMap(([name, answer]) => listed(own, name, answer));
    assert.deepEqual(new Set(own.sections.filter((id) => !sections.some(([other]) => other === id))), new Set());
    for (const [id, section] of sections) {
      const markup = valuesMarkup(id, section, own.elsewhere, new Map()).toString();
      assert.doesNotMatch(markup, /undefined|NaN|\[object/, id);
      assert.deepEqual(markup.match(/>[^<]*\d\.0*[1-9]\d{4,}[^<]*</g) ?? [], [], `${id}: digits beyond those that are shown`);
      const titles = [...markup.matchAll(/data-name="[^"]*"><th scope="row">([^<]*)/g)].map(([, title]) => title);
      assert.deepEqual(titles.filter((title, i) => titles.indexOf(title) !== i), [], `${id}: two results of one name`);
    }
  });
}

test("numbers are shown in the units that are chosen", () => {
  const [step] = steps.force.filter(({ formula }) => formula === "T/R");
  const shown = () => groupMarkup({ section: "contact_force", steps: [step] }, accuracy).toString();
  assert.match(shown(), /<mn>80<\/mn><mtext>\u202fN·m<\/mtext>/);
  setUnits("us");
  assert.match(shown(), /<mn>708\.06<\/mn><mtext>\u202flbf·in<\/mtext>/);
  assert.doesNotMatch(shown(), /mm/);
});

test("the steps are asked with what was asked, of the sections that are open", async () => {
  const sent = [];
  const client = {
    base: "/api/v1",
    post: async (path, body) => {
      sent.push([path, body]);
      return path === "/old" ? {} : { worked: [{ section: "hertz" }] };
    },
  };
  const requests = [
    { path: "/api/v1/crank-planetary", body: { mechanism: 1, include: ["cyclogram", "hertz", "checks"] } },
    { path: "/api/v1/old", body: { load: 2 } },
  ];
  assert.deepEqual(await askSteps({ requests }, ["hertz"], client), [{ section: "hertz" }]);
  assert.deepEqual(sent, [
    ["/crank-planetary", { mechanism: 1, include: ["hertz", "worked"] }],
    ["/old", { load: 2, include: ["worked"] }],
  ]);
});

test("notation: precedence, powers to the right, calls, what is wrong", () => {
  const read = (text) => plainText(parse(text));
  assert.equal(read("1-2-3"), "1 − 2 − 3");
  assert.equal(read("1-(2-3)"), "1 − (2 − 3)");
  assert.equal(read("2^3^2"), "2^(3^(2))");
  assert.equal(read("-a^2"), "−a^(2)");
  assert.equal(read("a/b/c"), "((a) / (b)) / (c)");
  assert.equal(read("2*(3+a)"), "2 · (3 + a)");
  assert.equal(read("min(3,1+1,7)"), "min(3; 1 + 1; 7)");
  assert.equal(read("sqrt(abs(-16))"), "√(|−16|)");
  for (const wrong of ["", "1+", "(1", "1)", "f(1", "*2", "a;b"]) assert.throws(() => parse(wrong), SyntaxError, wrong);
});

test("names are written as symbols", () => {
  assert.equal(plainSymbol("phi_T"), "φ T");
  assert.equal(plainSymbol("E_star"), "E*");
  assert.equal(plainSymbol("Delta_prime_B"), "Δ′ B");
  assert.equal(plainSymbol("gamma_1_2"), "γ 1,2");
  assert.equal(plainSymbol("K_sigma"), "K σ");
  assert.match(mathml(parse("sqrt(E_star/d)")).toString(), /^<msqrt><mfrac><mrow><msup><mi>E<\/mi><mo>\*<\/mo><\/msup><\/mrow><mrow><mi>d<\/mi>/);
});

test("formulas are written with symbols and with numbers and units", () => {
  const values = { d: { value: 10, unit: "mm" }, E_star: { value: 210, unit: "GPa" }, F: { value: -2, unit: "N" } };
  const written = (text, withNumbers) => plainText(parse(text), { values, withNumbers });
  assert.equal(written("(d+d)*E_star"), "(d + d) · E*");
  assert.equal(written("d^2", true), "(10 mm)^(2)");
  assert.equal(written("d-(d-E_star)"), "d − (d − E*)");
  assert.equal(written("2*d/E_star", true), "(2 · 10 mm) / (210 GPa)");
  assert.equal(written("d+F", true), "10 mm + (−2 N)");
  assert.match(mathml(parse("d"), { values, withNumbers: true }).toString(), /<mn>10<\/mn><mtext>\u202fmm<\/mtext>/);
});

test("a step by a method shows the numbers that go in", () => {
  const [step] = steps.rollers.filter(({ code }) => code === "displacement_mm");
  const shown = groupMarkup({ section: "roller_strength", steps: [step] }, accuracy).toString();
  assert.match(shown, /from <math aria-label="n = 5">.*<math aria-label="F m = 535\.714.N">/s);
  assert.match(shown, /Σg/);
});
