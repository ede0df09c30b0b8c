/** What the user may take along: the link, the request for other programs, request and answer as files. */
import { Problem } from "../lib/api.js";
import { csvOf, curlLine, flatValues, pythonCode } from "../lib/exports.js";
import { fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { createDialog } from "./parts.js";
import { download } from "./files.js";

function resultsCsv({ filled, answer }) {
  return csvOf({
    columns: ["section", "name", "value", "unit"].map((title) => ({ title })),
    rows: flatValues(filled, answer).map(({ section, name, value, unit }) => [section, name, value, unit]),
  });
}

function snippet(kind, label, text) {
  return html`
    <div class="snippet" data-kind="${kind}">
      <div class="snippet-head"><h3>${label}</h3>
        <button type="button" class="toggle copy" aria-label="${message("share.copyWhat", { what: label })}">${message("share.copy")}</button></div>
      <pre tabindex="0" aria-label="${label}">${text}</pre>
    </div>`;
}

/**
 * Opened by `button`. `exchange()` gives what was asked for the results on the screen: `{ calculator, requests: [{ path,
 * body, answer }], filled, answer }`, and `files: [{ id, make }]`, what the service draws of them, with `refused(problem)`,
 * which words why it does not; or null where there are none.
 */
export function createShare({ button, exchange, say }) {
  const dialog = createDialog({ id: "share", title: message("share.title"), content: html`<div class="share"></div>` });
  const content = dialog.querySelector(".share");
  let shown = null;

  function show() {
    shown = exchange();
    const url = (path) => new URL(`.${path}`, document.baseURI).href;
    const bodies = shown?.requests ?? [];
    fill(content, html`
      ${snippet("link", message("share.link"), location.href)}
      ${bodies.length > 0 && snippet("curl", message("share.curl"),
        bodies.map(({ path, body }) => curlLine(url(path), body)).join("\n"))}
      ${bodies.length > 0 && snippet("python", message("share.python"),
        pythonCode(url(bodies.at(-1).path), bodies.at(-1).body))}
      ${bodies.length > 0 ? html`<div class="files">
        <button type="button" class="toggle" data-file="json">${message("share.json")}</button>
        <button type="button" class="toggle" data-file="csv">${message("share.csv")}</button>
        ${shown.files.map(({ id }) => html`<button type="button" class="toggle" data-file="${id}">${message(`share.${id}`)}</button>`)}</div>
        <p class="refused" role="alert"></p>`
        : html`<p>${message("share.nothing")}</p>`}`);
    dialog.showModal();
  }

  content.addEventListener("click", async ({ target }) => {
    const piece = target.closest(".copy")?.closest(".snippet");
    if (piece) {
      const text = piece.querySelector("pre");
      try {
        await navigator.clipboard.writeText(text.textContent);
        target.textContent = message("share.copied");
        say(message("share.copied"));
      } catch {
        // Where the browser forbids it, the text is selected for the user's own keys.
        getSelection().selectAllChildren(text);
      }
    }
    const file = target.closest("[data-file]")?.dataset.file;
    const { calculator, requests, files = [], refused } = shown ?? {};
    const made = files.find(({ id }) => id === file);
    if (made) {
      const said = content.querySelector(".refused");
      said.textContent = "";
      try {
        const { name, content: blob } = await made.make();
        download(name, blob);
      } catch (problem) {
        if (!(problem instanceof Problem)) throw problem;
        said.textContent = refused(problem);
      }
    }
    if (file === "json") download(`${calculator}.json`, `${JSON.stringify({ requests }, null, 2)}\n`, "application/json");
    if (file === "csv") download(`${calculator}.csv`, resultsCsv(shown), "text/csv");
  });
  button.addEventListener("click", show);
}
