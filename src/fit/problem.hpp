#pragma once
/// A fit as least squares: coordinates in [0, 1] in, residuals out.
///
///   residual = (predicted - measured) / deviation,  misfit = sum of squared residuals
///
/// Each unknown, and each shift of a force zero, is a coordinate: 0 at its lowest and 1 at its highest
/// value, by the logarithm where it is sought so. A source of data is a block of residuals.

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/impact/pulse.hpp"
#include "dashpad/laboratory/column_test.hpp"

namespace dashpad::fit {

struct Coordinate {
  std::string key;
  std::string unit;
  double lowest = 0, highest = 1;
  double start = 0;  ///< a value
  bool is_logarithmic = false;
  bool is_nuisance = false;
  std::optional<Prior> prior;

  [[nodiscard]] double value(double x) const {
    return is_logarithmic ? lowest * std::pow(highest / lowest, x) : lowest + x * (highest - lowest);
  }
  [[nodiscard]] double place(double value) const {
    return place_between(lowest, highest, is_logarithmic, value);
  }
  /// Change of the value with the coordinate.
  [[nodiscard]] double slope(double x) const {
    return is_logarithmic ? value(x) * std::log(highest / lowest) : highest - lowest;
  }
};

/// A predicted figure that an impact does not have.
inline constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// Predicts from the values of all coordinates, SI. False without a material. Absent figures are `no_figure`.
using Predict = std::function<bool(std::span<const double> values, std::span<double> predicted)>;

/// The same with the shift at which the pulse meets the measured one best, which is put into the values.
using Settle = std::function<bool(std::span<double> values, std::span<double> predicted)>;

/// A source of data with its residuals.
struct Block {
  std::size_t first = 0;  ///< index of its first residual
  std::vector<double> measured;
  std::vector<double> deviation;
  std::optional<std::size_t> offset;  ///< the coordinate that is added to what is predicted
  Predict predict;
  /// The first residual from which on the data follow a curve: that of a test, or of a pulse behind the
  /// figures of its impact. Absent if none does.
  std::optional<std::size_t> curve;
  std::optional<std::size_t> shift;  ///< the coordinate by which its pulse comes later; predict() knows it
  Settle settle;                     ///< present if there is a shift
  bool noise_is_stated = true;
  std::size_t idle = 0;  ///< number of points that the base curve goes through, as a table of them
  bool is_impact = false;
  /// No data: what keeps a base curve rising, as a material must.
  bool is_rule = false;

  [[nodiscard]] std::size_t size() const { return measured.size(); }
};

struct Problem {
  std::vector<Coordinate> coordinates;
  std::vector<Block> blocks;
  double derivative_step = 1e-4;  ///< step of a coordinate for central differences

  [[nodiscard]] std::size_t points() const;  ///< measured numbers
  [[nodiscard]] std::size_t idle() const;    ///< those that tell nothing of the noise
  [[nodiscard]] std::size_t priors() const;
  [[nodiscard]] std::size_t residuals() const;  ///< number of residuals: of all blocks, then priors
  /// `x` in [0, 1]; false where the model cannot be evaluated.
  bool evaluate(std::span<const double> x, std::span<double> residuals) const;
  /// The same with the best shift of each pulse whose shift is not held, which is put into `x`.
  bool settle(std::span<double> x, const std::vector<bool>& held, std::span<double> residuals) const;
  [[nodiscard]] std::vector<bool> shifts() const;  ///< which coordinates are shifts of pulses
  [[nodiscard]] std::vector<double> values(std::span<const double> x) const;
};

/// The number of coordinates: unknowns, offsets and shifts.
std::size_t coordinate_count(const Fit& fit);

/// `runs`: of the solver, for each impact.
Problem problem_of(const Fit& fit, int runs);

/// A function that predicts the points of a test that count from the values of the unknowns.
Predict prediction_of(const Fit& fit, const MaterialMeasurement& test);
/// A function that predicts the figures of an impact, then its pulse, with `runs` runs of the solver, or to
/// the tolerance of the case if `runs` is 0. The pulse begins at the measured onset, or later by the
/// coordinate `shift`.
Predict prediction_of(const Fit& fit, const ImpactMeasurement& measured, int runs,
                      std::optional<std::size_t> shift = {});
/// The same with the best shift between these bounds, s.
Settle settling_of(const Fit& fit, const ImpactMeasurement& measured, int runs, std::size_t shift,
                   double lowest, double highest);

/// Whether the model admits nothing beyond that bound of an unknown.
bool is_natural_bound(const Fit& fit, const Unknown& unknown, double bound);

/// The material with these values of the unknowns.
Material material_with(const Fit& fit, std::span<const double> values);

/// The impact of a measurement with the material of the fit and these values of the unknowns. Throws
/// std::invalid_argument if the impact lacks a quantity or the values make an impossible support.
ImpactCase impact_with(const Fit& fit, const ImpactMeasurement& measured, std::span<const double> values);

/// The acceleration as a smooth curve through the steps of the solver, since a polyline would jump when their
/// number changes. None if the pulse was cut off or is not finite.
std::optional<Pulse> smooth_pulse(const Solution& solution);

/// Mean magnitude of the strain rate while the strain moves, 1/s.
double mean_rate_of(const MaterialMeasurement& test);

}  // namespace dashpad::fit
