#include "help/command_help.hpp"

#include <algorithm>
#include <sstream>

namespace dashpad::app {

namespace {

/// CLI11 tells of what is allowed only in the name of the type: "SYSTEM:{si,us}", "N:INT in [1 - 9]".
std::vector<std::string> allowed_values(const std::string& type) {
  const auto begin = type.find(":{"), end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> values;
  std::istringstream list(type.substr(begin + 2, end - begin - 2));
  for (std::string value; std::getline(list, value, ',');) values.push_back(value);
  return values;
}

/// Up to the colon, but NAME[:VARIANT] in full.
std::string value_name(const std::string& type) {
  const auto colon = type.find(':');
  return colon != std::string::npos && colon > 0 && type[colon - 1] == '[' ? type : type.substr(0, colon);
}

/// Materials and standards are called by their names.
std::string lister(const CLI::App& app, const CLI::Option& option, const std::string& value) {
  if (option.check_lname("standard")) return "standards";
  if (!option.get_positional()) return "";
  if (value == "MATERIAL" || value == "CARD") return "materials";
  const bool lists = app.get_name() == "materials" || app.get_name() == "standards";
  return lists && value == "NAME" ? app.get_name() : "";
}

OptionHelp option_help(const CLI::App& app, const CLI::Option& option) {
  OptionHelp help{.text = option.get_description()};
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  if (option.get_items_expected_max() == 0) return help;
  const std::string type = option.get_type_name();
  help.value = option.get_positional() ? option.get_name() : value_name(type);
  help.allowed = allowed_values(type);
  help.listed_by = lister(app, option, help.value);
  help.repeats = option.get_items_expected_max() > 1;
  return help;
}

void add(const CLI::App& app, std::vector<std::string> words, std::vector<CommandHelp>& commands) {
  words.push_back(app.get_name());
  CommandHelp command{.app = &app, .words = words};
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? command.positionals : command.options).push_back(option_help(app, *option));
  const std::vector<const CLI::App*> subcommands = app.get_subcommands([](const CLI::App*) { return true; });
  command.subcommands = subcommands;
  commands.push_back(std::move(command));
  for (const CLI::App* sub : subcommands) add(*sub, words, commands);
}

}  // namespace

std::vector<CommandHelp> all_commands(const CLI::App& app) {
  std::vector<CommandHelp> commands;
  add(app, {}, commands);
  return commands;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string escaped(const std::string& text, const std::string& characters, const std::string& escape) {
  std::string safe;
  for (const char c : text) {
    if (characters.find(c) != std::string::npos) safe += escape;
    safe += c;
  }
  return safe;
}

}  // namespace dashpad::app
