// The texts of --help.
import { commands, native_commands } from "./options.mjs";

const entries = (all) => all.map(([name, help]) => `  ${name.padEnd(29)} ${help}\n`).join("");

export function help() {
  return `dashpad simulates the impact of a rigid nose on a foam pad and its support.
From a case file, it computes peak force, peak acceleration, penetration, rebound and energy.
Usage: dashpad [OPTIONS] SUBCOMMAND

Options:
${entries([["-h,--help", "Print this help message and exit"], ["--version", "Print version and engine"]])}
Commands:
${entries(Object.entries(commands).map(([name, command]) => [name, command.help]))}
Start here:
  dashpad check CASE                                 is the case read as you intended?
  dashpad run CASE                                   solve an impact and show the result
  dashpad assess CASE --standard en-1177             pass or fail
  dashpad solve-for pad.thickness CASE --standard en-1177

Only the native command has ${native_commands.slice(0, -1).join(", ")} and ${native_commands.at(-1)}.

Exit codes:
  0  success, even if the pad bottomed out or the time limit was reached
  1  a result could not be written (to a full disk, for example), or the program failed
  2  invalid input or command line; nothing was run or written
  3  not reliable or no verdict: the results do not meet the tolerance, or assess or solve-for cannot decide
  4  assess: a limit of the standard is exceeded; solve-for: nothing in the range passes
`;
}

export function helpOf(name) {
  const { help: title, positionals, options, native } = commands[name];
  const shown = Object.entries(options).map(([option, { type, help: text, isList }]) =>
    [`${option}${type ? ` ${type}` : ""}${isList ? " ..." : ""}`, text]);
  return `${title}
Usage: dashpad ${name} [OPTIONS] ${positionals.join(" ")}

Options:
${entries([["-h,--help", "Print this help message and exit"], ...shown])}${native ? `
Only the native command has ${native.join(", ")}.
` : ""}
Files: - as FILE means standard output; the text then goes to standard error. An existing file is not overwritten
unless --force is given. A file is written completely or not at all.
`;
}
