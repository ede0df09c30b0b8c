/**
 * Asking the service for a group that is off until wanted, or that `shows` by itself: a `live` one beside the results,
 * another when it is run. Loaded when the first is shown.
 *
 * `logic.asked(input)` is the body of the request, `logic.ask({ client, body, signal, progressed })` its answer; on the
 * way `progressed(share, part)` tells how far it is, and a part of the group's state.
 */
import { newestOnly } from "./lib/api.js";
import { besided, refusedBesides, wants } from "./store.js";

const AGAIN_MS = 4000; // until a live group that the service could not answer asks again

export function createBeside({ store, client, id, logic, shows = (state) => wants(state, id) }) {
  const newest = newestOnly();
  let again = 0; // the timer after a failure of the service
  let asked = null; // the inputs or the results with which a live group was asked

  async function ask() {
    clearTimeout(again);
    const { typed, reading } = store.state;
    const { input, besides } = reading;
    if (besides[id]?.length > 0) {
      newest.cancel();
      store.apply(besided, id, { typed, phase: "incomplete", refusal: null });
      return;
    }
    const request = JSON.stringify(logic.asked(input));
    const { answer: known, of, phase, request: sent } = store.state.besides[id] ?? {};
    if (logic.live && sent === request && ["computing", "refused"].includes(phase)) {
      store.apply(besided, id, { typed });
      return;
    }
    if (known && of === request && (logic.live || phase === "fresh")) {
      newest.cancel();
      store.apply(besided, id, { typed, request, phase: "fresh", refusal: null });
      return;
    }
    const body = JSON.parse(request);
    store.apply(besided, id, { typed, request, body, phase: "computing", progress: undefined, refusal: null });
    const { answer, problem, superseded } = await newest.ask((signal) =>
      logic.ask({ client, body, signal, progressed: (progress, part) => signal.aborted || store.apply(besided, id, { progress, ...part }) }));
    if (superseded) return;
    if (!problem) {
      store.apply(besided, id, { answer, of: request, phase: "fresh" });
      return;
    }
    store.apply(refusedBesides, id, problem, logic.live);
    if (logic.live && problem.passing) again = setTimeout(() => store.state.reading === reading && ask(), Math.max(problem.wait, AGAIN_MS));
  }

  function cancel() {
    clearTimeout(again);
    newest.cancel();
  }

  return {
    ask,
    stop() {
      cancel();
      store.apply(besided, id, { phase: "stopped" });
    },
    cancel,
    /** Follow what is asked: a live group is of the same inputs; what was not to be had is asked for again with the results. */
    update(state) {
      const { shown, phase, pending, reading: { filled } } = state;
      const now = { computing: pending, fresh: shown }[phase];
      if (!shows(state)) {
        if (asked) cancel();
        asked = null;
      } else if (logic.live && now && now !== asked && pending === filled) {
        asked = now;
        ask();
      }
    },
  };
}
