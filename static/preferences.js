/** What the user chose once and the browser remembers; without storage it holds for the visit. */

export function preference(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

export function setPreference(name, value) {
  try {
    localStorage.setItem(name, value);
  } catch {
    // Private windows may have no storage.
  }
}
