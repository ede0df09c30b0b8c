/** The verdict in plain words, and of every warning, or what a check says in its place, what it tests, why it matters, how to mend it. */
import { judgedOf } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { codesOf, levelOf } from "../lib/verdict.js";
import { message } from "../messages/index.js";
import { explained } from "../service_texts.js";
import { following } from "../store.js";
import { remembering } from "./fold.js";
import { sentencesMarkup, sign } from "./parts.js";

function warningMarkup(code) {
  const words = explained(code);
  const part = (name) => html`<div><dt>${message(`words.${name}`)}</dt><dd>${words[name]}</dd></div>`;
  return html`<li class="explained ${levelOf(code)}" data-code="${code}">
    <h3>${sign(levelOf(code))}${words.title}</h3>
    <dl>${["tests", "why", "mend"].map(part)}</dl></li>`;
}

export function createExplanation({ calculator, materialOf }) {
  const title = message("words.title");
  const root = remembering(element(html`<details class="card fold plain-words"><summary><h2>${title}</h2></summary><div></div></details>`), "words");
  const host = root.querySelector("div");
  return {
    root,
    update: following(({ shown }) => [shown], ({ shown }) => {
      if (!shown) return;
      const sentences = calculator.sentences(shown.answer, { input: shown.filled, materialOf }).filter(Boolean);
      const codes = codesOf(shown.answer, judgedOf(calculator, shown.answer)?.checks).filter(explained); // not of a newer service
      fill(host, html`<ul class="sentences">${sentencesMarkup(sentences)}</ul>
        ${codes.length > 0 && html`<ul class="explanations">${codes.map(warningMarkup)}</ul>`}`);
    }),
  };
}
