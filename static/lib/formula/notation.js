/**
 * Formulas as trees, read from a line of the service like `sqrt(w*E_star/(pi*rho))`. No DOM, no texts.
 *
 * Infix over names, with `+ - * / ^ ( )` and functions, whose arguments a comma parts.
 */
const TOKEN = /\s*(?:(\d+(?:\.\d+)?)|([A-Za-z_]\w*)|(.))/y;
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

/** `{ number }`, `{ name }`, `{ call, of: [trees] }` or `{ operator, of: [trees] }`. */
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
    while (at(",")) {
      rest.shift();
      of.push(expression(0));
    }
    take(")");
    return { call: name, of };
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
