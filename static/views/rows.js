/** A list of records as a small table of boxes: a row each, with buttons to add and remove rows; what all such tables have. */
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { cellsOf, stepped, textOfCells } from "../lib/form_state.js";
import { shownUnit } from "../lib/units.js";
import { symbolMarkup } from "./parts.js";

function about({ title, help }) {
  return help ? message("rows.help", { title, help }) : title;
}

/**
 * The boxes of a table of records, one for each of the field's columns after the first `named` cells of a row; arrow keys step
 * the one at hand, an empty one from `empty`. `typed()` tells of a change.
 */
export function boxTable(body, field, { named = 0, empty = "", typed }) {
  const boxes = () => [...body.rows].map((row) => [...row.querySelectorAll("input")]);
  const columnOf = (box) => (box.matches(".box") ? field.columns[box.closest("td").cellIndex - named] : null);
  body.addEventListener("input", typed);
  body.addEventListener("keydown", (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const column = columnOf(event.target);
    if (!direction || !column || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const next = stepped(column, event.target.value || empty, direction, event.shiftKey ? 10 : 1);
    if (next === null) return;
    event.target.value = next;
    typed();
  });
  return {
    boxes,
    columnOf,
    cells: () => boxes().map((row) => row.map((box) => box.value.replace(/[;|]/g, " "))),
    /** Mark the box that is wrong, where one is. */
    mark(place) {
      for (const [r, row] of boxes().entries()) {
        for (const [c, box] of row.entries()) {
          if (place?.row === r && place.column === field.columns[c].name) box.setAttribute("aria-invalid", "true");
          else box.removeAttribute("aria-invalid");
        }
      }
    },
  };
}

/** The same interface as a field's view: its text is that of the whole list. */
export function createRows(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const root = element(html`
    <div class="field kind-records" data-path="${field.path}" role="group" aria-labelledby="${id}-title">
      <span class="records-title" id="${id}-title" title="${field.help}">${field.title}</span>
      <table class="records"><thead><tr>${field.columns.map((column) => html`
        <th scope="col" title="${about(column)}">${column.symbol ? symbolMarkup(column.symbol) : column.title}
          <span class="unit">${shownUnit(column.unit)}</span></th>`)}
        <th><span class="unseen">${message("rows.remove")}</span></th></tr></thead><tbody></tbody></table>
      <button type="button" class="add-row">${message("rows.add")}</button>
      <p class="field-message" id="${id}-message"></p>
    </div>`);
  const body = root.querySelector("tbody");
  const line = root.querySelector(".field-message");
  let shown = null;
  let said = "";

  const { boxes, columnOf, cells, mark } = boxTable(body, field, { typed });

  /** The line under the table: what is wrong, or what the box at hand means. */
  function explain() {
    const here = body.contains(document.activeElement) && columnOf(document.activeElement);
    const text = said || (here ? about(here) : field.help);
    if (line.textContent !== text) line.textContent = text;
  }

  function typed() {
    shown = textOfCells(cells());
    on.typed(shown);
  }

  function render(rows) {
    fill(body, html`${rows.map((texts, at) => html`<tr>${field.columns.map((column, c) => html`
      <td><input class="box" type="text" inputmode="decimal" autocomplete="off" spellcheck="false"
        aria-describedby="${id}-message" aria-label="${message("rows.cell", { row: at + 1, title: column.title })}"
        value="${texts[c] ?? ""}"></td>`)}
      <td><button type="button" class="remove-row" aria-label="${message("rows.removeRow", { row: at + 1 })}">×</button></td></tr>`)}`);
  }

  body.addEventListener("focusin", explain);
  body.addEventListener("click", (event) => {
    const button = event.target.closest(".remove-row");
    if (!button) return;
    button.closest("tr").remove();
    typed();
    render(cellsOf(shown));
    (body.querySelector(".remove-row") ?? root.querySelector(".add-row")).focus();
  });
  root.querySelector(".add-row").addEventListener("click", () => {
    const rows = boxes().map((row) => row.map((box) => box.value));
    // A new row starts as the one above it: only what differs has to be typed.
    rows.push(rows.length > 0 ? [...rows.at(-1)] : field.columns.map(() => ""));
    render(rows);
    typed();
    body.rows[rows.length - 1].querySelector("input").focus();
  });

  return {
    root,
    focus: () => (root.querySelector("[aria-invalid]") ?? root.querySelector("input, button")).focus(),
    setText(text) {
      if (text === shown) return;
      shown = text;
      render(cellsOf(text));
    },
    setMessage({ error = "", note = "", place = null }) {
      said = error || note;
      explain();
      root.classList.toggle("wrong", error !== "");
      mark(error === "" ? null : place);
    },
  };
}
