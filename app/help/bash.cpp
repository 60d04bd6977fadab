#include <fmt/format.h>

#include "help/command_help.hpp"

namespace dashpad::app {

namespace {

/// What stands before the tables. Without an answer, bash completes names of files.
constexpr const char* head =
    R"(# Completes the words of dashpad in bash. Written by dashpad-help; do not edit.

_dashpad_names() {{
  {}
}}

_dashpad() {{
  COMPREPLY=()
  local at=$COMP_CWORD word=${{COMP_WORDS[COMP_CWORD]}} path='' i
  # bash makes three words of "--units=us".
  if [[ $word == = ]]; then word=''; else at=$((at - 1)); fi
  if [[ ${{COMP_WORDS[at]}} == = ]]; then at=$((at - 1)); fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$path ${{COMP_WORDS[i]}}" in
      {}) path="$path ${{COMP_WORDS[i]}}" ;;
    esac
  done

  local first='' options='' valued=''
  case "$path" in
)";

constexpr const char* tail = R"(  esac
  if [[ " $valued " == *" ${COMP_WORDS[at]} "* ]]; then
    first=''
    case "$path ${COMP_WORDS[at]}" in
)";

constexpr const char* end = R"(    esac
  elif [[ $word == -* ]]; then
    first=$options
  fi
  case "$first" in
    @*) first=$(_dashpad_names "$1" "${first#@}") ;;
  esac
  # shellcheck disable=SC2207
  COMPREPLY=($(compgen -W "$first" -- "$word"))
}

complete -o bashdefault -o default -F _dashpad dashpad
)";

/// Without the name of the command: " study summary".
std::string path(const CommandHelp& command) {
  std::string text;
  for (const std::string& word : std::vector(command.words.begin() + 1, command.words.end()))
    text += " " + word;
  return text;
}

/// Words to choose from, or the command that lists them, as "@materials".
std::string choice(const OptionHelp& option) {
  return option.listed_by.empty() ? joined(option.allowed, " ") : "@" + option.listed_by;
}

/// What may stand first: a subcommand, or the value of a positional argument.
std::string first_word(const CommandHelp& command) {
  std::vector<std::string> words;
  for (const CLI::App* sub : command.subcommands) words.push_back(sub->get_name());
  for (const OptionHelp& positional : command.positionals)
    if (const std::string values = choice(positional); !values.empty()) words.push_back(values);
  return joined(words, " ");
}

}  // namespace

std::string bash_completion(const std::vector<CommandHelp>& commands) {
  std::vector<std::string> paths;
  std::string tables, values;
  for (const CommandHelp& command : commands) {
    const std::string of = path(command);
    if (!of.empty()) paths.push_back('"' + of + '"');
    std::vector<std::string> options, valued;
    for (const OptionHelp& option : command.options) {
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) {
        options.push_back(name);
        if (!option.value.empty()) valued.push_back(name);
        patterns.push_back(fmt::format("\"{} {}\"", of, name));
      }
      if (const std::string words = choice(option); !words.empty())
        values += fmt::format("      {}) first='{}' ;;\n", joined(patterns, " | "), words);
    }
    tables += fmt::format("    \"{}\")\n      first='{}'\n      options='{}'\n      valued='{}'\n      ;;\n",
                          of, first_word(command), joined(options, " "), joined(valued, " "));
  }
  return fmt::format(head, "\"$1\" \"$2\"" + only_names, joined(paths, " | ")) + tables + tail + values + end;
}

}  // namespace dashpad::app
