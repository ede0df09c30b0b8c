/** The inputs of a design, the defaults filled in. No DOM. */
import { shownFields } from "../schema_form.js";

function at(input, path) {
  return path.split(".").reduce((part, name) => part?.[name], input);
}

function withValue(part, [name, ...rest], value) {
  return { ...part, [name]: rest.length === 0 ? value : withValue(part?.[name], rest, value) };
}

/** The request's input with the defaults of all fields that it leaves out. */
export function filledInput(model, state, input) {
  return shownFields(model, state)
    .filter((field) => field.default !== undefined && field.default !== null && at(input, field.path) === undefined)
    .reduce((filled, { path, default: value }) => withValue(filled, path.split("."), value), input);
}

/** The fields on the form with their values, by groups: `[{ id, entries: [{ field, value }] }]`. */
export function listedInputs(model, state, input) {
  const shown = new Set(shownFields(model, state).map(({ path }) => path));
  return model.groups.map((group) => ({
    id: group.id,
    entries: group.items.flatMap((item) => (item.path ? [item] : item.options.flatMap(({ fields }) => fields)))
      .filter(({ path }, i, all) => shown.has(path) && all.findIndex((one) => one.path === path) === i)
      .map((field) => ({ field, value: at(input, field.path) }))
      .filter(({ value }) => value !== undefined && value !== null),
  })).filter(({ entries }) => entries.length > 0);
}
