import assert from "node:assert/strict";
import { test } from "node:test";

import { crankDrawing, pinDrawing } from "../../static/calculators/crank-planetary/along.js";
import { createDrawing as crank } from "../../static/calculators/crank-planetary/drawing.js";
import { createDrawing as precession, shaftStretches } from "../../static/calculators/precession/drawing.js";
import { createDrawing as rollers, rollerPlace, sphereOutline } from "../../static/calculators/rollers/drawing.js";

const PAPERS = [{ width: 944, height: 500 }, { width: 326, height: 554 }];
const SIZES = [1e-12, 1, 1e12];

/** The drawing has numbers everywhere, and none that a browser cannot place. */
function drawable({ markup }) {
  const text = markup.toString();
  assert.ok(!/NaN|Infinity|undefined/.test(text), /.{60}(NaN|Infinity|undefined).{20}/.exec(text)?.[0]);
}

test("a mechanism of any size, and with sizes that do not fit each other", () => {
  const cyclogram = {
    period_deg: 342.857, driving_count: [{ to_deg: 360 }],
    pairs: [1, 2, 3].map((pin) => ({ satellite: 1, pin, driving_deg: [[0, 171.43]] })),
  };
  for (const paper of PAPERS) {
    for (const R of SIZES) {
      for (const pin of SIZES) {
        for (const ratio of [1e-6, 20, 1e9]) {
          for (const hole of [pin / 2, 1.25 * pin]) {
            drawable(crank({
              input: {
                mechanism: { pins: 3, satellites: 1, ratio, initial_crank_angle_deg: 0 },
                load: { pin_circle_radius_mm: R },
                contact: { pin_radius_mm: pin, hole_radius_mm: hole },
              },
              answer: { cyclogram, contact_force: { peak_force_N: 1e-9, peak_pair: { satellite: 1, pin: 2 } } },
              curves: [], ...paper,
            }));
          }
        }
      }
    }
  }
});

test("a ring of any size about it, with and without what its discs do, and its caption", () => {
  const cyclogram = {
    period_deg: 342.857, driving_count: [{ to_deg: 360 }],
    pairs: [1, 2].map((satellite) => ({ satellite, pin: 1, driving_deg: [[0, 171.43]] })),
  };
  const pins = (size) => [0, 1, 2].map((k) => ({ centre_mm: [size * Math.cos(k), size * Math.sin(k)], radius_mm: size / 9 }));
  const rows = (value) => [0, 1].map(() => [0, 1, 2].map(() => [0, value]));
  for (const paper of PAPERS) {
    for (const size of SIZES) {
      for (const e of SIZES) {
        const input = {
          mechanism: { pins: 1, satellites: 2, ratio: 2, initial_crank_angle_deg: 0 },
          load: { pin_circle_radius_mm: 1 }, contact: { pin_radius_mm: 1, hole_radius_mm: 1 + e, eccentricity_mm: e },
          besides: { bearings: { on: "on" }, gear: { kind: "cycloid", ring_pin_circle_radius_mm: size, ring_pin_radius_mm: size / 9 } },
        };
        const answer = { cyclogram, contact_force: { peak_force_N: 1, peak_pair: { satellite: 1, pin: 1 } } };
        const plain = crank({ input, answer, curves: [], ...paper });
        drawable(plain);
        assert.deepEqual(plain.ringPairs, []);
        for (const value of [0, 1e-12, 1e6]) {
          const of = { turn_deg: [0, 90], ring_pins: pins(size), crank_angle_deg: [0, 360], force_N: rows(value), gap_mm: rows(value) };
          for (const lobe of [{ lobe_mm: [[0, size], [size / 2, size]] }, {}]) {
            const drawn = crank({ input, answer: { ...answer, ring_drawing: { ...of, ...lobe } }, curves: [], ...paper });
            drawable(drawn);
            assert.deepEqual(drawn.ringPairs, ["1/1", "1/2", "1/3", "2/1", "2/2", "2/3"]);
            assert.ok(new Set([plain, drawn].map(({ caption }) => caption)).size === 2);
          }
        }
      }
    }
  }
});

test("pins and shafts of any size, held in any way, with any number of satellites", () => {
  for (const paper of PAPERS) {
    for (const length of SIZES) {
      for (const rim of SIZES) {
        for (const satellites of [1, 2, 60]) {
          const planes = Array.from({ length: satellites }, (_, i) => (i + 1) * length);
          for (const [support, surface] of [["cantilever", "bare"], ["supported", "sleeved"], ["fixed", "bare"]]) {
            const besides = {
              strength: { on: "on", surface },
              pin: { support, span_mm: 2 * length, diameter_mm: rim, satellite_positions_mm: planes },
              crankshaft: { satellite_positions_mm: planes, bearing_positions_mm: [0, length] },
            };
            const input = {
              mechanism: { satellites }, load: { pin_circle_radius_mm: rim },
              contact: { pin_radius_mm: rim, hole_radius_mm: 1.25 * rim, eccentricity_mm: rim / 4, contact_length_mm: length }, besides,
            };
            drawable(pinDrawing({ input, ...paper }));
            for (const peak of [0, 5000]) {
              drawable(crankDrawing({ input, answer: { crankshaft: { bearings: [{ peak_N: peak }, { peak_N: 0 }] } }, ...paper }));
            }
          }
        }
      }
    }
  }
});

test("rollers of any size and number", () => {
  for (const paper of PAPERS) {
    for (const l of SIZES) {
      for (const D of SIZES) {
        for (const count of [1, 4, 60, 61]) {
          drawable(rollers({
            input: { cylinder_length_mm: l, sphere_width_mm: 8, sphere_diameter_mm: D, diameter_mm: 10, hole_circle_radius_mm: l },
            answer: { roller_strength: { forces_N: Array(count).fill(5), max_force_N: 5, centre_force_N: 10 } }, ...paper,
          }));
        }
      }
    }
  }
});

test("a gear of any size, its rollers on either side, with and without the shaft's answer", () => {
  const shaft = {
    reaction_B_N: [0, 0], reaction_C_N: [3, -4],
    deflection_B_mm: { x: 0, y: 0, total: 0 }, deflection_C_mm: { x: 1e-9, y: -1e-9, total: 1.4e-9 },
  };
  for (const paper of PAPERS) {
    for (const RC of SIZES) {
      for (const a of SIZES) {
        for (const [low, high] of [[15, 25], [-25, -15], [-5, 5]]) {
          for (const shaft_deflection of [shaft, undefined]) {
            drawable(precession({
              input: {
                roller_circle_radius_mm: RC, roller_radius_mm: RC / 12, nutation_angle_deg: 6, reference_z_mm: -a,
                bearing_distance_mm: a, overhang_mm: a, shaft_diameter_mm: 20,
              },
              answer: {
                contact_line: { lines: [{ position_angle_deg: -30, z_min_mm: low, z_max_mm: high }] },
                meshing_load: { force_N: [3, 4, 0] }, shaft_deflection,
              },
              curves: [], ...paper,
            }));
          }
        }
      }
    }
  }
});

test("a spherical part lies on its sphere and is as wide as said", () => {
  const outline = sphereOutline(5, 8, 15);
  for (const [x, y] of outline) assert.ok(Math.abs(Math.hypot(x - 5, y) - 7.5) < 1e-12);
  const across = outline.map(([x]) => x);
  assert.equal(Math.max(...across) - Math.min(...across), 8);
});

test("rollers stand evenly on their circle, their forces along it", () => {
  for (let i = 0; i < 5; i += 1) {
    const { place, along } = rollerPlace(i, 5, 30);
    assert.ok(Math.abs(Math.hypot(...place) - 30) < 1e-12);
    assert.ok(Math.abs(place[0] * along[0] + place[1] * along[1]) < 1e-12);
    assert.ok(place[0] * along[1] - place[1] * along[0] < 0, "clockwise, all the same way");
  }
});

test("the shaft's stretches follow each other from C to the clamp", () => {
  const sections = [{ length_mm: 30, diameter_mm: 20 }, { length_mm: 40, diameter_mm: 25 }];
  assert.deepEqual(
    shaftStretches({ shaft_sections: sections, bearing_distance_mm: 30, overhang_mm: 40, reference_z_mm: 20 }),
    [{ from: 20, to: 50, diameter: 20 }, { from: 50, to: 90, diameter: 25 }],
  );
});
