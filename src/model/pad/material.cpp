#include "dashpad/model/pad/material.hpp"

#include <fmt/format.h>

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

std::vector<std::string> extrapolations(const Material& material, double largest_strain,
                                        double largest_rate) {
  std::vector<std::string> reasons;
  if (const auto& fitted = material.fitted) {
    if (largest_strain > fitted->highest_strain)
      reasons.push_back(fmt::format("strain reaches {:.3f}; the law was fitted up to {:.3g}", largest_strain,
                                    fitted->highest_strain));
    if (largest_rate > fitted->highest_rate || largest_rate < fitted->lowest_rate)
      reasons.push_back(
          fmt::format("strain rate reaches {:.3g} per second; the law was fitted from {:.3g} to {:.3g}",
                      largest_rate, fitted->lowest_rate, fitted->highest_rate));
  }
  std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.residual_strain_time; })
          if (law.residual_strain_time * largest_rate >= 1)
            reasons.push_back(
                fmt::format("strain rate reaches {:.3g} per second; the law's residual strain is defined "
                            "below {:.3g} per second",
                            largest_rate, 1 / law.residual_strain_time));
      },
      material.law);
  return reasons;
}

}  // namespace dashpad
