// The pictures of a pulse, and of one over the computed one.

#include <algorithm>

#include <fmt/format.h>

#include "dashpad/output/pulse.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "dashpad/version.hpp"
#include "output/documents/assessment.hpp"
#include "output/documents/pulse.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/impact_figures.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t turn_of_computed = 0, turn_of_measured = 6;
constexpr double room = 0.1;  // share of the contact that is shown on either side of it
constexpr std::size_t turn_of_filtered = 0, turn_of_raw = 3, turn_of_hic15 = 1, turn_of_hic36 = 2;

/// The pulse, `shift` s later; `side` -1 turns it over.
Series line(const std::string& label, const Pulse& pulse, std::size_t palette_index, const UnitSystem& units,
            double side = 1, double shift = 0) {
  Series series{.label = label, .style = SeriesStyle::solid_line, .palette_index = palette_index};
  const double time_factor = value_in(units, 1, "s");
  for (std::size_t i = 0; i < pulse.time.size(); ++i)
    series.add(time_factor * (pulse.time[i] + shift), side * pulse.acceleration[i] / standard_gravity);
  return series;
}

/// 1 or -1: on which side of zero the pulse has its peak.
double side_of_peak(const injury::PulseReport& report) {
  for (std::size_t i = 0; i < report.pulse.time.size(); ++i)
    if (report.pulse.time[i] >= report.figures.peak.time) return report.pulse.acceleration[i] < 0 ? -1 : 1;
  return 1;
}

/// Limits the time axis of a much longer record to the impact, with its windows and a margin.
void show_impact(Axis& x, const injury::PulseReport& report, const UnitSystem& units) {
  constexpr double beside = 0.3, much_longer = 1.5;
  if (report.pulse.time.empty()) return;
  const auto [first, last] = std::minmax(report.contact.begin, report.contact.end);
  double begin = std::min({first, report.figures.hic15.begin, report.figures.hic36.begin});
  double end = std::max({last, report.figures.hic15.end, report.figures.hic36.end});
  const double margin = beside * (end - begin);
  begin = std::max(begin - margin, report.pulse.time.front());
  end = std::min(end + margin, report.pulse.time.back());
  if (!(end > begin) || report.pulse.time.back() - report.pulse.time.front() < much_longer * (end - begin))
    return;
  x.low = value_in(units, begin, "s");
  x.high = value_in(units, end, "s");
}

}  // namespace

Plot pulse_comparison_plot(const PulseComparisonReport& report, const UnitSystem& units) {
  const injury::PulseComparison& comparison = report.comparison;
  const auto& computed = comparison.computed;
  double begin = comparison.measured.contact.begin + comparison.shift,
         end = comparison.measured.contact.end + comparison.shift;
  if (const std::vector<double>& time = comparison.computed_pulse.time; !time.empty()) {
    begin = std::min(begin, computed ? computed->contact.begin : time.front());
    end = std::max(end, computed ? computed->contact.end : time.back());
  }
  Panel panel{.x = axis_of("time", units), .y = axis_of("deceleration", units)};
  const double peak = comparison.measured.peak.magnitude;
  if (computed)
    panel.title =
        fmt::format("The computed peak is {} g, the measured peak {} g",
                    brief(computed->peak.magnitude / standard_gravity, 3), brief(peak / standard_gravity, 3));
  else
    panel.y.high = 1.5 * peak / standard_gravity;
  panel.x.low = value_in(units, begin - room * (end - begin), "s");
  panel.x.high = value_in(units, end + room * (end - begin), "s");
  panel.series = {
      line("computed", comparison.computed_pulse, turn_of_computed, units, computed ? computed->side : -1),
      line("measured", report.pulse.pulse, turn_of_measured, units, comparison.measured.side,
           comparison.shift)};
  return {.title = one_line(report.impact.title.empty() ? report.case_file : report.impact.title),
          .panels = {std::move(panel)},
          .source = fmt::format("dashpad {}; {} against {}; filter for both: {}; alignment: {}", version(),
                                one_line(report.pulse.file), one_line(report.case_file),
                                report.pulse.filter ? filter_words(*report.pulse.filter) : "none",
                                injury::to_string(comparison.alignment))};
}

Plot pulse_plot(const injury::PulseReport& report, const UnitSystem& units) {
  const double side = side_of_peak(report);
  const injury::InjuryFigures& figures = report.figures;
  Panel panel{.title = "The acceleration " + peak_words(figures),
              .x = axis_of("time", units),
              .y = axis_of("acceleration", units)};
  const double peak = side * figures.peak.magnitude / standard_gravity;
  if (figures.hic36.begin != figures.hic15.begin || figures.hic36.end != figures.hic15.end)
    panel.series.push_back(
        hic_bracket("hic36", figures.hic36, brief(figures.hic36.value, 4), peak, turn_of_hic36, units, 1));
  panel.series.push_back(
      hic_bracket("hic15", figures.hic15, brief(figures.hic15.value, 4), peak, turn_of_hic15, units));
  if (report.filter) {
    panel.series.push_back(line("as measured", report.measured.pulse, turn_of_raw, units));
    panel.series.push_back(line(fmt::format("CFC{}", report.filter->channel_frequency_class), report.pulse,
                                turn_of_filtered, units));
  } else {
    panel.series.push_back(line("pulse", report.pulse, turn_of_filtered, units));
  }
  const double clip = side * figures.clip_3ms.level / standard_gravity;
  add_clip(panel, clip, brief(std::abs(clip), 4));
  if (report.limits)
    for (Series& limit : acceleration_limits(report.limits->results, units)) {
      limit.y.front() *= side;
      panel.series.push_back(std::move(limit));
    }
  show_impact(panel.x, report, units);
  return {.title = one_line(report.file),
          .panels = {panel},
          .source = fmt::format("dashpad {}; filter: {}", version(),
                                report.filter ? filter_words(*report.filter) : "none")};
}

}  // namespace dashpad::output
