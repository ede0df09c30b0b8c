/** Designs that the user keeps: in the browser's storage, and as files. No DOM. */

const KEY = "khv-calc.designs";
const FORMAT = "khv-calc designs";
export const MOST = 6; // side by side, of one calculator

function isDesign({ name, calculator, input } = {}) {
  return typeof name === "string" && typeof calculator === "string" && typeof input === "object" && input !== null;
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

/** `storage` is the browser's, or none: then the designs are kept as long as the page. */
export function createDesigns(storage) {
  let designs = [];
  try {
    designs = JSON.parse(storage?.getItem(KEY) ?? "[]").filter(isDesign);
  } catch {
    // What cannot be read is not ours.
  }

  function keep(changed) {
    designs = changed;
    try {
      storage?.setItem(KEY, JSON.stringify(designs));
    } catch {
      // A full or forbidden storage: kept as long as the page.
    }
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
      let file;
      try {
        file = JSON.parse(text);
      } catch {
        return null;
      }
      if (file?.format !== FORMAT || file.v !== 1 || !Array.isArray(file.designs)) return null;
      const added = file.designs.filter(isDesign);
      for (const { name, calculator, input } of added) {
        const taken = of(calculator).some((one) => one.name === name);
        keep([...designs, { name: taken ? free(calculator) : name, calculator, input }]);
      }
      return added.length;
    },
  };
}
