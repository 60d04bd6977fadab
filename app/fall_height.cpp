// dashpad fall-height: the critical fall height of a surface, from measured drops and from a case.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/fall_height/fall_height.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/output/fall_height.hpp"
#include "output_files.hpp"
#include "pulse/request.hpp"
#include "solve_for/question.hpp"

namespace dashpad::app {

namespace {

constexpr const char* fall_height_footer = R"(Examples:
  dashpad fall-height examples/drops/mat-50mm.csv     drops of EN 1177: 200 g and HIC 1000
  dashpad fall-height examples/drops/mat-50mm.csv --calibration "2 %" --report ./fall-height.html
  dashpad fall-height examples/drops/mat-50mm.csv --standard astm-f1292 --about "Surface: poured in place"
  dashpad fall-height examples/playground-mat-in-layers.toml
                                                      of a computed mat
  dashpad fall-height my-drops.csv my-mat.toml        the same surface, measured and computed

DROPS is a table (CSV) with a row for each drop. Its columns:

  drop_height [m]          or height, fall_height
  hic, gmax                the figures, ...
  file                     ... or the file of the pulse, beside the table; see dashpad pulse --help
  drop                     its number at this height on this place; by default in the order of the table
  position, surface, temperature [degC], ...
                           all other columns are kept as remarks. Drops that differ in a column that begins
                           with position, surface, sample, specimen, spot or temperature are evaluated apart.

The height is where a curve fitted to the drops of each place first reaches a limit; the lowest height of all places and
limits counts. The 95 % interval covers the scatter of the drops about the curve and the uncertainty of the instrument,
which all drops share. If no drop exceeds a limit, or all do, the answer says so and no height is given.
docs/fall-height.md describes the method and states the sources of what is taken from the standards.

CASE is a case file (.toml): the lowest fall height from which a limit is exceeded, as solve-for finds it.

Exit codes: 0 drops on both sides of the limit give a height with its interval, or the case gives one, and nothing is in
doubt; 3 otherwise; 1 a result could not be written; 2 invalid input or command line (nothing was run).)";

struct FallHeightRequest {
  std::vector<std::string> inputs;
  PulseRequest pulse;
  std::string standard = "en-1177";
  std::vector<std::string> about;
  SolveForRequest computed;  ///< its case, range, tolerance, folders
  OutputFiles files;
};

bool is_case(const std::string& file) { return file.ends_with(".toml"); }

/// Options that would do nothing with these inputs.
void refuse_unused(const FallHeightRequest& request, bool has_table, bool has_case,
                   std::vector<std::string>& errors) {
  const PulseRequest& pulse = request.pulse;
  const input::PulseOptions& source = pulse.source;
  const SolveForRequest& computed = request.computed;
  const auto say = [&](bool is_given, bool is_used, const char* option, const char* needs) {
    if (is_given && !is_used) errors.push_back(fmt::format("{}: applies only with {}", option, needs));
  };
  for (const auto& [is_given, option] : {std::pair{pulse.calibration.has_value(), "--calibration"},
                                         {pulse.zero.has_value(), "--zero"},
                                         {pulse.filter.has_value(), "--filter"},
                                         {pulse.corner.has_value(), "--corner"},
                                         {pulse.ends.has_value(), "--ends"},
                                         {pulse.resample.has_value(), "--resample"},
                                         {pulse.interval.has_value(), "--interval"},
                                         {pulse.from.has_value(), "--from"},
                                         {pulse.to.has_value(), "--to"},
                                         {!pulse.sensitivities.empty(), "--sensitivity"},
                                         {!source.time.empty(), "--time"},
                                         {!source.acceleration.empty(), "--acceleration"},
                                         {!source.time_unit.empty(), "--time-unit"},
                                         {!source.acceleration_unit.empty(), "--acceleration-unit"},
                                         {source.resultant, "--resultant"},
                                         {source.bridge_gaps, "--bridge-gaps"},
                                         {!source.test.empty(), "--test"},
                                         {!source.channel.empty(), "--channel"}})
    say(is_given, has_table, option, "a table of drops");
  for (const auto& [is_given, option] : {std::pair{computed.between.has_value(), "--between"},
                                         {!computed.given.settings.empty(), "--set"},
                                         {computed.tolerance.has_value(), "--tolerance"},
                                         {computed.no_intervals, "--no-intervals"}})
    say(is_given, has_case, option, "a case");
}

/// The figures of the pulses that the table names, read beside it.
void add_pulses(const FallHeightRequest& request, const std::filesystem::path& table_file,
                const injury::Standard& standard, fall_height::DropTable& table,
                std::vector<input::InputFile>& files, std::vector<std::string>& errors) {
  PulseRequest each = request.pulse;
  each.standard = standard;
  for (fall_height::Drop& drop : table.drops) {
    if (drop.pulse.empty()) continue;
    each.file = (table_file.parent_path() / drop.pulse).string();
    each.drop_height = fmt::format("{} m", drop.height);
    try {
      injury::PulseReport report = pulse_report(
          each, {}, [&](const auto& read, auto&) { files.insert(files.end(), read.begin(), read.end()); });
      report.uncertainty = injury::measurement_uncertainty(report, table.calibration);
      const injury::PulseLimits limits = injury::within_limits(report, standard);
      for (std::size_t i = 0; i < limits.results.size(); ++i) {
        const injury::CriterionResult& result = limits.results[i];
        if (!result.value || !(*result.value > 0)) continue;
        drop.figures[i] = *result.value;
        drop.doubts[i] = result.error / *result.value;
      }
      drop.flags = report.flags;
    } catch (const Refused& refused) {
      for (std::string complaint : refused.complaints()) {
        // A complaint with an excerpt says where it is itself.
        if (complaint.starts_with(each.file) && complaint.find('\n') == std::string::npos)
          complaint += fmt::format(" ({}, line {})", table_file.string(), drop.line);
        if (std::ranges::find(errors, complaint) == errors.end()) errors.push_back(std::move(complaint));
      }
    }
  }
}

std::optional<fall_height::Answer> measured_by(const FallHeightRequest& request, const std::string& file,
                                               const injury::Standard& standard,
                                               std::vector<input::InputFile>& files,
                                               std::vector<std::string>& errors) {
  const std::optional<double> calibration = calibration_of(request.pulse, errors);
  std::optional<fall_height::DropTable> table = taken(fall_height::read_drops(file, standard), errors);
  files.push_back({"the table of drops", file});
  if (!table) return std::nullopt;
  table->calibration = calibration;
  for (fall_height::Drop& drop : table->drops)
    for (std::size_t i = 0; i < standard.criteria.size(); ++i)
      drop.doubts[i] =
          calibration.value_or(0) * injury::acceleration_power(standard.criteria[i].quantity->key);
  add_pulses(request, file, standard, *table, files, errors);
  if (!errors.empty()) return std::nullopt;
  return fall_height::evaluated(*table, standard);
}

/// The heights that are searched where drops are measured, too: half the lowest to twice the highest.
std::string range_about(const fall_height::Answer& measured) {
  const auto [low, high] = fall_height::heights_of(measured);
  return fmt::format("{} m..{} m", low / 2, 2 * high);
}

int code_of(const output::FallHeightReport& report) {
  if (report.measured && !report.measured->is_sure()) return exit_not_trusted;
  if (!report.computed) return exit_done;
  return output::critical_turn(*report.computed) && report.computed->is_complete &&
                 report.computed->doubtful == 0
             ? exit_done
             : exit_not_trusted;
}

int run_fall_height(const FallHeightRequest& request) {
  std::vector<std::string> errors;
  std::vector<input::InputFile> files;
  output::FallHeightReport report{.about = request.about};
  for (const std::string& file : request.inputs) {
    std::string& place = is_case(file) ? report.case_file : report.table_file;
    if (!place.empty())
      errors.push_back(
          fmt::format("{}: one {} at a time, not also {}", file, is_case(file) ? "case" : "table", place));
    place = file;
  }
  if (report.table_file.empty() && !request.files.of("--csv").empty())
    errors.emplace_back("--csv: has a row for each drop; give a table of drops");
  refuse_unused(request, !report.table_file.empty(), !report.case_file.empty(), errors);
  const auto standard =
      standard_of(request.standard, chosen_standards(request.computed.standard_folder), files, errors);
  if (standard)
    for (const injury::Criterion& criterion : standard->criteria)
      if (criterion.quantity->part != Part::pulse && !criterion.limits("peak_acceleration"))
        errors.push_back(
            fmt::format("--standard {}: limits the {}, to which no curve over the height is fitted here; "
                        "for a case, use dashpad solve-for impactor.drop_height",
                        request.standard, title_in_sentence(*criterion.quantity)));
  if (!errors.empty()) throw Refused(std::move(errors));
  if (!report.table_file.empty())
    report.measured = measured_by(request, report.table_file, *standard, files, errors);
  judge_files(request.files, files, errors);
  judge_picture(request.files, errors);
  if (!errors.empty()) throw Refused(std::move(errors));
  if (!report.case_file.empty()) {
    SolveForRequest computed = request.computed;
    computed.key = "impactor.drop_height";
    computed.given.file = report.case_file;
    computed.standards = {request.standard};
    computed.files = request.files;
    if (!computed.between && report.measured) computed.between = range_about(*report.measured);
    report.computed = solve_for_with_progress(question_of(computed));
  }
  const UnitSystem& units = unit_system(request.files.units);
  const auto document = [&](output::Pictures pictures) {
    return output::fall_height_document(report, units, pictures);
  };
  publish(request.files, document,
          {{"--json", [&](const Target&) { return output::fall_height_json(report, units); }},
           {"--csv", [&](const Target&) { return output::fall_height_csv(report); }},
           {"--picture", [&](const Target& target) {
              return picture_text(output::fall_height_plot(report, units), target);
            }}});
  return code_of(report);
}

}  // namespace

void add_fall_height(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<FallHeightRequest>(
      app, action, "fall-height", "Find the critical fall height, from drops or a case", fall_height_footer,
      run_fall_height);
  add_option(sub, "DROPS|CASE", request.inputs, "Table of drops, case, or both")->required()->expected(1, 2);
  add_option(sub, "--standard NAME[:VARIANT]", request.standard, "Limits (default: en-1177)");
  add_option(sub, "--about TEXT", request.about,
             "A line for the page, such as \"Operator: M. Muster\"; may be repeated")
      ->take_all();
  add_calibration(sub, request.pulse);
  add_source_options(sub, request.pulse);
  add_processing_options(sub, request.pulse);
  add_settings(sub, request.computed.given.settings);
  add_option(sub, "--between RANGE", request.computed.between,
             "Heights to search with a case, such as \"1 m..3 m\"");
  add_file(sub, request.files, "--json",
           "Write the answer as JSON, in SI units and g (- for standard output)");
  add_file(sub, request.files, "--csv", "Write a row for each drop with its figures");
  add_file(sub, request.files, "--picture", "Draw the figures over the height: .svg, .png or .pdf");
  add_documents(sub, request.files);
  add_units(sub, request.files.units);
  add_all(sub, request.files.detail);
  add_tolerance(sub, request.computed.tolerance);
  add_no_intervals(sub, request.computed.no_intervals);
  add_force(sub, request.files.force);
  add_standard_folder(sub, request.computed.standard_folder);
  add_material_folder(sub, request.computed.given.materials);
}

}  // namespace dashpad::app
