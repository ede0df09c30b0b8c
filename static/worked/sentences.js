/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatNumber, formatQuantity, quantityParts } from "../format.js";
import { message } from "../messages/index.js";
import { impossibleWords, judged, wantedWords } from "./contact.js";

const say = (key, values) => message(`words.${key}`, values);

function transmission({ min_driving: least, max_driving: most, mean_driving: mean, dead_centres_deg: dead, pairs }) {
  if (dead.length > 0) {
    const named = dead.slice(0, 4).map((angle) => formatQuantity(angle, "°", 5)).join(", ");
    return ["bad", say("dead", { angles: named + (dead.length > 4 ? ` ${message("verdict.more")}` : "") })];
  }
  const values = { least, most, all: pairs.length, mean: formatNumber(mean, 4) };
  return ["good", say(least === most ? "steady" : "transmits", values)];
}

function evenness({ peak_force_N: peak, equal_sharing_peak_N: equal }) {
  return ["", say("even", { peak: formatQuantity(peak, "N", 4), share: formatNumber(peak / equal, 3) })];
}

/** The force grows with the torque, the pressure of a line contact with its root. */
function pressure(answer, context) {
  const { pressure: governing, loose, level, body, limit, safety, torque } = judged(answer);
  if (governing === undefined) return [["warning", say("noTheory")]];
  const shown = say("pressure", { pressure: formatQuantity(governing, "MPa", 4) });
  const values = body && { limit: formatQuantity(limit, "MPa", 4), safety: formatNumber(safety, 3) };
  const wanted = wantedWords(answer, context).join(" ");
  if (level === "bad") {
    return [
      ["bad", `${shown} ${say(`over.${body}`, values)} ${say("help")}`],
      wanted && ["warning", wanted],
      torque && ["", say("reduce", { factor: formatNumber(torque, 3) })],
    ];
  }
  if (wanted) return [["warning", `${shown} ${wanted}`], body && ["", say(`alone.${body}`, values)]];
  return [
    [level, `${shown} ${say(`within.${body}`, values)}${loose ? ` ${say("loose")}` : ""}`],
    torque && ["", say("reserve", { factor: formatNumber(torque, 3) })],
  ];
}

/** Of what cannot be built, why; only its kinematics and its forces are said besides. */
function crankPlanetary(answer, context) {
  const { cyclogram, contact_force: force, hertz } = answer;
  const reasons = impossibleWords(answer, context.input);
  const [level, transmitted] = cyclogram ? transmission(cyclogram) : [];
  return [
    ...reasons.map((reason) => ["bad", reason]),
    transmitted && [reasons.length > 0 && level === "good" ? "" : level, transmitted],
    force?.equal_sharing_peak_N !== undefined && evenness(force),
    ...(hertz && reasons.length === 0 ? pressure(answer, context) : []),
  ];
}

function rollers({ roller_strength: section }, { input }) {
  if (!section) return [];
  const { loaded_rollers: loaded, load_nonuniformity: ratio, relative_position_error: delta } = section;
  const all = section.forces_N.length;
  const tolerance = input.position_tolerance_mm;
  return [
    [loaded === all ? "good" : "warning", say(loaded === all ? "allCarry" : "someCarry", {
      loaded, all, ratio: formatNumber(ratio, 4),
    })],
    tolerance > 0 && all > 1 && ["", say("tolerance", {
      limit: formatQuantity((tolerance * all) / 4 / delta, "mm", 3),
      tolerance: formatQuantity(tolerance, "mm", 3),
    })],
    ["", say("bending", { stress: formatQuantity(section.bending_stress_MPa, "MPa", 4) })],
  ];
}

function precession({ contact_line: line, meshing_load: load, shaft_deflection: shaft }, { input }) {
  const arms = (line?.lines ?? []).flatMap(({ phi_min_deg: from, phi_max_deg: to }) => [from, to])
    .map((phi) => Math.abs(Math.sin((phi * Math.PI) / 180)));
  return [
    line && ["good", say("mesh", { count: line.lines.length, length: formatQuantity(line.total_length_mm, "mm", 4) })],
    load && ["", say("evenLoad", { ratio: formatNumber(Math.max(...arms) / Math.min(...arms), 3) })],
    shaft && ["", say("bends", {
      deflection: formatQuantity(shaft.deflection_C_mm.total, "mm", 3),
      part: quantityParts(
        Math.round((input.bearing_distance_mm + input.overhang_mm) / shaft.deflection_C_mm.total), "", 3,
      ).value,
    })],
  ];
}

const VERDICTS = { "crank-planetary": crankPlanetary, rollers, precession };

/**
 * Sentences on an answer, each `[level, text]`; level as in the verdict, "" for none. `context`:
 * the `input` and `materialOf(path, given)`.
 */
export function sentencesOf(calculator, answer, context) {
  return VERDICTS[calculator](answer, context).filter(Boolean);
}
