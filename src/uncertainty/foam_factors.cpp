#include "uncertainty/foam_factors.hpp"

#include <algorithm>
#include <string_view>

#include "dashpad/injury/metrics.hpp"

namespace dashpad::uncertainty {

double change_of(const ResultQuantity& quantity, double value, const Summary& summary, const Shares& shares,
                 double deviations) {
  switch (quantity.role.doubt) {
    case Doubt::none:
    case Doubt::of_level: break;
    case Doubt::of_acceleration: return deviations * (shares.acceleration * value);
    case Doubt::of_hic: return deviations * (shares.hic * value);
    case Doubt::of_hic_d: return deviations * (shares.hic * (value - injury::hic_d(0)));
    case Doubt::of_rebound: return deviations * (shares.rebound * value);
    case Doubt::of_rebound_height: {
      const double factor = std::max(1 + deviations * shares.rebound, 0.0);
      return (factor * factor - 1) * value;
    }
    case Doubt::of_penetration: {
      // The depth of the impact itself, or the strain, which is one over the thickness. Nothing goes deeper
      // than the pad.
      const bool is_depth = std::string_view(quantity.si_unit) == "m";
      const double deepest = is_depth ? summary.peak_penetration : summary.peak_strain;
      if (!(deepest > 0)) return 0;
      const double whole = deepest / summary.peak_strain;
      const double at_95 = deviations < 0 ? shares.shallower : shares.deeper;
      const double of_figure = deepest / summary.peak_penetration;
      return std::min(deviations * (shares.penetration * value + at_95 / two_sided_95 * of_figure),
                      std::max(whole - value, 0.0));
    }
  }
  return 0;
}

namespace {

/// Normal draws stay well within this number of deviations.
FoamFactor statistical(const std::string& key) { return {key, true, -20, 20}; }

}  // namespace

std::vector<FoamFactor> foam_factors(const ImpactCase& impact) {
  Summary beyond;  // all tests
  beyond.peak_strain = 1;
  beyond.peak_strain_rate = 1e9;
  for (std::size_t i = 0; i < impact.pad.layers.size(); ++i) {
    beyond.layers.emplace_back();
    beyond.layers.back().peak_strain = beyond.peak_strain;
    beyond.layers.back().peak_strain_rate = beyond.peak_strain_rate;
  }
  const Open open = open_sources_of(impact, beyond);
  std::vector<FoamFactor> factors;
  for (const Line& line : open.lines)
    factors.push_back(is_statistical(line.source)
                          ? statistical(line.key)
                          : FoamFactor{line.key, false, std::min(line.ends.front(), 0.0), line.ends.back()});
  for (const Shares& shares : open.shares) factors.push_back(statistical(shares.key));
  return factors;
}

FoamDraw::FoamDraw(const Numbers& numbers, const Summary& nominal, ImpactCase& impact) {
  const Open open = open_sources_of(impact, nominal);
  const auto number = [&](const std::string& key) {
    const auto found = std::ranges::find(numbers, key, &Numbers::value_type::first);
    return found == numbers.end() ? 0 : found->second;
  };
  for (const Line& line : open.lines)
    if (const double place = number(line.key); place != 0) {
      line.move(impact, place);
      has_moved_ = true;
    }
  for (const Shares& shares : open.shares)
    if (const double deviations = number(shares.key); deviations != 0)
      errors_.push_back({shares, deviations});
}

double FoamDraw::figure(const ResultQuantity& quantity, double value, const Summary& summary) const {
  double moved = value;
  for (const auto& [shares, deviations] : errors_)
    moved += change_of(quantity, moved, summary, shares, deviations);
  return quantity.role.is_signed || !(moved < 0) ? moved : 0;
}

}  // namespace dashpad::uncertainty
