// A page for man, from the text that --help prints.

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include "help/command_help.hpp"

namespace dashpad::app {

namespace {

/// A line that roff takes as it is: no command, and every dash the character that users type.
std::string roff(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string{c};
  return line.starts_with('.') || line.starts_with('\'') ? "\\&" + line : line;
}

/// Lines that are indented stay as they are, others are filled.
class Section {
 public:
  explicit Section(std::string title) : title_(std::move(title)) {}

  void add(const std::string& line) {
    if (line.empty()) {
      end_block();
      gap_ = true;
      return;
    }
    const bool is_block = line.starts_with(' ');
    if (is_block != in_block_) {
      end_block();
      if (is_block) text_ += text_.empty() ? ".EX\n" : ".PP\n.EX\n";
      in_block_ = is_block;
    } else if (gap_ && !text_.empty()) {
      text_ += is_block ? "\n" : ".PP\n";
    }
    if (gap_ && !is_block && !text_.empty() && !text_.ends_with(".PP\n")) text_ += ".PP\n";
    gap_ = false;
    text_ += roff(is_block ? line.substr(2) : line) + "\n";
  }

  [[nodiscard]] std::string text() {
    end_block();
    return text_.empty() ? "" : ".SH " + title_ + "\n" + text_;
  }

 private:
  void end_block() {
    if (in_block_) text_ += ".EE\n";
    in_block_ = false;
  }

  std::string title_, text_;
  bool in_block_ = false, gap_ = false;
};

/// Without its first word if that is the command: "dashpad simulates ..."
std::string name_line(const CommandHelp& command) {
  std::string line = command.app->get_description();
  line.resize(std::min(line.find('\n'), line.size()));
  if (line.starts_with(command.app->get_name() + " ")) line.erase(0, command.app->get_name().size() + 1);
  if (line.ends_with('.')) line.pop_back();
  line.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(line.front())));
  return fmt::format("{} \\- {}\n", roff(joined(command.words, "-")), roff(line));
}

std::string synopsis(const CommandHelp& command) {
  const std::string usage = CLI::Formatter{}.make_usage(command.app, joined(command.words, " "));
  const std::string own = "Usage: ";
  std::string line = usage.substr(usage.find(own) + own.size());
  line.erase(line.find_last_not_of('\n') + 1);
  const std::size_t name = joined(command.words, " ").size();
  return fmt::format(".B {}\n{}\n", roff(line.substr(0, name)),
                     roff(line.substr(std::min(name + 1, line.size()))));
}

/// Long lists of allowed values may be broken behind a comma.
std::string breakable(const std::string& line) {
  std::string text;
  for (const char c : line) text += c == ',' ? ",\\:" : std::string{c};
  return text;
}

std::string entries(const CommandHelp& command, bool are_positional, const std::string& group) {
  const CLI::Formatter formatter;
  std::string text;
  for (const CLI::Option* option : command.app->get_options()) {
    if (option->get_positional() != are_positional || (!are_positional && option->get_group() != group))
      continue;
    text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(formatter.make_option_name(option, are_positional)),
                        breakable(roff(formatter.make_option_opts(option))), roff(option->get_description()));
  }
  return text;
}

std::string subcommands(const CommandHelp& command) {
  std::string text;
  for (const CLI::App* sub : command.subcommands)
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(joined(command.words, "-") + "-" + sub->get_name()),
                        roff(sub->get_description()));
  return text;
}

std::string with_title(const std::string& title, const std::string& text) {
  return text.empty() ? "" : ".SH " + title + "\n" + text;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

}  // namespace

std::string manual_page(const CommandHelp& command, const std::string& version) {
  Section description{"DESCRIPTION"}, examples{"EXAMPLES"}, exit_status{"EXIT STATUS"};
  Section* section = &description;
  const std::string& first = command.app->get_description();
  std::istringstream lines(first + (first.ends_with('.') ? "\n\n" : ".\n\n") + command.app->get_footer());
  for (std::string line; std::getline(lines, line);) {
    const std::string exit_codes = "Exit codes:";
    if (line == "Examples:") {
      section = &examples;
    } else if (line.starts_with(exit_codes)) {
      section = &exit_status;
      line.erase(0, std::min(exit_codes.size() + 1, line.size()));
      if (!line.empty()) section->add(line);
    } else if (line.empty()) {
      section = &description;
      section->add(line);
    } else {
      section->add(line);
    }
  }
  std::string options = with_title("ARGUMENTS", entries(command, true, ""));
  for (const std::string& group : command.app->get_groups())
    options += with_title(roff(upper(group)), entries(command, false, group));
  std::string page = fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.ad l\n.nh\n",
                                 roff(upper(joined(command.words, "-"))), version);
  page += with_title("NAME", name_line(command)) + with_title("SYNOPSIS", synopsis(command));
  page += description.text() + options + with_title("SUBCOMMANDS", subcommands(command));
  page += exit_status.text() + examples.text();
  if (command.words.size() > 1) {
    const std::vector<std::string> above(command.words.begin(), command.words.end() - 1);
    page += with_title("SEE ALSO", fmt::format(".BR {} (1)\n", roff(joined(above, "-"))));
  }
  return page;
}

}  // namespace dashpad::app
