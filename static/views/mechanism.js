/**
 * The drawing of a calculator, and what moves it: a slider, play and pause, the pair selected.
 * What stands still has the drawing alone.
 */
import { formatQuantity } from "../format.js";
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

const TURN_MS = 12_000;
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

/** `on.moved(angle)` and `on.selected(pair)` let the figures follow. */
export function createMechanism({ calculator, on }) {
  const { load, moving } = calculator.drawing;
  const root = element(html`
    <section class="card mechanism" aria-labelledby="mechanism-title">
      <h2 id="mechanism-title">${message(`drawing.${calculator.id}`)}</h2>
      <div class="views"></div>
      <p class="scale"></p>
      ${moving && html`<div class="motion">
        ${!STILL.matches && html`<button type="button" class="toggle play" aria-pressed="false">${message("drawing.play")}</button>`}
        <input type="range" min="0" max="360" step="1" value="0" aria-label="${message("figure.crankAngle")}">
        <output></output>
        <label for="pair">${message("drawing.select")}</label>
        <select id="pair" class="box"><option value="">${message("drawing.all")}</option></select>
      </div>`}
    </section>`);
  const views = root.querySelector(".views");
  const scale = root.querySelector(".scale");
  const slider = root.querySelector("input");
  const shown = root.querySelector("output");
  const play = root.querySelector(".play");
  const choice = root.querySelector("select");
  let drawing = null;
  let angle = 0;
  let playing = 0; // the frame asked for, or 0
  let pair = "";

  function move(next) {
    angle = next;
    slider.value = String(Math.round(angle));
    slider.setAttribute("aria-valuetext", formatQuantity(Math.round(angle), "°"));
    shown.textContent = formatQuantity(Math.round(angle), "°");
    drawing?.move(angle);
    on.moved(angle);
  }

  function stop() {
    cancelAnimationFrame(playing);
    playing = 0;
    play?.setAttribute("aria-pressed", "false");
    if (play) play.textContent = message("drawing.play");
  }

  function start() {
    let last = performance.now();
    const frame = (time) => {
      move((angle + (360 * Math.max(0, time - last)) / TURN_MS) % 360);
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
    drawing?.select(pair || null);
    on.selected(pair || null);
  }

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
  }

  return {
    root,
    /** Draw an answer; `curves` are the traces of the figure that the drawing takes numbers from. */
    async update(input, answer, curves) {
      const { createDrawing } = await load();
      drawing = createDrawing({ input, answer, curves });
      views.replaceChildren(...(drawing?.nodes ?? []));
      scale.textContent = drawing ? drawing.caption : message("drawing.none");
      if (!moving) return;
      const pairs = drawing?.pairs ?? [];
      choice.replaceChildren(choice.options[0], ...pairs.map((name) => element(html`<option value="${name}">${name}</option>`)));
      if (!pairs.includes(pair)) pair = "";
      choice.value = pair;
      if (drawing) drawing.select(pair || null);
      move(angle);
    },
    select,
    get selected() {
      return pair || null;
    },
    get angle() {
      return angle;
    },
    /** Light the dimension of a field, or none. */
    light(path) {
      for (const each of views.querySelectorAll(".dimension")) each.classList.toggle("lit", each.dataset.dimension === path);
    },
    close: stop,
  };
}
