/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatAngle, formatNumber, formatQuantity } from "../../lib/format.js";
import { message, said } from "../../messages/index.js";

const say = (key, values) => message(`words.${key}`, values);

function transmission({ min_driving: least, max_driving: most, mean_driving: mean, dead_centres_deg: dead, pairs }, real) {
  if (dead.length > 0) {
    const named = dead.slice(0, 4).map((angle) => formatAngle(angle)).join(", ");
    return ["bad", say("dead", { angles: named + (dead.length > 4 ? ` ${message("verdict.more")}` : "") })];
  }
  const values = { least, most, all: pairs.length, mean: formatNumber(mean, 4) };
  if (real) return ["good", say("loaded", { least: real.loaded_pairs_min, most: real.loaded_pairs_max, all: pairs.length })];
  return ["good", say(least === most ? "steady" : "transmits", values)];
}

function evenness({ peak_force_N: peak, equal_sharing_peak_N: equal }) {
  return ["", say("even", { peak: formatQuantity(peak, "N"), share: formatNumber(peak / equal, 3) })];
}

/** The peak of the mechanism as it is made, beside the ideal one. */
function made({ peak_force_N: peak }, { peak_force_N: real }) {
  return ["", say("made", { real: formatQuantity(real, "N"), peak: formatQuantity(peak, "N") })];
}

/** What stands between the peak force and the force that the pressure is of: the product of the factors, 1 for none. */
export const factorOf = ({ load, contact } = {}) => (load?.application_factor ?? 1) * (contact?.distribution_factor ?? 1);

/** The force that the pressure is of, where it is not the peak force: the load factors, and what bent pins add to the line load. */
function pressed({ peak_force_N: peak }, { line_load_factor: edge = 1 }, factor) {
  if (factor === 1 && edge === 1) return null;
  return ["", say(edge === 1 ? "factors" : "bentFactors", {
    force: formatQuantity(peak * factor * edge, "N"), factor: formatNumber(factor, 4), edge: formatNumber(edge, 3),
  })];
}

/** What each satellite carries, and what the check that decides would say if all carried alike. */
function shared({ discs, even: [even] = [] }) {
  const shares = discs.map(({ share }) => formatQuantity(100 * share, "%", 3)).join("; ");
  const texts = [message("shares.carried", { shares })];
  if (even?.value !== undefined) {
    texts.push(message("shares.even", { check: said("checks", even.check).title, value: formatQuantity(even.value, even.unit, 3) }));
  }
  return ["", `${texts.join(". ")}.`];
}

/** Sentences `[level, text]`; how the parts stand their load is said by the checks. */
export function sentences({ cyclogram, contact_force: force, load_sharing: real, hertz, shares }, { input } = {}) {
  return [
    cyclogram && transmission(cyclogram, real),
    force && real ? made(force, real) : force?.equal_sharing_peak_N !== undefined && evenness(force),
    force && hertz && !real && pressed(force, hertz, factorOf(input)),
    shares && shared(shares),
  ];
}
