/** The verdict in plain words: what the answer means for the design. No DOM. */
import { formatNumber, formatQuantity } from "../../lib/format.js";
import { message } from "../../messages/index.js";

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

/** What stands between the peak force and the force that the pressure is of: the product of the factors, 1 for none. */
export const factorOf = (contact) => (contact?.dynamic_factor ?? 1) * (contact?.distribution_factor ?? 1);

/** The force under which the pressure is given, without the factors: the peak, or where clearance and errors are judged the real one. */
export function pressingForce({ contact_force: { peak_force_N: peak }, hertz }, contact) {
  const force = (2 * hertz.mean_pressure_MPa * hertz.half_width_mm * contact.contact_length_mm) / factorOf(contact);
  return Math.abs(force / peak - 1) > 1e-9 ? force : peak;
}

/** Sentences `[level, text]`; how the parts stand their load is said by the checks. */
export function sentences({ cyclogram, contact_force: force, hertz }, { input } = {}) {
  const factor = factorOf(input?.contact);
  return [
    cyclogram && transmission(cyclogram),
    force?.equal_sharing_peak_N !== undefined && evenness(force),
    force && hertz && factor !== 1 && ["", say("factors", {
      force: formatQuantity(pressingForce({ contact_force: force, hertz }, input.contact) * factor, "N", 4), factor: formatNumber(factor, 4),
    })],
  ];
}
