/**
 * One calculator at work: holds what was typed, asks the service, and tells the views.
 *
 * Every change is read and checked at once; the service is asked 120 ms after the last one (at once
 * on Enter), an older request is aborted, and until the answer is there the results count as stale.
 */
import { newestOnly } from "./api.js";
import { askSections, postingOnce } from "./asking.js";
import { createHistory } from "./history.js";
import { element, html } from "./lib/html.js";
import { message } from "./messages/index.js";
import { inSentence, ofTitle, placed } from "./refusals.js";
import { readState, shownFields, stateFromInput, stepped, textIn } from "./schema_form.js";
import { query } from "./url_state.js";
import { createCompare } from "./views/compare.js";
import { createExamples } from "./views/examples.js";
import { createFigure } from "./views/figure.js";
import { createForm, problemText } from "./views/form.js";
import { createMechanism } from "./views/mechanism.js";
import { createReport } from "./views/report.js";
import { createResults, warningsOf } from "./views/results.js";
import { currentTheme } from "./views/theme.js";
import { createVerdict, spoken } from "./views/verdict.js";
import { createWords } from "./views/words.js";
import { createWorked } from "./views/worked.js";
import { inWords } from "./wording.js";
import { filledInput } from "./worked/inputs.js";

const DEBOUNCE_MS = 120;

export function openWorkbench({ host, calculator, model, client, examples, catalogues, designs, version, state, on }) {
  const words = new Map([
    ...Object.entries(message("quantity")).map(([name, [title]]) => [name, title]),
    ...[...model.fields.values()].map(({ name, title }) => [name, title]),
  ]);
  const newest = newestOnly();
  const tables = new Set();
  const history = createHistory(state);
  const designAnswers = new Map(); // of the designs that are kept, by their inputs
  let reading = readState(model, state);
  let refused = {};
  let drawn = null; // { input, answer, requests } of the results on the screen
  let timer = 0;

  const startOf = (example) => stateFromInput(model, { ...calculator.start, ...example.input });
  const exampleQueries = new Map(
    examples.map((example) => [query(calculator.id, model, startOf(example)), example]),
  );

  const picker = createExamples({
    examples,
    on: {
      picked: (example) => take(startOf(example)),
    },
  });
  const form = createForm({
    model,
    calculator,
    catalogues,
    on: {
      typed: (path, text) => type(path, text),
      step(path, direction, factor) {
        const next = stepped(model.fields.get(path), state.texts[path], direction, factor);
        if (next !== null) type(path, next);
      },
      chosen(choice, option) {
        const seeded = seed(model.choices.find(({ id }) => id === choice), option);
        change({ texts: { ...state.texts, ...seeded }, chosen: { ...state.chosen, [choice]: option } });
      },
      apply() {
        compute();
        if (reading.wrong.length > 0) form.focus(reading.wrong[0]);
      },
    },
  });
  const materialOf = (path, given) => (typeof given === "string"
    ? catalogues[path].find(({ name }) => name === given) : given);
  const verdict = createVerdict();
  const results = createResults({ calculator, words });
  const plain = createWords({ calculator, materialOf });
  const worked = createWorked({
    calculator,
    materialOf,
    on: { print: () => report.print(), save: () => report.save() },
  });
  const figures = calculator.figures.map((figure) => createFigure({
    figure,
    client,
    words,
    on: {
      tabled(id, shown) {
        if (shown) tables.add(id);
        else tables.delete(id);
        compute();
      },
      charted(id, chart) {
        if (id === calculator.drawing.figure) updateDrawing(chart.data.filter(({ mode }) => mode === "lines"));
      },
      picked: (pair) => mechanism.select(pair),
      async tables(of) {
        const { input } = drawn;
        const post = postingOnce(client);
        return of.tables(await calculator.ask({
          post, input, sections: calculator.sections.filter((id) => drawn.answer[id]), tables: new Set([of.id]),
        }));
      },
    },
  }));
  const mechanism = createMechanism({
    calculator,
    on: {
      moved: () => followDrawing(),
      selected: () => followDrawing(),
    },
  });
  const followDrawing = () => {
    for (const figure of figures) figure.follow(mechanism.angle, mechanism.selected);
  };
  const compare = createCompare({
    model,
    calculator,
    on: {
      pin() {
        const { name } = designs.add(calculator.id, drawn.input);
        compareAnew(message("compare.kept", { name }));
      },
      open: ({ input }) => take(stateFromInput(model, input)),
      rename(design, name) {
        designs.rename(design.kept, name);
        compareAnew();
      },
      remove(design) {
        designs.remove(design.kept);
        compareAnew();
      },
      export: () => compare.save(designs.exported()),
      import(text) {
        const count = designs.imported(text);
        compareAnew(count === null ? message("compare.notOurs") : message("compare.imported", { count }));
      },
    },
  });

  const inputs = element(html`<div class="inputs"></div>`);
  inputs.append(picker.root, form.root);
  const outputs = element(html`<div class="outputs" id="results" data-calculator="${calculator.id}" tabindex="-1"></div>`);
  outputs.append(verdict.root, mechanism.root, ...figures.map(({ root }) => root), plain.root, results.root, worked.root, compare.root);
  host.replaceChildren(inputs, outputs);
  const report = createReport({
    calculator, model, catalogues, version, outputs, figures, plain: plain.root, worked,
    shown: () => drawn && { input: drawn.filled, state: drawn.state },
    light: async () => currentTheme() === "dark" && redraw(await keptDesigns(), "light"),
    back: () => currentTheme() === "dark" && compareAnew(),
    failed: (problem) => on.say(message("report.failed", { detail: inSentence(problem, words) })),
  });

  /** The same design in the fields of an option that is still empty, where it can be said so. */
  function seed(choice, option) {
    const { fields } = choice.options.find(({ id }) => id === option);
    if (!fields.every((field) => ["", textIn(field, field.default)].includes(state.texts[field.path]))) return {};
    const values = choice.auto
      ? fromCatalogue(choice, option)
      : calculator.seeds[`${choice.id}.${option}`]?.(reading.input) ?? {};
    return Object.fromEntries(Object.entries(values)
      .filter(([, value]) => typeof value !== "number" || Number.isFinite(value))
      .map(([path, value]) => [path, textIn(model.fields.get(path), value)]));
  }

  function fromCatalogue({ id }, option) {
    const entries = catalogues[id];
    if (option === "named") return { [id]: entries[0]?.name };
    const entry = entries.find(({ name }) => name === state.texts[id]) ?? {};
    return Object.fromEntries([...model.fields.keys()].filter((path) => path.startsWith(`${id}.`))
      .map((path) => [path, entry[path.slice(id.length + 1)]]));
  }

  /** A field lights its dimension in the drawing, and a dimension its field. */
  for (const event of ["pointerover", "focusin"]) {
    form.root.addEventListener(event, ({ target }) => mechanism.light(target.closest("[data-path]")?.dataset.path));
  }
  form.root.addEventListener("pointerleave", () => mechanism.light(null));
  mechanism.root.addEventListener("pointerover", ({ target }) => {
    const paths = target.closest("[data-field]")?.dataset.field.split(" ") ?? [];
    for (const field of form.root.querySelectorAll("[data-path]")) field.classList.toggle("lit", paths.includes(field.dataset.path));
  });
  const listening = new AbortController();
  document.addEventListener("keydown", ({ key }) => {
    if (key !== "Escape" || !mechanism.selected || document.querySelector("dialog[open], :popover-open")) return;
    mechanism.select(mechanism.selected);
  }, { signal: listening.signal });

  function updateDrawing(curves) {
    const { section } = calculator.drawing;
    if (drawn?.answer[section]) mechanism.update(drawn.input, drawn.answer, curves);
  }

  function showForm() {
    form.update({ state, input: reading.input, readings: reading.readings, refused });
  }

  /** `stale` says that the results on the screen are not of the inputs on the screen. */
  function show(status, stale = status !== "fresh") {
    host.dataset.state = status;
    host.dataset.stale = String(stale);
    const current = status === "fresh" ? "fresh" : "part";
    verdict.setState(status, !stale ? current : drawn ? "older" : "none");
  }

  function fieldWords(wrong) {
    return Object.entries(wrong)
      .map(([path, said]) => ofTitle(model.fields.get(path).title, said))
      .join("; ");
  }

  function type(path, text) {
    change({ ...state, texts: { ...state.texts, [path]: text } }, path);
  }

  /** Take over a whole design at once. */
  function take(next) {
    change(next);
    compute();
  }

  function change(next, path) {
    state = next;
    history.record(state, path);
    changed(path);
  }

  function move(next) {
    if (next === null) return;
    state = next;
    changed();
    compute();
  }

  /** After any change: what is typed is checked and shown at once, the answer follows. */
  function changed(path) {
    on.history(history);
    reading = readState(model, state);
    if (path) delete refused[path];
    else refused = {};
    showForm();
    newest.cancel();
    clearTimeout(timer);
    if (reading.wrong.length > 0) {
      showWrong();
    } else {
      show("computing");
    }
    timer = setTimeout(compute, DEBOUNCE_MS);
  }

  function showWrong() {
    show("wrong");
    const said = reading.wrong.map((path) => [path, problemText(reading.readings[path])]);
    const text = fieldWords(Object.fromEntries(said));
    verdict.setMessage("bad", text);
    return text;
  }

  async function compute() {
    clearTimeout(timer);
    const asked = query(calculator.id, model, state);
    picker.setCurrent(exampleQueries.get(asked));
    on.state(asked);
    const { input, wrong } = reading;
    if (wrong.length > 0) {
      on.say(showWrong());
      return;
    }
    show("computing");
    for (const figure of figures) figure.reserve(input);
    const { answer, problem, superseded } = await newest.ask((signal) =>
      askSections({ client, calculator, input, tables, signal }));
    if (superseded) return;
    if (problem) {
      show("offline");
      const text = inSentence(problem, words);
      verdict.setMessage("bad", text);
      on.say(text);
      return;
    }
    settle(input, answer);
  }

  /** The designs kept of this calculator, each with its answer (none where it was refused). */
  async function keptDesigns() {
    return Promise.all(designs.of(calculator.id).map(async (kept) => {
      const key = JSON.stringify(kept.input);
      if (!designAnswers.has(key)) {
        designAnswers.set(key, askSections({
          client, calculator, input: kept.input, tables: new Set(), signal: undefined,
        }).then(({ answer }) => answer, () => null));
      }
      return { ...kept, kept, answer: await designAnswers.get(key) };
    }));
  }

  async function compareAnew(said) {
    if (said) on.say(said);
    const kept = await keptDesigns();
    compare.update(kept, drawn);
    redraw(kept);
  }

  function settle(input, { answer, refusal, requests }) {
    const { refused: atFields, elsewhere } = placed(refusal, shownFields(model, state), words);
    refused = atFields;
    showForm();
    const atBoxes = fieldWords(Object.fromEntries(
      Object.entries(refused).map(([path, { words: said }]) => [path, said]),
    ));
    const refusalText = [...elsewhere, atBoxes].filter(Boolean).join("; ");
    show(!refusal ? "fresh" : atBoxes ? "wrong" : "refused", answer === null);
    if (answer) {
      drawn = { input, answer, requests, state, filled: filledInput(model, state, input) };
      const context = { input: drawn.filled, materialOf };
      const cells = calculator.verdict(answer, context);
      verdict.setCells(cells);
      results.update(answer);
      plain.update(drawn.filled, answer, warningsOf(answer));
      worked.update(drawn.filled, answer);
      for (const figure of figures) {
        if (answer[figure.section]) figure.setTables(answer);
        else figure.clear(refusalText);
      }
      compareAnew();
      // The curves come with the figure; where that stays away, the drawing does without.
      const source = figures.find(({ id }) => id === calculator.drawing.figure);
      if (!source || !answer[source.section] || tables.has(source.id)) updateDrawing(curvesOf(answer));
      if (!refusal) {
        const reasons = calculator.impossible?.(answer, context) ?? [];
        if (reasons.length > 0) {
          verdict.setState("refused", "fresh");
          verdict.setMessage("bad", reasons.join(" "));
        } else {
          const strained = warningsOf(answer).map(({ detail }) => inWords(detail, words));
          verdict.setMessage(...warningLine([...calculator.wanted?.(answer, context) ?? [], ...strained], cells));
        }
        on.say([...reasons, spoken(cells)].join(" "));
      }
    }
    if (!answer && !drawn) for (const figure of figures) figure.clear(refusalText);
    if (refusal) {
      verdict.setMessage("bad", refusalText);
      on.say(refusalText);
    }
  }

  function curvesOf({ contact_force: force }) {
    if (!force?.curves) return [];
    const { crank_angle_deg: x, pairs, force_N: forces } = force.curves;
    return pairs.map(({ satellite, pin }, i) => ({ name: `${satellite}.${pin}`, x, y: forces[i] }));
  }

  function warningLine(sentences, cells) {
    const fine = !cells.some(({ level }) => level === "bad");
    if (sentences.length === 0) return [fine ? "good" : "", message("verdict.noWarnings")];
    const key = sentences.length === 1 ? "verdict.oneWarning" : "verdict.warnings";
    return ["warning", message(key, { count: sentences.length, first: sentences[0] })];
  }

  async function redraw(kept, theme = currentTheme()) {
    if (!drawn) return;
    await Promise.all(figures.filter(({ section }) => drawn.answer[section]).map((figure) => {
      const others = kept.filter(({ answer }) => answer?.[figure.section]);
      return figure.draw(drawn.input, drawn.answer, theme, others);
    }));
  }

  showForm();
  verdict.setCells(calculator.verdict({}));
  for (const figure of figures) figure.reserve(reading.input);
  compare.update([], null);
  on.history(history);
  compute();

  return {
    redraw: () => compareAnew(),
    undo: () => move(history.undo()),
    redo: () => move(history.redo()),
    /** What was asked for the results on the screen, and answered; null where there are none. */
    exchange: () => drawn && { calculator: calculator.id, answer: drawn.answer, requests: drawn.requests },
    /** Stop; what was typed last is told even where it has not been asked about yet. */
    close() {
      clearTimeout(timer);
      newest.cancel();
      listening.abort();
      mechanism.close();
      report.close();
      for (const figure of figures) figure.close();
      on.state(query(calculator.id, model, state));
    },
  };
}
