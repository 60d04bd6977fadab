// dashpad pulse: injury metrics from a measured acceleration pulse.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "dashpad/output/pulse.hpp"
#include "output_files.hpp"
#include "progress_line.hpp"
#include "pulse/request.hpp"

namespace dashpad::app {

namespace {

constexpr const char* pulse_footer = R"(Examples:
  dashpad pulse drop.csv                                  columns and units from the header
  dashpad pulse drop.csv --time 1 --acceleration 3 --time-unit ms --acceleration-unit g
  dashpad pulse head.csv --resultant --filter CFC1000     x, y and z each filtered, then combined
  dashpad pulse drop.csv --zero auto --drop-height "1.5 m"
                                                          subtract the offset, find the restitution, check the pulse
  dashpad pulse logger.csv --interval "0.1 ms" --sensitivity "10 mV/g"
                                                          one column, in mV
  dashpad pulse drop.csv --report drop.html               a page: figures, curve, basis
  dashpad pulse drop.csv --drop-height "1.5 m" --standard en-1177 --position centre --report drop.html
                                                          compare with the limits of a standard
  dashpad pulse drop1.csv drop2.csv drop3.csv --report drops.html
                                                          several drops: mean, standard deviation, overlaid curves
  dashpad pulse test.zip --list                           the channels of an ISO-MME test
  dashpad pulse test.zip --channel "11HEAD0000??AC?A" --resultant --picture head.svg
  dashpad run examples/dashboard-20mph.toml --csv - > run.csv && dashpad pulse run.csv

FILE is a table (CSV, separated by commas, semicolons, tabs or blanks) or an ISO-MME test (its folder, its .mme file,
or a zip or tar archive of it). Units are taken from the file or the command line and never guessed; g is standard
gravity. Repairs are reported as remarks (REMARK); gaps, text and times that run backwards are rejected; --bridge-gaps
interpolates linearly where times are missing; --from and --to select a part of the record. LabVIEW files (.lvm),
Abaqus reports (.rpt) and tables with times of day can also be read. docs/pulses.md gives the rules.

Offset: the sensor reading in the quiet part before the impact is reported, with its effect on HIC15. --zero subtracts
it, for each direction separately and before any filtering: "--zero auto" subtracts the mean of the quiet part,
"--zero '0 ms,5 ms'" the mean from 0 to 5 ms.

Checks: PULSE CUT means that the pulse starts or ends above 1 % of its peak; its HIC and clips are then lower bounds.
With --speed or --drop-height, the velocity change must lie between v and 2v, where v is the impact speed; otherwise,
the pulse is flagged IMPOSSIBLE VELOCITY CHANGE. The restitution is (velocity change - v) / v. With --drop-height, the
contribution of gravity during contact is subtracted first.

Uncertainty: given for the peak, HIC and similar figures, with coverage factor k = 2. It includes the effects of the
sample interval, the filter (compared with the next higher class) and the sensor calibration (--calibration "2 %").

Figures: the peak; HIC15, HIC36, unlimited HIC, and HIC for the windows of --window; HIC(d); the 3 ms clip,
uninterrupted and cumulative; Gadd's severity index; the time above 80, 150 and 200 g, or above the levels of --dwell;
the velocity change during contact. They are computed from the pulse as measured or, with --filter, as filtered. The
directions of a resultant are filtered separately, then combined. A filter needs evenly spaced samples; uneven samples
are first resampled by linear interpolation, at the interval of --resample (default: the 5th percentile of their own
intervals).

Files: - as FILE of --json or --csv means standard output; the text then goes to standard error. An existing file is
not overwritten unless --force is given. A file is written completely or not at all.

Exit codes: 0 success, 1 a result could not be written, 2 invalid input or command line (nothing was written). With
--standard: 4 if a limit is exceeded, otherwise 3 if a limit lies within the uncertainty of the measurement.)";

/// The request for all files.
struct PulsesRequest {
  std::vector<std::string> files;
  PulseRequest each;
  OutputFiles written;
  std::string standard;
  std::string standard_folder;
};

/// Evaluates every file. Throws Refused with all errors, each once.
std::vector<injury::PulseReport> reports_of(const PulsesRequest& request) {
  PulseRequest each = request.each;
  std::vector<std::string> errors;
  const std::optional<double> calibration = calibration_of(each, errors);
  std::vector<input::InputFile> standard;
  if (!request.standard.empty())
    each.standard =
        standard_of(request.standard, chosen_standards(request.standard_folder), standard, errors);
  judge_picture(request.written, errors);
  if (request.files.size() > 1 && !request.written.of("--csv").empty())
    errors.emplace_back("--csv: accepts only one pulse; give one FILE");
  std::vector<injury::PulseReport> reports;
  for (const std::string& file : request.files) {
    each.file = file;
    try {
      reports.push_back(pulse_report(each, errors, [&](auto files, auto& complaints) {
        files.insert(files.end(), standard.begin(), standard.end());
        judge_files(request.written, files, complaints);
      }));
    } catch (const Refused& refused) {
      for (const std::string& complaint : refused.complaints())
        if (std::ranges::find(errors, complaint) == errors.end()) errors.push_back(complaint);
    }
  }
  if (!errors.empty()) throw Refused(std::move(errors));
  for (injury::PulseReport& report : reports) {
    const ProgressLine waiting("Computing the uncertainty of " + report.file);
    report.uncertainty = injury::measurement_uncertainty(report, calibration);
    if (each.standard) report.limits = injury::within_limits(report, *each.standard);
  }
  return reports;
}

int show_figures(const PulsesRequest& request) {
  const std::vector<injury::PulseReport> reports = reports_of(request);
  const injury::PulseReport& report = reports.front();
  const bool are_several = reports.size() > 1;
  const UnitSystem& units = unit_system(request.written.units);
  const auto document = [&](output::Pictures pictures) {
    return are_several ? output::pulses_document(reports, units, pictures)
                       : output::pulse_document(report, units, pictures);
  };
  const auto text_of = [&](const Target& target) {
    const ProgressLine waiting("Writing " + target.file);
    if (target.option == "--json")
      return are_several ? output::pulses_json(reports) : output::pulse_json(report);
    if (is_document(target)) return document_text(target, document);
    if (target.option == "--csv") return output::pulse_csv(report, units_of_files(units));
    return picture_text(are_several ? output::pulses_plot(reports, units) : output::pulse_plot(report, units),
                        target);
  };
  publish(request.written.targets(), request.written.force, text_of,
          output::to_terminal(document(output::Pictures::left_out), request.written.detail));
  int code = exit_done;
  for (const injury::PulseReport& each : reports)
    if (each.limits) code = std::max<int>(code, exit_code(injury::verdict_of(each.limits->results)));
  return code;
}

std::string list_of(const std::string& file, const std::string& test) {
  const ProgressLine waiting("Reading " + file);
  std::string text;
  if (input::is_iso_mme(file)) {
    for (const input::IsoMmeChannel& channel : input::iso_mme_channels(file, test).value())
      text += fmt::format("{:>4}  {:<16}  {:<8}  {:>8}  {}{}\n", channel.number, channel.code, channel.unit,
                          channel.samples, channel.name,
                          channel.problem.empty() ? "" : " (" + channel.problem + ")");
    text = fmt::format("{:>4}  {:<16}  {:<8}  {:>8}  {}\n", "No.", "code", "unit", "samples", "name") + text;
  } else {
    text = fmt::format("{:>4}  {:<30}  {}\n", "No.", "column", "unit");
    for (const injury::MeasuredColumn& column : input::pulse_csv_columns(file).value())
      text += fmt::format("{:>4}  {:<30}  {}\n", column.number, column.name,
                          column.unit.empty() ? "not stated" : column.unit);
  }
  for (char& c : text)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\n') || c == '\x7f') c = ' ';
  return text;
}

int show_pulses(const PulsesRequest& request) {
  if (!request.each.list) return show_figures(request);
  if (request.files.size() > 1) throw Refused({"--list: accepts only one file; give one FILE"});
  write_output(list_of(request.files.front(), request.each.source.test));
  return exit_done;
}

}  // namespace

void add_pulse(CLI::App& app, Action& action) {
  const auto [sub, request] = add_subcommand<PulsesRequest>(
      app, action, "pulse", "Compute injury metrics from a measured acceleration pulse (CSV, ISO-MME)",
      pulse_footer, show_pulses);
  PulseRequest& each = request.each;
  add_option(sub, "FILE", request.files, "Tables or ISO-MME tests")->required();
  add_source_options(sub, each);
  CLI::Option* list = add_flag(sub, "--list", each.list, "List the columns or channels, and exit");
  add_processing_options(sub, each);
  add_impact_options(sub, each);
  add_figure_options(sub, each);
  add_option(sub, "--standard NAME[:VARIANT]", request.standard,
             "Compare the figures with the limits of this standard (see dashpad standards)")
      ->excludes(list);
  add_standard_folder(sub, request.standard_folder);
  OutputFiles& written = request.written;
  add_file(sub, written, "--json", "Write the figures and the processing as JSON (- for standard output)")
      ->excludes(list);
  add_file(sub, written, "--csv",
           "Write the pulse from which the figures are computed, as CSV (- for standard output)")
      ->excludes(list);
  add_file(sub, written, "--picture", "Draw the pulse (.svg, .png, .pdf)")->excludes(list);
  for (CLI::Option* document : add_documents(sub, written)) document->excludes(list);
  add_units(sub, written.units);
  add_all(sub, written.detail);
  add_force(sub, written.force);
}

}  // namespace dashpad::app
