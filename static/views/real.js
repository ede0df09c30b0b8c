/** The mechanism as it is made: its numbers, its figure, and why a larger hole changes them. */
import { element, fill, html } from "../lib/html.js";
import { arrow, circle, label, line, paper } from "../lib/svg.js";
import { message } from "../messages/index.js";
import { warningText } from "../service_texts.js";
import { following } from "../store.js";
import { createFigure } from "./figure.js";
import { sign } from "./parts.js";

const HEIGHT = 920;
const NONE = []; // no kept design is drawn over it

/** A pin in a hole larger than it needs, not to scale. */
function largerHole() {
  const [pin, e, c] = [46, 34, 16];
  const [centre, hole] = [[150, 140], [150, 140 - e]];
  const foot = (radius, from) => [from[0], from[1] + radius];
  return paper(300, 222, [
    circle(hole, pin + e + c, "hole"), circle(hole, pin + e, "touching"), circle(centre, pin, "pin"),
    line([150, 2], [150, 220], "axis"),
    arrow(hole, [hole[0] + (pin + e + c) * 0.8, hole[1] - (pin + e + c) * 0.6], "size"), label([hole[0] + 62, hole[1] - 24], "r_out"),
    arrow(centre, [centre[0] - pin * 0.8, centre[1] + pin * 0.6], "size"), label([centre[0] - 28, centre[1] + 4], "r_in"),
    circle(hole, 2.5, "dot"), circle(centre, 2.5, "dot"), label([140, (hole[1] + centre[1]) / 2 + 4], "e", { anchor: "end" }),
    line(foot(pin, centre), foot(pin + e + c, hole), "gap"), label([160, 140 + pin + c / 2 + 5], "c", { anchor: "start" }),
  ]);
}

export function createView({ id, client, titles, figures, logic, asking }) {
  const root = element(html`
    <div class="real"><p class="state"></p>
      <dl class="numbers"></dl><ul class="sentences"></ul>
      <table class="quantities"><tbody></tbody></table>
      <details class="more"><summary>${message("real.why")}</summary><div class="larger">
        <div class="sketch" role="img" aria-label="${message("real.largerLabel")}"></div>
        <div>${message("real.larger").map((text) => html`<p>${text}</p>`)}</div></div></details>
    </div>`);
  fill(root.querySelector(".sketch"), largerHole());
  const part = (name) => root.querySelector(name);
  const figure = createFigure({
    figure: { id: "real", section: "real", path: "/load-sharing/chart", body: logic.drawn, shape: logic.shaped, height: HEIGHT },
    client,
    titles,
    on: {
      charted() {}, turned() {}, set() {}, picked() {},
    },
  });
  root.querySelector(".more").before(figure.root, element(html`<p class="figure-note">${message("real.lines")}</p>`));
  figures.push(figure);
  let drawn = {}; // of the figure: the body, and the results in the shape that it takes

  const numbers = following(({ answer, of }) => [answer, of], ({ answer, body }) => {
    if (!answer) return;
    fill(part(".numbers"), html`${logic.cells(answer).map((cell) => html`
      <div class="cell"><dt>${cell.label}</dt><dd><span class="figures">${cell.value}</span><span class="note">${cell.note}</span></dd></div>`)}`);
    const all = [
      ...logic.sentences(answer, body.mechanism),
      ...(answer.warnings ?? []).map((warning) => ["warning", warningText(warning, titles)]),
    ];
    fill(part(".sentences"), html`${all.map(([level, text]) => html`<li>${sign(level)}${text}</li>`)}`);
    fill(part(".quantities tbody"), html`${logic.rows(answer, body).map(([title, value]) => html`
      <tr><th scope="row">${title}</th><td class="value">${value}</td></tr>`)}`);
  });

  return {
    root,
    update(state) {
      const now = state.besides[id] ?? {};
      const { phase = "computing", answer, body, refusal, typed } = now;
      root.dataset.stale = String(phase !== "fresh" || typed !== state.typed);
      root.dataset.state = phase;
      const older = typed !== state.typed && state.phase !== "computing" && answer;
      part(".state").textContent = older ? message("besides.older")
        : { computing: message("state.computing"), refused: refusal?.text, failed: refusal?.text }[typed === state.typed ? phase : state.phase] ?? "";
      part(".state").classList.toggle("bad", phase === "refused" || phase === "failed");
      numbers({ ...now, body: body ?? {} });
      // Its figure, which takes longest, comes behind the results.
      if (body && drawn.body !== body && state.phase !== "computing") drawn = { body, shown: { input: body, filled: body, answer: { real: true } } };
      figure.update({ ...state, pending: drawn.body ?? null, shown: drawn.shown ?? null, kept: NONE, refusal: null });
    },
    close() {
      figure.close();
    },
  };
}
