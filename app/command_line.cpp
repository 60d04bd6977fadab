#include "command_line.hpp"

#include <algorithm>
#include <iterator>
#include <string>

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

}  // namespace

void add_commands(CLI::App& app, Action& action, std::string_view first) {
  app.name("dashpad")->description(description)->footer(main_footer);
  app.set_version_flag("--version", version_text, "Print version, commit, compiler and libraries");
  app.require_subcommand(1);
  const bool is_named = std::ranges::find(commands, first, &Command::name) != std::end(commands);
  for (const auto& [group, name, add, only_looks] : commands) {
    if (is_named && name != first) continue;
    add(app, action);
    app.get_subcommands({}).back()->group(std::string(group));
  }
}

bool only_looks(std::string_view name) {
  const auto* const named = std::ranges::find(commands, name, &Command::name);
  return named != std::end(commands) && named->only_looks;
}

}  // namespace dashpad::app
