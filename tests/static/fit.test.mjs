/** How pins and holes fit, on the page: when it is shown, what is asked, and what the answers say. */
import assert from "node:assert/strict";
import { test } from "node:test";

import { createBeside } from "../../static/besides.js";
import calculator from "../../static/calculators/crank-planetary/index.js";
import * as fit from "../../static/calculators/crank-planetary/fit.js";
import { setDiameters } from "../../static/lib/units.js";
import { LANGUAGES } from "../../static/messages/index.js";
import { useLanguage } from "./service.mjs";

const [{ shows }] = calculator.beside;

const INPUT = {
  mechanism: { pins: 6, satellites: 1, ratio: 20, revolutions: 1 },
  load: { output_torque_Nm: 20, pin_circle_radius_mm: 30, input_speed_rpm: 1500 },
  contact: { pin_radius_mm: 2, eccentricity_mm: 1.5, hole_clearance_mm: 0.1, contact_length_mm: 10 },
};

/** What the service answers of a hole 2 mm off along the circle. */
const JAMS = {
  state: "binds_in_turning", misfit: "jams", least_room_mm: -0.9000555858, least_room_crank_angle_deg: 257.14306, greatest_room_mm: 0.1,
  least_room_arcmin: -208.3644, greatest_room_arcmin: 32.553, needed_hole_radius_mm: 4.5000555858, blocked_share: 0.69647805,
  binding: [{ satellite: 1, pin: 1, side: "driving" }, { satellite: 1, pin: 4, side: "reverse" }],
  blocked_crank_deg: [[137.75107, 376.54354723]], discs: [{ satellite: 1, least_room_mm: -0.9, turned_deg: 0.6 }],
  elastic: { limit_mm: 0.0038354896, limit_force_N: 1686.74 },
};
const wordsOf = (one) => fit.sentences({ fit: one }, {}, new Map()).map(([, text]) => text);

test("one wrong hole: the parts go together, and jam between the pairs that are named", () => {
  const [state, least, greatest] = fit.cells({ fit: JAMS });
  assert.deepEqual([state.value, state.level], ["go together, but jam", "bad"]);
  assert.equal(state.note, "between pin 1 of satellite 1 (driving side) and pin 4 of satellite 1 (reverse side)");
  assert.match(`${least.value}; ${least.note}; ${greatest.value}; ${greatest.note}`, /^−0.9001\s*mm; −208.4′ .*257.1°; 0.1\s*mm; 32.55′/);
  const [jams, needed, place, elastic] = wordsOf(JAMS);
  assert.match(jams, /30.4 % of the crank angles and jam at the others: 137.8 to 376.5°, again every 342.9°.* 0.9001\s*mm is missing between pin 1/);
  assert.match(needed, /all holes of radius 4.50006\s*mm/);
  assert.match(place, /only one of the pins or holes/);
  assert.match(elastic, /0.003835\s*mm of a pair, under 1687\s*N/);
  setDiameters(true);
  assert.match(wordsOf(JAMS)[1], /all holes of diameter 9.00011\s*mm/);
  setDiameters(false);
});

test("each state has its word and reads in every language", async () => {
  const states = [
    [{ state: "fits", least_room_mm: 0.02, greatest_room_mm: 0.02, least_room_arcmin: 4.6, greatest_room_arcmin: 5.3 }, "good"],
    [JAMS, "bad"],
    [{ ...JAMS, state: "does_not_fit", misfit: "discs_out_of_phase", blocked_crank_deg: undefined, blocked_share: undefined }, "bad"],
    [{ ...JAMS, state: "does_not_fit", misfit: "cannot_assemble", binding: undefined }, "bad"],
    [{ state: "does_not_fit", misfit: "pressed_without_load", least_room_mm: -0.02, greatest_room_mm: -0.02, needed_hole_radius_mm: 10 }, "warning"],
    [{ ...JAMS, misfit: "fits_by_bearing_clearance" }, "warning"],
    [{ state: "no_bound", largest_hole_radius_mm: 12.8, renumbered: [0, 1] }, "bad"],
  ];
  for (const language of Object.keys(LANGUAGES)) {
    await useLanguage(language);
    const words = states.map(([one, level]) => {
      const [{ value, level: shown }] = fit.cells({ fit: one });
      assert.equal(shown, level);
      const all = [value, ...wordsOf(one), ...fit.rows({ fit: one }).flat()].join(" ");
      assert.doesNotMatch(all, /undefined|NaN|\{/);
      return value;
    });
    assert.equal(new Set(words).size, states.length - 1); // two of them do not go together, for two reasons
  }
  await useLanguage("en");
  assert.deepEqual(states.map(([one]) => fit.drawable({ fit: one })), [true, true, true, true, true, true, false]);
});

test("satellites have a table where they differ, of each by itself", () => {
  const discs = [{ satellite: 1, least_room_mm: 0.5, turned_deg: 1e-31 }, { satellite: 2, least_room_mm: 0.49999999999, turned_deg: 9 }];
  const [{ rows }] = fit.tables({ fit: { least_room_mm: -1.85, discs } });
  assert.deepEqual(rows, [["1", 0.5, 0], ["2", 0.49999999999, 9]]);
  assert.deepEqual(fit.tables({ fit: { least_room_mm: 0.5, discs: discs.map((one) => ({ ...one, turned_deg: 0 })) } }), []);
  assert.deepEqual(fit.tables({ fit: { least_room_mm: -0.9, discs: JAMS.discs } }), []);
});

test("the body is the design document", async () => {
  const holes = [{ hole_tangential_mm: 2 }, {}, {}, {}, {}, {}];
  const body = fit.asked({ ...INPUT, besides: { real: { on: "on" }, deviations: { holes } } });
  assert.deepEqual(body, { ...INPUT, contact_law: {}, deviations: { hole_tangential_mm: [[2, 0, 0, 0, 0, 0]] } });
  const posted = [];
  const client = { post: async (path, sent) => posted.push([path, sent.include]) };
  await fit.ask({ client, body });
  assert.deepEqual(posted, [["/fit", ["discs", "elastic"]]]);
  assert.throws(() => fit.ask({ client, body: { ...body, mechanism: { pins: 121, satellites: 2 } } }), { status: 422 });
});

test("it is shown, and asked, with the mechanism as it is made or where its check finds fault only", () => {
  const checked = (status) => ({ answer: { verdict: "pass", checks: [{ code: "interference", status }] } });
  const state = (on, shown, besides = {}) => ({
    typed: { texts: { "real.on": on ? "on" : "" } }, about: { calculator, model: { groups: [{ id: "real" }] } }, shown, reading: { input: { besides } },
  });
  assert.deepEqual([
    shows(state(false, null)), shows(state(false, checked("pass"))), shows(state(false, checked("not_checked"))),
    shows(state(false, checked("fail"))), shows(state(false, checked("marginal"))), shows(state(true, null)),
    shows(state(true, checked("fail"), { satellite_coupling: { shares: [0.5, 0.5] } })),
  ], [false, false, false, true, true, true, false]);
});

test("nothing is asked where it is not shown", async () => {
  const asked = [];
  const filled = {};
  const state = (shown) => ({ phase: "fresh", shown, pending: filled, typed: {}, reading: { input: {}, filled, besides: {} }, besides: {} });
  const store = { state: state({}), apply() {} };
  const logic = { live: true, asked: () => ({}), ask: async () => asked.push(1) };
  let there = false;
  const beside = createBeside({ store, client: {}, id: "fit", logic, shows: () => there });
  const turn = () => new Promise((resolve) => setTimeout(resolve, 1));
  beside.update(store.state);
  await turn();
  assert.equal(asked.length, 0);
  there = true;
  beside.update(store.state);
  await turn();
  assert.equal(asked.length, 1);
});
