// The tables of a fit.

#include <fmt/format.h>

#include "dashpad/fit/fit.hpp"
#include "output/text/fit_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Half width of the 95 % interval of a normal distribution, in standard deviations.
constexpr double width_of_95 = 1.96;

std::string rms_text(const std::optional<double>& rms, double largest, const UnitSystem& units) {
  if (!rms) return "not tested";
  return fmt::format("{}, {:.2g} %", brief_quantity(*rms, "Pa", units, 3), 100 * *rms / largest);
}

std::string loops_text(const fit::MetTest& test) {
  std::string text;
  for (const fit::Loop& loop : test.loops)
    text +=
        fmt::format("{}{:.3f}, {:.3f}", text.empty() ? "" : "; ", loop.measured_return, loop.computed_return);
  return text.empty() ? "no loops" : text;
}

}  // namespace

Table table_of_unknowns(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"unknown", "value", "standard error", "95 % interval", ""}};
  for (const fit::FittedUnknown& unknown : report.unknowns)
    table.rows.push_back(
        {unknown.key, brief_quantity(unknown.value, unknown.unit, units, 4),
         unknown.standard_error ? brief_quantity(*unknown.standard_error, unknown.unit, units, 2) : "none",
         interval_words(unknown, units),
         unknown.wants_beyond()     ? unknown.is_at_lowest ? "at its lower bound" : "at its upper bound"
         : unknown.is_at_lowest     ? "at its smallest possible value"
         : unknown.is_at_highest    ? "at its largest possible value"
         : unknown.rests_on_prior() ? "mostly from its prior"
                                    : ""});
  return table;
}

Table table_of_tests(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"test", "points", "loading", "unloading", "energy return, test and model", ""}};
  for (const fit::MetTest& test : report.tests)
    table.rows.push_back({test.file, fmt::format("{}", test.points),
                          rms_text(test.rms_loading, test.largest_stress, units),
                          rms_text(test.rms_unloading, test.largest_stress, units), loops_text(test),
                          test.is_held_out ? "held out: predicted" : ""});
  return table;
}

Table table_of_figures(const fit::FitReport& report, const UnitSystem& units) {
  Table table{
      .columns = {"impact", "figure", "measured", "deviation", "model", "95 % (model)", "difference", ""}};
  for (const fit::MetFigure& figure : report.figures) {
    const fit::ImpactFigureName& name = name_of(figure.figure);
    const auto shown = [&](double value, int digits) {
      return brief_quantity(value, name.quantity->si_unit, units, digits);
    };
    table.rows.push_back(
        {figure.file, name.quantity->title, shown(figure.measured, 4), shown(figure.deviation, 2),
         figure.computed ? shown(*figure.computed, 4) : "none",
         figure.prediction_deviation ? "± " + shown(width_of_95 * *figure.prediction_deviation, 2) : "",
         figure.computed
             ? fmt::format("{:+.1f} deviations", (*figure.computed - figure.measured) / figure.deviation)
             : "",
         figure.is_held_out ? "held out: predicted" : ""});
  }
  return table;
}

Table table_of_comparison(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"impact", "figure", "measured", "model", "difference", ""}};
  for (const fit::ImpactComparison& comparison : report.comparison) {
    const fit::ImpactFigureName& name = name_of(comparison.figure);
    const auto shown = [&](double value) { return brief_quantity(value, name.quantity->si_unit, units, 4); };
    table.rows.push_back({comparison.file, name.quantity->title, shown(comparison.measured),
                          comparison.computed ? shown(*comparison.computed) : "none",
                          comparison.computed ? fmt::format("{:+.1f} %", 100 * *comparison.share()) : "",
                          comparison.is_held_out ? "held out: predicted" : "fitted"});
  }
  return table;
}

Table table_of_loops(const fit::FitReport& report) {
  Table table{.columns = {"test", "reverses at", "measured", "model"}};
  for (const fit::MetTest& test : report.tests)
    for (const fit::Loop& loop : test.loops)
      table.rows.push_back(
          {test.file + (test.is_held_out ? ", predicted" : ""), fmt::format("{:.3g}", loop.largest_strain),
           fmt::format("{:.3f}", loop.measured_return), fmt::format("{:.3f}", loop.computed_return)});
  return table;
}

Table table_of_pulses(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"impact", "pulse", "points", "peak, measured and model", "model minus pulse, rms",
                          "shift", ""}};
  for (const fit::MetPulse& pulse : report.pulses) {
    const auto shown = [&](double value, int digits) { return brief_quantity(value, "m/s2", units, digits); };
    table.rows.push_back(
        {pulse.file, pulse.pulse_file,
         pulse.time.size() < pulse.samples ? fmt::format("{} of {}", pulse.time.size(), pulse.samples)
                                           : fmt::format("{}", pulse.time.size()),
         fmt::format("{}, {}", shown(pulse.measured_peak, 4),
                     pulse.computed_peak ? shown(*pulse.computed_peak, 4) : "none"),
         pulse.rms ? fmt::format("{}, {:.2g} %", shown(*pulse.rms, 3), 100 * *pulse.rms / pulse.measured_peak)
                   : "none",
         pulse.shift ? brief_quantity(*pulse.shift, "s", units, 2) : "aligned at the onset",
         pulse.is_held_out ? "held out: predicted" : ""});
  }
  return table;
}

}  // namespace dashpad::output
