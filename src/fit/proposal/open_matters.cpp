// What tests leave open, and what would be worth measuring next.

#include "fit/proposal/open_matters.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit/proposal/candidates.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

namespace {

constexpr double of_impacts = 10;     ///< 1/s: an impact at 1 m/s on 100 mm
constexpr double full_strain = 0.75;  ///< up to which a test should go
constexpr std::size_t fewest_samples = 3;
constexpr double poor = 0.03;  ///< misfit, share of the largest stress

std::string words_on_misfit(double misfit) {
  return fmt::format(
      "it misses the tests by {} % of their largest stress. dashpad material import takes the measured "
      "loadings as they are, a curve for each rate.",
      brief(100 * misfit, 2));
}

}  // namespace

std::vector<std::string> doubts_of(const AutoFit& result) {
  std::vector<std::string> doubts;
  if (const auto misfit = result.tried[result.chosen].misfit; misfit && *misfit > poor)
    doubts.push_back("The law does not fit the tests well: " + words_on_misfit(*misfit));
  const std::vector<MaterialMeasurement>& tests = result.candidate().fit.tests;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    if (result.proposal.tests[i].has_cycles)
      doubts.push_back(tests[i].file + " was loaded several times; the one curve lies between the cycles.");
    for (const std::string& remark : tests[i].remarks)
      if (remark.find("subtract") != std::string::npos || remark.find("goes back at") != std::string::npos)
        doubts.push_back(tests[i].file + ": " + remark + ".");
    if (tests[i].is_base)
      doubts.push_back(
          fmt::format("The base curve is the loading in {} as measured: no interval contains its noise, or "
                      "that other samples differ.",
                      tests[i].file));
  }
  return doubts;
}

void say_what_is_open(AutoFit& result) {
  const std::vector<Evidence>& tests = result.proposal.tests;
  const double highest_strain = std::ranges::max(tests, {}, &Evidence::highest_strain).highest_strain;
  const double slowest = std::ranges::min(tests, {}, &Evidence::rate).rate;
  const double fastest = std::ranges::max(tests, {}, &Evidence::rate).rate;
  const bool has_rates = fastest >= one_rate * slowest;
  const PadLaw& law = result.candidate().fit.base.pad.material.law;
  const bool recovers = std::holds_alternative<Foam>(law);
  const Tried& how = result.tried[result.chosen];
  const auto returns_at = [&](double rate) {
    return std::ranges::any_of(tests,
                               [&](const Evidence& shown) { return shown.returned && shown.rate >= rate; });
  };
  std::vector<std::string>&open = result.open, &next = result.next;
  if (how.misfit && *how.misfit > poor) open.push_back("The law itself: " + words_on_misfit(*how.misfit));
  if (!recovers && std::holds_alternative<CrushableFoam>(law) &&
      std::ranges::none_of(tests, &Evidence::has_cycles)) {
    open.emplace_back("Whether it stays crushed or recovers before the next blow: no test loads it again.");
    next.emplace_back("A second loading after the first, at once and after a day.");
  }
  if (std::holds_alternative<ViscoelasticFoam>(law)) {
    if (!returns_at(0))
      open.emplace_back("Unloading: it follows from the relaxation; no measured unloading confirms it.");
  } else if (!returns_at(0)) {
    open.emplace_back(
        "Unloading: no test unloads the foam, so rebound and loss are unknown; until they are measured, "
        "intervals range from no loss to complete loss.");
  } else if (recovers && !returns_at(of_impacts)) {
    open.emplace_back(
        "Unloading at the rate of an impact: whether the stress added by the rate is lost or returned "
        "(recoil, 0 to 1). For vinyl nitrile at 10 1/s, up to a strain of 0.55, this means that 0.07 or 0.27 "
        "of the energy is returned.");
  }
  if (!returns_at(of_impacts))
    next.emplace_back(
        "A drop of a flat weight or a headform onto the pad at the speed of use, with the whole pulse or at "
        "least peak and rebound speed: it determines the loss, which no slow test does. Add it to the "
        "proposed fit as [[impacts]].");
  if (!has_rates && std::holds_alternative<ViscoelasticFoam>(law)) {
    open.emplace_back(
        "Relaxation within milliseconds, as in an impact, since it is faster than the loading of the tests, "
        "and relaxation that takes longer than the tests.");
  } else if (!has_rates) {
    open.push_back(fmt::format(
        "The rate: all tests are at about {} 1/s. An impact at 5 m/s strains a pad of 50 mm at 100 1/s; with "
        "exponents of 0.03 to 0.2, as in the cards of the foams, its stress is {} to {} times that of the "
        "test.",
        brief(fastest, 2), brief(std::pow(100 / fastest, 0.03), 2), brief(std::pow(100 / fastest, 0.2), 2)));
    next.emplace_back("Loading at a second rate, a hundred times the first or more, to the same strain.");
  } else if (fastest < of_impacts) {
    open.emplace_back(
        fmt::format("Rates above {} 1/s: an impact at 5 m/s strains a pad of 50 mm at 100 1/s, to which the "
                    "power of the rate is extrapolated.",
                    brief(fastest, 2)));
    next.emplace_back("Loading at 10 1/s or more, or a drop.");
  }
  open.push_back(
      fmt::format("Strains above {}, the highest tested: beyond it the stress is a guess, and every pad that "
                  "comes near bottoming depends on it.",
                  brief(highest_strain, 3)));
  if (highest_strain < full_strain)
    next.emplace_back(
        fmt::format("A test to a strain of 0.8 or more; these end at {}.", brief(highest_strain, 3)));
  if (std::ranges::max(sizes_by_rate(tests)) < fewest_samples) {
    open.emplace_back(
        "The scatter among samples: there are not three tests at any rate, so no interval contains it.");
    next.emplace_back("The slow test on three samples of different lots; give their scatter to the card.");
  }
  if (std::ranges::any_of(tests, &Evidence::has_cycles))
    open.emplace_back(
        "Softening by earlier loading: the law has one curve for all cycles. Fresh and conditioned foam need "
        "two cards; cut the files after the first cycle, or before the last.");
  open.emplace_back("Temperatures other than that of the tests.");
  next.emplace_back(
      "If the pad is used in cold or heat: the slow test at that temperature (material import "
      "--temperature).");
}

}  // namespace dashpad::fit
