// dashpad pulse: injury figures of a measured acceleration.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "dashpad/input/measurement/pulse_csv.hpp"
#include "dashpad/output/pulse.hpp"
#include "output.hpp"
#include "progress_line.hpp"
#include "pulse/report.hpp"
#include "pulse/request.hpp"
#include "streams.hpp"

namespace dashpad::app {

namespace {

constexpr const char* pulse_footer = R"(Examples:
  dashpad pulse drop.csv                                  columns and units from the header
  dashpad pulse drop.csv --time 1 --acceleration 3 --time-unit ms --acceleration-unit g
  dashpad pulse head.csv --resultant --filter CFC1000     x, y and z each filtered, then combined
  dashpad pulse drop.csv --zero auto --drop-height "1.5 m"
                                                          sensor offset off; restitution, and a check
  dashpad pulse logger.csv --interval "0.1 ms" --sensitivity "10 mV/g"
                                                          one column, in mV
  dashpad pulse drop.csv --report drop.html               a page: figures, curve, what it rests on
  dashpad pulse test.zip --list                           the channels of a test in ISO-MME
  dashpad pulse test.zip --channel "11HEAD0000??AC?A" --resultant --picture head.svg
  dashpad run examples/dashboard-20mph.toml --csv - > run.csv && dashpad pulse run.csv

FILE is a table (CSV: commas, semicolons, tabs or blanks), or a test in ISO-MME: its folder, its .mme file, or
a zip or tar of it. Units are taken from the file or from you and never guessed; g is standard gravity. What
had to be repaired is a REMARK; a gap, text, or a time that goes back is refused; --bridge-gaps takes straight
lines where times are missing. docs/pulses.md has the rules.

Offset: what the sensor shows in the quiet part before the impact is told, with what it does to HIC15. --zero
takes it off, each direction by itself and before any filter: "--zero auto" the mean of the quiet part,
"--zero '0 ms,5 ms'" the mean from 0 to 5 ms.

Checks: PULSE CUT says that the pulse starts or ends above 1 % of its peak; its HIC and clips are lower bounds
then. With --speed or --drop-height the velocity change must lie between v and 2v, IMPOSSIBLE VELOCITY CHANGE
says otherwise; the restitution is (velocity change - v) / v. With --drop-height what gravity adds during contact
is taken off before.

Uncertainty: of peak, HIC and the like, k = 2, by what the sample interval may hide, what the filter takes away
beside the next higher class, and --calibration "2 %", that of the sensor.

Figures: the peak; HIC15, HIC36, HIC with any window, and those of --window; HIC(d); the 3 ms clip, in one
stretch and in all; Gadd's severity index; the time above 80, 150 and 200 g, or the levels of --dwell; the
change of velocity over contact. They are of the pulse as it is, or as --filter makes it. The directions of a resultant are
each filtered, then combined. A filter needs even samples:
--resample "0.1 ms" makes them so, by straight lines.

Files: - as FILE of --json or --csv is standard output; the text then goes to standard error. An existing file
is kept unless --force is given. A file is written whole or not at all.

Exit codes: 0 done, 1 a result could not be written, 2 input or command line refused and nothing written.)";

std::vector<Target> targets(const PulseRequest& request) {
  std::vector<Target> wanted;
  if (request.json) wanted.push_back({"--json", *request.json});
  if (request.csv) wanted.push_back({"--csv", *request.csv});
  if (request.picture) wanted.push_back({"--picture", *request.picture});
  add_targets(request.documents, wanted);
  return wanted;
}

int show_figures(const PulseRequest& request) {
  std::vector<std::string> complaints;
  const std::optional<double> calibration = calibration_of(request, complaints);
  injury::PulseReport report = pulse_report(
      request, std::move(complaints),
      [&](const auto& files, auto& wrong) { judge_targets(targets(request), files, request.force, wrong); });
  {
    const ProgressLine waiting("Computing the uncertainty of " + request.file);
    report.uncertainty = injury::measurement_uncertainty(report, calibration);
  }
  const UnitSystem& units = unit_system(request.units);
  const auto text_of = [&](const Target& target) {
    const ProgressLine waiting("Writing " + target.file);
    if (target.option == "--json") return output::pulse_json(report);
    if (is_document(target))
      return document_text(
          target, [&](output::Pictures pictures) { return output::pulse_document(report, units, pictures); });
    if (target.option == "--csv") return output::pulse_csv(report, units_of_files(units));
    return output::picture(output::pulse_plot(report, units), *output::picture_format(target.file));
  };
  publish(targets(request), request.force, text_of,
          output::to_terminal(output::pulse_document(report, units), request.detail));
  return exit_done;
}

std::string list_of(const PulseRequest& request) {
  const ProgressLine waiting("Reading " + request.file);
  std::string text;
  if (input::is_iso_mme(request.file)) {
    for (const input::IsoMmeChannel& channel : input::iso_mme_channels(request.file).value())
      text += fmt::format("{:>4}  {:<16}  {:<8}  {:>8}  {}{}\n", channel.number, channel.code, channel.unit,
                          channel.samples, channel.name,
                          channel.problem.empty() ? "" : " (" + channel.problem + ")");
    text = fmt::format("{:>4}  {:<16}  {:<8}  {:>8}  {}\n", "No.", "code", "unit", "samples", "name") + text;
  } else {
    text = fmt::format("{:>4}  {:<30}  {}\n", "No.", "column", "unit");
    for (const injury::MeasuredColumn& column : input::pulse_csv_columns(request.file).value())
      text += fmt::format("{:>4}  {:<30}  {}\n", column.number, column.name,
                          column.unit.empty() ? "not said" : column.unit);
  }
  for (char& c : text)
    if ((static_cast<unsigned char>(c) < ' ' && c != '\n') || c == '\x7f') c = ' ';
  return text;
}

int show_list(const PulseRequest& request) {
  write_output(list_of(request));
  return exit_done;
}

}  // namespace

void add_pulse(CLI::App& app, Action& action, const std::filesystem::path&) {
  CLI::App* sub = app.add_subcommand("pulse", "Injury figures of a measured acceleration (CSV, ISO-MME)");
  const auto request = std::make_shared<PulseRequest>();
  sub->add_option("FILE", request->file, "Table, or test in ISO-MME")->required()->type_name("");
  add_source_options(*sub, *request);
  CLI::Option* list = sub->add_flag("--list", request->list, "Show the columns or channels, and nothing else")
                          ->disable_flag_override();
  add_processing_options(*sub, *request);
  add_figure_options(*sub, *request);
  sub->add_option("--json", request->json, "Write figures and processing as JSON (- for standard output)")
      ->excludes(list)
      ->type_name("FILE");
  sub->add_option("--csv", request->csv, "Write the pulse of the figures as CSV (- for standard output)")
      ->excludes(list)
      ->type_name("FILE");
  sub->add_option("--picture", request->picture, "Draw the pulse (.svg, .png, .pdf)")
      ->excludes(list)
      ->type_name("FILE");
  for (CLI::Option* document : add_documents(*sub, request->documents)) document->excludes(list);
  add_units(*sub, request->units);
  add_all(*sub, request->detail);
  add_force(*sub, request->force);
  sub->footer(pulse_footer);
  sub->callback([request, &action] {
    action = [request] { return request->list ? show_list(*request) : show_figures(*request); };
  });
}

}  // namespace dashpad::app
