#pragma once
/// The responses that a study keeps of each impact: figures of the summary and of the pulse, by name.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad::study {

/// The quantities of the table of results that a study may keep, in SI; those of a pulse need the history.
const std::vector<ResultQuantity>& response_kinds();

/// A response of a study. Of a series of blows it is that of the last one computed, unless the name says of
/// which: "peak_acceleration.blow_1", or the mean "peak_acceleration.mean_2_5".
struct Response {
  const ResultQuantity* kind;
  int first_blow = 0, last_blow = 0;  ///< from 1; 0: the last one computed
};
/// The response of that name, or nothing.
std::optional<Response> find_response(const std::string& name);
/// Its quantity, or null.
const ResultQuantity* find_response_kind(const std::string& name);
/// "Peak acceleration", "Peak acceleration, mean of blows 2 to 5"; the name itself where it is no response.
std::string response_title(const std::string& name);

/// Whether an impact can have this value, SI: finite, and not below zero unless the response has a sign.
bool is_possible(const ResultQuantity& kind, double value);

/// Whether a good solution of that status has the response. An impactor that stays on the pad has no end of
/// contact. Injury figures count as promised, although a pulse that is not whole has none.
bool has_response(const ResultQuantity& kind, Status status);

/// The responses that cost nothing beyond the solution: all but those of the pulse.
std::vector<std::string> default_responses();

/// The ways in which a row went beyond the tests of its material, to be added up.
enum Extrapolated : unsigned {
  extrapolated_untold = 1,  ///< rows of 0.1.0, which do not say by what
  extrapolated_strain = 2,
  extrapolated_rate = 4,
  extrapolated_otherwise = 8,
};

/// The outcome of a row.
struct Outcome {
  Status status = Status::not_run;  ///< not_run: the case breaks a rule; all values are NaN
  unsigned extrapolated = 0;        ///< a sum of Extrapolated; 0 for none
  bool bottomed = false;
  /// The largest error estimate of the figures kept, as in ErrorEstimates and InjuryFigures::Errors; none for
  /// the peak strain rate. Infinite if a pulse has too few samples for an estimate.
  double error = 0;
  /// NaN for a figure that the impact lacks (rebound speed without release, peak force after bottoming out on
  /// a rigid support, injury figures of an incomplete pulse) or that no impact can have (is_possible()).
  std::vector<double> values;
};

class PulseFigures;

/// Fills outcomes with the responses of these names only. It reuses its memory; each thread needs its own.
class ResponseReader {
 public:
  /// Throws std::invalid_argument for a name that is no response.
  explicit ResponseReader(std::span<const std::string> names);
  ~ResponseReader();
  ResponseReader(ResponseReader&&) noexcept;
  ResponseReader& operator=(ResponseReader&&) noexcept;

  /// Whether a response is of other blows than the last: all blows of a series must be read then.
  [[nodiscard]] bool needs_blows() const { return needs_blows_; }
  /// Reads a solution; if needs_blows(), those of a series one after the other into the same outcome.
  void operator()(const Solution& solution, Outcome& outcome);

 private:
  struct Wanted {
    std::size_t number = 0;  ///< in response_kinds()
    Response of;
  };
  std::vector<Wanted> wanted_;
  std::vector<double> sums_;  ///< over the blows so far
  bool needs_blows_ = false;
  std::unique_ptr<PulseFigures> pulse_;  ///< present if a figure of the pulse is asked for
};

}  // namespace dashpad::study
