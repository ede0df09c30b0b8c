import assert from "node:assert/strict";
import { test } from "node:test";

import { createClient, newestOnly, Problem } from "../../static/lib/api.js";

const answering = (status, body, type = "application/json", headers = {}) => {
  const calls = [];
  const fetch = async (url, options) => {
    calls.push({ url, options });
    return new Response(typeof body === "string" ? body : JSON.stringify(body), {
      status, headers: { "content-type": type, ...headers },
    });
  };
  return { calls, client: createClient({ base: "/api", fetch }) };
};

test("a body goes out as JSON, with its query, and the answer comes back", async () => {
  const { calls, client } = answering(200, { force_N: 5 });
  assert.deepEqual(await client.post("/x/chart", { pins: 3 }, { query: { theme: "dark" } }), { force_N: 5 });
  assert.equal(calls[0].url, "./api/x/chart?theme=dark");
  assert.equal(calls[0].options.body, '{"pins":3}');
  assert.equal(calls[0].options.headers["content-type"], "application/json");
});

test("a problem keeps its status, words and pointers", async () => {
  const errors = [{ pointer: "/pins", detail: "must be 1 or more" }];
  const { client } = answering(422, { title: "Invalid input", detail: "pins", status: 422, errors }, "application/problem+json");
  await assert.rejects(client.post("/x", {}), (problem) => {
    assert.ok(problem instanceof Problem);
    assert.equal(problem.status, 422);
    assert.equal(problem.message, "pins");
    assert.deepEqual(problem.errors, errors);
    return true;
  });
});

test("what is no problem document, no JSON or no answer is a problem too", async () => {
  const gateway = answering(502, "<h1>Bad gateway</h1>", "text/html").client;
  await assert.rejects(gateway.get("/x"), (problem) => problem instanceof Problem && problem.status === 502);
  const busy = answering(503, { type: "./problems/unavailable" }, "application/problem+json", { "retry-after": "7" }).client;
  await assert.rejects(busy.get("/x"), ({ kind, passing, wait }) => kind === "unavailable" && passing && wait === 7000);
  await assert.rejects(gateway.get("/x"), ({ kind, passing, wait }) => kind === "unavailable" && passing && wait === 0);
  await assert.rejects(answering(500, "oh", "text/html").client.get("/x"), ({ kind, passing }) => kind === "failure" && !passing);
  const broken = answering(200, "{").client;
  await assert.rejects(broken.get("/x"), (problem) => problem instanceof Problem && problem.status === 0);
  const nobody = createClient({ fetch: async () => { throw new TypeError("failed to fetch"); } });
  await assert.rejects(nobody.get("/x"), (problem) => problem instanceof Problem && problem.status === 0);
});

test("an answer in lines says how far it is, and ends with the result, a problem, or too early", async () => {
  const told = [];
  const asked = (...lines) => {
    const { calls, client } = answering(200, lines.map((line) => `${JSON.stringify(line)}\n`).join(""), "application/x-ndjson; charset=utf-8");
    return client.post("/study", {}, { progressed: (share) => told.push(share) })
      .finally(() => assert.match(calls[0].options.headers.accept, /x-ndjson/));
  };
  assert.deepEqual(await asked({ progress: 0.25 }, { progress: 1 }, { result: { samples: 4 } }), { samples: 4 });
  assert.deepEqual(told, [0.25, 1]);
  const problem = { status: 422, title: "no", detail: "too many", errors: [{ pointer: "/samples", code: "service_limit" }] };
  await assert.rejects(asked({ problem }), (error) => error instanceof Problem && error.status === 422 && error.errors.length === 1);
  await assert.rejects(asked({ progress: 0.5 }), (error) => error instanceof Problem && error.status === 0);
  const plain = answering(200, { samples: 4 }).client;
  assert.deepEqual(await plain.post("/study", {}, { progressed() {} }), { samples: 4 });
});

const later = (milliseconds, value) => new Promise((resolve) => setTimeout(resolve, milliseconds, value));

test("a newer request aborts the older, whose late answer counts for nothing", async () => {
  const newest = newestOnly();
  let aborted = false;
  const first = newest.ask((signal) => {
    signal.addEventListener("abort", () => { aborted = true; });
    return later(20, "old"); // does not heed its signal
  });
  const second = newest.ask(() => later(5, "new"));
  assert.equal((await second).answer, "new");
  assert.equal((await first).superseded, true);
  assert.ok(aborted);
});

test("an abort is silent, a problem is told, another fault is thrown", async () => {
  const newest = newestOnly();
  const waiting = newest.ask((signal) => new Promise((_, reject) => {
    signal.addEventListener("abort", () => reject(new DOMException("aborted", "AbortError")));
  }));
  newest.cancel();
  assert.equal((await waiting).superseded, true);
  const problem = new Problem({ status: 422 });
  assert.equal((await newest.ask(async () => { throw problem; })).problem, problem);
  await assert.rejects(newest.ask(async () => { throw new TypeError("a bug"); }), TypeError);
});

test("a file comes with its name, and why there is none as a problem", async () => {
  const headers = { "content-disposition": 'attachment; filename="ring_pins.dxf"' };
  const { calls, client } = answering(200, "0\nEOF\n", "image/vnd.dxf", headers);
  const { name, content } = await client.file("/export/dxf", { parts: ["ring_pins"] });
  assert.deepEqual([name, content.type, await content.text()], ["ring_pins.dxf", "image/vnd.dxf", "0\nEOF\n"]);
  assert.equal(calls[0].options.body, '{"parts":["ring_pins"]}');
  const errors = [{ pointer: "/design/contact", code: "needed_to_draw", params: {} }];
  const refused = answering(422, { status: 422, errors }, "application/problem+json").client;
  await assert.rejects(refused.file("/export/dxf", {}), (problem) => problem instanceof Problem && problem.errors[0].pointer === "/design/contact");
});

test("what is asked aside waits for all else, gives way to it, is asked again, and ends with its signal", async () => {
  const sent = [];
  const fetch = (url, { signal }) => new Promise((resolve, reject) => {
    sent.push({ url, signal, done: () => resolve(new Response("{}", { status: 200 })) });
    signal?.addEventListener("abort", () => reject(signal.reason));
  });
  const until = async (count) => {
    while (sent.length < count) await later(10);
  };
  const client = createClient({ base: "", fetch });
  const stop = new AbortController();
  const main = client.post("/main", {});
  const found = client.post("/fixes", {}, { signal: stop.signal, aside: true });
  await later(300);
  assert.deepEqual(sent.map(({ url }) => url), ["./main"]);
  sent[0].done();
  await main;
  await until(2);
  const drawing = client.file("/dxf", {});
  assert.ok(sent[1].signal.aborted && sent[2].url === "./dxf");
  await later(300);
  assert.equal(sent.length, 3);
  sent[2].done();
  await drawing;
  await until(4);
  assert.equal(sent[3].url, "./fixes");
  sent[3].done();
  assert.deepEqual(await found, {});
  const ended = client.post("/fixes", {}, { signal: stop.signal, aside: true });
  await until(5);
  stop.abort();
  await assert.rejects(ended, { name: "AbortError" });
  assert.ok(sent[4].signal.aborted);
});
