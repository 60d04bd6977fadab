#include "output/text/fit_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

void grow(std::optional<double>& most, double value) { most = std::max(most.value_or(0), value); }

std::string words_of(const Misses& misses) {
  std::vector<std::string> parts;
  if (misses.tests)
    parts.push_back(
        fmt::format("the tests by {:.2g} % of their largest stress (root mean square)", 100 * *misses.tests));
  if (misses.figures)
    parts.push_back(fmt::format("the figures by at most {:.2g} times the stated deviation", *misses.figures));
  if (misses.pulses)
    parts.push_back(
        fmt::format("the pulses by {:.2g} % of their peak (root mean square)", 100 * *misses.pulses));
  return listed(parts);
}

/// Counts of the unknowns of the material.
struct Determined {
  std::size_t all = 0, by_data = 0, by_prior = 0, open = 0;
};

Determined determined(const fit::FitReport& report) {
  Determined count;
  for (const fit::FittedUnknown& unknown : report.unknowns) {
    if (unknown.is_nuisance) continue;
    ++count.all;
    ++(!unknown.is_identified() ? count.open : unknown.rests_on_prior() ? count.by_prior : count.by_data);
  }
  return count;
}

/// ", leave 1 to its prior and do not determine 1"
std::string beside_data(const Determined& determined) {
  std::string text;
  if (determined.by_prior > 0)
    text += fmt::format("{} leave {} to {}", determined.open > 0 ? "," : " and", determined.by_prior,
                        determined.by_prior == 1 ? "its prior" : "their priors");
  if (determined.open > 0) text += fmt::format(" and do not determine {}", determined.open);
  return text;
}

}  // namespace

Misses misses(const fit::FitReport& report, bool held_out) {
  Misses most;
  for (const fit::MetTest& test : report.tests)
    if (test.is_held_out == held_out)
      for (const auto& rms : {test.rms_loading, test.rms_unloading})
        if (rms) grow(most.tests, *rms / test.largest_stress);
  for (const fit::MetFigure& figure : report.figures)
    if (figure.is_held_out == held_out && figure.computed)
      grow(most.figures, std::abs(*figure.computed - figure.measured) / figure.deviation);
  for (const fit::MetPulse& pulse : report.pulses)
    if (pulse.is_held_out == held_out && pulse.rms) grow(most.pulses, *pulse.rms / pulse.measured_peak);
  return most;
}

std::string fit_headline(const fit::FitReport& report) {
  const Determined of = determined(report);
  std::string text = of.by_data == of.all
                         ? of.all == 1 ? "The data determine the unknown"
                                       : fmt::format("The data determine all {} unknowns", of.all)
                         : fmt::format("The data determine {} of {}{}", of.by_data, plural(of.all, "unknown"),
                                       beside_data(of));
  const std::string missed = words_of(misses(report, false));
  return text + (missed.empty() ? "." : "; the model deviates from " + missed + ".");
}

std::string prediction_words(const fit::FitReport& report) {
  const std::string missed = words_of(misses(report, true));
  return missed.empty() ? "" : "Predicted, not fitted: the model deviates from " + missed + ".";
}

std::string fit_answer(const fit::FitReport& report) {
  const auto fitted_in = [](const auto& all) {
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [](const auto& one) { return !one.is_held_out; }));
  };
  const std::size_t tests = fitted_in(report.tests), figures = fitted_in(report.figures),
                    pulses = fitted_in(report.pulses);
  std::size_t points_of_pulses = 0;
  for (const fit::MetPulse& pulse : fit::fitted(report.pulses)) points_of_pulses += pulse.time.size();
  const Determined of = determined(report);
  std::vector<std::string> data;
  if (tests > 0)
    data.push_back(plural(report.points - figures - points_of_pulses, "point") + " in " +
                   plural(tests, "test"));
  if (figures > 0) data.push_back(plural(figures, "impact figure"));
  if (pulses > 0) data.push_back(plural(points_of_pulses, "point") + " in " + plural(pulses, "impact pulse"));
  if (report.priors > 0) data.push_back(plural(report.priors, "prior"));
  std::string text = plural(of.all, "unknown") + " from " + listed(data);
  text += of.by_data == of.all ? ": the data determine all of them. "
                               : fmt::format(": the data determine {}{}. ", of.by_data, beside_data(of));
  if (report.starts_at_best == 0)
    return text + "The best fit was found along a profile, not from any of the starts.";
  return text + fmt::format("{} of {} starts converged to the same misfit{}.", report.starts_at_best,
                            report.starts,
                            report.starts_failed > 0
                                ? fmt::format("; {} failed (invalid or not converged)", report.starts_failed)
                                : "");
}

std::string words_on_added(const fit::FitReport& report) {
  if (std::ranges::none_of(report.unknowns, &fit::FittedUnknown::is_added)) return "";
  return "The fraction of the rate-dependent stress that resists the recovery was not stated, so "
         "pad.parameters.recoil is fitted too, from 0 to 1. State it if it is known.";
}

std::string interval_words(const fit::FittedUnknown& unknown, const UnitSystem& units) {
  const auto shown = [&](double value) { return brief_quantity(value, unknown.unit, units, 4); };
  if (unknown.is_identified())
    return shown(unknown.low.value_or(unknown.lowest)) + " to " +
           shown(unknown.high.value_or(unknown.highest));
  if (unknown.low) return "from " + shown(*unknown.low) + ", with no upper bound";
  if (unknown.high) return "up to " + shown(*unknown.high) + ", with no lower bound";
  return "unbounded on both sides";
}

std::string duration_words(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 2 * minute) return brief(seconds, 2) + " s";
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  return fmt::format("{:.1f} h", seconds / hour);
}

std::vector<std::string> open_matters(const fit::FitReport& report) {
  std::vector<std::string> all;
  for (const std::vector<std::string>& keys : report.flat_directions)
    all.push_back(listed(keys) + (keys.size() == 1 ? " is not determined by these data."
                                                   : " cannot be distinguished by these data."));
  for (const fit::StrongCorrelation& correlation : report.correlations)
    all.push_back(fmt::format("The errors in {} and {} are strongly correlated ({:.3f}).", correlation.first,
                              correlation.second, correlation.value));
  for (const std::string& end : report.rough_ends)
    all.push_back("This end of an interval is approximate, because the limit on refits was reached: " + end +
                  ".");
  return all;
}

std::vector<std::string> notes_on_noise(const fit::FitReport& report) {
  std::vector<std::string> all;
  if (!report.noise_is_stated)
    all.emplace_back(
        "Noise: not stated for all data; missing values are estimated from the residuals of the fit, as the "
        "same fraction of the largest stress for every test.");
  else if (report.degrees_of_freedom <= 0)
    all.emplace_back(
        "Noise: there are as many unknowns as data, so the misfit says nothing about the model.");
  else if (report.variance_scale > 1)
    all.push_back(
        fmt::format("Noise: chi-squared is {:.3g} per degree of freedom with the stated noise, so the model "
                    "deviates from the data by more than the noise; errors are multiplied by {:.3g}.",
                    report.misfit_per_degree(), std::sqrt(report.variance_scale)));
  else
    all.push_back(fmt::format("Noise: chi-squared is {:.3g} per degree of freedom with the stated noise.",
                              report.misfit_per_degree()));
  const auto add = [&](const auto& given, const std::string& file, std::size_t points) {
    if (given.is_held_out || !(given.effective_points < static_cast<double>(points))) return;
    all.push_back(fmt::format(
        "{}: adjacent residuals have a correlation of {:.2f}, so {} points are equivalent to {:.0f}; "
        "errors and intervals are widened accordingly.",
        file, given.autocorrelation, points, given.effective_points));
  };
  for (const fit::MetTest& test : report.tests) add(test, test.file, test.points);
  for (const fit::MetPulse& pulse : report.pulses) add(pulse, pulse.pulse_file, pulse.time.size());
  return all;
}

}  // namespace dashpad::output
