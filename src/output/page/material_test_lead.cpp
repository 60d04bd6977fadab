#include "output/page/material_test_lead.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "output/page/key_figures.hpp"
#include "output/plot/material_test.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::CushionPoint;
using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;

const MaterialTestRun& headline_run(const MaterialTestReport& report) {
  return *std::ranges::max_element(report.runs, {},
                                   [](const MaterialTestRun& run) { return run.rate.value_or(0); });
}

/// Values of a run as people read them, with three digits, large ones too.
struct Shown {
  const UnitSystem& units;

  [[nodiscard]] std::string stress(double value) const {
    return number(value_in(units, value, "Pa")) + " " + shown_unit(unit_for(units, "Pa"));
  }
  [[nodiscard]] std::string energy(double value) const {
    return number(value_in(units, value, "Pa")) + " " + energy_density_unit(units);
  }
  [[nodiscard]] static std::string number(double value) { return brief(rounded_to(value, 3)); }
  [[nodiscard]] static std::string strain(double value) { return brief(value, 3); }
  [[nodiscard]] static std::string share(double value) { return number(100 * value) + " %"; }
};

/// Whether the efficiency has a maximum on the way, rather than at the end of the first loading: only then
/// does the foam run out.
bool runs_out(const MaterialTestRun& run) {
  constexpr double end_of_loading = 0.999;
  return !run.cushion.strain.empty() &&
         run.figures.best_efficiency.strain < end_of_loading * run.cushion.strain.back();
}

/// The first limit.
std::string answer_to_limit(const MaterialTestReport& report, const MaterialTestRun& run,
                            const Shown& shown) {
  const std::string limit = shown.stress(report.test.stress_limits.front());
  if (const std::optional<CushionPoint>& at = run.at_limits.front())
    return fmt::format("Takes {} before its stress reaches {}", shown.energy(at->energy), limit);
  return fmt::format("Takes {} and does not reach {}", shown.energy(run.figures.energy_in), limit);
}

std::string answer_without_rate(const MaterialTestReport& report, const MaterialTestRun& run,
                                const Shown& shown) {
  const std::string hold = brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed && run.relaxed->at_end_of_ramp > 0)
    return fmt::format("Keeps {} of its stress for {} at a strain of {}",
                       Shown::share(run.relaxed->after_hold / run.relaxed->at_end_of_ramp), hold,
                       Shown::strain(report.test.strain));
  if (run.crept)
    return fmt::format("Creeps from a strain of {} to {} in {} under {}",
                       Shown::strain(run.crept->at_end_of_loading), Shown::strain(run.crept->after_hold),
                       hold, shown.stress(report.test.stress));
  if (!run.at_limits.empty()) return answer_to_limit(report, run, shown);
  const CushionPoint& best = run.figures.best_efficiency;
  if (runs_out(run))
    return fmt::format("Best used at {}: it has then taken {}", shown.stress(best.stress),
                       shown.energy(best.energy));
  return fmt::format("Takes {} up to a strain of {}, and has not run out there", shown.energy(best.energy),
                     Shown::strain(best.strain));
}

std::string answer_of(const MaterialTestReport& report, const MaterialTestRun& run, const Shown& shown) {
  return answer_without_rate(report, run, shown) + (run.rate ? fmt::format(" (at {})", rate_words(run)) : "");
}

void add_hold(std::vector<KeyFigure>& figures, const MaterialTestReport& report, const MaterialTestRun& run,
              const Shown& shown) {
  const std::string hold = "after " + brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed) {
    figures.push_back(
        {.label = "Stress at the end of the ramp", .value = shown.stress(run.relaxed->at_end_of_ramp)});
    figures.push_back(
        {.label = "Stress held", .value = shown.stress(run.relaxed->after_hold), .limit = hold});
  }
  if (run.crept) {
    figures.push_back(
        {.label = "Strain at the end of loading", .value = Shown::strain(run.crept->at_end_of_loading)});
    figures.push_back({.label = "Strain held", .value = Shown::strain(run.crept->after_hold), .limit = hold});
  }
}

void add_limits(std::vector<KeyFigure>& figures, const MaterialTestReport& report, const MaterialTestRun& run,
                const Shown& shown) {
  constexpr std::size_t most_limits = 2;
  for (std::size_t i = 0; i < run.at_limits.size() && i < most_limits; ++i) {
    const std::optional<CushionPoint>& at = run.at_limits[i];
    figures.push_back({.label = "Energy below " + shown.stress(report.test.stress_limits[i]),
                       .value = shown.energy(at ? at->energy : run.figures.energy_in),
                       .limit = at ? "at a strain of " + Shown::strain(at->strain) : "which is not reached"});
  }
}

KeyFigure strain_reached(const MaterialTestReport& report, const MaterialTestRun& run) {
  KeyFigure figure{.label = "Strain reached", .value = Shown::strain(run.column.largest_strain)};
  if (const auto range = range_of(report.material)) {
    figure.limit = fmt::format("{} up to {}", has_curves(report.material.law) ? "tested" : "fitted",
                               Shown::strain(range->highest_strain));
    figure.share = run.column.largest_strain / range->highest_strain;
    // A strain of 0.95 that was computed is not beyond 0.95.
    if (*figure.share > 1 + 1e-9) figure.tone = Tone::doubtful;
  }
  return figure;
}

std::vector<KeyFigure> test_figures(const MaterialTestReport& report, const MaterialTestRun& run,
                                    const Shown& shown) {
  const laboratory::CushionFigures& of = run.figures;
  std::vector<KeyFigure> figures;
  add_hold(figures, report, run, shown);
  add_limits(figures, report, run, shown);
  if (runs_out(run)) {
    figures.push_back({.label = "Best used at",
                       .value = shown.stress(of.best_efficiency.stress),
                       .limit = "the highest energy for its stress"});
    figures.push_back({.label = "Energy taken by then",
                       .value = shown.energy(of.best_efficiency.energy),
                       .limit = "efficiency " + brief(of.best_efficiency.efficiency, 3)});
    figures.push_back({.label = "Runs out at a strain of",
                       .value = Shown::strain(of.best_efficiency.strain),
                       .limit = "beyond, stress grows faster than energy"});
  } else
    figures.push_back({.label = "Energy taken",
                       .value = shown.energy(of.best_efficiency.energy),
                       .limit = "efficiency " + brief(of.best_efficiency.efficiency, 3)});
  if (run.unloads)
    figures.push_back(
        {.label = "Given back",
         .value = of.energy_in > 0 ? Shown::share(of.energy_returned / of.energy_in) : "none",
         .limit = fmt::format("{} of {}", shown.energy(of.energy_returned), shown.energy(of.energy_in))});
  figures.push_back(strain_reached(report, run));
  figures.push_back({.label = "Largest stress",
                     .value = shown.stress(of.peak_stress),
                     .limit = "at a strain of " + Shown::strain(of.strain_at_peak)});
  figures.resize(std::min(figures.size(), most_key_figures));
  return figures;
}

/// Stress over strain, not so high that what is pressed flat hides the rest, with the place that the answer
/// speaks of and where the foam was tested.
Panel stress_panel(const MaterialTestReport& report, const MaterialTestRun& run, const UnitSystem& units) {
  constexpr double most_over_best = 4;
  Panel panel = stress_over_strain(report, units);
  const CushionPoint& best = run.figures.best_efficiency;
  if (runs_out(run)) {
    panel.series.push_back({.label = "best used",
                            .style = SeriesStyle::points,
                            .x = {best.strain},
                            .y = {value_in(units, best.stress, "Pa")},
                            .turn = report.runs.size()});
    if (run.figures.peak_stress > most_over_best * best.stress) {
      panel.y.low = 0;
      panel.y.high = value_in(units, most_over_best * best.stress, "Pa");
    }
  }
  for (const double limit : report.test.stress_limits)
    panel.series.push_back({.label = "limit " + brief_quantity(limit, "Pa", units),
                            .style = SeriesStyle::horizontal_line,
                            .y = {value_in(units, limit, "Pa")}});
  if (const auto range = range_of(report.material); range && range->highest_strain < 1)
    panel.series.push_back(
        {.label = fmt::format("{} to {}", has_curves(report.material.law) ? "tested" : "fitted",
                              brief(range->highest_strain, 3)),
         .style = SeriesStyle::vertical_line,
         .x = {range->highest_strain}});
  return panel;
}

Panel deciding_panel(const MaterialTestReport& report, const MaterialTestRun& run, const UnitSystem& units) {
  Panel panel;
  if (run.relaxed)
    panel = stress_over_time(report, units);
  else if (run.crept)
    panel = strain_over_time(report, units);
  else
    panel = stress_panel(report, run, units);
  panel.title.clear();
  return panel;
}

}  // namespace

Lead material_test_lead(const MaterialTestReport& report, const UnitSystem& units) {
  const MaterialTestRun& run = headline_run(report);
  const Shown shown{units};
  Lead lead{.answer = answer_of(report, run, shown),
            .subject = {material_words(report.material), test_words(report.test, units)},
            .curve = Plot{.panels = {deciding_panel(report, run, units)}},
            .figures = test_figures(report, run, shown)};
  if (const std::vector<std::string> flags = flag_words(report); !flags.empty()) {
    lead.reservation = flags.front();
    const auto range = range_of(report.material);
    if (!run.flags.empty() && (!range || run.figures.best_efficiency.strain > range->highest_strain))
      lead.tone = Tone::doubtful;
  }
  return lead;
}

std::vector<std::string> material_test_basis(const MaterialTestReport& report, const UnitSystem& units) {
  const Material& material = report.material;
  std::string foam = material_words(material);
  if (material.density) foam += ", " + brief_quantity(*material.density, "kg/m3", units);
  foam += material.source.empty() ? ". Source not stated." : ". Source: " + one_line(material.source) + ".";
  std::vector<std::string> basis{std::move(foam)};
  if (const auto range = range_of(material))
    basis.push_back(fmt::format(
        "{} up to a strain of {}, at {} to {} per second.", has_curves(material.law) ? "Tested" : "Fitted",
        brief(range->highest_strain, 3), brief(range->lowest_rate, 3), brief(range->highest_rate, 3)));
  for (const std::string& reservation : material.reservations) basis.push_back(one_line(reservation));
  basis.push_back(test_words(report.test, units));
  for (std::string& note : notes_on(report)) basis.push_back(std::move(note));
  return basis;
}

}  // namespace dashpad::output
