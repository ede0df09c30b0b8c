import assert from "node:assert/strict";
import { test } from "node:test";

import {
  formatAngle, formatDuration, formatNumber, formatQuantity, parseNumber, parseNumbers, shownDigits, tidy, unitOf, written,
} from "../../static/lib/format.js";
import { quantityCell } from "../../static/lib/verdict.js";
import { valuesMarkup } from "../../static/views/results.js";
import { groupMarkup } from "../../static/views/worked.js";

const NARROW = "\u202f";

for (const [typed, value] of [
  ["32,5", 32.5], ["32.5", 32.5], ["1e-3", 0.001], ["1E+3", 1000], [" 7 ", 7], [".5", 0.5], [",5", 0.5],
  ["5.", 5], ["-4", -4], ["+4", 4], ["\u22124", -4], ["1 000,5", 1000.5], ["1\u00a0000.5", 1000.5],
  ["1\u202f000\u2009000", 1e6], ["2,5e2", 250], ["0", 0],
]) {
  test(`reads ${JSON.stringify(typed)} as ${value}`, () => {
    assert.deepEqual(parseNumber(typed), { value });
  });
}

for (const [typed, problem] of [
  ["", "required"], ["   ", "required"], ["1,000.5", "separators"], ["1.000,5", "separators"],
  ["1,000,000", "separators"], ["3 5", "number"], ["1 00", "number"], ["abc", "number"], ["1e", "number"],
  [".", "number"], ["-", "number"], ["e5", "number"], ["0x10", "number"], ["NaN", "number"],
  ["Infinity", "number"], ["1e999", "range"], ["--5", "number"],
]) {
  test(`refuses ${JSON.stringify(typed)} as ${problem}`, () => {
    assert.deepEqual(parseNumber(typed), { problem });
  });
}

test("a comma before three digits is read as decimal, and said to be so", () => {
  assert.deepEqual(parseNumber("1,000"), { value: 1, ambiguous: true });
  assert.deepEqual(parseNumber("0,125"), { value: 0.125 });
});

test("lists are parted by semicolons, spaces, or commas with spaces", () => {
  for (const typed of ["0; 120; 240", "0;120;240", "0 120 240", "0, 120, 240", "0;120;240;"]) {
    assert.deepEqual(parseNumbers(typed), { values: [0, 120, 240] });
  }
  assert.deepEqual(parseNumbers("0; 90,5"), { values: [0, 90.5] });
  assert.deepEqual(parseNumbers("0 90,5"), { values: [0, 90.5] });
  assert.deepEqual(parseNumbers("0,120,240"), { problem: "separators" });
  assert.deepEqual(parseNumbers("0;;240"), { problem: "number" });
  assert.deepEqual(parseNumbers(" "), { problem: "required" });
});

test("numbers show the digits asked, without filling noughts", () => {
  assert.equal(formatNumber(888.2307692, 6), "888.231");
  assert.equal(formatNumber(180, 6), "180");
  assert.equal(formatNumber(0, 3), "0");
  assert.equal(formatNumber(-2.5), "\u22122.5");
  assert.equal(formatNumber(2 / 3, 3), "0.667");
  assert.equal(formatNumber(9.99999999, 4), "10");
  assert.equal(formatNumber(1538.4615, 6), "1538.46");
  assert.equal(formatNumber(206000), `206${NARROW}000`);
  assert.equal(formatNumber(12345.678, 7), `12${NARROW}345.68`);
  assert.equal(formatNumber(123456, 2), `120${NARROW}000`);
  assert.equal(formatNumber(1.5e-9, 3), `1.5${NARROW}×${NARROW}10⁻⁹`);
  assert.equal(formatNumber(6.02e23, 3), `6.02${NARROW}×${NARROW}10²³`);
});

test("a place in a turn is said to a hundredth of a degree", () => {
  assert.deepEqual([0.0020343, 28.571428, 359.9962, -0.004].map((angle) => formatAngle(angle)), ["0°", "28.57°", "360°", "0°"]);
  assert.equal(formatAngle(123.456, 2), "120°");
});

test("what is shown reads back to the digits shown", () => {
  for (let i = 0; i < 2000; i += 1) {
    const value = (Math.random() - 0.5) * 10 ** (Math.random() * 9 - 3);
    const text = formatNumber(value, 6);
    if (text.includes("×")) continue;
    const back = parseNumber(text).value;
    assert.ok(Math.abs(back - value) <= 5.1e-6 * Math.abs(value), `${value} -> ${text}`);
  }
});

test("what is no finite number is never shown", () => {
  assert.throws(() => formatNumber(NaN), RangeError);
  assert.throws(() => formatNumber(Infinity), RangeError);
});

test("the stated accuracy limits the digits", () => {
  assert.equal(shownDigits(1e-15), 4);
  assert.equal(shownDigits(0), 4);
  assert.equal(shownDigits(1e-3), 3);
  assert.equal(shownDigits(0.014), 1);
  assert.equal(shownDigits(2), 1);
});

test("what follows from the request alone keeps its digits beside numbers of a larger error", () => {
  const section = { relative_speed_rpm: 1514.117647, peak_load_N: 13099.5928, accuracy: { relative_error: 4e-3 } };
  const shown = valuesMarkup("satellite_bearing", section, [], {}).toString().match(/(?<=class="value[^>]*>)[^<]+/g);
  assert.deepEqual(shown, [formatNumber(1514), formatNumber(13000)]);
  const steps = [{
    section: "satellite_bearing", code: "relative_speed_rpm", symbol: "n", formula: "n_1*(1+1/u)", names: { n_1: "input_speed_rpm", u: "ratio" },
    values: { n_1: 1430.25, u: 17.0625 }, result: section.relative_speed_rpm, unit: "rpm",
  }];
  const worked = groupMarkup({ section: "satellite_bearing", steps }, section.accuracy).toString();
  for (const number of [1514.12, 1430.25, 17.0625]) assert.ok(worked.includes(`<mn>${formatNumber(number)}</mn>`), worked);
});

test("three or four digits are shown, all are there for who points at them; of a rough model three", () => {
  const section = { peak_force_N: 888.230769231, life_h: 12345.678, accuracy: { relative_error: 1e-15 } };
  assert.deepEqual([written(section, "peak_force_N"), written(section, "life_h")], ["888.2\u00a0N", "12\u202f300\u00a0h"]);
  assert.equal(quantityCell(section, "peak_force_N").exact, "888.230769231\u00a0N");
  const cells = valuesMarkup("contact_force", section, [], {}).toString().match(/title="[^"]+">[^<]+/g);
  assert.deepEqual(cells, ['title="888.230769231">888.2', 'title="12\u202f345.678">12\u202f300']);
});

test("units come from the ending of the API name, the longest first", () => {
  assert.equal(unitOf("peak_force_N"), "N");
  assert.equal(unitOf("stiffness_N_per_mm"), "N/mm");
  assert.equal(unitOf("output_torque_Nm"), "N·m");
  assert.equal(unitOf("crank_angle_deg"), "°");
  assert.equal(unitOf("max_pressure_MPa"), "MPa");
  assert.equal(unitOf("pins"), "");
  assert.equal(formatQuantity(12.5, "°"), "12.5°");
  assert.equal(formatQuantity(12.5, "mm"), "12.5\u00a0mm");
  assert.equal(formatDuration(85.4), "85\u00a0µs");
  assert.equal(formatDuration(1500), "1.5\u00a0ms");
});

test("sums lose their binary noise and nothing else", () => {
  assert.equal(tidy(5 + 1.1), 6.1);
  assert.equal(tidy(0.1 + 0.2), 0.3);
  assert.equal(tidy(360 / 7), 51.4285714285714);
});
