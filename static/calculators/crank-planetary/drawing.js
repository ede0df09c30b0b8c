/** The crank-planetary mechanism to scale at a crank angle: the whole, and one pair enlarged. */
import { isOfRing } from "../../lib/chart.js";
import { formatQuantity } from "../../lib/format.js";
import { fill, html } from "../../lib/html.js";
import { message } from "../../messages/index.js";
import { arcPath, arrowOf, circle, createView, headPath, label, line, mm, paper, radius, roundBelow, scaleBar, set, setArrow, sized, WIDE_PX } from "../../lib/svg.js";
import { crankDirections, drivingAt, evenly, forcesAt, mechanismOf, MOST_PAIRS, moved, pinAngle, pinCentres, pitchRadii } from "./mechanism.js";
import { discStill, meshAt, meshInSight, placeRing, placeRingDetail, reachOf, ringCaption, ringDetail, ringMarks, ringParts, ringStill } from "./ring.js";

const STYLES = 6; // of satellites, as in the figures
const ARROW = 0.42; // the longest arrow, of the pin circle's radius
const MESH_ARROW = 0.3; // the longest arrow where the mesh is magnified, of what is in sight
const LESS = 2; // how many times shorter arrows at the ring are at most, of its circle
const MARGIN = 26; // px

const LABEL_PX = 70; // room for the dimensions about the pair, besides their values
const CHARACTER_PX = 6.7;
const LINE_PX = 15;
const ROOMY = 160; // half the room of the pair from which its dimensions need no more to the right
const FIELD = {
  R: "load.pin_circle_radius_mm",
  pin: "contact.pin_radius_mm",
  hole: "contact.hole_radius_mm",
  e: "contact.eccentricity_mm",
  pins: "mechanism.pins",
  satellites: "mechanism.satellites",
  ratio: "mechanism.ratio mechanism.satellite_teeth mechanism.ring_teeth",
  spacing: "mechanism.crank_spacing_deg mechanism.crank_angles_deg",
  start: "mechanism.initial_crank_angle_deg",
};

/** Where the two views stand on a paper of this size, or the first `alone`. */
function places(width, height, alone) {
  if (alone) return { main: { x: width / 2, y: height / 2, half: Math.min(width, height) / 2 } };
  const wide = width >= WIDE_PX;
  const main = wide ? Math.min(height, width * 0.58) : Math.min(width, height * 0.58);
  const half = main / 2;
  const beside = (width - main) / 2;
  return wide
    ? { main: { x: half, y: height / 2, half }, detail: { x: main + beside - Math.max(0, ROOMY - beside), y: height / 2, half: Math.min(beside, height / 2) } }
    : { main: { x: width / 2, y: half, half }, detail: { x: width / 2, y: (main + height) / 2, half: Math.min((height - main) / 2, width / 2) } };
}

function mainStill(view, centre, half, m) {
  const centres = evenly(m.pins, m.radius).map(view.at);
  const pitch = pitchRadii(m);
  const shownPitch = m.eccentricity && !m.ring?.lobe && view.size(pitch.ring) < half;
  const body = m.eccentricity && !m.ring && pitch.satellite > m.radius + m.holeRadius;
  return html`
    ${m.ring && ringStill(view, centre, m)}
    ${shownPitch && html`${body && circle(centre, view.size(pitch.ring * 1.05), "ring", FIELD.ratio)}
      ${body && circle(centre, view.size(pitch.ring), "bore")}
      ${circle(centre, view.size(pitch.ring), "pitch", FIELD.ratio)}`}
    ${line([centre[0] - half + 4, centre[1]], [centre[0] + half - 4, centre[1]], "centre")}
    ${line([centre[0], centre[1] - half + 4], [centre[0], centre[1] + half - MARGIN + 3], "centre")}
    ${circle(centre, view.size(m.radius), "centre pin-circle", FIELD.R)}
    ${m.cranks.map((_, j) => html`<g class="satellite series-${(j % STYLES) + 1}" data-field="${FIELD.satellites}">
      ${discStill(view, m, j)}${shownPitch && circle(centre, view.size(pitch.satellite), "pitch", FIELD.ratio)}
      ${m.eccentricity && centres.map(([x, y], n) => html`<circle class="hole" data-pair="${j + 1}.${n + 1}" data-field="${FIELD.hole}" cx="${x}" cy="${y}" r="${view.size(m.holeRadius)}"/>`)}</g>`)}
    <g class="pins">${centres.map((place) => html`${circle(place, m.pinRadius ? view.size(m.pinRadius) : 4, "pin", `${FIELD.pins} ${FIELD.pin}`)}
      ${m.inside && circle(place, view.size(m.inside), "pin inside")}`)}</g>
    ${Array.from({ length: m.pins }, (_, n) => html`<text class="number pin-number" text-anchor="middle">${n + 1}</text>`)}
    ${m.cranks.map((_, j) => html`<g class="crank series-${(j % STYLES) + 1}"><line/><circle r="2.5"/><text class="number" text-anchor="middle">${j + 1}</text></g>`)}
    <g class="angle phi" data-field="${FIELD.start}"><path class="arc"/><path class="head"/>${label([0, 0], m.start === 0 ? "φ" : "φ + φ₀")}</g>
    ${m.cranks.length > 1 && html`<g class="angle alpha" data-field="${FIELD.spacing}"><path class="arc"/><path class="head"/>${label([0, 0], "α")}</g>`}
    ${m.pairs.map((pair) => html`<g class="arrow force series-${((pair.satellite - 1) % STYLES) + 1}" data-pair="${pair.satellite}.${pair.pin}"><line class="shaft"/><path class="head"/></g>`)}
    ${m.ring && ringMarks(m)}
    ${radius(centre, view.size(m.radius), betweenPins(m.pins), "R", { of: m.radius, field: FIELD.R, lead: half - MARGIN + 12 - view.size(m.radius), least: 84 })}`;
}

/** Where a line passes between the pins to the free corner at the upper left, degrees from upright. */
function betweenPins(pins) {
  return pins < 5 ? -45 : (-180 / pins) * (2 * Math.max(0, Math.floor((pins / 4 - 1) / 2)) + 1);
}

function detailStill(m, spot) {
  return html`
    ${m.ring?.force && ringDetail(spot)}
    <g class="detail">
      ${line([spot.x - spot.half + 6, spot.y], [spot.x + spot.half - 6, spot.y], "centre")}
      ${line([spot.x, spot.y - spot.half + 30], [spot.x, spot.y + spot.half - 24], "centre")}
      <circle class="hole" data-field="${FIELD.hole}"/><circle class="pin" data-field="${FIELD.pin}"/>${m.inside && html`<circle class="pin inside"/>`}
      <line class="velocity"/><g class="angle gamma"><path class="arc"/>${label([0, 0], "γ")}</g>
      <g class="moving"></g>
      <g class="arrow force"><line class="shaft"/><path class="head"/></g>
      <circle class="contact" r="3"/>
    </g>
    <text class="words title" y="${spot.y - spot.half + 18}"></text>`;
}

/** What is said of the pair: in two lines, upwards, where one would leave the paper. */
function titleMarkup(text, { x, half }, width) {
  const from = x - half + 6;
  const place = text.length * CHARACTER_PX > width - from ? text.lastIndexOf(" ", text.length * 0.6) + 1 : 0;
  const lines = [text.slice(0, place), text.slice(place)].filter(Boolean);
  return html`${lines.map((line, i) => html`<tspan x="${from}" dy="${i ? LINE_PX : -LINE_PX * (lines.length - 1)}">${line}</tspan>`)}`;
}

function setAngle(root, centre, size, from, to) {
  const sweep = (((to - from) % 360) + 360) % 360;
  const [arc, head] = root.querySelectorAll("path");
  arc.setAttribute("d", arcPath(centre, size, from, from + sweep));
  const place = (turned, by) => [
    centre[0] + by * Math.sin((turned * Math.PI) / 180), centre[1] - by * Math.cos((turned * Math.PI) / 180),
  ];
  head?.setAttribute("d", sweep * size > 600 ? headPath(place(from + sweep - 400 / size, size), place(from + sweep, size)) : "");
  const [x, y] = place(from + sweep / 2, size + 12);
  set(root.querySelector("text"), { x, y: y + 4 });
}

/** Show the mechanism in a state; runs for every frame of the slider. */
function placeMain(parts, { m, angle, directions, pins, driving, force }) {
  const { view, main, arrowScale } = parts;
  const centre = [main.x, main.y];
  const turned = -pinAngle(m, angle);
  const eccentricity = m.eccentricity ?? 0;
  parts.satellites.forEach((satellite, j) => {
    const [x, y] = directions[j];
    const by = view.scale * eccentricity;
    satellite.setAttribute("transform", `translate(${x * by} ${-y * by}) rotate(${turned} ${main.x} ${main.y})`);
  });
  parts.pins.setAttribute("transform", `rotate(${turned} ${main.x} ${main.y})`);
  pins.forEach((pin, n) => {
    const [x, y] = view.at(pin);
    set(parts.numbers[n], { x, y: y + 4 });
  });
  const reach = Math.min(main.half * 0.3, view.size(m.radius) * 0.55);
  parts.cranks.forEach(({ line: ray, dot, text }, j) => {
    const [x, y] = directions[j];
    set(ray, { x1: main.x, y1: main.y, x2: main.x + x * reach, y2: main.y - y * reach });
    set(dot, { cx: main.x + x * view.scale * eccentricity, cy: main.y - y * view.scale * eccentricity });
    set(text, { x: main.x + x * (reach + 10), y: main.y - y * (reach + 10) + 4 });
  });
  const first = angle + m.start + m.cranks[0];
  setAngle(parts.angles.phi, centre, reach * 0.6, m.cranks[0], first);
  if (parts.angles.alpha) setAngle(parts.angles.alpha, centre, reach * 0.85, first, first + m.cranks[1] - m.cranks[0]);
  const contactRadius = m.pinRadius ?? 0;
  parts.arrows.forEach((arrow, i) => {
    const direction = directions[Math.floor(i / m.pins)];
    const touch = moved(pins[i % m.pins], direction, -contactRadius);
    parts.holes[i]?.classList.toggle("driving", driving[i]);
    const shown = driving[i] && force && force[i] > 0;
    setArrow(arrow, shown ? view.at(moved(touch, direction, -force[i] * arrowScale)) : null, view.at(touch), shown);
  });
}

/** Show one pair enlarged. */
function placeDetail(parts, { m, directions, pins, driving, force, real }, i) {
  const { close, detail, one } = parts;
  const satellite = Math.floor(i / m.pins);
  const direction = directions[satellite];
  const centre = [detail.x, detail.y];
  const touch = close.at(moved([0, 0], direction, -m.pinRadius));
  const hole = close.at(moved([0, 0], direction, m.eccentricity));
  one.root.setAttribute("class", `detail series-${(satellite % STYLES) + 1}`);
  set(one.hole, { cx: hole[0], cy: hole[1], r: close.size(m.holeRadius) });
  one.hole.classList.toggle("driving", driving[i]);
  set(one.pin, { cx: centre[0], cy: centre[1], r: close.size(m.pinRadius) });
  if (one.inside) set(one.inside, { cx: centre[0], cy: centre[1], r: close.size(m.inside) });
  set(one.contact, { cx: touch[0], cy: touch[1] });
  const value = force?.[i] ?? 0;
  const length = value * parts.arrowScale * parts.view.scale; // the bar of the forces holds here too
  const tail = [touch[0] - direction[0] * length, touch[1] + direction[1] * length];
  setArrow(one.arrow, tail, touch, value > 0);
  const [px, py] = pins[i % m.pins];
  const speed = [-py / m.radius, px / m.radius]; // the pins turn against the clock
  const way = detail.half * 0.55;
  set(one.velocity, { x1: centre[0], y1: centre[1], x2: centre[0] + speed[0] * way, y2: centre[1] - speed[1] * way });
  const clock = ([x, y]) => (Math.atan2(x, y) * 180) / Math.PI;
  const [from, to] = [clock(speed), clock(direction)];
  const opening = (((to - from) % 360) + 360) % 360;
  one.gamma.classList.toggle("none", !driving[i]);
  if (opening <= 180) setAngle(one.gamma, centre, way * 0.5, from, to);
  else setAngle(one.gamma, centre, way * 0.5, to, from);
  // Dimensions lie away from the line through the centres, where the force and the contact are, and from the mechanism.
  const away = clock(direction);
  const side = direction[1] >= 0 ? 1 : -1;
  fill(one.moving, html`
    ${line(centre, hole, "crank-line", FIELD.e)}
    ${circle(hole, 2.5, "dot", FIELD.e)}
    ${label([(centre[0] + hole[0]) / 2 + side * direction[1] * 12, (centre[1] + hole[1]) / 2 + side * direction[0] * 12 + 4], "e", { field: FIELD.e })}
    ${radius(centre, close.size(m.pinRadius), away + side * 125, "r_in", { of: m.pinRadius, field: FIELD.pin, lead: close.size(m.holeRadius + m.eccentricity - m.pinRadius) + 6 })}
    ${radius(hole, close.size(m.holeRadius), away + side * 55, "r_out", { of: m.holeRadius, field: FIELD.hole, lead: 10 })}`);
  if (driving[i] && !force) return ""; // until the forces are known
  const drives = real ? "drawing.carries" : "drawing.drives";
  return message(driving[i] ? drives : "drawing.idle", {
    ...m.pairs[i], force: formatQuantity(value, "N"),
  });
}

/** The moving elements of what has been put on the page. */
function partsOf(host, still) {
  const all = (selector) => [...host.querySelectorAll(selector)];
  const one = host.querySelector(".detail");
  const of = (selector) => one.querySelector(selector);
  return {
    ...still,
    satellites: all(".satellite"),
    holes: all(".satellite .hole"),
    pins: host.querySelector(".pins"),
    numbers: all(".pin-number"),
    cranks: all(".crank").map((root) => ({ line: root.querySelector("line"), dot: root.querySelector("circle"), text: root.querySelector("text") })),
    arrows: all(":is(svg, .magnified) > .force.arrow").map(arrowOf),
    ring: ringParts(host),
    title: host.querySelector(".title"),
    angles: { phi: host.querySelector(".phi"), alpha: host.querySelector(".alpha") },
    one: one && {
      root: one, hole: of(".hole"), pin: of(".pin"), inside: of(".inside"), velocity: of(".velocity"), gamma: of(".gamma"),
      moving: of(".moving"), arrow: arrowOf(of(".arrow")), contact: of(".contact"),
    },
  };
}

function caption(m) {
  const ring = ringCaption(m);
  if (ring) return `${message("drawing.toScale")} ${ring}`;
  const pitch = pitchRadii(m).satellite;
  const holes = m.radius + m.holeRadius;
  if (!m.eccentricity) return `${message("drawing.toScale")} ${message("drawing.noContact")}`;
  if (pitch > holes) return [message("drawing.toScale"), m.involute && message("drawing.pitchCircles")].filter(Boolean).join(" ");
  return `${message("drawing.toScale")} ${message("drawing.pitchInside", { pitch: mm(pitch), holes: mm(holes) })}`;
}

/**
 * The drawing of an answer on a paper of a size in pixels; null for too many pairs. `attach(host)`
 * makes it move: `move(angle, pair)` with the name of the pair that is selected, or null.
 */
export function createDrawing({ input, answer, curves, width, height, alone = false, mesh = false }) {
  const m = mechanismOf(input, answer);
  if (m.pairs.length > MOST_PAIRS.drawn) return null;
  const { main, detail } = places(width, height, alone);
  const pitch = pitchRadii(m);
  const holes = m.radius + m.holeRadius;
  const real = Boolean(answer.load_sharing);
  const { peak_force_N: peak, peak_pair: most, peak_crank_angle_deg: at } = answer.load_sharing ?? answer.contact_force ?? {};
  const { ring } = m;
  const largest = Math.max(peak ?? 0, (ring?.peak ?? 0) * (m.radius / (ring?.circle ?? Infinity)) * LESS);
  const inSight = mesh ? meshInSight(ring) : 0; // mm
  const arrowScale = mesh ? (MESH_ARROW * inSight) / (ring.peak || Infinity) : peak ? (ARROW * m.radius) / largest : 0; // mm a newton
  const reach = m.eccentricity
    ? Math.max(holes + m.eccentricity, ring ? reachOf(ring, arrowScale) : pitch.ring < 2 * holes ? pitch.ring * 1.05 : 0)
    : m.radius * 1.2;
  const view = createView({ ...main, scale: mesh ? (2 * main.half) / inSight : (main.half - MARGIN) / reach });
  const room = LABEL_PX + CHARACTER_PX * Math.max(...[m.holeRadius, m.pinRadius].map((length) => sized("", length ?? 0).join("").length));
  const close = m.eccentricity && detail
    ? createView({ ...detail, scale: Math.max(detail.half * 0.24, Math.min(detail.half * 0.62, detail.half - room)) / (m.holeRadius + m.eccentricity) })
    : null;
  const round = mesh ? ring.peak && roundBelow(ring.peak / 2, "N") : peak && roundBelow(peak / 2, "N");
  const bar = roundBelow(mesh ? inSight / 4 : m.radius, "mm");
  const names = m.pairs.map(({ satellite, pin }) => `${satellite}.${pin}`);
  const usual = most ? names.indexOf(`${most.satellite}.${most.pin}`) : 0;
  /** Which pairs drive at a crank angle, and their forces; of the real ones those drive whose force would be seen. */
  const loadsAt = (angle) => {
    const driving = drivingAt(m, angle);
    const force = forcesAt(m, curves, angle, real ? null : driving);
    if (force && angle === at) force[usual] = peak; // which lies between two points of the curve
    return { driving: real && force ? force.map((one) => one > 1e-6 * peak) : driving, force };
  };
  const scales = [
    scaleBar([12, height - 14], view.size(bar), mm(bar)),
    round && scaleBar([view.size(bar) + 110, height - 14], view.size(round * arrowScale), formatQuantity(round, "N", 3), "force"),
  ];
  return {
    markup: paper(width, height, html`
      ${mesh ? html`<g class="magnified">${mainStill(view, [main.x, main.y], main.half, m)}</g><text class="words title" y="18"></text>`
    : html`${mainStill(view, [main.x, main.y], main.half, m)}${close && detailStill(m, detail)}`}${scales}`, {
      "px-per-mm": view.scale, "mm-per-n": arrowScale,
    }),
    caption: [caption(m), real && message("drawing.realForces")].filter(Boolean).join(" "),
    pairs: names,
    ringPairs: ring?.force && (close || mesh) ? m.cranks.flatMap((_, j) => ring.pins.map((_pin, k) => `${j + 1}/${k + 1}`)) : [],
    end: m.end,
    attach(host) {
      const parts = partsOf(host, { view, close, main, detail, arrowScale });
      let shown = null;
      return {
        move(angle, pair) {
          const state = {
            m, angle,
            directions: crankDirections(m, angle),
            pins: pinCentres(m, angle),
            ...loadsAt(angle),
            real,
          };
          if (pair !== shown) {
            shown = pair;
            host.classList.toggle("choosing", pair !== null);
            for (const part of host.querySelectorAll("[data-pair]")) part.classList.toggle("selected", part.dataset.pair === pair);
          }
          placeMain(parts, state);
          placeRing(parts, state);
          if (mesh) {
            const { place, said } = meshAt(m, state, pair);
            const [x, y] = view.at(place);
            host.querySelector(".magnified").setAttribute("transform", `translate(${width / 2 - x} ${height / 2 - y})`);
            fill(parts.title, titleMarkup(said, { x: width / 2, half: width / 2 }, width));
          }
          if (!close) return;
          const ofRing = isOfRing(pair);
          parts.one.root.classList.toggle("none", ofRing);
          parts.ring.one?.root.classList.toggle("none", !ofRing);
          const said = ofRing ? placeRingDetail(parts, state, pair) : placeDetail(parts, state, pair === null ? usual : names.indexOf(pair));
          fill(parts.title, titleMarkup(said, detail, width));
        },
      };
    },
  };
}
