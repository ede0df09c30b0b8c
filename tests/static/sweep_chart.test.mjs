import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { formatNumber } from "../../static/lib/format.js";
import { GOVERNING, pointsOf } from "../../static/lib/sweep.js";
import { isMap, sweepChart } from "../../static/lib/sweep_chart.js";
import { setUnits } from "../../static/lib/units.js";
import "./service.mjs";

afterEach(() => setUnits("metric"));

const FIELDS = [{ title: "Pin radius", unit: "mm" }, { title: "Pins", unit: "" }];
const USED = { title: "Governing check", pointer: GOVERNING, percent: true, unit: "%" };
/** Three radii over two numbers of pins: the pressure decides but at the last radius, where a wall fails; one cannot be. */
const ANSWER = {
  axes: [{ pointer: "/contact/pin_radius_mm", values: [4, 6, 10] }, { pointer: "/mechanism/pins", values: [3, 4] }],
  outputs: { [GOVERNING]: [1.5, 1.2, 0.5, 0.4, 1.25, null] },
  status: ["fail", "marginal", "pass", "incomplete", "fail", "impossible"],
  codes: ["contact_pressure_hole", "wall_holes"], governing: [0, 0, 0, 0, 1, -1],
  reasons: [{ code: "larger_than", pointer: "/contact/pin_radius_mm", points: [5] }],
};
const POINTS = pointsOf(ANSWER, USED, new Map([["pin_radius_mm", "Pin radius"]]));
const mapped = (now = [6, 3], theme = "light") => sweepChart(POINTS, FIELDS, USED, now, theme);
const traces = (chart) => new Map(chart.data.map((trace) => [trace.name, trace]));

test("the check that governs over two fields is a map, anything else lines", () => {
  assert.ok(isMap(FIELDS, USED));
  for (const [fields, quantity] of [[FIELDS.slice(0, 1), USED], [FIELDS, { ...USED, pointer: "/hertz/max_pressure_MPa" }]]) {
    assert.ok(!isMap(fields, quantity));
    assert.ok(sweepChart(POINTS, fields, quantity, [6, 3], "light").data.every(({ type }) => type === "scatter"));
  }
});

test("cells meet half way between the values of both fields and carry their points", () => {
  const [pressure] = mapped().data;
  assert.equal(pressure.name, "Contact pressure of the hole");
  assert.deepEqual(pressure.customdata, [0, 1, 2, 3]);
  const reach = pressure.x.map((x, i) => [x - pressure.width[i] / 2, x + pressure.width[i] / 2]);
  assert.deepEqual(reach, [[3, 5], [3, 5], [5, 8], [5, 8]]);
  assert.deepEqual(pressure.base.map((from, i) => [from, from + pressure.y[i]]), [[2.5, 3.5], [3.5, 4.5], [2.5, 3.5], [3.5, 4.5]]);
  const { xaxis, yaxis } = mapped().layout;
  assert.deepEqual([xaxis.range, yaxis.range], [[3, 12], [2.5, 4.5]]);
});

test("a cell's colour is its check, its depth and text what is used; hatches tell what does not work", () => {
  const all = traces(mapped());
  const [pressure, wall] = ["Contact pressure of the hole", "Wall between holes"].map((name) => all.get(name));
  assert.notEqual(pressure.marker.color, wall.marker.color);
  const [full, over, half, less] = pressure.marker.opacity;
  assert.ok(full === over && over > half && half > less);
  assert.deepEqual(pressure.text, ["", "", "50", "40"]); // the text of the others stands over their hatch
  const hatches = ["Just works", "Fails", "Impossible"].map((name) => all.get(name));
  assert.deepEqual(hatches.map(({ customdata }) => customdata), [[1], [0, 4], [5]]);
  assert.deepEqual(hatches.map(({ text }) => text), [["120"], ["150", "125"], [""]]);
  assert.equal(new Set(hatches.map(({ marker }) => marker.pattern.shape)).size, 3);
  assert.equal(all.get("Fails").hovertext[1], "10\u00a0mm, 3: 125\u00a0%<br>Fails: Wall between holes");
  assert.equal(all.get("Impossible").hovertext[0], "10\u00a0mm, 4: –<br>Impossible: Pin radius");
});

test("the line is where all of the limit is used, between points that have a number", () => {
  const { x, y } = traces(mapped()).get("100 % of the limit");
  const pieces = x.flatMap((_, i) => (x[i] === null ? [] : [[x[i], y[i]]]));
  const used = ([at, pins]) => { // on the edges and the diagonal of the triangles that the points make
    if (at <= 6 && pins === 3) return 150 - 50 * (at - 4);
    if (at <= 6 && pins === 4) return 120 - 40 * (at - 4);
    if (at <= 6) return 120 + ((50 - 120) * (at - 4)) / 2;
    return pins === 3 ? 50 + (75 * (at - 6)) / 4 : 40 + (85 * (at - 6)) / 4;
  };
  for (const piece of pieces) assert.ok(Math.abs(used(piece) - 100) < 1e-9, formatNumber(used(piece)));
  assert.deepEqual([...new Set(pieces.filter(([, pins]) => pins === 3).map(([at]) => at))], [5, 6 + 8 / 3]);
  assert.deepEqual(x.map((one) => one === null), [false, false, true, false, false, true, false, false, true]); // three triangles
});

test("the cell of the design at hand is framed and its number stays, and none where it lies elsewhere", () => {
  for (const now of [[6, 3], [5.2, 3.4]]) {
    const { x, width, base, y, text, customdata } = traces(mapped(now)).get("Design at hand");
    assert.deepEqual([x, width, base, y, text, customdata], [[6.5], [3], [2.5], [1], [""], [2]]);
  }
  for (const now of [[13, 3], [6, 5], [undefined, 3]]) assert.equal(traces(mapped(now)).get("Design at hand"), undefined);
});

test("lines tell in the legend what a dot and a cross mean", () => {
  const legend = (points) => sweepChart(points, FIELDS.slice(0, 1), USED, [6], "light").data.filter(({ x }) => x[0] === null).map(({ name, marker }) => [name, marker.symbol]);
  assert.deepEqual(legend(POINTS), [["met", "circle"], ["not met", "x"]]);
  assert.deepEqual(legend(POINTS.filter(({ status }) => status !== "fail")), []);
});

test("cells, line and frame change their units together", () => {
  setUnits("us");
  const chart = mapped();
  const [frame, cells, line] = ["Design at hand", "Contact pressure of the hole", "100 % of the limit"].map((name) => traces(chart).get(name));
  const inches = (numbers) => numbers.map((one) => Math.round(one * 25.4e6) / 1e6);
  assert.deepEqual(inches(frame.x), [6.5]);
  assert.deepEqual(inches(cells.x), [4, 4, 6.5, 6.5]);
  assert.ok(inches(line.x.filter((one) => one !== null)).includes(5));
  assert.match(chart.layout.xaxis.title.text, /in$/);
});

test("both themes tell checks apart", () => {
  for (const theme of ["light", "dark"]) {
    const colours = mapped(undefined, theme).data.slice(0, 2).map(({ marker }) => marker.color);
    assert.equal(new Set(colours).size, 2);
  }
});
