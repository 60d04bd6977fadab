#include "fit/profile.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::fit {

namespace {

constexpr int most_refits = 40;
constexpr double precision = 5e-3;       ///< of the root of the rise over the threshold
constexpr double least_distance = 1e-7;  ///< of a coordinate
constexpr double better_by = 1e-2;       ///< of the threshold

/// Root of the rise of the misfit over the threshold: nearly even in the distance.
struct Rise {
  double distance = 0;
  double root = 0;
};

class Profiler {
 public:
  Profiler(const LeastSquares& problem, const Minimum& minimum, const ProfileRequest& request)
      : problem_(problem), minimum_(minimum), request_(request), last_(minimum.x) {
    held_.assign(problem.unknowns, false);
    held_[request.coordinate] = true;
  }

  ProfileEnd find() {
    const double at = minimum_.x[request_.coordinate];
    const double room = request_.side > 0 ? 1 - at : at;
    ProfileEnd end;
    if (room < least_distance) return end;
    Rise low;
    std::optional<Rise> high;  // without a root: there is no material
    bool barrier = false;
    double distance = std::clamp(request_.guess, least_distance, room);
    for (int refit = 0; refit < most_refits; ++refit) {
      const std::optional<double> root = rise_at(distance);
      if (better_) break;
      if (root && std::abs(*root - 1) < precision) {
        end.x = at + request_.side * distance;
        return end;
      }
      if (root && *root < 1) {
        if (distance >= room) return end;
        low = {distance, *root};
      } else {
        high = Rise{distance, root.value_or(0)};
        barrier = !root;
      }
      if (high && high->distance - low.distance < least_distance) break;
      distance = next(low, high, barrier, room);
    }
    if (better_)
      end.better = better_;
    else if (high && !barrier)
      end.x = at + request_.side * high->distance;
    return end;
  }

 private:
  static double next(const Rise& low, const std::optional<Rise>& high, bool barrier, double room) {
    if (!high) {
      const double factor = low.root > 0.05 ? std::min(1.05 / low.root, 3.0) : 3.0;
      return std::min(std::max(low.distance * factor, 1.05 * low.distance), room);
    }
    const double width = high->distance - low.distance;
    if (barrier) return low.distance + width / 2;
    const double straight = (1 - low.root) / (high->root - low.root);
    return low.distance + width * std::clamp(straight, 0.05, 0.95);
  }

  /// Nothing where no material was found.
  std::optional<double> rise_at(double distance) {
    const double place = std::clamp(minimum_.x[request_.coordinate] + request_.side * distance, 0.0, 1.0);
    std::vector<double> guess = minimum_.x;
    if (!request_.direction.empty())
      for (std::size_t i = 0; i < guess.size(); ++i)
        guess[i] = std::clamp(guess[i] + request_.side * distance * request_.direction[i], 0.0, 1.0);
    guess[request_.coordinate] = place;
    last_[request_.coordinate] = place;
    Minimum found = minimise(problem_, guess, coarse, held_);
    // The last place may be nearer, or the only one with a material.
    if (!found.converged) {
      const Minimum other = minimise(problem_, last_, coarse, held_);
      if (other.converged) found = other;
    }
    if (!found.converged) return std::nullopt;
    last_ = found.x;
    const double rise = (found.misfit - minimum_.misfit) / request_.threshold;
    if (rise < -better_by) better_ = found;
    return std::sqrt(std::max(rise, 0.0));
  }

  const LeastSquares& problem_;
  const Minimum& minimum_;
  const ProfileRequest& request_;
  std::vector<double> last_;
  std::vector<bool> held_;
  std::optional<Minimum> better_;
};

}  // namespace

ProfileEnd profile(const LeastSquares& problem, const Minimum& minimum, const ProfileRequest& request) {
  return Profiler(problem, minimum, request).find();
}

}  // namespace dashpad::fit
