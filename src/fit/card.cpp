#include "fit/card.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/study/application.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

namespace {

std::string rms_words(const MetTest& test) {
  const auto share = [&](const std::optional<double>& rms) { return 100 * *rms / test.largest_stress; };
  std::string words;
  if (test.rms_loading) words += fmt::format("{:.2g} % on loading", share(test.rms_loading));
  if (test.rms_unloading)
    words += fmt::format("{}{:.2g} % on unloading", words.empty() ? "" : ", ", share(test.rms_unloading));
  return words;
}

/// "3 figures; pulse drop.csv, rms 2.1 % of its peak".
std::string impact_words(const ImpactMeasurement& impact, const FitReport& report) {
  std::string words;
  if (!impact.figures.empty())
    words = fmt::format("{} figure{}", impact.figures.size(), impact.figures.size() == 1 ? "" : "s");
  if (!impact.pulse) return words;
  words += fmt::format("{}pulse {}", words.empty() ? "" : "; ", impact.pulse->file);
  for (const MetPulse& met : report.pulses)
    if (met.file == impact.file && met.pulse_file == impact.pulse->file && met.rms) {
      words += fmt::format(", rms {:.2g} % of its peak", 100 * *met.rms / met.measured_peak);
      break;
    }
  return words;
}

std::string origin_of(const Fit& fit, const FitReport& report) {
  std::string origin = "dashpad fit to ";
  std::string separator;
  for (const MetTest& test : report.tests) {
    if (test.is_held_out) continue;
    origin += fmt::format("{}{} ({} points; rms {} of the largest stress)", separator, test.file, test.points,
                          rms_words(test));
    separator = "; ";
  }
  for (const ImpactMeasurement& impact : fit.impacts) {
    if (impact.is_held_out) continue;
    origin += fmt::format("{}{} ({})", separator, impact.file, impact_words(impact, report));
    separator = "; ";
  }
  return origin + fmt::format("; misfit {:.3g} per degree of freedom{}", report.misfit_per_degree(),
                              report.noise_is_stated ? "" : ", by construction: the noise was not stated");
}

std::vector<std::string> reservations_of(const Fit& fit, const FitReport& report) {
  std::vector<std::string> all;
  for (const FittedUnknown& unknown : report.unknowns)
    if (!unknown.is_identified() && !unknown.is_nuisance)
      all.push_back(fmt::format("The data do not determine {}: its 95 % interval is open {}.", unknown.key,
                                unknown.open()));
  for (const FittedUnknown& unknown : report.unknowns)
    if (!study::is_of_law(unknown.key) && !unknown.is_nuisance)
      all.push_back(fmt::format("Found together with {} = {:.4g}{}, which a card does not hold.", unknown.key,
                                unknown.value, unknown.unit == "1" ? "" : " " + unknown.unit));
  const bool unloads = std::ranges::any_of(
      report.tests, [](const MetTest& test) { return !test.is_held_out && test.rms_unloading.has_value(); });
  const bool strikes = std::ranges::any_of(fit.impacts, [](const auto& of) { return !of.is_held_out; });
  if (!unloads && !strikes) all.emplace_back("Fitted to loading only: the way back is assumed.");
  for (const MetTest& test : report.tests)
    if (test.offset)
      all.push_back(fmt::format("The force zero of {} was taken to be off by {:.3g} kPa.", test.file,
                                *test.offset / 1000));
  return all;
}

/// Strains and rates of the fitted tests and impacts; one rate counts for half a decade on either side.
FittedRange range_of_data(const Fit& fit, const Material& material) {
  double strain = 0;
  double lowest = 1e300;
  double highest = 0;
  for (const MaterialMeasurement& test : fit.tests) {
    if (test.is_held_out) continue;
    for (std::size_t i = 0; i < test.strain.size(); ++i)
      if (counts(test, i)) strain = std::max(strain, test.strain[i]);
    double way = 0, time = 0;
    for (std::size_t i = 1; i < test.strain.size(); ++i) {
      way += std::abs(test.strain[i] - test.strain[i - 1]);
      time += test.strain[i] == test.strain[i - 1] ? 0 : test.time[i] - test.time[i - 1];
    }
    lowest = std::min(lowest, way / time);
    highest = std::max(highest, way / time);
  }
  for (const ImpactMeasurement& impact : fit.impacts) {
    if (impact.is_held_out) continue;
    ImpactCase with_material = impact.impact;
    with_material.pad.material = material;
    const Summary summary = solve(with_material, impact.options).summary;
    strain = std::max(strain, std::min(summary.peak_strain, 1.0));
    lowest = std::min(lowest, summary.peak_strain_rate);
    highest = std::max(highest, summary.peak_strain_rate);
  }
  if (highest < 2 * lowest) {
    lowest /= std::sqrt(10.0);
    highest *= std::sqrt(10.0);
  }
  return {strain, lowest, highest};
}

}  // namespace

Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report) {
  Material material = material_with(fit, values);
  material.name = "fitted";
  material.title = fit.title.empty() ? "Fitted foam" : fit.title;
  material.source = origin_of(fit, report);
  material.basis = "test";
  material.reservations = reservations_of(fit, report);
  material.fitted = range_of_data(fit, material);
  return material;
}

}  // namespace dashpad::fit
