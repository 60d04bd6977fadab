// From what was measured to laws, base curves, unknowns and where to start.

#include "fit/proposal/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "fit/card.hpp"
#include "fit/fit_tables.hpp"
#include "fit/proposal/base_curves.hpp"
#include "input/measurement/measurement_text.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

namespace {

constexpr double as_far = 0.02;           ///< strain by which the slowest test may fall short of another
constexpr std::size_t fewest_points = 8;  ///< of loading, for a formula
constexpr double stays_crushed = 0.1;     ///< share of the highest strain, without stress
constexpr double long_hold = 100;         ///< over the time of its loading: two branches

bool has_way_back(const Evidence& shown) { return shown.returned.has_value(); }
bool is_held(const Evidence& shown) { return shown.lost_held.has_value(); }

/// The test that was without stress before it was without strain; null without one.
const Evidence* crushed(const std::vector<Evidence>& tests) {
  const auto found = std::ranges::find_if(
      tests, [](const Evidence& shown) { return shown.strain_left > stays_crushed * shown.highest_strain; });
  return found == tests.end() ? nullptr : &*found;
}

std::string percent(double share) { return brief(100 * share, 2) + " %"; }

/// The choice between the measured curve and formulas.
struct BaseChoice {
  bool is_table = false;
  std::string reason;
};

BaseChoice base_for(const std::vector<Evidence>& tests, const Beginning& from) {
  const Evidence& slow = tests[from.slowest];
  const auto farther = std::ranges::find_if(
      tests, [&](const Evidence& shown) { return shown.highest_strain > slow.highest_strain + as_far; });
  const auto at_its_rate =
      std::ranges::count_if(tests, [&](const Evidence& shown) { return shown.rate < one_rate * slow.rate; });
  const bool is_alone = at_its_rate == 1;
  const bool is_more = sizes_by_rate(tests).size() > 1 || std::ranges::any_of(tests, has_way_back);
  if (is_more && is_alone && farther == tests.end())
    return {true,
            fmt::format("Base curve: a table, the loading in {} as measured up to a strain of {}. It is the "
                        "slowest test and no other goes further, so that no formula is needed.",
                        slow.file, brief(slow.highest_strain, 3))};
  const std::string why =
      !is_alone
          ? fmt::format("{} tests have about the rate of the slowest one, and a formula passes between them",
                        at_its_rate)
      : farther != tests.end()
          ? fmt::format(
                "{} goes to a strain of {}, beyond the slowest test's {}, and a formula extends the curve to "
                "it",
                farther->file, brief(farther->highest_strain, 3), brief(slow.highest_strain, 3))
          : std::string(
                "with one loading there is nothing else to fit, and a formula has few numbers, whose "
                "uncertainty goes into the card");
  return {false, "Base curve: a formula, since " + why + "; those below were tried."};
}

std::string words_on_law(const std::vector<Evidence>& tests) {
  const auto shown = std::ranges::find_if(tests, has_way_back);
  if (shown == tests.end()) return "Law: foam. No test includes unloading, so it is not fitted.";
  if (const Evidence* const stays = crushed(tests))
    return fmt::format(
        "Law: {} returned {} of its energy and was without stress from a strain of {} down. It may "
        "recover all the same or stay crushed, so foam (unknowns unloading_factor and "
        "unloading_shape) and crushable-foam (unknown unloading_modulus) were tried.",
        stays->file, percent(*stays->returned), brief(stays->strain_left, 3));
  return fmt::format(
      "Law: foam, since {} kept pressing during unloading and returned {} of its energy. Unknowns of the "
      "unloading: unloading_factor and unloading_shape.",
      shown->file, percent(*shown->returned));
}

/// Adds the unknowns of the rate; false if there is one rate only.
bool seek_rate(const std::vector<Evidence>& tests, bool with_slope, PadLaw& law) {
  if (sizes_by_rate(tests).size() < 2) return false;
  const double highest = std::ranges::max(tests, {}, &Evidence::rate).rate;
  constexpr double usual = 0.05;
  const PowerRateEffect power{
      .exponent = usual, .exponent_slope = with_slope ? -usual : 0, .highest_rate = highest};
  std::visit(
      [&]<class Law>(Law& found) {
        if constexpr (SharesSlip<Law>) found.curves.rate_effect = power;
      },
      law);
  return true;
}

/// The least unloading modulus that the rules of the law admit, Pa, to four digits and from above.
double min_modulus(CrushableFoam law) {
  const auto is_admitted = [&](double modulus) {
    law.unloading_modulus = modulus;
    return violations(PadLaw(law)).empty();
  };
  constexpr double largest = 1e12, narrow = 1 + 1e-4;
  double below = 1, above = largest;
  while (above > narrow * below) {
    const double middle = std::sqrt(below * above);
    (is_admitted(middle) ? above : below) = middle;
  }
  return above;
}

class Candidates {
 public:
  Candidates(ReadTests& tests, const Beginning& from, Proposal& into)
      : tests_(tests), from_(from), into_(into), crushed_(crushed(tests.evidence)) {}

  void add_foams(const std::vector<Base>& bases) {
    for (const bool crushable : {false, true})
      for (const Base& base : bases)
        for (const bool with_slope : {false, true})
          if ((crushed_ != nullptr || !crushable) &&
              (!with_slope || sizes_by_rate(tests_.evidence).size() > 1))
            add_foam(base, crushable, with_slope);
  }

  /// With two branches if the tests last a hundred times as long as their fastest loading.
  void add_viscoelastic(const std::string& if_others_miss) {
    double loading = infinite, longest = 0;  // s
    for (const Evidence& shown : tests_.evidence) {
      const double seconds = shown.highest_strain / shown.rate;
      loading = std::min(loading, seconds);
      longest = std::max({longest, seconds, shown.time_held});
    }
    const bool is_long = longest > 0.99 * long_hold * loading;
    const double e = from_.modulus;
    ViscoelasticFoam law{.first_modulus = e / 4,
                         .first_exponent = 8,
                         .second_modulus = e / 50,
                         .second_exponent = -1,
                         .first_share = 1,
                         .first_time = loading,
                         .second_share = is_long ? 0.5 : 0.0,
                         .second_time = is_long ? longest / 3 : 1};
    Fit fit = begin(law);
    const auto seek_one = [&](const char* key, double lowest, double highest, double start) {
      seek(fit, std::string("pad.parameters.") + key, lowest, highest, start);
    };
    seek_one("first_modulus", e / 1000, e * 5, law.first_modulus);
    seek_one("first_exponent", 1, 50, law.first_exponent);
    seek_one("second_modulus", e / 1e5, e, law.second_modulus);
    seek_one("second_exponent", -3, -0.1, law.second_exponent);
    seek_one("first_share", 0, 50, law.first_share);
    seek_one("first_time", loading / 50, is_long ? 10 * loading : 2 * longest, law.first_time);
    if (is_long) {
      seek_one("second_share", 0, 50, law.second_share);
      seek_one("second_time", 10 * loading, 5 * longest, law.second_time);
    }
    add("hyperfoam", "by relaxation", std::move(fit), if_others_miss);
  }

 private:
  [[nodiscard]] Fit begin(PadLaw law) const {
    Fit fit;
    fit.base = made_up_case();
    fit.base.pad.material.name = foam_of_the_case;
    fit.base.pad.material.law = std::move(law);
    fit.tests = tests_.measurements;
    fit.title = input::to_utf8(tests_.sources.front().file.stem().string());
    fit.recoil_is_stated = false;
    return fit;
  }

  void add_foam(const Base& base, bool crushable, bool with_slope) {
    const FoamCurves curves{
        .base = base.curve, .slowest_rate = tests_.evidence[from_.slowest].rate, .rate_effect = {}};
    Foam foam;
    foam.curves = curves;
    PadLaw law = foam;
    double modulus = 0;
    if (crushable) {
      CrushableFoam crushed_law;
      crushed_law.curves = curves;
      modulus = min_modulus(crushed_law);
      crushed_law.unloading_modulus = 2 * modulus;
      law = crushed_law;
    }
    const bool has_rate = seek_rate(tests_.evidence, with_slope, law);
    Fit fit = begin(std::move(law));
    if (std::holds_alternative<TableCurve>(base.curve)) fit.tests[from_.slowest].is_base = true;
    base.seek(fit, from_);
    if (crushable) {
      seek(fit, "pad.parameters.unloading_modulus", modulus, 1e3 * modulus, 2 * modulus);
    } else if (std::ranges::any_of(tests_.evidence, has_way_back)) {
      seek(fit, "pad.parameters.unloading_factor", 0, 1, 0.3);
      seek(fit, "pad.parameters.unloading_shape", 0.05, 20, 1);
    }
    if (has_rate) {
      seek(fit, "pad.rate.exponent", 0, 0.5, 0.05);
      if (with_slope) seek(fit, "pad.rate.exponent_slope", -2, 1, -0.05);
    }
    seek_recoil(fit);
    add(base.name, !has_rate ? "none" : with_slope ? "power with slope" : "power", std::move(fit));
  }

  void add(std::string base, std::string rate, Fit fit, std::string if_others_miss = "") {
    if (fit.unknowns.empty() || !violations(fit).empty()) return;
    std::string law = name_of(fit.base.pad.material.law);
    into_.candidates.push_back(
        {std::move(law), std::move(base), std::move(rate), std::move(fit), std::move(if_others_miss)});
  }

  ReadTests& tests_;
  const Beginning& from_;
  Proposal& into_;
  const Evidence* crushed_;
};

}  // namespace

std::vector<std::size_t> sizes_by_rate(const std::vector<Evidence>& tests) {
  std::vector<double> rates;
  for (const Evidence& shown : tests) rates.push_back(shown.rate);
  std::ranges::sort(rates);
  std::vector<std::size_t> sizes;
  double first = 0;
  for (const double rate : rates) {
    if (sizes.empty() || rate >= one_rate * first) {
      sizes.push_back(0);
      first = rate;
    }
    ++sizes.back();
  }
  return sizes;
}

Proposal proposal_for(ReadTests tests, std::vector<input::Fault>& faults) {
  Proposal proposal;
  std::vector<std::string> remarks;
  const std::optional<Beginning> from = beginning_of(tests, remarks, faults);
  if (!from) return proposal;
  Candidates candidates(tests, *from, proposal);
  std::vector<std::string>& reasons = proposal.reasons;
  const std::size_t rates = sizes_by_rate(tests.evidence).size();
  const BaseChoice base = base_for(tests.evidence, *from);
  reasons.push_back(words_on_law(tests.evidence));
  const auto held = std::ranges::find_if(tests.evidence, is_held);
  const bool shows_relaxation = rates > 1 && std::ranges::any_of(tests.evidence, has_way_back);
  if (held != tests.evidence.end())
    reasons.push_back(
        fmt::format("{} holds the strain while the stress falls by {}, so viscoelastic-foam was tried too: a "
                    "hyperfoam curve that relaxes.",
                    held->file, percent(*held->lost_held)));
  reasons.push_back(base.reason);
  if (rates > 1)
    reasons.push_back(
        fmt::format("Rate: {} rates from {} to {} 1/s, so the exponent of a power of the rate is "
                    "sought, alone and with a slope over the strain.",
                    rates, brief(std::ranges::min(tests.evidence, {}, &Evidence::rate).rate, 3),
                    brief(std::ranges::max(tests.evidence, {}, &Evidence::rate).rate, 3)));
  std::size_t points = 0;
  for (const Evidence& shown : tests.evidence) points += shown.loading_points;
  if (base.is_table)
    candidates.add_foams({{"table", from->table}});
  else if (points >= fewest_points)
    candidates.add_foams(formulas(*from));
  if (held != tests.evidence.end())
    candidates.add_viscoelastic("");
  else if (shows_relaxation)
    candidates.add_viscoelastic(
        "The other laws do not reproduce the unloading at several rates, so viscoelastic-foam was tried too: "
        "a hyperfoam curve that relaxes.");
  for (std::string& remark : remarks) reasons.push_back("REMARK: " + std::move(remark));
  if (proposal.candidates.empty())
    faults.push_back(
        {tests.sources[from->slowest].file.string(), 0, "", "",
         fmt::format("{} of one loading determine no formula, and there is nothing else to fit; dashpad "
                     "material import takes them as they are",
                     plural(tests.evidence[from->slowest].loading_points, "point"))});
  proposal.sources = std::move(tests.sources);
  proposal.tests = std::move(tests.evidence);
  return proposal;
}

}  // namespace dashpad::fit
