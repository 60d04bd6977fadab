// Reads a command line as the native command does. Commands and options that only that one has are known by name.

const value = (type, help) => ({ type, help });
const list = (type, help) => ({ type, help, isList: true });
const flag = (help) => ({ help });

const json = value("FILE", "Write the result as JSON, in SI units and g (- for standard output)");
const documents = {
  "--report": value("FILE", "Write a page for a web browser, as a single HTML file"),
  "--markdown": value("FILE", "Write the text of the page as Markdown, without pictures (- for standard output)"),
};
const set = { "--set": list("KEY=VALUE", 'Replace a value in the case, as in pad.thickness="30 mm"; may be repeated') };
const units = { "--units": value("SYSTEM", "Units of the output: si (default), us or engineering-metric") };
const force = { "--force": flag("Overwrite existing files") };
const solving = {
  ...units,
  "--all": flag("Show every figure to five digits, with its error"),
  "--tolerance": value("X", "Relative error allowed, from 1e-8 to 1e-2 (default: as in the case, otherwise 1e-4)"),
  "--no-intervals": flag("Omit the uncertainty intervals, which require solving further impacts"),
  ...force,
};
const materials = { "--materials": value("DIR", "Folder of material cards (default: $DASHPAD_MATERIALS, or the cards supplied)") };
const standards = { "--standards": value("DIR", "Folder of presets (default: $DASHPAD_STANDARDS, or the presets supplied)") };
const standard = { "--standard": list("NAME[:VARIANT]", "Standard, with any variants (see dashpad standards)") };
const until = { "--until": list("LIMIT", 'Keep a limit, such as "hic15 <= 700"; may be repeated') };

export const commands = {
  run: {
    help: "Solve one case and show or write the result",
    positionals: ["CASE"],
    options: { ...set, "--json": json, ...documents, ...solving, ...materials },
    native: ["--csv", "--png", "--drawing"],
  },
  check: {
    help: "Show how a case is interpreted, or what is wrong with it",
    positionals: ["CASE"],
    options: { ...set, ...units, "--json": flag("Print the case, or its errors, as JSON"), ...materials },
    only_looks: true,
  },
  assess: {
    help: "Compare a case with the limits of a test standard",
    positionals: ["CASE"],
    required: ["--standard"],
    options: {
      ...set,
      ...standard,
      "--speed": value("V", 'Impact speed, such as "15 mph"'),
      "--drop-height": value("H", "Free-fall height, instead of the speed"),
      "--mass": value("M", 'Mass of the impactor, such as "6.8 kg"'),
      "--radius": value("R", 'Radius of the sphere, such as "82.5 mm"'),
      "--keep-nose": flag("Use the nose of the case, not that of the standard"),
      "--keep-speed": flag("Use the speed of the case, not that of the standard"),
      "--json": json,
      ...documents,
      ...solving,
      ...standards,
      ...materials,
    },
  },
  "solve-for": {
    help: "Find the value at which a verdict changes, such as the least thickness that passes",
    positionals: ["KEY", "CASE"],
    options: { ...set, ...standard, ...until, "--json": json, ...documents, ...solving, ...standards, ...materials },
    native: ["--between", "--vary", "--probability", "--draws", "--seed", "--csv", "--picture"],
  },
  materials: {
    help: "List the material cards, or show one",
    positionals: ["[NAME]"],
    options: { ...documents, ...units, ...force, ...materials },
    native: ["--picture"],
    only_looks: true,
  },
  standards: {
    help: "List the presets of test standards, or show one",
    positionals: ["[NAME]"],
    options: { ...documents, ...units, ...force, ...standards },
    only_looks: true,
  },
};

export const native_commands = ["fall-height", "sensitivity", "explore", "pulse", "export", "post-impact", "compare",
  "material", "material-test", "fit", "study", "batch", "spit1984", "validate"];

export const unit_systems = ["si", "us", "engineering-metric"];

// Thrown for a command line that is not understood.
export class Misread extends Error {}

const isOption = (word) => /^(--[^-]|-[A-Za-z])/.test(word);

// The values of options and positionals by their names; lists as arrays, flags as true.
export function parsed(name, words) {
  const command = commands[name];
  const given = {};
  const extras = [];
  const positionals = command.positionals.map((each) => each.replace(/[[\]]/g, ""));
  const places = [...positionals];
  let onlyPositionals = false;
  for (let i = 0; i < words.length; ++i) {
    const word = words[i];
    if (onlyPositionals || !isOption(word)) {
      if (word === "--" && !onlyPositionals) onlyPositionals = true;
      else if (places.length > 0) given[places.shift()] = word;
      else extras.push(word);
      continue;
    }
    if (word === "-h" || word === "--help") return { help: true };
    const sign = word.indexOf("=");
    const option = sign < 0 ? word : word.slice(0, sign);
    const known = command.options[option];
    if (command.native?.includes(option))
      throw new Misread(`${option}: is not in this package; the native command has it`);
    if (!known) {
      extras.push(word);
    } else if (!known.type) {
      if (sign >= 0) throw new Misread(`${option.slice(2)} was given a disallowed flag override`);
      given[option] = true;
    } else {
      if (sign < 0 && (i + 1 === words.length || isOption(words[i + 1])))
        throw new Misread(`${option}: 1 required ${known.type} missing`);
      (given[option] ??= []).push(sign < 0 ? words[++i] : word.slice(sign + 1));
    }
  }
  if (given["--units"] && !unit_systems.includes(given["--units"].at(-1)))
    throw new Misread(`--units: ${given["--units"].at(-1)} not in {${unit_systems}}`);
  for (const [option, values] of Object.entries(given))
    if (Array.isArray(values) && !command.options[option].isList) {
      if (values.length > 1) throw new Misread(`${option}: At Most 1 required but received ${values.length}`);
      given[option] = values[0];
    }
  for (const each of [...command.positionals.filter((each) => !each.startsWith("[")), ...(command.required ?? [])])
    if (given[each] === undefined) throw new Misread(`${each} is required`);
  if (extras.length > 0)
    throw new Misread(`The following argument${extras.length > 1 ? "s were" : " was"} not expected: ${extras.reverse().join(" ")}`);
  return given;
}
