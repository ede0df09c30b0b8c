/** From a requirement to designs: a form of its own, and what is found as cards, each opened as an example is. */
import { createBeside } from "../besides.js";
import { newestOnly } from "../lib/api.js";
import { levelOfWord, titleOf, wordText } from "../lib/checks.js";
import { formatNumber, formatQuantity, unitOf } from "../lib/format.js";
import { stateFromInput } from "../lib/form_state.js";
import { clicks, element, fill, html } from "../lib/html.js";
import { session } from "../lib/storage.js";
import { decodeState, query } from "../lib/url_state.js";
import { message, quantityTitle, said } from "../messages/index.js";
import * as next from "../store.js";
import { createForm, editing } from "./form.js";
import { busy, sign } from "./parts.js";
import { createRun } from "./run.js";

const ID = "propose";
const KEPT = "khv-calc.propose"; // what is typed, in the units of the service

let former = {}; // what was found before the page was built anew

const digitsOf = (unit) => (unit === "mm" ? 4 : 3);

/** What tells designs apart: of plastic the torque at which it yields stands for the largest one. */
function cellsOf({ columns }) {
  const torque = "yield_torque_Nm" in columns ? "yield_torque_Nm" : "largest_torque_Nm";
  const shown = ["outer_diameter_mm", "length_mm", "mass_kg", torque, "backlash_arcmin", "efficiency"];
  return shown.filter((column) => column in columns).map((column) =>
    [quantityTitle(column, ID), formatQuantity(columns[column], unitOf(column), digitsOf(unitOf(column)))]);
}

const materialOf = ({ contact: { hole_material: name } }) => said("materials", name) ?? name;

function proposalMarkup(one, { nameOf, pictureOf }) {
  const [word, name] = [one.verdict, nameOf(one.design)];
  const limits = "yield_torque_Nm" in one.columns ? "contact_static_cold" : one.governing; // of plastic its first yield
  return html`${pictureOf(one.design)}<div><h3>${name}</h3>
      <p class="word ${levelOfWord(word)}">${sign(levelOfWord(word))}${wordText({ verdict: word, parts: [] })}</p>
      <p class="note">${[word !== "pass" && limits && titleOf({ code: limits }), materialOf(one.design)].filter(Boolean).join(" · ")}</p>
      <button type="button" class="primary" aria-label="${message("compare.openWhat", { name })}">${message("compare.open")}</button></div>
    <dl>${cellsOf(one).map(([title, value]) => html`<div><dt>${title}</dt><dd>${value}</dd></div>`)}</dl>`;
}

/** Why none holds: which checks reject how many designs, and the design that comes nearest with what it lacks. */
function noneMarkup({ tally, nearest, processes = [] }, logic) {
  return html`${processes.length > 0 && html`<p class="row">${message("propose.processes")} ${processes.map((code) => html`<button type="button" data-process="${code}">${message(`option.${code}`)}</button>`)}</p>`}${nearest && html`<h3 class="nearest">${message("propose.nearest")}</h3>
      <div class="proposal" data-at="nearest">${proposalMarkup(nearest, logic)}
        <p class="note">${message("propose.lacks")}</p>
        <ul class="lacks">${nearest.lacks.map(({ code, asked_over_reached: ratio }) => html`<li>${titleOf({ code })}${ratio !== undefined && html` <b>× ${formatNumber(ratio, 3)}</b>`}</li>`)}</ul></div>`}
    <table class="data"><caption>${message("propose.why")}</caption><thead><tr>
      <td></td><th scope="col">${message("propose.failed")}</th><th scope="col">${message("propose.onlyThis")}</th></tr></thead>
    <tbody>${tally.map(({ code, failed, only_this: only }) => html`<tr><th scope="row">${titleOf({ code })}</th><td>${formatNumber(failed)}</td><td>${formatNumber(only)}</td></tr>`)}</tbody></table>`;
}

/** How the search stands, in words. */
function standing({ phase, found = [], answer, refusal }) {
  const count = found.length;
  if (phase === "computing") return message("propose.searching", { count });
  if (phase === "stopped") return `${message("besides.stopped")} ${message("propose.found", { count })}`;
  if (refusal) return refusal.text;
  if (!answer) return message("propose.idle");
  const { screened, judged } = answer;
  return count > 0 ? `${message("propose.found", { count })} ${message("propose.looked", { screened, judged })}` : message("propose.none", { screened, judged });
}

/**
 * `logic` is what the calculator says of it, `modelOf(form)` a form made of the service's schema; `on.opened(design)`
 * takes a design over.
 */
export function createProposals({ logic, client, titles, modelOf, on }) {
  const model = modelOf(logic.FORM);
  const { state: typed } = decodeState(model, new URLSearchParams(session.getItem(KEPT) ?? ""), ID);
  const store = next.createStore(next.opened({ model, calculator: logic.FORM, titles }, typed ?? stateFromInput(model, {})));
  store.apply(next.besided, ID, former);
  const asking = createBeside({ store, client, id: ID, logic });
  const opening = newestOnly();

  function change(transition, ...values) {
    store.apply(transition, ...values, Date.now());
    session.setItem(KEPT, query(ID, model, store.state.typed));
  }

  function search() {
    store.apply(next.insisted);
    const [first] = store.state.reading.wrong;
    if (first) form.focus(first);
    else asking.ask();
  }

  const form = createForm({
    model, calculator: logic.FORM, catalogues: {}, unfolded: true, label: message("start.need"),
    on: {
      ...editing(store, change),
      apply: search,
    },
  });
  const run = createRun({
    run: message("propose.search"), stop: message("propose.cancel"), running: message("propose.running"), idle: message("propose.idle"),
    on: { run: search, stop: () => asking.stop() },
  });
  const root = element(html`<div class="propose"><div class="found"><ol class="proposals" aria-label="${message("propose.list")}"></ol><div class="none"></div></div></div>`);
  const [list, none] = root.firstElementChild.children;
  form.root.querySelector("[data-group=more] details").open = false;
  root.prepend(form.root, run.root);

  clicks(root, "process", (code) => {
    change(next.typedIn, "process", code);
    form.focus("process"); // the button goes
    search();
  });
  clicks(root, "at", async (at, card) => {
    const { found, answer, request } = store.state.besides[ID];
    const { design } = at === "nearest" ? answer.nearest : found[at];
    const { answer: whole, superseded } = await busy(card.querySelector("button"), () => opening.ask(() => logic.placed(client, design, JSON.parse(request))));
    if (!superseded) on.opened(whole);
  });

  /** What is in the list stays, and its focus, while more is found. */
  const listed = next.following(({ found = [] }) => [found], ({ found = [] }) => {
    if (found.length < list.children.length || found.length === 0) list.replaceChildren();
    for (const [i, one] of [...found.entries()].slice(list.children.length)) {
      list.append(element(html`<li class="proposal" data-at="${i}">${proposalMarkup(one, logic)}</li>`));
    }
  });

  function update(state) {
    const now = state.besides[ID];
    const { phase, answer, of, found = [] } = now;
    const older = Boolean(answer) && phase === "fresh" && JSON.stringify(logic.asked(state.reading.input)) !== of;
    if (phase) root.dataset.begun = "true"; // from then on the list has its room
    run.update(now, [standing(now), older && message("besides.older")].filter(Boolean).join(" "));
    listed(now);
    fill(none, phase === "fresh" && found.length === 0 ? noneMarkup(answer, logic) : html``);
  }

  store.show([form, { update }]);
  return {
    root,
    close() {
      if (store.state.besides[ID].phase === "computing") asking.stop();
      former = store.state.besides[ID];
    },
  };
}
