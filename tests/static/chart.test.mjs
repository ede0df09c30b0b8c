import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { curveTables, inShownUnits, overlaid, inLanguage } from "../../static/lib/chart.js";
import { setUnits } from "../../static/lib/units.js";

afterEach(() => setUnits("metric"));

const CHART = {
  data: [
    { name: "a", mode: "lines", x: [0, 10], y: [0, 25.4], line: { color: "red" }, hovertemplate: "%{y:.3g} mm at %{x}°" },
    { name: "b", mode: "lines", x: [0, 10], y: [0, 50.8], line: { color: "blue" } },
    { name: "χ = 25.4 mm", mode: "markers", x: [5], y: [4.4482216152605], yaxis: "y2" },
  ],
  layout: {
    xaxis: { title: { text: "Crank angle, °" }, range: [0, 10] },
    yaxis: { title: { text: "Place, mm" }, range: [0, 254] },
    yaxis2: { title: { text: "Force, N" } },
    shapes: [{ xref: "x", yref: "y", x0: 1, x1: 1, y0: 0, y1: 25.4 }, { xref: "x", yref: "paper", x0: 2, x1: 2, y0: 0, y1: 1 }],
    annotations: [{ text: "508 mm", xref: "x", yref: "y", x: 1, y: 508 }],
  },
};

test("in metric units a figure is left as it is", () => {
  assert.equal(inShownUnits(CHART), CHART);
});

test("data, ranges, marks and words change their units together", () => {
  setUnits("us");
  const { data, layout } = inShownUnits(CHART);
  assert.deepEqual(data[0].y, [0, 1]);
  assert.deepEqual(data[0].x, [0, 10]);
  assert.equal(data[0].hovertemplate, "%{y:.3g} in at %{x}°");
  assert.equal(data[2].name, "χ = 1 in");
  assert.deepEqual(data[2].y, [1]);
  assert.equal(layout.yaxis.title.text, "Place, in");
  assert.equal(layout.yaxis2.title.text, "Force, lbf");
  assert.deepEqual(layout.yaxis.range, [0, 10]);
  assert.deepEqual(layout.xaxis.range, [0, 10]);
  assert.equal(layout.shapes[0].y1, 1);
  assert.equal(layout.shapes[1].y1, 1); // a share of the paper, no length
  assert.equal(layout.annotations[0].text, "20 in");
  assert.equal(layout.annotations[0].y, 20);
});

test("curves become tables: one for each set of places, with canonical units", () => {
  const [lines, mark] = curveTables(CHART);
  assert.deepEqual(lines, {
    title: "Place",
    columns: [{ title: "Crank angle", unit: "°" }, { title: "a", unit: "mm" }, { title: "b", unit: "mm" }],
    rows: [[0, 0, 0], [10, 25.4, 50.8]],
  });
  assert.deepEqual(mark.rows, [[5, 4.4482216152605]]);
  assert.equal(mark.columns[1].unit, "N");
});

test("curves that share no places become one long table", () => {
  const data = ["a", "b", "c", "d"].map((name, i) => ({ name, x: [i, i + 1], y: [1, 2] }));
  const [table, ...rest] = curveTables({ data, layout: CHART.layout });
  assert.equal(rest.length, 0);
  assert.equal(table.rows.length, 8);
  assert.deepEqual(table.rows[2], ["b", 1, 1]);
});

test("other designs lie dashed over the curves, each named once", () => {
  const { data } = overlaid(CHART, [{ name: "A", chart: CHART }]);
  assert.equal(data.length, 5);
  assert.deepEqual(data.slice(3).map(({ name, showlegend }) => [name, showlegend]), [["A", true], ["A", false]]);
  assert.equal(data[3].line.dash, "dash");
  assert.equal(data[3].line.color, "red");
  assert.deepEqual(data[3].y, CHART.data[0].y);
});

test("in English a figure keeps the service's words", () => {
  assert.deepEqual(inLanguage(CHART).data.map(({ name }) => name), ["a", "b", "χ = 25.4 mm"]);
  assert.equal(inLanguage(CHART).layout.yaxis.title.text, "Place, mm");
});
