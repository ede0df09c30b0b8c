/**
 * A list of records: a line in the form that opens a grid over the centre, a row for each part of the mechanism, or as many
 * as are wanted, with buttons to add and remove them; what is pasted from a sheet fills it.
 */
import { cellsOf, stepped, textOfCells } from "../lib/form_state.js";
import { element, fill, html } from "../lib/html.js";
import { shortOf } from "../lib/outline.js";
import { shownUnit } from "../lib/units.js";
import { message } from "../messages/index.js";
import { symbolMarkup } from "./parts.js";

const about = ({ title, help }) => (help ? message("rows.help", { title, help }) : title);

/** What is pasted, as rows of cells; null where it is one value. */
export function pasted(text) {
  const rows = text.replace(/\r?\n$/, "").split(/\r?\n/).map((row) => row.split("\t").map((cell) => cell.replace(/[;|]/g, " ").trim()));
  return rows.length > 1 || rows[0].length > 1 ? rows : null;
}

/** The same interface as a field's view: its text is that of the whole list. Rows of a field that has `rows` are given their names. */
export function createRecords(field, { on }) {
  const id = `field-${field.path.replaceAll(".", "-")}`;
  const given = Boolean(field.rows);
  const root = element(html`
    <div class="field kind-records" data-path="${field.path}" role="group" aria-labelledby="${id}-title">
      <label id="${id}-title" title="${about(field)}"><span class="field-name">${shortOf(field.title)}</span></label>
      <button type="button" class="toggle open-records" aria-haspopup="dialog"></button>
      <p class="field-message" id="${id}-message"><span></span></p>
      <div class="over card" popover="manual" role="dialog" aria-label="${field.title}">
        <div class="head"><h3>${field.title}</h3><button type="button" class="toggle close-records">${message("keys.close")}</button></div>
        <p class="note">${field.help} ${message("real.paste")}</p>
        <div class="grid-rows"><table class="records"><thead><tr><td></td>${field.columns.map((column) => html`
          <th scope="col" title="${about(column)}">${column.title} ${column.symbol && symbolMarkup(column.symbol)} <span class="unit">${shownUnit(column.unit)}</span></th>`)}
          ${!given && html`<td></td>`}</tr></thead><tbody></tbody></table></div>
        ${!given && html`<button type="button" class="add-row">${message("rows.add")}</button>`}
        <p class="records-line note" aria-hidden="true"></p></div></div>`);
  const [opener, over, body, line] = [".open-records", ".over", "tbody", ".records-line"].map((part) => root.querySelector(part));
  let names = []; // of the rows, where they are given
  let text = ""; // of the list
  let shown = null; // that on the screen; null where it has to be shown anew
  let said = {};

  const isOpen = () => over.matches(":popover-open");
  const boxes = () => [...body.rows].map((row) => [...row.querySelectorAll("input")]);
  const columnOf = (box) => (box.matches(".box") ? field.columns[box.closest("td").cellIndex - 1] : null);

  function typed() {
    const cells = boxes().map((row) => row.map((box) => box.value.replace(/[;|]/g, " ").trim()));
    text = given && !cells.flat().some(Boolean) ? "" : textOfCells(cells);
    shown = text;
    on.typed(text);
  }

  /** What is wrong and where, else what the box at hand means. */
  function explain() {
    const { error = "", note = "", place } = said;
    const here = body.contains(document.activeElement) && columnOf(document.activeElement);
    root.classList.toggle("wrong", error !== "");
    root.querySelector(".field-message span").textContent = error || note || field.help;
    root.classList.toggle("noted", error === "" && note !== "");
    line.textContent = error || (here ? about(here) : "");
    line.classList.toggle("bad", error !== "");
    for (const [r, row] of boxes().entries()) {
      for (const [c, box] of row.entries()) {
        if (error && place?.row === r && place.column === field.columns[c].name) box.setAttribute("aria-invalid", "true");
        else box.removeAttribute("aria-invalid");
      }
    }
  }

  function render(cells = cellsOf(text)) {
    const count = cellsOf(text).length;
    opener.textContent = count === 0 ? message("rows.none") : message("rows.count", { count });
    opener.setAttribute("aria-label", `${field.title}: ${opener.textContent}`);
    if (!isOpen()) return;
    shown = text;
    // Rows beyond the mechanism's parts stay: nothing that was typed is lost.
    const rows = Array.from({ length: Math.max(names.length, cells.length) }, (_, r) => (given ? names[r] ?? "–" : r + 1));
    fill(body, html`${rows.map((row) => html`<tr><th scope="row">${row}</th>${field.columns.map((column) => html`
      <td><input class="box" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}-message"
        aria-label="${message(given ? "real.cell" : "rows.cell", { row, title: column.title })}"></td>`)}
      ${!given && html`<td><button type="button" class="remove-row" aria-label="${message("rows.removeRow", { row })}">×</button></td>`}</tr>`)}`);
    for (const [r, row] of boxes().entries()) for (const [c, box] of row.entries()) box.value = cells[r]?.[c] ?? "";
    explain();
  }

  function open() {
    if (isOpen()) return;
    over.showPopover();
    root.closest("details")?.addEventListener("toggle", () => isOpen() && over.hidePopover(), { once: true }); // with its section
    render();
  }

  function close() {
    over.hidePopover();
    opener.focus();
  }

  opener.addEventListener("click", () => {
    if (isOpen()) return close();
    open();
    return (over.querySelector("input") ?? over.querySelector(".add-row")).focus();
  });
  over.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      event.stopPropagation();
      close();
    }
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const column = columnOf(event.target);
    if (!direction || !column || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const next = stepped(column, event.target.value || (given ? "0" : ""), direction, event.shiftKey ? 10 : 1);
    if (next === null) return;
    event.target.value = next;
    typed();
  });
  over.addEventListener("click", ({ target }) => {
    if (target.matches(".close-records")) close();
    const values = boxes().map((row) => row.map((box) => box.value));
    if (target.matches(".add-row")) {
      // A new row starts as the one above it: only what differs has to be typed.
      render([...values, values.at(-1) ?? field.columns.map(() => "")]);
      typed();
      body.rows[values.length].querySelector("input").focus();
    }
    if (target.matches(".remove-row")) {
      render(values.filter((_, r) => r !== target.closest("tr").sectionRowIndex));
      typed();
      (body.querySelector(".remove-row") ?? over.querySelector(".add-row")).focus();
    }
  });
  body.addEventListener("input", typed);
  body.addEventListener("focusin", explain);
  body.addEventListener("paste", (event) => {
    const cells = pasted(event.clipboardData.getData("text"));
    if (!cells) return;
    event.preventDefault();
    const all = boxes();
    const from = all.findIndex((row) => row.includes(event.target));
    const at = all[from].indexOf(event.target);
    const values = all.map((row) => row.map((box) => box.value));
    while (!given && values.length < from + cells.length) values.push(field.columns.map(() => ""));
    for (const [r, row] of cells.entries()) {
      for (const [c, value] of row.entries()) if (values[from + r] && at + c < field.columns.length) values[from + r][at + c] = value;
    }
    if (values.length > all.length) render(values);
    for (const [r, row] of boxes().entries()) for (const [c, box] of row.entries()) box.value = values[r][c];
    boxes()[from][at].focus();
    typed();
  });

  return {
    root,
    focus() {
      open();
      (over.querySelector("[aria-invalid]") ?? over.querySelector("input, button")).focus();
    },
    /** What the rows are of. */
    setRows(labels) {
      if (labels.join() === names.join()) return;
      names = labels;
      render();
    },
    setText(next) {
      const same = next === text;
      text = next;
      if (!same || next !== shown) render();
    },
    setMessage(next) {
      said = next;
      explain();
    },
  };
}
