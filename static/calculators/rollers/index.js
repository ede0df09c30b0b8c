/** The calculator of swinging rollers: load sharing with position errors, and bending stress. */
import { enduranceOf, requestOf } from "../../lib/fatigue.js";
import { cell, statedCell } from "../../lib/verdict.js";
import { formatNumber, formatQuantity, written } from "../../lib/format.js";
import { message } from "../../messages/index.js";
import { figureText } from "../../service_texts.js";
import { createDrawing } from "./drawing.js";

function sharingCell({ forces_N: forces, loaded_rollers: loaded, load_nonuniformity: ratio }) {
  return {
    value: formatNumber(ratio, 4),
    note: message("verdict.rollersLoaded", { loaded, all: forces.length }),
    ...(loaded < forces.length && { level: loaded === 1 ? "bad" : "warning" }),
  };
}

/** The gaps that a tolerance means at worst: one roller ahead of the others by four times as much. */
function gapsOf(count, tolerance) {
  return Array.from({ length: count }, (_, i) => (i === 0 ? 0 : 4 * tolerance));
}

/** The verdict in plain words, sentences `[level, text]`. */
function sentences({ roller_strength: section }, { input: { position_tolerance_mm: tolerance } }) {
  if (!section) return [];
  const { loaded_rollers: loaded, load_nonuniformity: ratio, relative_position_error: delta } = section;
  const all = section.forces_N.length;
  const allCarry = loaded === all;
  return [
    [allCarry ? "good" : "warning", message(allCarry ? "words.allCarry" : "words.someCarry", { loaded, all, ratio: formatNumber(ratio, 4) })],
    tolerance > 0 && all > 1 && ["", message("words.tolerance", {
      limit: formatQuantity((tolerance * all) / 4 / delta, "mm", 3), tolerance: formatQuantity(tolerance, "mm", 3),
    })],
  ];
}

const PATH = "/roller-strength";
const TIRED = ["tensile_strength_MPa", "roller_rotates", "fatigue"];

const asked = ({ post, input }, ...include) => post(PATH, { ...requestOf(input, { endurance: TIRED }), include });

export default {
  id: "rollers",
  path: PATH,
  groups: ["load", "roller", "material", "requirements"],
  inline: ["requirements"],
  lines: {
    load: "output_torque_Nm, rollers hole_circle_radius_mm",
    roller: "diameter_mm cylinder_length_mm, eccentricity_mm",
    material: "youngs_modulus_GPa, yield_strength_MPa",
    requirements: "requirements.bending_safety",
    endurance: "endurance.fatigue, tensile_strength_MPa",
  },
  requirements: ["bending_safety"],
  hidden: ["include", "fixes_for"],
  choices: {
    errors: { tolerance: ["position_tolerance_mm"], gaps: ["gaps_mm"] },
    shear: { poisson: ["poissons_ratio"], modulus: ["shear_modulus_GPa"] },
  },

  /** The same design said in an option's own fields. */
  seeds: {
    "errors.gaps": ({ rollers, position_tolerance_mm: tolerance }) => ({
      gaps_mm: gapsOf(rollers ?? 1, tolerance ?? 0),
    }),
    "shear.modulus": ({ youngs_modulus_GPa: young, poissons_ratio: ratio }) => ({
      shear_modulus_GPa: Number((young / (2 * (1 + ratio))).toPrecision(6)),
    }),
  },

  /** What an empty design has besides what the service takes where nothing is said. */
  blank: { poissons_ratio: 0.3 },

  sections: ["roller_strength"],

  ask: async (asking) => ({ roller_strength: await asked(asking, "checks") }),
  better: { max_force_N: -1, load_nonuniformity: -1, bending_stress_MPa: -1, displacement_mm: -1 },
  judgedIn: "roller_strength",
  mend: async (asking) => ({ roller_strength: await asked(asking, "fixes") }),

  verdict: ({ roller_strength: section }) => [
    statedCell(section, "max_force_N", () => message("verdict.rollerMean", { mean: written(section, "mean_force_N") })),
    cell(message("verdict.nonuniformity"), section, sharingCell),
    statedCell(section, "bending_stress_MPa", () => message("verdict.bendingMoment", { moment: written(section, "bending_moment_Nm") }), figureText("bending_stress")),
  ],

  elsewhere: [],

  drawing: { create: createDrawing, section: "roller_strength" },

  figures: [
    {
      id: "rollers",
      section: "roller_strength",
      path: "/roller-strength/chart",
      compared: true,
      height: 940,
      /** A click on a curve over l/d sets the length. */
      sets: ({ x, data: { xaxis } }, { diameter_mm: diameter, cylinder_length_mm: length }) =>
        ["cylinder_length_mm", xaxis === "x2" ? length : Number((x * diameter).toPrecision(3))],
    },
  ],

  wanted: [enduranceOf({ tensile_strength_MPa: {}, roller_rotates: {} })],
  sentences,
  notes: ["ovsyannikov"],
};
