/** What the page asks for at once, by its head and first.js, is what it needs, and nothing else. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import vm from "node:vm";

import { CALCULATORS } from "../../static/calculators/index.js";
import { pages } from "./service.mjs";

const ROOT = new URL("../../", import.meta.url);
const textOf = (path) => readFileSync(new URL(`.${path}`, ROOT), "utf8");

/** The paths of a module and of all that it imports, one through the other. */
function graph(path, found = new Set()) {
  if (found.has(path)) return found;
  found.add(path);
  for (const [, name] of textOf(path).matchAll(/^(?:import|export|\}) ?[^"';]*?(?:from )?"(\.[^"]+)"(?: with [^;]*)?;/gm)) {
    graph(new URL(name, `http://x${path}`).pathname, found);
  }
  return found;
}

function linked(rel, page = pages[""]) {
  return [...page.matchAll(/<link ([^>]*)>/g)].map(([, text]) => Object.fromEntries(
    [...text.matchAll(/([\w-]+)(?:="([^"]*)")?/g)].map(([, name, value = ""]) => [name, value]),
  )).filter((link) => link.rel === rel);
}

/** What first.js asks for at an address. */
function asksAt(search) {
  const links = [];
  const document = {
    documentElement: { dataset: {} },
    createElement: () => ({ addEventListener() {} }),
    head: { append: (...nodes) => links.push(...nodes) },
  };
  vm.runInNewContext(textOf("/static/first.js"), { URLSearchParams, document, location: { search }, navigator: { languages: ["en"] } });
  return links;
}

for (const id of CALCULATORS) {
  test(`every module of the first screen is preloaded: ${id}`, () => {
    const modules = [...graph(`/static/calculators/${id}/index.js`, graph("/static/main.js"))];
    assert.ok(modules.length > 30, modules.length);
    assert.deepEqual(linked("modulepreload", pages[id]).map(({ href }) => `/${href}`).sort(), modules.filter((path) => path !== "/static/main.js").sort());
  });
}

test("without a calculator in the address those of the first", () => {
  for (const id of ["", "another"]) assert.equal(pages[id], pages[CALCULATORS[0]]);
});

test("what the service says of itself is asked for in the way in which the page asks", () => {
  const paths = /\[([^\]]*)\]\.map\(\(path\) => client\.get\(path\)\)/.exec(textOf("/static/main.js"))[1];
  for (const language of ["en", "uk"]) {
    const asked = [...linked("preload"), ...asksAt(`?lang=${language}`)].filter((link) => link.as === "fetch");
    assert.deepEqual(asked.map(({ href }) => href), paths.replace("${language}", language).match(/[\w/.?=]+/g).map((path) => `api/v1${path}`));
    assert.ok(asked.every(({ crossorigin, crossOrigin }) => crossorigin === "" || crossOrigin === "anonymous")); // as fetch does
  }
});

test("Plotly is run from where it has been asked for", () => {
  const [, source] = /SOURCE = "([^"]+)"/.exec(textOf("/static/views/plot.js"));
  assert.deepEqual(asksAt("").map(({ src }) => src).filter(Boolean), [source]);
  assert.deepEqual(linked("preload").filter((link) => link.as === "script").map(({ href }) => href), [source]);
});
