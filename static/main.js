/**
 * The page: its header, the open calculator, the address, what the browser remembers. Start here.
 *
 * workbench.js   one calculator at work: store.js (its state and transitions, pure), asking.js
 *                (requests to the service), views/ (each shows the state and reports what the user does);
 *                rest.js, what the first figure does not need, is loaded after it
 * calculators/   a folder for each: what the schema cannot say, its drawing, worked steps, sentences
 * service_texts  refusals, warnings and figures of the service in words; messages/, the page's own texts
 * lib/           without DOM: the form as data, units, numbers, links, formulas, parts of drawings
 */
import { CALCULATORS, calculatorOf } from "./calculators/index.js";
import { createClient, newestOnly } from "./lib/api.js";
import { createDesigns } from "./lib/designs.js";
import { stateFromInput } from "./lib/form_state.js";
import { element, html } from "./lib/html.js";
import { formModel } from "./lib/schema_form.js";
import { lasting, parsed, session } from "./lib/storage.js";
import { setDiameters, setUnits, SYSTEMS } from "./lib/units.js";
import { decodeState } from "./lib/url_state.js";
import { message, ownWords, setWords, useLanguage } from "./messages/index.js";
import { namedIn, passingText } from "./service_texts.js";
import { createBar } from "./views/bar.js";
import { chosenTheme, createSettings, onSystemTheme, setTheme } from "./views/settings.js";
import { createTabs } from "./views/tabs.js";
import { openWorkbench } from "./workbench.js";

const KEPT = "khv-calc.open";
const MET = "khv-calc.met"; // that the sheet on which a design begins was seen
const UNWRITTEN = "khv-calc.address";
const WRITTEN = "khv-calc.written";
const ADDRESS_MS = 300; // after the last change of the address
const WRITING_MS = 1000; // until the browser loads what has been written
const AGAIN_MS = 4000; // until the page tries again to start
const TOLD_MS = 5000;
const client = createClient();
let service = null;

/** What the service says of itself, asked for already at the head of the page; after a failure anew. */
function described() {
  service ??= Promise.all(["/openapi.json", "/examples", "/materials", "/calculations", `/words?language=${language}`].map((path) => client.get(path)))
    .then((descriptions) => {
      setWords(descriptions.at(-1), namedIn(descriptions));
      return descriptions;
    })
    .catch((problem) => {
      service = null;
      throw problem;
    });
  return service;
}

// An address that was left before it was written, or written when this page was asked for already: where it was to
// stand, and what.
const [place, unwritten] = parsed(session.getItem(UNWRITTEN), []);
const [former, written, time] = parsed(session.getItem(WRITTEN), []);
const late = former === location.search && time > performance.timeOrigin - WRITING_MS ? written : location.search;
const linked = new URLSearchParams(place === location.search ? unwritten : late);
const language = document.documentElement.lang; // by first.js
const units = [linked.get("units"), lasting.getItem("units")].find((id) => SYSTEMS.includes(id)) ?? SYSTEMS[0];
described().catch(() => {}); // said where a calculator is opened
await useLanguage(language);
setUnits(units);
document.querySelector(".skip").textContent = message("page.skip");

const panel = document.getElementById("panel");
const live = document.getElementById("live");
const kept = parsed(session.getItem(KEPT), {}); // queries of the calculators that were open, also over a reload
const stranger = linked.size === 0 && Object.keys(kept).length === 0 && !lasting.getItem(MET);
const asked = CALCULATORS.includes(linked.get("calculator")) ? linked.get("calculator") : CALCULATORS[0];
if (linked.size > 0) kept[asked] = linked.toString();
const designs = createDesigns(lasting);
const opening = newestOnly();
let bench = null; // the calculator at work
let whole = false; // all of the page is there
let opensExport = null;
let telling = 0; // the timer of what is told
let reopening = 0; // the timer after a calculator could not be opened
let rebuild = () => {}; // it anew, from its address
const lengthsIn = (address) => address.get("lengths") ?? (address.has("v") ? "radius" : lasting.getItem("lengths"));
let lengths = lengthsIn(linked) === "diameter" ? "diameter" : "radius"; // how radii are typed
let quiet = false; // the browser itself has moved in its history
let leaving = false; // another design is to come: Back leads to this one

const bar = createBar({ naming: document.getElementById("naming"), tools: document.getElementById("tools"), idle: ["undo", "redo", "export", "help"], on: {
  named: (text) => bench?.labelled("title", text),
  new: () => bench?.start(),
  undo: () => bench?.undo(),
  redo: () => bench?.redo(),
  compare: () => bench?.keep(),
  share,
  export: () => opensExport(),
} });

/** Writes the address: not while somebody types, as browsers take some ten milliseconds for it. */
const addressing = {
  query: null,
  timer: 0,
  soon(query) {
    clearTimeout(this.timer);
    this.query = query;
    bar.saved(false);
    session.setItem(UNWRITTEN, JSON.stringify([location.search, query]));
    this.timer = setTimeout(() => this.now(), ADDRESS_MS);
  },
  now(write = "replaceState") {
    clearTimeout(this.timer);
    if (this.query === null) return;
    session.setItem(WRITTEN, JSON.stringify([location.search, this.query, Date.now()]));
    history[write](null, "", `?${this.query}`);
    this.query = null;
    bar.saved(true);
    session.setItem(UNWRITTEN, "[]");
  },
};

function say(text) {
  live.classList.remove("told");
  live.textContent = text;
}

/** What a button has done, where nothing else on the screen would say it. */
function tell(text) {
  clearTimeout(telling);
  say(text);
  live.classList.add("told");
  telling = setTimeout(() => live.classList.remove("told"), TOLD_MS);
}

/** The link to the design, to be pasted elsewhere; where the browser forbids that it is shown. */
async function share() {
  addressing.now();
  try {
    await navigator.clipboard.writeText(location.href);
    tell(message("bar.shared"));
  } catch {
    prompt(message("bar.shareWhy"), location.href);
  }
}

/** What a calculator needs to be at work. */
async function partsOf(id) {
  const [calculator, [openapi, { examples }, lists, { calculations, exports }]] = await Promise.all([calculatorOf(id), described()]);
  return {
    calculator,
    modelOf: () => formModel(openapi, {
      ...calculator, path: client.base + calculator.path, words: ownWords,
      diameters: lengths === "diameter" ? message("diameter") : null,
    }),
    modelFor: (form) => formModel(openapi, { ...form, path: client.base + form.path, words: ownWords }),
    examples: examples.filter(({ calculation }) => `/${calculation}` === calculator.path)
      .map(({ input, ...example }) => ({ ...example, input: calculator.inputOf?.(input) ?? input })),
    catalogues: Object.fromEntries(Object.entries(calculator.catalogues ?? {}).map(([path, name]) => [path, lists[name]])),
    calculation: calculations.find(({ name }) => `/${name}` === calculator.path),
    calculations,
    exports: exports.filter(({ installed }) => installed).map(({ name }) => `/${name}`),
    pdf: exports.some(({ media_types: types }) => types.includes("application/pdf")),
    version: openapi.info.version,
  };
}

/** A calculator at work from its address; `history` is that of a design which it follows. */
function build(id, { modelOf, ...parts }, history) {
  setDiameters(lengths === "diameter");
  const model = modelOf();
  const { state, claim } = decodeState(model, new URLSearchParams(kept[id]), id);
  const typed = state ?? stateFromInput(model, parts.examples[0]?.input ?? {});
  bench = openWorkbench({
    ...parts,
    model,
    lengths,
    host: panel,
    client,
    designs,
    typed,
    claim,
    history,
    on: {
      say,
      tell,
      address(query) {
        kept[id] = query;
        session.setItem(KEPT, JSON.stringify(kept));
        if (quiet) return;
        addressing.soon(query);
        if (leaving) addressing.now("pushState");
        leaving = false;
      },
      left() {
        addressing.now();
        leaving = true;
      },
      cleared(query, history) {
        close();
        kept[id] = query;
        leaving = true;
        rebuild(history); // nothing of the design before stays on the screen
        bench.begin();
      },
      lengths(chosen) {
        close(); // its state, in radii or diameters, goes into the address
        lengths = chosen;
        lasting.setItem("lengths", chosen);
        rebuild();
        panel.querySelector('[data-choice="lengths"] input:checked').focus(); // the one that was chosen is made anew
      },
      whole() {
        whole = true;
        bar.tool("export").disabled = !opensExport;
      },
      named: bar.name,
      history(canUndo, canRedo) {
        bar.tool("undo").disabled = !canUndo;
        bar.tool("redo").disabled = !canRedo;
      },
    },
  });
}

function close() {
  bench?.close();
  bench = null;
  addressing.now();
}

async function open(id) {
  clearTimeout(reopening);
  tabs.setOpen(id);
  panel.dataset.state = "computing";
  try {
    const { answer: parts, problem, superseded } = await opening.ask(() => partsOf(id));
    if (superseded) return;
    if (problem) throw problem;
    close();
    rebuild = (history) => build(id, parts, history);
    rebuild();
  } catch (error) {
    close();
    tabs.setOpen(null);
    panel.textContent = message("page.failed", { detail: passingText(error, new Map()) });
    reopening = setTimeout(() => open(id), AGAIN_MS);
  }
}

document.addEventListener("keydown", (event) => {
  const alone = event.altKey && !event.ctrlKey && !event.metaKey;
  const acts = { KeyK: "keep", KeyL: "enlarge" };
  if (alone && acts[event.code]) {
    event.preventDefault();
    bench?.[acts[event.code]]();
  }
  if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.closest(".free-text")) return;
  const key = event.key.toLowerCase();
  if (key === "p" && bench?.exchange()) {
    event.preventDefault();
    bench.print().catch((problem) => tell(message("report.failed", { detail: passingText(problem, new Map()) })));
  }
  const act = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : null;
  if (!act || !bench) return;
  event.preventDefault();
  bench[act]();
});

const tabs = createTabs({ host: document.getElementById("tabs"), panel, ids: CALCULATORS, on: {
  opened(id) {
    leaving = true;
    open(id);
  },
} });
const settings = createSettings({
  button: bar.tool("settings"),
  current: { theme: chosenTheme(), units, language },
  on: {
    theme(chosen) {
      setTheme(chosen);
      lasting.setItem("theme", chosen);
      bench?.retheme();
    },
    units(chosen) {
      close(); // its state, in the old units, goes into the address
      setUnits(chosen);
      lasting.setItem("units", chosen);
      rebuild(); // at once: what is typed next goes into the new form
    },
    language(chosen) {
      lasting.setItem("language", chosen);
      close();
      if (lasting.getItem("language") === chosen) location.reload();
      else location.search = `${location.search}&lang=${chosen}`; // the browser remembers nothing
    },
  },
});
document.body.append(settings);
addEventListener("popstate", () => {
  const there = new URLSearchParams(location.search);
  const id = CALCULATORS.find((one) => one === there.get("calculator")) ?? CALCULATORS[0];
  addressing.query = null;
  quiet = true;
  close();
  quiet = false;
  leaving = false;
  lengths = lengthsIn(there) === "diameter" ? "diameter" : "radius";
  kept[id] = there.toString();
  open(id);
});
onSystemTheme(() => bench?.retheme());
/** How much of the page's lower edge a keyboard on the screen covers. */
for (const event of ["resize", "scroll"]) {
  visualViewport.addEventListener(event, ({ target: { height, offsetTop } }) => {
    document.documentElement.style.setProperty("--covered", `${Math.max(0, innerHeight - height - offsetTop)}px`);
  });
}
/** What a click needs and could not be loaded is said, until the page is loaded anew: browsers ask for a module once. */
addEventListener("unhandledrejection", (event) => {
  if (!/module/i.test(event.reason?.message)) return;
  event.preventDefault();
  document.querySelector(".unloaded")?.remove();
  const notice = element(html`<p class="told unloaded" role="alert">${message("page.unloaded")} <button type="button" class="link">${message("state.again")}</button></p>`);
  notice.lastElementChild.addEventListener("click", () => {
    addressing.now();
    location.reload();
  });
  document.body.append(notice);
});
addEventListener("pagehide", () => bench?.close());
addEventListener("pageshow", ({ persisted }) => persisted && rebuild()); // back from another page, as it was left

/** What the tools open is loaded after the first figures. */
async function loadTools() {
  await bench?.begun.catch(() => {});
  try {
    const [{ createExport }, { createKeys }] = await Promise.all([import("./views/export.js"), import("./views/keys.js")]);
    opensExport = createExport({
      exchange: () => bench?.exchange() ?? null, labels: () => bench.labels(), say,
      on: { print: (ready) => bench.print(ready), report: (type) => bench.report(type), labelled: (...label) => bench?.labelled(...label) },
    });
    createKeys({ button: bar.tool("help"), about: () => bench?.help() ?? null });
    bar.tool("help").disabled = false;
    bar.tool("export").disabled = !whole;
  } catch {
    setTimeout(loadTools, AGAIN_MS);
  }
}

await open(asked);
if (stranger) bench?.start().then(() => lasting.setItem(MET, "yes"));
loadTools();
