import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { coinciding, curveTables, enveloped, inShownUnits, overlaid, inLanguage, onPaper, pairsOf } from "../../static/lib/chart.js";
import { setUnits } from "../../static/lib/units.js";
import { useLanguage } from "./service.mjs";

afterEach(() => setUnits("metric"));

const amount = (value, unit, digits = 6) => ({ value, unit, digits });
const axis = (key, id, unit) => [["layout", key, "title", "text"], "axis", { title: [id, {}], unit }];
const SENT = {
  data: [
    { name: "a", mode: "lines", x: [0, 10], y: [0, 25.4], line: { color: "red" }, hovertemplate: "in English<extra></extra>" },
    { name: "b", mode: "lines", x: [0, 10], y: [0, 50.8], line: { color: "blue" } },
    { name: "χ = 25.4 mm", mode: "markers", x: [5], y: [4.4482216152605], yaxis: "y2" },
  ],
  layout: {
    xaxis: { title: { text: "Crank angle, °" }, range: [0, 10] },
    yaxis: { title: { text: "Deflection, mm" }, range: [0, 254] },
    yaxis2: { title: { text: "Contact force, N" } },
    shapes: [{ xref: "x", yref: "y", x0: 1, x1: 1, y0: 0, y1: 25.4 }, { xref: "x", yref: "paper", x0: 2, x1: 2, y0: 0, y1: 1 }],
    annotations: [{ text: "508 mm", xref: "x", yref: "y", x: 1, y: 508 }],
    meta: {
      words: [
        [["data", 0, "hovertemplate"], "at_place", { name: ["plane_xz", {}], value: amount("%{y:.3g}", "mm"), place: amount("%{x}", "°") }],
        [["data", 2, "name"], "tolerance", { tolerance: amount(25.4, "mm", 3), ratio: amount(0.5, "", 3) }],
        [["layout", "annotations", 0, "text"], "amount", { amount: amount(508, "mm") }],
        axis("xaxis", "crank_angle", "°"), axis("yaxis", "deflection", "mm"), axis("yaxis2", "contact_force", "N"),
      ],
    },
  },
};
const CHART = inLanguage(SENT);

test("in metric units a figure is left as it is", () => {
  assert.equal(inShownUnits(CHART), CHART);
});

test("in English a figure says what the service says, in the page's numbers", () => {
  assert.deepEqual(CHART.data.map(({ name }) => name), ["a", "b", "χ = 25.4\u00a0mm = 0.5·d"]);
  assert.equal(CHART.layout.yaxis.title.text, "Deflection, mm");
  assert.equal(CHART.data[0].hovertemplate, "plane xz: %{y:.3g}\u00a0mm at %{x}°<extra></extra>");
});

test("in another language its words, numbers and units are that language's; what has no words stays", async () => {
  await useLanguage("uk");
  const { data, layout } = inLanguage({ ...SENT, layout: { ...SENT.layout, meta: { words: [...SENT.layout.meta.words, [["data", 1, "name"], "new_one", {}]] } } });
  await useLanguage("en");
  assert.deepEqual(data.map(({ name }) => name), ["a", "b", "χ = 25,4\u00a0мм = 0,5·d"]);
  assert.equal(layout.yaxis2.title.text, "Контактна сила, Н");
  assert.equal(SENT.layout.yaxis2.title.text, "Contact force, N");
  assert.equal(layout.annotations[0].text, "508\u00a0мм");
});

test("data, ranges, marks and words change their units together", () => {
  setUnits("us");
  const { data, layout } = inShownUnits(inLanguage(SENT));
  assert.deepEqual(data[0].y, [0, 1]);
  assert.deepEqual(data[0].x, [0, 10]);
  assert.equal(data[0].hovertemplate, "plane xz: %{y:.3g}\u00a0in at %{x}°<extra></extra>");
  assert.equal(data[2].name, "χ = 1\u00a0in = 0.5·d");
  assert.deepEqual(data[2].y, [1]);
  assert.equal(layout.yaxis.title.text, "Deflection, in");
  assert.equal(layout.yaxis2.title.text, "Contact force, lbf");
  assert.deepEqual(layout.yaxis.range, [0, 10]);
  assert.deepEqual(layout.xaxis.range, [0, 10]);
  assert.equal(layout.shapes[0].y1, 1);
  assert.equal(layout.shapes[1].y1, 1); // a share of the paper, no length
  assert.equal(layout.annotations[0].text, "20\u00a0in");
  assert.equal(layout.annotations[0].y, 20);
});

test("curves become tables: one for each set of places, with canonical units", () => {
  const [lines, mark] = curveTables(CHART);
  assert.deepEqual(lines, {
    title: "Deflection",
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

test("other designs have a colour each, their points by name, and room on the axes; equal curves lie there once", () => {
  const other = {
    data: [CHART.data[0], { ...CHART.data[1], y: [0, 300] }, CHART.data[2]],
    layout: { ...CHART.layout, yaxis: { ...CHART.layout.yaxis, range: [0, 400] } },
  };
  const { data, layout } = overlaid(CHART, [{ name: "A", chart: other }, { name: "B", chart: other }]);
  const added = data.slice(3);
  assert.deepEqual(added.map(({ name, mode, showlegend }) => [name, mode, showlegend]), [
    ["A", "lines", true], ["A", "markers+text", false], ["B", "lines", true], ["B", "markers+text", false],
  ]);
  assert.equal(added[0].line.dash, "dash");
  assert.notEqual(added[0].line.color, added[2].line.color);
  assert.deepEqual(added[1].text, ["A"]);
  assert.deepEqual([layout.yaxis.range, layout.xaxis.range], [[0, 400], [0, 10]]);
});

test("pairs stand thin under the largest force; curves that coincide are one, and are said", () => {
  const line = (name, y) => ({ name, mode: "lines", x: [0, 1, 2], y, line: { color: "red", dash: "dash" }, hovertemplate: name });
  const chart = enveloped({ data: [line("1.1", [0, 4, 1]), line("1.2", [2, 3, 5]), line("2.2", [0, 4, 1]), { name: "Peak", mode: "markers", x: [1], y: [4] }], layout: { shapes: [{}] } }, "Largest");
  assert.deepEqual(chart.data.map(({ name }) => name), ["1.1 = 2.2", "1.2", "Largest", "Peak"]);
  assert.deepEqual(chart.data[2].y, [2, 4, 5]);
  assert.deepEqual(coinciding(chart), ["S1 P1 = S2 P2"]);
  assert.match(chart.data[0].hovertemplate, /^S1 P1 = S2 P2<br>/);
  assert.deepEqual(pairsOf(chart.data[0]), ["1.1", "2.2"]);
  const over = overlaid(chart, [{ name: "A", chart: { ...chart, data: [{ ...chart.data[2], y: [9, 9, 9] }, chart.data[1]] } }]);
  assert.deepEqual(over.data.slice(4).map(({ name, y }) => [name, y]), [["A", [9, 9, 9]]], "of another design the envelope alone");
});

test("a picture has its title over the legend, and leaves legends within the figure where they are", () => {
  const { title, legend, margin } = onPaper({ legend: { x: 0, y: 1.02, yanchor: "bottom" }, margin: { l: 5, t: 1 } }, "Forces", 440);
  assert.equal(title.text, "Forces");
  assert.deepEqual(legend, { x: 0, y: 0.9, yref: "container", yanchor: "top" });
  assert.deepEqual(margin, { l: 5, t: 44, b: 56 });
  assert.deepEqual(onPaper({ legend: { y: 0.6 } }, "Rollers", 900).legend, { y: 0.6 });
});
