#pragma once
/// A pad material: a law with its parameters, their source, and the range in which they were fitted.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

// Uncertainty of a foam as stated by its card (theory.md, section 6.2). What a card leaves out is unknown,
// not zero: `uncertainty/` then assumes a justified range, or reports that there is no interval.

/// Range in which a parameter lies, with no value likelier than another.
struct ValueRange {
  double low = 0;
  double high = 0;  ///< >= low

  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// Deviation of measured impacts from the law beyond noise: standard deviations over the figure, in [0, 1].
struct Misfit {
  double peak_acceleration = 0;  ///< also applies to forces and clips
  double hic = 0;                ///< applies to every window and to the severity index
  double rebound_speed = 0;
  double penetration = 0;
  int impacts = 0;           ///< number of impacts it was found from, >= 1
  bool is_held_out = false;  ///< whether these impacts were predicted, not fitted
  /// Radius of the nose over the thickness of the pad in these impacts, if known: the misfit then includes
  /// the error of independent columns below such a nose.
  std::optional<double> nose_over_pad = {};

  friend bool operator==(const Misfit&, const Misfit&) = default;
};

/// Uncertainty of the unknowns of a fit: the principal axes of their covariance. Each axis holds the values
/// of the unknowns one standard deviation down and up; other parameters of the law stay as they are.
struct PosteriorAxes {
  std::vector<std::string> keys;  ///< card keys: "curve.modulus", "parameters.friction", "rate.exponent"
  std::vector<std::vector<double>> minus, plus;  ///< SI, one value for each key; as many rows in both

  friend bool operator==(const PosteriorAxes&, const PosteriorAxes&) = default;
};

inline constexpr std::size_t max_posterior_axes = 4;
inline constexpr std::size_t max_posterior_keys = 50;

struct Uncertainty {
  /// Ranges of parameters of the law, whose own values lie inside.
  std::optional<ValueRange> recoil, unloading_factor, lag_strain;
  /// Exponent of the rate with which the stress grows above the highest tested rate, in [0, 1].
  std::optional<ValueRange> rate_exponent;
  std::optional<double> scatter;  ///< relative standard deviation of the stress among samples, [0, 1]
  std::optional<Misfit> misfit;
  PosteriorAxes posterior;

  friend bool operator==(const Uncertainty&, const Uncertainty&) = default;
};

/// The strains and strain rates for which a law was fitted; outside them a result is extrapolated.
struct FittedRange {
  double highest_strain = 1;  ///< (0, 1]
  double lowest_rate = 0;     ///< lowest peak strain rate of an impact for which the fit holds, 1/s
  double highest_rate = 0;    ///< 1/s
};

inline constexpr double highest_temperature = 2000;  ///< K

/// Factor of the stress of a foam at other temperatures.
struct TemperatureTable {
  std::vector<double> temperature;  ///< K, increasing
  std::vector<double> factor;       ///< > 0
};

/// Name of a material whose law is given in the case itself.
inline constexpr const char* foam_of_the_case = "foam of the case";

struct Material {
  std::string name = {};    ///< name in cards and cases, or foam_of_the_case
  std::string title = {};   ///< name to be shown
  std::string source = {};  ///< source of the parameters
  std::string basis = {};   ///< "test", "datasheet", "solver card" or "reconstruction"; empty: not stated
  std::string licence = {};
  std::optional<double> density = {};           ///< kg/m3
  std::optional<double> density_exponent = {};  ///< stress ~ density to this power, [0, 5]
  TemperatureTable temperature_table = {};
  std::vector<std::string> reservations = {};  ///< reservations about the card, one sentence each
  PadLaw law = {};
  std::optional<FittedRange> fitted = {};
  /// For a law measured only by strikes of a sphere: radius of the sphere over the thickness of the pad, > 0.
  /// The parameters of such a law include the effect of neighbouring columns.
  std::optional<double> nose_over_pad = {};
  Uncertainty uncertainty = {};
  /// Published values that the law does not use: name and value as the card has them.
  std::vector<std::pair<std::string, std::string>> also_published = {};
};

/// Strains and rates at which the curves of a foam were tested.
FittedRange tested_range(const FoamCurves& curves);

/// The range in which the law was fitted or its curves were tested; nothing where that is not stated.
std::optional<FittedRange> range_of(const Material& material);

/// Whether the key of a Violation of a law names a parameter, not a curve.
bool is_of_parameters(std::string_view key);

/// Every rule that the law, its fitted range or its uncertainty breaks. Keys are those of cards:
/// `parameters.modulus`, `fitted.highest_rate`, `uncertainty.recoil`.
std::vector<Violation> violations(const Material& material);
/// The same without the rules of the law, for one that is known to keep them.
std::vector<Violation> violations_beside_law(const Material& material);

/// How a result is extrapolated: beyond the tested strain by a guess, beyond the tested rates by a law.
enum class Beyond { strain, rate, other };
/// Name of the flag: "EXTRAPOLATED STRAIN", "EXTRAPOLATED RATE", "EXTRAPOLATED".
std::string name_of(Beyond beyond);

/// One reason why a result is extrapolated.
struct Extrapolation {
  Beyond beyond = Beyond::other;
  std::string text;
};

/// Reasons why a result with these largest strain and strain rate (1/s) is extrapolated: they lie beyond the
/// fitted range, or where the law is not defined. Empty if it is not.
std::vector<Extrapolation> extrapolations(const Material& material, double largest_strain,
                                          double largest_rate);

}  // namespace dashpad
