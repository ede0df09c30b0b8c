/**
 * The crank-planetary calculator: mechanism, load and contact as one job.
 *
 * Only what the schema cannot say stands here: which fields exclude each other, the values that the
 * theory suggests, what the verdict reads from the answer, which figures there are.
 */
import { cell, quantityCell, stated } from "../../lib/verdict.js";
import { digitsOf, formatAngle, formatNumber, formatQuantity, tidy } from "../../lib/format.js";
import { pairsOf } from "../../lib/chart.js";
import { DIAMETER, inDiameters } from "../../lib/units.js";
import { message, quantityTitle } from "../../messages/index.js";
import { figureText } from "../../service_texts.js";
import { createDrawing } from "./drawing.js";
import { askedOf, cranksOf, MOST_PAIRS, ratioOf, refuseMore } from "./mechanism.js";
import { factorOf, sentences } from "./sentences.js";
import { BESIDE, documentOf, drawnDocument, inputOf, LINES, shaped, WANTED, wantedSections } from "./wanted.js";

const MOST_ROWS = 24;

/** What /contact-force asks: the mechanism's fields beside those of an ideal load. */
function forceBody({ mechanism: { revolutions, ...mechanism }, load }) {
  const { output_torque_Nm, input_torque_Nm, efficiency, pin_circle_radius_mm, force_exponent } = load;
  return { ...askedOf(mechanism), output_torque_Nm, input_torque_Nm, efficiency, pin_circle_radius_mm, force_exponent };
}

/** The body of a figure of one section; before there is an answer, of what the form says. */
const figureOf = (section) => (input, answer = null, requests = [{ body: documentOf(input) }]) =>
  ({ ...drawnDocument(input, answer, requests), include: [section] });

/** The contact, the force of its pressure (with clearance that under the dynamic load), and what bent pins add to its line load. */
export function pressedBy(contact, factor, { contact_force: ideal, load_sharing: real, hertz }) {
  const edge = hertz?.line_load_factor ?? 1;
  if (real?.judged_force_N === undefined) return { contact: { ...contact, dynamic_factor: factor ?? 1 }, force: ideal.peak_force_N, edge };
  return { contact: { ...contact, dynamic_factor: 1, distribution_factor: 1 }, force: real.judged_force_N, edge };
}

function hertzBody({ load, contact: { eccentricity_mm: e, hole_clearance_mm: clearance, fit, distribution_of, ...given } }, answer) {
  const { contact, force, edge } = pressedBy(given, load?.application_factor, answer);
  const hole = fit && { hole_radius_mm: tidy(given.pin_radius_mm + e + answer.geometry.clearance_mm) };
  return { ...contact, ...hole, force_N: force * edge };
}

/** How much the hole is larger than pin and eccentricity need, or smaller. */
function clearanceOf({ contact }) {
  return tidy(contact?.hole_radius_mm - contact?.pin_radius_mm - contact?.eccentricity_mm);
}

/** Whether the forces that are judged are solved: of a document as it is made, of pins that bend, or of both meshes in series. */
function isSolved({ contact, contact_law, pin, gear }) {
  if (contact_law || clearanceOf({ contact }) > 1e-9 || contact?.hole_clearance_mm > 0 || contact?.fit) return true;
  const series = gear?.modification && contact?.hole_clearance_mm === 0;
  return Boolean(pin || series) && !(contact?.distribution_factor > 1);
}

function clearanceNote(input) {
  const clearance = clearanceOf(input);
  if (!(Math.abs(clearance) > 1e-9)) return "";
  if (clearance > 0) return message("form.clearance", { value: formatQuantity(clearance, "mm") });
  return message("form.interference", { value: formatQuantity(-clearance, inDiameters() ? DIAMETER : "mm") });
}

/** Tooth numbers of exactly this ratio, with the least difference; none where there are none. */
function teethOf(ratio) {
  const difference = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10].find((d) => Number.isInteger(tidy(ratio * d)));
  if (!difference) return {};
  const satellite = tidy(ratio * difference);
  return { "mechanism.satellite_teeth": satellite, "mechanism.ring_teeth": satellite + difference };
}

/** How many pairs drive; with real forces, how many of them are loaded. */
function pairsCell(section, real) {
  const { min_driving: least, max_driving: most, mean_driving: mean, pairs, dead_centres_deg: dead } = section;
  if (dead.length > 0) {
    const angles = dead.slice(0, 3).map((angle) => formatAngle(angle)).join(", ");
    const more = dead.length > 3 ? ` ${message("verdict.more")}` : "";
    return { value: `0–${most}`, note: message("verdict.dead", { angles: angles + more }), level: "bad" };
  }
  const span = (from, to) => (from === to ? String(from) : `${from}–${to}`);
  const all = new Set(pairs.map(({ satellite, pin }) => `${satellite}/${pin}`)).size;
  if (real) {
    return {
      label: message("real.loaded"),
      value: span(real.loaded_pairs_min, real.loaded_pairs_max),
      note: message("verdict.pairsLoaded", { all, ideal: span(least, most) }),
    };
  }
  return { value: span(least, most), note: message("verdict.pairsMean", { all, mean: formatNumber(mean, 4) }) };
}

function peakCell(section, input, id) {
  const factor = factorOf(input);
  const at = message("verdict.peakAt", {
    angle: formatAngle(section.peak_crank_angle_deg, digitsOf("", section.accuracy)),
    ...section.peak_pair,
  });
  return {
    label: quantityTitle("peak_force_N", id),
    ...stated(section, "peak_force_N"),
    note: factor === 1 ? at : `${at}; ${message("verdict.withoutFactors", { factor: formatNumber(factor, 4) })}`,
  };
}

function pressureCell(section, { requirements }) {
  const { governing_pressure_MPa: pressure, safety_factor: safety, line_load_factor: edge = 1 } = section;
  const { conformal_half_angle_pin_deg: angle } = section;
  return {
    ...(pressure !== undefined && stated(section, "governing_pressure_MPa")),
    note: [
      safety !== undefined && message("verdict.safety", { safety: formatNumber(safety, 3), asked: formatNumber(requirements.pitting_safety, 3) }),
      edge !== 1 && message("verdict.edge", { factor: formatNumber(edge, 3) }),
      angle !== undefined && message("verdict.wraps", { angle: formatAngle(angle, 3) }),
    ].filter(Boolean).join("; "),
  };
}

/** The torque that the input needs with the losses that are known, beside the one typed there; without them that one. */
function inputCells({ output_efficiency: losses }, { load = {} }) {
  const { input_torque_Nm: typed, efficiency } = load;
  const label = message("verdict.input");
  const typedText = () => formatQuantity(typed, "N·m");
  if (losses?.input_torque_Nm === undefined) {
    return typed === undefined ? [] : [{ label, value: typedText(), note: message("verdict.inputTyped", { efficiency: formatNumber(efficiency, 3) }) }];
  }
  const teeth = losses.total_efficiency !== losses.efficiency;
  const more = losses.input_torque_Nm > 1.01 * typed;
  const note = message(teeth ? "verdict.inputOf" : "verdict.inputOfPins", { efficiency: formatNumber(losses.total_efficiency, 3) });
  return [{
    ...quantityCell(losses, "input_torque_Nm", more ? `${message("verdict.inputMore", { typed: typedText() })}; ${note}` : note, label),
    level: more && "warning",
  }];
}

/** An answer as it is shown: no safety of what cannot be built. */
function withoutFalseSafety(answer) {
  if (!answer.hertz || !answer.checks?.some(({ impossible }) => impossible)) return answer;
  const { safety, safety_factor, ...hertz } = answer.hertz;
  return { ...answer, hertz };
}

/** Where the discs stand along the axis, where that is known. */
const placesOf = ({ crankshaft, pin }) => crankshaft?.satellite_positions_mm?.length || pin?.satellite_positions_mm?.length;

const pairColumns = () => ["satellite", "pin"].map((name) => ({ title: quantityTitle(name) }));
const phaseColumns = () => ["from", "to"].map((name) => ({ title: message(`sweep.${name}`), unit: "°" }));

/** When pairs drive; where forces are solved, when they carry. */
function phaseTables({ cyclogram, real_cyclogram: real }) {
  const word = real ? "carrying" : "driving";
  return [
    {
      title: message(real ? "figure.carried" : "figure.phases"),
      columns: [...pairColumns(), ...phaseColumns()],
      rows: (real ?? cyclogram).pairs.flatMap(({ satellite, pin, driving_deg: driving, loaded_deg: phases = driving }) =>
        phases.map(([from, to]) => [satellite, pin, from, to])),
    },
    {
      title: message(real ? "figure.carriedCounts" : "figure.counts"),
      columns: [...phaseColumns(), { title: message(`figure.${word}`) }],
      rows: (real?.loaded_count ?? cyclogram.driving_count).map(({ from_deg: from, to_deg: to, pairs }) => [from, to, pairs]),
    },
  ];
}

/** The peak, and the curves where they were asked for: of the forces that are judged. */
const judgedOf = ({ load_sharing: real, contact_force: ideal }) => real ?? ideal;

function forceTables(answer) {
  const { curves } = judgedOf(answer);
  return [{
    title: message(answer.load_sharing ? "figure.forcesReal" : "figure.forces"),
    columns: [
      { title: quantityTitle("crank_angle_deg"), unit: "°" },
      ...curves.pairs.map((pair) => ({ title: figureText("pair", pair), unit: "N" })),
    ],
    rows: curves.crank_angle_deg.map((angle, i) => [angle, ...curves.force_N.map((pair) => pair[i])]),
  }];
}

/** The curves of the answer itself, where it has been asked for them. */
function curvesOf(answer) {
  const curves = judgedOf(answer)?.curves;
  if (!curves) return [];
  const { crank_angle_deg: x, pairs, force_N: forces } = curves;
  return pairs.map(({ satellite, pin }, i) => ({ name: `${satellite}.${pin}`, x, y: forces[i] }));
}

/** The approximation of the peak is asked for only where it is stated: 3 to 5 pins, 1 or 2 satellites. */
function approximated({ pins, satellites }) {
  return pins >= 3 && pins <= 5 && satellites <= 2 ? ["approximation"] : [];
}

export default {
  id: "crank-planetary",
  path: "/crank-planetary",
  groups: ["mechanism", "load", "contact", "satellite_body", "temperatures", "requirements"],
  arranged: {
    reducer: ["ratio", "contact.eccentricity_mm", "mechanism.satellites", "cranks"],
    pins: ["mechanism.pins", "load.pin_circle_radius_mm", "contact.pin_radius_mm", "play", "contact.hole_radius_mm", "contact.contact_length_mm"],
    load: ["torque", "load.torque_direction", "load.application_factor", "load.input_speed_rpm", "load.peak_torque_Nm", "load.peak_kind"],
    materials: ["contact.pin_material", "contact.hole_material"],
    requirements: ["scope", "life_h", "pitting_safety", "min_wall_mm", "max_outer_diameter_mm", "max_length_mm", "max_backlash_arcmin", "max_lost_motion_arcmin"].map((name) => `requirements.${name}`),
    satellite_body: [
      ...["outer", "root", "bore"].map((name) => `satellite_body.${name}_radius_mm`),
      "satellite_body.solid_wall_mm", "temperatures.satellite_C", "temperatures.pins_C",
    ],
    more: ["load.force_exponent", "contact.distribution_factor", "contact.distribution_of", "mechanism.initial_crank_angle_deg", "mechanism.revolutions", "mechanism.output", "load.ring_speed_rpm", "load.carrier_speed_rpm"],
  },
  /** What the line of a section says, by its fields. */
  lines: {
    reducer: "mechanism.ratio mechanism.output_ratio mechanism.satellite_teeth mechanism.ring_teeth, mechanism.satellites, contact.eccentricity_mm",
    pins: "mechanism.pins contact.pin_radius_mm load.pin_circle_radius_mm, contact.fit contact.hole_clearance_mm contact.hole_radius_mm",
    load: "load.output_torque_Nm load.input_torque_Nm, load.input_speed_rpm, load.peak_torque_Nm",
    materials: "contact.pin_material, contact.hole_material",
    requirements: "requirements.life_h, requirements.max_outer_diameter_mm, requirements.max_length_mm, requirements.max_backlash_arcmin, requirements.pitting_safety",
    satellite_body: "satellite_body.outer_radius_mm, satellite_body.bore_radius_mm",
    more: "mechanism.output, contact.distribution_factor",
    ...LINES,
  },
  hidden: ["contact.dynamic_factor", "load.include", "load.samples", "include", "fixes_for", "crank_angle_deg"],
  moved: { "load.application_factor": "contact.dynamic_factor" },
  choices: {
    cranks: { spacing: ["mechanism.crank_spacing_deg"], list: ["mechanism.crank_angles_deg"] },
    ratio: { value: ["mechanism.ratio"], teeth: ["mechanism.satellite_teeth", "mechanism.ring_teeth"], ring: ["mechanism.output_ratio"] },
    play: { radial: ["contact.hole_clearance_mm"], fits: ["contact.fit"] },
    torque: { output: ["load.output_torque_Nm"], input: ["load.input_torque_Nm", "load.efficiency"] },
  },
  neededBy: ["fit"],
  optional: ["mechanism.crank_spacing_deg", "contact.hole_clearance_mm", "contact.fit"],
  catalogues: Object.fromEntries(["contact.pin_material", "contact.hole_material", "pin.material", "gear.pin_material", "gear.ring_material"]
    .flatMap((path) => [[path, "materials"], [`${path}.name`, "materials"]])),

  /** What an empty name of a table means: that of another box. It is shown only where something else was typed or is asked for. */
  alike: { "pin.material": "contact.pin_material" },

  /** The value that the theory gives for a box, where the other boxes allow it. */
  suggestions: {
    "mechanism.crank_spacing_deg": {
      formula: "360°/K",
      linked: true,
      value: ({ mechanism }) => 360 / mechanism.satellites,
    },
    "contact.hole_radius_mm": {
      formula: ({ contact } = {}) => {
        const sum = contact?.hole_clearance_mm ? "r_in + e + c" : "r_in + e";
        return inDiameters() ? `2(${sum})` : sum;
      },
      linked: true,
      needs: "contact.eccentricity_mm",
      value: ({ contact }) => tidy(contact?.pin_radius_mm + contact?.eccentricity_mm + (contact?.hole_clearance_mm ?? 0)),
      note: clearanceNote,
    },
  },

  /** The same design said in an option's own fields, so that choosing it starts from numbers. */
  seeds: {
    "cranks.list": ({ mechanism }) => ({ "mechanism.crank_angles_deg": cranksOf(mechanism).map(tidy) }),
    "ratio.teeth": ({ mechanism }) => teethOf(ratioOf(mechanism)),
    "ratio.ring": ({ mechanism }) => ({ "mechanism.output": "ring", "mechanism.output_ratio": tidy(ratioOf(mechanism) + 1) }),
    "torque.input": ({ mechanism, load }, { output_efficiency: losses } = {}) => {
      const efficiency = Number((losses?.total_efficiency ?? 1).toPrecision(3));
      const ratio = ratioOf(mechanism) + (mechanism.output === "ring" ? 1 : 0);
      return { "load.efficiency": efficiency, "load.input_torque_Nm": Number((load?.output_torque_Nm / (ratio * efficiency)).toPrecision(6)) };
    },
  },

  /** The sections in the order in which each needs the one before. */
  sections: ["cyclogram", "contact_force", "hertz", "geometry", ...WANTED.map(({ section }) => section).filter(Boolean)],

  /** A section that the answer has beside these, where the forces are solved. */
  solved: "load_sharing",

  /** One that it has where others than the pins are the output. */
  besides: ["members"],

  async ask({ post, input, filled, sections: all, tables }) {
    const wanted = wantedSections(input);
    const sections = all.filter((id) => wanted.includes(id) || !WANTED.some(({ section }) => section === id));
    const asked = documentOf(input, sections);
    const solved = isSolved(asked);
    refuseMore(filled.mechanism, solved ? MOST_PAIRS.turned : MOST_PAIRS.all);
    const optional = ["equal_sharing", ...approximated(filled.mechanism), ...(tables.has("force") ? ["curves"] : [])];
    return withoutFalseSafety(await post("/crank-planetary", {
      ...asked,
      ...(asked.load && { load: { ...asked.load, include: optional } }),
      include: [...sections, ...(sections.includes("contact_force") && (filled.mechanism.output ?? "pins") !== "pins" ? ["members"] : []), ...(solved ? [this.solved] : []), ...(solved && tables.has("cyclogram") ? ["real_cyclogram"] : []), ...(sections.includes("ring_mesh") ? ["ring_drawing"] : []), ...(sections.includes("envelope") && !sections.includes("mass") ? ["mass"] : []), "checks"],
    }));
  },

  /** What is asked after the first answer: solved under other torques. */
  limit: ["largest_torque"],

  mend: async ({ post, input, include = ["fixes", "combined"] }) => post("/crank-planetary", { ...documentOf(input), include }),

  /** What is usual of what is not known: the clearance, or that none is stated; modification and pins of a ring of pins. */
  usual: ({ parts = [], warnings = [] }) => {
    const said = (...codes) => parts.some(({ reason }) => codes.includes(reason)) || warnings.some(({ code }) => codes.includes(code));
    return [said("clearance_unknown", "perfect_parts") && "usual_fit", said("modification_unknown") && "usual_modification"].filter(Boolean);
  },

  /** Which way results are better. */
  better: { peak_force_N: -1, governing_pressure_MPa: -1, safety_factor: 1 },

  /** What a field may be sized for besides the checks. */
  targets: [{ pointer: "/hertz/safety_factor", quantity: "safety_factor", value: 1.5 }],

  verdict(answer, { input = {} } = {}) {
    const judged = answer.load_sharing ? "load_sharing" : "contact_force";
    return [
      cell(message("verdict.peak"), answer[judged], (section) => peakCell(section, input, judged)),
      cell(message("figure.driving"), answer.cyclogram, (section) => pairsCell(section, answer.load_sharing)),
      cell(quantityTitle("max_pressure_MPa"), answer.hertz, (section) => pressureCell(section, input)),
      ...inputCells(answer, input),
      ...(answer.mass?.mass_kg === undefined ? [] : [quantityCell(answer.mass, "mass_kg", message("mass.of"))]),
    ];
  },

  /** Values of the answer that figures, their tables or the checks show, or that only place the others. */
  elsewhere: [
    "locus", "pairs", "driving_count", "dead_zones_deg", "curves", "ring_drawing", "pins", "crank_angle_deg", "source", "source_code", "life", "forces",
  ],

  /** The drawing takes its forces from a figure's curves. */
  drawing: {
    create: createDrawing, section: "cyclogram", figure: "force", curves: curvesOf, moving: true, start: (answer) => judgedOf(answer)?.peak_crank_angle_deg,
    views: [
      { id: "disc", create: (about) => createDrawing({ ...about, alone: true }) },
      { id: "mesh", shows: (_input, { ring_drawing: teeth }) => Boolean(teeth), create: (about) => createDrawing({ ...about, alone: true, mesh: true }) },
      { id: "axis", shows: ({ contact, besides = {} }) => Boolean(contact?.contact_length_mm && placesOf(besides)), load: async () => (await import("./along.js")).axisDrawing },
    ],
  },

  figures: [
    {
      id: "force",
      section: "contact_force",
      path: "/crank-planetary/chart",
      follows: ({ data }) => pairsOf(data)[0] ?? null,
      enveloped: true,
      compared: true,
      body: figureOf("contact_force"),
      height: 400,
      tables: forceTables,
    },
    {
      id: "cyclogram",
      follows: ({ data, y }) => (data.type === "bar" ? y : null),
      section: "cyclogram",
      path: "/crank-planetary/chart",
      noted: true,
      body: figureOf("cyclogram"),
      height: ({ mechanism: { pins = 3, satellites = 1 } }) => 190 + 22 * Math.min(pins * satellites, MOST_ROWS),
      tables: phaseTables,
    },
    {
      id: "hertz",
      section: "hertz",
      path: "/hertz/chart",
      compared: true,
      body: hertzBody,
      height: 320,
    },
    { id: "workPeak", section: "contact_force", measures: "contact-force", body: forceBody },
  ],

  /** What the service makes of the design on the screen, the assembly at a crank angle: of cycloid discs whose modification is stated, and the pins of their ring; of involute teeth of known heights. */
  files({ requests }, angle) {
    const { include, ...design } = requests.find(({ path }) => path.endsWith(this.path))?.body ?? {};
    if (!shaped(design.gear) && !(design.gear?.modification && design.gear.ring_pin_radius_mm)) return [];
    const drawn = { path: "/export/dxf", titled: true };
    return [
      { id: "dxf", ...drawn, body: { design, crank_angle_deg: angle } },
      { id: "dxf_assembly", ...drawn, body: { design, parts: ["assembly"], crank_angle_deg: angle } },
      ...["carrier", "shaft", "housing"].map((part) => ({ id: `dxf_${part}`, ...drawn, body: { design, parts: [part] } })),
      ...["build123d", "step"].map((id) => ({ id, path: `/export/${id}`, body: { design } })),
    ];
  },

  /** What finds designs for a requirement. */
  propose: () => Promise.all([import("./propose.js"), import("../../views/propose.js")]),

  wanted: WANTED,
  beside: BESIDE,
  inputOf,
  /** No step of a safety that is not shown. */
  worked: ({ code }, { hertz }) => hertz?.safety || !/^(safety_|loads$|life_factor$)/.test(code),
  sentences,
  notes: ["yanchevskiy"],
};
