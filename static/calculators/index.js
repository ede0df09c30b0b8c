/** The calculators in the order of their tabs. A new one is its own file here and a line below. */
export const CALCULATORS = [
  { id: "crank-planetary", load: () => import("./crank_planetary.js") },
  { id: "rollers", load: () => import("./rollers.js") },
  { id: "precession", load: () => import("./precession.js") },
];
