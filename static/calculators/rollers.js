/** The calculator of swinging rollers: load sharing with position errors, and bending stress. */
import { formatNumber, formatQuantity, quantityParts, shownDigits } from "../format.js";
import { message } from "../messages/index.js";
import { workedSteps } from "../worked/rollers.js";

function forceCell(section) {
  const label = message("verdict.rollerForce");
  if (!section) return { label };
  return {
    label,
    ...quantityParts(section.max_force_N, "N", Math.min(5, shownDigits(section.accuracy.relative_error))),
    note: message("verdict.rollerMean", { mean: formatQuantity(section.mean_force_N, "N", 4) }),
  };
}

function sharingCell(section) {
  const label = message("verdict.nonuniformity");
  if (!section) return { label };
  const all = section.forces_N.length;
  const loaded = section.loaded_rollers;
  return {
    label,
    value: formatNumber(section.load_nonuniformity, 4),
    note: message("verdict.rollersLoaded", { loaded, all }),
    ...(loaded < all && { level: loaded === 1 ? "bad" : "warning" }),
  };
}

function stressCell(section) {
  const label = message("verdict.bendingStress");
  if (!section) return { label };
  return {
    label,
    ...quantityParts(section.bending_stress_MPa, "MPa", 4),
    note: message("verdict.bendingMoment", { moment: formatQuantity(section.bending_moment_Nm, "N·m", 4) }),
  };
}

export default {
  id: "rollers",
  path: "/roller-strength",
  groups: ["load", "roller", "material"],
  inline: [],
  hidden: [],
  choices: [
    {
      id: "errors",
      options: [
        { id: "tolerance", fields: ["position_tolerance_mm"] },
        { id: "gaps", fields: ["gaps_mm"] },
      ],
    },
    {
      id: "shear",
      options: [
        { id: "poisson", fields: ["poissons_ratio"] },
        { id: "modulus", fields: ["shear_modulus_GPa"] },
      ],
    },
  ],
  catalogues: {},
  suggestions: {},

  /** The same design said in an option's own fields. */
  seeds: {
    "errors.gaps": ({ rollers, position_tolerance_mm: tolerance }) => ({
      gaps_mm: Array.from({ length: rollers ?? 1 }, (_, i) => (i === 0 ? 0 : 4 * (tolerance ?? 0))),
    }),
    "shear.modulus": ({ youngs_modulus_GPa: young, poissons_ratio: ratio }) => ({
      shear_modulus_GPa: Number((young / (2 * (1 + ratio))).toPrecision(6)),
    }),
  },

  sections: ["roller_strength"],

  async ask({ post, input }) {
    return { roller_strength: await post("/roller-strength", input) };
  },

  verdict: ({ roller_strength: section }) => [forceCell(section), sharingCell(section), stressCell(section)],

  elsewhere: ["forces_N"],

  drawing: { load: () => import("../drawing/rollers.js"), section: "roller_strength" },

  figures: [
    {
      id: "rollers",
      section: "roller_strength",
      path: "/roller-strength/chart",
      compared: true,
      body: (input) => input,
      height: () => 940,
      tables: ({ roller_strength: { forces_N: forces } }) => [{
        title: message("figure.rollerForces"),
        columns: [{ title: message("figure.roller") }, { title: message("figure.rollerForce"), unit: "N" }],
        rows: forces.map((force, i) => [i + 1, force]),
      }],
    },
    {
      id: "workSharing",
      section: "roller_strength",
      path: "/work-precision/chart",
      onDemand: true,
      body: (input) => ({ calculation: "roller_sharing", input: input }),
      height: () => 620,
    },
  ],

  worked: workedSteps,
  notes: ["ovsyannikov"],
  start: {},
};
