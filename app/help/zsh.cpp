#include <algorithm>

#include <fmt/format.h>

#include "help/command_help.hpp"

namespace dashpad::app {

namespace {

constexpr const char* head = R"zsh(#compdef dashpad
# Completes the words of dashpad in zsh. Written by dashpad-help; do not edit.

_dashpad_names() {{
  local -a names
  names=(${{(f)"$(dashpad $1{})"}})
  _alternative "names:name:($names)" 'files:file:_files'
}}

# Leaves the rest of the line to the subcommand that it names, if any.
_dashpad_left_to_subcommand() {{
  local next=${{1}}_${{words[2]}}
  (( CURRENT > 2 && $+functions[$next] )) || return 1
  shift words
  (( CURRENT-- ))
  $next
}}
)zsh";

std::string in_quotes(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '\'' ? "'\\''" : std::string{c};
  return "'" + safe + "'";
}

/// What completes a value.
std::string action(const OptionHelp& option) {
  if (!option.listed_by.empty()) return " _dashpad_names " + option.listed_by;
  return option.allowed.empty() ? "_files" : "(" + joined(option.allowed, " ") + ")";
}

/// "*--set=[Replace a value]:KEY=VALUE:_files"; an option of two names takes two.
std::string option_lines(const OptionHelp& option) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    std::string spec = option.repeats ? "*" : "(" + joined(option.names, " ") + ")";
    spec += name + (option.value.empty() ? "" : is_long ? "=" : "+");
    spec += "[" + escaped(option.text, "[]\\") + "]";
    if (!option.value.empty()) spec += ":" + escaped(option.value, ":\\") + ":" + action(option);
    text += "    " + in_quotes(spec) + " \\\n";
  }
  return text;
}

std::string first_action(const CommandHelp& command) {
  if (!command.subcommands.empty())
    return command.positionals.empty() ? "{_describe subcommand subcommands}"
                                       : "{_describe subcommand subcommands; _files}";
  for (const OptionHelp& positional : command.positionals)
    if (const std::string does = action(positional); does != "_files") return does;
  return "_files";
}

}  // namespace

std::string zsh_completion(const std::vector<CommandHelp>& commands) {
  std::string text = fmt::format(head, only_names);
  for (const CommandHelp& command : commands) {
    const std::string name = "_" + joined(command.words, "_");
    text += fmt::format("\n{}() {{\n", name);
    if (!command.subcommands.empty()) {
      text += fmt::format("  _dashpad_left_to_subcommand {} && return\n  local -a subcommands=(\n", name);
      for (const CLI::App* sub : command.subcommands)
        text += "    " + in_quotes(sub->get_name() + ":" + escaped(sub->get_description(), ":\\")) + "\n";
      text += "  )\n";
    }
    text += "  _arguments -s : \\\n";
    for (const OptionHelp& option : command.options) text += option_lines(option);
    const std::string first = first_action(command);
    if (!command.subcommands.empty())
      text += "    " + in_quotes("1: :" + first) + "\n}\n";
    else
      text += "    " + in_quotes("*: :" + first) + "\n}\n";
  }
  return text + "\n_dashpad \"$@\"\n";
}

}  // namespace dashpad::app
