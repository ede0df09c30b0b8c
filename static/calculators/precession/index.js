/** The calculator of the precessional gear: contact lines, load of the mesh, deflection of the shaft. */
import { enduranceOf, requestOf } from "../../lib/fatigue.js";
import { cell, stated, statedCell } from "../../lib/verdict.js";
import { formatNumber, formatQuantity, quantityParts, tidy, unitOf } from "../../lib/format.js";
import { message, quantityTitle } from "../../messages/index.js";
import { createDrawing } from "./drawing.js";

const GEAR = [
  "roller_circle_radius_mm", "roller_radius_mm", "nutation_angle_deg", "ratio_u12", "rollers", "wheel",
];

const PATH = "/precession/shaft-deflection";
const TIRED = ["tensile_strength_MPa", "load_rotates_with_shaft", "fatigue"];

const shaftBody = (input, ...include) => ({ ...requestOf(input, { endurance: TIRED, lines: ["line_contact"] }), include });

function pick(input, names) {
  return Object.fromEntries(names.filter((name) => name in input).map((name) => [name, input[name]]));
}

const LINES = {
  "line_contact.mating_radius_mm": { required: true },
  "line_contact.roller_material": { required: true },
  "line_contact.mating_material": { required: true },
  "requirements.pitting_safety": { advanced: true },
};

/** The lines are asked for on the flanks that the torque loads. */
function lineBody(input) {
  const sign = Math.sign(input.torque_Nm ?? 0);
  return { ...pick(input, GEAR), ...(sign !== 0 && { torque_sign: sign }) };
}

function loadBody(input) {
  return pick(input, [...GEAR, "torque_Nm", "reference_z_mm"]);
}

const forceText = (force) => formatQuantity(Math.hypot(...force), "N");

/** The verdict in plain words, sentences `[level, text]`. */
function sentences({ contact_line: line, meshing_load: load, shaft_deflection: shaft }, { input }) {
  const arms = (line?.lines ?? []).flatMap(({ phi_min_deg: from, phi_max_deg: to }) => [from, to])
    .map((phi) => Math.abs(Math.sin((phi * Math.PI) / 180)));
  return [
    line && ["good", message("words.mesh", { count: line.lines.length, length: formatQuantity(line.total_length_mm, "mm") })],
    load && ["", message("words.evenLoad", { ratio: formatNumber(Math.max(...arms) / Math.min(...arms), 3) })],
    shaft && ["", message("words.bends", {
      deflection: formatQuantity(shaft.deflection_C_mm.total, "mm", 3),
      part: quantityParts(Math.round((input.bearing_distance_mm + input.overhang_mm) / shaft.deflection_C_mm.total), "", 3).value,
    })],
  ];
}

function lineTables({ contact_line: { lines } }) {
  const columns = [
    "position_angle_deg", "z_min_mm", "z_max_mm", "phi_min_deg", "phi_max_deg", "length_mm",
  ];
  return [{
    title: message("figure.contactLines"),
    columns: columns.map((name) => ({ title: quantityTitle(name), unit: unitOf(name) })),
    rows: lines.map((line) => columns.map((name) => line[name])),
  }];
}

/** Number of evenly spaced rollers of which these are neighbours; none where they are not. */
function wheelOf(rollers) {
  const angles = rollers.map((roller) => roller.position_angle_deg);
  const total = tidy(360 / (angles[1] - angles[0]));
  const even = angles.every((angle, i) => Math.abs(angle - angles[0] - (360 * i) / total) < 1e-9);
  return Number.isInteger(total) && total > 0 && even ? total : undefined;
}

/** What all rollers have in common; nothing where they differ. */
function same(rollers, name) {
  return new Set(rollers.map((roller) => roller[name])).size === 1 ? rollers[0][name] : undefined;
}

export default {
  id: "precession",
  path: PATH,
  groups: ["gear", "rollers", "load", "shaft", "requirements"],
  inline: ["wheel", "requirements"],
  lines: {
    gear: "ratio_u12, roller_radius_mm roller_circle_radius_mm, nutation_angle_deg",
    rollers: "wheel.rollers_total",
    load: "torque_Nm",
    shaft: "shaft_diameter_mm, bearing_distance_mm",
    requirements: "requirements.bending_safety, requirements.max_deflection_mm",
    endurance: "endurance.fatigue, tensile_strength_MPa",
    lines: "line_contact.roller_material, line_contact.mating_material",
  },
  requirements: ["bending_safety", "max_deflection_mm", "max_slope_mrad"],
  hidden: ["include", "fixes_for", "line_contact"],
  catalogues: Object.fromEntries(["line_contact.roller_material", "line_contact.mating_material"]
    .flatMap((path) => [[path, "materials"], [`${path}.name`, "materials"]])),
  choices: {
    rollersBy: {
      list: ["rollers"],
      wheel: ["rollers_total", "rollers_in_mesh", "position_angle_deg", "z_min_mm", "z_max_mm"].map((name) => `wheel.${name}`),
    },
    shaftBy: { diameter: ["shaft_diameter_mm"], sections: ["shaft_sections"] },
  },
  optional: ["wheel.rollers_in_mesh"],

  /** The same design said in an option's own fields. */
  seeds: {
    "rollersBy.wheel": ({ rollers = [] }) => ({
      "wheel.rollers_total": wheelOf(rollers),
      "wheel.rollers_in_mesh": rollers.length || undefined,
      "wheel.position_angle_deg": rollers[0]?.position_angle_deg,
      "wheel.z_min_mm": same(rollers, "z_min_mm"),
      "wheel.z_max_mm": same(rollers, "z_max_mm"),
    }),
    "rollersBy.list": ({ wheel }) => wheel && {
      rollers: Array.from({ length: wheel.rollers_in_mesh ?? wheel.rollers_total }, (_, i) => ({
        position_angle_deg: tidy(wheel.position_angle_deg + (360 * i) / wheel.rollers_total),
        z_min_mm: wheel.z_min_mm,
        z_max_mm: wheel.z_max_mm,
      })),
    },
    "shaftBy.sections": ({ bearing_distance_mm: a, overhang_mm: b, shaft_diameter_mm: diameter }) => ({
      shaft_sections: [
        { length_mm: a, diameter_mm: diameter },
        { length_mm: b, diameter_mm: diameter },
      ],
    }),
    "shaftBy.diameter": ({ shaft_sections: sections = [] }) => ({
      shaft_diameter_mm: Math.min(...sections.map(({ diameter_mm: diameter }) => diameter)),
    }),
  },

  /** Each says more than the one before, and is refused where that is. */
  sections: ["contact_line", "meshing_load", "shaft_deflection"],

  async ask({ post, input, sections }) {
    const bodies = {
      contact_line: ["/precession/contact-line", lineBody(input)],
      meshing_load: ["/precession/meshing-load", loadBody(input)],
      shaft_deflection: [PATH, shaftBody(input, "checks")],
    };
    const answer = {};
    for (const id of sections) answer[id] = await post(...bodies[id]);
    return answer;
  },

  better: { max_line_load_N_per_mm: -1, "deflection_B_mm.total": -1, "deflection_C_mm.total": -1 },
  judgedIn: "shaft_deflection",
  mend: async ({ post, input }) => ({ shaft_deflection: await post(PATH, shaftBody(input, "fixes")) }),

  verdict: ({ contact_line: line, meshing_load: load, shaft_deflection: shaft }) => [
    statedCell(line, "total_length_mm", () => message("line.rollers", { count: line.lines.length }), message("verdict.lineLength")),
    statedCell(load, "max_line_load_N_per_mm", () => message("verdict.meshForce", { force: forceText(load.force_N) })),
    cell(quantityTitle("deflection_C_mm"), shaft, ({ deflection_C_mm: C, deflection_B_mm: B }) => ({
      ...stated(shaft, "deflection_C_mm", C.total),
      note: message("verdict.deflectionB", {
        deflection: formatQuantity(B.total, "mm", 3), B: forceText(shaft.reaction_B_N), C: forceText(shaft.reaction_C_N),
      }),
    })),
  ],

  elsewhere: ["lines"],

  drawing: { create: createDrawing, section: "contact_line", figure: "shaft", tall: true, least: 480 },

  figures: [
    {
      id: "contactLines",
      section: "contact_line",
      path: "/precession/contact-line/chart",
      body: lineBody,
      sequenced: true,
      height: 840,
      tables: lineTables,
    },
    {
      id: "lineLoad",
      section: "meshing_load",
      path: "/precession/meshing-load/chart",
      compared: true,
      sequenced: true,
      body: loadBody,
      height: 360,
    },
    {
      id: "shaft",
      section: "shaft_deflection",
      path: "/precession/shaft-deflection/chart",
      compared: true,
      height: 700,
    },
    { id: "workLength", section: "contact_line", measures: "precession/contact-line", body: lineBody },
    { id: "workShaft", section: "shaft_deflection", measures: "precession/shaft-deflection" },
  ],

  wanted: [
    enduranceOf({ tensile_strength_MPa: {}, load_rotates_with_shaft: {} }),
    {
      id: "lines",
      fields: LINES,
      starts: () => ({ "line_contact.roller_material": "steel_bearing", "line_contact.mating_material": "steel_case_hardened" }),
    },
  ],
  sentences,
  notes: ["khatetovsky"],
};
