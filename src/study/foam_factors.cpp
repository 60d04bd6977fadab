#include "study/foam_factors.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "study/sampling.hpp"

namespace dashpad::study {

std::vector<FoamFactor> foam_factors(const Study& study) {
  if (study.materials.empty()) return uncertainty::foam_factors(study.base);
  std::vector<FoamFactor> factors;
  ImpactCase impact = study.base;
  for (const Material& material : study.materials) {
    impact.pad.material = material;
    for (FoamFactor& factor : uncertainty::foam_factors(impact))
      if (!std::ranges::count(factors, factor.key, &FoamFactor::key)) factors.push_back(std::move(factor));
  }
  return factors;
}

void draw_foam_uncertainty(Study& study) {
  for (const FoamFactor& factor : foam_factors(study)) {
    if (std::ranges::count(study.factors, factor.key, &Factor::key)) continue;
    Spread spread = Normal{0, 1};
    if (!factor.is_statistical) spread = Uniform{factor.lowest, factor.highest};
    study.factors.push_back({.key = factor.key, .unit = "1", .spread = spread, .lowest = {}, .highest = {}});
  }
}

void check_foam_factor(const Factor& factor, const FoamFactor& known, std::vector<Violation>& broken) {
  if (const auto* given = factor.given_values(); given && given->empty()) return;
  const CheckedRange range = checked_range(factor);
  if (range.low < known.lowest || range.high > known.highest)
    broken.push_back(
        {"factors." + factor.key, range.low < known.lowest ? range.low : range.high,
         fmt::format("must lie between {} and {}{}", known.lowest, known.highest,
                     known.is_statistical ? " standard deviations" : ", the ends of what is uncertain")});
}

}  // namespace dashpad::study
