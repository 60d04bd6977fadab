#include "injury/coarser_run.hpp"

#include <cstddef>
#include <vector>

namespace dashpad::injury {

double chord_error(const Pulse& pulse, const Clip& clip) {
  if (!(clip.level > 0)) return 0;
  const std::vector<double>&t = pulse.time, &a = pulse.acceleration;
  const auto bend = [&](std::size_t i) {
    if (i == 0 || i + 1 >= t.size()) return 0.0;
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    if (!(before > 0 && after > 0)) return 0.0;
    return 2 * std::abs((a[i + 1] - a[i]) / after - (a[i] - a[i - 1]) / before) / (before + after);
  };
  const auto first = std::ranges::upper_bound(t, clip.begin);
  double error = 0;
  for (auto i = std::size_t(std::max(first - t.begin(), std::ptrdiff_t{1})); i < t.size(); ++i) {
    const double from = std::abs(a[i - 1]), to = std::abs(a[i]), length = t[i] - t[i - 1];
    if (std::min(from, to) <= clip.level && clip.level <= std::max(from, to))
      error = std::max(error, length * length * std::max(bend(i - 1), bend(i)) / 8);
    if (t[i] >= clip.end) break;
  }
  return error / clip.level;
}

}  // namespace dashpad::injury
