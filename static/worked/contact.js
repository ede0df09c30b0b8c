/**
 * How the contact of pin and hole stands: each body by its own limit under the pressure that
 * governs, and what makes a design impossible. No DOM.
 */
import { formatNumber, formatQuantity, tidy } from "../format.js";
import { message, translated } from "../messages/index.js";

/** Half-width over pin radius up to which Hertz's pressure holds to 1 %, as in core.hertz. */
export const NARROW = 0.159;

const BODIES = ["pin", "hole"];

/** Warnings of what cannot be built. */
export const IMPOSSIBLE = ["interference", "holes_overlap", "pins_overlap"];

export function impossible({ warnings = [] }) {
  return warnings.map(({ code }) => code).filter((code) => IMPOSSIBLE.includes(code));
}

/** An answer as it is shown: no safety of what cannot be built. */
export function withoutFalseSafety(answer) {
  if (!answer.hertz || impossible(answer).length === 0) return answer;
  const { safety, safety_factor, ...hertz } = answer.hertz;
  return { ...answer, hertz };
}

/** Why it cannot be built, a sentence each. */
export function impossibleWords(answer, { contact }) {
  return impossible(answer).map((code) => message(`verdict.impossible.${code}`, {
    value: formatQuantity(contact.hole_radius_mm, "mm"),
    limit: formatQuantity(tidy(contact.pin_radius_mm + contact.eccentricity_mm), "mm"),
  }));
}

/**
 * `level` as in the verdict; `body` that governs ("pin", "hole", "both"; none where no limit is
 * known) with its `limit` and `safety`; `unknown`: the bodies without a limit; `loose`: there is a
 * clearance, which the force does not count; `torque`: how many times the torque reaches the limit,
 * where that follows from Hertz's pressure alone.
 */
export function judged({ hertz, warnings = [] }) {
  const {
    governing_pressure_MPa: pressure, conformal_pressure_MPa: conformal, half_width_ratio: ratio, safety = [],
  } = hertz;
  if (pressure === undefined) return { level: "warning", unknown: [] };
  const unknown = BODIES.filter((body) => !safety.some((one) => one.body === body));
  const least = Math.min(...safety.map((one) => one.safety_factor));
  const governing = safety.filter((one) => one.safety_factor === least);
  const loose = warnings.some(({ code }) => code === "clearance");
  const holds = !loose && (conformal !== undefined || ratio <= NARROW);
  const hertzian = !loose && conformal === undefined && ratio * Math.max(1, least) <= NARROW;
  return {
    pressure,
    unknown,
    loose,
    level: least < 1 ? "bad" : unknown.length > 0 || !holds ? "warning" : "good",
    ...(governing.length > 0 && {
      body: governing.length > 1 ? "both" : governing[0].body, limit: governing[0].limit_MPa, safety: least,
    }),
    ...(unknown.length === 0 && hertzian && { torque: least ** 2 }),
  };
}

/** Titles of the materials of both bodies. */
function materials({ contact }, materialOf) {
  return Object.fromEntries(BODIES.map((body) => {
    const { title } = materialOf(`contact.${body}_material`, contact[`${body}_material`]) ?? {};
    return [body, title ? translated(title) : message("verdict.ownMaterial")];
  }));
}

/** What is asked of the user where a body has no limit, a sentence each. */
export function wantedWords(answer, { input, materialOf }) {
  if (!answer.hertz) return [];
  return judged(answer).unknown.map((body) => message(`verdict.wanted.${body}`, materials(input, materialOf)));
}

/** The judgement in a few words. */
export function judgement(answer, { input, materialOf }) {
  const { pressure, unknown, loose, level, body, limit, safety } = judged(answer);
  if (pressure === undefined) return message("verdict.noTheory");
  const limited = body && message(`verdict.${level === "bad" ? "over" : "within"}.${body}`, {
    limit: formatQuantity(limit, "MPa", 4),
  });
  if (unknown.length === 0) {
    const factor = message("verdict.safety", { safety: formatNumber(safety, 3) });
    return [limited, factor, ...(loose ? [message("verdict.loose")] : [])].join("; ");
  }
  const missing = message(`verdict.unknown.${unknown.length > 1 ? "both" : unknown[0]}`, materials(input, materialOf));
  return level === "bad" ? `${limited}; ${missing}` : missing;
}
