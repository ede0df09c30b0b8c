/** The form of a calculator: groups of fields and choices, made from the form model. */
import { exactText, formatNumber, formatQuantity, quantityParts } from "../format.js";
import { element, html } from "../lib/html.js";
import { message, translated } from "../messages/index.js";
import { textIn } from "../schema_form.js";
import { createChoice } from "./choice.js";
import { createField } from "./field.js";
import { createRows } from "./rows.js";

function choiceAbout(choice) {
  const own = choice.auto ? null : message(`choice.${choice.id}`);
  return {
    id: choice.id,
    title: own ? own.title : choice.title,
    options: choice.options.map(({ id }) => ({ id, title: own ? own[id] : message(`form.${id}`) })),
  };
}

/** What is wrong with a box, in words; nothing for one that can be read. */
export function problemText(reading) {
  if (!reading?.problem) return "";
  const limit = reading.limit === undefined ? "" : formatNumber(reading.limit);
  const words = message(`problem.${reading.problem}`, { limit });
  if (reading.row === undefined) return words;
  return message("rows.problem", { row: reading.row + 1, title: reading.column.title, words });
}

/** What a table knows about a name: shown under the box as the values that will be used. */
function properties(entry) {
  if (!entry) return "";
  const limit = entry.limits.find(({ criterion }) => criterion === "endurance");
  return message("form.properties", {
    modulus: formatQuantity(entry.youngs_modulus_GPa, "GPa"),
    ratio: formatNumber(entry.poissons_ratio),
    limit: limit ? message("form.allowable", {
      pressure: formatQuantity(limit.pressure_MPa, "MPa"),
      criterion: translated(limit.criterion),
      source: translated(limit.source),
    }) : message("form.noLimit"),
  });
}

/**
 * `on.typed(path, text)`, `on.step(path, direction, factor)`, `on.chosen(choice, option)` and
 * `on.apply()` report what the user does; `update` shows a state.
 */
export function createForm({ model, calculator, catalogues, on }) {
  const root = element(html`<form class="form" novalidate aria-label="${message("form.inputs")}"></form>`);
  root.addEventListener("submit", (event) => {
    event.preventDefault();
    on.apply();
  });
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || event.target.closest("button")) return;
    event.preventDefault();
    on.apply();
  });

  const fields = new Map();
  const choices = new Map();
  let suggested = {};

  function addField(field, host) {
    const create = field.kind === "records" ? createRows : createField;
    const view = create(field, {
      suggestion: calculator.suggestions[field.path],
      on: {
        typed: (text) => on.typed(field.path, text),
        step: (direction, factor) => on.step(field.path, direction, factor),
        suggest: () => {
          on.typed(field.path, textIn(field, suggested[field.path]));
          view.focus();
        },
      },
    });
    fields.set(field.path, view);
    host.append(view.root);
  }

  for (const group of model.groups) {
    const part = element(html`
      <fieldset class="group card" data-group="${group.id}"><legend>${message(`group.${group.id}`)}</legend></fieldset>`);
    const rarely = group.items.filter((item) => item.advanced);
    for (const item of group.items.filter((one) => !one.advanced)) {
      if (item.path) {
        addField(item, part);
        continue;
      }
      const view = createChoice(choiceAbout(item), { on: { chosen: (option) => on.chosen(item.id, option) } });
      choices.set(item.id, view);
      for (const option of item.options) {
        for (const field of option.fields) addField(field, view.part(option.id));
      }
      part.append(view.root);
    }
    if (rarely.length > 0) {
      const more = element(html`<details class="more"><summary>${message("form.more")}</summary></details>`);
      for (const field of rarely) addField(field, more);
      part.append(more);
    }
    root.append(part);
  }

  function noteOf(field, reading, state) {
    if (reading?.readAs !== undefined) return message("form.readAs", { value: exactText(reading.readAs) });
    const entries = catalogues[field.path];
    return entries ? properties(entries.find(({ name }) => name === state.texts[field.path])) : "";
  }

  return {
    root,
    focus: (path) => fields.get(path).focus(),
    /** Show texts, choices and messages; `refused` holds the service's words by field path. */
    update({ state, input, readings, refused }) {
      for (const [id, view] of choices) view.setChosen(state.chosen[id]);
      for (const [path, field] of model.fields) {
        const view = fields.get(path);
        const reading = readings[path];
        const special = field.advanced && state.texts[path] !== textIn(field, field.default);
        if (special) view.root.closest("details").open = true;
        const names = catalogues[path] ?? field.options?.map((name) => ({ name }));
        if (names) view.setNames(names, state.texts[path]);
        view.setText(state.texts[path]);
        view.setMessage({
          error: problemText(reading) || (refused[path]?.words ?? ""),
          note: noteOf(field, reading, state),
          place: reading?.problem && reading.row !== undefined
            ? { row: reading.row, column: reading.column.name }
            : refused[path]?.place,
        });
      }
      suggested = {};
      for (const [path, { formula, value }] of Object.entries(calculator.suggestions)) {
        const amount = value(input);
        const possible = Number.isFinite(amount);
        if (possible) suggested[path] = amount;
        const { title, required, unit } = model.fields.get(path);
        const shown = possible ? formatQuantity(amount, unit) : formula;
        fields.get(path).setSuggestion({
          possible,
          label: message("form.suggestion", { title, formula, value: shown }),
        });
        if (!required) fields.get(path).setPlaceholder(possible ? quantityParts(amount, unit).value : formula);
      }
    },
  };
}
