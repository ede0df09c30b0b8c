/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message } from "../../messages/index.js";
import { impossibleWords, judged, wantedWords } from "./judgement.js";

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

/** Sentences `[level, text]`. Of what cannot be built, why; only its kinematics and its forces are said besides. */
export function sentences(answer, context) {
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
