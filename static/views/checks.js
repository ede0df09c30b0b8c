/** All checks, the one that governs first: how much of its limit each uses, from where the limit is, what mends it. */
import { checkRow, fixRow, isMended, judgedOf, percent } from "../lib/checks.js";
import { element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { following, stale } from "../store.js";
import { barMarkup, sign, symbolMarkup } from "./parts.js";

const AT_ONCE = 6; // rows in sight; the rest is folded
const FIXES = 4;

function detailsMarkup({ why, formula, source, place, reason }) {
  return html`<div class="check-more">${[reason, why, formula && symbolMarkup(formula), source, place].filter(Boolean).map((text) => html`<p>${text}</p>`)}</div>`;
}

function missingMarkup(missing, fieldAt) {
  return missing.length > 0 && html`<span class="asked">${message("checks.enter")} ${missing.map((path) => html`
    <button type="button" class="link" data-ask="${path}">${fieldAt(path)?.title ?? path}</button>`)}</span>`;
}

function rowMarkup(row, fieldAt) {
  const { code, level, status, title, value, limit, used, source, reason, missing, judged } = row;
  return html`
    <li class="check ${level ?? ""}" data-code="${code}" data-status="${status}">
      <details><summary>
        <span class="check-title">${sign(level)}${title}<span class="unseen">: ${message(`status.${status}`)}</span></span>
        <span class="check-used">${used !== undefined && judged ? html`${barMarkup(used, level)}<span>${percent(used)}</span>`
          : html`<span class="note">${message(`status.${status}`)}</span>`}</span>
        <span class="check-value">${value}${value && limit && " "}<span class="check-limit">${limit}</span></span>
        <span class="check-source">${judged ? source : reason}</span>
      </summary>${detailsMarkup(row)}</details>${missingMarkup(missing, fieldAt)}
    </li>`;
}

function fixMarkup({ applies, text, standard, then, level, effects }, i) {
  return html`<li>${applies
    ? html`<button type="button" class="fix" data-fix="${i}">${text}${standard && ` (${standard})`}</button>`
    : html`<span class="note">${text}</span>`}
    ${then && html`<span class="note">${sign(level)}${message("fixes.then", { verdict: then })}</span>`}
    ${effects.map((effect) => html`<span class="note">${sign(effect.level)}${effect.text}</span>`)}</li>`;
}

/**
 * `fieldAt(path)` is a field of the form, `askedAt(path)` gives the one in which something missing is entered;
 * `on.fixed(sets)` applies `{pointer: value}`, `on.asked(path)` leads to a field.
 */
export function createChecks({ calculator, titles, fieldAt, askedAt, on }) {
  const root = element(html`
    <section class="card checks" aria-labelledby="checks-title"><h2 id="checks-title">${message("checks.title")}</h2>
      <p class="note waiting">${message("checks.waiting")}</p>
      <ul class="rows"></ul><div class="fixes"></div>
      <details class="more" hidden><summary></summary><ul class="rows"></ul></details></section>`);
  const [first, rest] = root.querySelectorAll(".rows");
  const more = root.querySelector(".more");
  const fixes = root.querySelector(".fixes");
  let list = [];

  const rows = following(({ shown }) => [shown], ({ shown }) => {
    const judged = judgedOf(calculator, shown?.answer);
    root.style.visibility = shown && !judged?.checks ? "hidden" : "";
    root.querySelector(".waiting").hidden = Boolean(judged?.checks);
    if (!judged?.checks) return;
    const all = judged.checks.map((check) => checkRow(check, titles))
      .map((row) => ({ ...row, missing: [...new Set(row.missing.map(askedAt))] }));
    // No more stand in sight however many are asked for, so that what is under them keeps its place.
    const inSight = all.filter(({ judged: known, status, needed }) => known || (status === "not_checked" && needed)).slice(0, AT_ONCE);
    fill(first, html`${inSight.map((row) => rowMarkup(row, fieldAt))}`);
    const others = all.filter((row) => !inSight.includes(row));
    more.hidden = others.length === 0;
    more.querySelector("summary").textContent = message("checks.more", { count: others.length });
    fill(rest, html`${others.map((row) => rowMarkup(row, fieldAt))}`);
  });

  /** What mends the design, or that it is looked for. */
  const mending = following((state) => [state.shown, state.fixes, stale(state)], (state) => {
    const { shown, fixes: found } = state;
    const judged = judgedOf(calculator, shown?.answer);
    if (!judged?.checks) return;
    const [open, known] = [isMended(calculator, shown.answer), found?.of.answer === shown.answer];
    fixes.dataset.open = String(open);
    list = known ? found.list.slice(0, FIXES) : [];
    const seeks = open && !known && !stale(state);
    const why = open && known && list.length === 0 && { true: "long", false: "none" }[found.long];
    const note = seeks ? html`<p class="note">${message("fixes.seeking")}</p><progress class="seeking" aria-hidden="true"></progress>`
      : why && html`<p class="note">${message(`fixes.${why}`)}</p>`;
    fill(fixes, !note && list.length === 0 ? html`` : html`<h3>${message("fixes.title")}</h3>
      ${note}<ul>${list.map((fix) => fixRow(fix, fieldAt, judged)).map(fixMarkup)}</ul>`);
  });

  root.addEventListener("click", ({ target }) => {
    const { fix, ask } = target.closest("[data-fix], [data-ask]")?.dataset ?? {};
    if (fix) on.fixed(list[fix].sets);
    if (ask) on.asked(ask);
  });

  return {
    root,
    /** Leads to a check. */
    show(code) {
      const row = root.querySelector(`[data-code="${code}"]`);
      if (!row) return;
      if (more.contains(row)) more.open = true;
      row.querySelector("details").open = true;
      row.querySelector("summary").focus();
      row.scrollIntoView({ block: "center" });
    },
    update(state) {
      rows(state);
      mending(state);
    },
  };
}
