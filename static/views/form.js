/** The form of a calculator: an outline of sections with fields and choices, made from the form model. */
import { ALL, formatNumber, formatQuantity, inNumerals, quantityParts } from "../lib/format.js";
import { judgedOf, levelOfCheck, pathOf, sizedBy } from "../lib/checks.js";
import { element, html } from "../lib/html.js";
import { lineOf } from "../lib/outline.js";
import { message, said } from "../messages/index.js";
import { shownUnit } from "../lib/units.js";
import { shownFields, stepped, textIn } from "../lib/form_state.js";
import { fieldsOf } from "../lib/schema_form.js";
import { chose, following, left, readingText, refusedAt, typedIn, unread, wants } from "../store.js";
import { createField } from "./field.js";
import { createRecords } from "./rows.js";
import { createSection } from "./section.js";
import { createMenu } from "./menu.js";
import { createNames, createSwitch } from "./wanted_fields.js";

function choiceAbout(choice) {
  const own = choice.auto ? null : message(`choice.${choice.id}`);
  return {
    id: choice.id,
    title: own ? own.title : choice.title,
    options: choice.options.map(({ id }) => ({ id, title: own ? own[id] : message(`form.${id}`) })),
  };
}

/** A value with its spread: "23 (23–65) MPa". */
function spread(value, { low, high } = {}, unit) {
  if (!(high > low)) return formatQuantity(value, unit);
  return `${formatNumber(value)} (${formatNumber(low)}\u2013${formatNumber(high)})\u00a0${shownUnit(unit)}`;
}

/** Of a material whose sources differ: its values, from where to where they go, and where the strength comes from. */
function sourced({ youngs_modulus_GPa: modulus, poissons_ratio: ratio, strength_source: given, facts = [], ...entry }) {
  const found = Object.fromEntries(facts.map((fact) => [fact.name, fact]));
  const name = entry.strength_in_plane_MPa === undefined ? "yield_strength_MPa" : "strength_in_plane_MPa";
  const { seen = "two", source = given } = found[name] ?? {};
  return [
    modulus !== undefined && `E = ${spread(modulus, found.youngs_modulus_GPa, "GPa")}`,
    ratio === undefined ? message("form.byValues") : `ν = ${formatNumber(ratio)}`,
    entry[name] !== undefined && message(seen === "one" ? "form.reference" : "form.strength", { strength: spread(entry[name], found[name], "MPa"), source: inNumerals(source ?? "") }),
  ].filter(Boolean).join(", ");
}

/** What a table knows about a name: shown under the box as the values that will be used. */
function properties(entry) {
  if (!entry) return "";
  if (entry.facts || entry.youngs_modulus_GPa === undefined) return sourced(entry);
  const limit = entry.limits.find(({ criterion }) => criterion === "endurance");
  return message("form.properties", {
    modulus: formatQuantity(entry.youngs_modulus_GPa, "GPa"),
    ratio: formatNumber(entry.poissons_ratio),
    limit: limit ? message("form.allowable", {
      pressure: formatQuantity(limit.pressure_MPa, "MPa"),
      criterion: said("criteria", limit.criterion) ?? limit.criterion,
      source: said("sources", limit.source_code) ?? limit.source,
    }) : message("form.noLimit"),
  });
}

/** Radio buttons of which one is chosen, and its fields shown under them. */
function createChoice({ id, title, options }, { on }) {
  const name = `choice-${id.replaceAll(".", "-")}`;
  const root = element(html`
    <fieldset class="choice" data-choice="${id}">
      <legend>${title}</legend>
      <div class="segments">${options.map((option) => html`
        <label class="segment"><input type="radio" name="${name}" value="${option.id}"><span>${option.title}</span></label>`)}
      </div>
      ${options.map((option) => html`<div class="option" data-option="${option.id}"></div>`)}
    </fieldset>`);
  root.querySelector(".segments").addEventListener("change", (event) => on.chosen(event.target.value));
  const parts = [...root.querySelectorAll(".option")];
  return {
    root,
    part: (option) => parts.find((part) => part.dataset.option === option),
    setChosen(chosen) {
      for (const radio of root.querySelectorAll("input[type=radio]")) {
        if (radio.name === name) radio.checked = radio.value === chosen;
      }
      for (const part of parts) part.hidden = part.dataset.option !== chosen;
    },
  };
}

/** What typing and choosing in a form do to its state, by `change(transition, ...values)`. */
export const editing = (store, change) => ({
  typed: (path, text) => change(typedIn, path, text),
  step(path, direction, factor) {
    const text = stepped(store.state.about.model.fields.get(path), store.state.typed.texts[path], direction, factor);
    if (text !== null) change(typedIn, path, text);
  },
  left: (path) => store.apply(left, path),
  chosen: (choice, option) => change(chose, choice, option),
});

/** The series of a bearing of the table, by its name; nothing for another word. */
const seriesOf = (name) => name.match(/^(?:R?NA\d\d|N[UJ]\d|HK|MR|6\d)(?=[\d/])/)?.[0];

/**
 * `label` names it; `unfolded`, whether all its sections are open. `on.typed(path, text)`, `on.step(path, direction, factor)`, `on.left(path)`, `on.chosen(choice, option)`,
 * `on.apply()`, `on.lengths(option)`, `on.act(act, path)`, `on.switched(group, on)`, `on.asked(path)`.
 */
export function createForm({ model, calculator, catalogues, lengths, unfolded = false, label = message("form.inputs"), on }) {
  const root = element(html`<form class="form" novalidate aria-label="${label}"></form>`);
  root.addEventListener("submit", (event) => {
    event.preventDefault();
    on.apply();
  });
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || event.target.closest("button, summary")) return;
    event.preventDefault();
    on.apply();
  });

  const help = element(html`<div class="help-line" aria-hidden="true"><p class="help"></p></div>`);
  const helpAt = (node) => {
    const field = model.fields.get(node?.closest("[data-path]")?.dataset.path);
    help.firstElementChild.textContent = field && field.kind !== "records" && field.kind !== "switch" ? field.help : "";
  };
  root.addEventListener("focusin", ({ target }) => helpAt(target));
  root.addEventListener("focusout", ({ target, relatedTarget }) => {
    const at = target.closest("[data-path]");
    if (at && !at.contains(relatedTarget)) on.left(at.dataset.path);
    if (!root.contains(relatedTarget)) helpAt(null);
  });

  const menu = createMenu({ acts: ["size", "sweep", "sensitivity"], on: on.act });
  const { suggestions = {} } = calculator;
  const fields = new Map();
  const choices = new Map();
  const apart = new Set(); // of what follows another box, what has been said by itself
  let suggested = {};

  const creates = (field) => ({ records: createRecords, names: createNames, switch: createSwitch })[field.kind] ?? createField;

  function addField(field, host) {
    const view = creates(field)(field, {
      suggestion: suggestions[field.path],
      sizable: ["number", "integer"].includes(field.kind) && !suggestions[field.path],
      on: {
        switched: (chosen) => on.switched(field.wanted, chosen),
        menu: (button) => menu.open(button, field.path),
        typed: (text) => on.typed(field.path, text),
        step: (direction, factor) => on.step(field.path, direction, factor),
        asked: on.asked,
        /** What follows others does so while it is empty; else the value itself is put in. */
        suggest: () => {
          on.typed(field.path, suggestions[field.path].linked ? "" : textIn(field, suggested[field.path]));
          view.focus();
        },
      },
    });
    fields.set(field.path, view);
    host.append(view.root);
  }

  /** How radii are shown and typed, at the first group that has any. */
  function addLengths(part) {
    const options = ["radius", "diameter"].map((id) => ({ id, title: message(`form.${id}`) }));
    const view = createChoice({ id: "lengths", title: message("form.lengths"), options }, { on: { chosen: on.lengths } });
    view.setChosen(lengths);
    part.append(view.root);
  }

  /** A group that is off until wanted: its switch, and once that is on its fields. */
  function addWanted({ id, items: [gate, ...items] }, section) {
    addField(gate, section.root);
    section.root.prepend(fields.get(gate.path).root); // before the fields that it brings
    section.root.classList.add("wanted");
    section.rows.append(element(html`<p class="note">${gate.help}</p>`));
    let added = false;
    return (state) => {
      if (added || !wants(state, id)) return;
      added = true;
      const host = element(html`<div class="wanted-fields"></div>`);
      section.add(items, (item) => item.advanced, addItem, host);
      section.rows.append(host);
    };
  }

  /** A field or a choice of the form. */
  function addItem(item, part) {
    if (item.path) {
      addField(item, part);
      return;
    }
    const view = createChoice(choiceAbout(item), { on: { chosen: (option) => on.chosen(item.id, option) } });
    choices.set(item.id, { ...view, parts: item.options.flatMap((option) => option.fields) });
    for (const option of item.options) {
      for (const field of option.fields) addField(field, view.part(option.id));
    }
    part.append(view.root);
  }

  const isRadius = ({ name = "" }) => name.endsWith("_radius_mm");
  const firstRadius = model.groups.find(({ items }) => items.some(isRadius));
  const wanted = [];
  const sections = new Map(); // by the ids of their groups
  const groupAt = new Map(model.groups.flatMap(({ id, items }) => items.flatMap(fieldsOf).map(({ path }) => [path, id])));
  for (const group of model.groups) {
    const title = group.wanted ? group.items[0].title : message(`group.${group.id}`);
    const section = createSection({ id: group.id, title });
    sections.set(group.id, section);
    if (group === firstRadius) addLengths(section.rows);
    if (group.wanted) wanted.push(addWanted(group, section));
    else section.add(group.items, (item) => item.advanced, addItem);
    root.append(section.root);
  }
  sections.values().next().value.details.open = true;

  /** One section at a time is open, or all. */
  function unfold(all) {
    for (const { details, reveal } of sections.values()) {
      details.name = all ? "" : label;
      if (!all) continue;
      details.open = true;
      reveal();
    }
  }
  unfold(unfolded);
  root.append(menu.root, element(html`<p class="legend note">${["typed", "follows", "usual"].map((origin) => html`<span data-origin="${origin}">${message(`form.origin.${origin}`)}</span>`)}</p>`), help);

  function noteOf(field, reading, text, filled) {
    if (reading?.readAs !== undefined) return message("form.readAs", { value: String(reading.readAs) });
    if (reading?.worked) return `= ${formatQuantity(reading.value, field.unit, ALL)}`;
    const entries = catalogues[field.path];
    if (entries) return properties(entries.find(({ name }) => name === text));
    return suggestions[field.path]?.note?.(filled) ?? "";
  }

  /** The names of a table; none of them is one too where the box may be empty. */
  const namesOf = ({ path, required, default: preset }) => (required || preset || !catalogues[path]
    ? catalogues[path] : [{ name: "", title: path in (calculator.alike ?? {}) ? message("form.alike") : "–" }, ...catalogues[path]]);

  /** Texts, choices and messages. A field that nobody has touched asks: it is not called wrong. */
  function show(state) {
    const { typed: { texts, chosen }, reading: { readings, filled, besides } } = state;
    const missing = [...unread(state).missing, ...unread(state, Object.values(besides).flat()).missing];
    const shown = new Set(shownFields(model, state.typed));
    for (const add of wanted) add(state);
    for (const [id, view] of choices) view.setChosen(chosen[id]);
    for (const { root: place, parts } of choices.values()) {
      if (parts.some(({ when }) => when)) place.hidden = !parts.some((field) => shown.has(field));
    }
    for (const id of Object.keys(calculator.alike ?? {})) {
      const { root: place } = choices.get(id) ?? {};
      if (chosen[id] !== "named" || texts[id]) apart.add(id);
      if (place) place.hidden = !apart.has(id);
    }
    for (const [path, field] of model.fields) {
      const view = fields.get(path);
      if (field.wanted) {
        const group = view?.root.closest(".wanted-fields");
        if (group) group.hidden = !wants(state, field.wanted);
        if (view && field.kind !== "switch") view.root.hidden = !shown.has(field);
        if (!view || !shown.has(field)) continue;
      }
      const reading = missing.includes(path) ? {} : readings[path];
      const usual = texts[path] === textIn(field, field.default);
      const folded = view.root.closest("details.more");
      if (folded && !usual) folded.open = true;
      view.root.dataset.origin = texts[path] === "" ? "empty" : usual ? "usual" : "typed";
      const names = namesOf(field) ?? field.options?.map((name) => ({ name, title: name === "" ? "–" : message("option")[name], group_code: seriesOf(name) }));
      if (names) view.setNames?.(names, texts[path]);
      view.setText(field.kind === "switch" && !wants(state, field.wanted) ? "" : texts[path]);
      if (field.rows) view.setRows(field.rows(filled));
      if (field.empty) view.setPlaceholder(message(`form.${field.empty}`));
      if (field.follows) view.setPlaceholder(reading?.followed ? textIn(field, reading.value) : "");
      const refused = refusedAt(state, path);
      const asks = Boolean(refused?.code) && state.phase === "incomplete";
      view.setMessage({
        error: readingText(reading) || (!asks && refused?.words) || "",
        note: asks ? refused.words : noteOf(field, reading, texts[path], filled),
        ask: refused?.ask && { path: refused.ask, title: model.fields.get(refused.ask)?.title },
        place: reading?.row === undefined ? refused?.place : { row: reading.row, column: reading.column.name },
      });
    }
  }

  /** The line of each section: what its boxes say. */
  function summarise({ typed: { texts }, reading: { readings } }, shown) {
    const valueOf = (path) => shown.has(model.fields.get(path)) && texts[path] !== "" && [model.fields.get(path), readings[path]?.value];
    for (const [id, section] of sections) section.summarise(lineOf(calculator.lines?.[id] ?? "", valueOf));
  }

  /** The worst of the checks that hang on each section, and of its boxes. */
  const judge = following(({ shown, reading, touched, insisted, refusal }) => [shown, reading, touched, insisted, refusal], (state) => {
    const levels = new Map([...sections.keys()].map((id) => [id, []]));
    const at = (path, level) => levels.get(groupAt.get(path) ?? groupAt.get([...groupAt.keys()].find((one) => one.startsWith(`${path}.`))))?.push(level);
    for (const check of judgedOf(calculator, state.shown?.answer)?.checks ?? []) {
      for (const path of new Set((check.inputs ?? []).map(pathOf))) at(path, levelOfCheck(check));
    }
    for (const path of [...unread(state).wrong, ...Object.keys(state.refusal?.at ?? {})]) at(path, "bad");
    for (const [id, section] of sections) section.judge(levels.get(id));
  });

  /** What the theory gives from the other boxes. */
  function suggest(filled, texts) {
    suggested = {};
    for (const [path, { formula: formed, value, linked }] of Object.entries(suggestions)) {
      const formula = typeof formed === "function" ? formed(filled) : formed;
      const amount = value(filled);
      const possible = Number.isFinite(amount);
      if (possible) suggested[path] = amount;
      const { title, unit } = model.fields.get(path);
      const shown = possible ? formatQuantity(amount, unit, ALL) : "–";
      fields.get(path).setSuggestion({
        formula,
        possible: possible || linked,
        pressed: linked && texts[path] === "",
        // As it is seen, with its indices set low: who speaks to the page says that.
        label: message(linked ? "form.link" : "form.suggestion", { title, formula: formula.replaceAll("_", ""), value: shown }),
      });
      if (linked) fields.get(path).setPlaceholder(possible ? quantityParts(amount, unit, ALL).value : "");
    }
  }

  /** What the service has put in for an empty box, where nothing else is said there. */
  const assume = following(({ shown, typed, refusal, touched, insisted }) => [shown, typed, refusal, touched, insisted, fields.size], ({ shown, typed: { texts } }) => {
    const assumed = new Map((judgedOf(calculator, shown?.answer)?.assumed ?? []).map(({ pointer, value }) => [pathOf(pointer), value]));
    for (const [path, view] of fields) {
      const field = model.fields.get(path);
      if (texts[path] !== "" || !view.setAssumed || field.empty || field.follows || suggestions[path]?.linked) continue;
      const value = assumed.get(path);
      view.setAssumed(typeof value === "string" ? said("materials", value) ?? message("option")[value] ?? value : textIn(field, value));
    }
  });

  /** A value may be looked for where a check hangs on the field. */
  const sizes = following(({ shown }) => [shown, fields.size], ({ shown }) => {
    const inputs = new Set(sizedBy(judgedOf(calculator, shown?.answer)).flatMap((check) => check.inputs ?? []).map(pathOf));
    for (const [path, view] of fields) view.setSizable?.(inputs.has(path));
  });
  const refused = (besides) => Object.values(besides).filter(({ refusal }) => refusal);
  const boxes = following(({ typed, refusal, besides, touched, insisted }) => [
    typed, refusal, touched, insisted, refused(besides).length, ...refused(besides),
  ], (state) => {
    show(state);
    summarise(state, new Set(shownFields(model, state.typed)));
    suggest(state.reading.filled, state.typed.texts);
  });
  return {
    root,
    /** To a box. What is not asked of such a design gives way to the first of its section, what is off to its switch. */
    focus(path) {
      const group = groupAt.get(path);
      const { root: section, details, reveal } = sections.get(group);
      details.open = true;
      if (fields.get(path)?.root.closest(".beyond")) reveal();
      fields.get(path)?.root.closest("details.more")?.setAttribute("open", "");
      const seen = ([at, { root: own }]) => section.contains(own) && own.getClientRects().length > 0 && model.fields.get(at).kind !== "switch";
      const own = [...fields].filter(seen);
      (own.find(([at]) => at === path) ?? own[0] ?? [null, fields.get(`${group}.on`)])[1].focus();
    },
    open: (group) => sections.get(group).details.setAttribute("open", ""),
    unfold,
    update(state) {
      boxes(state);
      assume(state);
      sizes(state);
      judge(state);
    },
  };
}
