/** The shaft of the precessional gear with its supports, reactions and deflected shape, both planes. */
import { formatQuantity } from "../format.js";
import { message } from "../messages/index.js";
import { arrowPath, canvas, dimension, label, line, svg } from "./svg.js";

function sectionsOf({ shaft_sections: sections, shaft_diameter_mm: diameter, bearing_distance_mm: a, overhang_mm: b }) {
  return sections ?? [{ length_mm: a + b, diameter_mm: diameter }];
}

function planeView(input, section, curve, plane) {
  const { bearing_distance_mm: a, overhang_mm: b } = input;
  const total = a + b;
  const sections = sectionsOf(input);
  const widest = Math.max(...sections.map(({ diameter_mm: diameter }) => diameter));
  const size = total * 0.05;
  const tall = Math.max(widest / 2, size) + 3.2 * size;
  const axis = plane === 0 ? "x" : "y";
  const view = canvas({
    left: -2.5 * size, right: total + 2 * size, bottom: -tall - 1.5 * size, top: tall, name: message("drawing.shaft", { axis }),
  });
  let from = 0;
  for (const { length_mm: length, diameter_mm: diameter } of sections) {
    view.append(svg("path", { class: "body", d: `M${from} ${-diameter / 2}H${from + length}V${diameter / 2}H${from}Z` }));
    from += length;
  }
  const clamp = Array.from({ length: 5 }, (_, i) => {
    const y = -tall / 2 + (i * tall) / 4;
    return line([total, y], [total + size, y + size], "clamp");
  });
  view.append(...clamp, line([total, -tall / 2], [total, tall / 2 + size], "clamp"), line([-size, 0], [total, 0], "centre"));
  const reactions = { C: [0, section.reaction_C_N[plane]], B: [a, section.reaction_B_N[plane]] };
  const most = Math.max(...["B", "C"].flatMap((at) => section[`reaction_${at}_N`].map(Math.abs)), Number.MIN_VALUE);
  for (const [name, [x, force]] of Object.entries(reactions)) {
    const reach = (2.6 * size * force) / most;
    const foot = -Math.sign(force || 1) * (widest / 2);
    const arrow = svg("path", { class: "force series-0", d: arrowPath([x, foot - reach], [x, foot], size * 0.6), "data-reaction": name });
    arrow.dataset.length = Math.abs(reach);
    view.append(arrow, label([x + 1.2 * size, foot - reach - 0.7 * Math.sign(force || 1) * size], `${name}_${axis}`, size));
  }
  if (curve) {
    const largest = Math.max(...curve.y.map(Math.abs), Number.MIN_VALUE);
    const factor = (1.6 * size) / largest;
    const points = curve.x.map((x, i) => `${x} ${-curve.y[i] * factor}`);
    view.append(svg("path", { class: "deflected", d: `M${points.join("L")}` }));
    view.append(label([total / 2, tall - size * 0.8], message("drawing.deflection", { axis, largest: formatQuantity(largest, "mm", 3) }), size * 0.9, "label caption"));
  }
  view.append(
    dimension({ from: [0, -tall], to: [a, -tall], symbol: "a", size, path: "bearing_distance_mm", aside: [0, -size * 0.8] }),
    dimension({ from: [a, -tall], to: [total, -tall], symbol: "b", size, path: "overhang_mm", aside: [0, -size * 0.8] }),
    dimension({ from: [size * 0.8, -sections[0].diameter_mm / 2], to: [size * 0.8, sections[0].diameter_mm / 2], symbol: "d", size, path: "shaft_diameter_mm", aside: [size * 0.7, 0] }),
  );
  return view;
}

/** Null until the shaft is computed. */
export function createDrawing({ input, answer, curves }) {
  const section = answer.shaft_deflection;
  if (!section) return null;
  const deflections = curves.filter(({ yaxis }) => yaxis === "y3");
  return {
    nodes: [0, 1].map((plane) => planeView(input, section, deflections[plane], plane)),
    caption: message("drawing.shaftScale"),
  };
}
