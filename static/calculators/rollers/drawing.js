/** One swinging roller to scale with its lengths and forces, and the circle of rollers with their forces. */
import { formatQuantity } from "../../lib/format.js";
import { html } from "../../lib/html.js";
import { message } from "../../messages/index.js";
import { arrow, circle, createView, dimension, label, line, mm, paper, path, radius, roundBelow, scaleBar, WIDE_PX, words } from "../../lib/svg.js";

const MOST_ROLLERS = 60;
const MOST_NAMED = 12; // rollers whose force is written beside them
const ARC_POINTS = 12;

/** Outline of a spherical part of a width, cut from a sphere: half of it above the axis, mm. */
export function sphereOutline(middle, width, diameter) {
  const half = Math.min(width, diameter) / 2;
  const over = Array.from({ length: ARC_POINTS + 1 }, (_, i) => {
    const x = -half + (2 * half * i) / ARC_POINTS;
    return [middle + x, Math.sqrt(Math.max(0, (diameter / 2) ** 2 - x * x))];
  });
  return [...over, ...over.map(([x, y]) => [x, -y]).reverse()];
}

function rollerView(place, input, section, newton) {
  const { cylinder_length_mm: l, sphere_width_mm: b, sphere_diameter_mm: D, diameter_mm: d } = input;
  const reach = l + 1.5 * b; // from the middle to an end
  const tall = Math.max(D, d) / 2;
  const view = createView({
    x: place.x - 44, y: place.y,
    scale: Math.min((place.width / 2 - 76) / reach, (place.height / 2 - 100) / tall),
  });
  const at = (x, y) => view.at([x, y]);
  const below = view.size(tall) + 24;
  const level = (x, tier) => [at(x, 0)[0], at(0, 0)[1] + below + 26 * tier];
  const dim = (from, to, tier, symbol, value, field) =>
    dimension(level(from, tier), level(to, tier), symbol, { value: mm(value), field, beside: -13 });
  const right = [l + 1.5 * b, l + 1.5 * b];
  const end = l + b;
  const { max_force_N: F1, centre_force_N: F0 } = section ?? {};
  const push = (x, force, side, name, said = true) => {
    const tip = at(x, (side * D) / 2);
    const tail = [tip[0], tip[1] - side * force * newton];
    return html`${arrow(tail, tip, `force ${side > 0 ? "series-2" : "series-1"}`)}
      ${label([tip[0] + 8, (side > 0 ? tail[1] + 10 : tail[1] - 2)], name, { anchor: "start", value: said && formatQuantity(force, "N") })}`;
  };
  return html`
    ${path([at(-end, d / 2), at(end, d / 2), at(end, -d / 2), at(-end, -d / 2)], "body", "diameter_mm cylinder_length_mm")}
    ${[-end, 0, end].map((x) => path(sphereOutline(x, b, D).map((point) => view.at(point)), "body", "sphere_diameter_mm sphere_width_mm"))}
    ${line([at(-reach, 0)[0] - 14, place.y], [at(reach, 0)[0] + 14, place.y], "centre")}
    ${[[-b / 2, 1], [b / 2, 1], [l + b / 2, 0]].map(([x, tier]) => line(at(x, -tall), [level(x, tier)[0], level(x, tier)[1] + 4], "extension"))}
    ${dim(b / 2, b / 2 + l, 0, "l", l, "cylinder_length_mm")}
    ${dim(-b / 2, b / 2, 1, "b", b, "sphere_width_mm")}
    ${dimension(at(-l / 2 - b / 2, -d / 2), at(-l / 2 - b / 2, d / 2), "d", { value: mm(d), field: "diameter_mm", beside: -6, rise: 10 })}
    ${dimension(at(right[0], -D / 2), at(right[1], D / 2), "D", { value: mm(D), field: "sphere_diameter_mm", offset: -18, beside: -6, rise: 10 })}
    ${section && [push(-end, F1, -1, "F_1", false), push(end, F1, -1, "F_1"), push(0, F0, 1, "F_0")]}`;
}

/** A roller's place on its circle, from upright, clockwise, and the way its force points there. */
export function rollerPlace(index, count, length) {
  const angle = (2 * Math.PI * index) / count;
  return { place: [length * Math.sin(angle), length * Math.cos(angle)], along: [Math.cos(angle), -Math.sin(angle)] };
}

function circleView(place, input, { forces_N: forces, max_force_N: most }, size, newton) {
  const R = input.hole_circle_radius_mm;
  const view = createView({ x: place.x, y: place.y, scale: size / R });
  const centre = [place.x, place.y];
  const rollers = forces.map((force, i) => {
    const { place: middle, along } = rollerPlace(i, forces.length, R);
    const from = view.at(middle);
    const to = [from[0] + along[0] * force * newton, from[1] - along[1] * force * newton];
    const named = forces.length <= MOST_NAMED;
    const beside = view.size(input.diameter_mm / 2) + 12;
    const [x, y] = [from[0] + (middle[0] / R) * (beside - 6), from[1] - (middle[1] / R) * beside + 4];
    const anchor = Math.abs(middle[0]) < R / 4 ? "middle" : middle[0] > 0 ? "start" : "end";
    return html`${circle(from, view.size(input.diameter_mm / 2), force > 0 ? "body" : "body idle", "rollers")}
      ${force > 0 && html`<g data-roller="${i + 1}" data-length="${force * newton}">${arrow(from, to, `force ${force === most ? "series-2" : "series-1"}`)}</g>`}
      ${named && words([x, y], formatQuantity(force, "N"), { anchor })}`;
  });
  return html`
    ${line([place.x - size - 34, place.y], [place.x + size + 34, place.y], "centre")}
    ${line([place.x, place.y - size - 34], [place.x, place.y + size + 34], "centre")}
    ${circle(centre, size, "centre", "hole_circle_radius_mm")}${rollers}
    ${radius(centre, size, -180 / forces.length, "R", { of: R, field: "hole_circle_radius_mm", lead: 10 })}`;
}

export function createDrawing({ input, answer, width, height }) {
  const section = answer.roller_strength;
  const wide = width >= WIDE_PX;
  const rowed = section && section.forces_N.length <= MOST_ROLLERS;
  const share = wide ? 0.56 : 0.48;
  const first = wide
    ? { x: (width * share) / 2, y: height / 2, width: width * share, height }
    : { x: width / 2, y: (height * share) / 2, width, height: height * share };
  const second = wide
    ? { x: width * (1 + share) / 2, y: height / 2 }
    : { x: width / 2, y: (height * (1 + share)) / 2 - 8 };
  const size = (wide ? Math.min(width * (1 - share) - 20, height) : Math.min(width, height * (1 - share))) / 2 - (wide ? 84 : 76);
  const newton = section ? Math.min(0.55 * size, first.height / 10) / section.max_force_N : 0; // px
  const round = section && roundBelow(section.max_force_N, "N");
  return {
    markup: paper(width, height, html`
      ${rollerView(first, input, section, newton)}
      ${rowed && circleView(second, input, section, size, newton)}
      ${section && scaleBar([12, height - 14], round * newton, formatQuantity(round, "N", 3), "force")}`, { "px-per-n": newton }),
    caption: message("drawing.rollersCaption"),
  };
}
