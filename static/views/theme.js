/** Light or dark: the system's choice, or the user's, which the browser remembers. */
import { element, html } from "../lib/html.js";
import { message } from "../messages/index.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

function chosen() {
  return document.documentElement.dataset.theme ?? "system";
}

/** The theme in force, "light" or "dark". */
export function currentTheme() {
  const choice = chosen();
  return choice === "system" ? (dark.matches ? "dark" : "light") : choice;
}

export function createThemeSwitch({ on }) {
  const root = element(html`
    <label class="theme"><span class="unseen">${message("page.theme")}</span>
      <select id="theme">${["system", "light", "dark"].map((theme) =>
        html`<option value="${theme}">${message(`theme.${theme}`)}</option>`)}</select></label>`);
  const select = root.querySelector("select");
  select.value = chosen();
  select.addEventListener("change", () => {
    if (select.value === "system") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = select.value;
    try {
      localStorage.setItem("theme", select.value);
    } catch {
      // Without storage the choice holds for this visit.
    }
    on.changed();
  });
  dark.addEventListener("change", () => on.changed());
  return { root };
}
