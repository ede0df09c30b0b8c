/** What a calculator asks the service for: its sections, each request sent once. */
import { Problem } from "./api.js";

/** Posts that are sent once, however often they are asked for; `done` gathers what was answered. */
export function postingOnce(client, signal, done = []) {
  const answers = new Map();
  return (path, body) => {
    const key = `${path} ${JSON.stringify(body)}`;
    if (!answers.has(key)) {
      answers.set(key, client.post(path, body, { signal }).then((answer) => {
        done.push({ path: client.base + path, body, answer });
        return answer;
      }));
    }
    return answers.get(key);
  };
}

/** Ask for all sections; where the service refuses, for those that do not need the refused one. */
export async function askSections({ client, calculator, input, tables, signal }) {
  const requests = [];
  const post = postingOnce(client, signal, requests);
  let refusal = null;
  for (let count = calculator.sections.length; count > 0; count -= 1) {
    const sections = calculator.sections.slice(0, count);
    try {
      return { answer: await calculator.ask({ post, input, sections, tables }), refusal, requests };
    } catch (problem) {
      if (!(problem instanceof Problem) || problem.status !== 422) throw problem;
      refusal ??= problem;
    }
  }
  return { answer: null, refusal };
}
