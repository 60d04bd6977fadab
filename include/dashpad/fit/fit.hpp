#pragma once
/// A fit: the unknown numbers of a material and the measurements that they have to meet. SI throughout;
/// stress and strain are engineering values, compression positive. docs/fits.md describes its file.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::fit {

/// Normal distribution of an unknown, known before the fit.
struct Prior {
  double mean = 0;
  double deviation = 0;  ///< > 0
};

/// A quantity of the case (dashpad/case/case_quantity.hpp) that the fit has to find.
struct Unknown {
  std::string key;              ///< "pad.curve.modulus"
  std::string unit;             ///< SI; "1" for a pure number
  double lowest = 0;            ///< bounds within which it is sought
  double highest = 0;           ///< > lowest
  double start = 0;             ///< value of the first start
  bool is_logarithmic = false;  ///< sought by its logarithm; then lowest > 0
  std::optional<Prior> prior = {};
  bool is_added = false;  ///< added by the program, since nobody stated the number
};

/// The place of a value between its bounds, 0 to 1, by the logarithm if it is sought so.
inline double place_between(double lowest, double highest, bool is_logarithmic, double value) {
  return is_logarithmic ? std::log(value / lowest) / std::log(highest / lowest)
                        : (value - lowest) / (highest - lowest);
}

/// A compression test, strain and stress point by point. Between the points the strain is straight in time.
struct MaterialMeasurement {
  std::string file;            ///< name for messages and for the card
  std::vector<double> time;    ///< s since first contact, increasing
  std::vector<double> strain;  ///< each in [0, 1)
  std::vector<double> stress;  ///< Pa
  double lowest_strain = 0;    ///< points with strains from here
  double highest_strain = 1;   ///< end of the strains that count; the others are only passed through
  /// Temperature of the specimen, K, for a card with a temperature table; absent: the temperature at which
  /// its factor is 1.
  std::optional<double> temperature = {};
  std::optional<double> noise;  ///< standard deviation of a stress, Pa; absent: estimated from the misfit
  bool has_offset = false;      ///< its force zero is shifted by an unknown stress
  bool is_held_out = false;     ///< predicted, not fitted
  /// Whether the base curve is a table of its loading, whose residuals are then no sign of the noise.
  bool is_base = false;
  std::vector<std::string> remarks = {};  ///< repairs and interpretations of the file, a sentence each
};

/// A figure of an impact that can be measured, in the order of impact_figure_names().
enum class ImpactFigure {
  peak_force,
  peak_acceleration,
  time_of_peak,
  rebound_speed,
  peak_penetration,
  contact_time,
  hic15,
  hic36,
  hic_unlimited,
  clip_3ms,
  cumulative_3ms,
  velocity_change
};

/// A figure of an impact.
struct MeasuredFigure {
  ImpactFigure figure = ImpactFigure::peak_force;
  double value = 0;      ///< SI
  double deviation = 0;  ///< standard deviation, > 0
};

/// A measured pulse of an impact between its onset (injury::onset_share of its peak) and its end
/// (injury::contact_of()), with a positive peak.
struct MeasuredDeceleration {
  std::string file;
  std::vector<double> time;          ///< s since the onset, increasing
  std::vector<double> deceleration;  ///< m/s2, as many
  double peak = 0;                   ///< m/s2, > 0
  double onset = 0;                  ///< s, by the clock of the file
  double half_peak_width = 0;        ///< s, > 0
  std::size_t samples = 0;           ///< samples of the file in that stretch; `time` is thinned
  double deviation = 0;              ///< standard deviation of a deceleration, m/s2, > 0
  std::optional<injury::PulseFilter>
      filter;           ///< filter of the measured pulse, which the computed pulse gets, too
  double interval = 0;  ///< s between two samples of the file
  double hic = 0;       ///< HIC with an unlimited window, from all samples between onset and end, g^2.5 s
  double velocity_change = 0;                         ///< m/s, over contact
  std::optional<injury::MeasuredImpact> impact = {};  ///< present if the file gives a speed or drop height
  std::vector<std::string> remarks = {};  ///< repairs and interpretations of the file, a sentence each
};

/// Samples of a pulse that are fitted, at most; neighbours tell little that is new.
inline constexpr std::size_t max_pulse_points = 200;

/// The pulse between onset and end, thinned evenly to max_pulse_points. `measured` has been filtered; `quiet`
/// is the stretch before the impact, if it is known. Throws std::invalid_argument, with a message that
/// follows the name of the file, for a pulse without onset or with too few samples after it.
MeasuredDeceleration deceleration_of(const injury::ProcessedPulse& processed,
                                     const std::optional<injury::Stretch>& quiet = {});

/// An impact and what was measured of it. The material of its pad is that of the fit.
struct ImpactMeasurement {
  std::string file;
  ImpactCase impact;
  Options options;
  std::vector<MeasuredFigure> figures;
  std::optional<MeasuredDeceleration> pulse;
  bool is_held_out = false;
  bool states_neighbours = false;  ///< its case says what they are, and does not leave it to what is nominal
};

struct Fit {
  std::string title;
  ImpactCase base;        ///< its material has the starting values; without impacts the rest is made up
  bool has_case = false;  ///< the base is a case of the user's, not a pad alone
  Options options;        ///< options of that case
  /// Whether the recoil of a foam with a rate effect was given, rather than left to its default.
  bool recoil_is_stated = true;
  std::vector<Unknown> unknowns;
  std::vector<MaterialMeasurement> tests;
  std::vector<ImpactMeasurement> impacts;
  int starts = 8;          ///< [1, 1000]
  std::uint64_t seed = 1;  ///< seed of all starts but the first
};

/// Name in fit files and results, and SI unit.
struct ImpactFigureName {
  ImpactFigure figure;
  const char* key;                 ///< key in fit files
  const ResultQuantity* quantity;  ///< quantity with title and SI unit
};
const std::vector<ImpactFigureName>& impact_figure_names();
const ImpactFigureName& name_of(ImpactFigure figure);

/// Whether a card holds that number: one of the law, or the scale that goes into its stresses.
bool is_of_card(const std::string& key);
/// Whether an unknown is none of those, as the stiffness of a support: a case holds it.
bool finds_more_than_a_card(const Fit& fit);

/// Whether a number is among the unknowns.
inline bool seeks(const Fit& fit, std::string_view key) {
  return std::ranges::count(fit.unknowns, key, &Unknown::key) > 0;
}

/// The tests or impacts that are fitted to: those that are not held out.
template <class Measurement>
std::vector<std::reference_wrapper<const Measurement>> fitted(const std::vector<Measurement>& measurements) {
  std::vector<std::reference_wrapper<const Measurement>> result;  // clang 14 has no views of this library
  std::ranges::copy_if(measurements, std::back_inserter(result), std::logical_not(),
                       &Measurement::is_held_out);
  return result;
}
/// Whether there is one.
template <class Measurement>
bool has_fitted(const std::vector<Measurement>& measurements) {
  return !std::ranges::all_of(measurements, &Measurement::is_held_out);
}
/// Whether the unknowns are told by impacts alone.
inline bool rests_on_impacts_alone(const Fit& fit) {
  return !has_fitted(fit.tests) && has_fitted(fit.impacts);
}

/// Whether a strain counts in the fit.
inline bool counts(const MaterialMeasurement& test, std::size_t i) {
  return test.strain[i] >= test.lowest_strain && test.strain[i] <= test.highest_strain;
}

/// All rules that a fit breaks, under keys of fit files: "unknowns.pad.curve.modulus", "tests[1].file".
std::vector<Violation> violations(const Fit& fit);

struct FitFile {
  Fit fit;
  std::vector<input::InputFile> files;  ///< files that were read
};

/// Reads a fit file. `materials` is the folder of material cards; other files are relative to the fit file.
/// Reports all faults of the file and of those that it names.
///
/// Example:
/// \code
/// #include "dashpad/fit/report.hpp"
/// const auto read = dashpad::fit::read_fit("foam.toml", "materials");
/// for (const dashpad::input::Fault& fault : read.faults()) std::puts(to_string(fault).c_str());
/// if (read)
///   for (const dashpad::fit::FittedUnknown& found : dashpad::fit::run_fit(read->fit).unknowns)
///     std::printf("%s = %g\n", found.key.c_str(), found.value);  // SI
/// \endcode
input::Reading<FitFile> read_fit(const std::filesystem::path& file, const std::filesystem::path& materials);

}  // namespace dashpad::fit
