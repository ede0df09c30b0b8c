/** A search of the inputs by name or symbol, which "/" leads to. */
import { clicks, element, fill, html } from "../lib/html.js";
import { message } from "../messages/index.js";
import { symbolMarkup } from "./parts.js";

const MOST = 8;

/** `on.found(path)` leads to a field, `on.all(shown)` opens all sections; `on.here()` has the search itself in sight. */
export function createSearch({ model, all, signal, on }) {
  const root = element(html`<div class="search" role="search">
    <input type="search" class="box" aria-label="${message("form.search")}" placeholder="${message("form.search")} ( / )" aria-keyshortcuts="/" autocomplete="off" spellcheck="false">
    <button type="button" class="toggle" aria-pressed="${String(all)}">${message("form.all")}</button><ul></ul></div>`);
  const [input, toggle, list] = root.children;
  const fields = [...model.fields.values()].filter(({ kind }) => kind !== "switch");
  const plain = (text) => text.toLowerCase().replaceAll("_", "");

  /** Fields whose symbol it is, then those whose names begin with it or hold it. */
  function found(text) {
    const asked = plain(text.trim());
    if (!asked) return [];
    const rank = ({ title, symbol }) => [plain(symbol) === asked, plain(title).startsWith(asked), plain(title).includes(asked)].indexOf(true);
    return fields.filter((field) => rank(field) >= 0).sort((one, other) => rank(one) - rank(other)).slice(0, MOST);
  }

  const show = () => fill(list, html`${found(input.value).map(({ path, title, symbol }) => html`
    <li><button type="button" data-found="${path}">${title}${symbol && symbolMarkup(symbol)}</button></li>`)}`);
  function clear() {
    input.value = "";
    show();
  }
  function take(path) {
    clear();
    on.found(path);
  }
  input.addEventListener("input", show);
  clicks(list, "found", take);
  toggle.addEventListener("click", () => {
    const pressed = toggle.getAttribute("aria-pressed") !== "true";
    toggle.setAttribute("aria-pressed", String(pressed));
    on.all(pressed);
  });
  root.addEventListener("keydown", (event) => {
    const stops = [input, ...list.querySelectorAll("button")];
    const to = stops.indexOf(document.activeElement) + { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") clear();
    else if (event.key === "Enter" && event.target === input && stops[1]) take(stops[1].dataset.found);
    else if (stops[to] && event.target !== toggle) stops[to].focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input, select, textarea, dialog")) return;
    event.preventDefault();
    on.here();
    input.focus();
  }, { signal });
  return { root };
}
