/** One swinging roller with its lengths, and the row of rollers with their forces. */
import { formatQuantity } from "../format.js";
import { message } from "../messages/index.js";
import { arrowPath, canvas, circle, dimension, label, line, svg } from "./svg.js";

const MOST_ROLLERS = 60;

/** Outline of a sphere cut to its width: arcs above and below, straight at the sides. */
function slice(x, width, diameter) {
  const half = Math.min(width, diameter) / 2;
  const cut = Math.sqrt(Math.max(0, (diameter / 2) ** 2 - half ** 2));
  const r = diameter / 2;
  return `M${x - half} ${-cut}A${r} ${r} 0 0 1 ${x + half} ${-cut}L${x + half} ${cut}A${r} ${r} 0 0 1 ${x - half} ${cut}Z`;
}

function rollerView(input, section) {
  const { cylinder_length_mm: l, sphere_width_mm: b, sphere_diameter_mm: D, diameter_mm: d } = input;
  const reach = l + 1.5 * b;
  const tall = Math.max(D, d) / 2;
  const size = Math.max(reach, tall) * 0.075;
  const force = tall + 2.2 * size;
  const view = canvas({
    left: -reach - 2 * size, right: reach + 3 * size, bottom: -force - 2.2 * size, top: force + 2.2 * size, name: message("drawing.roller"),
  });
  view.append(
    svg("path", { class: "body", d: `M${-l - b / 2} ${-d / 2}H${l + b / 2}V${d / 2}H${-l - b / 2}Z` }),
    ...[-l - b, 0, l + b].map((x) => svg("path", { class: "body", d: slice(x, b, D) })),
    line([-reach - size, 0], [reach + size, 0], "centre"),
    dimension({ from: [b / 2, -tall - size], to: [b / 2 + l, -tall - size], symbol: "l", size, path: "cylinder_length_mm", aside: [0, -size * 0.8] }),
    dimension({ from: [-b / 2, -tall - size], to: [b / 2, -tall - size], symbol: "b", size, path: "sphere_width_mm", aside: [0, -size * 0.8] }),
    dimension({ from: [-l / 2 - b / 2, -d / 2], to: [-l / 2 - b / 2, d / 2], symbol: "d", size, path: "diameter_mm", aside: [size * 0.6, 0] }),
    dimension({ from: [reach + size, -D / 2], to: [reach + size, D / 2], symbol: "D", size, path: "sphere_diameter_mm", aside: [size * 0.8, 0] }),
  );
  if (section) {
    const up = (x, from, to) => svg("path", { class: "force series-0", d: arrowPath([x, from], [x, to], size * 0.6) });
    view.append(
      up(-l - b, -force - size, -D / 2), up(l + b, -force - size, -D / 2),
      svg("path", { class: "force series-1", d: arrowPath([0, force + size], [0, D / 2], size * 0.6) }),
      label([-l - b + size * 1.2, -force], "F_1", size), label([size * 1.2, force], "F_0", size),
    );
  }
  return view;
}

function rowView(input, { forces_N: forces, max_force_N: most }) {
  const radius = input.hole_circle_radius_mm;
  const d = input.diameter_mm;
  const longest = 0.55 * radius;
  const view = 1.1 * (radius + longest * 0.6) + d;
  const size = view * 0.075;
  const nodes = forces.flatMap((force, i) => {
    const angle = (2 * Math.PI * i) / forces.length;
    const place = [radius * Math.sin(angle), radius * Math.cos(angle)];
    const along = [Math.cos(angle), -Math.sin(angle)];
    const reach = (longest * force) / most;
    const to = [place[0] + reach * along[0], place[1] + reach * along[1]];
    const arrow = svg("path", {
      class: `force ${force === most ? "series-1" : "series-0"}`, "data-roller": i + 1, d: arrowPath(place, to, size * 0.6),
    });
    arrow.dataset.length = reach;
    return [circle(place, d / 2, force > 0 ? "body" : "body idle"), arrow];
  });
  const drawing = canvas({ left: -view, right: view, bottom: -view, top: view, name: message("drawing.row") });
  drawing.append(
    circle([0, 0], radius, "centre"), ...nodes,
    dimension({ from: [0, 0], to: [-0.7 * radius, 0.71414 * radius], symbol: "R", size, oneHead: true, path: "hole_circle_radius_mm", aside: [size * 0.7, size * 0.7] }),
  );
  return { drawing, caption: message("drawing.scale", { length: formatQuantity(longest, "mm", 3), force: formatQuantity(most, "N", 4) }) };
}

export function createDrawing({ input, answer }) {
  const section = answer.roller_strength;
  if (!section || section.forces_N.length > MOST_ROLLERS) return { nodes: [rollerView(input, section)], caption: "" };
  const { drawing, caption } = rowView(input, section);
  return { nodes: [rollerView(input, section), drawing], caption };
}
