/** The report on paper, as the page stands open, and as one HTML file with everything; inputs as a table. */
import { ALL, quantityParts } from "../lib/format.js";
import { element, fill, html } from "../lib/html.js";
import { listedInputs } from "../lib/form_state.js";
import { LABELS } from "../lib/url_state.js";
import { message, quantityTitle, said } from "../messages/index.js";
import { shownUnit } from "../lib/units.js";
import { download } from "./files.js";
import { symbolMarkup, tableMarkup } from "./parts.js";

const PAPER_WIDTH = 660; // of a figure, in the pixels of a print: A4 less its margins
const PAPER_HEIGHT = 0.46; // of that on the screen, where that leaves its titles room
const LEAST_HEIGHT = 200;
const LEFT_OUT = "button, input, select, .strip, .motion, .figure-tools, .compare, .say, .cursor, .accuracy-fold, [hidden], script, link";

/** A value as the form shows it: a number, a list, a name with its title. */
function valueText(field, value, catalogue) {
  if (typeof value === "string") return said("materials", value) ?? message("option")[value] ?? catalogue?.find(({ name }) => name === value)?.title ?? value;
  if (field.kind === "flag") return message("option")[value];
  if (field.kind === "names") return value.map((name) => said("not_considered", name) ?? quantityTitle(name, field.section)).join("; ");
  if (Array.isArray(value)) return value.map((one) => quantityParts(one, field.unit, ALL).value).join("; ");
  return typeof value === "number" ? quantityParts(value, field.unit, ALL).value : String(value);
}

function inputRow({ field, value }, catalogues) {
  const text = valueText(field, value, catalogues[field.path]);
  const cells = typeof value === "string" || field.kind === "names" ? html`<td class="value long" colspan="3">${text}</td>` : html`
    <td class="symbol-cell">${symbolMarkup(field.symbol)}</td><td class="value">${text}</td><td class="unit-cell">${shownUnit(field.unit)}</td>`;
  return html`<tr data-path="${field.path}"><th scope="row">${field.title}</th>${cells}</tr>`;
}

function recordsTable({ field, value }) {
  const columns = field.columns.filter(({ name }) => value.some((row) => row[name] !== undefined));
  return tableMarkup({
    title: field.title,
    columns: columns.map(({ title, unit }) => ({ title, unit })),
    rows: value.map((row) => columns.map(({ name }) => row[name] ?? "–")),
  });
}

function inputsMarkup(groups, catalogues) {
  return groups.map(({ id, title, entries }) => {
    const flat = entries.filter(({ field }) => !["records", "switch"].includes(field.kind));
    return html`<section class="given"><h3>${title ?? message(`group.${id}`)}</h3>
      ${flat.length > 0 && html`<table class="quantities"><tbody>${flat.map((entry) => inputRow(entry, catalogues))}</tbody></table>`}
      ${entries.filter(({ field }) => field.kind === "records").map(recordsTable)}</section>`;
  });
}

/** The rules of the page's own style sheets, the print rules for any medium, the font within. */
async function styles() {
  const sheets = [...document.styleSheets].filter(({ ownerNode }) => !ownerNode?.id);
  const text = sheets.flatMap(({ cssRules }) => [...cssRules].map(({ cssText }) => cssText)).join("\n");
  const [, font] = /url\("([^"]+\.woff2)"\)/.exec(text) ?? [];
  if (!font) return text;
  const sheet = sheets.find(({ cssRules }) => [...cssRules].some(({ cssText }) => cssText.includes(font)));
  const blob = await (await fetch(new URL(font, sheet.href))).blob();
  return text.replace(font, await dataUrl(blob));
}

function dataUrl(blob) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
}

function svgOf(url) {
  return decodeURIComponent(url.slice(url.indexOf(",") + 1));
}

/**
 * On paper a title block stands over the verdict, and the inputs follow the checks. `shown()` gives the results on the
 * screen (store.js), null where there are none; `light()` draws the figures for paper, `whole()` as they are, also those
 * behind a tab, `open(whole)` opens all tabs at once, `back()` has the page as it was; `failed(problem)` says that no file could be made.
 */
export function createReport({ calculator, model, catalogues, version, outputs, figures, worked, shown, light, whole: all, open, back, failed }) {
  const head = element(html`<header class="report-head"></header>`);
  const givens = element(html`<div class="report-givens"></div>`);
  outputs.prepend(head);
  outputs.querySelector(".right").after(givens);
  let folds = []; // opened for paper
  const title = message("report.title", { calculator: message(`calculator.${calculator.id}`) });
  const listening = new AbortController();
  let prepared = false;

  /** On paper stands what is open on the page, in a file of its own everything. */
  function prepare({ whole } = {}) {
    const now = shown();
    if (!now || prepared) return;
    prepared = true;
    fill(head, html`<h1>${title}</h1>
      <table class="title-block"><tbody><tr>${LABELS.filter((label) => label !== "note").map((label) => html`
        <th scope="row">${message(`label.${label}`)}</th><td>${now.typed.texts[label] || "–"}</td>`)}
        <th scope="row">${message("label.date")}</th><td>${new Date().toISOString().slice(0, 10)}</td></tr></tbody></table>
      ${now.typed.texts.note && html`<p class="report-note">${now.typed.texts.note}</p>`}
      <p class="made">${message("report.made", { version, date: new Date().toISOString().slice(0, 10) })}</p>
      <p class="made link-of">${location.href}</p>`);
    fill(givens, html`<h2>${message("form.inputs")}</h2>
      <div class="givens">${inputsMarkup(listedInputs(model, now.typed), catalogues)}</div>`);
    const closed = ":is(.checks details.more, .aside, .plain-words, .torque details):not([open])";
    folds = [...outputs.querySelectorAll(whole ? `details.fold:not([open], .accuracy-fold), ${closed}` : closed)];
    for (const fold of folds) fold.open = true;
    if (whole) worked.unfold();
    open(whole);
    for (const figure of figures) figure.toPaper(PAPER_WIDTH, (height) => (whole ? height : Math.max(PAPER_HEIGHT * height, Math.min(height, LEAST_HEIGHT))));
  }

  function restore() {
    if (!prepared) return;
    prepared = false;
    for (const fold of folds) fold.open = false;
    worked.fold();
    for (const figure of figures) figure.fromPaper();
    fill(head, html``);
    fill(givens, html``);
    back();
  }

  addEventListener("beforeprint", () => prepare(), { signal: listening.signal });
  addEventListener("afterprint", restore, { signal: listening.signal });

  async function file() {
    const [css] = await Promise.all([styles(), worked.ready(), all()]);
    const pictures = await Promise.all(figures.map(async (figure) =>
      [figure.id, figure.known() ? svgOf(await figure.picture("svg", PAPER_WIDTH)) : null]));
    prepare({ whole: true });
    const copy = outputs.cloneNode(true);
    restore();
    // The pictures join as text: in this document their style attributes would break the policy.
    const places = new Map();
    for (const [id, svg] of pictures) {
      const figure = copy.querySelector(`[data-figure="${id}"]`);
      if (!svg) {
        figure.remove();
        continue;
      }
      figure.querySelector("figcaption").remove();
      const canvas = figure.querySelector(".canvas");
      canvas.removeAttribute("style");
      canvas.textContent = `[[${id}]]`;
      places.set(canvas.textContent, svg);
    }
    for (const node of copy.querySelectorAll(LEFT_OUT)) node.remove();
    const content = copy.outerHTML.replace(/\[\[\w+\]\]/g, (place) => places.get(place) ?? place);
    return `<!doctype html>
<html lang="${document.documentElement.lang}" data-theme="light"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">${html`<title>${title}</title>`}
<style>${css}</style></head>
<body class="saved"><main class="workbench" data-stale="false">${content}</main></body></html>
`;
  }

  return {
    async print(ready) {
      await light();
      ready();
      globalThis.print();
    },
    async save() {
      if (!shown()) return;
      try {
        download(`${calculator.id}.html`, await file(), "text/html");
      } catch (problem) {
        failed(problem);
      }
    },
    close: () => listening.abort(),
  };
}
