#pragma once
/// The options of a command and of its subcommands, as manual pages and completions need them.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace dashpad::app {

struct OptionHelp {
  std::vector<std::string> names = {};  ///< "--out" and "-o"; none if it is positional
  std::string value = {};               ///< such as FILE; empty without a value
  std::string text = {};
  std::vector<std::string> allowed = {};  ///< values; empty if it takes others
  std::string listed_by = {};  ///< the command that lists the names it takes: "materials" or "standards"
  bool repeats = false;
};

struct CommandHelp {
  const CLI::App* app = nullptr;
  std::vector<std::string> words = {};  ///< with which it is called, as "dashpad", "study", "summary"
  std::vector<OptionHelp> options = {};
  std::vector<OptionHelp> positionals = {};
  std::vector<const CLI::App*> subcommands = {};
};

/// The command and everything below it; each command before its subcommands.
std::vector<CommandHelp> all_commands(const CLI::App& app);

std::string joined(const std::vector<std::string>& words, const std::string& separator);
/// The text with `escape` before each of these characters.
std::string escaped(const std::string& text, const std::string& characters, const std::string& escape = "\\");

/// A page for man. `version` stands in its footer.
std::string manual_page(const CommandHelp& command, const std::string& version);

std::string bash_completion(const std::vector<CommandHelp>& commands);
std::string zsh_completion(const std::vector<CommandHelp>& commands);
std::string fish_completion(const std::vector<CommandHelp>& commands);

/// For a shell, behind `dashpad materials` or `dashpad standards`: leaves the names, which begin the lines of
/// a table or of an indented list.
inline const std::string only_names = R"( 2>/dev/null | sed -n 's/^ \{0,2\}\([a-z][a-z0-9.-]*\)  .*/\1/p')";

}  // namespace dashpad::app
