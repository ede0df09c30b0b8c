// Runs before the first paint (a classic script in the head): a chosen theme never flashes, a language has its room, and the
// modules of the calculator in the address and the words of the language are asked for with what the page needs. Plotly is run while
// they are on their way.
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
  const words = { rel: "preload", as: "fetch", crossOrigin: "anonymous", href: `api/v1/words?language=${language}` };
  const own = {
    "crank-planetary": ["index", "drawing", "mechanism", "ring", "sentences", "wanted"],
    rollers: ["index", "drawing", "sentences"],
    precession: ["index", "drawing", "sentences"],
  };
  const shared = ["fatigue", "svg"].map((name) => `static/lib/${name}.js`);
  const asked = linked.get("calculator");
  const id = Object.hasOwn(own, asked) ? asked : "crank-planetary";
  const modules = own[id].map((name) => `static/calculators/${id}/${name}.js`);
  const links = [words, ...[...modules, ...shared].map((href) => ({ rel: "modulepreload", href }))];
  document.head.append(...links.map((about) => Object.assign(document.createElement("link"), about)));
  const plotly = Object.assign(document.createElement("script"), { src: "static/vendor/plotly/plotly-basic.min.js" });
  plotly.addEventListener("error", () => plotly.remove()); // the first figure tries again
  document.head.append(plotly);
})();
