/**
 * Formulas as trees, read from a line like `sqrt(w*E/(π*ρ))`. No DOM, no texts.
 *
 * The same tree is written as MathML (mathml.js) and computed (evaluate.js), so that what a worked
 * step shows is what was checked. Names are keys of the step's values. Functions: sqrt, sin, cos,
 * abs, min, max, ln, atan, acos, and
 * `sum(term)`, over the values of the term that are lists, and
 * `integral(term; z; from; to)`, where `z` is bound in the term.
 */
const TOKEN = /\s*(?:(\d+(?:\.\d+)?)|([\p{L}_∞][\p{L}\p{N}_′]*)|(.))/uy;
const POWERS = { "+": 1, "-": 1, "*": 2, "/": 2, "^": 4 };
const SIGN = 1; // takes the whole product after it

function tokens(text) {
  const found = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.trimEnd().length) {
    const [, number, name, mark] = TOKEN.exec(text);
    found.push({ number, name, mark });
  }
  return found;
}

/** `{ number }`, `{ name }`, `{ call, of: [trees], bound }` or `{ operator, of: [trees] }`. */
export function parse(text) {
  const rest = tokens(text);
  const at = (mark) => rest[0]?.mark === mark;
  const take = (mark) => {
    if (!at(mark)) throw new SyntaxError(`"${mark}" is missing in ${text}`);
    rest.shift();
  };

  function call(name) {
    take("(");
    const of = [expression(0)];
    while (!at(")")) {
      rest.shift();
      of.push(expression(0));
    }
    take(")");
    if (name !== "integral") return { call: name, of };
    const [term, bound, from, to] = of;
    return { call: name, of: [term, from, to], bound: bound.name };
  }

  function operand() {
    const { number, name, mark } = rest.shift() ?? {};
    if (number) return { number: Number(number) };
    if (name) return at("(") ? call(name) : { name };
    if (mark === "-") return { operator: "neg", of: [expression(SIGN)] };
    if (mark !== "(") throw new SyntaxError(`"${mark}" is out of place in ${text}`);
    const inner = expression(0);
    take(")");
    return inner;
  }

  function expression(power) {
    let left = operand();
    while (POWERS[rest[0]?.mark] > power) {
      const operator = rest.shift().mark;
      // A power binds to the right: a^b^c is a^(b^c).
      left = { operator, of: [left, expression(POWERS[operator] - (operator === "^" ? 1 : 0))] };
    }
    return left;
  }

  const tree = expression(0);
  if (rest.length > 0) throw new SyntaxError(`too much in ${text}`);
  return tree;
}
