/** Boxes of groups that are off until wanted: the switch, a set of choices, a table of the parts of a mechanism. */
import { cellsOf, textOfCells } from "../lib/form_state.js";
import { element, fill, html } from "../lib/html.js";
import { shownUnit } from "../lib/units.js";
import { message, quantityTitle, said } from "../messages/index.js";
import { symbolMarkup } from "./parts.js";
import { boxTable } from "./rows.js";

/** The switch of a group; what it says is its title. */
export function createSwitch(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const root = element(html`
    <div class="switch" data-path="${field.path}" title="${field.help}">
      <input type="checkbox" role="switch" aria-label="${field.title}" aria-describedby="${id}-message">
      <span class="unseen" id="${id}-message">${field.help}</span></div>`);
  const input = root.querySelector("input");
  input.addEventListener("change", () => on.switched(input.checked));
  // A box that is left may change its height, and the switch would move from under the pointer.
  input.addEventListener("mousedown", (event) => event.preventDefault());
  return {
    root,
    focus: () => input.focus(),
    setText(text) {
      input.checked = text === "on";
    },
    setMessage() {},
  };
}

/** Some of a list of names. */
export function createNames(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const title = (name) => said("not_considered", name) ?? quantityTitle(name, field.section);
  const root = element(html`
    <fieldset class="field kind-names" data-path="${field.path}"><legend>${field.title}</legend>
      ${field.options.map((name) => html`<label><input type="checkbox" value="${name}" aria-describedby="${id}-message"><span>${title(name)}</span></label>`)}
      <p class="field-message" id="${id}-message"><span></span></p></fieldset>`);
  const boxes = [...root.querySelectorAll("input")];
  const line = root.querySelector(".field-message span");
  root.addEventListener("change", () => on.typed(boxes.filter(({ checked }) => checked).map(({ value }) => value).join("; ")));
  return {
    root,
    focus: () => boxes[0].focus(),
    setText(text) {
      const names = text.split(/;\s*/);
      for (const box of boxes) box.checked = names.includes(box.value);
    },
    setMessage({ error = "" }) {
      line.textContent = error || field.help;
      root.classList.toggle("wrong", error !== "");
    },
  };
}

/** What is pasted, as rows of cells; null where it is one value. */
export function pasted(text) {
  const rows = text.replace(/\r?\n$/, "").split(/\r?\n/).map((row) => row.split("\t").map((cell) => cell.replace(/[;|]/g, " ").trim()));
  return rows.length > 1 || rows[0].length > 1 ? rows : null;
}

/** A list of records, a row for each part of the mechanism; folded until it is opened or says something. */
export function createGrid(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const root = element(html`
    <details class="field kind-records grid" data-path="${field.path}"><summary>${field.title}</summary>
      <p class="note">${field.help} ${message("real.paste")}</p>
      <div class="grid-rows"><table class="records"><thead><tr><td></td>${field.columns.map((column) => html`
        <th scope="col" title="${column.title}">${symbolMarkup(column.symbol)} <span class="unit">${shownUnit(column.unit)}</span></th>`)}</tr></thead>
        <tbody></tbody></table></div>
      <p class="field-message" id="${id}-message"></p></details>`);
  const body = root.querySelector("tbody");
  const line = root.querySelector(".field-message");
  let names = []; // of the rows
  let shown = null; // the text on the screen, null where it has to be shown anew
  let said = {};

  const table = boxTable(body, field, { named: 1, empty: "0", typed });

  function typed() {
    const cells = table.cells().map((row) => row.map((text) => text.trim()));
    shown = cells.flat().some(Boolean) ? textOfCells(cells) : "";
    on.typed(shown);
  }

  function mark() {
    const { error = "", place } = said;
    line.textContent = error;
    root.classList.toggle("wrong", error !== "");
    table.mark(error === "" ? null : place);
  }

  function render(text) {
    if (!root.open) return;
    shown = text;
    const cells = cellsOf(text);
    // Rows beyond the mechanism's parts stay: nothing that was typed is lost.
    const rows = Array.from({ length: Math.max(names.length, cells.length) }, (_, i) => names[i] ?? "–");
    fill(body, html`${rows.map((name, r) => html`<tr><th scope="row">${name}</th>${field.columns.map((column, c) => html`
      <td><input class="box" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}-message"
        aria-label="${message("real.cell", { row: name, title: column.title })}" value="${cells[r]?.[c] ?? ""}"></td>`)}</tr>`)}`);
    for (const [r, row] of table.boxes().entries()) for (const [c, box] of row.entries()) box.value = cells[r]?.[c] ?? "";
    mark();
  }

  let text = "";
  root.addEventListener("toggle", () => render(text));
  body.addEventListener("focusin", ({ target }) => {
    if (!said.error) line.textContent = table.columnOf(target).title;
  });
  body.addEventListener("paste", (event) => {
    const cells = pasted(event.clipboardData.getData("text"));
    if (!cells) return;
    event.preventDefault();
    const all = table.boxes();
    const from = all.findIndex((row) => row.includes(event.target));
    const at = all[from].indexOf(event.target);
    for (const [r, row] of cells.entries()) {
      for (const [c, value] of row.entries()) {
        const box = all[from + r]?.[at + c];
        if (box) box.value = value;
      }
    }
    typed();
  });

  return {
    root,
    focus() {
      root.open = true;
      render(text);
      (root.querySelector("[aria-invalid]") ?? root.querySelector("input")).focus();
    },
    /** What the rows are of. */
    setRows(labels) {
      if (labels.join() === names.join()) return;
      names = labels;
      render(text);
    },
    setText(next) {
      text = next;
      if (next !== shown) render(next);
    },
    setMessage(next) {
      said = next;
      mark();
    },
  };
}
