/** Pieces of the drawings as SVG; styles stand in drawing.css. Y points upwards, lengths are mm. */

const NAMESPACE = "http://www.w3.org/2000/svg";

/** An element with attributes; children may be elements. */
export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children);
  return node;
}

const short = (value) => Number(value.toPrecision(7));

export const at = ([x, y]) => `${short(x)} ${short(-y)}`;

export function circle([x, y], radius, kind) {
  return svg("circle", { class: kind, cx: short(x), cy: short(-y), r: short(radius) });
}

export function line(from, to, kind) {
  return svg("path", { class: kind, d: `M${at(from)}L${at(to)}` });
}

/** A text whose size is in mm, its middle at a place. */
export function label([x, y], text, size, kind = "label") {
  const node = svg("text", { class: kind, x: short(x), y: short(-y), "font-size": short(size) });
  const [name, index] = text.split("_");
  node.append(name);
  if (index) node.append(svg("tspan", { dy: short(size * 0.3), "font-size": short(size * 0.7) }, index));
  return node;
}

/** Path of an arrow with its head at `to`; nothing where it has no length. */
export function arrowPath(from, to, head) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length === 0) return "";
  const [ux, uy] = [dx / length, dy / length];
  const size = Math.min(head, length);
  const wing = (side) => at([to[0] - size * (ux - 0.4 * side * uy), to[1] - size * (uy + 0.4 * side * ux)]);
  return `M${at(from)}L${at(to)}M${wing(1)}L${at(to)}L${wing(-1)}`;
}

/** A dimension: a line with a head at each end (or at its far end only) and its symbol beside it. */
export function dimension({ from, to, symbol, path, size, aside = [0, 0], oneHead = false }) {
  const middle = [(from[0] + to[0]) / 2 + aside[0], (from[1] + to[1]) / 2 + aside[1]];
  const heads = arrowPath(from, to, size * 0.5) + (oneHead ? "" : arrowPath(to, from, size * 0.5));
  return svg("g", { class: "dimension", "data-dimension": path },
    svg("path", { d: heads }), label(middle, symbol, size));
}

/** A drawing with its view in mm. */
export function canvas({ left, right, bottom, top, name }) {
  return svg("svg", {
    class: "drawing", role: "img", "aria-label": name,
    viewBox: [left, -top, right - left, top - bottom].map(short).join(" "),
  });
}
