import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { afterEach, test } from "node:test";

import { formatNumber, parseNumber } from "../../static/format.js";
import en from "../../static/messages/en.js";
import { chartWords, LANGUAGES, message, translated, useLanguage } from "../../static/messages/index.js";
import { inWords } from "../../static/wording.js";

afterEach(() => useLanguage("en"));

const OTHERS = Object.keys(LANGUAGES).filter((language) => language !== "en");
const textsOf = async (language) => (await import(`../../static/messages/${language}.js`)).default;

/** Every key with the places to be filled in its text. */
function shape(part, path = "") {
  if (typeof part === "string") return [`${path} ${(part.match(/\{\w+\}/g) ?? []).sort().join()}`];
  return Object.entries(part).flatMap(([key, value]) => shape(value, `${path}.${key}`));
}

test("every language has its file and every file its language", () => {
  const files = readdirSync(new URL("../../static/messages", import.meta.url));
  assert.deepEqual(files.sort(), [...Object.keys(LANGUAGES), "index"].map((name) => `${name}.js`).sort());
});

for (const language of OTHERS) {
  test(`${language}: no text is missing, none too many, and each fills the same places`, async () => {
    const { service, ...page } = await textsOf(language);
    assert.deepEqual(shape(page), shape(en));
    assert.ok(Object.keys(service.words).length > 100);
  });

  test(`${language}: what reads the service's sentences fills every place it takes`, async () => {
    const { service } = await textsOf(language);
    for (const [said, words] of service.sentences) {
      const places = new Set(said.match(/\{\d\}/g));
      for (const place of words.match(/\{\d\}/g) ?? []) assert.ok(places.has(place), words);
    }
  });

  test(`${language}: materials, their limits and where these come from`, async () => {
    await useLanguage(language);
    const { materials } = JSON.parse(readFileSync(new URL("worked_examples.json", import.meta.url)));
    for (const { title, group, limits } of materials) {
      const judged = limits.filter(({ criterion }) => criterion === "endurance");
      for (const said of [title, group, ...judged.flatMap(({ criterion, source }) => [criterion, source])]) {
        assert.notEqual(translated(said), said);
      }
    }
  });

  test(`${language}: words, refusals, figures and numbers`, async () => {
    await useLanguage(language);
    const titles = new Map([["pin_radius_mm", translated("Pin radius")]]);
    assert.match(translated("Pin radius"), /^Рад/);
    assert.match(inWords("must be larger than pin_radius_mm", titles), /[бБ]ільше|[бБ]ольше/);
    assert.ok(!/[a-z]{3}/.test(inWords("must be larger than pin_radius_mm", titles)));
    const hover = chartWords("satellite %{customdata[0]}, pin %{customdata[1]}<br>drives from %{customdata[2]}° to %{x}°");
    assert.ok(!/satellite|pin|drives/.test(hover), hover);
    assert.match(hover, /%\{customdata\[2\]\}°/);
    assert.notEqual(message("section.hertz"), en.section.hertz);
    assert.equal(formatNumber(1234.5), "1234,5");
    assert.equal(parseNumber(formatNumber(0.001234)).value, 0.001234);
    assert.equal(translated("Nothing of the kind"), "Nothing of the kind");
  });
}
