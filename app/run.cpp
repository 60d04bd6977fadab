// dashpad run: solves one case, shows the summary, writes result files.

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "result_files.hpp"

namespace dashpad::app {

namespace {

constexpr const char* run_footer = R"(Examples:
  dashpad run examples/dashboard-20mph.toml
  dashpad run examples/dashboard-20mph.toml --units us
  dashpad run examples/dashboard-20mph.toml --set pad.thickness="30 mm" --set impactor.speed="15 mph"
  dashpad run examples/dashboard-20mph.toml --json result.json --csv history.csv
  dashpad run examples/dashboard-20mph.toml --report result.html --png result.png
  dashpad run examples/dashboard-20mph.toml --drawing dashboard.svg
  dashpad run examples/dashboard-20mph.toml --tolerance 1e-6 --json - | jq .peak_force_N

Units: si shows mm, kg, ms, m/s, N, J; us shows in, lb, ms, mph, lbf, in-lbf; engineering-metric shows
mm, kg, ms, km/h, kN, J. Accelerations are always in g. The JSON summary is in SI units and g, and its keys
name the units; the CSV history is in SI units (m, s, N, m/s, g) or, with --units us or engineering-metric, in
those units, which its header names. Case files accept any unit.

For a case with repeated blows ([blows]), the text has a row for each blow, followed by the figures for the last;
the CSV history, page, picture and drawing are for the last blow.

The text shows the main figures to four digits, since the law of a foam is rarely known to three. --all shows
every figure with its estimated error; files contain all digits.

Files: - as FILE means standard output; the text then goes to standard error. An existing file is not overwritten
unless --force is given. A file is written completely or not at all.

Exit codes: 0 success (even if the pad bottomed out or the time limit was reached), 1 a result could not be
written, 2 invalid input or command line (nothing was run), 3 not reliable: the pad did not bottom out, and the
results do not meet the tolerance.)";

struct RunRequest {
  GivenCase given;
  OutputFiles files;
  std::optional<std::string> tolerance;
  bool no_intervals = false;
};

int run(const RunRequest& request) {
  const input::CaseFile input = case_to_solve(
      request.given, request.tolerance, {},
      [&](const auto& files, auto& errors) { judge_result_files(request.files, files, errors); });
  std::vector<Blow> blows = solve_blows_with_progress(input.impact, input.options);
  Solution& solution = blows.back().solution;
  if (!request.no_intervals) add_intervals_with_progress(input.impact, input.options, solution);
  publish(request.files, {input.impact, input.options, solution,
                          input.impact.blows ? std::span(blows) : std::span<const Blow>{}});
  ExitCode worst = exit_code(blows.front().solution.summary);
  for (const Blow& blow : blows) worst = std::max(worst, exit_code(blow.solution.summary));
  return worst;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<RunRequest>(
      app, action, "run", "Solve one case and show or write the result", run_footer, run);
  add_case(sub, request.given);
  add_result_files(sub, request.files);
  add_tolerance(sub, request.tolerance);
  add_no_intervals(sub, request.no_intervals);
  add_force(sub, request.files.force);
  add_material_folder(sub, request.given.materials);
}

}  // namespace dashpad::app
