/** The service's verdict and checks in words and numbers, ready to be shown. No DOM. */
import { fieldWords, message, said } from "../messages/index.js";
import { ofTitle, reasonText } from "../service_texts.js";
import { ALL, formatAngle, formatNumber, formatQuantity, inNumerals, unitOf } from "./format.js";

const LEVELS = { pass: "good", marginal: "warning", fail: "bad", incomplete: "warning", not_checked: "warning" };
/** Names of an answer that say how it is judged or how exact it is: no results of their own. */
export const ASIDE = [
  "accuracy", "warnings", "verdict", "governing", "counts", "not_considered", "checks", "fixes", "torque_reserve",
  "largest_torque_Nm", "largest_torque_of", "largest_torque_without", "untried", "cold_yield", "parts", "model", "assumed", "fit",
];

/** The sections whose values are listed: those that are asked, and those that an answer has beside these, as that of forces which are solved. */
export const listedOf = ({ sections, solved, besides = [] }, answers) =>
  [...[...besides, solved].filter((id) => answers.some((answer) => answer?.[id])), ...sections];

/** The values of a section as `[[name, value]]`, those of its parts too, named after the part where there are words for that. */
export function flattened(section) {
  return Object.entries(section).flatMap(([name, value]) => {
    const parted = typeof value === "object" && !Array.isArray(value) && unitOf(name) === "" && !("pin" in value) && !ASIDE.includes(name);
    if (!parted) return [[name, value]];
    return flattened(value).map(([own, one]) => [message("quantity")[`${name}_${own}`] ? `${name}_${own}` : own, one]);
  });
}

const JUDGED = ["pass", "marginal", "fail"];

/** What an answer says of the whole design, from the section that has it; null where none has. */
export function judgedOf({ judgedIn }, answer) {
  const part = judgedIn ? answer?.[judgedIn] : answer;
  return part?.verdict ? part : null;
}

/** Whether it is looked for what mends a design. */
export const isMended = (calculator, answer) => Boolean(calculator.mend) && ["fail", "marginal"].includes(judgedOf(calculator, answer)?.verdict);

/** Whether its largest torque is asked for by itself, after the first answer: of what can be, as far as it is judged. */
export function isLimited({ limit }, answer) {
  if (!limit || !answer?.parts || wordOf(answer) === "impossible" || answer.cold_yield) return false;
  return answer.parts.some(({ status }) => JUDGED.includes(status)) && answer.parts.every(({ reason }) => reason !== "clearance_unknown");
}

/** What is usual of what is not known of it, with which it is looked at too. */
export const usuallyOf = ({ usual = () => [] }, answer) => usual(answer);

/** The checks that a value may be looked for by: those that say how much of their limit is used. */
export const sizedBy = (judged) => (judged?.checks ?? []).filter(({ utilisation }) => utilisation !== undefined);

/** The verdict's word: what cannot exist is not merely unfit. */
export function wordOf({ verdict, checks = [] }) {
  return checks.some(({ impossible }) => impossible) ? "impossible" : verdict;
}

/** The verdict's word of an answer; none where nothing is judged. */
export function wordIn(calculator, answer) {
  const judged = judgedOf(calculator, answer);
  return judged ? wordOf(judged) : undefined;
}

/** The word as it is shown: of what is not known of all parts, of how many it is. */
export function wordText(judged) {
  const word = wordOf(judged);
  const within = (judged.parts ?? []).filter(({ status }) => !["left_out", "not_asked"].includes(status));
  if (word !== "incomplete" || within.length === 0) return message(`verdictWord.${word}`);
  return message("verdictWord.soFar", { judged: within.filter(({ status }) => JUDGED.includes(status)).length, all: within.length });
}

/** How many things are not known: parts, or checks where it has no parts. */
export const unknownIn = ({ parts, counts }) => (parts ? parts.filter(({ status }) => status === "open").length : counts.not_checked);

const MARKS = { pass: "✓", marginal: "!", fail: "✗", open: "?", left_out: "–", not_asked: "·" };

/** A part for its chip: `title`, `status`, `level`, `mark`, `words`, the path of what it lacks (`ask`), and whether it can be left out. */
export function partRow({ code, title, status, governing, reason, missing = [] }) {
  const why = status === "open" && (said("reasons", reason) ?? said("notices", reason)?.title ?? reason);
  const lacks = missing.find((pointer) => !pointer.startsWith("/requirements"));
  return {
    code, status,
    title: said("not_considered", code) ?? title,
    level: LEVELS[status] ?? "",
    mark: MARKS[status],
    words: [message(`partStatus.${status}`), why].filter(Boolean).join(": "),
    ask: status === "open" && lacks ? pathOf(lacks) : status === "not_asked" && code === "losses" ? "friction.coefficient" : undefined,
    governing,
    leaves: status !== "left_out",
  };
}

export const levelOfWord = (word) => (word === "impossible" ? "bad" : LEVELS[word]);

export function titleOf({ code, title }) {
  return said("checks", code)?.title ?? title ?? code;
}

/** A share of a limit in per cent. */
export function percent(share) {
  return `${formatNumber(100 * share, share < 0.1 ? 2 : 3)}\u00a0%`;
}

const amount = (value, unit, digits) => (value === undefined ? "" : formatQuantity(value, unit, digits));

/**
 * A check for a row: `level`, `title`, `why`, `value`, `limit` (with the sense), `used` (share of the
 * limit), `source`, `place`, `reason`, `cause` of a marginal one, `missing` (paths of fields).
 */
export function checkRow(check, titles) {
  const { code, status, needed = true, value, limit, unit, keep, utilisation, source, source_code: sourceCode, criterion, life_factor: life, at, reason, missing = [] } = check;
  const noneAllowed = limit === 0 && keep !== "above"; // of what is counted, or overlaps
  const none = noneAllowed && value === 0;
  return {
    code,
    status,
    needed,
    level: levelOfCheck(check),
    title: titleOf(check),
    why: said("checks", code)?.why ?? check.why ?? "",
    value: none ? message("checks.none") : amount(value, unit),
    exact: none ? "" : amount(value, unit, ALL),
    limit: limit === undefined || none ? "" : noneAllowed ? message("checks.noneAllowed") : `${keep === "above" ? "≥" : "≤"}\u00a0${amount(limit, unit)}`,
    used: utilisation,
    formula: inNumerals(check.formula ?? ""),
    source: [
      criterion && (said("criteria", criterion) ?? criterion),
      source && (said("sources", sourceCode) ?? source),
      check.verified && (said("verified", check.verified) ?? check.verified),
      life !== undefined && message("checks.life", { factor: formatNumber(life, 3) }),
    ].filter(Boolean).join(": "),
    place: at?.pin === undefined ? "" : message("checks.at", { ...at, angle: formatAngle(at.crank_angle_deg ?? 0) }),
    reason: reason ? reasonText(reason, titles) : "",
    cause: status === "marginal" ? becauseOf(check, titles) : "",
    missing: missing.map(pathOf),
    judged: JUDGED.includes(status),
  };
}

/** Dotted path of a JSON pointer. */
export const pathOf = (pointer) => pointer.slice(1).replaceAll("/", ".");

/** What a fix does to another check: how much of its limit is used, where that is known before and after. */
function effectText(check, { status_from: was, status_to: is, utilisation_from: before, utilisation_to: after }) {
  const known = before !== undefined && after !== undefined;
  return known ? message("fixes.effect", { check, before: percent(before), after: percent(after) })
    : message("fixes.statusEffect", { check, before: message(`status.${was}`), after: message(`status.${is}`) });
}

/** What a fix changes in words, `name` that of a message: the input, and what follows it. */
function changeText({ pointer, title, unit, from, to, change, sets = {} }, fieldAt, name) {
  const field = fieldAt(pathOf(pointer)) ?? { title, unit };
  const shown = (value, unitOfIt) => (typeof value === "string" ? said("materials", value) ?? value : formatQuantity(value, unitOfIt, ALL));
  const values = {
    field: field.title, from: shown(from, field.unit), to: to === undefined ? "" : shown(to, field.unit),
    change: change === undefined ? "" : `${change > 0 ? "+" : ""}${percent(change)}`,
  };
  const others = name === "notEnough" ? [] : Object.entries(sets).filter(([at]) => at !== pointer)
    .map(([at, value]) => [fieldAt(pathOf(at)), value]).filter(([other]) => other)
    .map(([{ title: other, unit: of }, value]) => message("fixes.also", { field: other, to: shown(value, of) }));
  return [message(`fixes.${name}`, values), ...others].join("; ");
}

/** A fix: what to change, by how much, to what verdict, and what else it sets and does; `fieldAt(path)` is a field of the form. */
export function fixRow(fix, fieldAt, { checks = [], parts }) {
  const { standard, status, verdict, steps = [fix], side_effects: effects = [] } = fix;
  const enough = status !== "not_enough";
  const wordsOf = ({ change }) => (change === undefined ? "choice" : "change");
  const changes = steps.map((step) => changeText(step, fieldAt, enough ? wordsOf(step) : "notEnough")).join("; ");
  const named = (code) => titleOf(checks.find((check) => check.code === code) ?? { code });
  return {
    applies: enough && fix.sets !== undefined,
    text: steps.length > 1 ? message("fixes.together", { changes }) : changes,
    standard: standard ?? "",
    level: verdict === "incomplete" && parts ? "" : LEVELS[verdict],
    then: verdict && enough ? wordText({ verdict }) : "",
    effects: !enough ? [] : effects.filter(({ status_from: was, status_to: is }) => was !== is || is !== "pass").map((effect) => ({
      level: LEVELS[effect.status_to],
      text: effectText(named(effect.code), effect),
    })),
  };
}

/**
 * The check that decides: the first that is not known where the verdict is incomplete, else the one that governs; where
 * that holds, the first yield of plastic, which is necessary and not enough, if more of its limit is used.
 */
export function decisive({ verdict, governing, parts, checks = [] }) {
  if (verdict === "incomplete" && !parts) return checks.find(({ status }) => status === "not_checked");
  const own = checks.find(({ code }) => code === governing);
  return own && own.status !== "pass" ? own : checks.filter(({ reason, utilisation }) => reason?.code === "necessary_only" && utilisation !== undefined)
    .reduce((worst, check) => (check.utilisation > (worst?.utilisation ?? 0) ? check : worst), own);
}

/** Whether a check hangs on the torque. */
const byTorque = ({ torque_reserve: reserve, inputs = [] }) => reserve !== undefined || inputs.some((pointer) => /\/(out|in)put_torque_Nm$/.test(pointer));

/** The verdict in a sentence. */
export function verdictSentence(judged, titles) {
  const word = wordOf(judged);
  const check = decisive(judged);
  const row = check && checkRow(check, titles);
  const { largest_torque_Nm: largest } = judged;
  const allowed = largest !== undefined && message("checks.largestTorque", { torque: formatQuantity(largest, "N·m") });
  const cold = coldYield(judged)?.sentence;
  const governs = row?.value && row.limit ? ofTitle(row.title, `${row.value} (${row.limit})`) : [row?.title, row?.reason].filter(Boolean).join(": ");
  return [`${message(`verdictWord.${word}`)}.`, governs && `${governs}.`, allowed && `${allowed}.`, cold].filter(Boolean).join(" ");
}

function groupsOf({ checks = [] }) {
  const groups = new Set(checks.filter(({ status }) => JUDGED.includes(status)).map(({ group }) => group));
  return [...groups].map((group) => said("check_groups", group) ?? group).join(", ").toLowerCase();
}

/** How a check stands: good, warning, bad; nothing where it is not judged, and need not be. */
export const levelOfCheck = ({ status, needed = true }) => (needed || status !== "not_checked" ? LEVELS[status] : undefined);

/** What is not looked at, in words. */
export function notConsidered({ not_considered: all = [], parts = [] }) {
  const codes = all.filter((code) => !parts.some((part) => part.code === code)); // which say it themselves
  if (codes.length === 0) return "";
  return message("checks.notConsidered", { what: codes.map((code) => said("not_considered", code) ?? code).join("; ") });
}

/** What was not given and is assumed, in words. */
export function assumedIn({ assumed = [] }) {
  if (assumed.length === 0) return "";
  const what = assumed.map(({ pointer, value, low, high, without }) => {
    const [name, part] = pointer.split("/").filter((each) => !/^\d+$/.test(each)).reverse();
    const group = part === "bearings" ? "bearing" : part; // of the list of those of the shaft
    const between = low === undefined ? "" : ` (${formatNumber(low)}\u2013${formatNumber(high)})`;
    const numbers = [value].flat().filter((one) => typeof one === "number");
    const shown = numbers.length > 0 ? numbers.map((one) => formatQuantity(one, unitOf(name), ALL)).join("; ") + between : said("materials", value) ?? message("option")[value] ?? "";
    const words = { title: fieldWords(name, group)?.title ?? name, value: shown };
    if (!without) return message("checks.assumedOne", words);
    return message("checks.assumedWithout", { ...words, force: formatQuantity(without.peak_force_N, "N") });
  });
  return message("checks.assumed", { what: what.join("; ") });
}

/** Why a check is marginal, in a phrase. */
const becauseOf = ({ because, reason }, titles) => (because ? message(`verdictWord.because.${because}`) : reason ? reasonText(reason, titles) : "");

/** Why a verdict's word is what it is, in words: of one that just works by the check that governs; nothing where it works, or where what is unknown says so. */
export function wordNote(judged, titles) {
  const word = wordOf(judged);
  if (word === "pass") return "";
  if (word === "marginal") return becauseOf(decisive(judged) ?? {}, titles);
  if (word === "incomplete") return unknownIn(judged) > 0 ? "" : message("verdictWord.nothingNote");
  return message(`verdictWord.${word}Note`);
}

/** What the checks that have been judged are about, in words. */
export const lookedAt = (judged) => message("verdictWord.lookedAt", { groups: groupsOf(judged) });

/** Of plastic: above which torque it yields at once, in a sentence, and by what; nothing where that is not known. */
export function coldYield({ cold_yield: cold }) {
  if (!cold) return null;
  const { torque_Nm: torque, quarter_Nm: quarter, strength_MPa: strength, friction, open } = cold;
  return {
    torque,
    short: message("checks.coldShort", { quarter: formatQuantity(quarter, "N·m", 2) }),
    sentence: message("checks.coldYield", { torque: formatQuantity(torque, "N·m", 3), quarter: formatQuantity(quarter, "N·m", 2) }),
    by: message("checks.coldBy", {
      strength: formatQuantity(strength, "MPa", 3), friction: formatNumber(friction, 3),
      open: open.map((code) => titleOf({ code })).join(", ").toLowerCase(),
    }),
  };
}

/** What a largest torque does not count, and what holds above it where less than the load is certain; nothing else. */
export function torqueNote({ verdict, torque_reserve: reserve, largest_torque_without: without = [] }) {
  const certain = reserve < 1 && verdict !== "fail" && message("checks.surely");
  const uncounted = without.length > 0 && message("checks.uncounted", { checks: without.map((code) => titleOf({ code })).join(", ") });
  return [certain, uncounted].filter(Boolean).join("; ");
}

/** Why a verdict knows no largest torque, in words. */
export function torqueUnknown(judged) {
  const { counts, parts = [] } = judged;
  if (parts.some(({ reason }) => reason === "clearance_unknown")) return message("checks.byClearance");
  if (parts.length > 0 && parts.every(({ status }) => !JUDGED.includes(status))) return message("checks.openParts");
  if (counts.not_checked) return message("checks.openChecks", { count: counts.not_checked });
  const { checks = [] } = judged;
  const check = checks.find((one) => one.status === "fail" && !byTorque(one)); // which no smaller one cures
  if (check) return message("checks.notByTorque", { check: titleOf(check) });
  return message(checks.some((one) => JUDGED.includes(one.status) && byTorque(one)) ? "checks.torqueNotFound" : "checks.withoutTorque");
}
