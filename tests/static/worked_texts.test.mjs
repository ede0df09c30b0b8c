import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

import en from "../../static/messages/en.js";

const ROOT = new URL("../../", import.meta.url);

/** The text of all files of a folder with this ending, folders within it too. */
function textsOf(folder, ending) {
  return readdirSync(new URL(folder, ROOT), { recursive: true })
    .filter((name) => name.endsWith(ending))
    .map((name) => readFileSync(new URL(`${folder}/${name}`, ROOT), "utf8")).join("\n");
}

function found(text, pattern) {
  return [...new Set([...text.matchAll(pattern)].map(([, key]) => key))].sort();
}

test("every text of the worked steps is used, and none is missing", () => {
  const steps = textsOf("static/calculators", ".js") + textsOf("static/lib", ".js");
  for (const [part, pattern] of [
    ["note", /\bnote: "(\w+)"/g],
    ["erratum", /\berratum: "(\w+)"/g],
    ["value", /\bintermediate\("(\w+)"/g],
    ["source", /\b(?:source: |SOURCE = )"(\w+)"/g],
  ]) assert.deepEqual(Object.keys(en.worked[part]).sort(), found(steps, pattern), part);
});
