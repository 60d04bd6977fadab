#include "fit/determine.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::fit {
namespace {

/// The accuracy of the root of the rise over the threshold. With impacts each refit costs hundreds of them.
constexpr double close_enough = 5e-3, close_enough_with_impacts = 2e-2;
constexpr int max_refits = 40, max_refits_with_impacts = 12;
constexpr int iterations_with_impacts = 12;  ///< iterations of a refit
/// A guess beyond this share of the room is tried at the bound first: most ends there are open.
constexpr double near_bound = 0.6;
constexpr double min_distance = 1e-7;  ///< least distance of a coordinate
constexpr double better_by = 1e-2;     ///< share of the threshold

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
    if (room < min_distance) return end;
    Rise low;
    std::optional<Rise> high;  // without a root if there is no material
    bool barrier = false;
    double distance = std::clamp(request_.guess, min_distance, room);
    if (distance > near_bound * room) distance = room;
    const int most = problem_.takes_impacts ? max_refits_with_impacts : max_refits;
    int refit = 0;
    for (; refit < most; ++refit) {
      const std::optional<double> root = rise_at(distance);
      if (better_) break;
      if (root && std::abs(*root - 1) < (problem_.takes_impacts ? close_enough_with_impacts : close_enough)) {
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
      if (high && high->distance - low.distance < min_distance) break;
      distance = next(low, high, barrier, room);
    }
    end.is_rough = refit == most;
    if (better_)
      end.better = better_;
    else if (high && !barrier)
      end.x = at + request_.side * (end.is_rough ? distance : high->distance);
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

  /// With impacts a refit that ran out of iterations counts; its misfit is slightly too high.
  [[nodiscard]] bool is_good(const Minimum& refit) const {
    return problem_.takes_impacts ? refit.is_sound : refit.converged;
  }

  /// The root of the rise at a distance; none if no material was found there.
  std::optional<double> rise_at(double distance) {
    const double place = std::clamp(minimum_.x[request_.coordinate] + request_.side * distance, 0.0, 1.0);
    std::vector<double> guess = minimum_.x;
    if (!request_.direction.empty())
      for (std::size_t i = 0; i < guess.size(); ++i)
        guess[i] = std::clamp(guess[i] + request_.side * distance * request_.direction[i], 0.0, 1.0);
    guess[request_.coordinate] = place;
    last_[request_.coordinate] = place;
    const auto refitted = [&](const std::vector<double>& from) {
      return minimise(problem_, from, coarse, held_,
                      problem_.takes_impacts ? iterations_with_impacts : max_iterations);
    };
    Minimum found = refitted(guess);
    // The last place may be nearer, or the only one with a material.
    if (!is_good(found)) {
      const Minimum other = refitted(last_);
      if (is_good(other)) found = other;
    }
    if (!is_good(found)) return std::nullopt;
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
