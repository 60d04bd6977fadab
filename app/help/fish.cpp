#include <fmt/format.h>

#include "help/command_help.hpp"

namespace dashpad::app {

namespace {

constexpr const char* head =
    R"(# Completes the words of dashpad in fish. Written by dashpad-help; do not edit.

function __dashpad_names
    dashpad $argv[1]{}
end

# Whether the line has come to this subcommand.
function __dashpad_at
    set -l path
    for word in (commandline -opc)[2..]
        if contains -- (string join ' ' -- $path $word) {}
            set -a path $word
        end
    end
    test "$path" = "$argv[1]"
end

)";

std::string in_quotes(const std::string& text) { return "'" + escaped(text, "'\\") + "'"; }

std::string choice(const OptionHelp& option) {
  return option.listed_by.empty() ? joined(option.allowed, " ")
                                  : "(__dashpad_names " + option.listed_by + ")";
}

std::string option_line(const OptionHelp& option) {
  std::string line;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (const std::string values = choice(option); !values.empty())
    line += (option.listed_by.empty() ? " -xa " : " -ra ") + in_quotes(values);
  else if (!option.value.empty())
    line += " -r";
  return line + " -d " + in_quotes(option.text);
}

}  // namespace

std::string fish_completion(const std::vector<CommandHelp>& commands) {
  std::vector<std::string> paths;
  std::string lines;
  for (const CommandHelp& command : commands) {
    const std::string path = joined(std::vector(command.words.begin() + 1, command.words.end()), " ");
    if (!path.empty()) paths.push_back(in_quotes(path));
    const std::string start = "complete -c dashpad -n " + in_quotes("__dashpad_at '" + path + "'");
    const bool takes_files = !command.positionals.empty();
    for (const CLI::App* sub : command.subcommands)
      lines += start + (takes_files ? " -a " : " -fa ") + sub->get_name() + " -d " +
               in_quotes(sub->get_description()) + "\n";
    for (const OptionHelp& positional : command.positionals)
      if (const std::string values = choice(positional); !values.empty())
        lines += start + " -a " + in_quotes(values) + "\n";
    for (const OptionHelp& option : command.options) lines += start + option_line(option) + "\n";
  }
  return fmt::format(head, only_names, joined(paths, " ")) + lines;
}

}  // namespace dashpad::app
