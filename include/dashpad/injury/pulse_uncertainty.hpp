#pragma once
/// What sampling, filter and calibration leave open of the figures of a measured pulse.
///
/// Components and their sum are expanded uncertainties, k = 2 (some 95 %), relative to the figure. A bound b
/// on what sampling or a filter does counts as even between -b and b: its standard uncertainty is b / sqrt(3)
/// (GUM, JCGM 100:2008, 4.3.7).

#include <optional>
#include <string>
#include <vector>

#include "dashpad/result/result_quantity.hpp"

namespace dashpad::injury {

struct PulseReport;

struct FigureUncertainty {
  const ResultQuantity* quantity;
  std::optional<double> sampling = {};     ///< absent for a peak at an end, and for fewer than four samples
  std::optional<double> filter = {};       ///< absent where none was applied: what was before is not known
  std::optional<double> calibration = {};  ///< absent where nobody said it

  /// Root of the sum of the squares of those that are known.
  [[nodiscard]] double combined() const;
};

struct MeasurementUncertainty {
  std::optional<double> calibration = {};  ///< as stated: of an acceleration, expanded, relative
  std::string compared_with = {};          ///< "CFC1000" or "no filter", for the filter; empty without one
  std::vector<FigureUncertainty>
      figures;  ///< peak, HIC, clips, velocity change; those of which something is known
};

/// A calibration is at most so much.
inline constexpr double most_calibration = 0.5;

/// Of the figures of `report`. `calibration`: of an acceleration, expanded, in (0, most_calibration), alike
/// in all directions.
///
/// Sampling of the peak: a smooth pulse, a parabola through the largest sample and its neighbours, lies at
/// most |y(-1) - 2 y(0) + y(1)| / 8 above the largest sample. Of the others: 4/3 of what samples between the
/// given ones, by a cubic through four, do to them, since straight lines err by the square of the interval.
/// Filter: what the next higher class leaves of the figure that the chosen one takes away; where there is
/// none or the samples are too few for it, what no filter leaves. Calibration: to the power that the
/// acceleration has in the figure, 2.5 of HIC.
MeasurementUncertainty measurement_uncertainty(const PulseReport& report, std::optional<double> calibration);

}  // namespace dashpad::injury
