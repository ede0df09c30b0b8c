/**
 * The crank-planetary calculator: mechanism, load and contact as one job.
 *
 * Only what the schema cannot say stands here: which fields exclude each other, the values that the
 * theory suggests, what the verdict reads from the answer, which figures there are.
 */
import { formatNumber, formatQuantity, quantityParts, shownDigits, tidy } from "../format.js";
import { message } from "../messages/index.js";
import { impossible, impossibleWords, judged, judgement, wantedWords, withoutFalseSafety } from "../worked/contact.js";
import { workedSteps } from "../worked/crank_planetary.js";

const MOST_ROWS = 24;

function digitsOf(section) {
  return shownDigits(section.accuracy.relative_error);
}

/** /cyclogram and /contact-force ask the mechanism's fields beside their own. */
function forceBody({ mechanism: { revolutions, ...mechanism }, load }) {
  return { ...mechanism, ...load };
}

function hertzBody({ contact: { eccentricity_mm, ...contact } }, answer) {
  return { ...contact, force_N: answer.contact_force.peak_force_N };
}

function positive(value) {
  return value > 0 ? value : NaN;
}

/** Tooth numbers of exactly this ratio, with a difference as small as usual; none where there are none. */
function teethOf(ratio) {
  const difference = [2, 1, 3, 4, 5, 6, 7, 8, 9, 10].find((d) => Number.isInteger(tidy(ratio * d)));
  if (!difference) return {};
  const satellite = tidy(ratio * difference);
  return { "mechanism.satellite_teeth": satellite, "mechanism.ring_teeth": satellite + difference };
}

function pairsCell(section) {
  const label = message("verdict.pairs");
  if (!section) return { label };
  const { min_driving: least, max_driving: most, mean_driving: mean, pairs } = section;
  const dead = section.dead_centres_deg;
  if (dead.length > 0) {
    const angles = dead.slice(0, 3).map((angle) => formatQuantity(angle, "°", 5)).join(", ");
    const more = dead.length > 3 ? ` ${message("verdict.more")}` : "";
    return {
      label,
      value: `0–${most}`,
      note: message("verdict.dead", { angles: angles + more }),
      level: "bad",
    };
  }
  return {
    label,
    value: least === most ? String(least) : `${least}–${most}`,
    note: message("verdict.pairsMean", {
      all: new Set(pairs.map(({ satellite, pin }) => `${satellite}/${pin}`)).size,
      mean: formatNumber(mean, 4),
    }),
  };
}

function peakCell(section) {
  const label = message("verdict.peak");
  if (!section) return { label };
  const digits = digitsOf(section);
  return {
    label,
    ...quantityParts(section.peak_force_N, "N", digits),
    note: message("verdict.peakAt", {
      angle: formatQuantity(section.peak_crank_angle_deg, "°", Math.min(5, digits)),
      ...section.peak_pair,
    }),
  };
}

function pressureCell(answer, context) {
  const label = message("verdict.pressure");
  if (!answer.hertz) return { label };
  const { pressure, level } = judged(answer);
  const value = pressure === undefined ? {} : quantityParts(pressure, "MPa", Math.min(4, digitsOf(answer.hertz)));
  return impossible(answer).length > 0
    ? { label, ...value, level: "bad", note: message("state.refused") }
    : { label, ...value, level, note: judgement(answer, context) };
}

function columns(...names) {
  const unit = { from: "°", to: "°" };
  return names.map((name) => ({ title: message(`figure.${name}`), unit: unit[name] }));
}

function phaseTables({ cyclogram }) {
  return [
    {
      title: message("figure.phases"),
      columns: columns("satellite", "pin", "from", "to"),
      rows: cyclogram.pairs.flatMap(({ satellite, pin, driving_deg: driving }) =>
        driving.map(([from, to]) => [satellite, pin, from, to])),
    },
    {
      title: message("figure.counts"),
      columns: columns("from", "to", "driving"),
      rows: cyclogram.driving_count.map(({ from_deg: from, to_deg: to, pairs }) => [from, to, pairs]),
    },
  ];
}

function forceTables({ contact_force: { curves } }) {
  return [{
    title: message("figure.forces"),
    columns: [
      { title: message("figure.crankAngle"), unit: "°" },
      ...curves.pairs.map((pair) => ({ title: message("figure.pairForce", pair), unit: "N" })),
    ],
    rows: curves.crank_angle_deg.map((angle, i) => [angle, ...curves.force_N.map((pair) => pair[i])]),
  }];
}

/** The approximation of the peak is asked for only where it is stated: 3 to 5 pins, 1 or 2 satellites. */
function approximated({ mechanism: { pins, satellites = 2 } }) {
  return pins >= 3 && pins <= 5 && satellites <= 2 ? ["approximation"] : [];
}

export default {
  id: "crank-planetary",
  path: "/crank-planetary",
  groups: ["mechanism", "load", "contact"],
  hidden: ["load.include", "load.samples", "include", "crank_angle_deg"],
  choices: [
    {
      id: "cranks",
      options: [
        { id: "spacing", fields: ["mechanism.crank_spacing_deg"], optional: ["mechanism.crank_spacing_deg"] },
        { id: "list", fields: ["mechanism.crank_angles_deg"] },
      ],
    },
    {
      id: "ratio",
      options: [
        { id: "value", fields: ["mechanism.ratio"] },
        { id: "teeth", fields: ["mechanism.satellite_teeth", "mechanism.ring_teeth"] },
      ],
    },
    {
      id: "torque",
      options: [
        { id: "output", fields: ["load.output_torque_Nm"] },
        { id: "input", fields: ["load.input_torque_Nm", "load.efficiency"] },
      ],
    },
  ],
  catalogues: { "contact.pin_material": "materials", "contact.hole_material": "materials" },

  /** The value that the theory gives for a box, where the other boxes allow it. */
  suggestions: {
    "mechanism.crank_spacing_deg": {
      formula: "360°/K",
      value: ({ mechanism }) => 360 / (mechanism?.satellites ?? 2),
    },
    "contact.hole_radius_mm": {
      formula: "r_in + e",
      value: ({ contact }) => tidy(contact?.pin_radius_mm + contact?.eccentricity_mm),
    },
    "contact.eccentricity_mm": {
      formula: "r_out − r_in",
      value: ({ contact }) => positive(tidy(contact?.hole_radius_mm - contact?.pin_radius_mm)),
    },
  },

  /** The same design said in an option's own fields, so that choosing it starts from numbers. */
  seeds: {
    "cranks.list": ({ mechanism }) => {
      const count = mechanism?.satellites ?? 2;
      const spacing = mechanism?.crank_spacing_deg ?? 360 / count;
      return {
        "mechanism.crank_angles_deg": Array.from({ length: count }, (_, j) => tidy(j * spacing)),
      };
    },
    "ratio.teeth": ({ mechanism }) => teethOf(mechanism?.ratio),
    "torque.input": ({ mechanism, load }) => {
      const { ratio, satellite_teeth: satellite, ring_teeth: ring } = mechanism ?? {};
      const u = ratio ?? satellite / (ring - satellite);
      return { "load.efficiency": 1, "load.input_torque_Nm": tidy(load?.output_torque_Nm / u) };
    },
  },

  /** The sections in the order in which each needs the one before. */
  sections: ["cyclogram", "contact_force", "hertz", "geometry"],

  async ask({ post, input, sections, tables }) {
    const optional = ["equal_sharing", ...approximated(input), ...(tables.has("force") ? ["curves"] : [])];
    return withoutFalseSafety(await post("/crank-planetary", {
      mechanism: input.mechanism,
      ...(sections.includes("contact_force") && { load: { ...input.load, include: optional } }),
      ...(sections.includes("hertz") && { contact: input.contact }),
      include: sections,
    }));
  },

  verdict(answer, context) {
    return [peakCell(answer.contact_force), pairsCell(answer.cyclogram), pressureCell(answer, context)];
  },

  /** Why the design cannot be built, and what has to be given before it can be judged: sentences. */
  impossible: (answer, { input }) => impossibleWords(answer, input),
  wanted: wantedWords,

  /** Values of the answer that the figures and their tables show, or that only place the others. */
  elsewhere: ["pairs", "driving_count", "dead_zones_deg", "curves", "pins", "crank_angle_deg", "source"],

  /** The drawing takes its forces from a figure's curves. */
  drawing: { load: () => import("../drawing/crank_planetary.js"), section: "cyclogram", figure: "force", moving: true },

  figures: [
    {
      id: "cyclogram",
      follows: ({ data, y }) => (data.type === "bar" ? y : null),
      section: "cyclogram",
      path: "/cyclogram/chart",
      body: ({ mechanism }) => mechanism,
      height: ({ mechanism }) => {
        const rows = (mechanism?.pins ?? 3) * (mechanism?.satellites ?? 2);
        return 190 + 22 * Math.min(rows, MOST_ROWS);
      },
      tables: phaseTables,
    },
    {
      id: "force",
      section: "contact_force",
      path: "/contact-force/chart",
      follows: ({ data }) => (data.mode === "lines" ? data.name : null),
      compared: true,
      body: forceBody,
      height: () => 400,
      tables: forceTables,
    },
    {
      id: "hertz",
      section: "hertz",
      path: "/hertz/chart",
      compared: true,
      body: hertzBody,
      height: () => 320,
    },
    {
      id: "workPeak",
      section: "contact_force",
      path: "/work-precision/chart",
      onDemand: true,
      body: (input) => ({ calculation: "peak_force", input: forceBody(input) }),
      height: () => 620,
    },
  ],

  worked: workedSteps,
  notes: ["yanchevskiy"],

  /** A design to open with, should the service's examples be empty. */
  start: {
    mechanism: { pins: 3, satellites: 2, ratio: 20 },
    load: { output_torque_Nm: 50, pin_circle_radius_mm: 32.5 },
    contact: {
      contact_length_mm: 10,
      pin_radius_mm: 5,
      eccentricity_mm: 1.5,
      hole_radius_mm: 6.5,
      pin_material: { youngs_modulus_GPa: 210, poissons_ratio: 0.3 },
      hole_material: { youngs_modulus_GPa: 210, poissons_ratio: 0.3 },
    },
  },
};
