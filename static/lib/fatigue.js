/** What the fatigue of a part is judged by: the fields of a group that is off until wanted. No DOM. */
const rare = { advanced: true };

/** The fields; `way` is the path of the choice between `ways`, the first of which is chosen to begin with. */
export function fatigueFields(way, ways) {
  const by = (...some) => ({ when: [way, ...some] });
  const made = ways.filter((each) => each !== "endurance_limit" && each !== "plain");
  return {
    [way]: { options: ways, default: ways[0], words: ["fatigue", "strength"] },
    "fatigue.surface": { ...by(...made), default: "machined" },
    "fatigue.fatigue_notch_factor": by("notch_factor"),
    "fatigue.notch.theoretical_factor": { ...by("notch"), required: true },
    "fatigue.notch.radius_mm": { ...by("notch"), required: true },
    "fatigue.reliability_percent": by(...made),
    "fatigue.endurance_limit_MPa": { ...by("endurance_limit"), required: true },
    "fatigue.criterion": { ...rare, ...by(...made, "endurance_limit") },
    "fatigue.edition": { ...rare, ...by(...made) },
  };
}

/** A group of fatigue of a calculator whose request has it beside `also`, fields of its own. */
export const enduranceOf = (also) => ({
  id: "endurance",
  fields: { ...also, ...fatigueFields("endurance.fatigue", ["notch_factor", "notch", "endurance_limit"]), "requirements.fatigue_safety": rare },
  starts: () => ({ "fatigue.reliability_percent": 99 }),
});

/** A request: the form's own fields, and those of the groups that are on, `{ id: [name] }`. */
export function requestOf({ besides = {}, ...input }, groups) {
  const names = Object.keys(groups).filter((id) => besides[id]?.on === "on").flatMap((id) => groups[id]);
  const { requirements } = besides;
  return {
    ...input,
    ...Object.fromEntries(Object.entries(besides).filter(([name]) => names.includes(name))),
    ...(requirements && { requirements: { ...input.requirements, ...requirements } }),
  };
}
