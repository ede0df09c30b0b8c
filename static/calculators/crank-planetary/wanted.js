/**
 * The groups of the crank-planetary form that are off until wanted: their fields, by the paths of the bodies that they
 * ask with, and the page's own. What they ask and say is in real.js and study.js, loaded when they are switched on.
 */
import { message } from "../../messages/index.js";

const MOST_ROWS = 400; // of a table; more are for other programs

const counted = (count, label) => Array.from({ length: Math.min(count, MOST_ROWS) || 0 }, (_, i) => label(i));
const deviated = (part) => ["radial", "tangential", "radius"].map((way) => `deviations.${part}_${way}_mm`);
const law = (...kinds) => ({ when: ["contact_law.kind", ...kinds], required: true });
const held = (...supports) => ({ when: ["pin.support", ...supports] });
const SUPPORTS = ["cantilever", "supported", "fixed"];
const rare = { advanced: true };
const classOf = (part, letters) => ({ like: `tolerances.${part}_diameter.class`, words: [`${part}_class`, "study"], ...letters });
const byLimits = (part, end) => ({ when: ["study.sizes", "limits"], words: [`${part}_${end}`, "study"] });

const REAL = {
  "real.play": { options: ["radial", "fits"], default: "radial", words: ["play", "real"] },
  "contact.hole_clearance_mm": { when: ["real.play", "radial"] },
  "real.pin_class": classOf("pin", { when: ["real.play", "fits"], default: "h6" }),
  "real.hole_class": classOf("hole", { when: ["real.play", "fits"], default: "H7" }),
  "load.torque_direction": {},
  "contact_law.kind": {},
  "contact_law.stiffness_N_per_mm": law("linear"),
  "contact_law.exponent": law("power"),
  "contact_law.reference_force_N": law("power"),
  "contact_law.reference_approach_mm": law("power"),
  "pin.support": { options: ["rigid"], default: "rigid", words: ["support", "real"] },
  "pin.satellite_positions_mm": { ...held(...SUPPORTS), required: true },
  "pin.span_mm": { ...held("supported", "fixed"), required: true },
  "pin.diameter_mm": held(...SUPPORTS),
  "deviations.pins": {
    words: ["pins", "real"],
    columns: deviated("pin"),
    rows: ({ mechanism: { pins } }) => counted(pins, (n) => message("real.pin", { pin: n + 1 })),
  },
  "deviations.holes": {
    words: ["holes", "real"],
    columns: deviated("hole"),
    rows: ({ mechanism: { pins, satellites } }) => counted(pins * satellites, (i) =>
      message("figure.pairForce", { satellite: Math.floor(i / pins) + 1, pin: (i % pins) + 1 })),
  },
  "deviations.cranks": {
    words: ["cranks", "real"],
    columns: ["deviations.eccentricity_mm", "deviations.crank_phase_deg", "deviations.disc_phase_deg"],
    rows: ({ mechanism: { satellites } }) => counted(satellites, (j) => message("real.satellite", { satellite: j + 1 })),
  },
  "contact_law.reference_depth_mm": { ...rare, when: ["contact_law.kind", "hertz"] },
  geometry: rare,
  lost_motion_torque_share: rare,
};

const STUDY = {
  "tolerances.pin_position_mm": {},
  "tolerances.hole_position_mm": {},
  "study.sizes": { options: ["class", "limits"], default: "class", words: ["sizes", "study"] },
  "tolerances.pin_diameter.class": classOf("pin", { when: ["study.sizes", "class"], options: [""] }),
  "tolerances.hole_diameter.class": classOf("hole", { when: ["study.sizes", "class"], options: [""] }),
  "tolerances.pin_diameter.lower_mm": byLimits("pin", "lower"),
  "tolerances.pin_diameter.upper_mm": byLimits("pin", "upper"),
  "tolerances.hole_diameter.lower_mm": byLimits("hole", "lower"),
  "tolerances.hole_diameter.upper_mm": byLimits("hole", "upper"),
  "tolerances.eccentricity_mm": {},
  "tolerances.crank_phase_deg": {},
  "tolerances.disc_phase_deg": {},
  quantities: { words: ["quantities", "study"] },
  samples: {},
  "study.ranked": { options: ["ranked", "plain"], default: "ranked", words: ["ranked", "study"] },
  percentiles: rare,
  seed: rare,
  crank_angles: rare,
  ...Object.fromEntries(["peak_force_N", "max_pressure_MPa", "transmission_error_arcmin", "backlash_max_arcmin",
    "lost_motion_arcmin", "stiffness_min_Nm_per_arcmin"].map((name) => [`limits.${name}`, rare])),
};

/** Tolerances to start from when they are switched on: the classes of the fit where there is one. */
function starts({ besides }) {
  const { play, pin_class: pin, hole_class: hole } = besides?.real ?? {};
  return {
    "tolerances.pin_position_mm": 0.01,
    "tolerances.hole_position_mm": 0.02,
    "tolerances.pin_diameter.class": play === "fits" ? pin : "h6",
    "tolerances.hole_diameter.class": play === "fits" ? hole : "H7",
    "tolerances.eccentricity_mm": 0.005,
    "tolerances.disc_phase_deg": 0.01,
  };
}

export const WANTED = [
  {
    id: "real",
    paths: ["/load-sharing", "/tolerance-study"],
    fields: REAL,
    load: () => Promise.all([import("./real.js"), import("../../views/real.js")]),
  },
  {
    id: "study",
    paths: ["/tolerance-study"],
    fields: STUDY,
    starts,
    load: () => Promise.all([import("./study.js"), import("../../views/study.js")]),
  },
];
