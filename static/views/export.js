/** What the user may take along: the report, request and answer as files, the request for other programs. */
import { Problem } from "../lib/api.js";
import { csvOf, curlLine, flatValues, pythonCode } from "../lib/exports.js";
import { fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { busy, createDialog } from "./parts.js";
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
        <button type="button" class="toggle copy" aria-label="${message("export.copyWhat", { what: label })}">${message("export.copy")}</button></div>
      <pre tabindex="0" aria-label="${label}">${text}</pre>
    </div>`;
}

const REPORTS = { report: "text/html", pdf: "application/pdf" };

const button = (act, words) => html`<button type="button" class="toggle" data-do="${act}">${words}</button>`;

/**
 * `exchange()` gives what was asked for the results on the screen: `{ calculator, requests: [{ path,
 * body, answer }], filled, answer }`, and `files: [{ id, make }]`, what the service draws of them, with `refused(problem)`,
 * which words why it does not; or null where there are none. `labels()` is what the report's title block says, `[[label, text]]`.
 * `on.print(ready)`, which tells when it is about to, `on.report(type)`, which gives that file, `shown.pdf` whether as PDF too, `on.labelled(label, text)`. Returns what opens the sheet.
 */
export function createExport({ exchange, labels, say, on }) {
  const dialog = createDialog({ id: "export", title: message("bar.export"), content: html`<div class="share"></div>` });
  const content = dialog.querySelector(".share");
  let shown = null;

  async function give(file) {
    const { calculator, requests, files } = shown;
    if (file === "json") download(`${calculator}.json`, `${JSON.stringify({ requests }, null, 2)}\n`, "application/json");
    if (file === "csv") download(`${calculator}.csv`, resultsCsv(shown), "text/csv");
    const made = REPORTS[file] ? await on.report(REPORTS[file]) : await files.find(({ id }) => id === file)?.make();
    if (made) download(made.name, made.content);
  }

  /** What a button does; why the service does not is said below. */
  async function act(what) {
    const said = content.querySelector(".refused");
    said.textContent = "";
    try {
      await (what === "print" ? on.print(() => dialog.close()) : give(what)); // the sheet would stand on the paper
    } catch (problem) {
      if (!(problem instanceof Problem)) throw problem;
      said.textContent = shown.refused(problem);
    }
  }

  content.addEventListener("input", ({ target: { dataset, value } }) => on.labelled(dataset.label, value));
  content.addEventListener("click", async ({ target }) => {
    const what = target.dataset.do;
    const text = target.closest(".copy")?.closest(".snippet").querySelector("pre");
    if (what) await busy(target, () => act(what));
    if (!text) return;
    try {
      await navigator.clipboard.writeText(text.textContent);
      target.textContent = message("export.copied");
      say(message("export.copied"));
    } catch {
      // Where the browser forbids it, the text is selected for the user's own keys.
      getSelection().selectAllChildren(text);
    }
  });

  return () => {
    shown = exchange();
    const url = (path) => new URL(`.${path}`, document.baseURI).href;
    const bodies = shown?.requests ?? [];
    fill(content, shown ? html`
      <h3>${message("export.report")}</h3><div class="labels">${labels().map(([label, text]) => html`<label>${message(`label.${label}`)}
        <input class="box free-text" data-label="${label}" value="${text}" maxlength="${label === "note" ? 500 : 80}" autocomplete="off"></label>`)}</div>
      <div class="files">${button("print", message("report.print"))}${button("report", message("report.save"))}${shown.pdf && button("pdf", message("report.pdf"))}</div>
      <h3>${message("export.files")}</h3>
      <div class="files">${["json", "csv", ...shown.files.map(({ id }) => id)].map((id) => button(id, message(`export.${id}`)))}</div>
      <p class="refused" role="alert"></p>
      ${snippet("curl", message("export.curl"), bodies.map(({ path, body }) => curlLine(url(path), body)).join("\n"))}
      ${snippet("python", message("export.python"), pythonCode(url(bodies.at(-1).path), bodies.at(-1).body))}`
      : html`<p>${message("export.nothing")}</p>`);
    dialog.showModal();
  };
}
