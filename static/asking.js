/** Asking the service for results: 50 ms after the last key or at once, the newest request only. */
import { newestOnly, Problem } from "./lib/api.js";
import { readState, stateFromInput } from "./lib/form_state.js";
import { isLimited, isMended, judgedOf, usuallyOf } from "./lib/checks.js";
import { answered, asked, compared, failed, limited, mended, withUsual } from "./store.js";

const DEBOUNCE_MS = 50;
const AGAIN_MS = [1000, 2000, 4000, 8000]; // after a failure of the service; the last from then on

/** Posts that are sent once, however often they are asked for; `done` gathers what was answered; `aside`, after all else. */
function postingOnce(client, signal, done = [], aside = false) {
  const answers = new Map();
  return (path, body) => {
    const key = `${path} ${JSON.stringify(body)}`;
    if (!answers.has(key)) {
      answers.set(key, client.post(path, body, { signal, aside }).then((answer) => {
        done.push({ path: client.base + path, body, answer });
        return answer;
      }));
    }
    return answers.get(key);
  };
}

/** Ask for all sections; where the service refuses, for those that do not need the refused one. */
async function askSections({ client, calculator, input, filled, tables, signal }) {
  const requests = [];
  const post = postingOnce(client, signal, requests);
  let refusal = null;
  for (let count = calculator.sections.length; count > 0; count -= 1) {
    const sections = calculator.sections.slice(0, count);
    try {
      return { answer: await calculator.ask({ post, input, filled, sections, tables }), refusal, requests };
    } catch (problem) {
      if (!(problem instanceof Problem) || problem.status !== 422) throw problem;
      refusal ??= problem;
    }
  }
  return { answer: null, refusal };
}

/** `designs` are the kept ones (lib/designs.js). */
export function createAsking({ store, client, designs }) {
  const { model, calculator } = store.state.about;
  const newest = newestOnly();
  const further = newestOnly();
  const answers = new Map(); // of the designs that are kept, by their inputs
  let timer = 0;
  let failures = 0;
  let settled = Promise.resolve(); // the question for the largest torque
  let comparison = 0; // how often it was asked for: an earlier one does not come after a later

  function answerOf(input) {
    const key = JSON.stringify(input);
    if (!answers.has(key)) {
      const { filled } = readState(model, stateFromInput(model, input));
      answers.set(key, askSections({ client, calculator, input, filled, tables: new Set() })
        .then(async (found) => ({ ...found, answer: found.answer && { ...found.answer, ...await limitOf(found.answer, input) } }))
        .catch((problem) => {
          if (!problem.passing) return { answer: null };
          answers.delete(key); // asked for again with the next answer of the service
          return { answer: undefined };
        }));
    }
    return answers.get(key);
  }

  /** What an answer says of the largest torque of a design that is kept. */
  async function limitOf(answer, input) {
    if (!isLimited(calculator, answer)) return {};
    const { torque_reserve, largest_torque_Nm, largest_torque_of } = await calculator.mend({ post: postingOnce(client), input, include: calculator.limit }).catch(() => ({}));
    return largest_torque_Nm === undefined ? {} : { torque_reserve, largest_torque_Nm, largest_torque_of };
  }

  /** The designs kept of this calculator, each with its answer and what was asked for it: null where it was refused, undefined where it was not to be had. */
  async function compare() {
    const asked = comparison += 1;
    const kept = await Promise.all(designs.of(calculator.id)
      .map(async (design) => {
        const { answer, requests } = await answerOf(design.input);
        return { ...design, answer, requests };
      }));
    if (asked === comparison) store.apply(compared, kept);
  }

  function cancel() {
    clearTimeout(timer);
    newest.cancel();
    further.cancel();
  }

  /** After all that somebody waits for, one after the other: the largest torque of the design that is shown, what mends it, what becomes of it with what is usual. */
  async function lookFurther(shown) {
    const look = (own) => further.ask((signal) => calculator.mend({ post: postingOnce(client, signal, [], true), ...own, ...shown }));
    if (isLimited(calculator, shown.answer)) {
      settled = look({ include: calculator.limit });
      const { answer = {}, superseded } = await settled;
      if (superseded) return;
      store.apply(limited, shown, answer);
    }
    if (isMended(calculator, shown.answer)) {
      const { answer = {}, problem, superseded } = await look();
      if (superseded) return;
      store.apply(mended, shown, [answer.combined ?? [], judgedOf(calculator, answer)?.fixes ?? []].flat(), problem ? problem.kind === "too-long" || null : Boolean(answer.untried));
    }
    const include = usuallyOf(calculator, shown.answer);
    if (include.length === 0) return;
    const found = await look({ include: [...include, ...calculator.limit ?? []] });
    const { answer = {}, superseded } = found.problem?.kind === "too-long" ? await look({ include }) : found;
    if (!superseded) store.apply(withUsual, shown, answer);
  }

  async function now() {
    cancel();
    store.apply(asked);
    const { reading: { input, filled, wrong }, tables } = store.state;
    if (wrong.length > 0) {
      if (!store.state.kept) compare();
      return;
    }
    const { answer, problem, superseded } = await newest.ask((signal) =>
      askSections({ client, calculator, input, filled, tables, signal }));
    if (superseded) return;
    if (problem) {
      store.apply(failed, problem);
      if (problem.passing) timer = setTimeout(now, Math.max(problem.wait, AGAIN_MS[Math.min(failures, AGAIN_MS.length - 1)]));
      failures += 1;
      return;
    }
    failures = 0;
    store.apply(answered, answer);
    if (answer.answer) lookFurther(store.state.shown);
    const { shown, kept } = store.state;
    if (shown && (!kept || kept.some((design) => design.answer === undefined))) compare();
  }

  return {
    now,
    soon() {
      cancel();
      timer = setTimeout(now, DEBOUNCE_MS);
    },
    cancel,
    compare,
    /** Once the largest torque is known that was asked for. */
    settled: () => settled,
    /** The tables of a figure that has its own, of the results on the screen. */
    async tables(figure) {
      const { input, filled, answer } = store.state.shown;
      const sections = calculator.sections.filter((id) => answer[id]);
      return figure.tables(await calculator.ask({
        post: postingOnce(client), input, filled, sections, tables: new Set([figure.id]),
      }));
    },
  };
}
