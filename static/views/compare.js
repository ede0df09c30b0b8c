/** Kept designs beside the one at hand: inputs that differ, results and their differences. */
import { element, fill, html } from "../lib/html.js";
import { formatNumber, quantityParts, unitOf } from "../format.js";
import { message } from "../messages/index.js";
import { readState, shownFields, stateFromInput, textIn } from "../schema_form.js";
import { MOST } from "../designs.js";
import { shownUnit } from "../units.js";
import { download } from "./download.js";

const DIGITS = 5;

/** The boxes of an input by path: `{ title, unit, text }`. */
function boxesOf(model, input) {
  const state = stateFromInput(model, input);
  const { readings } = readState(model, state);
  return new Map(shownFields(model, state)
    .filter(({ path }) => readings[path].value !== undefined)
    .map((field) => [field.path, { field, text: textIn(field, readings[field.path].value) }]));
}

function inputRows(model, designs) {
  const boxes = designs.map(({ input }) => boxesOf(model, input));
  const paths = new Set(boxes.flatMap((one) => [...one.keys()]));
  return [...paths].flatMap((path) => {
    const texts = boxes.map((one) => one.get(path)?.text);
    if (new Set(texts).size === 1) return [];
    const { field } = boxes.find((one) => one.has(path)).get(path);
    return [{ title: field.title, unit: shownUnit(field.unit), cells: texts.map((text) => ({ text: text ?? "–" })) }];
  });
}

function change(value, own) {
  if (value === own) return "";
  const percent = (100 * (value - own)) / Math.abs(own);
  return Number.isFinite(percent) ? `${percent > 0 ? "+" : ""}${formatNumber(percent, 3)} %` : "≠";
}

/** The numbers of the sections, a row each: also what is known of some designs only. */
function resultRows(sections, elsewhere, designs) {
  const of = (section) => designs.map(({ answer }) => answer?.[section] ?? {});
  return sections.flatMap((section) => [...new Set(of(section).flatMap((values) =>
    Object.keys(values).filter((name) => typeof values[name] === "number" && !elsewhere.includes(name))))]
    .map((name) => ({
      title: message(`quantity.${name}`)[0],
      unit: shownUnit(unitOf(name)),
      cells: of(section).map(({ [name]: value }, i, [{ [name]: own }]) => {
        if (value === undefined) return { text: "–" };
        return {
          text: quantityParts(value, unitOf(name), DIGITS).value,
          ...(i > 0 && own !== undefined && { change: change(value, own), differs: value !== own }),
        };
      }),
    })));
}

/** Said above a design that cannot be built: its numbers are no reason to prefer it. */
function refusedMark(calculator, { input, answer }) {
  const reasons = answer && calculator.impossible ? calculator.impossible(answer, { input }) : [];
  return reasons.length > 0 && html`<span class="refused" title="${reasons.join(" ")}"><span
    class="sign bad" aria-hidden="true">✕</span>${message("state.refused")}</span>`;
}

function tableRows(rows) {
  return rows.map(({ title, unit, cells }) => html`
    <tr><th scope="row">${title}${unit && html` <span class="unit">${unit}</span>`}</th>${cells.map((cell) => html`
      <td class="${cell.differs && "differs"}">${cell.text}${cell.change && html` <small>${cell.change}</small>`}</td>`)}</tr>`);
}

/**
 * `on.pin()`, `on.open(design)`, `on.rename(design, name)`, `on.remove(design)`, `on.export()` and
 * `on.import(text)` report what the user does.
 */
export function createCompare({ model, calculator, on }) {
  const root = element(html`
    <section class="card compare" aria-labelledby="compare-title">
      <div class="compare-head"><h2 id="compare-title">${message("compare.title")}</h2>
        <button type="button" class="toggle" data-do="pin">${message("compare.pin")}</button>
        <button type="button" class="toggle" data-do="export">${message("compare.export")}</button>
        <label class="toggle file">${message("compare.import")}<input type="file" accept="application/json,.json" class="unseen"></label>
      </div>
      <div class="compare-table" tabindex="0" role="group" aria-labelledby="compare-title"></div>
    </section>`);
  const table = root.querySelector(".compare-table");
  const pin = root.querySelector("[data-do=pin]");
  let designs = [];

  root.addEventListener("click", ({ target }) => {
    const act = target.closest("[data-do]")?.dataset.do;
    const design = designs[target.closest("[data-design]")?.dataset.design];
    if (act === "pin" || act === "export") on[act]();
    else if (act) on[act](design);
  });
  root.addEventListener("change", async ({ target }) => {
    if (target.type === "file") {
      const [file] = target.files;
      if (file) on.import(await file.text());
      target.value = "";
    } else {
      on.rename(designs[target.closest("[data-design]").dataset.design], target.value);
    }
  });

  return {
    root,
    save: (text) => download("khv-calc-designs.json", text, "application/json"),
    /** `kept`: the designs with their answers; `own`: `{ input, answer }` of the one at hand. */
    update(kept, own) {
      designs = kept;
      pin.disabled = !own || kept.length >= MOST;
      if (kept.length === 0 || !own) {
        fill(table, html`<p class="missing">${message("compare.hint")}</p>`);
        return;
      }
      const all = [own, ...kept];
      fill(table, html`
        <table class="data">
          <thead><tr><th scope="col">${message("results.quantity")}</th><th scope="col">${message("compare.own")} ${refusedMark(calculator, own)}</th>${kept.map((design, i) => html`
            <th scope="col" data-design="${i}"><input class="box free-text" value="${design.name}" maxlength="24" aria-label="${message("compare.name", design)}">
              <span class="design-tools"><button type="button" class="toggle" data-do="open" aria-label="${message("compare.openWhat", design)}">${message("compare.open")}</button>
              <button type="button" class="toggle" data-do="remove" aria-label="${message("compare.removeWhat", design)}">×</button></span>${refusedMark(calculator, design)}</th>`)}</tr></thead>
          <tbody>${tableRows(inputRows(model, all))}</tbody>
          <tbody>${tableRows(resultRows(calculator.sections, calculator.elsewhere, all))}</tbody>
        </table>`);
    },
  };
}
