/** Designs that the user keeps: in the browser's storage, and as files. No DOM. */
import { parsed } from "./storage.js";

const KEY = "khv-calc.designs";
const FORMAT = "khv-calc designs";
export const MOST = 6; // side by side, of one calculator

function isDesign(one) {
  return typeof one?.name === "string" && typeof one.calculator === "string" && typeof one.input === "object" && one.input !== null;
}

/** A, B, … and then A2, B2, …: the first that is free. */
function freeName(taken) {
  for (let round = 1; ; round += 1) {
    for (const letter of "ABCDEFGHIJKLMNOPQRSTUVWXYZ") {
      const name = round === 1 ? letter : `${letter}${round}`;
      if (!taken.includes(name)) return name;
    }
  }
}

/** `storage` is the browser's (lib/storage.js). */
export function createDesigns(storage) {
  const found = parsed(storage.getItem(KEY), []);
  let designs = Array.isArray(found) ? found.filter(isDesign) : [];

  function keep(changed) {
    designs = changed;
    storage.setItem(KEY, JSON.stringify(designs));
  }

  const of = (calculator) => designs.filter((design) => design.calculator === calculator);
  const free = (calculator) => freeName(of(calculator).map(({ name }) => name));
  return {
    of,
    /** Keep an input (the canonical request) under a free letter. */
    add(calculator, input) {
      const design = { name: free(calculator), calculator, input };
      keep([...designs, design]);
      return design;
    },
    rename(design, name) {
      const wanted = name.trim();
      const taken = of(design.calculator).some((one) => one !== design && one.name === wanted);
      if (wanted !== "" && !taken) keep(designs.map((one) => (one === design ? { ...one, name: wanted } : one)));
    },
    remove: (design) => keep(designs.filter((one) => one !== design)),
    /** All designs as the text of a file. */
    exported: () => `${JSON.stringify({ format: FORMAT, v: 1, designs }, null, 2)}\n`,
    /** Add the designs of a file; how many, or null where it is none of ours. */
    imported(text) {
      const file = parsed(text, {});
      if (file.format !== FORMAT || file.v !== 1 || !Array.isArray(file.designs)) return null;
      const added = file.designs.filter(isDesign);
      for (const { name, calculator, input } of added) {
        const taken = of(calculator).some((one) => one.name === name);
        keep([...designs, { name: taken ? free(calculator) : name, calculator, input }]);
      }
      return added.length;
    },
  };
}
