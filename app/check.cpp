// dashpad check: shows how a case is understood, or its faults.

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/text/case.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr const char* check_footer = R"(Examples:
  dashpad check examples/dashboard-20mph.toml
  dashpad check examples/dashboard-20mph.toml --units us

Describes the impact in words and shows every value in SI, as used in the computation. Each error is
reported on one line: "file:line: key = value: rule".

Exit codes: 0 the case can be run, 2 it cannot.)";

struct CheckRequest {
  GivenCase given;
  std::string units;
};

int check(const CheckRequest& request) {
  const GivenCase& given = request.given;
  const input::CaseFile input =
      input::read_case(given.file, chosen_folder(given.materials), given.settings).value();
  write_output(fmt::format("{}: OK\n\n{}\nIn SI:\n{}", given.file,
                           output::case_text(input.impact, unit_system(request.units)),
                           output::case_in_si(input.impact, input.options)));
  return exit_done;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<CheckRequest>(
      app, action, "check", "Show how a case is understood, or what is wrong with it", check_footer, check);
  add_case(sub, request.given);
  add_units(sub, request.units);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
