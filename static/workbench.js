/**
 * One calculator at work: its state (store.js), what is asked of the service (asking.js), and the
 * views, each told of every state. Here they are put together, and what the user does becomes a
 * transition.
 */
import { createAsking } from "./asking.js";
import { partRow } from "./lib/checks.js";
import { MOST, resultsOf } from "./lib/designs.js";
import { element, html } from "./lib/html.js";
import { cellAt, lostOf, shownFields, stateFromInput, textIn, withLinks } from "./lib/form_state.js";
import { entryOf, optionsOf } from "./lib/schema_form.js";
import { lasting, parsed } from "./lib/storage.js";
import { LABELS, query, withVerdict } from "./lib/url_state.js";
import { message, quantityTitle, said, symbolOf } from "./messages/index.js";
import { neglectedIn, problemText } from "./service_texts.js";
import * as next from "./store.js";
import { createChecks } from "./views/checks.js";
import { createDrawingView } from "./views/drawing.js";
import { createExplanation } from "./views/explanation.js";
import { createFigure } from "./views/figure.js";
import { createForm, editing } from "./views/form.js";
import { createNotice } from "./views/notice.js";
import { createPanels } from "./views/panels.js";
import { createPlaces } from "./views/places.js";
import { createSearch } from "./views/search.js";
import { currentTheme } from "./views/settings.js";
import { createNumbers, createVerdict } from "./views/verdict.js";

const UNFOLDED = "outline"; // that all sections of the inputs are open
const AGAIN_MS = 4000; // until the rest of the page is asked for again

let makeRest = null; // what makes the rest of a calculator's page (rest.js), once loaded

/** Load what stands under the figures. */
const loadRest = async () => {
  ({ createRest: makeRest } = await import("./rest.js"));
};

/** A field lights its dimension in the drawing, and a dimension its field. */
function lightEachOther(form, drawing) {
  for (const event of ["pointerover", "focusin"]) {
    form.addEventListener(event, ({ target }) => drawing.light(target.closest("[data-path]")?.dataset.path));
  }
  form.addEventListener("pointerleave", () => drawing.light(null));
  drawing.root.addEventListener("pointerover", ({ target }) => {
    const paths = target.closest("[data-field]")?.dataset.field.split(" ") ?? [];
    for (const field of form.querySelectorAll("[data-path]")) field.classList.toggle("lit", paths.includes(field.dataset.path));
  });
}

/**
 * `modelFor(form)` is a further form; `typed` is the state of the form to begin with, `claim` what its link said besides (lib/url_state.js), `history` that
 * of a design which it follows. `on.left()` tells that another design is to come, `on.cleared(query, history)` that an
 * empty one is, `on.named(title, usual, why)` what it is called, `on.address(query)`, `on.history(canUndo, canRedo)`, `on.whole()` that all of the page is there, `on.say(text)` and `on.tell(text)`, which all see,
 * tell the page around it.
 */
export function openWorkbench({ host, calculator, model, modelFor, client, examples, catalogues, designs, version, calculation, calculations, exports, pdf, typed, claim, history, lengths, on }) {
  const named = (wanted) => [...model.fields.values()].filter((field) => Boolean(field.wanted) === wanted).map(({ name, title }) => [name, title]);
  const titles = new Map([
    ...named(true), ...Object.entries(message("quantity")), ...named(false),
  ]);
  const materialOf = (path, given) => (typeof given === "string"
    ? catalogues[path].find(({ name }) => name === given) : given);
  const about = { model, calculator, catalogues, titles, materialOf };
  const store = next.createStore(next.opened(about, typed, currentTheme(), claim, history));
  const asking = createAsking({ store, client, designs });
  const listening = new AbortController();
  const answered = asking.now(); // while the views are made

  function change(transition, ...values) {
    store.apply(transition, ...values, Date.now());
    asking.soon();
  }

  function changeAtOnce(transition, ...values) {
    const before = store.state.typed;
    store.apply(transition, ...values, Date.now());
    if (store.state.typed !== before) asking.now();
  }

  /** What happens outside follows the state too: it is told of the parts that it asks for. */
  const following = (pick, tell) => ({ update: next.following(pick, (state) => tell(...pick(state))) });
  const select = (pair) => store.apply(next.selected, pair);
  const stateOf = (input, labels) => {
    const { texts, chosen } = withLinks(model, stateFromInput(model, input));
    const named = LABELS.filter((label) => typeof labels?.[label] === "string").map((label) => [label, labels[label]]);
    return { texts: { ...texts, ...Object.fromEntries(named) }, chosen };
  };
  /** Another design, to which Back leads back. */
  function take(typed, claim) {
    on.left();
    changeAtOnce(next.taken, typed, claim);
  }
  const queries = examples.map(({ input }) => query(calculator.id, model, stateOf(input)));
  /** A design that somebody brings: a link, a request or a file of some, designs that were kept; whether it was one. */
  function brought(text) {
    const link = /^\S*\?(\S+)$/.exec(text)?.[1];
    if (link) location.search = link;
    const count = !link && designs.imported(text);
    const [kept] = count ? designs.of(calculator.id).slice(-1) : [];
    const { requests = [], ...single } = parsed(text, {});
    const { body = single } = requests.find(({ path }) => path?.endsWith(calculator.path)) ?? {};
    if (count) on.tell(message("compare.imported", { count }));
    if (count) asking.compare();
    if (kept) take(stateOf(kept.input, kept.labels), { verdict: kept.results?.verdict });
    const ours = !count && Object.keys(body).some((name) => [...model.fields.keys()].some((path) => path.split(".")[0] === name));
    if (ours) {
      const { include, ...input } = calculator.inputOf?.(body) ?? body;
      take(stateOf(input));
      const lost = lostOf(model, input);
      if (lost.length > 0) on.tell(message("compare.lost", { what: lost.join(", ") }));
    }
    return Boolean(link || count || ours);
  }
  const form = createForm({
    model,
    calculator,
    catalogues,
    lengths,
    unfolded: lasting.getItem(UNFOLDED) === "all",
    on: {
      lengths: on.lengths,
      ...editing(store, change),
      act(act, path) {
        rest?.act(act, path);
        if (act !== "size") places.show("shown");
      },
      switched(group, on) {
        changeAtOnce(next.switched, group, on);
        if (!on) return;
        form.open(group);
        panels.open(group);
      },
      asked: (path) => lead(path),
      apply() {
        store.apply(next.insisted);
        asking.now();
        const [first] = store.state.reading.wrong;
        if (first) lead(first);
      },
    },
  });
  let closeStart = null;
  /** The sheet on which a design begins. */
  async function start() {
    const [{ openStart }, [logic, finding] = []] = await Promise.all([import("./views/start.js"), calculator.propose?.()]);
    if (listening.signal.aborted || document.querySelector("dialog[open]")) return;
    closeStart = openStart({
      examples,
      at: examples[queries.indexOf(store.state.address)]?.id,
      pictureOf: logic?.pictureOf,
      proposals: logic && finding.createProposals({ logic, client, titles, modelOf: modelFor, on: {
        opened(design) {
          closeStart();
          take(stateOf(calculator.inputOf(design)));
        },
      } }),
      on: {
        picked: ({ input }) => take(stateOf(input)),
        cleared: () => on.cleared(query(calculator.id, model, stateOf(calculator.blank ?? {})), store.state.history),
        brought,
      },
    });
  }
  const apply = (sets) => changeAtOnce(next.applied, sets);
  const lead = (path) => {
    const { wanted } = model.fields.get(path) ?? {};
    if (wanted && !next.wants(store.state, wanted)) changeAtOnce(next.switched, wanted, true);
    for (const [choice, option] of Object.entries(optionsOf(model, path))) {
      if (store.state.typed.chosen[choice] !== option) changeAtOnce(next.chose, choice, option);
    }
    places.show("inputs");
    form.focus(path);
  };
  const verdict = createVerdict({
    calculator, titles, scope: model.fields.get("requirements.scope")?.options,
    on: {
      again: () => asking.now(),
      asked: (path) => lead(entryOf(model, path)),
      shown(code) {
        places.show("answer");
        checks.show(code);
      },
      /** The first value that a part lacks: at the check that asks for it, else its field. Without parts, the first check that waits. */
      unknown({ parts = [] }) {
        places.show("answer");
        const path = parts.map(partRow).find(({ status, ask }) => status === "open" && ask)?.ask;
        const ask = path && entryOf(model, path);
        if (!ask) checks.show();
        else if (!checks.asks(ask)) lead(ask);
      },
      scoped: (parts) => apply({ "/requirements/scope": parts }),
    },
  });
  const numbers = createNumbers({ calculator });
  const checks = createChecks({
    calculator, titles, fieldAt: (path) => model.fields.get(path) ?? cellAt(model, path)?.field, askedAt: (path) => entryOf(model, path),
    on: {
      fixed: apply,
      asked: lead,
    },
  });
  const drawing = createDrawingView({
    calculator,
    on: { turned: (angle) => store.apply(next.turned, angle), returned: () => store.apply(next.returned), selected: select },
  });
  /** The address of the design as it is typed, which the bar of the browser shows a little later. */
  const addressed = () => withVerdict(query(calculator.id, model, store.state.typed), next.verdictOf(store.state));
  /** What files say of the design at hand. */
  const titleBlock = () => ({
    ...Object.fromEntries(["title", "author", "revision"].map((label) => [label, store.state.typed.texts[label] ?? ""])),
    date: new Date().toISOString().slice(0, 10),
    link: new URL(`?${addressed()}`, location.href).href,
  });
  /** The calculation of the results on the screen, and what it was asked. */
  const calculated = () => {
    const { path, body: input } = store.state.shown.requests.at(-1);
    return { calculation: path.slice(client.base.length + 1), input };
  };
  /** The report of the results on the screen as the service writes it, `{ name, content }`, of a media type. */
  const report = (type) => {
    const { calculation, input: { include, ...input } } = calculated();
    const block = { ...titleBlock(), note: store.state.typed.texts.note ?? "" };
    return client.file("/export/report", { calculation, input, language: document.documentElement.lang, title_block: block }, type);
  };
  const keep = () => {
    if (!store.state.shown) return;
    if (designs.of(calculator.id).length >= MOST) {
      on.tell(message("compare.full", { most: MOST }));
      return;
    }
    const { input, requests, typed: { texts } } = store.state.shown;
    const { path, body } = requests.at(-1);
    const labels = Object.fromEntries(LABELS.filter((label) => texts[label]).map((label) => [label, texts[label]]));
    const { name } = designs.add(calculator.id, input, labels.title?.slice(0, 24), { labels, results: resultsOf(calculator, next.answerNow(store.state)), path, body });
    asking.compare();
    rest?.compare();
    on.tell(message(designs.lasting() ? "compare.kept" : "compare.unsaved", { name }));
  };
  const figureOf = (figure) => createFigure({
    figure,
    client,
    titles,
    on: {
      tabled(id, shown) {
        store.apply(next.tabled, id, shown);
        asking.now();
      },
      charted: (id, data) => store.apply(next.charted, id, data),
      turned: (angle) => store.apply(next.turned, angle),
      set: ([path, value]) => change(next.typedIn, path, textIn(model.fields.get(path), value)),
      picked: (pair) => select(pair === store.state.turn.pair ? null : pair),
      tables: asking.tables,
    },
  });
  const figures = calculator.figures.filter(({ measures }) => !measures)
    .map((figure) => figureOf({ ...figure, leads: figure.id === calculator.drawing.figure }));
  const panels = createPanels({ id: calculator.id, drawing, tall: calculator.drawing.tall, on: { opened: (tab) => store.apply(next.tabbed, tab) } });
  for (const { id, root } of figures) panels.add(id, message(`tab.${id}`), root);
  const explanation = createExplanation({ calculator, materialOf });
  const notice = createNotice({ calculator, on: { closed: () => store.apply(next.unclaimed) } });
  const inputs = element(html`<div class="inputs"></div>`);
  const search = createSearch({
    model,
    all: lasting.getItem(UNFOLDED) === "all",
    signal: listening.signal,
    on: {
      found: (path) => form.focus(path),
      here: () => places.show("inputs"),
      all(shown) {
        lasting.setItem(UNFOLDED, shown ? "all" : "one");
        form.unfold(shown);
      },
    },
  });
  inputs.append(notice.root, search.root, form.root);
  const outputs = element(html`<div class="outputs" id="results" data-calculator="${calculator.id}" tabindex="-1"></div>`);
  const right = element(html`<div class="right"><div class="answer"></div></div>`);
  right.prepend(verdict.root);
  right.lastElementChild.append(...[numbers, explanation, checks].map(({ root }) => root));
  outputs.append(right, panels.root);
  const places = createPlaces({ host, signal: listening.signal });
  host.replaceChildren(places.root, inputs, outputs);
  const enlarge = async (card) => (await import("./views/large.js")).enlarge(card);
  outputs.addEventListener("click", ({ target }) => {
    const button = target.closest(".enlarge");
    if (button) enlarge(button.closest(".figure, .mechanism"));
  });
  lightEachOther(form.root, drawing);
  document.addEventListener("keydown", ({ key }) => {
    if (key === "Escape" && !document.querySelector("dialog[open], :popover-open")) select(null);
  }, { signal: listening.signal });
  addEventListener("storage", () => asking.compare(), { signal: listening.signal }); // kept in another tab
  addEventListener("online", () => asking.now(), { signal: listening.signal });

  let begun = false; // from then on everything keeps its place, and its focus, while it computes
  store.show([
    notice,
    form,
    verdict, numbers, checks, explanation, drawing, ...figures,
    {
      update(state) {
        host.dataset.state = state.phase;
        begun ||= state.shown !== null || state.phase !== "computing";
        host.dataset.begun = String(begun);
        host.dataset.stale = String(next.stale(state));
        host.dataset.impossible = String(next.standing(state).phase === "refused");
      },
    },
    following(({ history: { past, future } }) => [past.length > 0, future.length > 0], on.history),
    following(({ typed, address }) => [typed.texts.title ?? "", examples[queries.indexOf(address)]], (title, example) => {
      document.title = [title, message(`calculator.${calculator.id}`), "KHV Calc"].filter(Boolean).join(" · ");
      on.named(title, example ? said("examples", example.id) : message("bar.unnamed"), example ? message("start.source", example) : "");
    }),
    following(({ said }) => [said], on.say),
    following((state) => [state.address, next.verdictOf(state)], (address, verdict) => address && on.address(withVerdict(address, verdict))),
  ]);

  let rest = null; // once there is time for it
  const addRest = () => {
    if (listening.signal.aborted) return;
    rest = makeRest({
      store, inputs, outputs, panels, client, designs, version, calculation, calculations, figureOf,
      on: {
        opened: (input, labels, claim) => take(stateOf(input, labels), claim),
        applied: apply,
        compared: () => asking.compare(),
      },
    });
    on.whole();
  };
  const load = () => loadRest().then(addRest, () => setTimeout(load, AGAIN_MS));
  const drawn = answered.then(() => Promise.all(figures.map((figure) => figure.settled())));
  if (makeRest) addRest();
  else drawn.finally(load);

  return {
    /** When the first figures are drawn. */
    begun: drawn,
    start,
    labels: () => LABELS.slice(1).map((label) => [label, store.state.typed.texts[label] ?? ""]),
    labelled(label, text) {
      store.apply(next.labelled, label, text, Date.now());
      store.apply(next.addressed);
    },
    /** To the first box. */
    begin: () => lead(shownFields(model, store.state.typed)[0].path),
    retheme: () => store.apply(next.themed, currentTheme()),
    undo: () => changeAtOnce(next.steppedBack),
    redo: () => changeAtOnce(next.steppedOn),
    keep,
    /** The figure at hand in its large view: that of the focus, that under the pointer, else the drawing. */
    enlarge() {
      const card = ".figure, .mechanism";
      const pointed = [...outputs.querySelectorAll(".figure:hover, .mechanism:hover")].at(-1);
      const chosen = [document.activeElement?.closest(card), pointed, drawing.root].find((one) => one && outputs.contains(one));
      if (chosen && !document.querySelector("dialog[open]")) enlarge(chosen);
    },
    report,
    /** Print the report; `ready()` is told just before. Nothing where there are no results. */
    print: (ready = () => {}) => store.state.shown && report("text/html").then(async ({ content }) => {
      const { printReport } = await import("./views/report.js");
      ready();
      return printReport(content);
    }),
    /** What helps to read the page: its symbols, each once, and what the model leaves out. */
    help() {
      const inputs = [...model.fields.values()].flatMap((field) => [field, ...field.columns ?? []])
        .map(({ symbol, title, help }) => [symbol, title, help]);
      const results = Object.entries(store.state.shown?.answer ?? {}).flatMap(([section, values]) => Object.keys(values)
        .map((name) => [symbolOf(name, section), name]).filter(([symbol]) => symbol)
        .map(([symbol, name]) => [symbol, quantityTitle(name, section), ""]));
      return {
        symbols: [...inputs, ...results].filter(([symbol], i, all) => symbol && all.findIndex(([other]) => other === symbol) === i),
        neglected: neglectedIn(calculation),
      };
    },
    /** What was asked for the results on the screen, and answered; null where there are none. */
    exchange: () => store.state.shown && {
      calculator: calculator.id,
      ...store.state.shown,
      pdf,
      answer: next.answerNow(store.state),
      files: [{ id: "xlsx", path: "/export/xlsx", body: calculated() }, ...calculator.files?.(store.state.shown, store.state.turn.angle ?? 0) ?? []]
        .filter(({ path }) => exports.includes(path))
        .map(({ id, path, titled, body }) => ({ id, make: () => client.file(path, titled ? { ...body, title_block: titleBlock() } : body) })),
      refused: (problem) => problemText(problem, titles),
    },
    /** Stop; what was typed last is told even where it has not been asked about yet. */
    close() {
      asking.cancel();
      listening.abort();
      drawing.close();
      panels.close();
      closeStart?.();
      rest?.close();
      for (const figure of figures) figure.close();
      on.address(addressed());
    },
  };
}
