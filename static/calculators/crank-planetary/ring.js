/** Satellites and their ring, cycloid discs on pins or involute teeth, to scale: what of the drawing of the mechanism is theirs. */
import { isOfRing } from "../../lib/chart.js";
import { formatQuantity } from "../../lib/format.js";
import { html } from "../../lib/html.js";
import { arrowOf, circle, path, roundBelow, set, setArrow } from "../../lib/svg.js";
import { message } from "../../messages/index.js";
import { pitchRadii, ringAt } from "./mechanism.js";

const GAP = 0.09; // the longest bar of a gap at most, of the circle of the ring's pins
const PITCHES = 3.2; // in sight where the mesh is magnified
const APART = 3; // px between the bars of discs at one pin
const NUMBERED = 6.5; // px: least radius of a pin with its number beside it
const RADIAN = Math.PI / 180;

const FIELD = {
  circle: "gear.ring_pin_circle_radius_mm",
  pin: "gear.ring_pin_radius_mm mechanism.ring_teeth",
  profile: "mechanism.satellite_teeth gear.modification.equidistant_mm gear.modification.pin_circle_mm gear.satellite_profile_shift gear.satellite_addendum",
  teeth: "mechanism.ring_teeth gear.ring_profile_shift gear.ring_addendum gear.cutter_teeth",
};

/** Where the ring's body is: its bore, in whose halves pins are seated, and its outside. */
export function bodyOf({ circle: own, radius, seated, ringLobe }) {
  if (ringLobe) return { bore: own, outside: 1.05 * own };
  return { bore: own + (seated ? 0 : 1.1 * radius), outside: own + 2.6 * radius };
}

/** How many times as long as they are gaps are drawn; 0 where there are none. */
const timesOf = ({ circle: own, widest }) => (widest > 0 ? roundBelow((GAP * own) / widest, "") : 0);

/** How far from the axis all that is drawn reaches, with arrows of so many mm a newton. */
export function reachOf(ring, arrowScale) {
  return Math.max(bodyOf(ring).outside + ring.widest * timesOf(ring), ring.circle + ring.peak * arrowScale);
}

/** A turned point, degrees against the clock. */
function turned([x, y], angle) {
  const [c, s] = [Math.cos(angle * RADIAN), Math.sin(angle * RADIAN)];
  return [c * x - s * y, s * x + c * y];
}

/** Points of an outline of so many equal pitches, turned. */
const around = (view, lobe, count, angle) => Array.from({ length: count }, (_, i) => lobe.map((point) => view.at(turned(point, angle - (360 * i) / count)))).flat();

/** What of a satellite's group is the disc, about the axis at the crank angle 0. */
export const discStill = (view, { ring }, j) => ring?.lobe && path(around(view, ring.lobe, ring.lobes, ring.turns[j]), "profile", FIELD.profile);

const numberAt = ([x, y], number) => html`<text class="number ring-number" text-anchor="middle" x="${x}" y="${y + 3}">${number}</text>`;

/** The ring with its pins or its teeth, which stand still. */
export function ringStill(view, centre, { ring }) {
  const { bore, outside } = bodyOf(ring);
  if (ring.ringLobe) {
    return html`${circle(centre, view.size(outside), "ring", FIELD.teeth)}
      ${path(around(view, ring.ringLobe, ring.ringTeeth, ring.ringTurn), "bore ring-teeth", FIELD.teeth)}`;
  }
  const size = view.size(ring.radius);
  return html`${circle(centre, view.size(outside), "ring", FIELD.circle)}${circle(centre, view.size(bore), "bore")}
    ${circle(centre, view.size(ring.circle), "centre", FIELD.circle)}
    <g class="ring-pins">${ring.pins.map(({ centre: place, radius }, k) => html`<circle class="ring-pin" data-field="${FIELD.pin}"
      cx="${view.at(place)[0]}" cy="${view.at(place)[1]}" r="${view.size(radius)}"${ring.force && html` data-pair="1/${k + 1}"`}/>
      ${size >= NUMBERED && numberAt(view.at(place.map((part) => part * (1 + (1.8 * radius) / Math.hypot(...place)))), k + 1)}`)}</g>`;
}

/** Forces on the discs, and gaps, which move. */
export function ringMarks({ ring, cranks }) {
  return ring.force && html`<g class="ring-marks">${cranks.map((_, j) => html`<g class="series-${(j % 6) + 1}">${ring.pins.map((_pin, k) => html`
    <line class="ring-gap none"/><g class="arrow force none" data-pair="${j + 1}/${k + 1}"><line class="shaft"/><path class="head"/></g>`)}</g>`)}</g>`;
}

/** One pin of the ring with the disc beside it, enlarged. */
export function ringDetail(spot) {
  return html`<g class="ring-detail none"><clipPath id="ring-detail"><circle cx="${spot.x}" cy="${spot.y}" r="${spot.half * 0.72}"/></clipPath>
    <g clip-path="url(#ring-detail)"><circle class="ring-pin"/><path class="profile" vector-effect="non-scaling-stroke"/><line class="velocity"/></g>
    <g class="arrow force"><line class="shaft"/><path class="head"/></g><circle class="contact" r="3"/></g>`;
}

/** What moves of these, on the page. */
export function ringParts(host) {
  const root = host.querySelector(".ring-detail");
  const of = (selector) => root.querySelector(selector);
  return {
    pins: [...host.querySelectorAll(".ring-pins .ring-pin")],
    gaps: [...host.querySelectorAll(".ring-gap")],
    arrows: [...host.querySelectorAll(".ring-marks .arrow")].map(arrowOf),
    profiles: [...host.querySelectorAll(".satellite .profile")],
    one: root && { root, pin: of(".ring-pin"), profile: of(".profile"), normal: of(".velocity"), arrow: arrowOf(of(".arrow")), contact: of(".contact") },
  };
}

/** Where a pin presses a disc, and the normal there, outwards: it passes through the pitch point. */
function contactOf(m, direction, { centre, radius }) {
  const pitch = pitchRadii(m).ring;
  const away = [centre[0] - direction[0] * pitch, centre[1] - direction[1] * pitch];
  const length = Math.hypot(...away);
  const normal = away.map((part) => part / length);
  return { normal, touch: centre.map((part, i) => part - normal[i] * radius) };
}

/** Forces and gaps at a crank angle; runs for every frame of the slider. */
export function placeRing(parts, { m, angle, directions }) {
  const { ring } = m;
  if (!ring?.force) return;
  const { view, arrowScale, ring: own } = parts;
  const { force, gap } = ringAt(m, angle);
  const { outside } = bodyOf(ring);
  const times = timesOf(ring);
  const count = ring.pins.length;
  directions.forEach((direction, j) => {
    ring.pins.forEach((pin, k) => {
      const i = j * count + k;
      const { normal, touch } = contactOf(m, direction, pin);
      const tail = touch.map((part, axis) => part + normal[axis] * force[i] * arrowScale);
      setArrow(own.arrows[i], view.at(tail), view.at(touch), force[i] > 0);
      own.gaps[i].classList.toggle("none", force[i] > 0 || !(gap[i] > 0)); // both between a point with either
      const far = Math.hypot(...pin.centre);
      const out = pin.centre.map((part) => part / far);
      const [from, to] = [outside, outside + gap[i] * times].map((length) => view.at(out.map((part) => part * length)));
      const aside = (j - (directions.length - 1) / 2) * APART;
      set(own.gaps[i], { x1: from[0] + out[1] * aside, y1: from[1] + out[0] * aside, x2: to[0] + out[1] * aside, y2: to[1] + out[0] * aside });
    });
  });
  own.pins.forEach((pin, k) => {
    const most = directions.reduce((best, _, j) => (force[j * count + k] > force[best * count + k] ? j : best), 0);
    pin.dataset.pair = `${most + 1}/${k + 1}`;
    pin.classList.toggle("loaded", force[most * count + k] > 0);
  });
}

/** One pair enlarged, by its name `satellite/pin`; what is said of it. */
export function placeRingDetail(parts, { m, angle, directions }, name) {
  const { view, detail, arrowScale, ring: { one, profiles } } = parts;
  const [satellite, number] = name.split("/").map(Number);
  const [j, k] = [satellite - 1, number - 1];
  const pin = m.ring.pins[k];
  const { force, gap } = ringAt(m, angle);
  const i = j * m.ring.pins.length + k;
  const size = (detail.half * 0.3) / (m.ring.radius * view.scale); // of what is drawn beside it
  const [x, y] = view.at(pin.centre);
  const at = (place) => view.at(place).map((part, axis) => [detail.x, detail.y][axis] + size * (part - [x, y][axis]));
  const { normal, touch } = contactOf(m, directions[j], pin);
  one.root.setAttribute("class", `ring-detail series-${(j % 6) + 1}`);
  set(one.pin, { cx: detail.x, cy: detail.y, r: view.size(pin.radius) * size });
  if (profiles[j]) {
    const placed = profiles[j].parentNode.getAttribute("transform");
    set(one.profile, { d: profiles[j].getAttribute("d"), transform: `translate(${detail.x - size * x} ${detail.y - size * y}) scale(${size}) ${placed}` });
  }
  const spot = at(touch);
  set(one.contact, { cx: spot[0], cy: spot[1] });
  set(one.normal, { x1: detail.x, y1: detail.y, x2: spot[0] - normal[0] * detail.half, y2: spot[1] + normal[1] * detail.half });
  const length = force[i] * arrowScale * view.scale; // the bar of the forces holds here too
  setArrow(one.arrow, [spot[0] + normal[0] * length, spot[1] - normal[1] * length], spot, force[i] > 0);
  return wordsOf(name, force[i], gap[i]);
}

/** What is said of a pin of the ring and a disc, `satellite/pin`. */
function wordsOf(name, force, gap) {
  const [satellite, pin] = name.split("/");
  return force > 0 ? message("drawing.ringCarries", { satellite, pin, force: formatQuantity(force, "N", 3) })
    : message("drawing.ringGap", { satellite, pin, gap: formatQuantity(gap, "mm", 2) });
}

/** How much of the mesh is in sight where it is magnified, mm. */
export const meshInSight = ({ circle: own, ringTeeth, pins }) => (PITCHES * 2 * Math.PI * own) / (ringTeeth ?? pins.length);

/** Where the mesh is to be looked at, and what is said of it: the pin that bears most or is selected; of involute teeth where they meet. */
export function meshAt(m, { angle, directions }, pair) {
  const { ring } = m;
  if (!ring.force) return { place: directions[0].map((part) => part * ring.circle), said: "" };
  const { force, gap } = ringAt(m, angle);
  const count = ring.pins.length;
  const [satellite, pin] = isOfRing(pair) ? pair.split("/").map(Number) : [];
  const i = satellite ? (satellite - 1) * count + pin - 1 : force.indexOf(Math.max(...force));
  const name = `${Math.floor(i / count) + 1}/${(i % count) + 1}`;
  return { place: ring.pins[i % count].centre, said: wordsOf(name, force[i], gap[i]) };
}

/** What is said of the ring under the drawing; nothing where there is none. */
export function ringCaption({ ring }) {
  if (!ring) return "";
  if (ring.ringLobe) return message("drawing.teeth");
  if (!ring.force) return message(ring.turns ? "drawing.manyTurns" : "drawing.ringPins");
  const times = timesOf(ring);
  return [
    message("drawing.ring"), times > 0 && message("drawing.gaps", { times: String(times) }), !ring.lobe && message("drawing.noProfile"),
  ].filter(Boolean).join(" ");
}
