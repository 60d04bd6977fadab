#pragma once
/// The stress of a material in a first loading at constant rate.

#include <vector>

#include "dashpad/model/pad/material.hpp"

namespace dashpad::laboratory {

/// Rates that the material was tested at, 1/s, increasing; at least one. Of a law without curves the ends of
/// its fitted range; without that, 1.
std::vector<double> tested_rates(const Material& material);

struct LoadingCurve {
  std::vector<double> strain;
  std::vector<double> stress;  ///< Pa
};

/// Up to a strain in (0, 1), in `steps` (2 or more) even steps from strain zero. The material
/// breaks no rule (violations(Material)).
LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps);

}  // namespace dashpad::laboratory
