/** The calculators in the order of their tabs. A new one is a folder of its own here and a name below. */
export const CALCULATORS = ["crank-planetary", "rollers", "precession"];

/** Each is loaded when it is opened. */
export async function calculatorOf(id) {
  return (await import(`./${id}/index.js`)).default;
}
