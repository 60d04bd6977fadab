#include "dashpad/output/deck/exports.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

namespace dashpad::output {

namespace {

struct TimeCurve {
  const char* name;
  const char* si_unit;
  std::vector<double> History::*values;
};

constexpr TimeCurve time_curves[] = {
    {"force", "N", &History::force},
    {"acceleration", "m/s2", &History::acceleration},
    {"velocity", "m/s", &History::velocity},
    {"motion", "m", &History::motion},
    {"penetration", "m", &History::penetration},
};

constexpr const char* loading = "loading";
constexpr const char* unloading = "unloading";

/// Builds a curve from points in the order of x, skipping those that do not lie ahead of the last one.
class Builder {
 public:
  Builder(Curve empty, double largest_x) : curve_(std::move(empty)), gap_(smallest_gap * largest_x) {}

  void add(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    if (!curve_.x.empty() && !(x - curve_.x.back() >= gap_ && x > curve_.x.back())) return;
    curve_.x.push_back(x);
    curve_.y.push_back(y);
  }

  /// Adds the last point, replacing points that are too near.
  void add_last(double x, double y) {
    while (curve_.x.size() > 1 && x - curve_.x.back() < gap_) {
      curve_.x.pop_back();
      curve_.y.pop_back();
    }
    add(x, y);
  }

  /// Moves the last point back to make room at x.
  void leave_room_at(double x) {
    if (curve_.x.size() < 2 || x - curve_.x.back() >= gap_) return;
    const double before = curve_.x[curve_.x.size() - 2];
    curve_.x.back() = x - std::min(widest_fall * x, (x - before) / 2);
  }

  [[nodiscard]] Curve take() { return std::move(curve_); }

 private:
  Curve curve_;
  double gap_;
};

Curve over_time(const TimeCurve& kind, const History& history) {
  Curve empty{kind.name, {"time", "s"}, {kind.name, kind.si_unit}, {}, {}};
  const std::vector<double>& values = history.*kind.values;
  if (values.size() != history.size()) throw std::invalid_argument("history: " + empty.name + " has gaps");
  if (history.time.empty()) return empty;
  Builder builder(std::move(empty), history.time.back());
  for (std::size_t i = 0; i + 1 < history.size(); ++i) builder.add(history.time[i], values[i]);
  builder.add_last(history.time.back(), values.back());
  return builder.take();
}

Curve empty_branch(const char* name) { return {name, {"penetration", "m"}, {"force", "N"}, {}, {}}; }

/// The index at which the largest penetration is first reached.
std::size_t deepest(const History& history) {
  if (history.force_of_pad().size() != history.size() || history.penetration.size() != history.size())
    throw std::invalid_argument("history: penetration or force has gaps");
  const auto& y = history.penetration;
  return static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
}

/// A stretch between two kept points, with the point furthest from the line between them.
struct Stretch {
  std::size_t first, last, furthest;
  double error;
  bool operator<(const Stretch& other) const { return error < other.error; }
};

Stretch stretch(const Curve& curve, std::size_t first, std::size_t last) {
  Stretch of{first, last, first, 0};
  const double slope = (curve.y[last] - curve.y[first]) / (curve.x[last] - curve.x[first]);
  for (std::size_t i = first + 1; i < last; ++i) {
    const double error = std::abs(curve.y[first] + slope * (curve.x[i] - curve.x[first]) - curve.y[i]);
    if (error > of.error) of.furthest = i, of.error = error;
  }
  return of;
}

}  // namespace

const std::vector<std::string>& curve_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const TimeCurve& kind : time_curves) all.emplace_back(kind.name);
    all.insert(all.end(), {loading, unloading});
    return all;
  }();
  return names;
}

Curve curve(const std::string& name, const Solution& solution) {
  for (const TimeCurve& kind : time_curves)
    if (name == kind.name) return over_time(kind, solution.history);
  if (name == loading) return loading_branch(solution.history);
  if (name == unloading) return unloading_branch(solution);
  throw std::invalid_argument("unknown curve \"" + name + "\"");
}

Curve loading_branch(const History& history) {
  const std::size_t last = deepest(history);
  if (history.size() == 0) return empty_branch(loading);
  const double largest = history.penetration[last];
  Builder builder(empty_branch(loading), largest);
  builder.add(0, 0);
  for (std::size_t i = 0; i < last; ++i) builder.add(history.penetration[i], history.force_of_pad()[i]);
  builder.add_last(largest, history.force_of_pad()[last]);
  return builder.take();
}

Curve unloading_branch(const Solution& solution) {
  const History& history = solution.history;
  const std::size_t first = deepest(history);
  if (history.size() == 0 || !solution.summary.release) return empty_branch(unloading);
  const double largest = history.penetration[first];
  Builder builder(empty_branch(unloading), largest);
  builder.add(0, 0);
  // On a rigid support a rigid foam is released at the largest force, since it does not follow the impactor.
  builder.add(history.penetration.back(), 0);
  for (std::size_t i = history.size() - 1; i > first; --i)
    builder.add(history.penetration[i], history.force_of_pad()[i]);
  builder.leave_room_at(largest);
  builder.add_last(largest, history.force_of_pad()[first]);
  return builder.take();
}

ThinnedCurve thinned(const Curve& curve, std::size_t max_points) {
  if (max_points < 2) throw std::invalid_argument("a curve needs at least 2 points");
  if (curve.size() <= max_points) return {curve, 0};
  std::priority_queue<Stretch> stretches;
  stretches.push(stretch(curve, 0, curve.size() - 1));
  std::vector<std::size_t> kept{0, curve.size() - 1};
  while (kept.size() < max_points && stretches.top().error > 0) {
    const Stretch worst = stretches.top();
    stretches.pop();
    kept.push_back(worst.furthest);
    stretches.push(stretch(curve, worst.first, worst.furthest));
    stretches.push(stretch(curve, worst.furthest, worst.last));
  }
  std::ranges::sort(kept);
  ThinnedCurve result{{curve.name, curve.abscissa, curve.ordinate, {}, {}}, stretches.top().error};
  for (const std::size_t i : kept) {
    result.curve.x.push_back(curve.x[i]);
    result.curve.y.push_back(curve.y[i]);
  }
  return result;
}

}  // namespace dashpad::output
