// The command dashpad: reads the command line and calls a subcommand.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/study/store.hpp"
#include "input/disk.hpp"
#include "input/spelling.hpp"
#include "output.hpp"
#include "quantities/text.hpp"

namespace dashpad::app {

namespace {

constexpr const char* description =
    "dashpad simulates the impact of a rigid nose on a foam pad and its support.\nFrom a case file, "
    "it computes peak force, peak acceleration, penetration, rebound and energy.";

constexpr const char* main_footer = R"(Start here:
  dashpad check examples/dashboard-20mph.toml    is the case read as you intended?
  dashpad run examples/dashboard-20mph.toml      solve an impact and show the result
  dashpad solve-for --help                       how thick, how high, how certain
  dashpad fall-height --help                     the critical fall height of a surface
  dashpad sensitivity --help                     which number of a case matters most
  dashpad materials                              list the foams
  dashpad material-test ensolite-aac-9           simulate a laboratory test of one of them
  dashpad material --help                        import and export other solvers' decks
  dashpad fit --help                             fit a card to measurements
  dashpad run --help                             files, units, tolerance
  dashpad cite examples/dashboard-20mph.toml     what its results rest on, for a list of references
  dashpad spit1984 --help                        the program of the 1986 report, digit for digit
  dashpad compare CASE --pulse FILE              compare a case with a measured pulse
  dashpad compare examples/dashboard-20mph.toml  the solver and the 1984 program side by side
  dashpad validate                               compare both with the tests in the 1986 report
  dashpad study --help                           many impacts: curves, maps, probabilities

An input file may be - (standard input) or a pipe, of up to 16 MiB.

Exit codes:
  0  success, even if the pad bottomed out or the time limit was reached
  1  a result could not be written (to a full disk, for example), or the program failed
  2  invalid input or command line; nothing was run or written
  3  not reliable or no verdict: the results do not meet the tolerance, assess or solve-for cannot decide,
     or the drops of fall-height do not enclose the limit
  4  assess: a limit of the standard is exceeded, even if other results are missing;
     solve-for: nothing in the range passes; validate --strict: a rule is not met)";

struct Command {
  std::string_view group;  ///< of the help
  std::string_view name;
  void (*add)(CLI::App&, Action&);
  bool only_looks = false;  ///< runs no impact
};

/// In the order of the help, with everyday commands first.
constexpr Command commands[]{{"Everyday use", "run", add_run},
                             {"Everyday use", "check", add_check, true},
                             {"Everyday use", "assess", add_assess},
                             {"Everyday use", "solve-for", add_solve_for},
                             {"Everyday use", "fall-height", add_fall_height},
                             {"Everyday use", "sensitivity", add_sensitivity},
                             {"Everyday use", "explore", add_explore},
                             {"Everyday use", "standards", add_standards, true},
                             {"Everyday use", "cite", add_cite, true},
                             {"Everyday use", "pulse", add_pulse},
                             {"Everyday use", "export", add_export},
                             {"Everyday use", "post-impact", add_post_impact},
                             {"Everyday use", "compare", add_compare},
                             {"Foams", "materials", add_materials, true},
                             {"Foams", "material", add_material, true},
                             {"Foams", "material-test", add_material_test},
                             {"Foams", "fit", add_fit},
                             {"Many impacts", "study", add_study},
                             {"Many impacts", "batch", add_batch},
                             {"The 1986 report", "spit1984", add_spit1984},
                             {"The 1986 report", "validate", add_validate}};

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
  const bool would_run = std::ranges::none_of(app.get_subcommands(), [](const CLI::App* sub) {
    const auto* const named = std::ranges::find(commands, sub->get_name(), &Command::name);
    return named != std::end(commands) && named->only_looks;
  });
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
  CLI::App app{description, "dashpad"};
  app.footer(main_footer);
  app.get_formatter()->column_width(32);
  app.set_version_flag("--version", version_text, "Print version, commit, compiler and libraries");
  app.require_subcommand(1);

  Action action;
  // If the first argument is a subcommand, only its options are added: all take longer than many an impact.
  const std::string_view first = argument_count > 1 ? arguments[1] : "";
  const bool is_named = std::ranges::find(commands, first, &Command::name) != std::end(commands);
  for (const auto& [group, name, add, only_looks] : commands) {
    if (is_named && name != first) continue;
    add(app, action);
    app.get_subcommands({}).back()->group(std::string(group));
  }
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
    return command(argument_count, arguments);
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
