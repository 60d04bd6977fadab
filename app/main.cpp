// The command dashpad: reads the command line and calls a subcommand.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/study/store.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "output.hpp"
#include "quantities/text.hpp"
#include "system.hpp"

namespace dashpad::app {

namespace {

/// Nobody reads more lines, however many kinds of faults there are.
constexpr std::size_t max_lines = 200;

/// A complaint as one line, and below it its excerpt, if any. Line breaks in users' names are removed.
std::string shown(const std::string& complaint) {
  const auto line = complaint.find("\n  "), bar = complaint.find_first_not_of(" 0123456789", line + 1);
  const bool has_excerpt = line != std::string::npos && bar != std::string::npos && complaint[bar] == '|';
  const auto end = has_excerpt ? line : complaint.size();
  return one_line(without_endless_words(complaint.substr(0, end))) + without_controls(complaint.substr(end));
}

int refuse(const std::vector<std::string>& complaints, const CLI::App& app) {
  std::string text;
  const std::size_t count = complaints.size();
  const std::vector<std::string> lines = input::abridged(complaints);
  for (std::size_t i = 0; i < lines.size() && i < max_lines; ++i) text += shown(lines[i]) + "\n";
  if (lines.size() > max_lines) text += "...\n";
  text += plural(count, "error");
  const bool would_run = std::ranges::none_of(
      app.get_subcommands(), [](const CLI::App* sub) { return only_looks(sub->get_name()); });
  write_error(text + (would_run ? "; nothing was run\n" : "\n"));
  return exit_refused;
}

/// Takes streams among the files named on the command line: positional arguments, and the pulse of a
/// comparison. Stores are no such files, and a batch reads its stream line by line.
void take_streams(const CLI::App& app) {
  for (const CLI::App* sub : app.get_subcommands()) {
    for (const CLI::Option* option : sub->get_options()) {
      const bool is_read = option->get_positional() || option->check_lname("pulse");
      if (is_read && sub->get_parent()->get_name() != "study" && sub->get_name() != "batch")
        for (const std::string& name : option->results()) input::take_given_stream(name);
    }
    take_streams(*sub);
  }
}

/// Messages of libraries do not help a user.
constexpr const char* library_failed =
    "dashpad: a number went out of range; this is a bug, so please report it and include the input files\n";

int perform(const Action& action, const CLI::App& app) {
  try {
    take_streams(app);
    return action();
  } catch (const input::InputError& error) {
    return refuse(lines(error.faults()), app);
  } catch (const study::DamagedStore& error) {
    return refuse({error.what()}, app);
  } catch (const Refused& error) {
    return refuse(error.complaints(), app);
  }
}

/// Advice without a known command: what to type instead of the first word.
std::string advice_on(const std::vector<std::string>& words, const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  if (words.empty()) return "no command given; available: " + input::listing(names);
  const std::string& word = words.front();
  if (word.ends_with(".toml")) return word + ": is not a command; to solve this case: dashpad run " + word;
  if (word.starts_with('-'))
    return word + ": is not accepted before a command; the commands are " + input::listing(names);
  return word + ": no such command" + input::meant_or_listed(word, names);
}

/// Returns 0 for help and version, 2 for a command line that is not understood.
int answer(const CLI::App& app, const CLI::ParseError& error) {
  const auto exit_code = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (exit_code == CLI::ExitCodes::RequiredError && app.get_subcommands().empty()) {
    write_error(advice_on(app.remaining(), app) + "\nRun with --help for more information.\n");
    return exit_refused;
  }
  std::ostringstream out, err;
  const int code = app.exit(error, out, err);
  write_output(out.str());
  write_error(dashpad::without_endless_words(err.str()));
  return code == 0 ? exit_done : exit_refused;
}

/// Complaints about options with an empty text, as from a script's unset variable, which would count as 0.
std::vector<std::string> given_empty(const CLI::App& app) {
  std::vector<std::string> complaints;
  for (const CLI::Option* option : app.get_options())
    if (std::ranges::count(option->results(), "") > 0)
      complaints.push_back(option->get_name() + ": must not be empty");
  for (const CLI::App* sub : app.get_subcommands())
    std::ranges::move(given_empty(*sub), std::back_inserter(complaints));
  return complaints;
}

int command(int argument_count, char** arguments) {
  CLI::App app;
  app.get_formatter()->column_width(32);
  app.allow_windows_style_options(false);  // a name of a file may begin with /, there too
  Action action;
  add_commands(app, action, argument_count > 1 ? arguments[1] : "");
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  if (const std::vector<std::string> complaints = given_empty(app); !complaints.empty())
    return refuse(complaints, app);
  return perform(action, app);
}

}  // namespace

}  // namespace dashpad::app

int main(int argument_count, char** arguments) {
  using namespace dashpad::app;
  try {
    prepare_streams();
    const std::span<char*> given = arguments_in_utf8(argument_count, arguments);
    return command(static_cast<int>(given.size()), given.data());
  } catch (const std::bad_alloc&) {
    write_error("dashpad: out of memory\n");
  } catch (const std::filesystem::filesystem_error& error) {
    write_error(
        dashpad::without_endless_words("dashpad: " + error.path1().string() + ": " + error.code().message()) +
        "\n");
  } catch (const std::domain_error&) {
    write_error(library_failed);  // boost::math, for NaN
  } catch (const std::overflow_error&) {
    write_error(library_failed);
  } catch (const nlohmann::json::exception&) {
    write_error(library_failed);
  } catch (const std::exception& error) {
    write_error(dashpad::without_endless_words(std::string{"dashpad: "} + error.what()) + "\n");
  }
  return exit_failed;
}
