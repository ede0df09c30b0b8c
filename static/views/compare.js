/** Kept designs beside the one at hand: inputs that differ, results and their differences. */
import { ASIDE, decisive, flattened, judgedOf, levelOfWord, listedOf, percent, titleOf, wordOf } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { ALL, formatNumber, formatQuantity, quantityParts, unitOf } from "../lib/format.js";
import { message, quantityTitle } from "../messages/index.js";
import { movedOf, resultsOf } from "../lib/designs.js";
import { readState, shownFields, stateFromInput, textIn } from "../lib/form_state.js";
import { shownUnit } from "../lib/units.js";
import { answerNow, following } from "../store.js";
import { download } from "./files.js";
import { sign } from "./parts.js";

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

function change(value, base) {
  const percent = (100 * (value - base)) / Math.abs(base);
  return Number.isFinite(percent) ? `${percent > 0 ? "+" : ""}${formatNumber(percent, 3)} %` : "≠";
}

const isNumber = (value) => typeof value === "number";
const NOTHING = { input: {}, answer: null }; // a design that is not complete
const XYZ = ["x", "y", "z"];

/** The numbers of a section, those of vectors each: `[[name, title, unit, value]]`. */
function numbersOf(id, section, elsewhere) {
  return flattened(section).filter(([name]) => !elsewhere.includes(name) && !ASIDE.includes(name)).flatMap(([name, value]) => {
    const title = () => quantityTitle(name, id);
    if (isNumber(value)) return [[name, title(), unitOf(name), value]];
    const parts = Array.isArray(value) && value.length <= XYZ.length ? value.map((one, i) => [XYZ[i], one])
      : value && !Array.isArray(value) && typeof value === "object" ? Object.entries(value) : [];
    if (parts.length === 0 || name === "peak_pair" || !parts.every(([, one]) => isNumber(one))) return [];
    return parts.map(([part, one]) => [`${name}.${part}`, `${title().split(":")[0]}: ${quantityTitle(part)}`, unitOf(name), one]);
  });
}

/** A row of numbers: its change against the base, the best of them marked where it is known which way is better. */
function numberRow(title, unit, values, base, better) {
  const known = values.filter((value) => value !== undefined);
  const best = better && known.length > 1 ? (better > 0 ? Math.max(...known) : Math.min(...known)) : undefined;
  const texts = values.map((value) => (value === undefined ? undefined : quantityParts(value, unit).value));
  const differs = new Set(texts).size > 1;
  return {
    title, unit: shownUnit(unit), differs,
    cells: values.map((value, i) => (value === undefined ? { text: "–" } : {
      text: texts[i],
      exact: formatQuantity(value, unit, ALL),
      best: differs && best !== undefined && texts[i] === texts[values.indexOf(best)],
      ...(texts[base] !== undefined && texts[i] !== texts[base] && { change: change(value, values[base]), differs: true }),
    })),
  };
}

/** The verdict, and the one at which the design was kept where that was another. */
function verdictCell(word, was) {
  const moved = message("verdictWord")[was] && was !== word;
  return {
    level: levelOfWord(word), text: message(`verdictWord.${word}`),
    ...(moved && { change: message("compare.was", { verdict: message(`verdictWord.${was}`) }) }),
  };
}

/** The rows that decide: the verdict, the check that governs, the largest torque. */
function decisiveRows(calculator, designs, base) {
  const all = designs.map(({ answer }) => judgedOf(calculator, answer));
  if (!all.some(Boolean)) return [];
  const text = (of) => all.map((judged) => (judged ? of(judged) : { text: "–" }));
  return [
    { title: message("verdict.label"), cells: all.map((judged, i) => (judged ? verdictCell(wordOf(judged), designs[i].results?.verdict) : { text: "–" })) },
    {
      title: message("checks.governing"),
      cells: text((judged) => {
        const check = decisive(judged);
        return { text: check ? `${titleOf(check)}${check.utilisation === undefined ? "" : `, ${percent(check.utilisation)}`}` : "–" };
      }),
    },
    numberRow(quantityTitle("largest_torque_Nm"), "N·m", all.map((judged) => judged?.largest_torque_Nm), base, 1),
    ...movedRow(calculator, designs),
  ];
}

/** What moved since designs were kept, where anything did: an earlier version of the service may have said it. */
function movedRow(calculator, designs) {
  const cells = designs.map(({ results, answer }) => ({
    text: movedOf(results, answer ? resultsOf(calculator, answer) : {})
      .map(([name, before, after]) => `${quantityTitle(name)} ${quantityParts(before, unitOf(name)).value} → ${formatQuantity(after, unitOf(name))}`).join("; "),
  }));
  return cells.some(({ text }) => text) ? [{ title: message("compare.moved"), cells }] : [];
}

/** The numbers of the sections, a row each: also what is known of some designs only; those that differ first. */
function resultRows(calculator, designs, base) {
  const { elsewhere, better = {} } = calculator;
  const rows = listedOf(calculator, designs.map(({ answer }) => answer)).flatMap((section) => {
    const all = designs.map(({ answer }) => new Map(numbersOf(section, answer?.[section] ?? {}, elsewhere).map((one) => [one[0], one])));
    const ids = [...new Set(all.flatMap((one) => [...one.keys()]))];
    return ids.map((id) => {
      const [, title, unit] = all.find((one) => one.has(id)).get(id);
      return { id, ...numberRow(title, unit, all.map((one) => one.get(id)?.[3]), base, better[id]) };
    });
  });
  const first = (row) => (row.id in better ? 0 : 1);
  return [...rows.filter(({ differs }) => differs).sort((one, other) => first(one) - first(other)), ...rows.filter(({ differs }) => !differs)];
}

function tableRows(rows) {
  return rows.map(({ title, unit, cells, differs }) => html`
    <tr class="${differs === false && "equal"}"><th scope="row">${title}${unit && html` <span class="unit">${unit}</span>`}</th>${cells.map((cell) => html`
      <td class="${cell.differs && "differs"} ${cell.best && "best"}" title="${cell.exact ?? ""}">${sign(cell.level)}${cell.best && html`<span class="sign good" title="${message("compare.best")}">★</span>`}${cell.text}${cell.change && html` <small>${cell.change}</small>`}</td>`)}</tr>`);
}

/**
 * `on.open(design)`, `on.rename(design, name)`, `on.remove(design)` and `on.export()` report what the user does.
 */
export function createCompare({ model, calculator, on }) {
  const root = element(html`
    <section class="compare" aria-labelledby="compare-title">
      <div class="compare-head"><h2 id="compare-title">${message("compare.title")}</h2>
        <button type="button" class="toggle" data-do="export">${message("compare.export")}</button>
      </div>
      <div class="compare-table" tabindex="0" role="group" aria-labelledby="compare-title"></div>
    </section>`);
  const table = root.querySelector(".compare-table");
  let designs = [];

  root.addEventListener("click", ({ target }) => {
    const act = target.closest("[data-do]")?.dataset.do;
    const design = designs[target.closest("[data-design]")?.dataset.design];
    if (act === "export") on.export();
    else if (act) on[act](design);
  });
  root.addEventListener("change", ({ target }) => on.rename(designs[target.closest("[data-design]").dataset.design], target.value));

  return {
    root,
    save: (text) => download("khv-calc-designs.json", text, "application/json"),
    update: following(({ kept, shown, limit }) => [kept, shown, limit], (state) => {
      const { kept, shown } = state;
      designs = kept ?? [];
      if (designs.length === 0) {
        fill(table, html`<p class="missing">${message("compare.hint")}</p>`);
        return;
      }
      const all = [shown ? { ...shown, answer: answerNow(state) } : NOTHING, ...designs];
      const base = 1; // the design kept first: what comes after is held against it
      fill(table, html`
        <table class="data">
          <thead><tr><th scope="col">${message("results.quantity")}</th><th scope="col">${message("compare.own")}</th>${designs.map((design, i) => html`
            <th scope="col" data-design="${i}" class="series-${(i % 6) + 1}"><input class="box free-text" value="${design.name}" maxlength="24" aria-label="${message("compare.name", design)}">
              <span class="design-tools"><button type="button" class="toggle" data-do="open" aria-label="${message("compare.openWhat", design)}">${message("compare.open")}</button>
              <button type="button" class="toggle" data-do="remove" aria-label="${message("compare.removeWhat", design)}">×</button></span>${i + 1 === base && html`<span class="note">${message("compare.base")}</span>`}</th>`)}</tr></thead>
          <tbody></tbody><tbody></tbody><tbody></tbody>
        </table>`); // the same designs keep their boxes, in which a name is being typed
      const rows = [decisiveRows(calculator, all, base), inputRows(model, all), resultRows(calculator, all, base)];
      rows.forEach((each, i) => fill(table.firstElementChild.tBodies[i], html`${tableRows(each)}`));
    }),
  };
}
