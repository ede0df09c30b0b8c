/** Tabs that are opened from a field's menu: a result over that field and another one, and which inputs matter most. */
import { createBeside } from "../besides.js";
import { pathOf, percent, titleOf } from "../lib/checks.js";
import { formatQuantity, parseSum, typedText } from "../lib/format.js";
import { clicks, element, fill, html } from "../lib/html.js";
import { valueIn } from "../lib/sizing.js";
import { followed, pointsOf, rangeOf, sensitivityBody, sensitivityRows, setsAt, sweepBody, sweptBeside, sweepTable, withPoint } from "../lib/sweep.js";
import { isMap, sweepChart } from "../lib/sweep_chart.js";
import { canonicalValue, shownUnit, spell } from "../lib/units.js";
import { message } from "../messages/index.js";
import { following } from "../store.js";
import { createFigure } from "./figure.js";
import { createRun } from "./run.js";

const NOTHING = {};
const [HEIGHT, MAP_HEIGHT] = [260, 320];
const MOST = 200; // points

/** A tab with what starts it, stops it and says how it stands. */
function createStudied({ id, store, panels, client, bodyOf, path, show, keyOf = (body) => body, head = "" }) {
  const root = element(html`<section class="beside-card explored" data-explored="${id}" aria-label="${message(`${id}.title`)}">${head}</section>`);
  const logic = {
    asked: () => store.state.shown && bodyOf(store.state.shown),
    ask: ({ client: service, body, signal, progressed }) => service.post(path, body, { signal, progressed }),
  };
  const asking = createBeside({ store, client, id, logic });
  const run = createRun({
    run: message("sweep.run"), stop: message("study.stop"), running: message("sweep.running"), idle: message("sweep.idle"),
    on: { run: () => logic.asked() && asking.ask(), stop: () => asking.stop() },
  });
  root.append(run.root);
  panels.add(id, message(`tab.${id}`), root, { offered: false });
  return {
    root,
    open() {
      panels.offer(id, true);
      panels.open(id, false);
      if (logic.asked()) asking.ask();
    },
    cancel: () => asking.cancel(),
    update(state) {
      const { phase, progress, answer, body, of, refusal } = state.besides[id] ?? NOTHING;
      const [now, then] = answer ? [logic.asked(), JSON.parse(of)].map((one) => one && JSON.stringify(keyOf(one, answer))) : [];
      const older = now !== then;
      const words = {
        computing: progress === undefined ? message("sweep.running") : message("study.done", { percent: Math.round(100 * progress) }),
        stopped: message("besides.stopped"), refused: refusal?.text, failed: refusal?.text,
      }[phase] ?? (answer ? "" : message("sweep.idle"));
      const unread = state.shown && !logic.asked() && message("sweep.wrong", { most: MOST });
      run.update({ phase, progress }, unread || [words, older && message("besides.older")].filter(Boolean).join(" "));
      root.dataset.stale = String(older || phase === "computing");
      show(state, answer, body);
    },
  };
}

/** A result over a field: a figure and a table whose points are designs that a click loads. */
function createSweep({ store, on, ...parts }) {
  const { calculator, model, titles } = store.state.about;
  let about = null; // { field, beside, quantities } of the boxes
  let points = [];
  let drawn = null; // what is drawn, as the results of a design
  const table = (button) => [sweepTable(points, drawn.fields, drawn.quantity, button)];
  const figure = createFigure({
    figure: {
      id: "sweep", section: "sweep", path: "", height: () => (drawn && isMap(drawn.fields, drawn.quantity) ? MAP_HEIGHT : HEIGHT),
      body: (_input, answer) => answer.sweep,
      sets: ({ customdata }) => customdata,
      tables: () => table((text, i) => html`<button type="button" class="link" data-load="${i}">${text}</button>`),
    },
    client: { post: async (_path, _answer, { query: { theme } }) => sweepChart(points, drawn.fields, drawn.quantity, drawn.fields.map((field) => valueIn(store.state.shown, field)), theme) },
    titles,
    on: {
      charted() {}, turned() {}, picked() {},
      set: (i) => i !== undefined && load(i),
      tabled() {
        drawn = { ...drawn };
        tab.update(store.state);
      },
      tables: async () => table(),
    },
  });
  const tab = createStudied({
    ...parts, id: "sweep", store, path: "/sweep", head: html`<div class="swept"></div>`,
    bodyOf: (shown) => about && ranges() && sweepBody(calculator, shown, ranges(), about.quantities[part("quantity").value]),
    keyOf: withPoint,
    show(state, answer, body) {
      if (drawn && drawn.of !== state.shown) drawn = { ...drawn, of: state.shown }; // the design at hand is another one
      if (answer && drawn?.answer.sweep !== answer) {
        const { axes, outputs: [output] } = body;
        const fields = axes.map(({ pointer }) => model.fields.get(pathOf(pointer)));
        const quantity = followed(calculator, state.shown.answer, fields[0].path).find((one) => one.pointer === output);
        drawn = { fields, quantity, of: state.shown, answer: { sweep: answer }, input: NOTHING, filled: NOTHING, requests: [] };
        points = pointsOf(answer, quantity, titles);
      }
      figure.update({ ...state, shown: drawn, kept: null, phase: "fresh", refusal: null, pending: drawn ?? NOTHING });
    },
  });
  const part = (name) => tab.root.querySelector(`[data-part="${name}"]`);
  const load = (i) => on.applied(setsAt(drawn.answer.sweep, i, store.state.shown));

  /** What the boxes of a field say, in canonical units; null where one cannot be read. */
  function range(field, which) {
    const [from, to, steps] = ["from", "to", "steps"].map((name) => parseSum(part(name + which).value).value);
    if (!Number.isFinite(from) || !Number.isFinite(to) || from === to || !Number.isInteger(steps) || steps < 2) return null;
    return { field, from: canonicalValue(from, field.unit), to: canonicalValue(to, field.unit), steps };
  }

  function ranges() {
    const found = [range(about.field, ""), ...(about.beside ? [range(about.beside, "2")] : [])];
    return found.every(Boolean) && found.reduce((points, { steps }) => points * steps, 1) <= MOST ? found : null;
  }

  const box = (name, value) => html`<label>${message(`sweep.${name.replace("2", "")}`)} <input class="box free-text" data-part="${name}" inputmode="decimal" autocomplete="off" value="${value}"></label>`;

  function boxes(field, which) {
    const { from, to, steps } = rangeOf(field, store.state.shown, which !== "");
    return html`${box(`from${which}`, typedText(spell(from, field.unit)))}${box(`to${which}`, typedText(spell(to, field.unit)))}${box(`steps${which}`, String(steps))}
      ${shownUnit(field.unit)}`;
  }

  tab.root.append(figure.root, element(html`<p class="note">${message("sweep.click")}</p>`));
  clicks(tab.root, "load", (at) => load(Number(at)));
  tab.root.querySelector(".swept").addEventListener("input", ({ target }) => {
    if (target.dataset.part === "beside") {
      about.beside = model.fields.get(target.value);
      fill(tab.root.querySelector(".beside-of"), about.beside ? boxes(about.beside, "2") : "");
    }
    tab.update(store.state);
  });
  return {
    ...tab,
    open({ path }) {
      const field = model.fields.get(path);
      about = { field, quantities: followed(calculator, store.state.shown.answer, path) };
      const option = ({ path: value, title }) => html`<option value="${value}">${title}</option>`;
      fill(tab.root.querySelector(".swept"), html`<p><b>${field.title}</b> ${boxes(field, "")}</p>
        <p><label>${message("sweep.beside")} <select class="box" data-part="beside"><option value="">–</option>${sweptBeside(model, store.state.shown, field)
          .map(([title, fields]) => html`<optgroup label="${title}">${fields.map(option)}</optgroup>`)}</select></label> <span class="beside-of"></span></p>
        <p><label>${message("sweep.quantity")} <select class="box" data-part="quantity">${about.quantities.map(({ id, title }) => html`<option value="${id}">${title}</option>`)}</select></label></p>`);
      tab.open();
    },
    close() {
      tab.cancel();
      figure.close();
    },
  };
}

/** The inputs that change the utilisation that governs, the largest change first; each leads to its sweep. */
function createSensitivity({ on, ...parts }) {
  const { calculator, model } = parts.store.state.about;
  const fieldAt = (path) => model.fields.get(path);
  const bar = ({ share }) => html`<svg class="change" viewBox="-100 0 200 8" preserveAspectRatio="none" aria-hidden="true"><rect class="whole" x="-100" width="200" height="8"/>
    <rect class="${share > 0 ? "more" : "less"}" x="${Math.round(Math.min(0, 100 * share))}" width="${Math.round(Math.abs(100 * share))}" height="8"/></svg>`;
  const side = (one) => html`<td title="${one.at}${one.check && `: ${one.check}`}">${bar(one)}${one.text} <span class="note">${one.at}</span></td>`;
  const outcome = following((_answer) => [_answer], (answer) => {
    if (!answer) return;
    const at = answer.torque_Nm === undefined ? "" : message("sensitivity.at", { torque: formatQuantity(answer.torque_Nm, "N·m") });
    fill(tab.root.querySelector(".outcome"), html`<p class="note">${message("sensitivity.of", { check: titleOf({ code: answer.governing }), used: percent(answer.result) })} ${at}</p>
      <div class="grid-rows" tabindex="0" role="region" aria-label="${message("tab.sensitivity")}"><table class="data"><thead><tr>
        ${["input", "less", "more"].map((name) => html`<th scope="col">${message(`sensitivity.${name}`)}</th>`)}</tr></thead>
      <tbody>${sensitivityRows(answer, fieldAt).map(({ path, title, sides }) => html`<tr>
        <th scope="row"><button type="button" class="link" data-sweep="${path}">${title}</button></th>${sides.map(side)}</tr>`)}</tbody></table></div>`);
  });
  const tab = createStudied({
    ...parts, id: "sensitivity", path: "/sensitivity",
    bodyOf: (shown) => sensitivityBody(calculator, shown, fieldAt),
    show: (_state, answer) => outcome(answer),
  });
  tab.root.append(element(html`<div class="outcome"></div>`));
  clicks(tab.root, "sweep", (path) => on.swept(fieldAt(path)));
  return tab;
}

/** `on.applied(sets)` takes the values of a point over. */
export function createExplore({ on, ...parts }) {
  const sweep = createSweep({ ...parts, on });
  const sensitivity = createSensitivity({ ...parts, on: { swept: sweep.open } });
  return {
    sweep: sweep.open,
    sensitivity: sensitivity.open,
    update(state) {
      sweep.update(state);
      sensitivity.update(state);
    },
    close() {
      sweep.close();
      sensitivity.cancel();
    },
  };
}
