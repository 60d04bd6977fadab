#pragma once
/// Critical fall height from measured drops: where the figures of a surface reach the limits of a standard.
///
/// For each limit L, ln f = c0 + c1 x + c2 x^2 with x = ln(h / h0) is fitted to the drops of one place by
/// least squares (docs/fall-height.md); the height is where the curve first meets ln L. Of several limits and
/// places the lowest height counts.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::fall_height {

/// A column of the table that is no number of the drop, and its text: "position", "centre".
using Remark = std::pair<std::string, std::string>;

struct Drop {
  double height = 0;                 ///< m, more than 0
  std::vector<double> figures = {};  ///< by criteria of the standard, SI, more than 0; NaN for none
  std::vector<double> doubts = {};   ///< of the instrument: relative, k = 2, by criteria
  int number = 0;                    ///< among the drops of one place from one height, from 1
  std::string pulse = {};            ///< file of the measured pulse; empty if the table has the figures
  int line = 0;                      ///< in the table
  std::vector<Remark> remarks = {};
  std::vector<Flag> flags = {};  ///< of its pulse
};

struct DropTable {
  std::vector<Drop> drops = {};
  /// Uncertainty of the accelerometer: relative, k = 2; absent if not stated.
  std::optional<double> calibration = {};
};

/// Reads a table of drops (CSV): drop_height, and either the figures that the standard limits (hic_unlimited
/// or hic, peak_acceleration or gmax, ...) or the file of a pulse, beside the table; drop, its number at one
/// height, by default in the order of the table; all other columns are remarks. At least one row; all faults
/// at once.
input::Reading<DropTable> read_drops(const std::filesystem::path& file, const injury::Standard& standard);

/// A place of the curve: a drop, or the mean of those that the standard counts.
struct Point {
  double height = 0, value = 0;
};

/// A curve through points in logarithms.
struct Curve {
  int terms = 0;      ///< 2: a power of the height; 3: one that changes with it
  double middle = 0;  ///< h0, m: the geometric mean of the heights
  std::array<double, 3> coefficients{};
  std::array<std::array<double, 3>, 3> cofactors{};  ///< (X'X)^-1
  double deviation = 0;     ///< s of ln f about the curve; 0 without degrees of freedom
  std::size_t freedom = 0;  ///< points less terms

  /// The figure at a height, SI.
  [[nodiscard]] double at(double height) const;
  /// Half the width of the 95 % interval of ln f for the curve there, by Student's t; infinite without
  /// degrees of freedom.
  [[nodiscard]] double half_width(double height) const;
};

/// The least-squares curve: three terms from six points at four heights on, or from five if the third is
/// significant (95 %); else two. Absent for points at fewer than two heights.
std::optional<Curve> fitted(std::span<const Point> points);

/// The height of one limit at one place.
struct Crossing {
  std::size_t criterion = 0;
  std::vector<Point> points = {};  ///< by height
  /// Those that the curve is fitted to: near the height if they are enough there, else all.
  std::vector<Point> near = {};
  std::optional<Curve> curve = {};
  std::optional<double> height = {};  ///< m; absent if the curve meets the limit nowhere near the drops
  /// 95 %, by drops and instrument; an end that no height near the drops has is 0 or infinite. Absent without
  /// degrees of freedom.
  std::optional<std::pair<double, double>> interval = {};
  double doubt = 0;          ///< of the instrument: relative, k = 2, common to all drops
  bool is_kept = false;      ///< by some point
  bool is_exceeded = false;  ///< by some point
  /// Heights, m, of the highest point up to the height that keeps the limit, and of the lowest from the
  /// height on that exceeds it; without one, of the first or last point, if it lies at most a tenth on the
  /// other side.
  std::optional<double> below = {};
  std::optional<double> above = {};

  /// Whether points that keep the limit and points that exceed it enclose the height.
  [[nodiscard]] bool is_enclosed() const { return below && above; }
  /// Half the width of the 95 % interval of ln f at a height, by curve and instrument. Needs a curve.
  [[nodiscard]] double half_width(double at) const;
};

/// Whether a column of that header tells places apart: "Position", "surface", "temperature [degC]", ...
bool tells_places_apart(std::string_view header);

/// The order in which the lowest height is found: an enclosed height, the lowest point if all exceed the
/// limit, else infinite; and the highest point, beyond which the last is.
std::pair<double, double> order_of(const Crossing& crossing);

/// Drops on one place: the same surface, position and temperature.
struct Place {
  std::vector<Remark> remarks = {};  ///< those that tell it from other places
  std::vector<Drop> drops = {};      ///< by height, then number
  std::vector<Crossing> crossings = {};
  /// The one with the lowest height, among those of the limits that some drop has a figure for.
  std::size_t lowest = 0;
  std::vector<Flag> flags = {};

  [[nodiscard]] const Crossing& decides() const { return crossings[lowest]; }
};

struct Answer {
  injury::Standard standard = {};
  std::vector<Place> places = {};
  std::size_t lowest = 0;  ///< the place with the lowest height
  std::vector<Flag> reservations = {};
  std::vector<Remark> common = {};  ///< remarks that are the same for all drops

  /// The lowest height.
  [[nodiscard]] const Crossing& decides() const { return places[lowest].decides(); }
  /// Whether the height is enclosed, has an interval with two ends, and nothing is in doubt about drops and
  /// places.
  [[nodiscard]] bool is_sure() const;
};

/// The lowest and the greatest height of all drops, m.
std::pair<double, double> heights_of(const Answer& answer);

/// The place with the lowest height for a limit.
const Place& lowest_for(const Answer& answer, std::size_t criterion);

/// Evaluates drops, at least one, by a standard that has criteria.
///
/// Example:
/// \code
/// #include "dashpad/input/standard_file.hpp"
/// const auto standard = dashpad::input::read_standard("standards/en-1177.toml").value();
/// const auto drops = dashpad::fall_height::read_drops("drops.csv", standard).value();
/// const auto answer = dashpad::fall_height::evaluated(drops, standard);
/// if (answer.decides().height) std::printf("%.2f m\n", *answer.decides().height);
/// \endcode
Answer evaluated(const DropTable& table, const injury::Standard& standard);

}  // namespace dashpad::fall_height
