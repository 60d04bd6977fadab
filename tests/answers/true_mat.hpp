#pragma once
/// Made-up playground mats whose law is known, and none of Dashpad's: columns under a missile, stepped
/// through time without any of its sources.

#include <cstdint>
#include <string>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::test {

/// 4.6 kg, a hemisphere of 80 mm: EN 1177.
inline constexpr double missile_mass = 4.6, missile_radius = 0.08;

enum class TrueLaw {
  /// Plateau and densification, a factor that grows by the logarithm of the rate, a Maxwell branch, and a way
  /// back that is weaker by a weight.
  maxwell_branch,
  /// A plateau whose rate exponent grows with the strain beside air that is enclosed and compressed, each
  /// with a
  /// way back of its own.
  enclosed_air
};

struct TrueMat {
  TrueLaw law = TrueLaw::maxwell_branch;
  double thickness = 0.05;                 ///< m
  double plateau = 90e3, modulus = 1.6e6;  ///< Pa
  double densification = 75e3;             ///< Pa; of enclosed air its pressure
  double exponent = 1.6;                   ///< of densification; of enclosed air the share of solid
  double rate_factor = 0.045;  ///< of ln(1 + rate / 0.01); of enclosed air the exponent at strain zero
  double rate_growth = 0;      ///< of the exponent with the strain, with enclosed air
  double branch = 0.35;        ///< stiffness of the Maxwell branch over that of the curve
  double branch_time = 6e-3;   ///< s
  double loss = 0.55;          ///< weight that is gone at the end of the way back
  double loss_of_air = 0.2;    ///< the same of enclosed air
};

struct TrueDrop {
  Pulse pulse;      ///< s since first contact; m/s2, negative: what a sensor in the missile shows
  double peak = 0;  ///< m/s2
  double hic = 0;   ///< of any window
  double largest_strain = 0;
};

/// How finely columns and time are divided.
struct Fineness {
  int columns = 160;
  double step = 5e-6;  ///< s
};

TrueDrop dropped(const TrueMat& mat, double height, Fineness fineness = {});

/// What was drawn for a seed.
struct DrawnMat {
  TrueMat mat;
  double highest = 0;  ///< m, of the three drops; the others from half and three quarters of that
  double within = 0;   ///< m, between the lowest and the highest, for which a HIC is asked
  double beyond = 0;   ///< m, 20 % above the highest
};
DrawnMat drawn_mat(TrueLaw law, std::uint64_t seed);

/// What a sensor with a noise of 0.5 % of the peak shows at 20 kHz, by a clock of its own.
Pulse measured_pulse(const TrueDrop& drop, std::uint64_t seed, std::uint64_t which);

}  // namespace dashpad::test
