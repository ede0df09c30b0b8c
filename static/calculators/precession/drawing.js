/** The precessional gear: wheel and shaft in section, the shaft's deflected shape, the wheel from its end. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { html } from "../../lib/html.js";
import { message } from "../../messages/index.js";
import { arcPath, arrow, circle, createView, dimension, label, line, mm, paper, path, radius, roundBelow, scaleBar, sized, wall, WIDE_PX, words } from "../../lib/svg.js";

const MOST_ROLLERS = 200;
const LONGEST_ARROW = 62; // px
const SCALES = 24; // px at the foot, for the bars
const NAME_PX = 84; // the name of a length and its value
const MARKS = 6; // of a wall
const STRIP = 0.21; // of the height, for the deflected shape in one plane

const FIELD = {
  RC: "roller_circle_radius_mm",
  rho: "roller_radius_mm",
  theta: "nutation_angle_deg",
  low: "rollers wheel.z_min_mm",
  high: "rollers wheel.z_max_mm",
  position: "rollers wheel.position_angle_deg",
  rollers: "rollers wheel.rollers_total wheel.rollers_in_mesh",
  l: "reference_z_mm",
  a: "bearing_distance_mm",
  b: "overhang_mm",
  d: "shaft_diameter_mm shaft_sections",
};

/** Stretches of the shaft along z, mm: `[{ from, to, diameter }]`, from C to the clamp. */
export function shaftStretches(input) {
  const { shaft_diameter_mm: diameter, bearing_distance_mm: a, overhang_mm: b, reference_z_mm: start } = input;
  const sections = input.shaft_sections ?? [{ length_mm: a + b, diameter_mm: diameter }];
  let from = start;
  return sections.map(({ length_mm: length, diameter_mm: across }) => {
    const stretch = { from, to: from + length, diameter: across };
    from += length;
    return stretch;
  });
}

function bearing([x, y], half, side) {
  const [near, far] = [y - side * half, y - side * (half + 12)];
  return html`<path class="bearing" d="M${x - 6} ${near}V${far}H${x + 6}V${near}ZM${x - 6} ${near}L${x + 6} ${far}M${x - 6} ${far}L${x + 6} ${near}"/>`;
}

/** The section through axis and a roller. `x` gives the pixel of a z, for the shapes below it too. */
function sectionView(input, roller, axis, x, scale) {
  const { roller_circle_radius_mm: RC, roller_radius_mm: rho, nutation_angle_deg: theta } = input;
  const { reference_z_mm: l, bearing_distance_mm: a, overhang_mm: b } = input;
  const y = (up) => axis - up * scale;
  const stretches = shaftStretches(input);
  const widest = Math.max(...stretches.map(({ diameter }) => diameter));
  const end = l + a + b;
  const top = y(RC + rho);
  const under = y(-widest / 2) + 30;
  const crowded = Math.min(a, b) * scale < NAME_PX;
  const between = (from, to, level, symbol, value, field, beside = -12) =>
    dimension([x(from), level], [x(to), level], symbol, { value: mm(value), field, beside: from <= to ? beside : -beside });
  const extension = (at, from, to) => line([x(at), from], [x(at), to], "extension");
  const tilt = (theta * Math.PI) / 180;
  const far = Math.min((RC * 0.9) / Math.tan(tilt), end + 24 / scale);
  const reach = Math.abs(x(far) - x(0));
  return html`
    ${line([x(Math.min(0, l)) - 24, axis], [x(end) + 26, axis], "centre")}
    ${circle([x(0), axis], 3, "dot")}${label([x(0) - 10, axis - 8], "O")}
    ${path([[x(roller.z_min_mm), y(RC + rho)], [x(roller.z_max_mm), y(RC + rho)], [x(roller.z_max_mm), y(RC - rho)], [x(roller.z_min_mm), y(RC - rho)]], "body", FIELD.rollers)}
    ${line([x(roller.z_min_mm) - 12, y(RC)], [x(roller.z_max_mm) + 60, y(RC)], "centre")}
    ${[[roller.z_min_mm, 14], [roller.z_max_mm, 40]].map(([z, by]) => [extension(z, top, top - by - 4)])}
    ${extension(0, axis - 10, top - 44)}
    ${between(0, roller.z_min_mm, top - 14, "z_min", roller.z_min_mm, FIELD.low, 9)}
    ${between(0, roller.z_max_mm, top - 40, "z_max", roller.z_max_mm, FIELD.high, 9)}
    ${dimension([x(roller.z_max_mm) + 20, y(RC)], [x(roller.z_max_mm) + 20, y(RC + rho)], sized("ρ", rho)[0], { value: sized("ρ", rho)[1], field: FIELD.rho, beside: -6 })}
    ${line([x(roller.z_max_mm), y(RC + rho)], [x(roller.z_max_mm) + 26, y(RC + rho)], "extension")}
    ${stretches.map(({ from, to, diameter }) => path([[x(from), y(diameter / 2)], [x(to), y(diameter / 2)], [x(to), y(-diameter / 2)], [x(from), y(-diameter / 2)]], "body shaft-part", FIELD.d))}
    ${dimension([x(roller.z_max_mm) + 46, axis], [x(roller.z_max_mm) + 46, y(RC)], sized("R_C", RC)[0], { value: sized("R_C", RC)[1], field: FIELD.RC, beside: -6, rise: 22 })}
    ${line([x(l), axis], [x(end), axis], "centre")}
    ${line([x(0), axis], [x(far), y(Math.abs(far) * Math.tan(tilt))], "centre", FIELD.theta)}
    <g class="angle" data-field="${FIELD.theta}"><path class="arc" d="${arcPath([x(0), axis], reach, 90 - theta, 90)}"/>
      ${label([x(0) + reach + 9, axis - reach * Math.tan(tilt / 2) + 4], "θ")}</g>
    ${[1, -1].map((side) => [bearing([x(l) + 6, axis], (stretches[0].diameter / 2) * scale, side), bearing([x(l + a), axis], (widest / 2) * scale, side)])}
    ${wall([x(end), axis], (widest / 2) * scale + 14, -1, MARKS)}
    ${input.shaft_sections && stretches.map(({ from, to, diameter }) => words([x((from + to) / 2), axis + 15], `⌀ ${mm(diameter)}`, { anchor: "middle" }))}
    ${!input.shaft_sections && dimension([x(end) - 16, y(-widest / 2)], [x(end) - 16, y(widest / 2)], "d", { value: mm(widest), field: FIELD.d, beside: 6, rise: -9 })}
    ${[0, l, l + a, end].map((z) => extension(z, axis + (z === 0 ? 6 : (widest / 2) * scale), under + (z === l + a || z === end ? (crowded ? 28 : 4) : 28)))}
    ${between(l, l + a, under, "a", a, FIELD.a)}${between(l + a, end, crowded ? under + 24 : under, "b", b, FIELD.b)}
    ${between(0, l, under + 24, "l", l, FIELD.l)}
    ${label([x(l) - 8, y(widest / 2) - 8], "C")}${label([x(l + a) + 14, y(widest / 2) - 8], "B")}`;
}

/** What bends the shaft, the satellite's forces on it, and its deflected shape in one plane, under the section. */
function stripView(axis, plane, input, section, curve, x, newton, factor) {
  const { reference_z_mm: l, bearing_distance_mm: a, overhang_mm: b } = input;
  const name = plane === 0 ? "x" : "y";
  const places = { C: x(l), B: x(l + a) };
  return html`
    ${line([x(l) - 10, axis], [x(l + a + b) + 10, axis], "centre")}${wall([x(l + a + b), axis], 22, -1, MARKS)}
    ${words([x(l + a + b) + 16, axis - 22], `${name}z`)}
    ${curve && html`<path class="deflected" d="M${curve.x.map((place, i) => `${x(l + place).toFixed(2)} ${(axis - curve.y[i] * factor).toFixed(2)}`).join("L")}"/>`}
    ${Object.entries(places).map(([at, across]) => {
      const force = section[`reaction_${at}_N`][plane];
      const deflection = section[`deflection_${at}_mm`][name];
      const tip = [across, axis + force * newton];
      const side = deflection > 0 ? -1 : 1; // the label stands where the shape does not
      const reach = Math.max(0, -side * force * newton) + (at === "C" ? 20 : 0);
      return html`<g data-reaction="${at}${name}" data-length="${Math.abs(force) * newton}">${Math.abs(force) * newton > 0.5 && arrow([across, axis], tip, "force series-1")}
        ${label([across + (at === "C" ? 6 : -6), axis - side * reach + (side > 0 ? -7 : 17)], `−${at}_${name}`, { anchor: at === "C" ? "start" : "end", value: formatQuantity(-force, "N") })}</g>
        ${circle([across, axis - deflection * factor], 2.5, "dot deflected-dot")}`;
    })}`;
}

function endView(place, size, input, answer, newton) {
  const { roller_circle_radius_mm: RC, roller_radius_mm: rho } = input;
  const view = createView({ x: place.x, y: place.y, scale: size / RC });
  const centre = [place.x, place.y];
  const { lines } = answer.contact_line;
  const turned = (angle) => [-RC * Math.sin((angle * Math.PI) / 180), RC * Math.cos((angle * Math.PI) / 180)];
  const first = ((lines[0].position_angle_deg % 360) + 360) % 360;
  const forces = {
    F: answer.meshing_load?.force_N, B: answer.shaft_deflection?.reaction_B_N, C: answer.shaft_deflection?.reaction_C_N,
  };
  const half = (first * Math.PI) / 360;
  return html`
    ${line([place.x - size - 26, place.y], [place.x + size + 26, place.y], "centre")}
    ${line([place.x, place.y - size - 26], [place.x, place.y + size + 26], "centre")}
    ${label([place.x + size + 22, place.y - 6], "x")}${label([place.x + 12, place.y - size - 18], "y")}
    ${circle(centre, size, "centre", FIELD.RC)}
    ${lines.slice(0, MOST_ROLLERS).map((each) => circle(view.at(turned(each.position_angle_deg)), view.size(rho), "body", FIELD.rollers))}
    ${line(centre, view.at(turned(first)), "extent", FIELD.position)}
    <g class="angle" data-field="${FIELD.position}"><path class="arc" d="${arcPath(centre, size * 0.62, -first, 0)}"/>
      ${label([place.x - Math.sin(half) * (size + 10), place.y - Math.cos(half) * (size + 10)], "φ₁", { anchor: "end", value: formatQuantity(lines[0].position_angle_deg, "°") })}</g>
    ${radius(centre, size, 142, "R_C", { of: RC, field: FIELD.RC, lead: 12 })}
    ${Object.entries(forces).map(([name, force], i) => {
      if (!force) return "";
      const tip = [place.x + force[0] * newton, place.y - force[1] * newton];
      const length = Math.hypot(...force.slice(0, 2)) * newton;
      if (length < 8) return "";
      return html`${arrow(centre, tip, `force series-${i === 0 ? 2 : 1}`)}${label([tip[0] + (tip[0] < place.x ? -12 : 12), tip[1] + 4], name)}`;
    })}`;
}

const ROOMY_PX = 760;

/** Null until there are contact lines. */
export function createDrawing({ input, answer, curves, width, height }) {
  if (!answer.contact_line) return null;
  const { roller_circle_radius_mm: RC, roller_radius_mm: rho } = input;
  const { reference_z_mm: l, bearing_distance_mm: a, overhang_mm: b } = input;
  const section = answer.shaft_deflection;
  const [roller] = answer.contact_line.lines;
  const wide = width >= WIDE_PX;
  const column = wide ? width * 0.6 : width;
  const tall = wide ? height - SCALES : height * 0.68;
  const strips = STRIP * tall;
  const upper = tall - 2 * strips;
  const widest = Math.max(...shaftStretches(input).map(({ diameter }) => diameter));
  const [z0, z1] = [Math.min(0, l, roller.z_min_mm), Math.max(l + a + b, roller.z_max_mm)];
  const aside = wide && width < ROOMY_PX ? 22 : 0; // for the dimension to the right of the wheel
  const ending = (wide ? Math.min(width - column, height) : Math.min(width, height - tall)) / 2 - 46 - aside;
  const scale = Math.min((column - 100) / (z1 - z0), (upper - 136) / (RC + rho + widest / 2), ending / RC);
  const left = (column - scale * (z1 - z0)) / 2 - 8;
  const x = (z) => Number((left + (z - z0) * scale).toFixed(2));
  const axis = 66 + (RC + rho) * scale;
  const deflections = curves.filter(({ yaxis }) => yaxis === "y3");
  const most = section ? Math.max(...["B", "C"].map((at) => section[`deflection_${at}_mm`].total)) : 0;
  const factor = most > 0 ? (strips * 0.3) / most : 0; // px a mm of deflection
  const largest = Math.max(0, Math.hypot(...(answer.meshing_load?.force_N ?? [])), ...(section ? ["B", "C"].map((at) => Math.hypot(...section[`reaction_${at}_N`])) : []));
  const newton = largest > 0 ? Math.min(LONGEST_ARROW, strips * 0.36) / largest : 0;
  const end = wide
    ? { x: column + (width - column) / 2 - aside, y: height / 2 }
    : { x: width / 2, y: tall + (height - tall) / 2 - 6 };
  const round = largest > 0 && roundBelow(largest, "N");
  const bar = roundBelow(RC, "mm");
  return {
    markup: paper(width, height, html`
      ${sectionView(input, roller, axis, x, scale)}
      ${section && [1, 0].map((plane, i) => stripView(upper + (i + 0.5) * strips, plane, input, section, deflections[plane], x, newton, factor))}
      ${endView(end, RC * scale, input, answer, newton)}
      ${scaleBar([12, height - 12], bar * scale, mm(bar))}
      ${round && scaleBar([bar * scale + 100, height - 12], round * newton, formatQuantity(round, "N", 3), "force")}`, {
      "px-per-mm": scale, "px-per-n": newton, "px-per-deflection": factor,
    }),
    caption: section
      ? message("drawing.shaftCaption", { times: formatNumber(factor / scale, 2) })
      : message("drawing.toScale"),
  };
}
