/** Wiring: the header, the open calculator, the address, what the browser remembers. */
import { createClient } from "./api.js";
import { CALCULATORS } from "./calculators/index.js";
import { createDesigns } from "./designs.js";
import { element, html } from "./lib/html.js";
import { LANGUAGES, message, translated, useLanguage } from "./messages/index.js";
import { preference, setPreference } from "./preferences.js";
import { formModel, stateFromInput } from "./schema_form.js";
import { setUnits, SYSTEMS } from "./units.js";
import { decodeState } from "./url_state.js";
import { createKeys } from "./views/keys.js";
import { createSettings } from "./views/settings.js";
import { createShare } from "./views/share.js";
import { createTabs } from "./views/tabs.js";
import { chosenTheme, onSystemTheme, setTheme } from "./views/theme.js";
import { openWorkbench } from "./workbench.js";

const API = "/api/v1";
const client = createClient({ base: API });
const panel = document.getElementById("panel");
const live = document.getElementById("live");
const kept = new Map(); // queries of the calculators that were open, also over a reload
const KEPT = "khv-calc.open";

function storage(name) {
  try {
    return globalThis[name];
  } catch {
    return null;
  }
}

function keep(id, query) {
  kept.set(id, query);
  try {
    storage("sessionStorage")?.setItem(KEPT, JSON.stringify(Object.fromEntries(kept)));
  } catch {
    // Then a reload keeps the open calculator only, by its address.
  }
}

/** The language asked for: by hand, else the first of the browser's that there is. */
function chosenLanguage() {
  const wanted = [preference("language"), ...navigator.languages.map((tag) => tag.split("-")[0])];
  return wanted.find((id) => id in LANGUAGES) ?? "en";
}

const language = chosenLanguage();
await useLanguage(language);
document.documentElement.lang = language;
document.querySelector(".skip").textContent = message("page.skip");
document.getElementById("tabs").setAttribute("aria-label", message("page.calculators"));
const units = SYSTEMS.find((id) => id === preference("units")) ?? SYSTEMS[0];
setUnits(units);

const linked = new URLSearchParams(location.search);
const designs = createDesigns(storage("localStorage"));
let wanted = null;
let open = null;
let build = null; // the open calculator anew, from its address

try {
  const remembered = JSON.parse(storage("sessionStorage")?.getItem(KEPT) ?? "{}");
  for (const [id, query] of Object.entries(remembered)) kept.set(id, query);
} catch {
  // What cannot be read is not ours.
}
if (linked.has("calculator")) kept.set(linked.get("calculator"), linked.toString());

const service = Promise.all([
  createClient({ base: "" }).get("/openapi.json"),
  client.get("/examples"),
]);

async function cataloguesOf(calculator) {
  const lists = new Map();
  for (const name of new Set(Object.values(calculator.catalogues))) {
    lists.set(name, client.get(`/${name}`).then((answer) => answer[name]));
  }
  const entries = Object.entries(calculator.catalogues).map(async ([path, name]) => [path, await lists.get(name)]);
  return Object.fromEntries(await Promise.all(entries));
}

async function openCalculator(id) {
  if (wanted === id) return;
  wanted = id;
  panel.dataset.state = "computing";
  tabs.setOpen(id);
  const { load } = CALCULATORS.find((one) => one.id === id);
  const [{ default: calculator }, [openapi, { examples }]] = await Promise.all([load(), service]);
  const model = formModel(openapi, { ...calculator, path: API + calculator.path, words: translated });
  const own = examples.filter((example) => `/${example.calculation}` === calculator.path);
  const catalogues = await cataloguesOf(calculator);
  if (wanted !== id) return; // another tab was opened meanwhile
  open?.close();
  build = () => openWorkbench({
    host: panel,
    calculator,
    model,
    client,
    examples: own,
    catalogues,
    designs,
    version: openapi.info.version,
    state: decodeState(model, new URLSearchParams(kept.get(id)))
      ?? stateFromInput(model, { ...calculator.start, ...own[0]?.input }),
    on: {
      state(query) {
        keep(id, query);
        globalThis.history.replaceState(null, "", `?${query}`);
      },
      history({ canUndo, canRedo }) {
        undo.disabled = !canUndo;
        redo.disabled = !canRedo;
      },
      say(text) {
        live.textContent = text;
      },
    },
  });
  open = build();
}

function failed(error) {
  open?.close();
  wanted = open = build = null;
  panel.textContent = message("page.failed", { detail: error.message });
}

function tool(sign, words, act) {
  const button = element(html`
    <button type="button" class="tool" aria-label="${words}" title="${words}" disabled>${sign}</button>`);
  button.addEventListener("click", act);
  return button;
}

const undo = tool("↶", message("page.undo"), () => open?.undo());
const redo = tool("↷", message("page.redo"), () => open?.redo());
document.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.closest(".free-text")) return;
  const key = event.key.toLowerCase();
  const act = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : null;
  if (!act || !open) return;
  event.preventDefault();
  open[act]();
});

const ids = CALCULATORS.map(({ id }) => id);
const tabs = createTabs({
  host: document.getElementById("tabs"),
  panel,
  ids,
  on: { opened: (id) => openCalculator(id).catch(failed) },
});
const settings = createSettings({
  current: { theme: chosenTheme(), units, language },
  on: {
    theme(chosen) {
      setTheme(chosen);
      setPreference("theme", chosen);
      open?.redraw();
    },
    units(chosen) {
      open?.close(); // its state, in the old units, goes into the address
      setUnits(chosen);
      setPreference("units", chosen);
      open = build?.() ?? null; // at once: what is typed next goes into the new form
    },
    language(chosen) {
      setPreference("language", chosen);
      open?.close();
      location.reload();
    },
  },
});
const share = createShare({
  exchange: () => open?.exchange() ?? null,
  say: (text) => { live.textContent = text; },
});
document.getElementById("tools").append(undo, redo, share.button, settings.button, createKeys().button);
document.body.append(settings.sheet);
onSystemTheme(() => open?.redraw());
addEventListener("pagehide", () => open?.close());

const asked = linked.get("calculator");
openCalculator(ids.includes(asked) ? asked : ids[0]).catch(failed);
