#pragma once
/// What is not known of a foam, as its card states it (theory.md, section 6). What a card leaves out is
/// unknown, not zero: `uncertainty/` then takes a range with a reason, or says that there is none.

#include <optional>
#include <string>
#include <vector>

namespace dashpad {

/// Of a parameter: it lies between the two, and no value is likelier than another.
struct ValueRange {
  double low = 0;
  double high = 0;  ///< >= low

  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// By what measured impacts differ from the law beyond their noise: standard deviations, shares of the
/// figure, in [0, 1].
struct Misfit {
  double peak_acceleration = 0;  ///< also of forces and clips
  double hic = 0;                ///< of every window; also of the severity index
  double rebound_speed = 0;
  double penetration = 0;
  int impacts = 0;           ///< how many it rests on, >= 1
  bool is_held_out = false;  ///< whether these were predicted, not fitted
  /// Radius of the nose over the thickness of the pad in them, where these are known: what columns leave out
  /// below such a nose is in the misfit then.
  std::optional<double> nose_over_pad = {};

  friend bool operator==(const Misfit&, const Misfit&) = default;
};

/// What the data of a fit leave open of its unknowns: the principal axes of their covariance, each by the
/// values of the unknowns one standard deviation down and up it. The others of the law stay.
struct PosteriorAxes {
  std::vector<std::string> keys;  ///< of the card: "curve.modulus", "parameters.friction", "rate.exponent"
  std::vector<std::vector<double>> minus, plus;  ///< SI, one for each key; as many rows in both

  friend bool operator==(const PosteriorAxes&, const PosteriorAxes&) = default;
};

inline constexpr std::size_t most_posterior_axes = 4;
inline constexpr std::size_t most_posterior_keys = 50;

struct Uncertainty {
  /// Of parameters of the law, which lie inside.
  std::optional<ValueRange> recoil, unloading_factor, lag_strain;
  /// Exponent of the rate by which the stress goes on to grow above the highest tested rate, in [0, 1].
  std::optional<ValueRange> rate_exponent;
  std::optional<double> scatter;  ///< standard deviation of the stress from sample to sample, a share, [0, 1]
  std::optional<Misfit> misfit;
  PosteriorAxes posterior;

  friend bool operator==(const Uncertainty&, const Uncertainty&) = default;
};

}  // namespace dashpad
