/** A small picture of a reducer, of its inputs alone: ring, discs and pins to scale, at the crank angle 0. */
import { html } from "../../lib/html.js";
import { circle, createView, paper } from "../../lib/svg.js";
import { evenly, mechanismOf, pitchRadii } from "./mechanism.js";
import { bodyOf, discStill, ringStill } from "./ring.js";

const SIZE = 128; // px
const POINTS = 24; // of a lobe
const UNSOLVED = { cyclogram: { driving_count: [{ to_deg: 360 }], period_deg: 360, pairs: [] } };
const USUAL = { satellites: 2, initial_crank_angle_deg: 0 };

/** One lobe of a disc without modification, and how far the discs have turned: the pins' path about a disc, less their radius. */
function lobesOf({ ring: { circle: R, radius, lobes }, eccentricity: e, cranks, start }) {
  const lobe = Array.from({ length: POINTS }, (_, i) => {
    const [t, n] = [(2 * Math.PI * i) / (POINTS * lobes), lobes + 1];
    const [across, up] = [R * Math.cos(t) - e * n * Math.cos(n * t), -R * Math.sin(t) + e * n * Math.sin(n * t)];
    const inwards = radius / Math.hypot(across, up);
    return [R * Math.sin(t) - e * Math.sin(n * t) + up * inwards, R * Math.cos(t) - e * Math.cos(n * t) - across * inwards];
  });
  return { lobe, turns: cranks.map((crank) => (crank + start) / lobes) };
}

export function pictureOf({ mechanism, contact, ...parts }) {
  const { pin_radius_mm: pin, eccentricity_mm: offset, hole_radius_mm: hole = pin + offset } = contact; // a fit says no hole
  const m = mechanismOf({ mechanism: { ...USUAL, ...mechanism }, contact: { ...contact, hole_radius_mm: hole }, ...parts }, UNSOLVED);
  const { eccentricity: e, radius, holeRadius, pinRadius, pins, ring } = m;
  const pitch = pitchRadii(m);
  const body = Math.max(pitch.ring, radius + holeRadius + e) * 1.08;
  const view = createView({ x: SIZE / 2, y: SIZE / 2, scale: (SIZE / 2 - 2) / (ring ? bodyOf(ring).outside : body) });
  const centre = view.at([0, 0]);
  if (ring) Object.assign(m.ring, lobesOf(m));
  const around = (size, kind) => evenly(pins, radius).map((place) => circle(view.at(place), view.size(size), kind));
  const discs = m.cranks.map((crank, j) => {
    const turned = ((crank + m.start) * Math.PI) / 180;
    return html`<g class="series-${(j % 6) + 1}" transform="translate(${view.size(e * Math.sin(turned))} ${-view.size(e * Math.cos(turned))})">
      ${ring ? discStill(view, m, j) : circle(centre, view.size(Math.max(pitch.satellite, radius + holeRadius * 1.3)), "profile")}${around(holeRadius, "hole")}</g>`;
  });
  return html`<span class="drawing picture">${paper(SIZE, SIZE, html`
    ${ring ? ringStill(view, centre, m) : html`${circle(centre, view.size(body), "ring")}${circle(centre, view.size(body / 1.04), "bore")}`}
    ${discs}${around(pinRadius, "pin")}`)}</span>`;
}
