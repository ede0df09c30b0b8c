/**
 * The groups of the crank-planetary form that are off until wanted: their fields, by the paths of the body that they
 * ask with, and the page's own. What they ask and say is in modules of their own, loaded when they are switched on.
 */
import { judgedOf } from "../../lib/checks.js";
import { fatigueFields } from "../../lib/fatigue.js";
import { tidy } from "../../lib/format.js";
import { message } from "../../messages/index.js";
import { figureText } from "../../service_texts.js";
import { wants } from "../../store.js";
import { askedOf, fitted, MOST_PAIRS, ratioOf, refuseMore } from "./mechanism.js";

const MOST_ROWS = 400; // of a table; more are for other programs

const counted = (count, label) => Array.from({ length: Math.min(count, MOST_ROWS) || 0 }, (_, i) => label(i));
const deviated = (part) => ["radial", "tangential", "radius"].map((way) => `deviations.${part}_${way}_mm`);
const rare = { advanced: true };
/** Fields of a section of which the same is said. */
const each = (section, own, ...names) => Object.fromEntries(names.map((name) => [`${section}.${name}`, own]));
/** What a law of contact of these sizes says, by its kinds. */
const lawAt = (path, own = {}) => ({
  ...each(path, { ...own, when: [`${path}.kind`, "linear"], required: true }, "stiffness_N_per_mm"),
  ...each(path, { ...own, when: [`${path}.kind`, "power"], required: true }, "exponent", "reference_force_N", "reference_approach_mm"),
});
const classOf = (part, letters) => ({ like: `tolerances.${part}_diameter.class`, words: [`${part}_class`, "study"], ...letters });
const byOwn = { when: ["study.sizes", "class", "limits"] };
const ofRing = { when: ["gear.kind", "cycloid"], needs: "bearings" }; // where the ring stands
const byLimits = (part, end) => ({ when: ["study.sizes", "limits"], words: [`${part}_${end}`, "study"] });

const REAL = {
  "contact_law.kind": { options: [""] },
  ...lawAt("contact_law"),
  "deviations.pins": {
    words: ["pins", "real"],
    columns: deviated("pin"),
    rows: ({ mechanism: { pins } }) => counted(pins, (n) => message("real.pin", { pin: n + 1 })),
  },
  "deviations.holes": {
    words: ["holes", "real"],
    columns: deviated("hole"),
    rows: ({ mechanism: { pins, satellites } }) => counted(pins * satellites, (i) =>
      figureText("pair", { satellite: Math.floor(i / pins) + 1, pin: (i % pins) + 1 })),
  },
  "deviations.cranks": {
    words: ["cranks", "real"],
    columns: ["deviations.eccentricity_mm", "deviations.crank_phase_deg", "deviations.disc_phase_deg"],
    rows: ({ mechanism: { satellites } }) => counted(satellites, (j) => message("real.satellite", { satellite: j + 1 })),
  },
  "contact_law.reference_depth_mm": { when: ["contact_law.kind", "hertz"] },
  "satellite_coupling.shares": rare,
  ...each("crank_support", { ...rare, default: null }, "stiffness_N_per_mm", "radial_clearance_mm"),
  lost_motion_torque_share: {},
};

const STUDY = {
  "study.sizes": { options: ["class", "limits", "process"], default: "class", words: ["sizes", "study"] },
  "tolerances.process": { when: ["study.sizes", "process"], required: true },
  "tolerances.pin_process": { when: ["study.sizes", "process"], options: [""] },
  "tolerances.hole_process": { when: ["study.sizes", "process"], options: [""] },
  ...each("tolerances", byOwn, "pin_position_mm", "hole_position_mm"),
  "tolerances.pin_diameter.class": classOf("pin", { when: ["study.sizes", "class"], options: [""] }),
  "tolerances.hole_diameter.class": classOf("hole", { when: ["study.sizes", "class"], options: [""] }),
  "tolerances.pin_diameter.lower_mm": byLimits("pin", "lower"),
  "tolerances.pin_diameter.upper_mm": byLimits("pin", "upper"),
  "tolerances.hole_diameter.lower_mm": byLimits("hole", "lower"),
  "tolerances.hole_diameter.upper_mm": byLimits("hole", "upper"),
  ...each("tolerances", {}, "eccentricity_mm", "crank_phase_deg", "disc_phase_deg"),
  "tolerances.ring_pin_position_mm": ofRing,
  "tolerances.ring_pin_diameter.class": { ...ofRing, options: [""], words: ["ring_pin_class", "study"] },
  ...each("tolerances", ofRing, "equidistant_mm", "modification_pin_circle_mm"),
  quantities: { words: ["quantities", "study"], section: "load_sharing" },
  samples: { empty: "fitting" },
  "study.ranked": { options: ["ranked", "plain"], default: "ranked", words: ["ranked", "study"] },
  percentiles: rare,
  seed: {},
  crank_angles: {},
  ...each("limits", rare, "peak_force_N", "max_pressure_MPa", "transmission_error_arcmin", "backlash_max_arcmin",
    "lost_motion_arcmin", "stiffness_min_Nm_per_arcmin"),
  ...each("limits", { ...rare, ...ofRing }, "ring_peak_force_N", "ring_max_pressure_MPa"),
};

const BARE = ["rolling.on", undefined, "", "off"]; // where no rollers are on the pins

const asked = (...names) => each("requirements", rare, ...names);
const bolted = { ...rare, when: ["strength.bolt", "bolted"] };
const STRENGTH = {
  "pin.support": {},
  "pin.satellite_positions_mm": { required: true, follows: (input) => planes(input, gapOf(input)) },
  "pin.span_mm": { when: ["pin.support", "supported", "fixed", "tie_ring"], required: true },
  "pin.ring_joint": { when: ["pin.support", "tie_ring"], default: "pinned" },
  "pin.material": { without: ["allowable_pressure_MPa", "life_curve", "long_term_factor"] },
  "strength.surface": { options: ["bare", "sleeved"], default: "bare", words: ["surface", "strength"], when: BARE },
  "pin.diameter_mm": { when: ["strength.surface", "sleeved"], required: true, words: ["diameter", "strength"] },
  ...fatigueFields("strength.fatigue", ["notch_factor", "notch", "endurance_limit", "plain"]),
  "fatigue.life_h": { ...rare, when: ["strength.fatigue", "notch_factor", "notch", "endurance_limit"] },
  ...each("pin", rare, "bore_diameter_mm", "rotates"),
  "strength.bolt": { ...rare, options: ["whole", "bolted"], default: "whole", words: ["bolt", "strength"] },
  "pin.bolt.core_diameter_mm": { ...bolted, required: true },
  ...each("pin.bolt", bolted, "preload_N", "tightening_torque_Nm", "preload_scatter", "friction_coefficient"),
  "pin.bolt.bolt_material": { ...bolted, without: ["allowable_pressure_MPa", "life_curve", "long_term_factor"] },
  ...asked("bending_safety", "fatigue_safety", "max_deflection_mm", "max_slope_mrad"),
};

const named = ["rollers.name", undefined, ""]; // where no name says it
const ROLLING = {
  "rollers.name": {},
  "rollers.kind": { when: named, default: "ball" },
  ...each("rollers", {}, "bore_diameter_mm", "outer_diameter_mm", "width_mm", "radial_clearance_mm", "dynamic_rating_N", "static_rating_N",
    "ratings", "rolling_elements", "per_satellite", "max_radial_load_N", "max_static_radial_load_N", "friction_coefficient", "limiting_speed_rpm"),
};

const LOSSES = {
  "friction.coefficient": { required: true, when: BARE },
  "friction.wear_rate_mm3_per_Nm": { when: BARE },
  ...asked("min_efficiency", "max_wear_mm", "max_pv_MPa_m_per_s", "max_sliding_speed_m_per_s"),
};

const ofKind = (...kinds) => ({ when: ["gear.kind", ...kinds] });
const [ofPins, ofTeeth, ofBoth] = [ofKind("cycloid"), ofKind("involute"), ofKind("cycloid", "involute")];
const needed = { required: true };
/** Teeth of the ring less those of a satellite, where both are given. */
const differenceOf = ({ satellite_teeth: z2, ring_teeth: z3 }) => z3 - z2;
const discs = { ...ofPins, default: null }; // nothing is known of what is left empty
const BEARINGS = {
  "gear.kind": { options: ["ratio"], default: "involute" },
  "gear.module_mm": { ...ofTeeth, ...needed },
  "gear.teeth_difference": { ...ofTeeth, ...needed, follows: ({ mechanism }) => differenceOf(mechanism) },
  "gear.reference_pressure_angle_deg": { ...rare, ...ofTeeth },
  "gear.ring_pin_circle_radius_mm": { ...ofPins, ...needed },
  "gear.ring_pin_radius_mm": ofPins,
  ...each("gear.modification", discs, "equidistant_mm", "pin_circle_mm"),
  "gear.ring_class": ofPins,
  "gear.radial_force_ratio": { ...ofKind("ratio"), ...needed },
  "bearing.name": {},
  "bearing.kind": { default: "roller", when: ["bearing.name", undefined, ""] },
  ...each("bearing", {}, "dynamic_rating_N", "static_rating_N", "bore_diameter_mm", "outer_diameter_mm", "width_mm"),
  "bearing.limiting_speed_rpm": rare,
  "bearing.reliability_percent": {},
  ...each("bearing", rare, "ring_factor", "weibull_slope"),
  ...asked("static_safety"),
};

const held = { ...needed, when: ["gear.pin_support", "supported", "fixed"] };
const TEETH = {
  ...each("gear", ofTeeth, "satellite_profile_shift", "ring_profile_shift", "satellite_addendum", "ring_addendum", "ring_material"),
  "gear.pin_material": ofPins,
  "gear.friction_coefficient": ofBoth,
  "gear.modification.rotation_arcmin": { ...rare, ...discs },
  "gear.contact_length_mm": { ...rare, ...ofBoth },
  ...each("gear", ofTeeth, "root_strength_MPa", "cutter_teeth", "satellite_tip_radius_mm", "ring_tip_radius_mm", "dedendum", "rack_tip_radius",
    "cutter_profile_shift", "cutter_addendum", "face_load_factor", "pair_stiffness_N_per_mm"),
  "gear.contact_law.kind": { ...rare, ...ofPins, options: [""], words: ["contact_law", "teeth"] },
  "gear.contact_law.reference_depth_mm": { when: ["gear.contact_law.kind", "hertz"], words: ["reference_depth", "teeth"] },
  ...lawAt("gear.contact_law", rare),
  ...each("gear", { ...rare, ...ofPins }, "seat_stiffness_N_per_mm", "sleeve_bore_radius_mm", "rolling"),
  "deviations.ring_pins": {
    ...ofPins,
    words: ["ring_pins", "teeth"],
    columns: deviated("ring_pin"),
    rows: ({ mechanism }) => counted(mechanism.ring_teeth ?? ratioOf(mechanism) + 1, (n) => message("real.pin", { pin: n + 1 })),
  },
  "gear.pin_support": { ...ofPins, default: "seat" },
  ...each("gear", held, "span_mm", "satellite_positions_mm"),
  "gear.rotates": { ...held, required: false },
  ...each("gear", ofPins, "tool_radius_mm", "every_second_pin"),
  ...asked("max_ring_backlash_arcmin", "max_transmission_error_arcmin", "min_ring_efficiency", "max_seat_pressure_MPa"),
};

const shaftBearing = (index, letter) => Object.fromEntries(Object.entries({
  name: {},
  kind: { default: "ball", when: [`crankshaft.bearings.${index}.name`, undefined, ""] },
  dynamic_rating_N: {},
  static_rating_N: rare, bore_diameter_mm: rare, outer_diameter_mm: rare, width_mm: rare,
}).map(([name, own]) => [`crankshaft.bearings.${index}.${name}`, { ...own, words: [name, "crank", { letter }] }]));
const CRANK = {
  "crankshaft.satellite_positions_mm": { required: true, follows: onShaft, words: ["satellites", "crank"] },
  "crankshaft.bearing_positions_mm": { required: true, follows: besideSatellites },
  ...shaftBearing(0, "A"),
  ...shaftBearing(1, "B"),
  "crankshaft.satellite_mass_kg": {},
  ...each("crankshaft", rare, "counterweights", "rotor_mass_kg", "eccentric_diameter_mm", "shaft_diameter_mm"),
  ...asked("max_unbalance_N", "max_unbalance_couple_Nm", "max_unbalance_share", "balance_grade_mm_per_s"),
};

const HOUSING = each("build", {}, "gap_mm", "carrier_width_mm", "second_carrier_width_mm", "carrier_diameter_mm", "housing_diameter_mm", "housing_width_mm");

const GAP = 2; // mm between satellites, and before the first
const USUAL_RPM = 1500;
const MODULES = [0.5, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 8, 10];

/** The gap between satellites: as it is typed, or usual. */
const gapOf = ({ besides }) => (isOn({ besides }, "housing") && besides.build?.gap_mm) || GAP;

/** Middle planes of satellites beside each other, the first so far from the origin. */
function planes({ mechanism: { satellites }, contact: { contact_length_mm: width } = {}, besides }, first) {
  return Array.from({ length: Math.min(satellites, 100) || 0 }, (_, j) => tidy(first + width / 2 + j * (width + gapOf({ besides }))));
}

/**
 * A ring that leaves room for the holes: involute teeth where their circle does, else pins about a cycloid disc. Tips of
 * involute teeth clear each other up to a module that falls with their difference. Far below it, and with a difference
 * of one, their pressure angle is steep.
 */
function ringOf({ mechanism, load, contact: { eccentricity_mm: e, pin_radius_mm: pin } = {} }) {
  const u = ratioOf(mechanism);
  const given = Math.max(differenceOf(mechanism), 0);
  const difference = given || [1, 2, 3, 4, 5].find((d) => Number.isInteger(tidy(u * d))) || 1;
  const holes = load?.pin_circle_radius_mm + pin + e;
  const largest = e / (0.45 * difference + 0.36);
  const module = MODULES.findLast((m) => m <= largest);
  const involute = difference > 1 && module > 0.8 * largest && holes < module * (difference * u / 2 - 1.25);
  const half = Math.sin(Math.PI / (difference * (u + 1))) / 2; // of the way to where the ring's pins touch
  const circle = Math.ceil(Math.max(1.4 * e * (u + 1), 1.2 * (holes + e) / (1 - half)));
  return {
    "gear.kind": involute ? "involute" : "cycloid",
    "gear.module_mm": module,
    "gear.teeth_difference": given ? undefined : difference, // which follows them
    "gear.ring_pin_circle_radius_mm": circle,
    "gear.ring_pin_radius_mm": Math.floor(20 * circle * half) / 20,
  };
}

/** Whether involute teeth are given with their profile shifts. */
const shifted = (gear) => gear?.satellite_profile_shift !== undefined && gear.ring_profile_shift !== undefined;

/** Whether their heights are given too, so that they have an outline. */
export const shaped = (gear) => shifted(gear) && ["satellite", "ring"].every((body) => gear[`${body}_addendum`] || gear[`${body}_tip_radius_mm`]);

/** Involute teeth to start from: usual low ones, the ring's spaces a trifle wider than they fill at the eccentricity. */
function teethTo({ contact: { eccentricity_mm: e } = {}, besides: { gear } }, { "gear.teeth_difference": difference }) {
  const { module_mm: module, teeth_difference: given = difference, reference_pressure_angle_deg: degrees = 20 } = gear;
  const alpha = (degrees * Math.PI) / 180;
  const inv = (angle) => Math.tan(angle) - angle;
  const working = Math.acos((module * given * Math.cos(alpha)) / (2 * e));
  const wider = (given * (inv(working) - inv(alpha))) / (2 * Math.tan(alpha));
  return {
    "gear.satellite_profile_shift": 0,
    "gear.ring_profile_shift": Number.isFinite(wider) ? tidy(Math.ceil(200 * wider + 0.5) / 200) : undefined,
    "gear.satellite_addendum": 0.8,
    "gear.ring_addendum": 0.8,
  };
}

/** Satellites along the shaft: as far apart as along the pins, where these are given. */
function onShaft({ mechanism, contact, besides }) {
  const own = planes({ mechanism, contact, besides }, contact?.contact_length_mm / 2);
  const along = besides?.pin?.satellite_positions_mm;
  return along?.length === own.length ? along.map((z) => tidy(own[0] + z - Math.min(...along))) : own;
}

/** Bearings a satellite's width away from the satellites. */
function besideSatellites({ contact, besides }) {
  const width = contact?.contact_length_mm;
  return [0, tidy(Math.max(...besides?.crankshaft?.satellite_positions_mm ?? []) + width)];
}

/** Tolerances to start from when they are switched on: the classes of the fit where there is one. */
function starts({ contact }) {
  return {
    "tolerances.pin_position_mm": 0.01,
    "tolerances.hole_position_mm": 0.02,
    ...(!contact?.fit && { "tolerances.pin_diameter.class": "h6", "tolerances.hole_diameter.class": "H7" }), // which the fit says
    "tolerances.eccentricity_mm": 0.005,
    "tolerances.disc_phase_deg": 0.01,
  };
}

const PLASTIC_GPA = 20; // below it a modulus is that of a plastic

/** Whether pins or holes are of plastic, whose friction has no usual value. */
function hasPlastic({ contact = {} }, materialOf) {
  return ["pin_material", "hole_material"].some((name) => {
    const path = `contact.${name}`;
    const { name: table, youngs_modulus_GPa: own } = materialOf(path, contact[name]) ?? {};
    return (own ?? materialOf(path, table)?.youngs_modulus_GPa) < PLASTIC_GPA;
  });
}

/** A group that is a section of the answer. */
const part = (id, section, fields, own) => ({
  id, section, fields, ...own,
  load: () => Promise.all([import("./parts.js").then(({ [id]: logic }) => logic), import("../../views/part.js")]),
});

export const WANTED = [
  {
    id: "real",
    view: "load-sharing",
    fields: REAL,
    load: () => Promise.all([import("./real.js"), import("../../views/real.js")]),
  },
  {
    id: "study",
    view: "tolerance-study",
    fields: STUDY,
    judged: false,
    starts,
    load: () => Promise.all([import("./study.js"), import("../../views/study.js")]),
  },
  part("strength", "pin_strength", STRENGTH, { starts: () => ({ "fatigue.reliability_percent": 99 }) }),
  part("rolling", "rollers", ROLLING, { starts: () => ({ "load.input_speed_rpm": USUAL_RPM }) }),
  part("losses", "output_efficiency", LOSSES, {
    starts: (input, materialOf) => ({ "friction.coefficient": hasPlastic(input, materialOf) ? undefined : 0.08, "load.input_speed_rpm": USUAL_RPM }),
  }),
  part("bearings", "satellite_bearing", BEARINGS, { starts: (input) => ({ ...ringOf(input), "load.input_speed_rpm": USUAL_RPM }) }),
  part("teeth", "ring_mesh", TEETH, {
    needs: "bearings",
    applies: ({ besides: { gear } = {} }) => Boolean(gear?.modification && !gear.every_second_pin) || shifted(gear),
    starts(input) {
      const found = ringOf(input);
      if (input.besides?.gear?.kind === "involute" && input.besides.gear.module_mm) return teethTo(input, found);
      return { ...found, "gear.kind": "cycloid", "gear.modification.equidistant_mm": 0.02, "load.input_speed_rpm": USUAL_RPM };
    },
  }),
  part("crank", "crankshaft", CRANK, { needs: "bearings" }),
  part("housing", "envelope", HOUSING),
  part("mass", "mass", {}),
];

/**
 * How pins and holes fit stands with the mechanism as it is made, and where its check finds fault; not of satellites that
 * turn each for itself: these are no one fit.
 */
function showsFit(state) {
  return !state.reading.input.besides?.satellite_coupling && (wants(state, "real") || misfits(state));
}

/** Whether the fit of pins and holes is found wanting. */
function misfits({ about: { calculator }, shown }) {
  const check = judgedOf(calculator, shown?.answer)?.checks?.find(({ code }) => code === "interference");
  return ["fail", "marginal"].includes(check?.status);
}

/** What their lines in the outline say (index.js). */
export const LINES = {
  real: "contact_law.kind",
  study: "tolerances.process, tolerances.hole_diameter.class tolerances.pin_diameter.class, samples",
  strength: "pin.support pin.span_mm, strength.surface, fatigue.life_h",
  rolling: "rollers.name",
  losses: "friction.coefficient",
  bearings: "gear.kind gear.module_mm gear.ring_pin_radius_mm gear.ring_pin_circle_radius_mm, bearing.name",
  teeth: "gear.satellite_profile_shift gear.ring_profile_shift, gear.ring_material gear.pin_material",
  crank: "crankshaft.bearings.0.name, crankshaft.bearings.1.name",
  housing: "build.housing_diameter_mm, build.carrier_diameter_mm",
};

/** Groups that nobody switches: shown where `shows(state)` says so, and opened where it is `urgent(state)`. */
export const BESIDE = [
  { id: "fit", shows: showsFit, urgent: misfits, load: () => Promise.all([import("./fit.js"), import("../../views/live.js")]) },
];

/** Whether a group is on. */
const isOn = ({ besides }, id) => besides?.[id]?.on === "on";

/** Sections of the answer that are wanted. */
export const wantedSections = (input) => WANTED
  .filter(({ id, section, applies = () => true }) => section && isOn(input, id) && applies(input)).map(({ section }) => section);

/** Whether sleeves are on the pins. */
export const sleeved = (input) => isOn(input, "strength") && input.besides.strength.surface === "sleeved";

/**
 * Columns of a table of measured parts as lists by their names, each made of its values by `shaped`; what is left empty
 * there is 0, a column left empty is not said.
 */
function listsOf(rows = [], shaped = (values) => values) {
  const names = [...new Set(rows.flatMap(Object.keys))];
  return Object.fromEntries(names.map((name) => [name, shaped(rows.map((row) => row[name] ?? 0))]));
}

/** Values of holes, satellite by satellite. */
const bySatellites = (pins) => (values) => Array.from({ length: Math.ceil(values.length / pins) }, (_, j) => values.slice(j * pins, (j + 1) * pins));

/**
 * The design document that the form says, as all calculations take it: what belongs to these sections of the answer, or
 * to all that are wanted. A contact law is always said of a mechanism as it is made: by the materials where none is chosen.
 */
export function documentOf({ mechanism, load, contact, besides = {}, ...others }, sections = null) {
  const wanted = wantedSections({ mechanism, besides });
  const asked = (section) => sections?.includes(section) ?? true;
  const on = (section) => wanted.includes(section) && asked(section);
  const made = isOn({ besides }, "real");
  const { deviations: { pins, holes, cranks, ring_pins: ringPins } = {}, requirements } = besides;
  const { contact_law: law = {}, satellite_coupling: shared, crank_support: support, pin, fatigue, rollers, friction, gear: { kind, ...gear } = {}, bearing, crankshaft, build = {} } = besides;
  const zone = isOn({ besides }, "study") ? besides.tolerances?.ring_pin_position_mm : undefined;
  const deviations = {
    ...(made && { ...listsOf(pins), ...listsOf(holes, bySatellites(mechanism.pins)), ...listsOf(cranks) }),
    ...(on("ring_mesh") && listsOf(ringPins)),
  };
  const parts = {
    mechanism: askedOf(mechanism),
    load: asked("contact_force") && load,
    ...(asked("hertz") && {
      contact: contact && fitted(contact),
      contact_law: made && law,
      deviations: Object.keys(deviations).length > 0 && deviations,
      satellite_coupling: made && shared && { kind: "shares", ...shared },
      crank_support: made && support,
      pin: on("pin_strength") && pin,
      fatigue: on("pin_strength") && fatigue,
      rollers: on("rollers") && rollers,
      friction: on("output_efficiency") && !on("rollers") && { ...friction, sleeve: on("pin_strength") && sleeved({ besides }) },
      gear: on("satellite_bearing") && { ...(kind !== "ratio" && { kind }), ...gear },
      bearing: on("satellite_bearing") && bearing,
      crankshaft: on("crankshaft") && crankshaft,
      build: on("envelope") && build,
      tolerances: zone !== undefined && { ring_pin_position_mm: zone }, // all that a verdict says of them
      ...others,
      requirements: requirements ? { ...others.requirements, ...requirements } : others.requirements,
    }),
  };
  return Object.fromEntries(Object.entries(parts).filter(([, part]) => part));
}

/** The body of a figure of the answer: the document by which that was asked, of no more pairs than are drawn. */
export function drawnDocument(input, answer, [{ body: { include, ...asked } }]) {
  refuseMore(asked.mechanism, MOST_PAIRS.drawn);
  return asked;
}

/** How tolerances say the diameters of holes and pins. */
function sizesOf({ process, hole_diameter: hole, pin_diameter: pin }) {
  if (process) return "process";
  return [hole, pin].some((size) => size?.lower_mm !== undefined) ? "limits" : "class";
}

/** Tables of measured parts, each with the names of its columns (REAL, TEETH). */
const MEASURED = { pins: /^pin_/, holes: /^hole_/, cranks: /^(eccentricity|crank_phase|disc_phase)_/, ring_pins: /^ring_pin_/ };

/** Rows of the tables of measured parts that deviations have. */
function measuredOf(deviations) {
  const tables = Object.entries(MEASURED).map(([id, named]) => {
    const lists = Object.entries(deviations).filter(([name]) => named.test(name)).map(([name, values]) => [name, values.flat()]);
    const count = Math.max(0, ...lists.map(([, { length }]) => length));
    return [id, Array.from({ length: count }, (_, k) => Object.fromEntries(lists.map(([name, values]) => [name, values[k]])))];
  });
  return Object.fromEntries(tables.filter(([, { length }]) => length > 0));
}

/** What the form shows of a design document: the groups are on whose parts it has; a pin of one material has it in one field. */
export function inputOf({ pin: given, fatigue = {}, rollers, friction, gear, bearing, crankshaft, build, deviations = {}, tolerances,
  contact_law: law, crank_support: support, satellite_coupling: shared, ...own }) {
  const { requirements, contact } = own;
  const measured = measuredOf(deviations);
  const { ring_pins: ring, ...others } = measured;
  const real = law || support || shared || Object.keys(others).length > 0;
  const { material, ...bare } = given ?? {};
  const pin = given && JSON.stringify(material) === JSON.stringify(contact?.pin_material) ? bare : given;
  const { sleeve, ...rubbing } = friction ?? {};
  const ways = { notch_factor: "fatigue_notch_factor", notch: "notch", endurance_limit: "endurance_limit_MPa" };
  const way = Object.keys(ways).find((each) => fatigue[ways[each]] !== undefined);
  const on = { on: "on" };
  return {
    ...own,
    besides: {
      ...(real && { real: on, contact_law: law, crank_support: support, satellite_coupling: shared }),
      ...((real || ring) && { deviations: measured }),
      ...(pin && { strength: { ...on, surface: sleeve ? "sleeved" : "bare", fatigue: way }, pin, fatigue }),
      ...(rollers && { rolling: on, rollers }),
      ...(friction && { losses: on, friction: rubbing }),
      ...((bearing || crankshaft || gear?.modification || shifted(gear)) && { bearings: on, gear: { kind: "ratio", ...gear }, bearing }),
      ...((gear?.modification || shifted(gear)) && { teeth: on }),
      ...(crankshaft && { crank: on, crankshaft }),
      ...(build && { housing: on, build }),
      ...(tolerances && { study: { ...on, sizes: sizesOf(tolerances) }, tolerances }),
      ...(requirements && { requirements }),
    },
  };
}
