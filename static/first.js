// Runs before the first paint (a classic script in the head): a chosen theme never flashes, and the
// modules of the calculator in the address are asked for with those of the page.
(() => {
  try {
    const theme = localStorage.getItem("theme");
    if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
  } catch {
    // Without storage the system's theme holds.
  }
  const own = {
    "crank-planetary": ["index", "drawing", "mechanism", "sentences", "wanted", "worked"],
    rollers: ["index", "drawing", "sentences", "worked"],
    precession: ["index", "drawing", "sentences", "worked"],
  };
  const shared = ["fatigue", "formula/step", "svg"].map((name) => `static/lib/${name}.js`);
  const asked = new URLSearchParams(location.search).get("calculator");
  const id = Object.hasOwn(own, asked) ? asked : "crank-planetary";
  const modules = own[id].map((name) => `static/calculators/${id}/${name}.js`);
  document.head.append(...[...modules, ...shared].map((href) =>
    Object.assign(document.createElement("link"), { rel: "modulepreload", href })));
})();
