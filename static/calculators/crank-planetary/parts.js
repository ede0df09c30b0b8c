/** Groups of the crank-planetary form that are sections of the answer: what is said and drawn of each. No DOM. */
import { inTwoLines } from "../../lib/chart.js";
import { formatNumber, written } from "../../lib/format.js";
import { quantityCell } from "../../lib/verdict.js";
import { message, quantityTitle } from "../../messages/index.js";
import { reasonText } from "../../service_texts.js";
import { crankDrawing, pinDrawing } from "./along.js";
import { drawnDocument } from "./wanted.js";

export const strength = {
  figure: { id: "pinStrength", path: "/pin-strength/chart", body: drawnDocument },
  drawing: pinDrawing,

  /** The same pin in the supports between which the truth of a cage lies, asked for where it is held at both ends. */
  bounds: {
    path: "/pin-strength",
    list: "support_bounds",
    of: ({ pin_strength: section }, { besides }) => section && besides?.pin?.span_mm !== undefined && besides.pin.support !== "tie_ring",
    body: (input, answer, requests) => ({ ...drawnDocument(input, answer, requests), include: ["support_bounds", "deflection"] }),
    shown: [
      "peak_bending_stress_MPa", "peak_equivalent_stress_MPa", "static_safety_factor", "fatigue_safety_factor", "deflection_mm", "slope_mrad",
    ],
    nameOf: ({ support }) => message("option")[support],
  },

  cells(section) {
    const { static_safety_factor: yields, fatigue, deflection, tie_ring: ring, bolt } = section;
    const stress = yields === undefined ? message("strength.noYield") : message("strength.yield", { safety: formatNumber(yields, 3) });
    const cycle = fatigue ? message("strength.cycle", { from: written(fatigue, "min_stress_MPa"), to: written(fatigue, "max_stress_MPa") })
      : message("strength.noFatigue");
    const opens = bolt?.opening_moment_Nm === undefined ? message("strength.noPreload")
      : message(bolt.holds ? "strength.boltHolds" : "strength.boltAlone", { opens: written(bolt, "opening_moment_Nm") });
    return [
      quantityCell(section, "peak_equivalent_stress_MPa", stress),
      quantityCell(fatigue ?? {}, "safety_factor", cycle, quantityTitle("fatigue_safety_factor")),
      deflection && quantityCell(deflection, "deflection_mm", message("strength.slope", {
        satellite: deflection.satellite, sloping: deflection.slope_satellite, slope: written(deflection, "slope_mrad"),
      })),
      ring && quantityCell(ring, "peak_force_N", message("strength.ringMoves", {
        shift: written(ring, "shift_mm"), turn: written(ring, "turn_mrad"),
      }), quantityTitle("tie_ring_peak_force_N")),
      bolt && quantityCell(bolt, "moment_Nm", opens, message("strength.bolt")),
    ].filter(Boolean);
  },
};

export const rolling = {
  cells(section) {
    const { satellite, pin } = section;
    const told = (name, key, none) => (section[name] === undefined ? message(none) : message(`rolling.${key}`, { [key]: written(section, name) }));
    const cell = (name, note, title = name) => quantityCell(section, name, note, quantityTitle(title, "rollers"));
    return [
      cell("equivalent_load_N", message("rolling.peak", { satellite, pin, peak: written(section, "peak_load_N") })),
      cell("life_h", told("dynamic_rating_as_roller_N", "rating", "bearings.noRating")),
      cell("static_safety_factor", told("speed_rpm", "speed", "rolling.noSpeed"), "static_rating_safety"),
    ];
  },
};

export const losses = {
  figure: { path: "/output-efficiency/chart", body: drawnDocument, height: 420 },
  cells: (section) => [
    quantityCell(section, "efficiency", message("losses.least", { value: written(section, "min_efficiency") })),
    quantityCell(section, "mean_loss_W", message("losses.of", { power: written(section, "output_power_W") })),
    quantityCell(section, "peak_pv_MPa_m_per_s", message("losses.at", { speed: written(section, "sliding_speed_m_per_s") })),
  ],
};

const ROUNDING = 1e-9;

/** The satellite whose bearing has the largest equivalent load. */
function worstOf({ satellites }) {
  return satellites.reduce((worst, one, i) => (one.equivalent_load_N > satellites[worst].equivalent_load_N * (1 + ROUNDING) ? i : worst), 0);
}

export const bearings = {
  figure: { path: "/satellite-bearing/chart", body: drawnDocument },
  lists: { satellites: (i) => message("real.satellite", { satellite: i + 1 }) },
  cells(section) {
    const satellite = worstOf(section) + 1;
    const own = section.satellites[satellite - 1];
    const ratio = written(section, "radial_force_ratio");
    return [
      quantityCell(own, "equivalent_load_N", message("bearings.peak", { satellite, peak: written(own, "peak_load_N") })),
      quantityCell(own, "life_h", own.life_h === undefined ? message("bearings.noRating") : message("bearings.basic", { life: written(own, "basic_life_h") })),
      quantityCell(own, "static_safety_factor", message("bearings.ring", { ratio }), quantityTitle("static_rating_safety")),
    ];
  },
};

const [PATH, PANELS] = [420, 760]; // heights of the figures of involute teeth, and of discs on pins

const lost = (efficiency) => (efficiency === undefined ? message("teeth.noFriction")
  : message("teeth.efficiency", { efficiency: written(efficiency, "efficiency") }));

/** How the tips of involute teeth pass each other. */
function tipsOf({ tips_overlap_all_round: overlap, tip_interference_G: room }) {
  if (overlap) return message("teeth.overlap");
  return room === undefined ? message("teeth.apart") : message("teeth.tips", { room: formatNumber(room, 3) });
}

/** Cycloid discs on pins of the ring, or involute teeth. */
export const teeth = {
  figure: {
    path: "/crank-planetary/chart",
    height: ({ besides } = {}) => (besides?.gear?.kind === "cycloid" ? PANELS : PATH),
    body: (input, answer, [{ body }]) => ({ ...body, include: ["ring_mesh"] }),
    /** Its titles no longer than its panels are high, where there are several. */
    shape: ({ data, layout }) => (!layout.yaxis4 ? { data, layout } : {
      data,
      layout: { ...layout, ...Object.fromEntries(["yaxis", "yaxis2", "yaxis3", "yaxis4"].map((axis) => [axis, inTwoLines(layout[axis])])) },
    }),
  },
  cells({ over_turn: turn, ideal, efficiency, geometry, stresses }) {
    if (turn === undefined) {
      return [
        quantityCell(stresses, "pressure_one_pair_start_MPa", message("teeth.start", { force: written(stresses, "normal_force_N") })),
        quantityCell(geometry, "contact_ratio", tipsOf(geometry)),
        quantityCell(geometry, "backlash_arcmin", lost(efficiency), quantityTitle("geometry_backlash_arcmin")),
      ];
    }
    const pressure = quantityCell(turn, "max_pressure_MPa", message("teeth.peak", {
      ...turn.peak_pair, force: written(turn, "peak_force_N"), times: written(turn, "peak_force_ratio"),
    }));
    if (turn.backlash_max_arcmin === undefined) { // both meshes in series, whose play and stiffness are elsewhere
      const lag = { lag_arcmin: Math.max(turn.lag_max_arcmin, -turn.lag_min_arcmin) };
      return [
        pressure,
        quantityCell(lag, "lag_arcmin", message("teeth.both"), message("teeth.lag")),
        ...(efficiency === undefined ? [] : [quantityCell(efficiency, "efficiency", message("teeth.alone"))]),
      ];
    }
    const play = ideal.backlash_arcmin === undefined ? message("teeth.jams") : message("teeth.many", { backlash: written(ideal, "backlash_arcmin") });
    return [
      pressure,
      quantityCell(turn, "backlash_max_arcmin", play),
      quantityCell(turn, "transmission_error_arcmin", lost(efficiency)),
    ];
  },
};

const letterOf = (i) => "AB"[i];

export const crank = {
  figure: { path: "/crankshaft/chart", body: drawnDocument },
  drawing: crankDrawing,
  lists: { bearings: letterOf, corrections: letterOf },
  cells({ bearings: held, balance }) {
    const lasts = (bearing) => (bearing.basic_life_h === undefined ? message("crank.equivalent", { load: written(bearing, "equivalent_N") })
      : message("crank.life", { life: written(bearing, "basic_life_h") }));
    return [
      ...held.map((bearing, i) => quantityCell(bearing, "peak_N", lasts(bearing), message("crank.bearing", { letter: letterOf(i) }))),
      balance && quantityCell(balance, "unbalance_kg_mm", message("crank.left", {
        force: written(balance, "force_N"), couple: written(balance, "couple_Nm"),
      })),
    ].filter(Boolean);
  },
};

export const housing = {
  cells(section) {
    const [around, near, far] = section.of.map((part) => message(`option.${part}`));
    return [
      quantityCell(section, "outer_diameter_mm", message("housing.around", { around })),
      quantityCell(section, "length_mm", message("housing.along", { near, far })),
    ];
  },
};

/** Parts that have their names from the sizes of housing and carrier. */
const NAMED = ["housing", "carrier", "second_carrier", "bearing_a", "bearing_b"];

/** What is said of a part: how many there are and whether its shape is assumed, or why its mass is not known. */
function noteOf({ count, estimate, reason }) {
  if (reason) return reasonText(reason);
  return [message("mass.pieces", { count }), estimate && message("mass.estimate")].filter(Boolean).join("; ");
}

export const mass = {
  cells: (section) => [
    quantityCell(section, "mass_kg", message("mass.of")),
    quantityCell(section, "inertia_kg_m2"),
    ...section.parts.map((part) => quantityCell(part, "mass_kg", noteOf(part), message(`${NAMED.includes(part.code) ? "option" : "mass"}.${part.code}`))),
  ],
};
