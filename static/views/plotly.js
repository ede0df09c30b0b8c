/** Plotly.js, fetched once and only when the first figure is to be drawn. */

const SCRIPT = new URL("../vendor/plotly/plotly-basic.min.js", import.meta.url);
const STYLES = new URL("../vendor/plotly/plotly-global.css", import.meta.url);

// Plotly writes its rules into a style element of this id, which the page's policy forbids;
// where a linked sheet of that id and class is present, it leaves them to the sheet.
function linkStyles() {
  const link = document.createElement("link");
  Object.assign(link, { id: "plotly.js-style-global", className: "no-inline-styles", rel: "stylesheet", href: STYLES });
  return settled(link);
}

function runScript() {
  const script = document.createElement("script");
  script.src = SCRIPT;
  return settled(script);
}

function settled(node) {
  return new Promise((resolve, reject) => {
    node.addEventListener("load", resolve);
    node.addEventListener("error", () => {
      node.remove();
      reject(new Error(`cannot load ${node.src ?? node.href}`));
    });
    document.head.append(node);
  });
}

let loading = null;

export function loadPlotly() {
  loading ??= Promise.all([linkStyles(), runScript()]).then(() => globalThis.Plotly, (error) => {
    loading = null; // the next figure tries again
    throw error;
  });
  return loading;
}
