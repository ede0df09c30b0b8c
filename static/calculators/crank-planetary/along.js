/** Pin, crankshaft and the whole reducer to scale along their axes, with what holds and loads them. No DOM. */
import { formatQuantity } from "../../lib/format.js";
import { html } from "../../lib/html.js";
import { arrow, createView, dimension, label, line, mm, paper, path, roundBelow, scaleBar, wall } from "../../lib/svg.js";
import { message } from "../../messages/index.js";
import { cranksOf } from "./mechanism.js";
import { sleeved } from "./wanted.js";

const MOST_NAMED = 4; // satellites whose place is written
const MOST_DRAWN = 40;
const ARROW = 26; // px
const TIER = 24; // px between dimensions
const RADIAN = Math.PI / 180;

/** A view in which so much of an axis and so much about it fit, dimensions below. */
function viewOf({ width, height }, { from, to, above, below, tiers }) {
  const [left, right, top, bottom] = [64, 40, 34, TIER * tiers + 44];
  const scale = Math.min((width - left - right) / (to - from), (height - top - bottom) / (above + below));
  const middle = (width - (to - from) * scale + left - right) / 2;
  return createView({ x: middle - from * scale, y: top + ((height - top - bottom) - (above + below) * scale) / 2 + above * scale, scale });
}

const bar = ({ at }, x0, x1, y0, y1, kind, field = "") => path([at([x0, y0]), at([x1, y0]), at([x1, y1]), at([x0, y1])], kind, field);

/** A support that lets the part tilt, under it. */
function knife([x, y]) {
  return html`<path class="clamp" d="M${x} ${y}l-8 13h16zM${x - 12} ${y + 16}h24"/>`;
}

/** A ring that joins the pins in section, on an axle where they turn in it. */
function tieRing(view, place, radius, joint) {
  const [half, tall] = [radius / 2, 1.8 * radius];
  return html`${[1, -1].map((side) => bar(view, place - half, place + half, side * radius, side * tall, "body", "pin.ring_joint pin.span_mm"))}
    ${joint !== "clamped" && html`<circle class="body" cx="${view.at([place, 0])[0]}" cy="${view.at([0, 0])[1]}" r="${view.size(half)}"/>`}`;
}

/** Dimensions of places along the axis from the origin, each lower than the one before. */
function places(view, zero, all, low, field, symbol) {
  const level = (i) => low + TIER * (i + 1);
  const named = all.slice(0, MOST_NAMED);
  const last = level(named.length - 1) + 4;
  return html`${line([view.at([zero, 0])[0], low], [view.at([zero, 0])[0], last], "extension")}
    ${named.map((place, i) => {
      const x = view.at([place, 0])[0];
      return html`${line([x, low], [x, level(i) + 4], "extension")}
        ${dimension([view.at([zero, 0])[0], level(i)], [x, level(i)], symbol(i), { value: mm(place - zero), field, beside: -12 })}`;
    })}`;
}

const ends = (values) => [Math.min(...values), Math.max(...values)];

/** The pin in its supports and the holes that load it: each satellite on the side of its crank. */
export function pinDrawing({ input, width, height }) {
  const { mechanism, contact, besides: { pin } } = input;
  const rolls = sleeved(input);
  const { pin_radius_mm: rim, hole_radius_mm: hole, contact_length_mm: b } = contact;
  const planes = pin.satellite_positions_mm.slice(0, MOST_DRAWN);
  const radius = rolls ? pin.diameter_mm / 2 : rim;
  const held = pin.support === "cantilever" ? null : pin.span_mm;
  const tied = pin.support === "tie_ring";
  const end = Math.max(held === null ? 0 : held + (tied ? radius / 2 : 0), ...planes.map((z) => z + b / 2));
  const tall = Math.max(2 * hole, 2 * rim) + 0.35 * rim;
  const reach = { from: -0.06 * end, to: end * 1.02, above: tall - rim, below: tall - rim, tiers: Math.min(planes.length, MOST_NAMED) + (held ? 1 : 0) };
  const view = viewOf({ width, height }, reach);
  const sides = cranksOf(mechanism).map((angle) => (Math.cos(angle * RADIAN) < -1e-9 ? -1 : 1));
  const low = view.at([0, -(tall - rim)])[1];
  const axis = (x) => view.at([x, 0]);
  const half = view.size(radius) + 12;
  const marks = roundBelow(end / 2, "mm");
  const edge = view.size(tall - 2 * rim); // of a satellite beside its hole
  const named = edge > ARROW + 8 ? ARROW / 2 : Math.max(edge, ARROW) + 10; // px from the pin to a force's name: clear of that edge
  return {
    markup: paper(width, height, html`
      ${planes.map((z, j) => {
        const side = sides[j] ?? 1;
        const far = -side * (2 * hole - rim); // the hole's other edge
        return html`<g class="series-${(j % 6) + 1}">${[[side * rim, side * (tall - rim)], [far, far - side * 0.35 * rim]].map(([y0, y1]) =>
          bar(view, z - b / 2, z + b / 2, y0, y1, "body satellite-body", "pin.satellite_positions_mm contact.hole_radius_mm contact.contact_length_mm"))}
          ${rolls && bar(view, z - b / 2, z + b / 2, -rim, rim, "body", "contact.pin_radius_mm")}
          ${arrow(view.at([z, side * (rim + ARROW / view.scale)]), view.at([z, side * rim]), "force")}
          ${label([view.at([z, 0])[0] + 6, view.at([0, side * rim])[1] - side * named + 5], `F_${j + 1}`, { anchor: "start" })}</g>`;
      })}
      ${bar(view, 0, end, -radius, radius, "body", "pin.diameter_mm contact.pin_radius_mm")}
      ${line(axis(reach.from), axis(reach.to), "centre")}
      ${held !== null && pin.support === "supported" ? knife([axis(0)[0], view.at([0, -radius])[1]]) : wall(axis(0), half, 1)}
      ${tied && tieRing(view, held, radius, pin.ring_joint)}
      ${held !== null && !tied && (pin.support === "supported" ? knife([axis(held)[0], view.at([0, -radius])[1]]) : wall(axis(held), half, -1))}
      ${dimension([axis(0)[0] - 26, view.at([0, -radius])[1]], [axis(0)[0] - 26, view.at([0, radius])[1]], "d", { value: "", field: "pin.diameter_mm contact.pin_radius_mm", beside: -6 })}
      ${places(view, 0, planes, low, "pin.satellite_positions_mm", (i) => `z_${i + 1}`)}
      ${held !== null && places({ ...view }, 0, [held], low + TIER * Math.min(planes.length, MOST_NAMED), "pin.span_mm", () => "L")}
      ${scaleBar([12, height - 12], view.size(marks), mm(marks))}`, { "px-per-mm": view.scale }),
    caption: message("strength.scale", { diameter: mm(2 * radius) }),
  };
}

/** A bearing in section: two rolling elements about the shaft. */
function rolling(view, x, radius) {
  const [cx, cy] = view.at([x, 0]);
  const [size, away] = [8, view.size(radius)];
  return html`${[-1, 1].map((side) => {
    const y = cy + side * (away + size);
    return html`<path class="body" d="M${cx - size} ${y - size}h${2 * size}v${2 * size}h${-2 * size}zM${cx - size} ${y - size}l${2 * size} ${2 * size}M${cx + size} ${y - size}l${-2 * size} ${2 * size}"/>`;
  })}`;
}

/** The crankshaft with its bearings and satellites in the plane of the first crank. */
export function crankDrawing({ input, answer, width, height }) {
  const { mechanism, load, contact, crankshaft: _, satellite_body: body = {}, besides } = input;
  const { satellite_positions_mm: all, bearing_positions_mm: [A, B] } = besides.crankshaft;
  const { eccentricity_mm: e, contact_length_mm: b, hole_radius_mm: hole } = contact;
  const planes = all.slice(0, MOST_DRAWN);
  const outer = body.outer_radius_mm ?? load.pin_circle_radius_mm + hole;
  const bore = body.bore_radius_mm ?? Math.max(load.pin_circle_radius_mm - 1.5 * hole, 0.3 * outer);
  const shaft = Math.max(bore / 2 - e, 0.25 * bore);
  const offsets = cranksOf(mechanism).map((angle) => e * Math.cos(angle * RADIAN));
  const [from, to] = ends([A, B, ...planes.map((z) => z - b / 2), ...planes.map((z) => z + b / 2)]);
  const tall = outer + e;
  const named = Math.min(planes.length, MOST_NAMED);
  const view = viewOf({ width, height }, { from, to, above: tall, below: tall, tiers: named + 1 });
  const low = view.at([0, -tall])[1];
  const { bearings } = answer.crankshaft;
  const most = Math.max(...bearings.map(({ peak_N: force }) => force));
  const newton = most > 0 ? Math.min(70, view.size(tall) - 20) / most : 0;
  const marks = roundBelow((to - from) / 2, "mm");
  return {
    markup: paper(width, height, html`
      ${planes.map((z, j) => {
        const o = offsets[j] ?? 0;
        return html`<g class="series-${(j % 6) + 1}">
          ${[1, -1].map((side) => bar(view, z - b / 2, z + b / 2, o + side * bore, o + side * outer, "body satellite-body", "crankshaft.satellite_positions_mm contact.contact_length_mm"))}
          ${bar(view, z - b / 2, z + b / 2, o - bore * 0.8, o + bore * 0.8, "body", "contact.eccentricity_mm")}
          ${line(view.at([z - b / 2 - b / 8, o]), view.at([z + b / 2 + b / 8, o]), "centre crank-axis")}
          ${label([view.at([z, 0])[0], view.at([0, o + outer])[1] - 6], `${j + 1}`)}</g>`;
      })}
      ${bar(view, from, to, -shaft, shaft, "body")}
      ${line(view.at([from, 0]).map((x, i) => x - (i === 0 ? 16 : 0)), view.at([to, 0]).map((x, i) => x + (i === 0 ? 16 : 0)), "centre")}
      ${[A, B].map((place, i) => {
        const [x, y] = view.at([place, 0]);
        const tip = y + view.size(shaft) + 18;
        return html`${rolling(view, place, shaft)}<g data-bearing="${"AB"[i]}" data-length="${bearings[i].peak_N * newton}">${arrow([x, tip + bearings[i].peak_N * newton], [x, tip], "force")}</g>
          ${label([x + (i === 0 ? -10 : 10), tip + bearings[i].peak_N * newton / 2 + 14], `R_${"AB"[i]}`, { anchor: i === 0 ? "end" : "start" })}`;
      })}
      ${places(view, A, [...planes.slice(0, MOST_NAMED)], low, "crankshaft.satellite_positions_mm", (i) => `z_${i + 1}`)}
      ${places(view, A, [B], low + TIER * named, "crankshaft.bearing_positions_mm", () => "AB")}
      ${scaleBar([12, height - 12], view.size(marks), mm(marks))}
      ${most > 0 && scaleBar([view.size(marks) + 110, height - 12], roundBelow(most, "N") * newton, formatQuantity(roundBelow(most, "N"), "N", 3), "force")}`, {
      "px-per-mm": view.scale, "px-per-n": newton,
    }),
    caption: message(body.outer_radius_mm ? "crank.scale" : "crank.scaleAssumed", { eccentricity: mm(e) }),
  };
}

/** A part on both sides of an axis at `o`, from one radius to another. */
const mirrored = (view, x0, x1, from, to, o = 0, kind = "body", field = "") => html`${[1, -1].map((side) => bar(view, x0, x1, o + side * from, o + side * to, kind, field))}`;

/** A bearing in section, its rolling elements crossed; nothing where its sizes are not known. */
function bearingMarkup(view, x, { bore_diameter_mm: inner, outer_diameter_mm: outer, width_mm: width }, o = 0, field = "") {
  if (!(inner && outer && width)) return null;
  const [low, high] = [inner / 2, outer / 2];
  const cross = (side) => [[low, high], [high, low]].map(([a, b]) => line(view.at([x - width / 2, o + side * a]), view.at([x + width / 2, o + side * b]), "rolling", field));
  return html`${mirrored(view, x - width / 2, x + width / 2, low, high, o, "body", field)}${[1, -1].map(cross)}`;
}

/** Where the discs stand along the axis. */
const discsOf = ({ crankshaft, pin }) => crankshaft?.satellite_positions_mm ?? pin?.satellite_positions_mm;

/** The reducer cut along its axis in the plane of the first crank: what is known of its discs, pins, ring, bearings, shaft, carrier and housing. */
export function axisDrawing({ input, answer, width, height }) {
  const { mechanism, load, contact, satellite_body: body = {}, besides } = input;
  const { crankshaft = {}, pin = {}, gear = {}, bearing = {} } = besides;
  const usual = (answer.assumed ?? []).filter(({ pointer }) => pointer.startsWith("/build/")).map(({ pointer, value }) => [pointer.split("/")[2], value]);
  const made = { ...Object.fromEntries(usual), ...besides.build };
  const { eccentricity_mm: e, contact_length_mm: b, pin_radius_mm: r } = contact;
  const R = load.pin_circle_radius_mm;
  const hole = contact.hole_radius_mm ?? r + e + (contact.hole_clearance_mm ?? 0);
  const planes = discsOf(besides).slice(0, MOST_DRAWN);
  const offsets = cranksOf(mechanism).map((angle) => e * Math.cos(angle * RADIAN));
  const [first, last] = ends(planes);
  const { ring_pin_circle_radius_mm: circle, ring_pin_radius_mm: ringPin } = gear;
  const rim = circle && ringPin ? circle - ringPin : body.outer_radius_mm ?? R + 1.3 * hole;
  const bore = body.bore_radius_mm ?? bearing.outer_diameter_mm / 2;
  const start = pin.satellite_positions_mm ? planes[0] - pin.satellite_positions_mm[0] : first - b / 2 - b / 4;
  const held = pin.span_mm && pin.support !== "cantilever";
  const end = held ? start + pin.span_mm : last + b / 2;
  const plates = [[start - (made.carrier_width_mm ?? 0), start], ...held ? [[end, end + (made.second_carrier_width_mm ?? 0)]] : []].filter(([from, to]) => to > from);
  const shaft = (crankshaft.bearing_positions_mm ?? []).map((place, i) => ({ place, ...crankshaft.bearings?.[i] }));
  const middle = (first + last) / 2;
  const wall = made.housing_width_mm ? [middle - made.housing_width_mm / 2, middle + made.housing_width_mm / 2] : [first - b / 2, last + b / 2];
  const outside = (made.housing_diameter_mm ?? 0) / 2;
  const tall = Math.max(outside, (made.carrier_diameter_mm ?? 0) / 2, ringPin ? circle + ringPin : rim + e);
  const beyond = shaft.map(({ width_mm: wide = b / 2 }) => wide);
  const [from, to] = ends([...planes.flatMap((z) => [z - b / 2, z + b / 2]), start, end, ...plates.flat(), ...outside ? wall : [], ...shaft.flatMap(({ place }, i) => [place - beyond[i], place + beyond[i]])]);
  const view = viewOf({ width, height }, { from, to, above: tall, below: tall, tiers: 1 });
  const low = view.at([0, -tall])[1];
  const radius = (shaft[0]?.bore_diameter_mm ?? bearing.bore_diameter_mm ?? bore) / 2;
  const marks = roundBelow((to - from) / 2, "mm");
  return {
    markup: paper(width, height, html`
      ${outside > 0 && mirrored(view, ...wall, ringPin ? circle : rim + e, outside, 0, "body housing", "build.housing_diameter_mm build.housing_width_mm")}
      ${ringPin && mirrored(view, first - b / 2, last + b / 2, circle - ringPin, circle + ringPin, 0, "pin", "gear.ring_pin_circle_radius_mm gear.ring_pin_radius_mm")}
      ${made.carrier_diameter_mm && plates.map(([x0, x1]) => mirrored(view, x0, x1, Math.max(...shaft.map(({ outer_diameter_mm: d = 0 }) => d / 2), 0), made.carrier_diameter_mm / 2, 0, "body", "build.carrier_diameter_mm build.carrier_width_mm"))}
      ${planes.map((z, j) => {
        const o = offsets[j] ?? 0;
        const [x0, x1] = [z - b / 2, z + b / 2];
        return html`<g class="series-${(j % 6) + 1}">
          ${[1, -1].map((side) => bar(view, x0, x1, o + side * bore, side * rim + (ringPin ? 0 : o), "body satellite-body", "crankshaft.satellite_positions_mm contact.contact_length_mm"))}
          ${[1, -1].map((side) => bar(view, x0, x1, side * R + o - hole, side * R + o + hole, "body cut", "contact.hole_radius_mm"))}
          ${bar(view, x0, x1, o - (bearing.bore_diameter_mm / 2 || bore * 0.8), o + (bearing.bore_diameter_mm / 2 || bore * 0.8), "body", "contact.eccentricity_mm")}
          ${bearingMarkup(view, z, bearing, o, "bearing.outer_diameter_mm bearing.width_mm")}
          ${line(view.at([x0 - b / 8, o]), view.at([x1 + b / 8, o]), "centre crank-axis")}</g>`;
      })}
      ${[1, -1].map((side) => bar(view, plates[0]?.[0] ?? start, plates[1]?.[1] ?? end, side * R - r, side * R + r, "pin", "contact.pin_radius_mm load.pin_circle_radius_mm"))}
      ${bar(view, from, planes[0] - b / 2, -radius, radius, "body")}${bar(view, planes.at(-1) + b / 2, to, -radius, radius, "body")}
      ${shaft.map((one, i) => html`${bearingMarkup(view, one.place, one, 0, `crankshaft.bearings.${i}.outer_diameter_mm`) ?? rolling(view, one.place, radius)}`)}
      ${line(view.at([from, 0]).map((x, i) => x - (i === 0 ? 16 : 0)), view.at([to, 0]).map((x, i) => x + (i === 0 ? 16 : 0)), "centre")}
      ${shaft.length > 1 ? places(view, shaft[0].place, [shaft[1].place], low, "crankshaft.bearing_positions_mm", () => "AB")
        : planes.length > 1 && places(view, first, [last], low, "pin.satellite_positions_mm", () => "z")}
      ${scaleBar([12, height - 12], view.size(marks), mm(marks))}`, { "px-per-mm": view.scale }),
    caption: message("drawing.axisScale"),
  };
}
