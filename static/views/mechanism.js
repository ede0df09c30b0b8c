/**
 * The drawing of a calculator, and what moves it: a slider, play and pause, the pair selected.
 * What stands still has the drawing alone.
 */
import { formatQuantity } from "../format.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { download } from "./download.js";
import { pngOf, svgOf } from "./picture.js";

const TURN_MS = 12_000;
const STEPS = 720; // of the slider
const PAPER = matchMedia("print"); // there the drawing of the screen is scaled
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

/** `on.moved(angle)` and `on.selected(pair)` let the figures follow. */
export function createMechanism({ calculator, on }) {
  const { load, moving } = calculator.drawing;
  const title = message(`drawing.${calculator.id}`);
  const root = element(html`
    <section class="card mechanism" data-drawing="${calculator.id}" aria-labelledby="mechanism-title">
      <div class="head"><h2 id="mechanism-title">${title}</h2><span class="figure-tools">
        ${["PNG", "SVG"].map((kind) => html`<button type="button" class="toggle save" data-kind="${kind}"
          aria-label="${message("figure.save", { title, kind })}">${kind}</button>`)}</span></div>
      ${moving && html`<div class="motion">
        ${!STILL.matches && html`<button type="button" class="toggle play" aria-pressed="false">${message("drawing.play")}</button>`}
        <input type="range" min="0" max="360" step="0.5" value="0" aria-label="${message("figure.crankAngle")}">
        <output></output>
        <label for="pair">${message("drawing.select")}</label>
        <select id="pair" class="box"><option value="">${message("drawing.all")}</option></select>
      </div>`}
      <div class="drawing" role="img" aria-label="${message(`drawing.${calculator.id}Label`)}"></div>
      <p class="scale"></p>
    </section>`);
  const views = root.querySelector(".drawing");
  const controls = root.querySelectorAll(".save, .motion button, .motion input, .motion select");
  const scale = root.querySelector(".scale");
  const slider = root.querySelector("input");
  const shown = root.querySelector("output");
  const play = root.querySelector(".play");
  const choice = root.querySelector("select");
  let latest = null; // { input, answer, curves } to be drawn
  let createDrawing = null;
  let drawing = null;
  let moves = null; // the drawing on the page, where it moves
  let lit = null; // path of the field whose parts are lit
  let size = { width: 0, height: 0 }; // of its place on the screen
  let end = 360;
  let angle = 0;
  let playing = 0; // the frame asked for, or 0
  let pair = "";

  function move(next) {
    angle = Math.min(next, end);
    const text = `φ = ${formatQuantity(angle, "°", 4)}`;
    slider.value = String(angle);
    slider.setAttribute("aria-valuetext", text);
    shown.textContent = text;
    moves?.move(angle, pair || null);
    on.moved(angle);
  }

  function stop() {
    if (!moving) return;
    cancelAnimationFrame(playing);
    playing = 0;
    slider.step = String(end / STEPS);
    play?.setAttribute("aria-pressed", "false");
    if (play) play.textContent = message("drawing.play");
  }

  function start() {
    let last = performance.now();
    slider.step = "any";
    const frame = (time) => {
      move((angle + (360 * Math.max(0, time - last)) / TURN_MS) % end);
      last = time;
      playing = requestAnimationFrame(frame);
    };
    playing = requestAnimationFrame(frame);
    play.setAttribute("aria-pressed", "true");
    play.textContent = message("drawing.pause");
  }

  function select(next) {
    pair = next === pair ? "" : next;
    choice.value = pair;
    moves?.move(angle, pair || null);
    on.selected(pair || null);
  }

  /** Put the latest answer on the screen, as large as its place is; printing only scales it. */
  function draw() {
    if (!PAPER.matches) size = { width: views.clientWidth, height: views.clientHeight };
    if (!createDrawing || !latest || size.width === 0) return;
    drawing = createDrawing({ ...latest, ...size });
    fill(views, drawing?.markup ?? html``);
    enable(drawing !== null);
    scale.textContent = drawing ? drawing.caption : message("drawing.none");
    light(lit);
    if (!moving) return;
    const pairs = drawing?.pairs ?? [];
    fill(choice, html`<option value="">${message("drawing.all")}</option>${pairs.map((name) => html`<option value="${name}">${name}</option>`)}`);
    if (!pairs.includes(pair)) pair = "";
    choice.value = pair;
    end = drawing?.end ?? 360;
    slider.max = String(end);
    if (!playing) slider.step = String(end / STEPS);
    moves = drawing?.attach(views) ?? null;
    move(angle);
  }

  /** Controls wait for a drawing: there is nothing to move or to save. */
  function enable(enabled) {
    for (const control of controls) control.disabled = !enabled;
    if (!enabled) stop();
  }

  function light(path) {
    lit = path;
    for (const part of views.querySelectorAll(".lit")) part.classList.remove("lit");
    if (!path) return;
    for (const part of views.querySelectorAll(`[data-field~="${CSS.escape(path)}"]`)) part.classList.add("lit");
  }

  enable(false);
  const sizes = new ResizeObserver(() => {
    if (views.clientWidth !== size.width && !PAPER.matches) draw();
  });
  sizes.observe(views);

  root.querySelector(".figure-tools").addEventListener("click", async ({ target }) => {
    const kind = target.closest("[data-kind]")?.dataset.kind.toLowerCase();
    if (!kind) return;
    const svg = views.querySelector("svg");
    const content = kind === "png" ? await pngOf(svg) : svgOf(svg);
    download(`${calculator.id}.${kind}`, content, "image/svg+xml");
  });

  if (moving) {
    slider.addEventListener("input", () => {
      stop();
      move(Number(slider.value));
    });
    play?.addEventListener("click", () => (playing ? stop() : start()));
    choice.addEventListener("change", () => {
      pair = "";
      select(choice.value);
    });
    views.addEventListener("click", ({ target }) => {
      const name = target.closest("[data-pair]")?.dataset.pair;
      if (name) select(name);
    });
  }

  return {
    root,
    /** Draw an answer; `curves` are the traces of the figure that the drawing takes numbers from. */
    async update(input, answer, curves) {
      latest = { input, answer, curves };
      createDrawing ??= (await load()).createDrawing;
      draw();
    },
    select,
    get selected() {
      return pair || null;
    },
    get angle() {
      return angle;
    },
    /** Light the parts of a field, or none. */
    light,
    close() {
      stop();
      sizes.disconnect();
    },
  };
}
