// The document of a measured pulse: its figures, then its origin and how it was processed.

#include "output/documents/pulse.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/version.hpp"
#include "output/documents/assessment.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
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
                                                            : "implied by the format";
  std::string text = fmt::format("{} in {} ({})", one_line(column.name), column.unit, from);
  if (!column.sensitivity.empty()) text += ", at " + one_line(column.sensitivity);
  if (column.factor != 1) text += fmt::format(", 1 {} = {:.7g} {}", column.unit, column.factor, si_unit);
  return text;
}

std::vector<std::string> offset_row(const injury::OffsetEffect& effect, double peak,
                                    const UnitSystem& units) {
  const auto& [offset, given, taken_off, with, without] = effect;
  const std::string interval =
      fmt::format("the mean of {} samples {}", offset.samples, stretch_of(offset.begin, offset.end, units));
  const std::string scatter = "scatter " + injury::each_in_g(offset.scatter, peak);
  const std::string mean = injury::each_in_g(offset.mean, peak);
  if (!taken_off) return {"Quiet part", fmt::format("{}, {}; {}", mean, interval, scatter)};
  return {"Zeroed",
          fmt::format("{} subtracted, {}; {}; {}", mean, interval, scatter, injury::change_of_hic15(effect))};
}

/// Restitution, HIC with chosen windows, and dwell times; with Detail::main only for levels that are reached.
std::vector<ValueRow> further_rows(const injury::PulseReport& report, const UnitSystem& units,
                                   Detail detail) {
  const int digits = digits_of(detail);
  std::vector<ValueRow> rows;
  const auto add = [&](const char* key, const std::string& label, double value, const std::string& remark) {
    const ScaledUnit unit = shown_as(result_quantity(key).si_unit, units);
    rows.push_back({.key = key,
                    .label = label,
                    .value = significant(unit.scale * value, digits),
                    .unit = unit.unit,
                    .remark = remark});
  };
  if (report.impact) {
    const injury::MeasuredImpact& impact = *report.impact;
    const double given = impact.gravity * (report.contact.end - report.contact.begin);
    if (const std::optional<double> restitution = injury::restitution(report.contact, impact))
      add("restitution", result_quantity("restitution").title, *restitution,
          "relative to " + brief_quantity(impact.speed, "m/s", units) +
              (given > 0
                   ? fmt::format(", after subtracting {} for gravity", brief_quantity(given, "m/s", units, 3))
                   : ""));
  }
  for (const injury::WindowedHic& windowed : report.windows)
    add("hic_unlimited", "HIC, window up to " + brief(1e3 * windowed.longest_window) + " ms",
        windowed.hic.value, stretch(windowed.hic.begin, windowed.hic.end, units, digits));
  for (const injury::DwellTime& each : report.dwells)
    if (each.cumulative > 0 || detail == Detail::all)
      add("dwell_time",
          injury::title_of(injury::Criterion{.quantity = &result_quantity("dwell_time"),
                                             .level = each.level,
                                             .description = {},
                                             .origin = {}}),
          each.cumulative, "in total; longest interval " + brief_quantity(each.longest, "s", units, digits));
  return rows;
}

/// The figures of the pulse, and what else it was asked for.
std::vector<ValueRow> rows_of(const injury::PulseReport& report, const UnitSystem& units, Detail detail) {
  std::vector<ValueRow> rows = pulse_rows(report.figures, units, detail);
  for (ValueRow& row : rows)
    if (row.key == "velocity_change")
      row.remark =
          "in contact, " + stretch(report.contact.begin, report.contact.end, units, digits_of(detail));
  for (ValueRow& row : further_rows(report, units, detail)) rows.push_back(std::move(row));
  return rows;
}

/// The uncertainty of each figure of the measurement by source, with Detail::main of peak and HIC15 only.
Table uncertainty_table(const injury::MeasurementUncertainty& uncertainty, Detail detail) {
  const auto share = [](const std::optional<double>& value, const char* none) {
    return !value ? none : *value < 5e-5 ? "< 0.01 %" : injury::in_percent(*value);
  };
  Table table{.columns = {"Uncertainty of", "Combined", "Sampling", "Filter", "Calibration"}};
  for (const injury::FigureUncertainty& each : uncertainty.figures) {
    const std::string_view key = each.quantity->key;
    if (detail == Detail::all || key == "peak_acceleration" || key == "hic15")
      table.rows.push_back({each.quantity->title, "± " + share(each.combined(), ""),
                            share(each.sampling, "not known"), share(each.filter, "-"),
                            share(each.calibration, "-")});
  }
  return table;
}

/// What the uncertainty of the measurement is, and what it leaves out.
std::string uncertainty_words(const injury::MeasurementUncertainty& uncertainty) {
  const std::string& compared = uncertainty.compared_with;
  return fmt::format(
      "Measurement uncertainty{} with coverage factor k = 2{}. The effect of any {}filter applied before the "
      "file was written is not included{}.",
      compared.empty() && !uncertainty.calibration ? ", from sampling only," : "",
      compared.empty() ? "" : ", including the effect of the filter compared with " + compared,
      compared.empty() ? "" : "other ",
      uncertainty.calibration ? "" : ", nor is that of the calibration (give it with --calibration)");
}

/// The result of a comparison with limits: "Within the limits: HIC(d) has 136 to spare".
std::string limits_answer(const injury::PulseLimits& limits, const UnitSystem& units) {
  const injury::Verdict verdict = injury::verdict_of(limits.results);
  const injury::CriterionResult* const next = closest(limits.results);
  if (next == nullptr) return "Undecided: the pulse is cut off, so its figures are lower bounds";
  const std::string name = uncapitalised(injury::title_of(next->criterion));
  const std::string margin = margin_words(*next, units, 3);
  const ValueRow row = criterion_row(*next, units, Detail::main);
  switch (verdict) {
    case injury::Verdict::pass: return fmt::format("Within the limits: {} has {} to spare", name, margin);
    case injury::Verdict::fail:
      return fmt::format("Fails: {} is {}, but must be {}", name, row.value, row.limit);
    case injury::Verdict::undecided: break;
  }
  return fmt::format("Undecided: {} is {} from its limit", name, margin);
}

/// Where and when the pulse was measured, as far as it is known.
std::vector<std::string> subject_of(const injury::PulseReport& report, const UnitSystem& units) {
  std::vector<std::string> lines{fmt::format("{} ({})", one_line(report.file), report.measured.format)};
  std::string about = report.impact ? "Impact " + impact_words(*report.impact, units) : "";
  for (const auto& [what, words] : report.about)
    about += fmt::format("{}{}: {}", about.empty() ? "" : ". ", what, one_line(words));
  if (!about.empty()) lines.push_back(about + ".");
  if (report.limits) lines.push_back("Limits of " + one_line(report.limits->standard));
  return lines;
}

/// The criteria, then the figures that are none of them.
std::vector<ValueRow> rows_with_limits(const injury::PulseReport& report, const UnitSystem& units,
                                       Detail detail) {
  std::vector<ValueRow> limited;
  if (report.limits) limited = criterion_rows(report.limits->results, units, detail);
  std::vector<ValueRow> rows = limited;
  for (ValueRow& row : rows_of(report, units, detail))
    if (!std::ranges::count(limited, row.label, &ValueRow::label)) rows.push_back(std::move(row));
  if (detail == Detail::all)
    for (ValueRow& row : rows) {
      row.error.reset();
      for (const injury::FigureUncertainty& each : report.uncertainty.figures)
        if (row.label == each.quantity->title) row.error = each.combined();
    }
  return rows;
}

}  // namespace

std::string pulse_answer(const injury::PulseReport& report, const UnitSystem& units) {
  if (report.limits) return limits_answer(*report.limits, units);
  return fmt::format(
      "Peak {}, HIC15 {}",
      brief_quantity(report.figures.peak.magnitude, result_quantity("peak_acceleration").si_unit, units, 3),
      brief(report.figures.hic15.value, 3));
}

Tone pulse_tone(const injury::PulseReport& report) {
  if (report.limits)
    if (const injury::Verdict verdict = injury::verdict_of(report.limits->results);
        verdict != injury::Verdict::pass || reservations(report).empty())
      return tone_of(verdict);
  return reservations(report).empty() ? Tone::plain : Tone::doubtful;
}

std::string impact_words(const injury::MeasuredImpact& impact, const UnitSystem& units) {
  return fmt::format(
      "at {}{}", brief_quantity(impact.speed, "m/s", units),
      impact.drop_height ? ", after a fall of " + brief_quantity(*impact.drop_height, "m", units) : "");
}

std::string filter_words(const injury::PulseFilter& filter) {
  return fmt::format("CFC{}, corner frequency of {}, ends {}", filter.channel_frequency_class,
                     filter.corner == injury::Corner::sae_j211 ? "SAE J211" : "ISO 6487",
                     to_string(filter.ends));
}

std::vector<std::vector<std::string>> pulse_basis(const injury::PulseReport& report,
                                                  const UnitSystem& units) {
  const injury::MeasuredPulse& measured = report.measured;
  const Pulse& pulse = measured.pulse;
  std::vector<std::vector<std::string>> rows{{"Time", origin(measured.time, "s")}};
  for (const injury::MeasuredColumn& column : measured.acceleration)
    rows.push_back({"Acceleration", origin(column, "m/s2")});
  if (measured.resultant)
    rows.push_back({"Resultant", fmt::format("of {} directions{}", measured.acceleration.size(),
                                             report.filter ? ", filtered separately, then combined" : "")});
  rows.push_back({"Samples", fmt::format("{} {}", pulse.time.size(),
                                         stretch_of(pulse.time.front(), pulse.time.back(), units))});
  if (report.resampled_to)
    rows.push_back(
        {"Resampled", fmt::format("every {}: {} samples", brief_quantity(*report.resampled_to, "s", units),
                                  report.pulse.time.size())});
  if (report.offset) rows.push_back(offset_row(*report.offset, report.figures.peak.magnitude, units));
  rows.push_back({"Filter", report.filter ? filter_words(*report.filter) : "none"});
  if (report.impact) rows.push_back({"Impact", impact_words(*report.impact, units)});
  return rows;
}

std::vector<std::string> reservations(const injury::PulseReport& report) {
  std::vector<std::string> lines;
  for (const Flag& flag : report.flags) lines.push_back(flag.text);
  if (report.limits)
    for (const Flag& flag : report.limits->reservations) lines.push_back(flag.text);
  for (const std::string& remark : report.measured.remarks) lines.push_back("REMARK: " + one_line(remark));
  return lines;
}

Document pulse_document(const injury::PulseReport& report, const UnitSystem& units, Pictures pictures) {
  Document document{.title = report.file, .warnings = reservations(report)};
  document.lead = Lead{.answer = pulse_answer(report, units),
                       .tone = pulse_tone(report),
                       .subject = subject_of(report, units),
                       .figures = rows_with_limits(report, units, Detail::main)};
  if (pictures == Pictures::drawn) document.lead->curve = untitled(pulse_plot(report, units));
  document.sections = {
      {.heading = "Figures",
       .rows = {{.rows = rows_with_limits(report, units, Detail::all), .error = "Uncertainty (k = 2)"}}}};
  if (!report.uncertainty.figures.empty())
    for (const auto& [seen, detail] : {std::pair{Seen::in_full, Detail::all}, {Seen::in_brief, Detail::main}})
      document.sections.push_back({.seen = seen,
                                   .paragraphs = {uncertainty_words(report.uncertainty)},
                                   .tables = {uncertainty_table(report.uncertainty, detail)}});
  if (const auto check = injury::speed_check(report))
    document.sections.push_back({.heading = "Velocity", .seen = Seen::always, .paragraphs = {check->text}});
  if (report.limits)
    document.sections.push_back(
        {.seen = Seen::always,
         .paragraphs = {"Only the figures of the pulse are compared with the limits of the standard; how the "
                        "test was carried out is not assessed, and nothing is certified."}});
  document.sections.push_back(
      {.heading = "Basis",
       .seen = Seen::always,
       .paragraphs = {fmt::format("HIC and severity index are in g^2.5 s; the pulse is taken as linear "
                                  "between its samples (dashpad {}).",
                                  version())},
       .tables = {{.columns = {"", ""}, .rows = pulse_basis(report, units)}}});
  return document;
}

}  // namespace dashpad::output
