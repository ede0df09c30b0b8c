/** Undo and redo over states that are never changed in place. No DOM. */

const PAUSE_MS = 1500; // changes of one box with shorter pauses count as one

export function begun(present) {
  return { past: [], present, future: [] };
}

/** With a new state; `path` names the box that was changed, if it was one. */
export function recorded({ past, present, path: last, time: then }, next, path, time) {
  const again = path !== undefined && path === last && time - then <= PAUSE_MS;
  return { past: again ? past : [...past, present], present: next, future: [], path, time };
}

/** The next change is one of its own, even of the same box at once. */
export const paused = (history) => ({ ...history, path: undefined });

/** Back at the state before, or the same where there is none. */
export function undone(history) {
  const { past, present, future } = history;
  return past.length === 0 ? history
    : { past: past.slice(0, -1), present: past.at(-1), future: [present, ...future] };
}

export function redone(history) {
  const { past, present, future: [next, ...future] } = history;
  return next === undefined ? history : { past: [...past, present], present: next, future };
}
