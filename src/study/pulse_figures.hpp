#pragma once
/// The injury figures of a solved impact one by one, so that nothing is computed that nobody asked for.

#include <optional>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/hic.hpp"
#include "dashpad/injury/pulse.hpp"

namespace dashpad::study {

struct FigureWithError {
  double value = 0;
  double error = 0;  ///< relative
};

/// The same numbers and errors as injury_figures() of dashpad/injury/figures.hpp.
class PulseFigures {
 public:
  /// Not whole: the impactor did not leave the pad, or a value is not finite. Nothing may be asked then.
  explicit PulseFigures(const Solution& solution);
  [[nodiscard]] bool whole() const { return whole_; }

  FigureWithError hic(double longest_window);
  FigureWithError hic_d();
  FigureWithError contiguous_3ms();
  FigureWithError cumulative_3ms();
  FigureWithError severity_index();
  FigureWithError velocity_change();

 private:
  template <class Figure>
  FigureWithError with_error(Figure figure, double power);

  Pulse pulse_, coarser_;
  double force_error_ = 0;
  bool whole_ = false;
  std::optional<FigureWithError> whole_window_;  ///< HIC with a window that is no limit
};

}  // namespace dashpad::study
