/**
 * A calculator at work: its state, and the transitions that give the next one. Pure: no DOM, no
 * service, no storage; what happens outside is in asking.js, workbench.js and the views.
 *
 * `about`    what never changes: `{ model, calculator, catalogues, titles, materialOf }`
 * `typed`    what the boxes say, `{ texts, chosen }`, and `reading`, the same read and checked
 * `touched`  paths of the boxes where the user has been; `insisted`: Enter counts for all of them
 * `phase`    "incomplete", "wrong", "computing", "refused" or "fresh", or without an answer one of `UNANSWERED`
 * `address`  the query of what was asked last, and `pending`, its inputs
 * `refusal`  what the service refused: `{ at: {path: { words, place?, ask?, code? }}, text }`, or null
 * `shown`    the results on the screen: `{ typed, input, filled, answer, requests, cells }`, or null
 * `fixes`    what mends the design on the screen, `{ of: shown, list, long }`, of several inputs together first, `long` where it took too long to find, null where it was not to be had; or null
 * `limit`    the largest torque of the design on the screen, `{ of: shown, found }`, `found` what an answer says of it; or null
 * `usual`    what becomes of it with a usual clearance, a usual ring: `{ of: shown, fit?, ring? }` as the service answers, or null
 * `curves`   the curves of a figure that the drawing needs: `{ of: shown, data }`
 * `kept`     the designs that are kept, each with its answer; null until these are known
 * `tab`      what is open under the drawing
 * `tables`   ids of the figures shown as tables; `theme`, in which figures are drawn
 * `turn`     crank angle and pair selected in the drawing; `own`: where the user has turned it
 * `claim`    what the link or the store said of the design that was opened: `{ typed, unknown?, older?, verdict? }`
 * `besides`  what groups that are wanted have, by their ids: `{ typed, request, body?, answer?, of?, phase, progress?, refusal? }`,
 *            asked with `request` where `typed` stood; `answer` is that of the request `of`; besides.js asks
 * `line`     the line under the verdict, `[level, text]`; `said`, what is announced
 */
import { judgedOf, pathOf, verdictSentence, wordIn, wordOf } from "./lib/checks.js";
import { formatNumber, formatQuantity } from "./lib/format.js";
import { begun, paused, recorded, redone, undone } from "./lib/history.js";
import { cellAt, cellsOf, isOn, readState, shownFields, textIn, textOfCells, withLinks } from "./lib/form_state.js";
import { query } from "./lib/url_state.js";
import { warningsOf } from "./lib/verdict.js";
import { message } from "./messages/index.js";
import { explained, ofTitle, passingText, problemText, refusalTexts, warningText } from "./service_texts.js";

/** What is wrong with a box, in words; nothing for one that can be read. */
export function readingText(reading) {
  if (!reading?.problem) return "";
  const limit = reading.limit === undefined ? "" : formatNumber(reading.limit, 6);
  const words = message(`problem.${reading.problem}`, { limit });
  if (reading.row === undefined) return words;
  return message("rows.problem", { row: reading.row + 1, title: reading.column.title, words });
}

/** Paths of the boxes that cannot be read: those that are `wrong`, and those that nobody has filled in yet. */
export function unread({ reading: { wrong: own, readings }, touched, insisted }, wrong = own) {
  const asks = (path) => readings[path].problem === "required" && !insisted && !touched.has(path);
  return { wrong: wrong.filter((path) => !asks(path)), missing: wrong.filter(asks) };
}

/** Say what stands in the way of an answer; else one is to come. */
function checked(state) {
  const { about: { model: { fields } }, reading: { readings } } = state;
  const { wrong, missing } = unread(state);
  const titles = missing.map((path) => fields.get(path).title).join(", ");
  const text = [
    ...wrong.map((path) => ofTitle(fields.get(path).title, readingText(readings[path]))),
    ...(missing.length > 0 ? [message("verdict.needed", { titles })] : []),
  ].join("; ");
  if (wrong.length > 0) return { ...state, phase: "wrong", line: ["bad", text] };
  return missing.length > 0 ? { ...state, phase: "incomplete", line: ["", text] } : { ...state, phase: "computing" };
}

function read(state, history) {
  const typed = history.present;
  return checked({ ...state, history, typed, reading: readState(state.about.model, typed) });
}

/** A design opened: the first one, or after those of a `history`. */
export function opened(about, design, theme, claim = {}, history = null) {
  const typed = withLinks(about.model, design);
  const state = read({
    about, theme, touched: new Set(), insisted: false, address: null, refusal: null, shown: null, fixes: null, limit: null, usual: null, curves: null,
    kept: null, besides: {}, tab: null, tables: new Set(), turn: { angle: 0, pair: null, own: false }, line: ["", ""], said: "",
    claim: { ...claim, typed },
  }, history ? recorded(history, typed) : begun(typed));
  return { ...state, pending: state.reading.filled };
}

/** A box typed in. */
export function typedIn(state, path, text, time) {
  const { typed, touched, refusal } = state;
  const { [path]: _, ...at } = refusal?.at ?? {};
  return read(
    { ...state, touched: new Set(touched).add(path), refusal: refusal && { ...refusal, at } },
    recorded(state.history, { ...typed, texts: { ...typed.texts, [path]: text } }, path, time),
  );
}

/**
 * A group that is off until wanted, switched on, with what it needs, or off; one that is empty starts from the
 * calculator's values.
 */
export function switched(state, id, on, time) {
  const { typed, about: { model: { fields }, calculator: { wanted }, materialOf }, reading: { filled } } = state;
  const texts = { ...typed.texts };
  const turn = ({ id: one, starts = () => ({}), needs }) => {
    texts[`${one}.on`] = on ? "on" : "";
    if (!on) return;
    const values = Object.entries(starts(filled, materialOf)).filter(([, value]) => [value].flat().every((each) => each !== undefined && !Number.isNaN(each)));
    const untouched = (path) => ["", textIn(fields.get(path), fields.get(path).default)].includes(texts[path]);
    const empty = values.every(([path]) => untouched(path) || fields.get(path).wanted !== one);
    for (const [path, value] of values) if (empty && untouched(path)) texts[path] = textIn(fields.get(path), value);
    if (needs && texts[`${needs}.on`] !== "on") turn(wanted.find((group) => group.id === needs));
  };
  turn(wanted.find((group) => group.id === id));
  return read({ ...state, refusal: null }, recorded(state.history, { ...typed, texts }, undefined, time));
}

/**
 * An option chosen; its fields start from the same design, where it can be said so. What says what others give follows
 * them from then on, what has nobody to follow any more keeps its value.
 */
export function chose(state, id, option, time) {
  const { typed, about: { model }, reading: { readings: before } } = state;
  const seeded = seeds(state, model.choices.find((choice) => choice.id === id), option);
  const next = withLinks(model, { texts: { ...typed.texts, ...seeded }, chosen: { ...typed.chosen, [id]: option } });
  const { readings } = readState(model, next);
  const left = Object.keys(before).filter((path) => before[path].followed && readings[path]?.problem === "required");
  for (const path of left) next.texts[path] = textIn(model.fields.get(path), before[path].value);
  return read({ ...state, refusal: null }, recorded(state.history, next, undefined, time));
}

function seeds({ typed: { texts }, reading: { filled }, shown, about: { model, calculator, catalogues } }, choice, option) {
  const { fields } = choice.options.find(({ id }) => id === option);
  if (!fields.every((field) => ["", textIn(field, field.default)].includes(texts[field.path]))) return {};
  const values = choice.auto
    ? fromCatalogue(fields, choice.id, option, catalogues[choice.id], texts[choice.id] || texts[calculator.alike?.[choice.id]])
    : calculator.seeds[`${choice.id}.${option}`]?.(filled, shown?.answer) ?? {};
  return Object.fromEntries(Object.entries(values)
    .filter(([, value]) => typeof value !== "number" || Number.isFinite(value))
    .map(([path, value]) => [path, textIn(model.fields.get(path), value)]));
}

/** A table's first entry, or the values of the entry that was chosen. */
function fromCatalogue(fields, id, option, entries, chosen) {
  if (option === "named") return { [id]: entries[0]?.name };
  const entry = entries.find(({ name }) => name === chosen) ?? {};
  // where sources differ the strength is asked, and the name says the rest
  const asked = entry.facts ? ["youngs_modulus_GPa", "poissons_ratio", "yield_strength_MPa"] : [];
  return Object.fromEntries(fields.map(({ path, name }) => [path, asked.includes(name) ? undefined : entry[name]]));
}

/** Title, author, revision or note of the design. */
export function labelled(state, label, text, time) {
  const typed = { ...state.typed, texts: { ...state.typed.texts, [label]: text } };
  const history = recorded(state.history, typed, label, time);
  const shown = state.shown?.typed === state.typed ? { ...state.shown, typed } : state.shown;
  return { ...state, history, typed, shown };
}

/** A whole design taken over at once, with what is said of it besides. */
export function taken(state, design, claim, time) {
  const typed = withLinks(state.about.model, design);
  const untouched = {
    ...state, touched: new Set(), insisted: false, refusal: null, turn: { ...state.turn, own: false }, claim: { ...claim, typed },
  };
  return read(untouched, recorded(state.history, typed, undefined, time));
}

/** Another tab is open under the drawing. */
export const tabbed = (state, tab) => ({ ...state, tab });

/** What was said of the design has been read. */
export const unclaimed = (state) => ({ ...state, claim: {} });

function moved(state, history) {
  return history === state.history ? state : read({ ...state, refusal: null }, history);
}

export const steppedBack = (state) => moved(state, undone(state.history));
export const steppedOn = (state) => moved(state, redone(state.history));

/** The user has been at a box and left it. */
export function left(state, path) {
  if (state.touched.has(path)) return state;
  const next = { ...state, touched: new Set(state.touched).add(path) };
  return state.reading.wrong.length > 0 ? checked(next) : next;
}

/** The user wants an answer of what there is. */
export function insisted(state) {
  const next = { ...state, insisted: true, history: paused(state.history) };
  return state.reading.wrong.length > 0 ? checked(next) : next;
}

/** The link follows what needs no answer. */
export function addressed(state) {
  const { about: { model, calculator }, typed } = state;
  return { ...state, address: query(calculator.id, model, typed) };
}

/** The service is asked, unless boxes cannot be read. */
export function asked(state) {
  const { reading: { filled, wrong } } = state;
  const next = addressed(state);
  return wrong.length > 0 ? { ...next, said: state.line[1] } : { ...next, phase: "computing", pending: filled };
}

/** The service has answered what was asked last, or a part of it, and refused the rest. */
export function answered(state, { answer, refusal, requests }) {
  const { about: { calculator, materialOf }, typed, reading: { input, filled } } = state;
  const context = { input: filled, materialOf };
  const shown = answer === null ? state.shown : {
    typed, input, filled, answer, requests,
    cells: calculator.verdict(answer, context),
  };
  const turn = state.turn.own || !answer ? state.turn : startedAt(state, answer);
  return refusal
    ? refused({ ...state, shown, turn }, refusal)
    : { ...state, shown, turn, phase: "fresh", refusal: null, line: warningLine(state.about, shown), said: announced(shown, state.about) };
}

/** The drawing turned to where it starts: the peak. */
function startedAt({ about: { calculator }, turn }, answer) {
  const angle = calculator.drawing.start?.(answer);
  return Number.isFinite(angle) ? { ...turn, angle, own: false } : turn;
}

function refused(state, refusal) {
  const { about: { model, titles }, touched, insisted: all } = state;
  const { at, elsewhere } = refusalTexts(refusal, shownFields(model, state.typed), titles);
  const atBoxes = Object.entries(at).map(([path, { words }]) => ofTitle(model.fields.get(path).title, words));
  const text = [...elsewhere, ...atBoxes].join("; ");
  // What a table lacks, or what nobody has filled in yet, is asked for: it is not called wrong.
  const asks = ([path, { code }]) => code === "not_sourced" || (code && !all && !touched.has(path));
  const asked = elsewhere.length === 0 && Object.entries(at).every(asks);
  const phase = atBoxes.length === 0 ? "refused" : asked ? "incomplete" : "wrong";
  return { ...state, phase, refusal: { at, text }, line: [asked ? "" : "bad", text], said: text };
}

/**
 * What is strained or assumed, or that there is nothing of the kind; why checks could not be made, too, where that is
 * explained below. The checks are said by the verdict.
 */
function warningLine({ calculator, titles }, { answer }) {
  const reasons = (judgedOf(calculator, answer)?.checks ?? []).flatMap(({ reason }) => (reason && explained(reason.code) ? reason : []));
  const sentences = [...new Set([...warningsOf(answer), ...reasons].map((warning) => warningText(warning, titles)))];
  if (sentences.length === 0) return ["", message("verdict.noWarnings")];
  const key = sentences.length === 1 ? "verdict.oneWarning" : "verdict.warnings";
  return ["warning", message(key, { count: sentences.length, first: sentences[0] })];
}

/** The verdict in one sentence, for those who hear it. */
function announced(shown, { calculator, titles }) {
  const { cells, answer } = shown;
  const judged = judgedOf(calculator, answer);
  const words = cells.filter(({ note }) => note !== undefined)
    .map(({ label, value, unit, note }) => `${[label, value, unit].filter(Boolean).join(" ")}, ${note}`);
  return [judged && verdictSentence(judged, titles), message("verdict.announce", { cells: `${words.join(". ")}.` })]
    .filter(Boolean).join(" ");
}

/** What would mend the design that is shown; of another one it is passed over. */
export const mended = (state, of, list, long = false) => (state.shown?.answer === of.answer ? { ...state, fixes: { of, list, long } } : state);

/** The largest torque of that design; nothing of it where it is not known. */
export function limited(state, of, { torque_reserve, largest_torque_Nm, largest_torque_of, largest_torque_without }) {
  if (state.shown?.answer !== of.answer) return state;
  const said = largest_torque_Nm === undefined ? state.said : message("checks.largestTorque", { torque: formatQuantity(largest_torque_Nm, "N·m") });
  return { ...state, said, limit: { of, found: { torque_reserve, largest_torque_Nm, largest_torque_of, largest_torque_without } } };
}

/** The answer on the screen, with the largest torque where that is known. */
export const answerNow = ({ shown, limit }) => (shown && limit?.of.answer === shown.answer ? { ...shown.answer, ...limit.found } : shown?.answer);

/** What becomes of that design with what is usual of what is not known of it. */
export const withUsual = (state, of, { usual_fit: fit, usual_modification: ring }) => (state.shown?.answer === of.answer ? { ...state, usual: { of, fit, ring } } : state);

/** Values put in by JSON pointer: a fix, a size that was looked for. */
export function applied(state, sets, time) {
  const { typed, about: { model } } = state;
  const texts = { ...typed.texts };
  for (const [pointer, value] of Object.entries(sets)) {
    const path = pathOf(pointer);
    const cell = cellAt(model, path);
    if (model.fields.has(path)) texts[path] = textIn(model.fields.get(path), value);
    else if (cell) texts[cell.list] = textOfCells(cellsOf(texts[cell.list]).map((cells, row) => (row === cell.row ? cells.with(cell.index, textIn(cell.field, value)) : cells)));
  }
  const next = withLinks(model, { ...typed, texts });
  return read({ ...state, refusal: null }, recorded(state.history, next, undefined, time));
}

/** What a wanted group has now. */
export function besided(state, id, part) {
  return { ...state, besides: { ...state.besides, [id]: { ...state.besides[id], ...part } } };
}

/** A wanted group was refused: at its boxes, and in words; a `live` one asks again what may be answered then. */
export function refusedBesides(state, id, problem, live) {
  const { about: { model, titles }, besides: { [id]: { typed } } } = state;
  if (problem.status !== 422) return besided(state, id, { phase: "failed", refusal: { at: {}, text: (live ? passingText : problemText)(problem, titles) } });
  const { at, elsewhere } = refusalTexts(problem, shownFields(model, typed), titles);
  const atBoxes = Object.entries(at).map(([path, { words }]) => ofTitle(model.fields.get(path).title, words));
  return besided(state, id, { phase: "refused", refusal: { at, text: [...elsewhere, ...atBoxes].join("; ") } });
}

/** What stands in the way of a wanted group: boxes of its own that cannot be read, in words. */
export function hinderedBesides(state, id) {
  const { reading: { besides, readings }, about: { model: { fields } } } = state;
  return (besides[id] ?? []).map((path) => ofTitle(fields.get(path).title, readingText(readings[path]))).join("; ");
}

/** What a box is told by the group that it belongs to; it stands until something is typed. */
export function refusedAt({ typed, refusal, besides }, path) {
  return refusal?.at[path] ?? Object.values(besides).find((one) => one.typed === typed && one.refusal?.at[path])?.refusal.at[path];
}

/** Whether a group is on. */
export const wants = ({ typed: { texts }, about: { model } }, id) => isOn(model, id, texts);

/** Why there is no answer: the service is out of reach, it is busy, it takes too long, or it fails. */
export const UNANSWERED = ["offline", "busy", "long", "failed"];

export function failed(state, problem) {
  const text = passingText(problem, state.about.titles);
  const phase = problem.status === 0 ? "offline" : { unavailable: "busy", "too-long": "long" }[problem.kind] ?? "failed";
  return { ...state, phase, line: ["bad", text], said: text };
}

export const compared = (state, kept) => ({ ...state, kept });
export const themed = (state, theme) => ({ ...state, theme });
export const turned = (state, angle) => ({ ...state, turn: { ...state.turn, angle, own: true } });
export const returned = (state) => (state.shown ? { ...state, turn: startedAt(state, state.shown.answer) } : state);
export const selected = (state, pair) => ({ ...state, turn: { ...state.turn, pair } });

export function tabled(state, id, on) {
  const tables = new Set(state.tables);
  if (on) tables.add(id);
  else tables.delete(id);
  return { ...state, tables };
}

/** A figure was drawn: its curves, if they are those that the drawing waits for. */
export function charted(state, id, data) {
  if (id !== state.about.calculator.drawing.figure) return state;
  return { ...state, curves: { of: state.shown, data: data.filter(({ mode }) => mode === "lines") } };
}

/** Whether the numbers on the screen are of other inputs than those on the screen, or may be. */
export function stale({ phase, shown, typed }) {
  return ["computing", ...UNANSWERED].includes(phase) || shown?.typed !== typed;
}

/** How it stands, and what the numbers are of: these inputs, a part of them, older ones, none yet. */
export function standing(state) {
  const { phase, shown } = state;
  if (stale(state)) return { phase, numbers: shown ? "older" : "none" };
  if (phase !== "fresh") return { phase, numbers: "part" };
  const judged = judgedOf(state.about.calculator, shown.answer);
  return { phase: judged && wordOf(judged) === "impossible" ? "refused" : phase, numbers: "fresh" };
}

/** The verdict's word of these inputs; none while it is to come. */
export function verdictOf(state) {
  const { about: { calculator }, shown, phase } = state;
  return phase === "fresh" && !stale(state) ? wordIn(calculator, shown.answer) : undefined;
}

/** What the drawing shows: results with the curves it needs; null while these are to come. */
export function drawable({ about: { calculator }, shown, curves, tables }) {
  const { section, figure, curves: curvesOf } = calculator.drawing;
  if (!shown?.answer[section]) return null;
  const source = calculator.figures.find(({ id }) => id === figure);
  const { filled: input, answer } = shown;
  if (!source || !answer[source.section] || tables.has(figure)) return { input, answer, curves: curvesOf?.(answer) ?? [] };
  return curves?.of === shown ? { input, answer, curves: curves.data } : null;
}

/** The state in force, and the views that are told of every next one. */
export function createStore(state) {
  const views = [];
  return {
    get state() {
      return state;
    },
    /** Tell these views too, now and of every next one. */
    show(more) {
      views.push(...more);
      for (const view of more) view.update(state);
    },
    apply(transition, ...values) {
      const next = transition(state, ...values);
      if (next === state) return;
      state = next;
      for (const view of views) view.update(state);
    },
  };
}

/** An update that acts only where one of the parts that `pick` lists has changed. */
export function following(pick, act) {
  let last = null;
  return (state) => {
    const parts = pick(state);
    if (last?.length === parts.length && last.every((part, i) => part === parts[i])) return;
    last = parts;
    act(state);
  };
}
