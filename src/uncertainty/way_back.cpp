// Uncertainty of the unloading (recoil, unloading factor, lag strain), and the statistical uncertainties.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::uncertainty {
namespace {

/// Ranges where a card gives none: all that is admitted for recoil, and for the unloading factor if no loss
/// was stated; for the lag strain, which no test at hand measures, 2.5 times less to 4 times more than 0.005.
constexpr ValueRange any_share{0, 1}, usual_lag{0.002, 0.02};

/// Whether nothing was stated about the unloading.
bool is_unstated(const Foam& foam) {
  return foam.friction == 0 && foam.unloading_factor == 1 && !foam.unloading_curve;
}

ValueRange around(double value, const ValueRange& range) {
  return {std::min(value, range.low), std::max(value, range.high)};
}

/// The value moved towards the lower (place -1) or upper (place 1) end of its range.
double towards(double value, const ValueRange& range, double place) {
  return place < 0 ? value - place * (range.low - value) : value + place * (range.high - value);
}

struct WayBack {
  ValueRange recoil, unloading_factor;
};

/// The ranges of a foam; a range is a point if the number is known or has no effect.
WayBack open_of(const Foam& foam, const Uncertainty& uncertainty, bool has_rate) {
  WayBack open{{foam.recoil, foam.recoil}, {foam.unloading_factor, foam.unloading_factor}};
  if (has_rate) open.recoil = around(foam.recoil, uncertainty.recoil.value_or(any_share));
  if (uncertainty.unloading_factor)
    open.unloading_factor = *uncertainty.unloading_factor;
  else if (is_unstated(foam))
    open.unloading_factor = around(foam.unloading_factor, any_share);
  return open;
}

bool is_open(const ValueRange& range) { return range.high > range.low; }

void add_scatter(const std::vector<Part>& parts, Open& open) {
  std::vector<double> scatter;
  std::string unmeasured;
  for (const Part& part : parts) {
    scatter.push_back(part.material->uncertainty.scatter.value_or(0));
    if (!part.material->uncertainty.scatter)
      unmeasured += (unmeasured.empty() ? "" : " or ") + part.material->name;
  }
  if (!unmeasured.empty())
    open.sources.push_back({Source::scatter, "the sample-to-sample scatter",
                            fmt::format("no measured value is given for {}", unmeasured)});
  if (std::ranges::all_of(scatter, [](double share) { return share == 0; })) return;
  open.sources.push_back({Source::scatter,
                          fmt::format("the sample-to-sample scatter (standard deviation {:.2g} %)",
                                      100 * std::ranges::max(scatter)),
                          ""});
  Line line{.source = Source::scatter, .key = "foam.scatter"};
  line.ends = {-line.deviations, line.deviations};
  line.move = [scatter](ImpactCase& impact, double place) {
    change_parts(impact, [&](Material&, PadCondition& condition, std::size_t i) {
      condition.scale *= std::max(1 + place * scatter[i], 0.01);
    });
  };
  open.lines.push_back(std::move(line));
}

/// A number of a case moved by deviations along an axis, whose ends lie one below and above: by equal ratios
/// if they are positive, else by equal steps.
double moved(double value, double nominal, double minus, double plus, double deviations) {
  const double end = deviations < 0 ? minus : plus, by = std::abs(deviations);
  return nominal > 0 && end > 0 ? value * portable::pow(end / nominal, by) : value + by * (end - nominal);
}

/// The line along an axis; on it lie the values of the case that are unknowns of a fit.
Line line_along(const ImpactCase& impact, const std::string& prefix, const PosteriorAxes& axes,
                std::size_t axis) {
  std::vector<CaseQuantity> unknowns;
  std::vector<double> nominal, minus, plus;
  const CaseQuantities quantities = quantities_of(impact);
  for (std::size_t i = 0; i < axes.keys.size(); ++i)
    if (const CaseQuantity* const unknown = quantities.find(prefix + axes.keys[i])) {
      unknowns.push_back(*unknown);
      nominal.push_back(unknown->get(impact));
      minus.push_back(axes.minus[axis][i]);
      plus.push_back(axes.plus[axis][i]);
    }
  // The ends lie at one standard deviation; the result is multiplied by 1.96.
  return {.source = Source::posterior,
          .ends = {-1, 1},
          .move =
              [=](ImpactCase& moved_case, double place) {
                for (std::size_t i = 0; i < unknowns.size(); ++i)
                  unknowns[i].set(moved_case,
                                  moved(unknowns[i].get(moved_case), nominal[i], minus[i], plus[i], place));
              },
          .deviations = 1};
}

void add_posterior(const ImpactCase& impact, const std::vector<Part>& parts, Open& open) {
  int count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PosteriorAxes& axes = parts[i].material->uncertainty.posterior;
    const std::string prefix = impact.pad.layers.empty() ? "pad." : fmt::format("pad.layers[{}].", i + 1);
    for (std::size_t axis = 0; axis < axes.minus.size(); ++axis) {
      open.lines.push_back(line_along(impact, prefix, axes, axis));
      open.lines.back().key = fmt::format("foam.posterior_{}", ++count);
    }
  }
  if (count > 0) open.sources.push_back({Source::posterior, "the uncertainty of the fitted parameters", ""});
}

void add_misfit(const std::vector<Part>& parts, Open& open) {
  Shares shares{.source = Source::misfit, .key = "foam.misfit"};
  const Misfit* worst = nullptr;
  for (const Part& part : parts)
    if (const auto& misfit = part.material->uncertainty.misfit) {
      if (worst == nullptr || misfit->hic > worst->hic) worst = &*misfit;
      shares.acceleration = std::max(shares.acceleration, misfit->peak_acceleration);
      shares.hic = std::max(shares.hic, misfit->hic);
      shares.rebound = std::max(shares.rebound, misfit->rebound_speed);
      shares.penetration = std::max(shares.penetration, misfit->penetration);
    }
  if (worst == nullptr) return;
  open.shares.push_back(shares);
  open.sources.push_back(
      {Source::misfit,
       fmt::format("the misfit of the fitted law over {} {} impact{}", worst->impacts,
                   worst->is_held_out ? "predicted" : "fitted", worst->impacts == 1 ? "" : "s"),
       ""});
}

}  // namespace

void add_way_back(const ImpactCase& impact, const Summary& summary, Open& open) {
  std::vector<std::optional<WayBack>> of_part;
  bool recoil = false, unloading = false, lag = false;
  for (const Part& part : parts_of(impact.pad, summary)) {
    of_part.emplace_back();
    const auto* const foam = std::get_if<Foam>(&part.material->law);
    if (foam == nullptr) {
      const std::string law = name_of(part.material->law);
      const bool crushes = std::holds_alternative<CrushableFoam>(part.material->law);
      if (crushes || !part.material->fitted)
        open.sources.push_back(
            {Source::way_back, "the unloading of the foam",
             crushes ? "the law leaves the foam crushed, but real foam recovers more"
                     : "it follows the " + law + " law, and the card does not say that it was tested"});
      continue;
    }
    const bool has_rate = !std::holds_alternative<NoRateEffect>(foam->curves.rate_effect);
    const WayBack way = open_of(*foam, part.material->uncertainty, has_rate);
    recoil = recoil || is_open(way.recoil);
    unloading = unloading || is_open(way.unloading_factor);
    lag = lag || has_rate;
    if (is_open(way.recoil) || is_open(way.unloading_factor)) of_part.back() = way;
  }
  if (recoil || unloading) {
    open.sources.push_back({Source::way_back,
                            recoil && unloading
                                ? "the unloading of the foam (both in slow tests and at the impact rate)"
                            : recoil ? "the unloading of the foam at the impact rate"
                                     : "the unloading of the foam",
                            ""});
    // Place 1 has the largest loss, -1 the smallest.
    open.lines.push_back({.source = Source::way_back,
                          .key = "foam.way_back",
                          .ends = {-1, 1},
                          .move = [of_part](ImpactCase& moved_case, double place) {
                            change_parts(moved_case, [&](Material& material, PadCondition&, std::size_t i) {
                              if (!of_part[i]) return;
                              Foam& foam = std::get<Foam>(material.law);
                              foam.recoil = towards(foam.recoil, of_part[i]->recoil, place);
                              foam.unloading_factor =
                                  towards(foam.unloading_factor, of_part[i]->unloading_factor, -place);
                            });
                          }});
  }
  if (!lag) return;
  if (!recoil && !unloading)
    open.sources.push_back({Source::way_back, "how quickly the stress follows a change in strain rate", ""});
  open.lines.push_back({.source = Source::way_back,
                        .key = "foam.lag_strain",
                        .ends = {-1, 1},
                        .move = [](ImpactCase& moved_case, double place) {
                          change_parts(moved_case, [&](Material& material, PadCondition&, std::size_t) {
                            auto* const foam = std::get_if<Foam>(&material.law);
                            if (foam == nullptr) return;
                            const ValueRange range =
                                around(foam->lag_strain, material.uncertainty.lag_strain.value_or(usual_lag));
                            foam->lag_strain = portable::exp(
                                towards(portable::log(foam->lag_strain),
                                        {portable::log(range.low), portable::log(range.high)}, place));
                          });
                        }});
}

void add_statistics(const ImpactCase& impact, const Summary& summary, Open& open) {
  const std::vector<Part> parts = parts_of(impact.pad, summary);
  add_scatter(parts, open);
  add_posterior(impact, parts, open);
  add_misfit(parts, open);
}

double student_95(double degrees_of_freedom) {
  if (!(degrees_of_freedom > 0)) return infinite;
  return quantile(complement(boost::math::students_t(degrees_of_freedom), 0.025));
}

}  // namespace dashpad::uncertainty
