#include "dashpad/output/pulse.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/injury/standard.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/version.hpp"
#include "output/result_rows.hpp"
#include "output/text/pulse_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr int source_digits = 5;

std::string stretch_of(double begin, double end, const UnitSystem& units) {
  return stretch(begin, end, units, source_digits);
}

std::string origin(const injury::MeasuredColumn& column, const std::string& si_unit) {
  const std::string from = column.unit_origin == "given"    ? "as given"
                           : column.unit_origin == "header" ? "from the file"
                                                            : "by the format";
  std::string text = fmt::format("{} in {} ({})", one_line(column.name), column.unit, from);
  if (!column.sensitivity.empty()) text += ", at " + one_line(column.sensitivity);
  if (column.factor != 1) text += fmt::format(", 1 {} = {:.7g} {}", column.unit, column.factor, si_unit);
  return text;
}

std::string offset_line(const injury::PulseReport& report, const UnitSystem& units) {
  if (!report.offset) return "";
  const auto& [offset, given, taken_off, with, without] = *report.offset;
  const std::string interval =
      fmt::format("the mean of {} samples {}", offset.samples, stretch_of(offset.begin, offset.end, units));
  const std::string scatter = "scatter " + injury::each_in_g(offset.scatter, report.figures.peak.magnitude);
  const std::string mean = injury::each_in_g(offset.mean, report.figures.peak.magnitude);
  if (!taken_off) return fmt::format("  quiet part    {}, {}; {}\n", mean, interval, scatter);
  return fmt::format("  zeroed        {} taken off, {}; {}; {}\n", mean, interval, scatter,
                     injury::change_of_hic15(*report.offset));
}

/// Restitution, HIC with windows of one's own and dwell times. With Detail::main no level that is not
/// reached.
std::vector<ResultRow> further_rows(const injury::PulseReport& report, const UnitSystem& units,
                                    Detail detail) {
  const int digits = digits_of(detail);
  std::vector<ResultRow> rows;
  const auto add = [&](const char* key, const std::string& label, double value, const std::string& remark) {
    const ScaledUnit unit = shown_as(result_quantity(key).si_unit, units);
    rows.push_back({key, label, significant(unit.scale * value, digits), unit.unit, {}, remark});
  };
  if (report.impact) {
    const injury::MeasuredImpact& impact = *report.impact;
    const double given = impact.gravity * (report.contact.end - report.contact.begin);
    if (const std::optional<double> restitution = injury::restitution(report.contact, impact))
      add("restitution", result_quantity("restitution").title, *restitution,
          "of an impact at " + brief_quantity(impact.speed, "m/s", units) +
              (given > 0 ? ", without gravity's " + brief_quantity(given, "m/s", units, 3) : ""));
  }
  for (const injury::WindowedHic& of : report.windows)
    add("hic_unlimited", "HIC of " + brief(1e3 * of.longest_window) + " ms", of.hic.value,
        stretch(of.hic.begin, of.hic.end, units, digits));
  for (const injury::DwellTime& of : report.dwells)
    if (of.cumulative > 0 || detail == Detail::all)
      add("dwell_time",
          injury::title_of(injury::Criterion{
              .metric = injury::Metric::dwell_time, .level = of.level, .description = {}, .origin = {}}),
          of.cumulative, "in all; longest " + brief_quantity(of.longest, "s", units, digits));
  return rows;
}

}  // namespace

std::vector<ResultRow> report_rows(const injury::PulseReport& report, const UnitSystem& units,
                                   Detail detail) {
  std::vector<ResultRow> rows = pulse_rows(report.figures, units, detail);
  for (ResultRow& row : rows)
    if (row.key == "velocity_change")
      row.remark =
          "in contact, " + stretch(report.contact.begin, report.contact.end, units, digits_of(detail));
  for (ResultRow& row : further_rows(report, units, detail)) rows.push_back(std::move(row));
  return rows;
}

std::string uncertainty_words(const injury::MeasurementUncertainty& of, Detail detail) {
  constexpr double next_to_nothing = 5e-5;
  const auto share = [](double value) {
    return value < next_to_nothing ? "below 0.01 %" : injury::in_percent(value);
  };
  std::string text;
  for (const injury::FigureUncertainty& each : of.figures) {
    const std::string_view key = each.quantity->key;
    if (detail == Detail::main && key != "peak_acceleration" && key != "hic15") continue;
    text += fmt::format("{}{} ± {} (sampling {}", text.empty() ? "Uncertainty of the measurement: " : "; ",
                        title_in_sentence(*each.quantity), share(each.combined()),
                        each.sampling ? share(*each.sampling) : "not known");
    if (each.filter) text += ", filter " + share(*each.filter);
    if (each.calibration) text += ", calibration " + share(*each.calibration);
    text += ")";
  }
  if (text.empty()) return text;
  text += of.compared_with.empty() ? ", k = 2. What a filter before the file took away is not in it"
                                   : fmt::format(
                                         ", k = 2, the filter beside {}. What another one before the "
                                         "file took away is not in it",
                                         of.compared_with);
  return text + (of.calibration ? "." : ", nor is the calibration, which --calibration states.");
}

std::string filter_words(const injury::PulseFilter& filter) {
  return fmt::format("CFC{}, corner of {}, ends {}", filter.channel_frequency_class,
                     filter.corner == injury::Corner::sae_j211 ? "SAE J211" : "ISO 6487",
                     to_string(filter.ends));
}

std::string pulse_source(const injury::PulseReport& report, const UnitSystem& units) {
  const injury::MeasuredPulse& measured = report.measured;
  const Pulse& pulse = measured.pulse;
  std::string text = fmt::format("  time          {}\n", origin(measured.time, "s"));
  for (const injury::MeasuredColumn& column : measured.acceleration)
    text += fmt::format("  acceleration  {}\n", origin(column, "m/s2"));
  if (measured.resultant)
    text += fmt::format("  resultant of {} directions{}\n", measured.acceleration.size(),
                        report.filter ? ", each filtered, then combined" : "");
  text += fmt::format("  {} samples {}\n", pulse.time.size(),
                      stretch_of(pulse.time.front(), pulse.time.back(), units));
  if (report.resampled_to)
    text += fmt::format("  resampled every {}: {} samples\n",
                        brief_quantity(*report.resampled_to, "s", units), report.pulse.time.size());
  text += offset_line(report, units);
  return text + fmt::format("  filter        {}\n", report.filter ? filter_words(*report.filter) : "none");
}

std::string pulse_source_sentence(const injury::PulseReport& report, const UnitSystem& units) {
  std::string source = "The pulse:" + pulse_source(report, units);
  source.back() = '.';
  replace_all(source, "\n", ";");
  return source;
}

std::vector<std::string> reservations(const injury::PulseReport& report) {
  std::vector<std::string> lines;
  for (const Flag& flag : report.flags) lines.push_back(flag.text);
  for (const std::string& remark : report.measured.remarks) lines.push_back("REMARK: " + one_line(remark));
  return lines;
}

std::string pulse_text(const injury::PulseReport& report, const UnitSystem& units, Detail detail) {
  std::string text = fmt::format("{} ({})\n", one_line(report.file), report.measured.format);
  for (const std::string& line : reservations(report)) text += wrapped(line, 2) + "\n";
  text += "\n";
  text += laid_out(report_rows(report, units, detail));
  if (const std::string words = uncertainty_words(report.uncertainty, detail); !words.empty())
    text += "\n" + wrapped(words, 2) + "\n";
  if (const auto check = injury::speed_check(report)) text += "\n" + wrapped(check->text, 2) + "\n";
  text += "\nThe pulse:\n" + wrapped_lines(pulse_source(report, units));
  return text + fmt::format(
                    "HIC and severity index in g^2.5 s; the pulse is linear between its samples "
                    "(dashpad {})\n",
                    version());
}

}  // namespace dashpad::output
