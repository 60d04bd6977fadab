// The command dashpad: reads the command line and hands over to a subcommand.

#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/io/fault.hpp"
#include "material_folder.hpp"
#include "output.hpp"
#include "streams.hpp"

namespace dashpad {

namespace {

constexpr const char* description =
    "dashpad: the impact of a rigid sphere on a foam pad on an elastic support.\n"
    "Give it a case file; it answers with peak force, g, penetration, rebound and energy.";

constexpr const char* footer = R"(Start here:
  dashpad check examples/dashboard-20mph.toml    is the case understood as meant?
  dashpad run examples/dashboard-20mph.toml      the impact, on the screen
  dashpad materials                              which foams there are
  dashpad material-test ensolite-aac-9           one of them in the laboratory
  dashpad run --help                             files, units, tolerance
  dashpad spit1984 --help                        the program of the 1986 report, digit for digit
  dashpad compare examples/dashboard-20mph.toml  the solver and the program of 1984 side by side
  dashpad validate                               both beside the validation tests of that report
  dashpad study --help                           many impacts: curves, maps, probabilities

Exit codes:
  0  done; also when the pad bottomed out or the time was up: these are results
  1  a result could not be written (full disk, ...), or the program failed
  2  input or command line refused; nothing was run, nothing was written
  3  no verdict, or not reliable: results are there but miss the tolerance, or assess cannot decide
  4  assess: a limit of the standard is exceeded; validate --strict: a rule is missed)";

/// More than that nobody reads, and a file that is no case at all can have thousands.
constexpr std::size_t most_complaints = 200;

int refuse(const std::vector<std::string>& complaints, const CLI::App& app) {
  std::string text;
  const std::size_t count = complaints.size();
  for (std::size_t i = 0; i < count && i < most_complaints; ++i) text += complaints[i] + "\n";
  if (count > most_complaints) text += "...\n";
  text += std::to_string(count) + (count == 1 ? " fault" : " faults");
  const bool would_run =
      !app.got_subcommand("check") && !app.got_subcommand("materials") && !app.got_subcommand("standards");
  write_error(text + (would_run ? "; nothing was run\n" : "\n"));
  return exit_refused;
}

int perform(const Action& action, const CLI::App& app) {
  try {
    return action();
  } catch (const InputError& error) {
    return refuse(lines(error.faults()), app);
  } catch (const Refused& error) {
    return refuse(error.complaints(), app);
  }
}

/// Help and version end in exit code 0, a command line that is not understood in 2.
int answer(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out, err;
  const int code = app.exit(error, out, err);
  write_output(out.str());
  write_error(err.str());
  return code == 0 ? exit_done : exit_refused;
}

int command(int argument_count, char** arguments) {
  CLI::App app{description, "dashpad"};
  app.footer(footer);
  app.get_formatter()->column_width(32);
  app.set_version_flag("--version", version_text, "Version, commit, compiler and libraries");
  app.require_subcommand(1);

  const std::filesystem::path executable = running_executable(arguments[0]);
  Action action;
  add_run(app, action, executable);
  add_check(app, action, executable);
  add_materials(app, action, executable);
  add_material_test(app, action, executable);
  add_assess(app, action, executable);
  add_standards(app, action, executable);
  add_post_impact(app, action, executable);
  add_pulse(app, action, executable);
  add_export(app, action, executable);
  add_compare(app, action, executable);
  add_spit1984(app, action, executable);
  add_validate(app, action, executable);
  add_study(app, action, executable);
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  return perform(action, app);
}

}  // namespace

}  // namespace dashpad

int main(int argument_count, char** arguments) {
  using namespace dashpad;
  try {
    prepare_streams();
    return command(argument_count, arguments);
  } catch (const std::exception& error) {
    write_error(std::string{"dashpad: "} + error.what() + "\n");
    return exit_failed;
  }
}
