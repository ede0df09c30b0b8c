import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { afterEach, test } from "node:test";

import { CALCULATORS, calculatorOf } from "../../static/calculators/index.js";
import { formatNumber, formatQuantity, inNumerals, parseNumber } from "../../static/lib/format.js";
import { formModel } from "../../static/lib/schema_form.js";
import { setUnits } from "../../static/lib/units.js";
import en from "../../static/messages/en.json" with { type: "json" };
import { fieldWords, LANGUAGES, message, said } from "../../static/messages/index.js";
import { figureText } from "../../static/service_texts.js";
import { english, openapi, useLanguage } from "./service.mjs";

const { symbols, ...spoken } = english;

afterEach(() => useLanguage("en"));

const OTHERS = Object.keys(LANGUAGES).filter((language) => language !== "en");
const fileOf = async (path) => (await import(path, { with: { type: "json" } })).default;
const textsOf = async (language) => ({ ...await fileOf(`../../static/messages/${language}.json`), service: await fileOf(`../../app/words/${language}.json`) });

// Where languages differ by nature: names of their units.
const OWN = ["unit"];
// Latin words that stay: keys, formats, programs, standards and their designations, US units, functions.
const LATIN = new RegExp(String.raw`\([A-Z][\w, -]*\)|\b(${[
  "Enter", "Esc", "Ctrl", "Alt", "Shift", "KHV Calc", "CSV", "PDF", "DXF", "XLSX", "STEP", "JSON", "curl", "Python", "psi", "lbf", "sin", "cos", "tan", "true", "false", "tanh-sinh",
  "QUADPACK", "PEEK", "ISO", "DIN", "arcsin", "HBW", "CuSn", "KISSsoft", "SKF", "IKO", "MITCalc", "Roloff/Matek", "Zaretsky", "Autodesk Inventor",
  "Johnson, Contact Mechanics", "Shigley, Mechanical Engineering Design", "Shigley", "Wang, Luo, Su", "Tribology Handbook",
  "PLA", "PETG", "ABS", "PA6-CF", "SAE", "McEwen",
].join("|")})`, "g");

/** Every text with its key; the forms of a noun are one text. */
function* leaves(part, path = "") {
  if (typeof part === "string") yield [path, [part]];
  else if (part.other) yield [path, Object.values(part)];
  else for (const [key, value] of Object.entries(part)) if (path !== "" || !OWN.includes(key)) yield* leaves(value, `${path}.${key}`);
}

const places = (text) => (text.match(/\{\w+\}/g) ?? []).sort().join();

test("every language has its file and every file its language", () => {
  const files = readdirSync(new URL("../../static/messages", import.meta.url));
  assert.deepEqual(files.sort(), [...Object.keys(LANGUAGES).map((name) => `${name}.json`), "index.js"].sort());
});

test("a book stands under its own name wherever it is named", async () => {
  for (const language of OTHERS) {
    const texts = [...leaves(await textsOf(language))].flatMap(([, forms]) => forms);
    assert.ok(texts.some((text) => text.includes("Shigley, Mechanical Engineering Design, 6")));
    assert.deepEqual(texts.filter((text) => /Джонсон|Шигл[иі]|Shigley, Mechanical Engineering Design(?!, 6)/.test(text)), []);
  }
});

for (const language of OTHERS) {
  test(`${language}: no text is missing, none too many, of the page and of the service, and each fills the same places`, async () => {
    const shape = (texts) => [...leaves(texts)].flatMap(([path, forms]) => [...new Set(forms.map((one) => `${path} ${places(one)}`))]);
    assert.deepEqual(shape(await textsOf(language)).sort(), shape({ ...en, service: spoken }).sort());
  });

  test(`${language}: nothing is left in English, and a noun has all its forms`, async () => {
    const categories = new Intl.PluralRules(language).resolvedOptions().pluralCategories;
    for (const [path, forms] of leaves(await textsOf(language))) {
      for (const text of forms) {
        const plain = text.replace(/<[^>]*>|\{\w+\}|_(max|min|out)(?![a-z])/g, "").replace(LATIN, "");
        assert.doesNotMatch(plain, /(?<![A-Za-z0-9\p{Script=Greek}])[A-Za-z]{3,}/u, `${path}: ${text}`);
      }
      if (forms.length > 1) assert.equal(forms.length, categories.length, path);
    }
  });

  test(`${language}: one term for one thing`, async () => {
    const wrong = {
      uk: /пальц(?!ів\) вихідної)|палець|передавальн|зубц|закладен|щільн|вихідні дані|застереженн|мертв[аіо]\p{L}* точ|текуч|стінк|розточ|зношенн|сфер(?!ич)|кут\p{L}* нахилу|пристосовніс|нєхорош|(?<!коефіцієнт )надійн|'/iu,
      ru: /ведом\p{L}+ звен|коленчат|закладен|плотн(?!ость материала)|венц|допустим(?!ое значение)|мёртв\p{L}+ точ|передаточное отношение(?!"|,| зацеп)|первая текуч|стенк|расточ|сфер(?!ич)|цев[ко]|уг\p{L}+ наклона|(?<!коэффициент )надёжн/iu,
    }[language];
    for (const [path, forms] of leaves(await textsOf(language))) {
      if (path.endsWith("ratio_u12.title")) continue;
      for (const text of forms) assert.doesNotMatch(text, wrong, path);
    }
  });

  test(`${language}: a title that is put in stands in the nominative`, async () => {
    const governed = /(?<!\p{L})(з|із|зі|для|до|від|за|на|с|к|от|при|таким|косинус|значення|значения) \{(field|other)\}/u;
    for (const [path, forms] of leaves(await textsOf(language))) {
      for (const text of forms) assert.doesNotMatch(text, governed, path);
    }
  });

  test(`${language}: fields, figures, numbers and units`, async () => {
    await useLanguage(language);
    assert.match(fieldWords("pin_radius_mm", "contact").title, /^Рад/);
    assert.notEqual(fieldWords("diameter_mm", "roller").title, fieldWords("diameter_mm", "shaft").title);
    assert.equal(fieldWords("nothing_of_the_kind", "load"), null);
    assert.equal(said("notices", "nothing_of_the_kind"), undefined);
    const hover = figureText("pair_force", {
      satellite: 1, pin: 2, force: { value: "%{y:.5g}", unit: "N", digits: 6 }, angle: { value: "%{x:.2f}", unit: "°", digits: 6 },
    });
    assert.match(hover, /%\{y:\.5g\}\u00a0Н; φ = %\{x:\.2f\}°$/);
    assert.equal(figureText("amount", { amount: { value: 0.0025, unit: "mm", digits: 3 } }), "0,0025\u00a0мм");
    assert.notEqual(message("section.hertz"), en.section.hertz);
    assert.equal(formatNumber(1234.5), "1234,5");
    assert.equal(formatNumber(2.1e11), "2,1·10¹¹");
    assert.equal(formatQuantity(3.5, "N·m"), "3,5\u00a0Н·м");
    assert.equal(parseNumber(formatNumber(0.001234)).value, 0.001234);
    setUnits("us");
    assert.equal(formatQuantity(25.4, "mm"), "1\u00a0in");
    setUnits("metric");
  });
}

test("a noun agrees with its number", async () => {
  const rollers = (counts) => counts.map((count) => message("line.rollers", { count }));
  assert.deepEqual(rollers([1, 2]), ["1 roller", "2 rollers"]);
  await useLanguage("uk");
  assert.deepEqual(rollers([1, 2, 5, 11, 21, 2.5]),
    ["1 ролик", "2 ролики", "5 роликів", "11 роликів", "21 ролик", "2,5 ролика"]);
  await useLanguage("ru");
  assert.deepEqual(rollers([1, 2, 5, 22]), ["1 ролик", "2 ролика", "5 роликов", "22 ролика"]);
});

test("every option of every form has its words, or is a designation", async () => {
  const designation = /^$|^[A-Za-z]{0,3}\d+(\/[a-z]*\d+)?(E|-XL)?$/; // of a fit, a class, a bearing
  for (const id of CALCULATORS) {
    const { catalogues = {}, path, ...own } = await calculatorOf(id);
    const model = formModel(openapi, { ...own, path: `/api/v1${path}` });
    const fields = [...model.fields.values()].flatMap((field) => [field, ...field.columns ?? []]);
    const options = fields.filter((field) => ["option", "flag"].includes(field.kind) && !(field.path in catalogues))
      .flatMap((field) => field.options.map((option) => [option, field.path]));
    assert.ok(options.length > 1);
    for (const [option, where] of options) assert.ok(designation.test(option) || en.option[option] || english.materials[option], `${where}: ${option}`);
  }
});

test("decimal fractions of what the service writes stand as the language has them, designations do not", async () => {
  const text = "PolyTerra 23.2, table 1.5.1; ≥ 0.01·C";
  assert.equal(inNumerals(text), text);
  await useLanguage("uk");
  assert.equal(inNumerals(text), "PolyTerra 23,2, table 1.5.1; ≥ 0,01·C");
});
