#pragma once
/// A function of the strain as cubics over cells of equal width in the square root of the strain.
///
/// Such cells are narrow at strain zero, where curves of foams are steep. The cubics match values and slopes
/// of the function at the ends of their cells; slopes are central differences of fourth order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dashpad {

/// Place of a root of a strain in the cells.
struct CellPlace {
  std::size_t cell = 0;
  double t = 0;  ///< place within the cell, 0 to 1
};

/// Cells from strain 0 to `last_strain`.
struct Cells {
  static constexpr std::size_t count = 256;
  double width = 1;      ///< width of a cell in the root of the strain
  double per_width = 1;  ///< 1 / width

  Cells() = default;
  explicit Cells(double last_strain)
      : width(std::sqrt(last_strain) / count), per_width(count / std::sqrt(last_strain)) {}

  [[nodiscard]] CellPlace place(double root) const {
    const double x = root * per_width;
    // NaN stays NaN, in the last cell.
    const auto cell = x < count ? static_cast<std::int32_t>(x) : static_cast<std::int32_t>(count - 1);
    return {static_cast<std::size_t>(cell), x - cell};
  }
};

class CellTable {
 public:
  /// Fills the table with f(root of the strain), evaluated slightly beyond both ends of the cells, too.
  template <class F>
  void fill(const Cells& cells, F&& f) {
    cubics_.resize(Cells::count);
    const double h = cells.width;
    const auto slope = [&](double x) {
      const double d = h / 4;
      return h * (8 * (f(x + d) - f(x - d)) - (f(x + 2 * d) - f(x - 2 * d))) / (12 * d);
    };
    double value = f(0.0);
    double rise = slope(0);
    for (std::size_t i = 0; i < Cells::count; ++i) {
      const double x = h * static_cast<double>(i + 1);
      const double next = f(x);
      const double next_rise = slope(x);
      cubics_[i] = {value, rise, 3 * (next - value) - 2 * rise - next_rise,
                    2 * (value - next) + rise + next_rise};
      value = next;
      rise = next_rise;
    }
  }

  using Cubic = std::array<double, 4>;
  [[nodiscard]] const Cubic& cubic(std::size_t cell) const { return cubics_[cell]; }
  /// The coefficients as rows of four numbers for each cell.
  [[nodiscard]] const double* rows() const { return cubics_.empty() ? nullptr : cubics_.front().data(); }
  [[nodiscard]] double at(CellPlace place) const {
    const Cubic& c = cubics_[place.cell];
    return c[0] + place.t * (c[1] + place.t * (c[2] + place.t * c[3]));
  }

 private:
  std::vector<Cubic> cubics_;
};

}  // namespace dashpad
