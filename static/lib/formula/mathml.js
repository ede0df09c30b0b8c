/**
 * Formulas written as MathML, with symbols or with numbers put in; and as plain text. No DOM.
 *
 * `values` are `{ name: { value, unit } }` of a formula's names, in canonical units. A name is written as its symbol: a Greek
 * letter by its name, then after `_` what stands below, `star` and `prime` above: `Delta_prime_B`, `E_star`, `gamma_1_2`.
 */
import { ALL, formatNumber, quantityParts } from "../format.js";
import { html } from "../html.js";

const ADD = 1;
const MULTIPLY = 2;
const POWER = 3;
const ATOM = 4;
const FUNCTION_NAMES = { asin: "arcsin", acos: "arccos", atan: "arctan" };
const GREEK = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", Delta: "Δ", eps: "ε", epsilon: "ε", eta: "η", theta: "θ", lambda: "λ", mu: "μ", nu: "ν", pi: "π",
  rho: "ρ", sigma: "σ", tau: "τ", phi: "φ", chi: "χ", psi: "ψ", Psi: "Ψ",
};

/** The two ways of writing: what each part becomes, given its written parts. */
const MATHML = {
  number: (text, unit) => html`<mn>${text}</mn>${unit && html`<mtext>${unit === "°" ? "°" : `\u202f${unit}`}</mtext>`}`,
  symbol(base, below, above) {
    const [name, sub, sup] = [html`<mi>${base}</mi>`, html`<mi>${below}</mi>`, html`<mo>${above}</mo>`];
    if (below && above) return html`<msubsup>${name}${sub}${sup}</msubsup>`;
    if (below) return html`<msub>${name}${sub}</msub>`;
    return above ? html`<msup>${name}${sup}</msup>` : name;
  },
  operator: (left, sign, right) => html`${left}<mo>${sign}</mo>${right}`,
  beside: (left, right) => html`${left}<mo>\u2062</mo><mspace width="0.12em"></mspace>${right}`,
  negative: (inner) => html`<mo form="prefix">\u2212</mo>${inner}`,
  parentheses: (inner) => html`<mrow><mo>(</mo>${inner}<mo>)</mo></mrow>`,
  fraction: (above, below) => html`<mfrac><mrow>${above}</mrow><mrow>${below}</mrow></mfrac>`,
  power: (base, exponent) => html`<msup><mrow>${base}</mrow><mrow>${exponent}</mrow></msup>`,
  root: (inner) => html`<msqrt>${inner}</msqrt>`,
  absolute: (inner) => html`<mrow><mo>|</mo>${inner}<mo>|</mo></mrow>`,
  call: (name, args) => html`<mi>${name}</mi><mo>\u2061</mo><mrow><mo>(</mo>${args.map((arg, i) =>
    html`${i > 0 && html`<mo separator="true">;</mo><mspace width="0.3em"></mspace>`}${arg}`)}<mo>)</mo></mrow>`,
};
const PLAIN = {
  number: (text, unit) => text + (unit === "°" ? "°" : unit && ` ${unit}`),
  symbol: (base, below, above) => base + (above || "") + (below ? ` ${below}` : ""),
  operator: (left, sign, right) => `${left} ${sign} ${right}`,
  beside: (left, right) => `${left} · ${right}`,
  negative: (inner) => `\u2212${inner}`,
  parentheses: (inner) => `(${inner})`,
  fraction: (above, below) => `(${above}) / (${below})`,
  power: (base, exponent) => `${base}^(${exponent})`,
  root: (inner) => `√(${inner})`,
  absolute: (inner) => `|${inner}|`,
  call: (name, args) => `${name}(${args.join("; ")})`,
};

const letterOf = (name) => GREEK[name] ?? name;

/** A name as its letter, what stands below and what above. */
function symbolParts(name) {
  const [letter, ...rest] = name.split("_");
  const base = letterOf(letter) + (rest.includes("prime") ? "′" : "");
  const below = rest.filter((part) => !["prime", "star"].includes(part)).map(letterOf).join(",");
  return [base, below, rest.includes("star") ? "*" : ""];
}

function writer(style, { values, withNumbers, digits }) {
  const atom = (written, priority = ATOM, number = false) => ({ written, priority, number });
  const within = (part, least) => (part.priority < least ? style.parentheses(part.written) : part.written);

  function amount(value, unit) {
    const whole = !unit && Number.isInteger(value);
    const { value: text, unit: shown } = quantityParts(Math.abs(value), unit, whole ? ALL : digits);
    const written = style.number(text, shown);
    // A unit, a power of ten: what is raised to a power then needs parentheses.
    const plain = atom(written, unit || /10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+$/.test(text) ? MULTIPLY : ATOM, true);
    return value < 0 ? atom(style.negative(written), ADD, true) : plain;
  }

  function name({ name: own }) {
    const known = values[own];
    return withNumbers && known ? amount(known.value, known.unit) : atom(style.symbol(...symbolParts(own)));
  }

  function operation(tree) {
    const { operator, of } = tree;
    if (operator === "neg") return atom(style.negative(within(write(of[0]), MULTIPLY)), ADD);
    const [left, right] = of.map(write);
    switch (operator) {
      case "+": return atom(style.operator(left.written, "+", within(right, right.number ? MULTIPLY : ADD)), ADD);
      case "-": return atom(style.operator(left.written, "\u2212", within(right, MULTIPLY)), ADD);
      case "/": return atom(style.fraction(left.written, right.written), MULTIPLY);
      case "^": return atom(style.power(within(left, ATOM), right.written), POWER);
      default: {
        const [a, b] = [within(left, MULTIPLY), within(right, MULTIPLY)];
        const beside = !withNumbers && !right.number;
        return { ...atom(beside ? style.beside(a, b) : style.operator(a, "·", b), MULTIPLY), number: left.number };
      }
    }
  }

  function call({ call: named, of }) {
    const args = of.map((part) => write(part).written);
    if (named === "sqrt") return atom(style.root(args[0]));
    if (named === "abs") return atom(style.absolute(args[0]));
    return atom(style.call(FUNCTION_NAMES[named] ?? named, args), POWER);
  }

  function write(tree) {
    if (tree.number !== undefined) return atom(style.number(formatNumber(tree.number), ""), ATOM, true);
    if (tree.name) return name(tree);
    return tree.operator ? operation(tree) : call(tree);
  }

  return (tree) => write(tree).written;
}

/** A tree as the inside of a `<math>` element. */
export function mathml(tree, { values = {}, withNumbers = false, digits = 6 } = {}) {
  return writer(MATHML, { values, withNumbers, digits })(tree);
}

/** A tree in one line of text, for those who hear it. */
export function plainText(tree, { values = {}, withNumbers = false, digits = 6 } = {}) {
  return writer(PLAIN, { values, withNumbers, digits })(tree);
}

export function mathSymbol(symbol) {
  return MATHML.symbol(...symbolParts(symbol));
}

export function plainSymbol(symbol) {
  return PLAIN.symbol(...symbolParts(symbol));
}
