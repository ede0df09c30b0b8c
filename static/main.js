/** Wiring: the header, the open calculator, the address. */
import { createClient } from "./api.js";
import { CALCULATORS } from "./calculators/index.js";
import { message } from "./messages/index.js";
import { formModel, stateFromInput } from "./schema_form.js";
import { decodeState } from "./url_state.js";
import { createKeys } from "./views/keys.js";
import { createTabs } from "./views/tabs.js";
import { createThemeSwitch } from "./views/theme.js";
import { openWorkbench } from "./workbench.js";

const API = "/api/v1";
const client = createClient({ base: API });
const panel = document.getElementById("panel");
const live = document.getElementById("live");
const linked = new URLSearchParams(location.search);
const kept = new Map(); // what was typed in calculators that are not open now
let wanted = null;
let open = null;

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
  tabs.setOpen(id);
  const { load } = CALCULATORS.find((one) => one.id === id);
  const [{ default: calculator }, [openapi, { examples }]] = await Promise.all([load(), service]);
  const model = formModel(openapi, { ...calculator, path: API + calculator.path });
  const own = examples.filter((example) => `/${example.calculation}` === calculator.path);
  const catalogues = await cataloguesOf(calculator);
  if (wanted !== id) return; // another tab was opened meanwhile
  open?.close();
  open = openWorkbench({
    host: panel,
    calculator,
    model,
    client,
    examples: own,
    catalogues,
    state: kept.get(id)
      ?? (linked.get("calculator") === id ? decodeState(model, linked) : null)
      ?? stateFromInput(model, { ...calculator.start, ...own[0]?.input }),
    on: {
      state(state, query) {
        kept.set(id, state);
        history.replaceState(null, "", `?${query}`);
      },
      say(text) {
        live.textContent = text;
      },
    },
  });
}

function failed(error) {
  wanted = null;
  panel.textContent = message("page.failed", { detail: error.message });
}

const ids = CALCULATORS.map(({ id }) => id);
const tabs = createTabs({
  host: document.getElementById("tabs"),
  panel,
  ids,
  on: { opened: (id) => openCalculator(id).catch(failed) },
});
document.getElementById("tools").append(
  createThemeSwitch({ on: { changed: () => open?.redraw() } }).root,
  createKeys().button,
);

const asked = linked.get("calculator");
openCalculator(ids.includes(asked) ? asked : ids[0]).catch(failed);
