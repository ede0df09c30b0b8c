/** What starts and stops a long calculation, how far it is, and a line that says how it stands. */
import { element, html } from "../lib/html.js";

/** `on.run()`, `on.stop()`; `running` names the bar, `idle` is said first. */
export function createRun({ run: words, stop: ends, running: label, idle, on }) {
  const root = element(html`
    <div class="running"><div class="run">
        <button type="button" class="primary" data-do="run">${words}</button>
        <button type="button" class="toggle" data-do="stop" disabled>${ends}</button>
        <progress max="1" value="0" class="idle" aria-label="${label}"></progress></div>
      <p class="state note" role="status">${idle}</p></div>`);
  const [run, stop] = root.querySelectorAll("button");
  const bar = root.querySelector("progress");
  const line = root.querySelector(".state");
  run.addEventListener("click", () => on.run());
  stop.addEventListener("click", () => on.stop());
  return {
    root,
    update({ phase, progress }, text, again = words) {
      const running = phase === "computing";
      const held = [run, stop].includes(document.activeElement); // a button that is disabled would lose it
      run.disabled = running;
      run.textContent = again;
      stop.disabled = !running;
      if (held) (running ? stop : run).focus();
      bar.classList.toggle("idle", !running);
      if (running && progress === undefined) bar.removeAttribute("value");
      else bar.value = running ? progress : 0;
      if (line.textContent !== text) line.textContent = text;
      line.classList.toggle("bad", phase === "refused" || phase === "failed");
    },
  };
}
