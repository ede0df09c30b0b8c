/**
 * The form as data, made from the service's OpenAPI schema. No DOM, no texts.
 *
 * A *field* is one box: `{ path, name, title, help, kind, symbol, unit, step, lowest, highest, ...}`
 * with the dotted path of its value in the request body; `kind` is "number", "integer", "numbers"
 * (a list), "records" (a list of objects, whose boxes are `columns`), "name" (a text chosen from a
 * list that the service gives), "option" (an enumeration), "flag" (yes or no), "names" (some of an enumeration) or "switch".
 * A *group* that is `wanted` is off until its first field, a switch, is "on"; a field of it is shown
 * only where another one says one of some words, its `when`.
 * A *choice* is a set of options, each with its own fields, of which one option is shown.
 * What is typed into the form and what it says is in form_state.js.
 */
import { unitOf } from "./format.js";
import { DIAMETER } from "./units.js";

function resolver(openapi) {
  const resolve = (schema) => {
    if (schema.$ref) {
      const target = openapi.components.schemas[schema.$ref.split("/").pop()];
      const { $ref, ...own } = schema;
      return resolve({ ...target, ...own });
    }
    if (schema.allOf?.length === 1) {
      const { allOf, ...own } = schema;
      return resolve({ ...resolve(allOf[0]), ...own });
    }
    const variants = schema.anyOf ?? schema.oneOf;
    if (!variants) return schema;
    const real = variants.filter((variant) => variant.type !== "null");
    if (real.length !== 1) return schema;
    const { anyOf, oneOf, ...own } = schema;
    return { ...resolve(real[0]), ...own };
  };
  return resolve;
}

/** The schema of a POST endpoint's body, and the means to resolve its references. */
function bodySchema(openapi, path, words) {
  const resolve = Object.assign(resolver(openapi), { words });
  const body = openapi.paths[path].post.requestBody.content["application/json"].schema;
  return { schema: resolve(body), resolve };
}

function bounds(schema) {
  const lowest = schema.minimum ?? schema.exclusiveMinimum;
  const highest = schema.maximum ?? schema.exclusiveMaximum;
  return {
    lowest,
    highest,
    lowestAllowed: schema.exclusiveMinimum === undefined,
    highestAllowed: schema.exclusiveMaximum === undefined,
  };
}

function kindOf(schema, resolve) {
  if (schema.enum || schema["x-options"]) return "option";
  if (schema.type === "array" && schema.items.enum) return "names";
  if (schema.type === "array" && resolve(schema.items).type === "object") return "records";
  return { number: "number", integer: "integer", array: "numbers", string: "name", boolean: "flag" }[schema.type];
}

/** The words of an enumeration; none of them is one too where nothing has to be said. */
function optionsIn({ enum: words, "x-options": named, default: preset }, required) {
  if (words) return (required || preset ? words : ["", ...words]).map(String);
  return named && ["", ...named];
}

function fieldOf(schema, path, required, resolve) {
  const name = path.split(".").pop();
  const kind = kindOf(schema, resolve);
  const { title, help } = resolve.words(name, schema["x-group"]) ?? { title: schema.title ?? name, help: schema.description ?? "" };
  const limited = kind === "numbers" ? resolve(schema.items) : schema;
  return {
    path,
    name,
    kind,
    title,
    help,
    symbol: schema["x-symbol"] ?? "",
    unit: schema["x-unit"] ?? unitOf(name),
    step: schema["x-step"] ?? (kind === "integer" ? 1 : undefined),
    ...(kind === "option" && schema.type === "integer" && { whole: true }),
    options: optionsIn(schema, required) ?? { flag: ["false", "true"], names: schema.items?.enum }[kind],
    group: schema["x-group"],
    advanced: schema["x-advanced"] ?? false,
    required,
    default: schema.default ?? undefined,
    ...(kind === "records" && { columns: columnsOf(resolve(schema.items), path, resolve) }),
    ...bounds(limited),
  };
}

/** The boxes of one record of a list. */
function columnsOf(record, path, resolve) {
  return Object.entries(record.properties).map(([key, property]) =>
    fieldOf(resolve(property), `${path}.${key}`, (record.required ?? []).includes(key), resolve));
}

/** A property that is a name or an object of its own: the name, or the object's fields. */
function namedOrOwn(schema, path, required, resolve) {
  const variants = (schema.anyOf ?? schema.oneOf ?? []).map(resolve);
  const named = variants.find((variant) => variant.type === "string");
  const own = variants.find((variant) => variant.type === "object");
  if (!named || !own) return null;
  const { anyOf, oneOf, ...about } = schema;
  const name = fieldOf({ ...named, ...about }, path, required, resolve);
  const fields = Object.entries(own.properties).map(([key, property]) =>
    fieldOf(resolve(property), `${path}.${key}`, (own.required ?? []).includes(key), resolve));
  return {
    id: path,
    title: name.title,
    auto: true,
    options: [{ id: "named", fields: [name] }, { id: "own", fields }],
  };
}

function sectionItems(section, path, resolve, hidden) {
  return Object.entries(section.properties)
    .map(([key, property]) => ({ key, property: resolve(property), at: path ? `${path}.${key}` : key }))
    .filter(({ at, property }) => !hidden.includes(at) && property.type !== "object")
    .map(({ key, property, at }) => {
      const required = (section.required ?? []).includes(key);
      return namedOrOwn(property, at, required, resolve) ?? fieldOf(property, at, required, resolve);
    });
}

/** Gather the fields that belong to a choice where the first of them stands. */
function withChoices(items, choices, optional) {
  const byPath = new Map(items.map((item) => [item.path ?? item.id, item]));
  // What distinguishes an option has to be given, unless it is said to be optional.
  const fieldAt = (path) => {
    const field = byPath.get(path);
    return { ...field, required: !optional.includes(path) && field.default === undefined };
  };
  const placed = new Set();
  return items.flatMap((item) => {
    const path = item.path ?? item.id;
    const [id, options] = Object.entries(choices).find(([, all]) => Object.values(all).flat().includes(path)) ?? [];
    if (!id) return [item];
    if (placed.has(id)) return [];
    placed.add(id);
    return [{ id, options: Object.entries(options).map(([option, paths]) => ({ id: option, fields: paths.map(fieldAt) })) }];
  });
}

/** Groups of a flat body: each field says its own; the objects named `inline` stand among them. */
function groupsByField(schema, { groups, inline, hidden, resolve }) {
  const items = [
    ...sectionItems(schema, "", resolve, hidden),
    ...inline.flatMap((key) => sectionItems(resolve(schema.properties[key]), key, resolve, hidden)),
  ];
  return groups.map((id) => ({ id, items: items.filter((item) => item.group === id) }));
}

/**
 * The model of an endpoint's form.
 *
 * `groups` names the parts of the body in the order shown, or, where `inline` is given, the groups
 * that the fields of a flat body name themselves; `choices` says which fields exclude each other,
 * `{ choice: { option: [path] } }`, and `optional` which of them may be left empty; `hidden` what the
 * page decides for the user, `neededBy` further endpoints that are asked, whose schemas say which fields they need (`x-needs`), `requirements`, where it is given, the only ones that are asked for; `arranged` puts them in groups of the page's own; `suggestions` says which
 * boxes follow others while they are empty (`linked`); `moved` the older path of a field, by its path; `diameters` has title and help, by name, of
 * radii that are shown as diameters; `wanted` are groups that are off until wanted; `words(name, group)` gives title and help of a field, or null for
 * those of the schema.
 */
export function formModel(openapi, {
  path, groups, inline, requirements, choices = {}, optional = [], neededBy = [], hidden: kept = [], arranged = null, suggestions = {}, diameters = null, moved = {},
  wanted = [], words = () => null,
}) {
  const { schema, resolve } = bodySchema(openapi, path, words);
  const others = requirements ? Object.keys(resolve(schema.properties.requirements).properties).filter((name) => !requirements.includes(name)) : [];
  const hidden = [...kept, ...others.map((name) => `requirements.${name}`), ...wanted.flatMap(({ fields }) => Object.keys(fields))];
  const plain = inline
    ? groupsByField(schema, { groups, inline, hidden, resolve })
    : groups.map((id) => ({ id, items: sectionItems(resolve(schema.properties[id]), id, resolve, hidden) }));
  const parts = plain.map((part) => ({
    ...part,
    items: withChoices(part.items, choices, optional).map((item) => (diameters ? asDiameter(item, diameters) : item)),
  }));
  const items = parts.flatMap((part) => part.items);
  // What follows another box is always said, be it by that one: figures need it too.
  const pathOf = (view) => path.replace(/[^/]*$/, view);
  const needed = [path, ...neededBy.map(pathOf)].flatMap((each) => bodySchema(openapi, each, words).schema["x-needs"] ?? []).map((pointer) => pointer.slice(1).replaceAll("/", "."));
  for (const field of items.flatMap(fieldsOf)) field.required ||= needed.includes(field.path) || Boolean(suggestions[field.path]?.needs);
  const besides = wanted.map(({ view, ...group }) => wantedGroup(openapi, { path: view ? pathOf(view) : path, ...group }, words))
    .map((group) => (diameters ? { ...group, items: group.items.map((item) => asDiameter(item, diameters)) } : group));
  const every = [...items, ...besides.flatMap((group) => group.items)];
  const fields = new Map(every.flatMap(fieldsOf).map((field) => [field.path, field]));
  const linked = Object.entries(suggestions).filter(([at, { linked: follows }]) => follows && fields.has(at));
  return {
    diameters: Boolean(diameters), moved, groups: [...arranged ? inOrder(items, arranged) : parts, ...besides], choices: every.filter((item) => !item.path), fields, linked,
  };
}

/** A property of an object, an entry of a list. */
function stepInto({ properties, items }, key) {
  return /^\d+$/.test(key) ? items : properties?.[key];
}

const rawAt = (schema, at, resolve) => at.split(".").reduce((part, key) => part && stepInto(resolve(part), key), schema);

/** The schema of a part of a body, by its dotted path; of what may be a number or more, the number. */
function partAt(schema, at, resolve) {
  const found = rawAt(schema, at, resolve);
  if (!found) return null;
  const { anyOf, oneOf, ...about } = resolve(found);
  const number = (anyOf ?? oneOf ?? []).map(resolve).find(({ type }) => type === "number");
  return number ? { ...number, ...about } : resolve(found);
}

/** What a pattern such as `^(f|g)(5|6)$` allows. */
function allowedBy(pattern) {
  return pattern.match(/\(([^)]*)\)/g).map((part) => part.slice(1, -1).split("|"))
    .reduce((all, next) => all.flatMap((start) => next.map((end) => start + end)), [""]);
}

/**
 * A group that is off until wanted: its switch, and fields of the body of the calculator's endpoint, or of a `view` beside that, by their paths.
 * What is said of a field stands above its schema, or that of the field that it is `like`: `when`, `words` (name and group of its title, and values put in), `options` besides those
 * of the schema, `needs` (another group that has to be on), `empty` (what an empty box says), `follows` (the list that stands for an empty one, from the other boxes), `rows` and `columns` of a list of records that the body has as lists, own values that are left out (`without`). A group is not `judged` where the verdict
 * does not hang on it, and off while one is that it `needs`.
 */
function wantedGroup(openapi, { id, path, fields, needs, judged = true }, words) {
  const { schema, resolve } = bodySchema(openapi, path, words);
  const made = (at, { words: [name, group, values] = [], like = at, ...own }) => {
    let part = partAt(schema, like, resolve) ?? {};
    while (part.type === "array" && own.leaf) part = { ...part, ...resolve(part.items) };
    const { default: preset = part.default, required = false, options = [], ...rest } = own;
    const field = fieldOf({ ...part, default: preset, "x-group": group ?? part["x-group"] }, at, required, resolve);
    const named = name && words(name, group, values);
    return {
      ...field,
      ...named,
      ...(part.enum && { options: [...options, ...part.enum] }),
      ...(part.pattern && { kind: "option", options: [...options, ...allowedBy(part.pattern)] }),
      ...(!part.type && options.length > 0 && { kind: "option", options }),
      ...(part.type === "array" && part.items.enum && { kind: "names", options: part.items.enum }),
      ...rest,
    };
  };
  /** A name of a table or values of its own, else one field. */
  const item = (at, { without = [], ...own }) => {
    const raw = rawAt(schema, at, resolve);
    const choice = raw && namedOrOwn(resolve(raw), at, false, resolve);
    if (!choice) return { ...made(at, own), wanted: id };
    return { ...choice, options: choice.options.map((option) => ({
      ...option, fields: option.fields.filter(({ name }) => !without.includes(name)).map((field) => ({ ...field, ...(own.when && { when: own.when }), wanted: id })),
    })) };
  };
  const items = Object.entries({ [`${id}.on`]: { kind: "switch", words: ["on", id] }, ...fields }).map(([at, { columns, ...own }]) => ({
    ...item(at, own),
    ...(columns && {
      kind: "records",
      columns: columns.map((column) => made(column, { leaf: true, path: `${at}.${column.split(".").pop()}` })),
      covers: columns,
    }),
  }));
  return { id, wanted: true, needs, judged, items };
}

/** The items in groups of the page's own, `{ group: [path or choice] }`; the last takes what is not named. */
function inOrder(items, arranged) {
  const named = Object.values(arranged).flat();
  const at = (id) => items.find((item) => (item.path ?? item.id) === id);
  const rest = items.filter((item) => !named.includes(item.path ?? item.id));
  return Object.entries(arranged).map(([id, ids], i, all) =>
    ({ id, items: [...ids.map(at).filter(Boolean), ...(i === all.length - 1 ? rest : [])] }));
}

/** A field of a radius that is shown and typed as a diameter. */
function asDiameter(item, words) {
  if (!item.path) return { ...item, options: item.options.map((option) => ({ ...option, fields: option.fields.map((field) => asDiameter(field, words)) })) };
  if (item.kind !== "number" || !(item.name in words)) return item;
  return { ...item, ...words[item.name], unit: DIAMETER, symbol: `2${item.symbol}` };
}

/** Symbols of the quantities of each section of the answers, `{ section: { name: symbol } }`; those of a part of one by its name and theirs too. */
export function symbolsIn(openapi) {
  const resolve = resolver(openapi);
  const propertiesOf = (schema) => {
    const { properties, anyOf, oneOf = anyOf ?? [] } = resolve(schema);
    return Object.assign({}, properties, ...oneOf.map(propertiesOf)); // of each kind, where it has several
  };
  const symbolsOf = (schema, part) => {
    const own = Object.entries(propertiesOf(schema));
    const parts = own.map(([name, property]) => symbolsOf(property, name)).reverse();
    const said = own.map(([name, property]) => [name, resolve(property)["x-symbol"]]).filter(([, symbol]) => symbol)
      .flatMap(([name, symbol]) => [[name, symbol], ...part ? [[`${part}_${name}`, symbol]] : []]);
    return Object.assign({}, ...parts, Object.fromEntries(said));
  };
  const answers = Object.entries(openapi.paths).flatMap(([path, { post }]) => {
    const schema = post?.responses["200"]?.content["application/json"]?.schema;
    return schema ? [[path.split("/").pop().replaceAll("-", "_"), schema]] : [];
  });
  const sections = answers.flatMap(([name, schema]) => [[name, schema], ...Object.entries(propertiesOf(schema))]);
  const found = {};
  for (const [section, schema] of sections.filter(([, one]) => "accuracy" in propertiesOf(one))) {
    found[section] = { ...found[section], ...symbolsOf(schema) };
  }
  return found;
}

/** Title and help of every field of a form by its name, or by group and name where groups differ. */
export function fieldTexts({ components }) {
  const texts = {};
  for (const { properties = {} } of Object.values(components.schemas)) {
    for (const [name, { title, description: help = "", "x-group": group }] of Object.entries(properties)) {
      if (group) (texts[name] ??= {})[group] = { title, help };
    }
  }
  const alike = (own) => new Set(Object.values(own).map((one) => JSON.stringify(one))).size === 1;
  return Object.fromEntries(Object.entries(texts).flatMap(([name, own]) =>
    (alike(own) ? [[name, Object.values(own)[0]]] : Object.entries(own).map(([group, one]) => [`${group}.${name}`, one]))));
}

/** The fields of an item: itself, or those of all options of a choice. */
export function fieldsOf(item) {
  return item.path ? [item] : item.options.flatMap(({ fields }) => fields);
}

/** Where what a check misses is entered: the field itself; of an entry of a table or of a part, the first of its own values that may be empty. */
export function entryOf({ choices, fields }, path) {
  const own = choices.find(({ id, auto }) => auto && id === path)?.options.find(({ id }) => id === "own");
  const parts = fields.has(path) ? [] : [...fields.values()].filter((field) => field.path.startsWith(`${path}.`));
  return (own?.fields ?? parts).find((field) => !field.required && field.default === undefined)?.path ?? path;
}

/** The options that show a field, `{ choice: option }`. */
export function optionsOf({ choices }, path) {
  const option = ({ options }) => options.find(({ fields }) => fields.some((field) => field.path === path))?.id;
  return Object.fromEntries(choices.map((choice) => [choice.id, option(choice)]).filter(([, id]) => id));
}
