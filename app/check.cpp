// dashpad check: shows how a case is understood, or its faults.

#include <string>
#include <utility>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/text/case.hpp"
#include "input/fault_json.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr const char* check_footer = R"(Examples:
  dashpad check examples/dashboard-20mph.toml
  dashpad check examples/dashboard-20mph.toml --units us
  dashpad check examples/dashboard-20mph.toml --json | jq .case.pad

Describes the impact in words and shows every value in SI, as used in the computation. Each error is
reported on one line: "file:line: key = value: rule".

--json prints the case in SI, with the keys of "dashpad run --json", or its errors as {"faults": [{"file",
"line", "key", "value", "rule"}, ...]}, to standard output.

Exit codes: 0 the case can be run, 2 it cannot.)";

struct CheckRequest {
  GivenCase given;
  std::string units;
  bool as_json = false;
};

int check(const CheckRequest& request) {
  const GivenCase& given = request.given;
  input::Reading<input::CaseFile> read =
      input::read_case(given.file, chosen_folder(given.materials), given.settings);
  if (request.as_json) {
    write_result(read ? output::case_json(read->impact, read->options)
                      : result_json_text({{"faults", array_of(read.faults(), fault_json)}}));
    return read ? exit_done : exit_refused;
  }
  const input::CaseFile input = std::move(read).value();
  write_output(output::checked_case(given.file, input.impact, input.options, unit_system(request.units)));
  return exit_done;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<CheckRequest>(
      app, action, "check", "Show how a case is interpreted, or what is wrong with it", check_footer, check);
  add_case(sub, request.given);
  add_units(sub, request.units);
  add_flag(sub, "--json", request.as_json, "Print the case, or its errors, as JSON");
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
