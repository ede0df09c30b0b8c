/** The service asked for results and for the designs that are kept, as it comes and goes. */
import assert from "node:assert/strict";
import { mock, test } from "node:test";

import { createAsking } from "../../static/asking.js";
import { createBeside } from "../../static/besides.js";
import { Problem } from "../../static/lib/api.js";
import { stateFromInput } from "../../static/lib/form_state.js";
import { answerNow, createStore, opened, typedIn } from "../../static/store.js";
import { INPUT, MODEL } from "./model.mjs";

const GONE = new Problem({ title: "unreachable" });
const tick = () => new Promise((resolve) => { setImmediate(resolve); });

/** A calculator at work with a service that answers as `post` says, and these designs kept. */
function working(post, kept = [], texts = {}, own = {}) {
  const calculator = {
    id: "job", sections: ["force"], seeds: {}, drawing: { section: "force" }, figures: [], verdict: () => [],
    ask: ({ post: send, input }) => send("/job", input),
    ...own,
  };
  const titles = new Map();
  const { texts: all, chosen } = stateFromInput(MODEL, INPUT);
  const about = { model: MODEL, calculator, catalogues: {}, titles, materialOf: (path, given) => given };
  const store = createStore(opened(about, { texts: { ...all, ...texts }, chosen }, "light"));
  const client = { base: "", post: (path, body) => Promise.resolve().then(() => post(body)) };
  return { store, client, asking: createAsking({ store, client, designs: { of: () => kept } }) };
}

const answerTo = ({ mechanism }) => ({ force: { value: mechanism.pins, accuracy: { relative_error: 0 } } });
const design = (name, pins) => ({ name, calculator: "job", input: { ...INPUT, mechanism: { ...INPUT.mechanism, pins } } });

test("a kept design that the service did not answer is asked for again with the next answer", async () => {
  let gone = true;
  const { store, asking } = working((body) => {
    if (gone && body.mechanism.pins === 9) throw GONE;
    return answerTo(body);
  }, [design("A", 9)]);
  await asking.now();
  await tick();
  assert.equal(store.state.kept[0].answer, undefined);
  gone = false;
  await asking.now();
  await tick();
  assert.equal(store.state.kept[0].answer.force.value, 9);
});

test("a kept design that is refused is not asked for again", async () => {
  let asked = 0;
  const { store, asking } = working((body) => {
    if (body.mechanism.pins === 9) {
      asked += 1;
      throw new Problem({ status: 422, detail: "no" });
    }
    return answerTo(body);
  }, [design("A", 9)]);
  await asking.now();
  await tick();
  await asking.now();
  await tick();
  assert.deepEqual([store.state.kept[0].answer, asked], [null, 1]);
});

test("a slow comparison does not come after a later one", async () => {
  const kept = [design("A", 9)];
  let release = null;
  const { store, asking } = working((body) =>
    (body.mechanism.pins === 9 ? new Promise((resolve) => { release = () => resolve(answerTo(body)); }) : answerTo(body)), kept);
  await asking.now();
  await tick();
  assert.equal(store.state.phase, "fresh", "results do not wait for kept designs");
  kept.pop();
  await asking.compare();
  release();
  await tick();
  assert.deepEqual(store.state.kept, []);
});

test("a busy service is asked again when it said, one that fails only when the user wants it", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  let asked = 0;
  let problem = new Problem({ status: 503, kind: "unavailable", wait: 30000 });
  const { store, asking } = working((body) => {
    asked += 1;
    if (problem) throw problem;
    return answerTo(body);
  });
  await asking.now();
  assert.equal(store.state.phase, "busy");
  mock.timers.tick(29999);
  await tick();
  assert.equal(asked, 1);
  problem = new Problem({ status: 500, kind: "failure" });
  mock.timers.tick(1);
  await tick();
  assert.deepEqual([store.state.phase, asked], ["failed", 2]);
  mock.timers.tick(60000);
  await tick();
  assert.equal(asked, 2);
  problem = null;
  await asking.now();
  assert.equal(store.state.phase, "fresh");
  mock.timers.reset();
});

test("fixes that take too long to find leave the answer as it is, and that is said", async () => {
  const failing = (kind) => new Problem({ status: 503, kind, detail: "not within 10 s" });
  const fixes = [{ sets: {} }];
  const combined = { sets: {}, steps: fixes };
  const judged = (body, kind) => {
    if (body === "fixes" && kind) throw failing(kind);
    return { ...(body !== "fixes" && answerTo(body)), verdict: "fail", governing: "x", checks: [{ code: "x", title: "X", status: "fail" }], counts: {}, fixes, ...(body === "fixes" && { combined }) };
  };
  for (const [kind, long] of [["too-long", true], ["failure", null], ["", false]]) {
    const { store, asking } = working((body) => judged(body, kind), [], {}, { mend: ({ post }) => post("/job", "fixes") });
    await asking.now();
    await tick();
    assert.equal(store.state.phase, "fresh");
    assert.deepEqual(store.state.fixes, { of: store.state.shown, list: kind ? [] : [combined, ...fixes], long });
  }
});

test("what is usual is asked for apart from what mends the design, and where something is not known", async () => {
  const found = { usual_fit: { class: "H7/f7" }, usual_modification: { class: "ground" } };
  const own = { usual: ({ open }) => open, mend: ({ post, include }) => post("/job", { include }) };
  for (const open of [["usual_fit"], []]) {
    const asked = [];
    const { store, asking } = working((body) => {
      if (!body.include) return { ...answerTo(body), open };
      asked.push(body.include);
      return found;
    }, [], {}, own);
    await asking.now();
    await tick();
    assert.deepEqual(asked, open.length > 0 ? [open] : []);
    assert.deepEqual(store.state.usual, open.length > 0 ? { of: store.state.shown, fit: found.usual_fit, ring: found.usual_modification } : null);
    assert.equal(store.state.fixes, null);
  }
});

test("the largest torque, what mends a design, and what is usual are asked for aside, one after the other, and not of a design that is typed over", async () => {
  const asked = [];
  const own = {
    limit: ["largest_torque"],
    usual: () => ["usual_fit"],
    mend: ({ post, include = ["fixes"] }) => post("/job", { include }),
  };
  const failing = { verdict: "fail", parts: [{ status: "fail" }], checks: [{ code: "x", title: "X", status: "fail" }], counts: {} };
  const { store, client, asking } = working((body) => ({ ...answerTo(body), ...failing }), [], {}, own);
  const { post } = client;
  client.post = (path, body, { signal, aside }) => (aside
    ? new Promise((resolve) => { asked.push({ include: body.include[0], signal, done: resolve }); }) : post(path, body));
  await asking.now();
  await tick();
  assert.deepEqual(asked.map(({ include }) => include), ["largest_torque"]);
  const { shown } = store.state;
  let settled = false;
  asking.settled().then(() => { settled = true; });
  await tick();
  assert.deepEqual([settled, answerNow(store.state)], [false, shown.answer]);
  asked[0].done({ ...failing, largest_torque_Nm: 80, torque_reserve: 0.8 });
  await tick();
  assert.deepEqual([settled, store.state.shown, answerNow(store.state).largest_torque_Nm], [true, shown, 80]);
  assert.match(store.state.said, /80/);
  assert.deepEqual(asked.map(({ include }) => include), ["largest_torque", "fixes"]);
  asked[1].done(failing);
  await tick();
  assert.deepEqual([store.state.fixes.of === store.state.shown, asked.length, asked[2].include], [true, 3, "usual_fit"]);
  store.apply(typedIn, "mechanism.pins", "7", 0);
  asking.soon();
  assert.ok(asked[2].signal.aborted);
  asking.cancel();
});

test("a live group that the service could not answer asks again by itself, unless its inputs have changed", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  let asked = 0;
  let gone = true;
  const { store, client } = working(answerTo);
  const logic = {
    live: true,
    asked: ({ mechanism }) => mechanism,
    bodyOf: async (body) => body,
    async ask() {
      asked += 1;
      if (gone) throw GONE;
      return { value: 1 };
    },
  };
  const beside = createBeside({ store, client, id: "real", logic });
  await beside.ask();
  assert.deepEqual([store.state.besides.real.phase, asked], ["failed", 1]);
  gone = false;
  mock.timers.tick(5000);
  await tick();
  assert.deepEqual([store.state.besides.real.phase, asked], ["fresh", 2]);
  gone = true;
  store.apply(typedIn, "mechanism.pins", "5", 0);
  await beside.ask();
  store.apply(typedIn, "mechanism.pins", "x", 1);
  mock.timers.tick(5000);
  await tick();
  assert.equal(asked, 3);
  mock.timers.reset();
});
