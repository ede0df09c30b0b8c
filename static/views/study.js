/** What tolerances do: the study is run by a button, and its numbers stay, marked where they are of earlier inputs. */
import { formatQuantity } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { warningSentences } from "../service_texts.js";
import { following, hinderedBesides } from "../store.js";
import { sentencesMarkup } from "./parts.js";
import { createRun } from "./run.js";

const [WIDTH, HEIGHT] = [600, 150];

const px = (share, of) => (share * of).toFixed(2);

/** The histogram as bars, the marks as lines across it; what these are stands in the table beside it. */
function histogramMarkup({ title, unit, histogram, marks }, barsOf) {
  const { low, high, bars, marks: lines } = barsOf(histogram, marks);
  const label = message("study.histogram", { quantity: title, marks: marks.map((mark) => `${mark.title} ${mark.value}`).join("; ") });
  return html`<div class="histogram" role="img" aria-label="${label}">
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
      ${bars.map(({ x, width, height }) => html`<rect x="${px(x, WIDTH)}" y="${px(1 - 0.95 * height, HEIGHT)}" width="${px(width, WIDTH)}" height="${px(0.95 * height, HEIGHT)}"/>`)}
      ${lines.map(({ id, x }, i) => html`<line class="mark-${id === "limit" || id === "nominal" ? id : i}" x1="${px(x, WIDTH)}" x2="${px(x, WIDTH)}" y1="0" y2="${HEIGHT}"/>`)}
    </svg><p class="ends" aria-hidden="true"><span>${formatQuantity(low, unit)}</span><span>${formatQuantity(high, unit)}</span></p></div>`;
}

function quantityMarkup(quantity, barsOf) {
  return html`<section class="studied" data-quantity="${quantity.name}"><h3>${quantity.title}</h3>
    ${quantity.histogram && histogramMarkup(quantity, barsOf)}
    <table class="data"><thead class="unseen"><tr><td></td><th scope="col">${message("results.value")}</th><th scope="col">${message("study.interval")}</th></tr></thead>
      <tbody>${quantity.marks.map(({ id, title, value, interval }, i) => html`<tr>
        <th scope="row"><svg class="key" viewBox="0 0 24 8" aria-hidden="true"><line class="mark-${id === "limit" || id === "nominal" ? id : i}" x1="0" x2="24" y1="4" y2="4"/></svg>${title}</th>
        <td>${value}</td><td class="note">${interval}</td></tr>`)}</tbody></table></section>`;
}

function rankedMarkup(title, rows) {
  if (rows.length === 0) return "";
  return html`<section class="ranked"><h3>${message("study.contributions", { quantity: title })}</h3>
    <div class="grid-rows" tabindex="0" role="region" aria-label="${message("study.contributions", { quantity: title })}"><table class="data">
    <thead><tr>${["source", "total", "alone"].map((name) => html`<th scope="col">${message(`study.${name}`)}</th>`)}
      <th scope="col">${rows[0].percent === undefined ? message("study.fitWithout") : message("study.without", { percent: rows[0].percent })}</th></tr></thead>
    <tbody>${rows.map(({ title: source, total, text, alone, without }) => html`<tr><th scope="row">${source}
      <svg class="share" viewBox="0 0 100 6" preserveAspectRatio="none" aria-hidden="true"><rect class="whole" width="100" height="6"/><rect width="${px(Math.min(total, 1), 100)}" height="6"/></svg></th>
      <td>${text}</td><td>${alone}</td><td>${without}</td></tr>`)}</tbody></table></div></section>`;
}

export function createView({ id, logic, asking, open, titles }) {
  const root = element(html`<div class="study"><p class="state" tabindex="-1">${message("study.idleYet")}</p><button type="button" class="primary" data-do="begin">${message("study.run")}</button><div class="outcome"></div></div>`);
  const run = createRun({
    run: message("study.run"), stop: message("study.stop"), running: message("study.running"), idle: message("study.idleYet"),
    on: {
      run() {
        open(); // there its results come
        asking.ask();
      },
      stop: () => asking.stop(),
    },
  });
  const line = root.querySelector(".state");
  const here = root.querySelector("[data-do=begin]"); // until there are results, which say more
  here.addEventListener("click", () => asking.ask());
  const see = element(html`<button type="button" class="link" data-do="see" hidden>${message("study.see")}</button>`);
  run.root.querySelector("progress").before(see);
  see.addEventListener("click", () => {
    open();
    root.closest("section").scrollIntoView();
  });

  const outcome = following(({ answer }) => [answer], ({ answer, body }) => {
    if (!answer) return;
    const [first] = Object.entries(answer.quantities);
    const names = body.quantities ?? Object.keys(answer.quantities);
    const [leading] = names;
    const of = answer.quantities[leading] ?? first[1];
    const words = [...logic.advice(leading, of), ...logic.exactness(leading, of, answer), ...warningSentences(answer, titles)];
    fill(root.querySelector(".outcome"), html`
      <ul class="sentences">${sentencesMarkup(words)}</ul>
      <div class="studies">${Object.entries(answer.quantities).map(([name, one]) => quantityMarkup(logic.quantityOf(name, one), logic.barsOf))}</div>
      ${rankedMarkup(logic.titleOf(leading), logic.ranked(leading, of))}
      ${rankedMarkup(message("study.fit"), logic.rankedFit(answer))}`);
  });

  return {
    root,
    /** What starts and stops it, for the form. */
    controls: run.root,
    update(state) {
      const now = state.besides[id] ?? {};
      const { phase, progress, answer, body, of, refusal } = now;
      const running = phase === "computing";
      const { reading: { input } } = state;
      const older = Boolean(answer) && JSON.stringify(logic.asked(input)) !== of;
      if (phase) root.dataset.begun = "true";
      const words = {
        computing: progress === undefined ? message("study.running") : message("study.done", { percent: Math.round(100 * progress) }),
        incomplete: message("besides.needed", { fields: hinderedBesides(state, id) }),
        stopped: message("besides.stopped"), refused: refusal?.text, failed: refusal?.text,
      }[phase] ?? (answer ? "" : message("study.idleYet"));
      see.hidden = !answer || running;
      const held = document.activeElement === here; // a button that is hidden would lose it
      here.hidden = Boolean(answer) || running;
      if (held && here.hidden) line.focus();
      const text = [words, older && message("besides.older")].filter(Boolean).join(" ");
      run.update(now, text, message(answer && !older ? "study.again" : "study.run"));
      line.textContent = text;
      line.classList.toggle("bad", phase === "refused" || phase === "failed");
      root.querySelector(".outcome").dataset.stale = String(older || running);
      outcome({ answer, body: body ?? {} });
    },
    close() {},
  };
}
