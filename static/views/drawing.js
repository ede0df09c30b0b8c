/**
 * The drawing of a calculator, and what moves it: a slider, play and pause, the pair selected.
 * What stands still has the drawing alone.
 */
import { pairNames } from "../lib/chart.js";
import { formatAngle } from "../lib/format.js";
import { clicks, element, fill, html } from "../lib/html.js";
import { message, quantityTitle } from "../messages/index.js";
import { drawable, following } from "../store.js";
import { enlargeButton, olderMark, saveButtons } from "./parts.js";

const TURN_MS = 12_000;
const STEPS = 720; // of the slider
const PAPER = matchMedia("print"); // there the drawing of the screen is scaled
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

/** `on.turned(angle)`, `on.returned()` to where it starts, and `on.selected(pair)`: a name, or null for all. */
export function createDrawingView({ calculator, on }) {
  const { create, moving, start: startOf, views = [], least = 200 } = calculator.drawing;
  const title = message(`drawing.${calculator.id}`);
  const root = element(html`
    <section class="card mechanism" data-drawing="${calculator.id}" aria-labelledby="drawing-${calculator.id}">
      <div class="head"><h2 id="drawing-${calculator.id}">${title}</h2>
        ${views.length > 0 && html`<span class="views" role="group" aria-label="${message("drawing.views")}">${["whole", ...views.map(({ id }) => id)].map((id, i) => html`
          <button type="button" class="toggle" data-view="${id}" aria-pressed="${String(i === 0)}">${message(`drawing.view.${id}`)}</button>`)}</span>`}<span class="figure-tools">
        ${saveButtons(title, ["PNG", "SVG"])}${enlargeButton(title)}</span></div>
      ${moving && html`<div class="motion">
        ${!STILL.matches && html`<button type="button" class="toggle play" aria-pressed="false">${message("drawing.play")}</button>`}
        <input type="range" min="0" max="360" step="0.5" value="0" aria-label="${quantityTitle("crank_angle_deg")}">
        <output></output>
        ${startOf && html`<button type="button" class="toggle to-peak">${message("drawing.peak")}</button>`}
        <label>${message("drawing.select")} <select id="pair" class="box"></select></label>
      </div>`}
      <div class="drawing" role="img" aria-label="${message(`drawing.${calculator.id}Label`)}"></div>
      ${olderMark()}<p class="scale"></p>
    </section>`);
  for (const { id, shows } of views) root.querySelector(`[data-view="${id}"]`).hidden = Boolean(shows); // until it is known to be there
  const place = root.querySelector(".drawing");
  const controls = root.querySelectorAll(".save, .motion button, .motion input, .motion select");
  const scale = root.querySelector(".scale");
  const slider = root.querySelector("input");
  const shownAngle = root.querySelector("output");
  const play = root.querySelector(".play");
  const choice = root.querySelector("select");
  let view = { id: "whole", create }; // that is chosen
  let latest = null; // { input, answer, curves } to be drawn
  let drawing = null;
  let moves = null; // the drawing on the page, where it moves
  let lit = null; // path of the field whose parts are lit
  let size = { width: 0, height: 0 }; // of its place on the screen
  let turn = { angle: 0, pair: null };
  let playing = 0; // the frame asked for, or 0

  const end = () => drawing?.end ?? 360;

  function showTurn() {
    if (!moving) return;
    const text = `φ = ${formatAngle(turn.angle)}`;
    slider.value = String(turn.angle);
    slider.setAttribute("aria-valuetext", text);
    shownAngle.textContent = text;
    choice.value = turn.pair ?? "";
    moves?.move(turn.angle, turn.pair);
  }

  function showPlaying() {
    slider.step = playing ? "any" : String(end() / STEPS);
    play?.setAttribute("aria-pressed", String(playing !== 0));
    if (play) play.textContent = message(playing ? "drawing.pause" : "drawing.play");
  }

  function stop() {
    cancelAnimationFrame(playing);
    playing = 0;
    if (moving) showPlaying();
  }

  function start() {
    let last = performance.now();
    const frame = (time) => {
      on.turned((turn.angle + (360 * Math.max(0, time - last)) / TURN_MS) % end());
      last = time;
      playing = requestAnimationFrame(frame);
    };
    playing = requestAnimationFrame(frame);
    showPlaying();
  }

  /** Put the latest answer on the screen, as large as its place is; printing only scales it. */
  function draw() {
    if (!PAPER.matches) size = { width: place.clientWidth, height: Math.max(place.clientHeight, least) };
    if (!latest || size.width === 0) return;
    drawing = view.create({ ...latest, ...size });
    fill(place, drawing?.markup ?? html``);
    // Controls wait for a drawing: there is nothing to move or to save.
    for (const control of controls) control.disabled = drawing === null;
    scale.textContent = drawing ? drawing.caption : message("drawing.none");
    light(lit);
    if (!moving) return;
    if (!drawing) stop();
    const { pairs: own = [], ringPairs = [] } = drawing ?? {};
    const pairs = [...own, ...ringPairs];
    fill(choice, html`<option value="">${message("drawing.all")}</option>${pairs.map((name) => html`<option value="${name}">${pairNames(name)}</option>`)}`);
    slider.max = String(end());
    showPlaying();
    moves = drawing?.attach?.(place) ?? null;
    root.querySelector(".motion").classList.toggle("still", Boolean(drawing) && !moves);
    if (!moves) return;
    if (turn.pair !== null && !pairs.includes(turn.pair)) on.selected(null);
    else if (turn.angle > end()) on.turned(end());
    showTurn();
  }

  function light(path) {
    lit = path;
    for (const part of place.querySelectorAll(".lit")) part.classList.remove("lit");
    if (!path) return;
    for (const part of place.querySelectorAll(`[data-field~="${CSS.escape(path)}"]`)) part.classList.add("lit");
  }

  /** Another view of the same design. */
  async function look(id) {
    const next = views.find((one) => one.id === id) ?? { id, create };
    next.create ??= await next.load();
    view = next;
    for (const button of root.querySelectorAll("[data-view]")) button.setAttribute("aria-pressed", String(button.dataset.view === id));
    draw();
  }
  clicks(root, "view", look);

  /** Views of what is known of the design alone. */
  function offer() {
    for (const { id, shows = () => true } of views) {
      const offered = shows(latest.input, latest.answer);
      root.querySelector(`[data-view="${id}"]`).hidden = !offered;
      if (!offered && view.id === id) look("whole");
    }
  }

  for (const control of controls) control.disabled = true;
  if (moving) fill(choice, html`<option value="">${message("drawing.all")}</option>`);
  const sizes = new ResizeObserver(() => {
    const other = place.clientWidth !== size.width || (place.clientHeight !== size.height && place.clientHeight > least);
    if (other && !PAPER.matches) draw();
  });
  sizes.observe(place);

  clicks(root, "kind", async (name) => {
    const kind = name.toLowerCase();
    const { download, pngOf, svgOf } = await import("./files.js");
    const svg = place.querySelector("svg");
    const content = kind === "png" ? await pngOf(svg) : svgOf(svg);
    download(`${calculator.id}.${kind}`, content, "image/svg+xml");
  });
  if (moving) {
    slider.addEventListener("input", () => {
      stop();
      on.turned(Number(slider.value));
    });
    play?.addEventListener("click", () => (playing ? stop() : start()));
    root.querySelector(".to-peak")?.addEventListener("click", () => {
      stop();
      on.returned();
    });
    choice.addEventListener("change", () => on.selected(choice.value || null));
    clicks(place, "pair", (name) => on.selected(name === turn.pair ? null : name));
  }

  const redraw = following(({ shown, curves }) => [shown, curves], (state) => {
    const next = drawable(state);
    root.dataset.stale = String(!next && latest !== null); // until the curves of the answer are there
    if (!next) return;
    latest = next;
    offer();
    draw();
  });
  const follow = following((state) => [state.turn], (state) => {
    turn = state.turn;
    showTurn();
  });
  return {
    root,
    update(state) {
      follow(state);
      redraw(state);
    },
    /** Light the parts of a field, or none. */
    light,
    close() {
      stop();
      sizes.disconnect();
    },
  };
}
