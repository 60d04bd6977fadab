#pragma once
/// Least squares, the uncertainty of a minimum, and the search from the starts to the best minimum.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

// Least squares within bounds, their derivatives, and profile likelihood: how far a coordinate can move until
// the misfit, with the others refitted, has risen by a threshold.

/// Residuals over coordinates in [0, 1]; false where they cannot be evaluated. Several threads call it.
struct LeastSquares {
  std::size_t unknowns = 0;
  std::size_t residuals = 0;
  double step = 1e-4;  ///< step of a coordinate for derivatives
  std::function<bool(std::span<const double> x, std::span<double> residuals)> evaluate;
  /// Whether residuals need impacts, exact to some 1e-4: searches end earlier and use threads.
  bool takes_impacts = false;
  /// Coordinates that settle() sets to their best values unless held, instead of a search. May be empty.
  std::vector<bool> settles = {};
  std::function<bool(std::span<double> x, const std::vector<bool>& held, std::span<double> residuals)>
      settle = {};
};

/// The derivatives d residual / d x, a row per residual: central differences, or one-sided ones of second
/// order at a bound. False if the residuals cannot be evaluated.
bool derivatives(const LeastSquares& problem, std::span<const double> x, std::span<double> into);

struct Minimum {
  bool converged = false;
  std::string why_not;
  std::vector<double> x;
  double misfit = 0;      ///< sum of squares
  bool is_sound = false;  ///< converged, or out of iterations with a misfit that is not below the least one
};

/// The relative change of the misfit at which a search has converged: for comparisons, and for the result.
/// With impacts, whose misfit has a noise of up to 1e-4, they are at least that and a tenth of it.
inline constexpr double coarse = 1e-6, fine = 1e-10;
inline constexpr int max_iterations = 300;

/// Searches from a start by the method of Levenberg and Marquardt in [0, 1]; `held` coordinates stay.
Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance = fine,
                 const std::vector<bool>& held = {}, int iterations = max_iterations);

struct ProfileEnd {
  /// Absent if the misfit does not rise so far within the bounds, or within the range of valid materials.
  std::optional<double> x;
  bool is_rough = false;  ///< the refits ran out before it was as exact as asked for
  /// A better minimum, if one was met on the way.
  std::optional<Minimum> better;
};

struct ProfileRequest {
  std::size_t coordinate = 0;
  int side = 1;             ///< 1 upwards, -1 downwards
  double threshold = 3.84;  ///< rise of the misfit
  double guess = 0.1;       ///< first guess of the distance
  std::vector<double> direction =
      {};  ///< change of all coordinates along the profile, for first guesses; 1 for its own
};

/// Searches from a minimum for the end of an interval, to half a per cent of the distance, or two per cent
/// with impacts, in about ten refits that begin where the curvature at the minimum predicts the others.
ProfileEnd profile(const LeastSquares& problem, const Minimum& minimum, const ProfileRequest& request);

// The uncertainty of a minimum from the derivatives of the residuals there.
//
// With J the derivatives and r the residuals over their deviations, the errors of the coordinates have the
// covariance
//
//   scale H^-1 (sum over blocks of w_k J_k' J_k) H^-1,   H = J' J
//
// w_k = n / n_eff is 1 for independent errors, and (1 + rho) / (1 - rho) for errors along a curve whose
// neighbours are correlated by rho: the fit weighs them as if they were independent.
//
// From it follow the uncertainty of predictions and draws from the posterior's Laplace approximation.

/// Eigenvalues of a symmetric matrix, rising, and their directions of length 1.
struct PrincipalAxes {
  std::vector<double> values;
  std::vector<double> directions;  ///< one after the other

  [[nodiscard]] std::span<const double> direction(std::size_t k) const {
    return {directions.data() + k * values.size(), values.size()};
  }
};

/// `matrix` holds `size` rows of `size` numbers.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const double> matrix, std::size_t size);

/// The standard deviation along an axis of a covariance of coordinates in [0, 1]. Along a direction that the
/// data do not determine the distribution is uniform between the bounds.
[[nodiscard]] double deviation_along(const PrincipalAxes& axes, std::size_t k);

/// Lag-1 correlation of residuals along a curve, and how many independent ones they are worth.
struct Autocorrelation {
  double rho = 0;
  double effective_points = 0;
};
Autocorrelation autocorrelation_of(std::span<const double> residuals);

struct Uncertainty {
  /// The standard error of each coordinate; absent at a bound, and if it exceeds the width of the bounds.
  std::vector<std::optional<double>> error;
  std::vector<double> widening;    ///< factor on its variance from correlated residuals
  std::vector<double> covariance;  ///< row by row; rows of coordinates at a bound are 0
  std::vector<std::pair<std::size_t, std::size_t>> strongly_correlated;
  std::vector<double> correlations;  ///< correlations of these pairs
  std::vector<std::vector<std::size_t>> flat_directions;
  std::vector<double> precision;        ///< inverse covariance of all coordinates, row by row
  std::vector<double> gradient;         ///< gradient of half the misfit over the scale
  std::vector<Autocorrelation> blocks;  ///< autocorrelation along the curve of each block
};

/// Finds the uncertainty at a minimum. `scale` multiplies variances. False without derivatives.
bool find_uncertainty(const Problem& problem, const LeastSquares& residuals, std::span<const double> x,
                      double scale, Uncertainty& into);

bool is_at_bound(double x);

/// Standard deviations of the figures of an impact at the minimum `x`: the root of the sum of squared half
/// differences between both ends of each principal axis of the covariance. Along directions that the data do
/// not determine the distribution is uniform between the bounds. Absent if the figure is missing there.
std::vector<std::optional<double>> prediction_deviations(const Fit& fit, const ImpactMeasurement& impact,
                                                         const Problem& problem, std::span<const double> x,
                                                         const Uncertainty& uncertainty);

/// Draws from a normal distribution about a minimum in [0, 1]^n with this precision (row by row) and
/// gradient, cut off at the bounds, by hit and run along the eigenvectors of the precision. Coordinates that
/// the data do not determine are uniform between their bounds.
std::vector<std::vector<double>> laplace_sample(std::span<const double> minimum,
                                                std::span<const double> precision,
                                                std::span<const double> gradient, std::size_t count,
                                                std::uint64_t seed);

// The search from the starts to the best minimum, and the session in which it runs.

/// The session of a fit: request to stop, progress, and finished pieces of work. Safe for several threads.
class Session {
 public:
  /// Reads what is kept. Throws as check_state() does.
  Session(const Fit& fit, const RunOptions& options);

  [[nodiscard]] bool is_stopped() const { return options_.stop != nullptr && *options_.stop; }
  void throw_if_stopped() const;

  /// A kind of work begins, in so many pieces.
  void begin(const char* what, std::size_t pieces);

  /// The piece of that name, kept from before or computed and kept now. The names of a fit are always the
  /// same, and pieces depend only on the fit and on earlier pieces.
  Minimum piece(const std::string& name, const std::function<Minimum()>& compute);
  ProfileEnd piece(const std::string& name, const std::function<ProfileEnd()>& compute);

 private:
  /// Pieces as JSON texts, by their names.
  template <class Result>
  Result recalled(const std::string& name, const std::function<Result()>& compute);
  void finished(const std::string& name, const std::string& text);

  const RunOptions& options_;
  mutable std::mutex mutex_;  ///< guards all members below
  std::map<std::string, std::string> kept_;
  const char* what_ = "";
  std::size_t done_ = 0, pieces_ = 0;
};

/// The problem as searches see it. They end soon once the session is stopped.
LeastSquares least_squares_of(const Problem& problem, const Session& session,
                              std::atomic<std::size_t>& evaluations);

/// The best of the starts that converged, or the best of all. The report gets how many came to it.
Minimum search(const Fit& fit, const Problem& problem, const LeastSquares& residuals, Session& session,
               FitReport& report);

struct Solved {
  Minimum minimum;
  Uncertainty uncertainty;
  std::vector<ProfileEnd> below, above;  ///< ends for each coordinate
};

/// Proceeds from a minimum to the best one that its profiles meet, with the profiles there; report.converged
/// tells whether it is a minimum. Noise that is not stated is estimated and put into the problem.
Solved determine(Problem& problem, const LeastSquares& residuals, Minimum minimum, Session& session,
                 FitReport& report);

}  // namespace dashpad::fit
