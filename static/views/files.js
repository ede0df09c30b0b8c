/** Files made on the page: given to the user, and drawings that stand by themselves, light, on white. */

const SCALE = 2; // pixels a point
const STYLES = [
  "fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linejoin",
  "opacity", "visibility", "paint-order", "font-family", "font-size", "font-style", "font-weight",
  "text-anchor", "dominant-baseline",
];

/** Text of an SVG file of a drawing on the page. */
export function svgOf(drawing) {
  const { width, height } = drawing.viewBox.baseVal;
  const copy = drawing.cloneNode(true);
  const shown = [drawing, ...drawing.querySelectorAll("*")];
  drawing.style.colorScheme = "light";
  for (const [index, part] of [copy, ...copy.querySelectorAll("*")].entries()) {
    const style = getComputedStyle(shown[index]);
    for (const { name } of [...part.attributes]) if (/^(class|tabindex|data-.*)$/.test(name)) part.removeAttribute(name);
    for (const name of STYLES) part.setAttribute(name, style.getPropertyValue(name));
  }
  drawing.style.colorScheme = "";
  const paper = document.createElementNS(copy.namespaceURI, "rect");
  for (const [name, value] of Object.entries({ width, height, fill: "#ffffff", stroke: "none" })) paper.setAttribute(name, value);
  copy.prepend(paper);
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  return new XMLSerializer().serializeToString(copy);
}

/** Data URL of the same as pixels. */
export async function pngOf(drawing) {
  const { width, height } = drawing.viewBox.baseVal;
  const url = URL.createObjectURL(new Blob([svgOf(drawing)], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width: SCALE * width, height: SCALE * height });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL("image/png");
  } finally {
    URL.revokeObjectURL(url);
  }
}

let design = ""; // the title of the design at hand, as part of a file's name

export function nameFiles(title) {
  design = title.trim().toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
}

/** Give the user a file, named by the design where it has a title; `content` is a text or a blob, or a data URL where it begins like one. */
export function download(name, content, type = content.type ?? "text/plain") {
  const url = String(content).startsWith("data:") ? content : URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  Object.assign(link, { href: url, download: design ? `${design}-${name}` : name });
  link.click();
  if (url !== content) setTimeout(() => URL.revokeObjectURL(url));
}
