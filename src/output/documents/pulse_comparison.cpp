#include "dashpad/output/pulse.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/impact.hpp"
#include "output/documents/basis.hpp"
#include "output/documents/pulse.hpp"
#include "output/result_rows.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using injury::Alignment;
using injury::ComparedFigure;

constexpr int compared_digits = 4;
constexpr double next_to_nothing = 5e-3;  // share of the measured figure below which figures count as equal
constexpr double rounding_of_figures = 1e-6;

const ComparedFigure& figure_of(const PulseComparisonReport& report, std::string_view key) {
  return *std::ranges::find(report.comparison.figures, key,
                            [](const ComparedFigure& figure) { return figure.quantity->key; });
}

/// "12 %": two digits, and all before the point; of 100,000 % and more nobody wants them.
std::string in_percent(double share) {
  return std::abs(share) < 1000 ? injury::in_percent(std::abs(share)) : "more than 1000 times";
}

/// "12 % above", or "" for next to nothing.
std::string more_or_less(double share, const char* more, const char* less) {
  if (std::abs(share) < next_to_nothing) return "";
  return fmt::format("{} {}", in_percent(share), share > 0 ? more : less);
}

/// A figure in the unit that people see.
std::string shown(const std::optional<double>& value, double scale) {
  return value ? significant(scale * *value, compared_digits) : "-";
}

std::string shown_difference(const ComparedFigure& figure, double scale) {
  if (!figure.difference()) return "-";
  if (std::abs(*figure.difference()) <= rounding_of_figures * std::abs(*figure.computed)) return "0";
  return fmt::format("{:+.3g}", scale * *figure.difference());
}

std::string shown_share(const ComparedFigure& figure) {
  const std::optional<double> share = figure.share();
  if (!share) return "-";
  if (std::abs(*share) <= rounding_of_figures) return "0 %";
  if (*share >= 1000) return "> 1000 times";
  return (*share < 0 ? "-" : "+") + in_percent(*share);
}

/// Whether times that count from the onset may count from something else.
bool is_onset_doubtful(const injury::PulseComparison& comparison) {
  constexpr double matters = 0.05;  // share of the time to the peak
  const injury::PulseShape& pulse = comparison.measured;
  return comparison.alignment != injury::Alignment::none && pulse.onset && pulse.last_onset &&
         *pulse.last_onset - *pulse.onset > matters * (pulse.peak.time - *pulse.onset);
}

std::string alignment_note(const PulseComparisonReport& report, const UnitSystem& units) {
  const injury::PulseComparison& comparison = report.comparison;
  const std::string shift = fmt::format(
      "{} {} the measured times", brief_quantity(std::abs(comparison.shift), "s", units, compared_digits),
      comparison.shift < 0 ? "subtracted from" : "added to");
  switch (comparison.alignment) {
    case Alignment::onset:
      return fmt::format(
          "Aligned at the onset, where each pulse first reaches {:.0f} % of its peak: {}. The time to peak "
          "is measured from this onset.",
          100 * injury::onset_share, shift);
    case Alignment::peak:
      return fmt::format(
          "Aligned at the peak: {}. The time to peak is measured from the point at which each pulse first "
          "reaches {:.0f} % of its peak.",
          shift, 100 * injury::onset_share);
    case Alignment::none:
      return "Not aligned: the time to peak is measured from first contact in the computed pulse and from "
             "time zero in the measured one.";
  }
  return "";
}

std::string restitution_note(const PulseComparisonReport& report, const UnitSystem& units) {
  const injury::PulseShape& measured = report.comparison.measured;
  const std::string over = fmt::format(
      "The velocity change is taken over the time in which the acceleration has the sign of its peak "
      "(measured: {})",
      stretch(measured.contact.begin, measured.contact.end, units, compared_digits));
  if (!report.pulse.impact) return over + ".";
  const std::string speed = brief_quantity(report.pulse.impact->speed, "m/s", units, compared_digits);
  return measured.restitution
             ? fmt::format("{}. The measured restitution is for an impact at {}.", over, speed)
             : fmt::format("{}. For an impact at {}, the change fits no restitution (0 to 1).", over, speed);
}

/// The interval of a computed figure. Null without one, and beside a filter, which it is without.
const FigureInterval* interval_beside(const PulseComparisonReport& report, const char* key) {
  const std::optional<Intervals>& intervals = report.solution.summary.intervals;
  const FigureInterval* const found = intervals && !report.pulse.filter ? intervals->find(key) : nullptr;
  return found != nullptr && !found->sources.empty() ? found : nullptr;
}

/// The differences between computed and measured figures.
std::vector<ValueRow> key_figures(const PulseComparisonReport& report, const UnitSystem& units) {
  std::vector<ValueRow> rows;
  if (!report.comparison.computed) return rows;
  for (const std::vector<std::string>& row : comparison_table(report, units).rows) {
    const auto value = [&](const std::string& cell) {
      return cell == "-" ? "none" : with_unit(cell, row[1]);
    };
    const std::string interval = row[7].empty() ? "" : fmt::format(" ({} at 95 %)", row[7]);
    rows.push_back(
        {.label = row[0],
         .value = row[5],
         .remark = fmt::format("{} computed{}, {} measured", value(row[3]), interval, value(row[2]))});
  }
  return rows;
}

/// The warnings of the case and of the pulse, a line each.
std::vector<std::string> comparison_reservations(const PulseComparisonReport& report,
                                                 const UnitSystem& units) {
  std::vector<std::string> lines;
  if (is_onset_doubtful(report.comparison))
    lines.push_back(fmt::format(
        "ONSET IN DOUBT: the pulse first reaches {:.0f} % of its peak at {}, but crosses that level for the "
        "last time before the peak at {}; noise or an offset may have been mistaken for the impact; --zero "
        "auto, --filter or --align peak may help",
        100 * injury::onset_share, brief_quantity(*report.comparison.measured.onset, "s", units, 3),
        brief_quantity(*report.comparison.measured.last_onset, "s", units, 3)));
  for (const std::string& line : reservations(report.pulse)) lines.push_back(line + " (pulse)");
  for (const std::string& line : warnings(report.solution.summary, units)) lines.push_back(line + " (case)");
  return lines;
}

}  // namespace

std::string comparison_answer(const PulseComparisonReport& report) {
  if (!report.comparison.computed)
    return "The computed pulse is incomplete and cannot be compared. " + outcome(report.solution.summary);
  const ComparedFigure& of_peak = figure_of(report, "peak_acceleration");
  const std::string peak = more_or_less(*of_peak.share(), "higher", "lower");
  std::string text = peak.empty() ? "The computed peak is within 0.5 % of the measured one"
                                  : "The computed peak is " + peak + " than the measured one";
  if (const auto share = figure_of(report, "time_to_peak").share()) {
    const std::string time = more_or_less(*share, "later", "earlier");
    text += " and occurs " + (time.empty() ? "at the same time" : time);
  }
  const std::string hic = more_or_less(*figure_of(report, "hic15").share(), "higher", "lower");
  text += hic.empty() ? "; HIC15 agrees." : "; HIC15 is " + hic + ".";
  if (const FigureInterval* const interval = interval_beside(report, "peak_acceleration"))
    text += fmt::format(
        " The measured peak lies {} the 95 % interval of the computed one.",
        *of_peak.measured < interval->low || *of_peak.measured > interval->high ? "outside" : "within");
  const std::optional<injury::MeasuredImpact>& measured = report.pulse.impact;
  const double speed = report.impact.impactor.speed;
  if (measured && injury::unlike_speeds(*measured, {.speed = speed}))
    text += " But the impact speed in the case is " +
            more_or_less(speed / measured->speed - 1, "higher", "lower") + ".";
  return text;
}

Table comparison_table(const PulseComparisonReport& report, const UnitSystem& units) {
  Table table{.columns = {"Figure", "Unit", "Measured", "Computed", "Difference", "Difference (%)",
                          "Numerical error", "95 % interval"}};
  for (const ComparedFigure& figure : report.comparison.figures) {
    const auto [scale, unit] = shown_as(figure.quantity->si_unit, units);
    const FigureInterval* const interval = interval_beside(report, figure.quantity->key);
    table.rows.push_back({figure.quantity->title, unit, shown(figure.measured, scale),
                          shown(figure.computed, scale), shown_difference(figure, scale), shown_share(figure),
                          figure.computed ? "± " + shown_error(figure.error) : "-",
                          interval ? interval_words(*interval, units) : ""});
  }
  return table;
}

std::vector<std::string> comparison_notes(const PulseComparisonReport& report, const UnitSystem& units) {
  std::vector<std::string> notes{alignment_note(report, units),
                                 "The width is the total time above half the peak. HIC15 is in g^2.5 s.",
                                 restitution_note(report, units)};
  if (report.pulse.filter) notes.emplace_back("The computed pulse was filtered like the measured one.");
  return notes;
}

Document pulse_comparison_document(const PulseComparisonReport& report, const UnitSystem& units,
                                   Pictures pictures) {
  Document document{.title = comparison_answer(report), .warnings = comparison_reservations(report, units)};
  document.lead = Lead{.answer = document.title,
                       .tone = !report.comparison.computed ? Tone::bad
                               : document.warnings.empty() ? Tone::plain
                                                           : Tone::doubtful,
                       .subject = {fmt::format("{} ({}) compared with {}", one_line(report.pulse.file),
                                               report.pulse.measured.format, one_line(report.case_file))},
                       .figures = key_figures(report, units)};
  if (pictures == Pictures::drawn) {
    document.lead->drawing = impact_drawing(report.impact, report.solution, units);
    document.lead->curve = untitled(pulse_comparison_plot(report, units));
  }
  std::vector<Basis> of_case = case_basis(report.impact, units);
  of_case.push_back(solver_basis(report.solution.summary));
  document.sections = {
      {.heading = "Figures", .seen = Seen::on_pages, .tables = {comparison_table(report, units)}},
      {.heading = "Basis",
       .seen = Seen::always,
       .paragraphs = comparison_notes(report, units),
       .tables = {captioned("The case", basis_table(of_case)),
                  {.caption = "The pulse", .columns = {"", ""}, .rows = pulse_basis(report.pulse, units)}}}};
  return document;
}

}  // namespace dashpad::output
