#include "dashpad/pad/material.hpp"

namespace dashpad {
namespace {

void check_fit(const FittedRange& fitted, std::vector<Violation>& broken) {
  constexpr double highest_rate = 1e9;  // 1/s
  if (!(fitted.highest_strain > 0 && fitted.highest_strain <= 1))
    broken.push_back({"fitted.highest_strain", fitted.highest_strain, "must be more than 0 and at most 1"});
  if (!(fitted.lowest_rate >= 0 && fitted.lowest_rate <= highest_rate))
    broken.push_back({"fitted.lowest_rate", fitted.lowest_rate, "must be at least 0 and at most 1e9 1/s"});
  if (!(fitted.highest_rate > 0 && fitted.highest_rate <= highest_rate))
    broken.push_back({"fitted.highest_rate", fitted.highest_rate, "must be more than 0 and at most 1e9 1/s"});
  else if (fitted.highest_rate <= fitted.lowest_rate)
    broken.push_back({"fitted.highest_rate", fitted.highest_rate, "must be more than lowest_rate"});
}

}  // namespace

std::vector<Violation> violations(const Material& material) {
  std::vector<Violation> broken = violations(material.law);
  for (Violation& violation : broken) violation.key = "parameters." + violation.key;
  if (material.fitted) check_fit(*material.fitted, broken);
  return broken;
}

}  // namespace dashpad
