/**
 * All checks, a line each by what they are about: sign, name, how much of the limit is used, value and limit. Opened it
 * says why, by what formula, from where the limit is, and what mends it; those that hold are folded.
 */
import { checkRow, decisive, fixRow, isMended, judgedOf, percent } from "../lib/checks.js";
import { clicks, element, fill, html } from "../lib/html.js";
import { message, said } from "../messages/index.js";
import { following, stale } from "../store.js";
import { barMarkup, sign, symbolMarkup } from "./parts.js";

const FIXES = 2; // in sight; the others are folded

function detailsMarkup({ why, formula, source, place, reason }) {
  return html`<details class="check-more"><summary>${message("checks.basis")}</summary>${[reason, why, formula && symbolMarkup(formula), source, place].filter(Boolean).map((text) => html`<p>${text}</p>`)}</details>`;
}

function missingMarkup(missing, fieldAt) {
  return missing.length > 0 && html`<span class="asked">${message("checks.enter")} ${missing.map((path) => html`
    <button type="button" class="link" data-ask="${path}">${fieldAt(path)?.title ?? path}</button>`)}</span>`;
}

/** A value whose unit gives way to that of the limit beside it. */
function amountMarkup(value) {
  const [amount, unit] = value.split(/\u00a0(?=[^\u00a0]*$)/);
  return html`${amount}${unit && html`<span class="check-unit">\u00a0${unit}</span>`}`;
}

function rowMarkup(row, fieldAt) {
  const { code, level, status, title, value, exact, limit, used, source, reason, cause, missing, judged } = row;
  return html`
    <li class="check ${level ?? ""}" data-code="${code}" data-status="${status}">
      <details><summary>
        <span class="check-title" title="${title}">${sign(level)}${title}<span class="unseen">: ${message(`status.${status}`)}</span></span>
        <span class="check-used">${used !== undefined ? html`${barMarkup(used, level)}<span class="check-share">${percent(used)}</span>`
          : html`<span class="note">${value ? "" : message(`status.${status}`)}</span>`}</span>
        <span class="check-value" title="${exact}">${amountMarkup(value)}${value && limit && " "}<span class="check-limit">${limit}</span></span>
        <span class="check-source">${cause || (judged ? source : reason)}</span>
      </summary><div class="fixes" hidden></div>${detailsMarkup(row)}</details>${missingMarkup(missing, fieldAt)}
    </li>`;
}

function fixMarkup([{ applies, text, standard, then, level, effects }, i]) {
  return html`<li>${applies
    ? html`<button type="button" class="fix" data-fix="${i}">${text}${standard && ` (${standard})`}</button>`
    : html`<span class="note">${text}</span>`}
    ${then && html`<span class="note">${sign(level)}${message("fixes.then", { verdict: then })}</span>`}
    ${effects.map((effect) => html`<span class="note">${sign(effect.level)}${effect.text}</span>`)}</li>`;
}

/** The best of them; more are folded. */
function fixesMarkup(fixes) {
  const more = fixes.slice(FIXES);
  return html`<ul>${fixes.slice(0, FIXES)}</ul>${more.length > 0
    && html`<details class="more"><summary>${message("form.more", { count: more.length })}</summary><ul>${more}</ul></details>`}`;
}

/**
 * `fieldAt(path)` is a field of the form, `askedAt(path)` gives the one in which something missing is entered;
 * `on.fixed(sets)` applies `{pointer: value}`, `on.asked(path)` leads to a field.
 */
export function createChecks({ calculator, titles, fieldAt, askedAt, on }) {
  const root = element(html`
    <section class="card checks" aria-labelledby="checks-title"><h2 id="checks-title">${message("checks.title")}</h2>
      <p class="note waiting">${message("checks.waiting")}</p>
      <ul class="rows"></ul>
      ${["holding", "apart"].map((name) => html`<details class="more ${name}" hidden><summary></summary><div></div></details>`)}</section>`);
  const first = root.querySelector(".rows");
  const folds = root.querySelectorAll(".more");
  let list = [];
  let governing = null; // the code of the check that decides
  const opened = new Set(); // codes of the rows that the user has opened

  /** Rows by what they are about. */
  const grouped = (rows) => html`${[...new Set(rows.map(({ group }) => group))].map((group) => html`
    <h3>${said("check_groups", group) ?? group}</h3><ul class="rows">${rows.filter((row) => row.group === group).map((row) => rowMarkup(row, fieldAt))}</ul>`)}`;

  function fold(details, key, rows) {
    details.hidden = rows.length === 0;
    details.querySelector("summary").textContent = message(key, { count: rows.length });
    fill(details.lastElementChild, grouped(rows));
  }

  const rows = following(({ shown }) => [shown], ({ shown }) => {
    const judged = judgedOf(calculator, shown?.answer);
    root.style.visibility = shown && !judged?.checks ? "hidden" : "";
    root.querySelector(".waiting").hidden = Boolean(judged?.checks);
    if (!judged?.checks) return;
    governing = decisive(judged)?.code ?? judged.governing;
    const all = judged.checks.map((check) => ({ ...checkRow(check, titles), group: check.group }))
      .map((row) => ({ ...row, missing: [...new Set(row.missing.map(askedAt))] }));
    const holds = ({ code, status }) => status === "pass" && code !== governing;
    const isOpen = (row) => !holds(row) && (row.judged || (row.status === "not_checked" && row.needed));
    const asked = new Set();
    /** A field is asked for once, at the first row that lacks it. */
    const once = (row) => ({ ...row, missing: row.missing.filter((path) => !asked.has(path) && asked.add(path)) });
    fill(first, html`${all.filter(isOpen).map((row) => rowMarkup(once(row), fieldAt))}`);
    fold(folds[0], "checks.hold", all.filter(holds).map(once));
    fold(folds[1], "checks.more", all.filter((row) => !holds(row) && !isOpen(row)).map(once));
    const mended = isMended(calculator, shown.answer);
    for (const row of root.querySelectorAll(".check")) {
      const own = opened.has(row.dataset.code);
      row.querySelector("details").open = own || (mended && row.dataset.code === governing);
      row.querySelector(".check-more").open = own;
    }
  });

  /** What mends the design at the check that it mends, of several inputs together at the one that governs; or that it is looked for. */
  const mending = following((state) => [state.shown, state.fixes, stale(state)], (state) => {
    const { shown, fixes: found } = state;
    const judged = judgedOf(calculator, shown?.answer);
    if (!judged?.checks) return;
    const [open, known] = [isMended(calculator, shown.answer), found?.of.answer === shown.answer];
    list = known ? found.list : [];
    const seeks = open && !known && !stale(state);
    const why = open && known && (list.length === 0 ? { true: "long", false: "none" }[found.long] : found.long && "ended");
    const note = seeks ? html`<p class="note">${message("fixes.seeking")}</p><progress class="seeking" aria-hidden="true"></progress>`
      : why && html`<p class="note">${message(`fixes.${why}`)}</p>`;
    for (const row of root.querySelectorAll(".check")) {
      const { code } = row.dataset;
      const own = list.map((fix, i) => [fix, i]).filter(([fix]) => fix.code === code || (code === governing && (fix.code === undefined || fix.steps)));
      const place = row.querySelector(".fixes");
      const says = open && code === governing && note;
      place.hidden = !(open && code === governing) && own.length === 0;
      fill(place, html`${!place.hidden && html`<h3>${message("fixes.title")}</h3>`}${says}
        ${fixesMarkup(own.map(([fix, i]) => fixMarkup([fixRow(fix, fieldAt, judged), i])))}`);
    }
  });

  clicks(root, "fix", (i) => on.fixed(list[i].sets));
  clicks(root, "ask", (path) => on.asked(path));
  root.addEventListener("click", ({ target }) => {
    const row = target.closest(".check > details > summary")?.closest(".check");
    if (!row) return;
    const open = !row.querySelector("details").open; // it turns after the click
    opened[open ? "add" : "delete"](row.dataset.code);
    row.querySelector(".check-more").open = open;
  });

  function lead(row, place) {
    row.closest(".more")?.setAttribute("open", "");
    place.focus();
    row.scrollIntoView({ block: "center" });
  }

  return {
    root,
    /** Leads to where a field is asked for, if a check does. */
    asks(path) {
      const button = root.querySelector(`[data-ask="${path}"]`);
      if (button) lead(button.closest(".check"), button);
      return Boolean(button);
    },
    /** Leads to a check; of none that is named to the first that is not known. */
    show(code = root.querySelector('.check[data-status="not_checked"]')?.dataset.code) {
      const row = root.querySelector(`[data-code="${code}"]`);
      if (!row) return;
      for (const details of row.querySelectorAll(":scope > details, .check-more")) details.open = true;
      lead(row, row.querySelector("summary"));
    },
    update(state) {
      rows(state);
      mending(state);
    },
  };
}
