/** The verdict in plain words, and of every warning what it tests, why it matters, how to mend it. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { IMPOSSIBLE } from "../worked/contact.js";
import { sentencesOf } from "../worked/sentences.js";

const SIGNS = { good: "✓", bad: "✕", warning: "▲" };

function sentence([level, text]) {
  return html`<li>${SIGNS[level] && html`<span class="sign ${level}" aria-hidden="true">${SIGNS[level]}</span>`}${text}</li>`;
}

function warningMarkup(code) {
  const level = IMPOSSIBLE.includes(code) ? "bad" : "warning";
  const part = (name) => html`<div><dt>${message(`words.${name}`)}</dt><dd>${message(`warnings.${code}.${name}`)}</dd></div>`;
  return html`<li class="explained ${level}" data-code="${code}">
    <h3><span class="sign ${level}" aria-hidden="true">${SIGNS[level]}</span>${message(`warnings.${code}.title`)}</h3>
    <dl>${["tests", "why", "mend"].map(part)}</dl></li>`;
}

export function createWords({ calculator, materialOf }) {
  const title = message("words.title");
  const root = element(html`<section class="card plain-words" aria-label="${title}"><h2>${title}</h2><div></div></section>`);
  const host = root.querySelector("div");
  return {
    root,
    update(input, answer, warnings) {
      const codes = [...new Set(warnings.map(({ code }) => code))];
      fill(host, html`<ul class="sentences">${sentencesOf(calculator.id, answer, { input, materialOf }).map(sentence)}</ul>
        ${codes.length > 0 && html`<ul class="explanations">${codes.map(warningMarkup)}</ul>`}`);
    },
  };
}
