/** What is chosen once: theme, units, language, in a sheet under one button. */
import { element, html } from "../lib/html.js";
import { LANGUAGES, message } from "../messages/index.js";
import { SYSTEMS } from "../lib/units.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

/** "system", "light" or "dark". */
export function chosenTheme() {
  return document.documentElement.dataset.theme ?? "system";
}

export function setTheme(theme) {
  if (theme === "system") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
}

/** The theme in force, "light" or "dark". */
export function currentTheme() {
  const choice = chosenTheme();
  return choice === "system" ? (dark.matches ? "dark" : "light") : choice;
}

export function onSystemTheme(changed) {
  dark.addEventListener("change", changed);
}

function choice(name, options, current) {
  return html`
    <label for="${name}">${message(`settings.${name}`)}</label>
    <select id="${name}" class="box">${Object.entries(options).map(([id, title]) =>
      html`<option value="${id}" ${id === current && html`selected`}>${title}</option>`)}</select>`;
}

/** The sheet that `button` opens; `current` and `on` by name: the choice in force, and what to do with a new one. */
export function createSettings({ button, current, on }) {
  const themes = message("theme");
  const units = Object.fromEntries(SYSTEMS.map((id) => [id, message(`units.${id}`)]));
  const sheet = element(html`
    <div id="settings" class="card" popover role="dialog" aria-label="${message("bar.settings")}">
      ${choice("theme", themes, current.theme)}
      ${choice("units", units, current.units)}
      ${choice("language", LANGUAGES, current.language)}
    </div>`);
  sheet.addEventListener("change", ({ target }) => on[target.id](target.value));
  button.setAttribute("popovertarget", sheet.id);
  return sheet;
}
