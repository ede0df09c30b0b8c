/**
 * Asking the service for a group that is off until wanted, `about` of the calculator's `wanted`: a `live` one after
 * every answer, another when it is run. Loaded when the first is switched on.
 *
 * `logic.asked(input, filled)` is what the boxes ask, without the service; `logic.bodyOf(asked, client)` the body of the
 * request, and `logic.ask({ client, body, signal, progressed })` its answer.
 */
import { newestOnly } from "./lib/api.js";
import { besided, refusedBesides, wants } from "./store.js";

export function createBeside({ store, client, id, logic }) {
  const newest = newestOnly();
  let asked = null; // the state's `shown` after which a live group was asked

  async function ask() {
    const { typed, reading: { input, filled, besides } } = store.state;
    if (besides[id].length > 0) {
      newest.cancel();
      store.apply(besided, id, { typed, phase: "incomplete", refusal: null });
      return;
    }
    const request = JSON.stringify(logic.asked(input, filled));
    const { answer: known, of, phase } = store.state.besides[id] ?? {};
    if (known && of === request && (logic.live || phase === "fresh")) {
      newest.cancel();
      store.apply(besided, id, { typed, request, phase: "fresh", refusal: null });
      return;
    }
    store.apply(besided, id, { typed, request, phase: "computing", progress: undefined, refusal: null });
    const { answer, problem, superseded } = await newest.ask(async (signal) => {
      const body = await logic.bodyOf(JSON.parse(request), client);
      if (!signal.aborted) store.apply(besided, id, { body });
      return logic.ask({ client, body, signal, progressed: (progress) => signal.aborted || store.apply(besided, id, { progress }) });
    });
    if (superseded) return;
    if (problem) store.apply(refusedBesides, id, problem);
    else store.apply(besided, id, { answer, of: request, phase: "fresh" });
  }

  return {
    ask,
    stop() {
      newest.cancel();
      store.apply(besided, id, { phase: "stopped" });
    },
    cancel: () => newest.cancel(),
    /** Follow what is shown: a live group is of the same inputs. */
    update(state) {
      const { shown, phase, typed } = state;
      if (!wants(state, id)) {
        if (asked) newest.cancel();
        asked = null;
      } else if (logic.live && shown !== asked && shown?.typed === typed && phase === "fresh") {
        asked = shown;
        ask();
      }
    },
  };
}
