/** The REST service as promises. The only module that calls `fetch`. No DOM. */

const LINES = "application/x-ndjson";
const ASIDE_MS = 250; // how often what waits for all else looks whether it may be asked
const KINDS = { 500: "failure", 502: "unavailable", 503: "unavailable", 504: "unavailable" }; // of answers that are not the service's own

/** What the service (or the way to it) refused: RFC 9457, with the pointers of the wrong fields. */
export class Problem extends Error {
  constructor({ status = 0, kind = "", title = "", detail = "", errors = [], where = {}, wait = 0 }) {
    super(detail || title);
    // `wait`: ms, before which the service asks not to be asked again
    Object.assign(this, { name: "Problem", status, kind, title, detail, errors, where, wait });
  }

  /** Whether it may be gone when the same is asked again: no service, or one that is busy; what takes too long or fails would again. */
  get passing() {
    return this.status === 0 || this.kind === "unavailable";
  }
}

function problemFrom(body, status, title, wait) {
  return new Problem({
    status,
    kind: body.type?.split("/").pop() ?? KINDS[status],
    title: body.title ?? title,
    detail: body.detail ?? "",
    errors: Array.isArray(body.errors) ? body.errors : [],
    where: body.where,
    wait,
  });
}

async function problemOf(response) {
  const kind = response.headers.get("content-type") ?? "";
  const body = kind.includes("json") ? await response.json().catch(() => ({})) : {};
  const seconds = Number(response.headers.get("retry-after"));
  return problemFrom(body, response.status, response.statusText, Number.isFinite(seconds) ? 1000 * seconds : 0);
}

/** What a stream of lines ends with: the answer, or the problem thrown; `progressed(share, found)` is told on the way, with what a line says besides. */
async function lastOf(body, progressed) {
  const reader = body.pipeThrough(new TextDecoderStream()).getReader();
  for (let rest = ""; ;) {
    const { value, done } = await reader.read();
    const lines = (rest + (value ?? "")).split("\n");
    rest = done ? "" : lines.pop();
    for (const line of lines.filter((one) => one.trim() !== "")) {
      const { progress, result, problem, ...found } = JSON.parse(line);
      if (problem) throw problemFrom(problem, problem.status, "");
      if (result) return result;
      if (progress !== undefined) progressed(progress, found);
    }
    if (done) throw new Problem({ title: "unreachable" }); // it ended before its end
  }
}

/** What an answer says, as JSON or as lines. */
function saidBy(response, progressed) {
  const lines = (response.headers?.get("content-type") ?? "").includes(LINES);
  return lines ? lastOf(response.body, progressed) : response.json();
}

/** A file that is answered, with its name. */
async function fileOf(response) {
  const [, name] = /filename="([^"]+)"/.exec(response.headers.get("content-disposition") ?? "") ?? [];
  return { name, content: await response.blob() };
}

/**
 * `get(path)` and `post(path, body, { signal, query })` below `base`, which is below the page; with `progressed(share, found)`
 * the answer may come as lines that say how far it is and what was found; what is posted `aside` waits for all else that is posted, gives way
 * to it, and is asked again. `file(path, body, type)` answers `{ name, content }`.
 */
export function createClient({ base = "/api/v1", fetch = globalThis.fetch } = {}) {
  async function ask(path, options, read = saidBy) {
    try {
      const response = await fetch(`.${base}${path}`, options);
      if (!response.ok) throw await problemOf(response);
      return await read(response);
    } catch (error) {
      if (error instanceof Problem || error.name === "AbortError") throw error;
      throw new Problem({ title: "unreachable" });
    }
  }
  let waiting = 0; // posts that somebody waits for
  let giveWay = null; // ends what is asked aside

  /** Asked at once; what is asked aside gives way to it. */
  async function first(asked) {
    waiting += 1;
    giveWay?.abort();
    try {
      return await asked();
    } finally {
      waiting -= 1;
    }
  }

  /** Asked once nobody waits for anything else, and anew where it had to give way. */
  async function aside(asked, signal) {
    for (;;) {
      await new Promise((resolve) => { setTimeout(resolve, ASIDE_MS); });
      signal.throwIfAborted();
      if (waiting > 0) continue;
      const way = new AbortController();
      giveWay = way;
      signal.addEventListener("abort", () => way.abort(), { signal: way.signal });
      try {
        return await asked(way.signal);
      } catch (error) {
        if (signal.aborted || error.name !== "AbortError") throw error;
      }
    }
  }

  const sending = (body, accept, signal) => ({
    method: "POST",
    signal,
    headers: { accept, "content-type": "application/json" },
    body: JSON.stringify(body),
  });
  return {
    base,
    get: (path) => ask(path), // without headers: so it takes what the page's head has asked for
    post(path, body, { signal, query, progressed, aside: waits } = {}) {
      const asked = (until = signal) => ask(
        query ? `${path}?${new URLSearchParams(query)}` : path,
        sending(body, progressed ? `${LINES}, application/json` : "application/json", until),
        (response) => saidBy(response, progressed),
      );
      return waits ? aside(asked, signal) : first(asked);
    },
    file: (path, body, type = "*/*") => first(() => ask(path, sending(body, type), fileOf)),
  };
}

/**
 * Let only the newest request answer. A new `ask` aborts the one before; what was superseded
 * settles as `{ superseded: true }`, whether its abort was heeded or its answer came too late.
 */
export function newestOnly() {
  let newest = 0;
  let controller = null;
  return {
    async ask(request) {
      controller?.abort();
      controller = new AbortController();
      const id = ++newest;
      try {
        const answer = await request(controller.signal);
        return id === newest ? { id, answer } : { id, superseded: true };
      } catch (problem) {
        if (id !== newest) return { id, superseded: true };
        if (!(problem instanceof Problem)) throw problem;
        return { id, problem };
      }
    },
    cancel() {
      newest += 1;
      controller?.abort();
      controller = null;
    },
  };
}
