#pragma once
/// A pad material: a law with its parameters, where they come from, and where they were fitted.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

// What is not known of a foam, as its card states it (theory.md, section 6). What a card leaves out is
// unknown, not zero: `uncertainty/` then takes a range with a reason, or says that there is none.

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

/// The strains and strain rates for which a law was fitted to tests. Outside it a result is extrapolated.
struct FittedRange {
  double highest_strain = 1;  ///< (0, 1]
  double lowest_rate = 0;     ///< lowest peak strain rate of an impact for which the fit holds, 1/s
  double highest_rate = 0;    ///< 1/s
};

/// By what the stress of a foam is multiplied at other temperatures.
struct TemperatureTable {
  std::vector<double> temperature;  ///< K, increasing
  std::vector<double> factor;       ///< > 0
};

/// The name of a material whose law stands in the case itself.
inline constexpr const char* foam_of_the_case = "foam of the case";

struct Material {
  std::string name = {};    ///< as cards and cases name it, or foam_of_the_case
  std::string title = {};   ///< for people
  std::string source = {};  ///< where the parameters come from
  std::string basis = {};   ///< "test", "datasheet", "solver card" or "reconstruction"; empty: not stated
  std::string licence = {};
  std::optional<double> density = {};           ///< kg/m3
  std::optional<double> density_exponent = {};  ///< stress ~ density to this power, [0, 5]
  TemperatureTable temperature_table = {};
  std::vector<std::string> reservations = {};  ///< what to keep in mind, a sentence each
  PadLaw law = {};
  std::optional<FittedRange> fitted = {};
  /// Of a law that was measured by strikes of a sphere alone: its radius over the thickness of the pad, > 0.
  /// What neighbouring columns did is in its numbers.
  std::optional<double> nose_over_pad = {};
  Uncertainty uncertainty = {};
  /// Published values that the law does not use: name and value as the card has them.
  std::vector<std::pair<std::string, std::string>> also_published = {};
};

/// Where the curves of a foam were tested.
FittedRange tested_range(const FoamCurves& curves);

/// Where the law was fitted or its curves were tested; nothing where that is not stated.
std::optional<FittedRange> range_of(const Material& material);

/// Whether the key of a broken rule of a law (violations(PadLaw)) is that of a parameter, not of a curve.
bool is_of_parameters(std::string_view key);

/// Every rule that the law, its fitted range or its uncertainty breaks. Keys are those of cards:
/// `parameters.modulus`, `fitted.highest_rate`, `uncertainty.recoil`.
std::vector<Violation> violations(const Material& material);
/// The same but for the law, where that is known to keep its rules.
std::vector<Violation> violations_beside_law(const Material& material);

/// Beyond what a law was tested or fitted for: its strain is a guess there, its rate a law.
enum class Beyond { strain, rate, other };
/// As flags name it: "EXTRAPOLATED STRAIN", "EXTRAPOLATED RATE", "EXTRAPOLATED".
std::string name_of(Beyond beyond);

/// Why a result is extrapolated, in words.
struct Extrapolation {
  Beyond beyond = Beyond::other;
  std::string text;
};

/// Why a result with these largest strain and strain rate (1/s) is extrapolated, a reason each: beyond the
/// fitted range, or where the law is not defined. Empty if it is not.
std::vector<Extrapolation> extrapolations(const Material& material, double largest_strain,
                                          double largest_rate);

}  // namespace dashpad
