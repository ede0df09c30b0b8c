import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";

import { csvOf, csvOfTables, curlLine, flatValues, pythonCode } from "../../static/lib/exports.js";
import { createDesigns, movedOf, resultsOf } from "../../static/lib/designs.js";
import { begun, recorded, redone, undone } from "../../static/lib/history.js";
import { lasting } from "../../static/lib/storage.js";

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
  const rows = flatValues({ mechanism: { pins: 3 }, load: { output_torque_Nm: 280 } }, {
    verdict: "pass",
    checks: [{ code: "wall", status: "pass", value: 4, limit: 3, unit: "mm", source: "geometry" }],
    force: { peak_force_N: 5, peak_pair: { satellite: 1, pin: 2 }, force_N: [1, 2], accuracy: { relative_error: 0 }, curves: {} },
    hertz: undefined,
    lines: { lines: [{ length_mm: 3 }] },
  });
  assert.deepEqual(rows.map(({ name, value, unit }) => [name, value, unit]), [
    ["mechanism.pins", 3, ""], ["load.output_torque_Nm", 280, "N·m"], ["peak_force_N", 5, "N"], ["peak_pair.satellite", 1, ""], ["peak_pair.pin", 2, ""],
    ["force_N[0]", 1, "N"], ["force_N[1]", 2, "N"], ["lines[0].length_mm", 3, "mm"],
    ["wall.value", 4, "mm"], ["wall.limit", 3, "mm"], ["wall.status", "pass", ""], ["wall.source", "geometry", ""],
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

test("two tabs keep designs in one storage, and neither loses the other's", () => {
  const storage = memory();
  const [one, other] = [createDesigns(storage), createDesigns(storage)];
  const first = one.add("job", { pins: 3 });
  const second = other.add("job", { pins: 4 });
  assert.deepEqual([first.name, second.name], ["A", "B"]);
  assert.notEqual(first.id, second.id);
  one.rename(second, "Wide");
  other.remove(first);
  assert.deepEqual(one.of("job").map(({ name, input }) => [name, input.pins]), [["Wide", 4]]);
  const older = createDesigns(memory({ "khv-calc.designs": '[{"name":"A","calculator":"job","input":{}}]' }));
  older.rename(older.of("job")[0], "Old");
  assert.equal(older.of("job")[0].name, "Old", "designs kept before there were ids");
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

test("a project file keeps results and requests, and one of the first form its verdict", () => {
  const calculator = { id: "job" };
  const answer = { verdict: "pass", governing: "x", largest_torque_Nm: 20, hertz: { max_pressure_MPa: 800 }, load_sharing: { backlash_max_arcmin: 2, peak_force_N: 7 }, other: { peak_force_N: 9 } };
  const results = resultsOf(calculator, answer);
  assert.deepEqual(results, { verdict: "pass", governing: "x", largest_torque_Nm: 20, max_pressure_MPa: 800, peak_force_N: 7, backlash_max_arcmin: 2 });
  assert.deepEqual(movedOf(results, resultsOf(calculator, { ...answer, largest_torque_Nm: 20 * (1 + 1e-7), hertz: { max_pressure_MPa: 801 } })), [["max_pressure_MPa", 800, 801]]);
  assert.deepEqual(movedOf(undefined, results), []);
  const first = createDesigns(memory());
  first.add("job", { pins: 3 }, "Own", { results, path: "/job", body: { pins: 3 } });
  const file = JSON.parse(first.exported("1.2.3"));
  assert.deepEqual([file.format, file.v, file.version], ["khv-calc designs", 2, "1.2.3"]);
  const second = createDesigns(memory());
  assert.equal(second.imported(JSON.stringify(file)), 1);
  const [{ results: kept, path, body }] = second.of("job");
  assert.deepEqual([kept, path, body], [results, "/job", { pins: 3 }]);
  const old = { format: "khv-calc designs", v: 1, designs: [{ name: "B", calculator: "job", input: {}, verdict: "fail" }] };
  assert.equal(second.imported(JSON.stringify(old)), 1);
  assert.deepEqual(second.of("job")[1].results, { verdict: "fail" });
  assert.equal(second.imported(JSON.stringify({ ...old, v: 3 })), null);
});

test("a storage with something else in it, or none, does no harm", () => {
  for (const text of ["{]", "null", "{}", '[null, { "name": "A" }]']) {
    assert.deepEqual(createDesigns(memory({ "khv-calc.designs": text })).of("job"), []);
  }
  const designs = createDesigns(lasting); // which Node.js has not
  designs.add("job", {});
  assert.equal(designs.of("job").length, 1);
});

test("where the browser's storage is full, what is kept stays until the page is closed", () => {
  const first = '[{"id":"1","name":"A","calculator":"job","input":{"pins":3}}]';
  const designs = createDesigns({ ...memory({ "khv-calc.designs": first }), setItem() {} });
  assert.equal(designs.lasting(), true);
  assert.equal(designs.add("job", { pins: 4 }).name, "B");
  assert.equal(designs.lasting(), false);
  assert.deepEqual(designs.of("job").map(({ input }) => input.pins), [3, 4]);
  designs.remove(designs.of("job")[0]);
  assert.deepEqual(designs.of("job").map(({ name }) => name), ["B"]);
});

test("undo and redo step over whole changes; typing in one box is one change", () => {
  let history = recorded(begun("a"), "b", "pins", 0);
  history = recorded(history, "bc", "pins", 100);
  history = undone(recorded(history, "d", undefined, 100));
  assert.equal(history.present, "bc");
  const first = undone(history);
  assert.equal(first.present, "a");
  assert.equal(undone(first), first);
  history = redone(first);
  assert.equal(history.present, "bc");
  assert.equal(redone(redone(history)).present, "d");
  history = recorded(history, "e", "pins", 200);
  assert.equal(redone(history), history);
  history = undone(recorded(history, "f", "pins", 10_200));
  assert.deepEqual([history.present, undone(history).present], ["e", "bc"]);
});
