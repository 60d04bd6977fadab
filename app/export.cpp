// dashpad export: solves a case and writes its curves for decks of other programs.

#include <algorithm>
#include <optional>

#include <functional>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "output.hpp"

namespace dashpad::app {

namespace {

constexpr int max_points = 1'000'000;

constexpr const char* export_footer = R"(Examples:
  dashpad export examples/dashboard-20mph.toml --format ls-dyna --out pad.k
  dashpad export examples/dashboard-20mph.toml --format radioss --system t-mm-s --out pad_0000.inc
  dashpad export examples/dashboard-20mph.toml --format ls-dyna --curves loading,unloading --first-id 9001 \
    --points 100 --out contact.k
  dashpad export examples/dashboard-20mph.toml --format csv --curves force --out -
  dashpad export examples/dashboard-20mph.toml --format iso-mme --out test.zip

Formats: ls-dyna writes *DEFINE_CURVE keywords for *INCLUDE; radioss writes /FUNCT blocks for #include; csv
writes one curve in two columns, after comment lines that begin with #; iso-mme writes the curves over time as a
zipped ISO-MME test, in SI units and sampled at 100 kHz.

Curves (default: all): force, acceleration, velocity, motion and penetration over time; loading and unloading are
the force of the pad against its penetration, up to the greatest penetration and from there to release. The curves
are numbered in the order in which they are named.

Systems: kg-mm-ms (default; kN, GPa, J), kg-m-s (N, Pa, J), t-mm-s (N, MPa, mJ), g-mm-ms (N, MPa, mJ), g-cm-us (Mbar),
lbf-s2/in-in-s (lbf, psi). Compression is positive; the acceleration is negative while the pad slows the impactor. See
docs/exports.md.

Files: - as FILE means standard output; messages about the curves then go to standard error. An existing file is
not overwritten unless --force is given. A file is written completely or not at all; its comments contain any flags
(TOLERANCE NOT MET, TIME LIMIT, PULSE CUT, BOTTOMED, ENERGY GAINED, SERIES CUT, EXTRAPOLATED STRAIN or RATE).

Exit codes: 0 success (even if the pad bottomed out or the time limit was reached), 1 the file could not be written
or none of the curves exists, 2 invalid input (nothing was run), 3 not reliable: the file was written, but the
result does not meet the tolerance.)";

struct Format {
  const char* name;
  std::string (*text)(const output::CurveFile&);
  bool holds_one_curve;
  bool over_time_only;
};

constexpr Format formats[] = {{"ls-dyna", output::ls_dyna_text, false, false},
                              {"radioss", output::radioss_text, false, false},
                              {"csv", output::curve_csv, true, false},
                              {"iso-mme", output::iso_mme_zip, false, true}};

struct ExportRequest {
  GivenCase given;
  std::string format;
  std::string out;
  std::vector<std::string> curves;  ///< empty for all that the format takes
  std::string system;               ///< empty for the first
  bool in_g = false;
  int first_id = 1;
  std::optional<int> points;
  std::optional<std::string> tolerance;
  bool force = false;
};

const Format& format_of(const ExportRequest& request) {
  return *std::ranges::find_if(formats, [&](const Format& format) { return request.format == format.name; });
}

std::vector<std::string> curves_of(const ExportRequest& request) {
  if (!request.curves.empty()) return request.curves;
  std::vector<std::string> names = output::curve_names();
  if (format_of(request).over_time_only) std::erase_if(names, std::not_fn(output::is_over_time));
  return names;
}

/// Errors in the choice of curves.
std::vector<std::string> wrong_curves(const ExportRequest& request) {
  std::vector<std::string> errors;
  if (format_of(request).over_time_only) {
    for (const std::string& name : request.curves)
      if (!output::is_over_time(name))
        errors.push_back(fmt::format("--curves {}: {} accepts only curves over time", name, request.format));
    if (!request.system.empty())
      errors.push_back(fmt::format("--system {}: {} is always in SI units", request.system, request.format));
  }
  for (auto name = request.curves.begin(); name != request.curves.end(); ++name)
    if (std::find(request.curves.begin(), name, *name) != name)
      errors.push_back(fmt::format("--curves: {} is given twice", *name));
  if (format_of(request).holds_one_curve && curves_of(request).size() != 1)
    errors.push_back(fmt::format("--format {}: a file holds only one curve; name it, as in --curves force",
                                 request.format));
  const int highest_first = output::highest_curve_id - static_cast<int>(curves_of(request).size()) + 1;
  if (request.first_id > highest_first)
    errors.push_back(fmt::format("--first-id {}: must be at most {}, so that no curve has a number above {}",
                                 request.first_id, highest_first, output::highest_curve_id));
  return errors;
}

output::CurveFile curves_for(const ExportRequest& request, const input::CaseFile& input,
                             const Solution& solution) {
  std::optional<std::size_t> points;
  if (request.points) points = static_cast<std::size_t>(*request.points);
  output::CurveFile file = output::curve_file(input.impact, solution, curves_of(request), points);
  if (!request.system.empty()) file.units = consistent_system(request.system);
  file.acceleration_in_g = request.in_g;
  file.first_id = request.first_id;
  if (std::ranges::none_of(file.curves,
                           [](const output::FileCurve& file_curve) { return file_curve.curve.exists(); }))
    throw std::runtime_error("nothing was written: " + file.curves.front().curve.name + " is " +
                             file.curves.front().remark);
  return file;
}

/// A line for each curve, then the flags.
std::string account(const ExportRequest& request, const output::CurveFile& file) {
  std::string text = fmt::format("{}, {}, units {}\n", request.out == "-" ? "standard output" : request.out,
                                 request.format, format_of(request).over_time_only ? "SI" : file.units.name);
  int id = file.first_id;
  for (const output::FileCurve& file_curve : file.curves)
    text += fmt::format("  {:>8}  {:<13} {}\n", id++, file_curve.curve.name, file_curve.remark);
  for (const std::string& flag : file.flags) text += flag + "\n";
  return text;
}

int export_curves(const ExportRequest& request) {
  const input::CaseFile input = case_to_solve(
      request.given, request.tolerance, wrong_curves(request), [&](const auto& files, auto& errors) {
        judge_targets({{"--out", request.out}}, files, request.force, errors);
      });
  const Solution solution = solve_with_progress(input.impact, input.options);
  const output::CurveFile file = curves_for(request, input, solution);
  publish(
      {{"--out", request.out}}, request.force, [&](const Target&) { return format_of(request).text(file); },
      account(request, file));
  return exit_code(solution.summary);
}

void add_options(CLI::App& sub, ExportRequest& request) {
  std::vector<std::string> format_names, system_names;
  for (const Format& format : formats) format_names.emplace_back(format.name);
  for (const UnitSystem& system : consistent_systems()) system_names.push_back(system.name);
  add_case(sub, request.given);
  add_option(sub, "--format F", request.format, "ls-dyna, radioss, csv or iso-mme")
      ->required()
      ->check(CLI::IsMember(format_names));
  add_option(sub, "--out FILE", request.out, "Output file (- for standard output)")->required();
  add_option(sub, "--curves LIST", request.curves, "Curves, separated by commas (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember(output::curve_names()));
  add_option(sub, "--system SYSTEM", request.system, "Units of the deck (default: kg-mm-ms)")
      ->check(CLI::IsMember(system_names));
  add_flag(sub, "--acceleration-in-g", request.in_g, "Give accelerations in g, whatever the system of units");
  add_option(sub, "--first-id N", request.first_id, "Number of the first curve (default: 1)")
      ->check(CLI::Range(1, output::highest_curve_id));
  add_option(sub, "--points N", request.points,
             "Reduce each curve to at most N points; the resulting deviation is reported")
      ->check(CLI::Range(2, max_points));
  add_tolerance(sub, request.tolerance);
  add_flag(sub, "--force", request.force, "Overwrite an existing file");
  add_material_folder(sub, request.given.materials);
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<ExportRequest>(
      app, action, "export", "Write the curves of a case for use in other solvers", export_footer,
      export_curves);
  add_options(sub, request);
}

}  // namespace dashpad::app
