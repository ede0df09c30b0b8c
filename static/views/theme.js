/** Light or dark: the system's choice, or the user's. */

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
