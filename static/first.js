// Runs before the first paint (a classic script in the head): a chosen theme never flashes, a language has its room, and its
// words are asked for with what the page needs. Plotly is run while they are on their way.
(() => {
  const linked = new URLSearchParams(location.search);
  const languages = [linked.get("lang"), ...navigator.languages.map((tag) => tag.split("-")[0])];
  try {
    languages.splice(1, 0, localStorage.getItem("language"));
    const theme = localStorage.getItem("theme");
    if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  } catch {
    // Without storage the system's theme holds.
  }
  // Room is kept for the words of a language from the first paint on.
  const language = languages.find((one) => ["en", "uk", "ru"].includes(one)) ?? "en";
  document.documentElement.lang = language;
  const words = document.createElement("link");
  Object.assign(words, { rel: "preload", as: "fetch", crossOrigin: "anonymous", href: `api/v1/words?language=${language}` });
  const plotly = Object.assign(document.createElement("script"), { src: "static/vendor/plotly/plotly-basic.min.js" });
  plotly.addEventListener("error", () => plotly.remove()); // the first figure tries again
  document.head.append(words, plotly);
})();
