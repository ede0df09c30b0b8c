/**
 * Parts of a technical drawing as SVG markup, in pixels, and arrows that move on the page.
 *
 * A *view* places mm on the paper: `createView({ x, y, scale })` with the pixel of its origin and the
 * pixels of a millimetre; y points up in mm and down on the paper. `field` names the fields of the
 * form whose size a part shows.
 */
import { formatQuantity, tidy } from "./format.js";
import { html } from "./html.js";
import { inDiameters, shownValue } from "./units.js";

const HEAD = 8; // length of an arrowhead, px
const HALF = 2.6; // half its width
const LETTER_PX = 7.7; // of a label, at most and on average

export const WIDE_PX = 480; // from here on views stand side by side

function px(value) {
  return Number(value.toFixed(2));
}

export function createView({ x, y, scale }) {
  return {
    scale,
    /** The pixel of a place in mm. */
    at: ([across, up]) => [px(x + across * scale), px(y - up * scale)],
    size: (length) => px(length * scale),
  };
}

export function line([x1, y1], [x2, y2], kind, field = "") {
  return html`<line class="${kind}" data-field="${field}" x1="${px(x1)}" y1="${px(y1)}" x2="${px(x2)}" y2="${px(y2)}"/>`;
}

export function circle([x, y], radius, kind, field = "") {
  return html`<circle class="${kind}" data-field="${field}" cx="${px(x)}" cy="${px(y)}" r="${px(radius)}"/>`;
}

export function path(points, kind, field = "", close = true) {
  const d = points.map(([x, y], i) => `${i ? "L" : "M"}${px(x)} ${px(y)}`).join("");
  return html`<path class="${kind}" data-field="${field}" d="${d}${close ? "Z" : ""}"/>`;
}

/** A symbol with its index set low, and its value beside it. */
export function label([x, y], symbol, { value = "", anchor = "middle", field = "", kind = "" } = {}) {
  let low = false;
  const pieces = [...symbol.split(/_([\p{L}\p{N}]+)/u), value && ` = ${value}`].map((text, i, all) => {
    if (!text) return "";
    const index = i % 2 === 1 && i < all.length - 1;
    const dy = index ? 3 : low ? -3 : 0;
    low = index;
    const name = index ? "sub" : i === all.length - 1 ? "amount" : "symbol";
    return html`<tspan class="${name}" dy="${dy}">${text}</tspan>`;
  });
  return html`<text class="label ${kind}" data-field="${field}" x="${px(x)}" y="${px(y)}" text-anchor="${anchor}">${pieces}</text>`;
}

export function words([x, y], text, { anchor = "start", kind = "words" } = {}) {
  return html`<text class="${kind}" x="${px(x)}" y="${px(y)}" text-anchor="${anchor}">${text}</text>`;
}

function unit([x1, y1], [x2, y2]) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  return length > 0 ? [(x2 - x1) / length, (y2 - y1) / length, length] : [0, 0, 0];
}

/** The path of an arrowhead whose tip is `to`, seen from `from`. */
export function headPath(from, to, size = 1) {
  const [across, down] = unit(from, to);
  const [x, y] = to;
  const back = [x - across * HEAD * size, y - down * HEAD * size];
  const side = [-down * HALF * size, across * HALF * size];
  return `M${px(x)} ${px(y)}L${px(back[0] + side[0])} ${px(back[1] + side[1])}`
    + `L${px(back[0] - side[0])} ${px(back[1] - side[1])}Z`;
}

/** An arrow of exactly the length from `from` to `to`. */
export function arrow(from, to, kind, field = "") {
  return html`<g class="arrow ${kind}" data-field="${field}">${line(from, to, "shaft")}<path class="head" d="${headPath(from, to, 1.25)}"/></g>`;
}

/** Set attributes of an element. */
export function set(node, values) {
  for (const [name, value] of Object.entries(values)) node.setAttribute(name, value);
}

/** An arrow on the page. */
export const arrowOf = (root) => ({ root, shaft: root.querySelector(".shaft"), head: root.querySelector(".head") });

/** Lay an arrow on the page from one place to another, or hide it. */
export function setArrow({ root, shaft, head }, from, to, shown) {
  root.classList.toggle("none", !shown);
  if (!shown) return;
  set(shaft, { x1: from[0], y1: from[1], x2: to[0], y2: to[1] });
  head.setAttribute("d", headPath(from, to, 1.25));
}

/** What is built in: hatched on the side away from the part. */
export function wall([x, y], half, side, count = 7) {
  const marks = Array.from({ length: count }, (_, i) => y - half + (i * 2 * half) / (count - 1));
  return html`<path class="clamp" d="M${x} ${y - half}V${y + half}${marks.map((mark) => `M${x} ${mark}l${-8 * side} 8`).join("")}"/>`;
}

const SHORT = 3.2 * HEAD; // below this length the heads stand outside

/**
 * A dimension between two places, moved aside by `offset` px (to the left of the way from the first
 * to the second), with its label in the middle or beside a short one, `rise` px higher.
 */
export function dimension(from, to, symbol, { value = "", field = "", offset = 0, beside = 10, rise = 0 } = {}) {
  const [across, down, length] = unit(from, to);
  const aside = ([x, y], by) => [x + down * by, y - across * by];
  const [start, end] = [aside(from, offset), aside(to, offset)];
  const short = length < SHORT;
  const out = 2 * HEAD;
  const tails = short
    ? [[start[0] - across * out, start[1] - down * out], [end[0] + across * out, end[1] + down * out]]
    : [start, end];
  const heads = short
    ? [headPath(tails[0], start), headPath(tails[1], end)]
    : [headPath(end, start), headPath(start, end)];
  const over = Math.sign(offset) * 4;
  const middle = aside([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], offset + beside);
  const upright = Math.abs(down) > 0.5;
  return html`<g class="dimension" data-field="${field}">
    ${offset !== 0 && [line(from, aside(from, offset + over), "extension"), line(to, aside(to, offset + over), "extension")]}
    ${line(tails[0], tails[1], "extent")}<path class="head" d="${heads[0]}"/><path class="head" d="${heads[1]}"/>
    ${label([middle[0], middle[1] + 4 - rise], symbol, { value, field, anchor: upright ? (beside * down > 0 ? "start" : "end") : "middle" })}</g>`;
}

/** What a drawing calls a radius, and what it says of it: in diameters twice of both. */
export const sized = (symbol, length) => (inDiameters() ? [`2${symbol}`, mm(2 * length)] : [symbol, mm(length)]);

/** A radius of so many mm from the centre outwards, in degrees from upright, clockwise; its label outside, not left of `least` nor of what it takes itself. */
export function radius(centre, length, angle, named, { of, field = "", lead = 26, least = 0 } = {}) {
  const [symbol, value] = sized(named, of);
  const direction = [Math.sin((angle * Math.PI) / 180), -Math.cos((angle * Math.PI) / 180)];
  const along = (by) => [centre[0] + direction[0] * by, centre[1] + direction[1] * by];
  const [rim, end] = [along(length), along(length + lead)];
  const right = direction[0] >= 0;
  const room = least && Math.max(least, LETTER_PX * `${symbol} = ${value}`.length);
  return html`<g class="dimension" data-field="${field}">${line(centre, end, "extent")}
    <path class="head" d="${headPath(centre, rim)}"/>
    ${label([Math.max(room, end[0] + (right ? 4 : -4)), end[1] + 4], symbol, { value, field, anchor: right ? "start" : "end" })}</g>`;
}

/** The path of an arc about a centre, from one angle to a larger one, degrees from upright, clockwise. */
export function arcPath([x, y], length, from, to) {
  const place = (angle) => [x + length * Math.sin((angle * Math.PI) / 180), y - length * Math.cos((angle * Math.PI) / 180)];
  const [start, end] = [place(from), place(to)];
  return `M${px(start[0])} ${px(start[1])}A${px(length)} ${px(length)} 0 ${to - from > 180 ? 1 : 0} 1 ${px(end[0])} ${px(end[1])}`;
}

/** A length as it is written in a drawing. */
export function mm(value) {
  return formatQuantity(value, "mm");
}

/** The largest value not above this one that is 1, 2 or 5 by tens in the unit shown: a round one for a scale. */
export function roundBelow(value, unit) {
  const one = shownValue(1, unit);
  const decade = 10 ** Math.floor(Math.log10(value * one));
  const lead = ((value * one) / decade) * (1 + 1e-9);
  return tidy(((lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * decade) / one);
}

/** A bar that says how long something is on the paper. */
export function scaleBar([x, y], length, text, kind = "") {
  return html`<g class="scale-bar ${kind}"><path d="M${px(x)} ${px(y - 4)}v8M${px(x)} ${px(y)}h${px(length)}M${px(x + length)} ${px(y - 4)}v8"/>
    ${words([x + length + 8, y + 4], text)}</g>`;
}

/** The whole drawing, a pixel a unit; `data` is told to those who measure it. */
export function paper(width, height, parts, data = {}) {
  const told = Object.entries(data).map(([name, value]) => html` data-${name}="${value}"`);
  return html`<svg viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" aria-hidden="true"${told}>${parts}</svg>`;
}
