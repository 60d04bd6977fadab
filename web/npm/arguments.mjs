// What the calls of the module take. Another type is a mistake of the program and throws a TypeError; what values of the
// right type say is for the engine to judge, which answers with faults.

const isText = (value) => typeof value === "string";
const isNumber = (value) => typeof value === "number";
// Neither a list nor bytes, nor the promise of a file that was not awaited. By its name, since it may be of another realm.
const isTable = (value) => Object.prototype.toString.call(value) === "[object Object]";
const isContent = (value) => isText(value) || Object.prototype.toString.call(value) === "[object Uint8Array]";
const isTextOrNumber = (value) => isText(value) || isNumber(value);
const isListOf = (value, is) => Array.isArray(value) && value.every(is);
const isTableOf = (value, is) => isTable(value) && Object.values(value).every(is);
const systems = ["si", "us", "engineering-metric"];

const kinds = {
  text: [isText, "a text"],
  name: [(value) => isText(value) && value !== "", "a text that is not empty"],
  flag: [(value) => typeof value === "boolean", "true or false"],
  number: [isNumber, "a number"],
  quantity: [isTextOrNumber, "a number in SI or a text with its unit"],
  units: [(value) => systems.includes(value), '"si", "us" or "engineering-metric"'],
  settings: [(value) => isListOf(value, isText) || isTableOf(value, isTextOrNumber), 'a list of "KEY=VALUE" or an object of texts and numbers'],
  limits: [(value) => isText(value) || isListOf(value, isText), "a text or a list of texts"],
  content: [isContent, "a text or a Uint8Array"],
  files: [(value) => isTableOf(value, isContent) && !Object.hasOwn(value, ""), "an object of texts and Uint8Arrays by their names"],
  case: [(value) => isText(value) || isTable(value), "the text of a case file or an object of its tables"],
  options: [isTable, "an object"],
};

const kind_of = {
  all: "flag",
  dropHeight: "quantity",
  file: "name",
  files: "files",
  intervals: "flag",
  keepNose: "flag",
  keepSpeed: "flag",
  mass: "quantity",
  radius: "quantity",
  settings: "settings",
  speed: "quantity",
  standard: "text",
  tolerance: "number",
  units: "units",
};
const more_of = { "solve-for": { until: "limits" } };

function shown(value) {
  if (isText(value)) return `"${value.length > 40 ? `${value.slice(0, 40)}...` : value}"`;
  if (Array.isArray(value)) return "a list";
  return typeof value === "object" && value !== null ? Object.prototype.toString.call(value).slice(8, -1) : String(value);
}

// `what` is the argument as a message calls it.
export function needArgument(what, kind, value) {
  const [is, words] = kinds[kind];
  if (!is(value)) throw new TypeError(`${what} must be ${words}, not ${isTable(value) ? "this object" : shown(value)}`);
}

// `meant` says which of some words may be meant.
export function needOptions(request, options, meant) {
  needArgument("the options", "options", options);
  const known = { ...kind_of, ...more_of[request] };
  for (const [name, value] of Object.entries(options)) {
    if (!Object.hasOwn(known, name)) throw new TypeError(`unknown option "${name}"${meant(name, Object.keys(known))}`);
    if (value !== undefined) needArgument(name, known[name], value);
  }
}
