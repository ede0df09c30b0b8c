/** The browser's storages; where there is none, or it is full or forbidden, nothing is remembered. */

function careful(area) {
  const attempt = (act) => {
    try {
      return act(globalThis[area]);
    } catch {
      return null;
    }
  };
  return {
    getItem: (name) => attempt((storage) => storage.getItem(name)),
    setItem: (name, text) => attempt((storage) => storage.setItem(name, text)),
  };
}

/** What is remembered from visit to visit, and what over a reload only. */
export const lasting = careful("localStorage");
export const session = careful("sessionStorage");

/** What was remembered as JSON; what cannot be read is not ours. */
export function parsed(text, otherwise) {
  try {
    return JSON.parse(text) ?? otherwise;
  } catch {
    return otherwise;
  }
}
