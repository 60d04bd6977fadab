#pragma once
/// The injury figures of a solved impact one by one, so that nothing is computed that nobody asked for.

#include <optional>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"
#include "injury/hic_search.hpp"
#include "injury/hump.hpp"
#include "result/summary_values.hpp"

namespace dashpad::study {

/// The same numbers and errors as injury_figures() of dashpad/injury/figures.hpp, of one solution after the
/// other.
class PulseFigures {
 public:
  /// Takes no memory once it has held a pulse as long.
  void take(const Solution& solution);
  /// False: the impactor did not leave the pad, or a value is not finite. Nothing may be asked then.
  [[nodiscard]] bool whole() const { return whole_; }

  EstimatedValue hic(double longest_window);
  EstimatedValue hic_d();
  EstimatedValue clip_3ms();
  EstimatedValue cumulative_3ms();
  EstimatedValue severity_index();
  EstimatedValue velocity_change();

 private:
  /// A pulse, and what several figures need of it.
  struct Sampled {
    Pulse pulse;
    std::optional<injury::Hump> hump;
    std::optional<double> scale;  ///< of the curve, once it is there
    injury::hic_search::Curve curve;

    void prepare();
    double hic(double longest_window);
  };
  template <class Figure>
  EstimatedValue with_error(Figure figure, double power);
  template <class ClipOf>
  EstimatedValue level_of(ClipOf clip_of);

  Sampled fine_, coarse_;
  bool has_coarse_ = false;
  double force_error_ = 0;
  bool whole_ = false;
  std::optional<EstimatedValue> whole_window_;  ///< HIC with a window that is no limit
  std::optional<EstimatedValue> clip_;          ///< of a hump: contiguous and cumulative are the same
};

}  // namespace dashpad::study
