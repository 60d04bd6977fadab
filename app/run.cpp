// dashpad run: solves one case, shows the summary, writes result files.

#include <memory>
#include <optional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/io/case_file.hpp"
#include "dashpad/io/history_csv.hpp"
#include "dashpad/io/summary_text.hpp"
#include "dashpad/report/page.hpp"
#include "dashpad/report/pulse_text.hpp"
#include "dashpad/report/result_json.hpp"
#include "dashpad/report/result_plot.hpp"
#include "output.hpp"
#include "streams.hpp"

namespace dashpad {

namespace {

constexpr const char* footer = R"(Examples:
  dashpad run examples/dashboard-20mph.toml
  dashpad run examples/dashboard-20mph.toml --units us
  dashpad run examples/dashboard-20mph.toml --json result.json --csv history.csv
  dashpad run examples/dashboard-20mph.toml --report result.html --png result.png
  dashpad run examples/dashboard-20mph.toml --tolerance 1e-6 --json - | jq .peak_force_N

Units: si shows mm, kg, ms, m/s, N, J; us shows in, lb, ms, mph, lbf, in-lbf; engineering-metric shows
mm, kg, ms, km/h, kN, J. Accelerations are in g everywhere. The JSON summary is always in SI and its keys
name the units; the CSV history is in SI (m, s, N, m/s, g) or, with --units us or engineering-metric, in
those units, which its header names. Case files take any unit.

Files: - as FILE is standard output; the summary for people then goes to standard error. An existing file
is kept unless --force is given. A file is written whole or not at all.

Exit codes: 0 done (also when the pad bottomed out or the time was up), 1 a result could not be written,
2 input or command line refused and nothing was run, 3 results are there but miss the tolerance.)";

struct Request {
  std::string case_file;
  std::optional<std::string> json;
  std::optional<std::string> csv;
  std::optional<std::string> report;
  std::optional<std::string> png;
  std::string units;
  std::optional<std::string> tolerance;
  std::string materials;
  bool force = false;
};

std::vector<Target> targets(const Request& request) {
  std::vector<Target> wanted;
  if (request.json) wanted.push_back({"--json", *request.json});
  if (request.csv) wanted.push_back({"--csv", *request.csv});
  if (request.report) wanted.push_back({"--report", *request.report});
  if (request.png) wanted.push_back({"--png", *request.png});
  return wanted;
}

/// The case, with the command line's changes. Throws Refused with all that is wrong with both.
CaseFile read_and_check(const Request& request, const std::filesystem::path& materials) {
  std::vector<std::string> wrong = complaints(targets(request), request.case_file, request.force);
  if (request.report && !has_page()) wrong.push_back(std::string{"--report: "} + no_page);
  const std::optional<double> tolerance = tolerance_of(request.tolerance, wrong);
  std::optional<CaseFile> input = read_case(request.case_file, materials, wrong);
  if (!wrong.empty()) throw Refused(std::move(wrong));
  if (tolerance) input->options.tolerance = *tolerance;
  return *std::move(input);
}

/// Files first, then what goes to standard output.
void write_results(const Request& request, const CaseFile& input, const Solution& solution) {
  const UnitSystem& units = unit_system(request.units);
  const std::optional<InjuryFigures> injury = whole_pulse_figures(solution);
  const auto text_of = [&](const Target& target) {
    if (target.option == "--json") return result_json(input.impact, solution.summary, injury);
    if (target.option == "--png")
      return picture(result_plot(input.impact, solution, injury, units), PictureFormat::png);
    if (target.option == "--csv") return history_csv(solution.history, units_of_files(units));
    return page(input.impact, input.options, solution, units,
                contact_snapshots(input.impact, solution.history));
  };
  std::string summary = summary_text(input.impact, solution.summary, units);
  if (injury) summary += "\nThe pulse:\n" + injury_text(*injury, units);
  publish(targets(request), request.force, text_of, summary);
}

int run(const Request& request, const std::filesystem::path& materials) {
  const CaseFile input = read_and_check(request, materials);
  const Solution solution = solve(input.impact, input.options);
  write_results(request, input, solution);
  return solution.summary.trustworthy() ? exit_done : exit_not_trusted;
}

}  // namespace

void add_run(CLI::App& app, Action& action, const std::filesystem::path& executable) {
  CLI::App* sub = app.add_subcommand("run", "Solve one case and show or write the result");
  const auto request = std::make_shared<Request>();
  sub->add_option("CASE", request->case_file, "Case file (TOML)")->required()->type_name("");
  sub->add_option("--json", request->json, "Write the summary as JSON (- for standard output)")
      ->type_name("FILE");
  sub->add_option("--csv", request->csv, "Write the history as CSV (- for standard output)")
      ->type_name("FILE");
  sub->add_option("--report", request->report, "Write a page to look at in a browser, as one HTML file")
      ->type_name("FILE");
  sub->add_option("--png", request->png, "Draw acceleration and hysteresis as a still; needs gnuplot")
      ->type_name("FILE");
  add_units(*sub, request->units);
  sub->add_option("--tolerance", request->tolerance,
                  "Relative error to keep to, from 1e-8 to 1e-2 (default: the case's, else 1e-4)")
      ->type_name("X");
  sub->add_flag("--force", request->force, "Overwrite existing files")->disable_flag_override();
  add_material_folder(*sub, request->materials);
  sub->footer(footer);
  sub->callback([request, &action, executable] {
    action = [request, executable] { return run(*request, chosen_folder(request->materials, executable)); };
  });
}

}  // namespace dashpad
