// A measured pulse over the computed one, as a picture.

#include "dashpad/output/pulse.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/documents/pulse.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t turn_of_computed = 0, turn_of_measured = 6;
constexpr double room = 0.1;  // of the contact, beside it

/// The pulse with its peak upwards, `shift` s later.
Series deceleration(const char* label, const Pulse& pulse, double side, double shift, std::size_t turn,
                    const UnitSystem& units) {
  Series series{.label = label, .style = SeriesStyle::solid_line, .turn = turn};
  for (std::size_t i = 0; i < pulse.time.size(); ++i)
    series.add(value_in(units, pulse.time[i] + shift, "s"), side * pulse.acceleration[i] / standard_gravity);
  return series;
}

}  // namespace

Plot pulse_comparison_plot(const PulseComparisonReport& report, const UnitSystem& units) {
  const injury::PulseComparison& of = report.comparison;
  double begin = of.measured.contact.begin + of.shift, end = of.measured.contact.end + of.shift;
  if (!of.computed_pulse.time.empty()) {
    begin = std::min(begin, of.computed ? of.computed->contact.begin : of.computed_pulse.time.front());
    end = std::max(end, of.computed ? of.computed->contact.end : of.computed_pulse.time.back());
  }
  Panel panel{.x = axis_of("time", units), .y = axis_of("deceleration", units)};
  if (of.computed)
    panel.title = fmt::format("The computed peak is {} g, the measured one {} g",
                              brief(of.computed->peak.magnitude / standard_gravity, 3),
                              brief(of.measured.peak.magnitude / standard_gravity, 3));
  else
    panel.y.high = 1.5 * of.measured.peak.magnitude / standard_gravity;
  panel.x.low = value_in(units, begin - room * (end - begin), "s");
  panel.x.high = value_in(units, end + room * (end - begin), "s");
  panel.series = {
      deceleration("computed", of.computed_pulse, of.computed ? of.computed->side : -1, 0, turn_of_computed,
                   units),
      deceleration("measured", report.pulse.pulse, of.measured.side, of.shift, turn_of_measured, units)};
  return {.title = one_line(report.impact.title.empty() ? report.case_file : report.impact.title),
          .panels = {std::move(panel)},
          .source = fmt::format("dashpad {}; {} over {}; filter of both: {}; alignment: {}", version(),
                                one_line(report.pulse.file), one_line(report.case_file),
                                report.pulse.filter ? filter_words(*report.pulse.filter) : "none",
                                injury::to_string(of.alignment))};
}

}  // namespace dashpad::output
