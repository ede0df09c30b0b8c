/** The crank-planetary mechanism to scale: ring, satellites, holes, pins, crank; one pair enlarged. */
import { formatQuantity } from "../format.js";
import { message } from "../messages/index.js";
import { contactPoint, mechanismAt, valueAt } from "./geometry.js";
import { arrowPath, at, canvas, circle, dimension, label, line, svg } from "./svg.js";

const MOST_PAIRS = 400;
const LONGEST_ARROW = 0.45; // of the pin circle, at the peak force
const SERIES = 6; // colours of the figures

function sizes({ mechanism, load, contact }) {
  const pin = contact.pin_radius_mm;
  const eccentricity = contact.eccentricity_mm ?? contact.hole_radius_mm - pin;
  return { mechanism, pinCircle: load.pin_circle_radius_mm, eccentricity, pin, hole: contact.hole_radius_mm };
}

/** Whether a pair drives at an angle, by the phases of the cyclogram, degrees. */
function drives(phases, angle) {
  return phases.some(([from, to]) => angle >= from && angle <= to);
}

/** Views that move with the crank: `{ nodes, move(angle), select(pair) }`; null for too many pairs. */
export function createDrawing({ input, answer, curves }) {
  const scale = sizes(input);
  const { mechanism, pinCircle, pin, hole, eccentricity } = scale;
  const { pairs } = answer.cyclogram;
  if (pairs.length > MOST_PAIRS) return null;
  const peak = answer.contact_force?.peak_force_N;
  const satellite = pinCircle + 1.7 * hole;
  const ring = satellite + Math.abs(eccentricity);
  const view = 1.06 * ring;
  const size = view * 0.075;
  const force = new Map(curves.map((curve) => [curve.name, curve]));

  const whole = canvas({ left: -view, right: view, bottom: -view, top: view, name: message("drawing.mechanism") });
  const satellites = svg("g");
  const output = svg("g");
  const arrows = svg("g");
  whole.append(
    circle([0, 0], ring, "ring"),
    line([-view, 0], [view, 0], "centre"), line([0, -view], [0, view], "centre"),
    satellites, circle([0, 0], pinCircle, "centre"), output, arrows,
  );
  const bodies = answer.cyclogram.pairs.reduce((all, { satellite: j }) => Math.max(all, j), 0);
  const outlines = Array.from({ length: bodies }, (_, j) => {
    const group = svg("g", { class: `satellite series-${j % SERIES}` });
    group.append(circle([0, 0], satellite, "outline"), circle([0, 0], satellite * 0.22, "outline"));
    satellites.append(group);
    return group;
  });
  const parts = pairs.map(({ satellite: j, pin: n, driving_deg: phases }) => {
    const bore = circle([0, 0], hole, "bore");
    outlines[j - 1].append(bore);
    const arrow = svg("path", { class: `force series-${(j - 1) % SERIES}`, "data-pair": `${j}.${n}` });
    arrows.append(arrow);
    return { name: `${j}.${n}`, j: j - 1, n: n - 1, phases, bore, arrow };
  });
  const pins = Array.from({ length: mechanism.pins }, (_, n) => {
    const group = svg("g", { class: "pin" }, circle([0, 0], pin, "body"), label([0, 0], String(n + 1), Math.min(size, pin), "label number"));
    output.append(group);
    return group;
  });
  const crank = svg("path", { class: "crank" });
  const circleLabel = dimension({
    from: [0, 0], to: [0.7 * pinCircle, 0.71414 * pinCircle], symbol: "R", size, oneHead: true,
    path: "load.pin_circle_radius_mm", aside: [0, size * 0.7],
  });
  whole.append(crank, circleLabel);

  const near = 1.7 * hole;
  const small = near * 0.1;
  const detail = canvas({ left: -near, right: near, bottom: -near, top: near, name: message("drawing.pair") });
  const closeUp = svg("g");
  detail.append(closeUp);

  let selected = null;
  let shown = 0;

  function forceOf(name) {
    const curve = force.get(name);
    return curve ? valueAt(curve, shown) : undefined;
  }

  function drawPair({ pins: places, satellites: cranks }) {
    const candidates = parts.filter(({ name, phases }) => (selected ? name === selected : drives(phases, shown)));
    const most = candidates.reduce((best, part) => ((forceOf(part.name) ?? 0) > (forceOf(best?.name) ?? -1) ? part : best), null)
      ?? parts[0];
    const { direction } = cranks[most.j];
    const middle = [eccentricity * direction[0], eccentricity * direction[1]];
    const touch = contactPoint([0, 0], direction, pin);
    const along = ([x, y], by) => [x + by * direction[0], y + by * direction[1]];
    const across = [direction[1], -direction[0]];
    const value = forceOf(most.name);
    const tail = value && peak ? along(touch, (-0.8 * hole * value) / peak) : touch;
    const caption = message("drawing.pairForce", {
      satellite: most.j + 1, pin: most.n + 1, force: value === undefined ? "–" : formatQuantity(value, "N", 4),
    });
    const up = ([x, y], by) => [x + by * across[0], y + by * across[1]];
    closeUp.replaceChildren(
      svg("g", { class: `satellite series-${most.j % SERIES}` }, circle(middle, hole, "bore")),
      svg("g", { class: "pin" }, circle([0, 0], pin, "body")),
      line(along([0, 0], -1.5 * hole), along([0, 0], 1.5 * hole), "centre"),
      dimension({ from: [0, 0], to: up([0, 0], pin), symbol: "r_in", size: small, oneHead: true, path: "contact.pin_radius_mm", aside: along([0, 0], -0.7 * small) }),
      dimension({ from: middle, to: up(middle, -hole), symbol: "r_out", size: small, oneHead: true, path: "contact.hole_radius_mm", aside: along([0, 0], 0.7 * small) }),
      dimension({ from: [0, 0], to: middle, symbol: "e", size: small, oneHead: true, path: "contact.eccentricity_mm", aside: up([0, 0], 0.8 * small) }),
      circle(touch, near * 0.018, "touch"),
      svg("path", { class: `force series-${most.j % SERIES}`, d: arrowPath(tail, touch, small) }),
      label([0, -near + small], caption, small, "label caption"),
    );
    return places;
  }

  function move(angle) {
    shown = angle;
    const state = mechanismAt(scale, angle);
    const turn = (-state.turned * 180) / Math.PI;
    state.satellites.forEach(({ centre }, j) => outlines[j].setAttribute("transform", `translate(${at(centre)})`));
    state.pins.forEach((place, n) => pins[n].setAttribute("transform", `translate(${at(place)})`));
    crank.setAttribute("d", state.satellites.map(({ centre }) => `M0 0L${at(centre)}`).join(""));
    whole.dataset.turned = String(turn);
    for (const { name, j, n, phases, bore, arrow } of parts) {
      const { direction } = state.satellites[j];
      const place = state.pins[n];
      bore.setAttribute("cx", place[0]);
      bore.setAttribute("cy", -place[1]);
      const driving = drives(phases, angle);
      bore.classList.toggle("driving", driving);
      bore.classList.toggle("selected", name === selected);
      const value = driving ? forceOf(name) : 0;
      const length = value && peak ? (LONGEST_ARROW * pinCircle * value) / peak : 0;
      const touch = contactPoint(place, direction, pin);
      arrow.setAttribute("d", arrowPath([touch[0] - length * direction[0], touch[1] - length * direction[1]], touch, size * 0.6));
      arrow.dataset.length = length;
      arrow.classList.toggle("selected", name === selected);
    }
    drawPair(state);
  }

  return {
    nodes: [whole, detail],
    caption: peak ? message("drawing.scale", {
      length: formatQuantity(LONGEST_ARROW * pinCircle, "mm", 3), force: formatQuantity(peak, "N", 4),
    }) : "",
    pairs: parts.map(({ name }) => name),
    move,
    select(pair) {
      selected = pair;
      move(shown);
    },
  };
}
