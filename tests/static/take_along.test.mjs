import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";

import { flatValues } from "../../static/answers.js";
import { csvOf, csvOfTables } from "../../static/csv.js";
import { createDesigns } from "../../static/designs.js";
import { createHistory } from "../../static/history.js";
import { curlLine, pythonCode } from "../../static/snippets.js";

const BODY = { pins: 3, name: "it's \"steel\"", list: [1.5, -2e-9], nested: { yes: true, nothing: null, long: Array(40).fill(1.25) } };

test("CSV quotes what needs it and keeps all digits", () => {
  const table = { title: "t", columns: [{ title: "a, b", unit: "mm" }, { title: "c" }], rows: [[0.1 + 0.2, 'say "x"'], [undefined, 2]] };
  assert.equal(csvOf(table), '"a, b, mm",c\r\n0.30000000000000004,"say ""x"""\r\n,2\r\n');
  assert.equal(csvOfTables([table, table]).split("\r\n\r\n").length, 2);
});

test("the curl line sends the body as it is", () => {
  const script = `curl() { printf %s "$6"; }; ${curlLine("http://x/y", BODY)}`; // the word after -d
  const shell = spawnSync("sh", ["-c", script], { encoding: "utf8" });
  assert.deepEqual(JSON.parse(shell.stdout), BODY);
});

test("the Python program sends the same body", () => {
  const code = pythonCode("http://x/y", BODY).replace("import httpx\n", `
import json, types
class Answer:
    def raise_for_status(self): pass
    def json(self): return self.body
def post(url, json):
    answer = Answer(); answer.body = (url, json); return answer
httpx = types.SimpleNamespace(post=post)
`).replace("print(answer.json())", "print(json.dumps(answer.json()))");
  const run = spawnSync("python3", ["-c", code], { encoding: "utf8" });
  assert.equal(run.stderr, "");
  assert.deepEqual(JSON.parse(run.stdout), ["http://x/y", BODY]);
});

test("every value of an answer gets a row, curves and accuracy none", () => {
  const rows = flatValues({
    force: { peak_force_N: 5, peak_pair: { satellite: 1, pin: 2 }, force_N: [1, 2], accuracy: { relative_error: 0 }, curves: {} },
    hertz: undefined,
    lines: { lines: [{ length_mm: 3 }] },
  });
  assert.deepEqual(rows.map(({ name, value, unit }) => [name, value, unit]), [
    ["peak_force_N", 5, "N"], ["peak_pair.satellite", 1, ""], ["peak_pair.pin", 2, ""],
    ["force_N[0]", 1, "N"], ["force_N[1]", 2, "N"], ["lines[0].length_mm", 3, "mm"],
  ]);
});

function memory(start = {}) {
  const kept = new Map(Object.entries(start));
  return { getItem: (key) => kept.get(key) ?? null, setItem: (key, value) => kept.set(key, value) };
}

test("designs are kept, renamed, removed, and found again", () => {
  const storage = memory();
  const designs = createDesigns(storage);
  designs.add("job", { pins: 3 });
  const second = designs.add("job", { pins: 4 });
  assert.deepEqual(designs.of("job").map(({ name }) => name), ["A", "B"]);
  designs.rename(second, "A"); // taken
  designs.rename(second, "Wide");
  assert.deepEqual(createDesigns(storage).of("job").map(({ name }) => name), ["A", "Wide"]);
  designs.remove(designs.of("job")[0]);
  assert.deepEqual(createDesigns(storage).of("job").map(({ input }) => input), [{ pins: 4 }]);
  assert.deepEqual(designs.of("other"), []);
});

test("a file of designs loads elsewhere; names that are taken get a free one", () => {
  const first = createDesigns(memory());
  first.add("job", { pins: 3 });
  const second = createDesigns(memory());
  second.add("job", { pins: 9 });
  assert.equal(second.imported(first.exported()), 1);
  assert.deepEqual(second.of("job").map(({ name, input }) => [name, input.pins]), [["A", 9], ["B", 3]]);
  assert.equal(second.imported("no JSON"), null);
  assert.equal(second.imported('{"format": "another"}'), null);
});

test("a storage with something else in it, or none, does no harm", () => {
  assert.deepEqual(createDesigns(memory({ "khv-calc.designs": "{]" })).of("job"), []);
  const designs = createDesigns(null);
  designs.add("job", {});
  assert.equal(designs.of("job").length, 1);
});

test("undo and redo step over whole changes; typing in one box is one change", () => {
  let time = 0;
  const history = createHistory("a", () => time);
  history.record("b", "pins");
  time += 100;
  history.record("bc", "pins");
  history.record("d");
  assert.equal(history.undo(), "bc");
  assert.equal(history.undo(), "a");
  assert.equal(history.undo(), null);
  assert.equal(history.canUndo, false);
  assert.equal(history.redo(), "bc");
  history.record("e", "pins");
  assert.equal(history.canRedo, false);
  time += 10_000;
  history.record("f", "pins");
  assert.equal(history.undo(), "e");
  assert.equal(history.undo(), "bc");
});
