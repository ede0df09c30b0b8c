/** Undo and redo over states that are never changed in place. No DOM. */

const PAUSE_MS = 1500; // changes of one box with shorter pauses count as one

export function createHistory(first, now = Date.now) {
  let past = [];
  let present = first;
  let future = [];
  let lastPath;
  let lastTime = 0;
  const move = (from, to) => {
    if (from.length === 0) return null;
    to.push(present);
    present = from.pop();
    lastPath = undefined;
    return present;
  };
  return {
    /** A new state; `path` names the box that was changed, if it was one. */
    record(state, path) {
      const time = now();
      if (path === undefined || path !== lastPath || time - lastTime > PAUSE_MS) past.push(present);
      [present, future, lastPath, lastTime] = [state, [], path, time];
    },
    /** The state before or after, now in force; null where there is none. */
    undo: () => move(past, future),
    redo: () => move(future, past),
    get canUndo() {
      return past.length > 0;
    },
    get canRedo() {
      return future.length > 0;
    },
  };
}
