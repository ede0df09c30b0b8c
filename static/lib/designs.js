/** Designs that the user keeps: in the browser's storage, and as project files. No DOM. */
import { judgedOf, wordIn } from "./checks.js";
import { parsed } from "./storage.js";

const KEY = "khv-calc.designs";
const FORMAT = "khv-calc designs";
export const MOST = 6; // side by side, of one calculator

function isDesign(one) {
  return typeof one?.name === "string" && typeof one.calculator === "string" && typeof one.input === "object" && one.input !== null;
}

const NUMBERS = ["largest_torque_Nm", "max_pressure_MPa", "peak_force_N", "backlash_max_arcmin", "efficiency"];
const FELT = 1e-6; // a change of a number that is one

/** What is kept of an answer: the word, the check that governs and the numbers of which a user asks first. */
export function resultsOf(calculator, answer) {
  const judged = judgedOf(calculator, answer);
  const parts = [judged, ...["load_sharing", "hertz"].map((name) => answer?.[name]), ...Object.values(answer ?? {})];
  const numbers = NUMBERS.map((name) => [name, parts.find((part) => typeof part?.[name] === "number")?.[name]]);
  return Object.fromEntries([["verdict", wordIn(calculator, answer)], ["governing", judged?.governing], ...numbers].filter(([, value]) => value !== undefined));
}

/** The numbers that moved between two results, `[[name, before, after]]`. */
export function movedOf(before = {}, after = {}) {
  return NUMBERS.filter((name) => name in before && name in after && Math.abs(after[name] - before[name]) > FELT * Math.abs(before[name]))
    .map((name) => [name, before[name], after[name]]);
}

/** A design as it is kept now: in the first form its verdict stood alone. */
const formed = ({ verdict, ...one }) => ({ results: { verdict }, ...one });

/** A, B, … and then A2, B2, …: the first that is free. */
function freeName(taken) {
  for (let round = 1; ; round += 1) {
    for (const letter of "ABCDEFGHIJKLMNOPQRSTUVWXYZ") {
      const name = round === 1 ? letter : `${letter}${round}`;
      if (!taken.includes(name)) return name;
    }
  }
}

function newId() {
  return `${Date.now().toString(36)}-${Math.random().toString(36).slice(2, 10)}`;
}

/**
 * `storage` is the browser's (lib/storage.js); other tabs use it too, so it is read anew for every change. Where it is full or
 * forbidden, the designs stay as long as the page does.
 */
export function createDesigns(storage) {
  let text = null;
  let designs = [];
  let stored = true; // whether the browser has taken the last change

  function read() {
    const found = stored ? storage.getItem(KEY) ?? text : text;
    if (found === text) return designs;
    text = found;
    const all = parsed(text, []);
    designs = Array.isArray(all) ? all.filter(isDesign).map((one) => ({ id: `${one.calculator} ${one.name}`, ...formed(one) })) : [];
    return designs;
  }

  function keep(changed) {
    designs = changed;
    text = JSON.stringify(designs);
    storage.setItem(KEY, text);
    stored = storage.getItem(KEY) === text;
  }

  const of = (calculator) => read().filter((design) => design.calculator === calculator);
  const taken = (calculator, name, id) => of(calculator).some((one) => one.name === name && one.id !== id);

  /** Keep an input (the canonical request) under the name wanted, or a free letter; `about` are its labels, its results, and the path and body of its request. */
  function add(calculator, input, wanted = "", about = {}) {
    const name = wanted && !taken(calculator, wanted) ? wanted : freeName(of(calculator).map((one) => one.name));
    const design = { id: newId(), name, calculator, input, ...about };
    keep([...read(), design]);
    return design;
  }

  return {
    of,
    add,
    /** Whether they will be there on the next visit. */
    lasting: () => stored,
    rename({ id, calculator }, name) {
      const wanted = name.trim();
      if (wanted !== "" && !taken(calculator, wanted, id)) keep(read().map((one) => (one.id === id ? { ...one, name: wanted } : one)));
    },
    remove: ({ id }) => keep(read().filter((one) => one.id !== id)),
    /** All designs as the text of a file of this version of the service. */
    exported: (version) => `${JSON.stringify({ format: FORMAT, v: 2, version, designs: read() }, null, 2)}\n`,
    /** Add the designs of a file, also of one of the first form, which keeps of their results the verdict alone; how many, or null where it is none of ours. */
    imported(file) {
      const { format, v, designs: found } = parsed(file, {});
      if (format !== FORMAT || ![1, 2].includes(v) || !Array.isArray(found)) return null;
      const added = found.filter(isDesign).map(formed);
      for (const { name, calculator, input, labels, results, path, body } of added) add(calculator, input, name, { labels, results, path, body });
      return added.length;
    },
  };
}
