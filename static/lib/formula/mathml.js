/** Formulas written as MathML, with symbols or with numbers put in; and as plain text. No DOM. */
import { formatNumber, quantityParts } from "../format.js";
import { html } from "../html.js";
import { picked, termCount } from "./evaluate.js";

const ADD = 1;
const MULTIPLY = 2;
const POWER = 3;
const ATOM = 4;
const WRITTEN_TERMS = 4; // of a sum with numbers; of a longer one, and of integrals, some and the last
const FUNCTION_NAMES = { atan: "arctan", acos: "arccos" };

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
  sum: (inner) => html`<munder><mo>∑</mo><mi>i</mi></munder>${inner}`,
  gap: (first, last) => html`${first}<mo>+</mo><mo>…</mo><mo>+</mo>${last}`,
  integral: (inner, from, to, name) => html`<msubsup><mo>∫</mo><mrow>${from}</mrow><mrow>${to}</mrow></msubsup>${inner}<mspace width="0.2em"></mspace><mi>d</mi><mi>${name}</mi>`,
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
  sum: (inner) => `∑ ${inner}`,
  gap: (first, last) => `${first} + … + ${last}`,
  integral: (inner, from, to, name) => `∫[${from} … ${to}] ${inner} d${name}`,
};

/** `E*_1` as its letter, what stands below and what above. */
function symbolParts(symbol, index) {
  const [name, below = ""] = symbol.split("_");
  const base = name.replace("*", "");
  return [base, index === undefined ? below : below.replace(/\bi\b/, index + 1), name === base ? "" : "*"];
}

function writer(style, { values, withNumbers, digits }) {
  const atom = (written, priority = ATOM, number = false) => ({ written, priority, number });
  const within = (part, least) => (part.priority < least ? style.parentheses(part.written) : part.written);

  function amount(value, unit) {
    const whole = !unit && Number.isInteger(value);
    const { value: text, unit: shown } = quantityParts(Math.abs(value), unit, whole ? 15 : digits);
    const written = style.number(text, shown);
    // A unit, a power of ten: what is raised to a power then needs parentheses.
    const plain = atom(written, unit || /10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+$/.test(text) ? MULTIPLY : ATOM, true);
    return value < 0 ? atom(style.negative(written), ADD, true) : plain;
  }

  function name(tree, known) {
    const value = known[tree.name];
    if (!value) return atom(style.symbol(tree.name, "", ""));
    if (withNumbers && !value.formula) return amount(value.value, value.unit);
    return atom(style.symbol(...symbolParts(value.symbol, withNumbers ? value.index : undefined)));
  }

  function operation({ operator, of }, known) {
    if (operator === "neg") return atom(style.negative(within(write(of[0], known), MULTIPLY)), ADD);
    const [left, right] = of.map((part) => write(part, known));
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

  function sum(term, known) {
    if (!withNumbers) return atom(style.sum(within(write(term, known), MULTIPLY)), ADD);
    const count = termCount(term, known);
    const at = (i) => {
      const part = write(term, picked(known, i));
      return i === 0 ? part.written : within(part, MULTIPLY);
    };
    const plus = (from, to) => Array.from({ length: to - from }, (_, i) => at(from + i))
      .reduce((left, right) => style.operator(left, "+", right));
    if (count === 1) return write(term, picked(known, 0));
    const integrals = term.call === "integral";
    if (count <= (integrals ? 2 : WRITTEN_TERMS)) return atom(plus(0, count), ADD);
    const first = plus(0, integrals ? 1 : 2);
    return atom(style.gap(first, at(count - 1)), ADD);
  }

  function call({ call: named, of, bound }, known) {
    if (named === "sum") return sum(of[0], known);
    if (named === "integral") {
      const { [bound]: _, ...inner } = known;
      return atom(style.integral(
        within(write(of[0], inner), MULTIPLY), write(of[1], known).written, write(of[2], known).written, bound,
      ), MULTIPLY);
    }
    const args = of.map((part) => write(part, known).written);
    if (named === "sqrt") return atom(style.root(args[0]));
    if (named === "abs") return atom(style.absolute(args[0]));
    return atom(style.call(FUNCTION_NAMES[named] ?? named, args), POWER);
  }

  function write(tree, known) {
    if (tree.number !== undefined) return atom(style.number(formatNumber(tree.number, 15), ""), ATOM, true);
    if (tree.name) return name(tree, known);
    return tree.operator ? operation(tree, known) : call(tree, known);
  }

  return (tree) => write(tree, values).written;
}

/** A tree as the inside of a `<math>` element. */
export function mathml(tree, { values, withNumbers = false, digits = 6 }) {
  return writer(MATHML, { values, withNumbers, digits })(tree);
}

/** A tree in one line of text, for those who hear it. */
export function plainText(tree, { values, withNumbers = false, digits = 6 }) {
  return writer(PLAIN, { values, withNumbers, digits })(tree);
}

export function mathSymbol(symbol) {
  return MATHML.symbol(...symbolParts(symbol));
}

export function plainSymbol(symbol) {
  return PLAIN.symbol(...symbolParts(symbol));
}
