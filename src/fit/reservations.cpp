// Reservations about a fitted foam, and the recoil that nobody stated.

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "dashpad/result/result_quantity.hpp"
#include "dashpad/study/study.hpp"
#include "fit/card.hpp"
#include "fit/problem.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

using input::TomlNode;

namespace {

constexpr const char* key_of_recoil = "pad.parameters.recoil";
/// A test at more than this many times the rate of the base curve has stress that the rate added.
constexpr double clearly_faster = 2;
/// The share of the largest strain by which a test must come back to count as unloaded.
constexpr double min_way_back = 0.1;

const TomlNode* in(const TomlNode* table, const char* key) { return table ? table->child(key) : nullptr; }

const FoamCurves* curves_with_rate(const Fit& fit) {
  const auto* const foam = std::get_if<Foam>(&fit.base.pad.material.law);
  return foam && !std::holds_alternative<NoRateEffect>(foam->curves.rate_effect) ? &foam->curves : nullptr;
}

bool shows_recoil(const ImpactMeasurement& impact) {
  return !impact.is_held_out &&
         (impact.pulse || std::ranges::any_of(impact.figures, [](const MeasuredFigure& figure) {
            return figure.figure == ImpactFigure::rebound_speed ||
                   figure.figure == ImpactFigure::contact_time ||
                   figure.figure == ImpactFigure::velocity_change;
          }));
}

bool shows_recoil(const MaterialMeasurement& test, double slowest_rate) {
  if (test.is_held_out || rates_of(test).highest <= clearly_faster * slowest_rate) return false;
  const auto largest = std::ranges::max_element(test.strain);
  return *std::min_element(largest, test.strain.end()) < (1 - min_way_back) * *largest;
}

using Sentences = std::vector<std::string>;

std::string value_words(const FittedUnknown& unknown, double value) {
  return brief_quantity(value, unknown.unit, plain_si(), 4);
}

void add_open_unknowns(const FitReport& report, Sentences& all) {
  for (const FittedUnknown& unknown : report.unknowns) {
    if (unknown.is_nuisance) continue;
    if (unknown.wants_beyond())
      all.push_back(fmt::format("{} lies at its {} bound, {}: the data favour a value beyond it.",
                                unknown.key, unknown.is_at_lowest ? "lower" : "upper",
                                value_words(unknown, unknown.value)));
    else if (!unknown.is_identified())
      all.push_back(fmt::format("The data do not determine {}: its 95 % interval is unbounded {}.",
                                unknown.key, unknown.open() == "both" ? "on both sides" : unknown.open()));
  }
}

/// The search and the misfit.
void add_doubts(const FitReport& report, Sentences& all) {
  if (report.starts > 1 && report.starts_at_best == 1)
    all.push_back(
        fmt::format("Only 1 of {} starts of the search converged to this fit: there may be a better one.",
                    report.starts));
  if (report.starts_at_best == 0)
    all.emplace_back(
        "No start of the search converged to this fit, which was found along a profile: there may be a "
        "better one.");
  // For sound data, chi-squared scatters by the root of twice its degrees of freedom.
  const double most = 1 + 3 * std::sqrt(2 / std::max(report.degrees_of_freedom, 1.0));
  if (report.noise_is_stated && report.misfit_per_degree() > most)
    all.push_back(
        fmt::format("Chi-squared is {:.3g} per degree of freedom: the model deviates from the data by more "
                    "than their noise.",
                    report.misfit_per_degree()));
}

constexpr double worth_saying = 0.05;  ///< share of the measured figure

/// The largest miss of each figure of the impacts.
void add_misses(const FitReport& report, Sentences& all) {
  for (const ImpactFigureName& name : impact_figure_names()) {
    const ImpactComparison* worst = nullptr;
    for (const ImpactComparison& comparison : report.comparison)
      if (comparison.figure == name.figure && comparison.share() &&
          (!worst || std::abs(*comparison.share()) > std::abs(*worst->share())))
        worst = &comparison;
    if (worst && std::abs(*worst->share()) > worth_saying)
      all.push_back(fmt::format("For {}, the modelled {} is {} % {} the measured one.", worst->file,
                                title_in_sentence(*name.quantity), brief(100 * std::abs(*worst->share()), 2),
                                *worst->share() < 0 ? "below" : "above"));
  }
}

/// Pulses of other impacts than the cases beside them.
void add_speeds(const Fit& fit, std::span<const double> values, Sentences& all) {
  for (const ImpactMeasurement& impact : fit.impacts) {
    if (!impact.pulse) continue;
    const Impactor impactor = impact_with(fit, impact, values).impactor;
    if (impact.pulse->impact && injury::unlike_speeds(*impact.pulse->impact, {.speed = impactor.speed}))
      all.push_back(fmt::format(
          "{} has an impact speed of {} m/s, but the impact recorded in {} was at {} m/s.", impact.file,
          brief(impactor.speed, 4), impact.pulse->file, brief(impact.pulse->impact->speed, 4)));
    const double change = impact.pulse->velocity_change - impactor.gravity * impact.pulse->time.back();
    if (change < (1 - worth_saying) * impactor.speed || change > (1 + worth_saying) * 2 * impactor.speed)
      all.push_back(fmt::format(
          "The pulse {} has a velocity change of {} m/s, which is impossible for an impact at {} m/s, the "
          "speed in {}: the drop height differs, the scale is wrong, or the sensor has an offset.",
          impact.pulse->file, brief(change, 4), brief(impactor.speed, 4), impact.file));
  }
}

/// Values beside those of the card with which the impacts were met.
void add_company(const Fit& fit, const FitReport& report, Sentences& all) {
  bool is_scaled = false;
  for (const FittedUnknown& unknown : report.unknowns) {
    if (unknown.is_nuisance) continue;
    is_scaled = is_scaled || unknown.key == "pad.scale";
    if (!is_of_card(unknown.key))
      all.push_back(fmt::format("Fitted together with {} = {}, which is not part of the card.", unknown.key,
                                value_words(unknown, unknown.value)));
  }
  if (is_scaled && has_fitted(fit.tests))
    all.emplace_back(
        "All stresses include the scale found from the impacts; the tests were fitted without it.");
  for (const MetTest& test : report.tests)
    if (test.offset)
      all.push_back(fmt::format("An offset of {:.3g} kPa was fitted to the stress in {}.",
                                *test.offset / 1000, test.file));
}

/// The source of the tested range if no compression test gives it.
void add_range(const Fit& fit, std::span<const double> values, Sentences& all) {
  const bool has_tests = has_fitted(fit.tests);
  const Material& base = fit.base.pad.material;
  if (!has_tests && !is_stated(base)) {
    all.emplace_back(
        has_curves(base.law)
            ? "The data include no compression test: the foam is treated as tested up to the end of the "
              "curve in the fit file."
            : "The data include no compression test: the strain up to which the law is valid is unknown.");
    return;
  }
  double tested = 0, reached = 0;
  for (const MaterialMeasurement& test : fit.tests)
    if (!test.is_held_out) tested = std::max(tested, rates_of(test).highest);
  if (const auto own = range_of(base); own && !has_tests) tested = own->highest_rate;
  std::string file;
  for (const ImpactMeasurement& impact : fitted(fit.impacts)) {
    const double rate = rate_of(fit, impact, values);
    if (rate > reached) file = impact.file;
    reached = std::max(reached, rate);
  }
  if (reached > tested)
    all.push_back(fmt::format(
        "For strain rates from {:.3g} to {:.3g} per second, the only data are impacts, such as {}.", tested,
        reached, file));
}

}  // namespace

bool states_recoil(const TomlNode& fit_file, const std::vector<input::InputFile>& files) {
  if (in(in(fit_file.child("pad"), "parameters"), "recoil")) return true;
  return std::ranges::any_of(files, [](const input::InputFile& file) {
    if (file.file.extension() != ".toml") return false;
    const input::Reading<input::TomlFile> toml = input::read_toml(file.file);
    if (!toml) return false;
    const TomlNode* const pad = file.kind == "the material card" ? &toml->root : toml->root.child("pad");
    return in(in(pad, "parameters"), "recoil") && !in(toml->root.child("uncertainty"), "recoil");
  });
}

bool shows_way_back(const Fit& fit, const FitReport& report) {
  return has_fitted(fit.impacts) || std::ranges::any_of(report.tests, [](const MetTest& test) {
           return !test.is_held_out && test.rms_unloading.has_value();
         });
}

bool assumes_recoil(const Fit& fit) {
  return !fit.recoil_is_stated && curves_with_rate(fit) && !seeks(fit, key_of_recoil);
}

void seek_recoil(Fit& fit) {
  if (!assumes_recoil(fit) || !violations(fit).empty()) return;
  const double slowest_rate = curves_with_rate(fit)->slowest_rate;
  const bool is_shown =
      std::ranges::any_of(fit.impacts, [](const auto& given) { return shows_recoil(given); }) ||
      std::ranges::any_of(fit.tests, [&](const auto& given) { return shows_recoil(given, slowest_rate); });
  if (!is_shown) return;
  fit.unknowns.push_back({.key = key_of_recoil, .unit = "1", .lowest = 0, .highest = 1, .start = 0.5});
  fit.unknowns.back().is_added = true;
  if (!violations(fit).empty()) fit.unknowns.pop_back();
}

Sentences reservations_of(const Fit& fit, std::span<const double> values, const FitReport& report) {
  Sentences all;
  add_open_unknowns(report, all);
  add_doubts(report, all);
  add_speeds(fit, values, all);
  add_misses(report, all);
  add_company(fit, report, all);
  if (!shows_way_back(fit, report)) all.emplace_back("Fitted to loading only: the unloading is assumed.");
  if (assumes_recoil(fit))
    all.emplace_back(
        "The fraction of the rate-dependent stress that resists recovery (recoil) was not tested: 1, the "
        "largest loss, is assumed; values from 0 to 1 are possible.");
  add_range(fit, values, all);
  for (const std::string& old : fit.base.pad.material.reservations) {
    const auto is_about = [&](const Unknown& unknown) { return old.find(unknown.key) != std::string::npos; };
    if (std::ranges::none_of(fit.unknowns, is_about) && std::ranges::count(all, old) == 0) all.push_back(old);
  }
  return all;
}

}  // namespace dashpad::fit
