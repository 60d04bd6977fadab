#pragma once
/// The stress of one column under any smooth strain history, by quadrature of its memory integral:
///
///   stress(t) = integral over t' of exp(-(H(t) - H(t'))) (dG/de r + h G) dt',   H = integral of h
///
/// No time steps: double-exponential quadrature, which takes the singular rates of laws 4 and 5 at e = 0.

#include <functional>

#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"
#include "dashpad/model/pad/twenty_one_parameter.hpp"

namespace dashpad::oracle {

/// Strain over the time since the column was touched: 0 at 0, rising until `turning`, falling after it.
struct StrainHistory {
  std::function<double(double)> strain;
  std::function<double(double)> rate;  ///< its derivative, 1/s
  double turning = 0;                  ///< s; the largest strain is reached there
  double touched = 0;  ///< s, from the impact's first contact to the column's (law 5 counts from the former)
};

/// Stress at `time` after the column was touched, Pa. The strain must still be positive.
double column_stress(const LinearViscoelastic& law, const StrainHistory& history, double time);
double column_stress(const NineParameter& law, const StrainHistory& history, double time);
double column_stress(const TwentyOneParameter& law, const StrainHistory& history, double time);

}  // namespace dashpad::oracle
