/** A small service schema with every kind of field, as FastAPI writes it. */
import { formModel } from "../../static/lib/schema_form.js";

export const OPENAPI = {
  paths: {
    "/api/v1/job": {
      post: { requestBody: { content: { "application/json": { schema: { $ref: "#/components/schemas/Job" } } } } },
    },
  },
  components: {
    schemas: {
      Job: {
        type: "object",
        required: ["mechanism"],
        properties: {
          mechanism: { $ref: "#/components/schemas/Mechanism" },
          contact: { anyOf: [{ $ref: "#/components/schemas/Contact" }, { type: "null" }], title: "Contact" },
        },
      },
      Mechanism: {
        type: "object",
        title: "Mechanism",
        required: ["pins"],
        properties: {
          pins: { type: "integer", title: "Pins", "x-symbol": "N", minimum: 1, maximum: 40, "x-step": 1 },
          satellites: { type: "integer", title: "Satellites", default: 2, minimum: 1 },
          crank_spacing_deg: { anyOf: [{ type: "number", maximum: 360 }, { type: "null" }], title: "Spacing", default: null },
          crank_angles_deg: {
            anyOf: [{ type: "array", items: { type: "number", minimum: -360 } }, { type: "null" }], title: "Angles",
          },
          ratio: { anyOf: [{ type: "number", exclusiveMinimum: 0 }, { type: "null" }], title: "Ratio" },
          satellite_teeth: { anyOf: [{ type: "integer", minimum: 1 }, { type: "null" }], title: "Satellite teeth" },
          ring_teeth: { anyOf: [{ type: "integer" }, { type: "null" }], title: "Ring teeth" },
          include: { type: "array", items: { type: "string" }, default: [] },
        },
      },
      Contact: {
        type: "object",
        required: ["pin_material", "pin_radius_mm"],
        properties: {
          pin_radius_mm: { type: "number", title: "Pin radius", exclusiveMinimum: 0, "x-step": 0.5, description: "r" },
          pin_material: {
            anyOf: [{ type: "string" }, { $ref: "#/components/schemas/Material" }], title: "Pin material",
          },
          dynamic_factor: { type: "number", default: 1.0, minimum: 1, "x-advanced": true },
        },
      },
      Material: {
        type: "object",
        required: ["youngs_modulus_GPa"],
        properties: {
          youngs_modulus_GPa: { type: "number", title: "Young's modulus", exclusiveMinimum: 0 },
          allowable_pressure_MPa: { anyOf: [{ type: "number" }, { type: "null" }], title: "Allowable" },
          layers: { anyOf: [{ enum: ["flat", "upright"], type: "string" }, { type: "null" }], title: "Layers" },
        },
      },
    },
  },
};

export const MODEL = formModel(OPENAPI, {
  path: "/api/v1/job",
  groups: ["mechanism", "contact"],
  hidden: ["mechanism.include"],
  choices: {
    cranks: { spacing: ["mechanism.crank_spacing_deg"], list: ["mechanism.crank_angles_deg"] },
    ratio: { value: ["mechanism.ratio"], teeth: ["mechanism.satellite_teeth", "mechanism.ring_teeth"] },
  },
  optional: ["mechanism.crank_spacing_deg"],
});

export const INPUT = {
  mechanism: { pins: 3, ratio: 20 },
  contact: { pin_radius_mm: 5, pin_material: "steel" },
};

/** What the service's schema fills in where an input leaves it out. */
const DEFAULTS = {
  "crank-planetary": {
    mechanism: { satellites: 2, initial_crank_angle_deg: 0 },
    load: { force_exponent: 1 },
    contact: {
      pin_material: "steel_bearing", hole_material: "steel_through_hardened", dynamic_factor: 1, distribution_factor: 1,
    },
  },
  rollers: { stress_concentration: 1 },
  precession: {},
};

export function filled(calculator, input) {
  const defaults = DEFAULTS[calculator];
  const parts = Object.entries(input).map(([name, part]) =>
    [name, typeof defaults[name] === "object" ? { ...defaults[name], ...part } : part]);
  return { ...defaults, ...Object.fromEntries(parts) };
}
