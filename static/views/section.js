/** A section of the inputs: a line with its values and the worst of what hangs on them, and the rows that it opens. */
import { element, fill, html } from "../lib/html.js";
import { shortOf } from "../lib/outline.js";
import { message } from "../messages/index.js";
import { sign } from "./parts.js";

const ROWS = 18; // in sight; more are folded
const WORST = ["bad", "warning", "good"];

/** `title` names it; what it holds is added. */
export function createSection({ id, title }) {
  const root = element(html`<div class="group" data-group="${id}"><details class="section">
    <summary><h2>${shortOf(title)}</h2><span class="values"></span><span class="mark"></span></summary>
    <fieldset class="rows" aria-label="${title}"></fieldset><button type="button" class="link beyond-rows" hidden></button></details></div>`);
  const details = root.firstElementChild;
  const [values, mark] = root.querySelectorAll(".values, .mark");
  const rows = root.querySelector(".rows");
  const button = root.querySelector(".beyond-rows");
  let whole = false; // all rows are in sight

  /** Rows that are neither typed nor among the first wait behind a button. */
  function limit() {
    const shown = [...rows.querySelectorAll(":scope > .field, :scope > .choice, .wanted-fields > .field, .wanted-fields > .choice")].filter((row) => !row.hidden);
    const beyond = shown.slice(ROWS).filter(({ dataset, classList }) => !whole && dataset.origin !== "typed" && !classList.contains("wrong"));
    for (const row of shown) row.classList.toggle("beyond", beyond.includes(row));
    button.hidden = beyond.length === 0;
    button.textContent = message("form.more", { count: beyond.length });
  }
  function reveal() {
    whole = true;
    limit();
  }
  button.addEventListener("click", reveal);
  return {
    root,
    details,
    rows,
    reveal,
    /** Items of which those that are `rare` fold. */
    add(items, rare, addItem, host = rows) {
      const rest = items.filter(rare);
      for (const item of items.filter((one) => !rare(one))) addItem(item, host);
      if (rest.length === 0) return;
      const more = element(html`<details class="more"><summary>${message("form.more", { count: rest.length })}</summary></details>`);
      for (const item of rest) addItem(item, more);
      host.append(more);
    },
    /** What its boxes say, in a line. */
    summarise(line) {
      limit();
      values.hidden = line === "";
      if (values.textContent !== line) values.textContent = line;
      values.title = line;
    },
    /** The worst level of what hangs on it. */
    judge(levels) {
      const worst = WORST.find((level) => levels.includes(level));
      fill(mark, html`${sign(worst)}${worst && html`<span class="unseen">${message(`form.worst.${worst}`)}</span>`}`);
    },
  };
}
