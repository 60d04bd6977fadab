#include "impact/figures.hpp"

#include <algorithm>
#include <array>

#include "model/root.hpp"

namespace dashpad {
namespace {

/// The parabola through three points, and its slope.
struct Parabola {
  std::array<double, 3> t{}, y{};
  Parabola(const std::vector<double>& time, const std::vector<double>& value, std::size_t first)
      : t{time[first], time[first + 1], time[first + 2]},
        y{value[first], value[first + 1], value[first + 2]} {}
  [[nodiscard]] double first_difference() const { return (y[1] - y[0]) / (t[1] - t[0]); }
  [[nodiscard]] double curvature() const {
    return ((y[2] - y[1]) / (t[2] - t[1]) - first_difference()) / (t[2] - t[0]);
  }
  [[nodiscard]] double at(double x) const {
    return y[0] + (x - t[0]) * (first_difference() + curvature() * (x - t[1]));
  }
  [[nodiscard]] double slope(double x) const {
    return first_difference() + curvature() * (2 * x - t[0] - t[1]);
  }
};

/// Integral of F dY over [from, to]; Simpson's rule is exact for the product of a parabola and a slope.
double work_of(const Parabola& f, const Parabola& y, double from, double to) {
  const double middle = (from + to) / 2;
  return (to - from) / 6 *
         (f.at(from) * y.slope(from) + 4 * f.at(middle) * y.slope(middle) + f.at(to) * y.slope(to));
}

template <class Visit>
void for_each_stretch(const Track& track, Visit&& visit) {
  for (std::size_t k = 0; k < track.stretch_starts.size(); ++k) {
    const std::size_t first = track.stretch_starts[k];
    const std::size_t last =
        k + 1 < track.stretch_starts.size() ? track.stretch_starts[k + 1] : track.size() - 1;
    if (last > first) visit(first, last);
  }
}

/// The force between entry i and the next of a track: the mean of the two parabolas through both and one more
/// entry of the same stretch, or the only one, or a line.
class ForceCurve {
 public:
  ForceCurve(const Track& track, std::size_t i)
      : time_(track.history.time), force_(track.history.force), i_(i) {
    for_each_stretch(track, [&](std::size_t first, std::size_t last) {
      if (i < first || i >= last) return;
      behind_ = i > first;
      ahead_ = i + 2 <= last;
    });
  }
  [[nodiscard]] double at(double t) const {
    const auto with = [&](std::size_t first) { return Parabola(time_, force_, first).at(t); };
    if (behind_ && ahead_) return (with(i_ - 1) + with(i_)) / 2;
    if (behind_ || ahead_) return with(behind_ ? i_ - 1 : i_);
    return force_[i_] + (force_[i_ + 1] - force_[i_]) * (t - time_[i_]) / (time_[i_ + 1] - time_[i_]);
  }

 private:
  const std::vector<double>& time_;
  const std::vector<double>& force_;
  std::size_t i_;
  bool behind_ = false;
  bool ahead_ = false;
};

/// The moment between entry i and the next at which the force, above `level` at i, falls below it, N.
Moment where_force_falls_below(double level, const Track& track, std::size_t i, const Impactor& impactor) {
  const History& h = track.history;
  const ForceCurve force(track, i);
  constexpr int bits = 40;
  const RootBracket found = narrowed(
      {.low = h.time[i],
       .high = h.time[i + 1],
       .f_low = h.force[i] - level,
       .f_high = h.force[i + 1] - level},
      [&](double t) { return force.at(t) - level; }, bits);
  const double time = (found.low + found.high) / 2;
  const double duration = time - h.time[i];
  const double impulse = duration / 6 * (h.force[i] + 4 * force.at(time - duration / 2) + force.at(time));
  return {time, h.velocity[i] - impulse / impactor.mass + impactor.gravity * duration};
}

/// Integral of a force over a displacement, J, both given at the entries of a track.
double work_of(const Track& track, const std::vector<double>& force, const std::vector<double>& way) {
  const std::vector<double>& time = track.history.time;
  double sum = 0;
  for_each_stretch(track, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto with = [&](std::size_t start) {
        return work_of(Parabola(time, force, start), Parabola(time, way, start), time[i], time[i + 1]);
      };
      const bool behind = i > first;
      const bool ahead = i + 2 <= last;
      if (behind && ahead)
        sum += (with(i - 1) + with(i)) / 2;
      else if (behind || ahead)
        sum += with(behind ? i - 1 : i);
      else
        sum += (force[i] + force[i + 1]) / 2 * (way[i + 1] - way[i]);
    }
  });
  return sum;
}

/// Relative difference below which values count as equal.
constexpr double plateau = 1e-12;

struct Peak {
  double time = 0;
  double value = 0;
};

/// The peak of values at the entries of a track.
Peak peak_of(const std::vector<double>& values, const Track& track) {
  const std::vector<double>& times = track.history.time;
  Peak peak;
  for_each_stretch(track, [&](std::size_t first, std::size_t last) {
    std::size_t top = first;
    for (std::size_t i = first; i <= last; ++i)
      if (values[i] > values[top]) top = i;
    Peak here{times[top], values[top]};
    // On a plateau the peak is at an entry.
    const bool is_peak = top > first && top < last && values[top + 1] < (1 - plateau) * values[top];
    if (is_peak) {
      const Parabola p(times, values, top - 1);
      if (p.curvature() < 0) {
        here.time =
            std::clamp(here.time - p.slope(here.time) / (2 * p.curvature()), times[top - 1], times[top + 1]);
        here.value = p.at(here.time);
      }
    }
    if (here.value > peak.value) peak = here;
  });
  return peak;
}

}  // namespace

void read_peaks(const Track& track, Figures& figures) {
  const History& h = track.history;
  const Peak force = peak_of(h.force, track);
  figures.peak_force = force.value;
  figures.time_of_peak_force = force.time;
  if (!h.transmitted_force.empty()) {
    figures.peak_transmitted = peak_of(h.transmitted_force, track).value;
    figures.peak_deflection = peak_of(h.support_deflection, track).value;
  }
  figures.peak_penetration = *std::max_element(h.penetration.begin(), h.penetration.end());
  // An impactor that leaves a pad on a free body may move on behind it forever.
  const auto left =
      figures.release ? std::upper_bound(h.time.begin(), h.time.end(), figures.release->time) : h.time.end();
  figures.peak_motion = *std::max_element(h.motion.begin(), h.motion.begin() + (left - h.time.begin()));
  for (std::size_t i = 1; i < h.size(); ++i) {
    if (!(h.velocity[i - 1] > 0 && h.velocity[i] <= 0)) continue;
    // The velocity crosses zero in the step: cubic through motion and velocity of both ends.
    const double step = h.time[i] - h.time[i - 1];
    const double share = h.velocity[i - 1] / (h.velocity[i - 1] - h.velocity[i]);
    const double u = share, v = 1 - share;
    const double motion = h.motion[i - 1] * v * v * (1 + 2 * u) + h.motion[i] * u * u * (1 + 2 * v) +
                          step * u * v * (h.velocity[i - 1] * v - h.velocity[i] * u);
    figures.peak_motion = std::max(figures.peak_motion, motion);
  }
}

void read_weight(const Track& track, const Impactor& impactor, Figures& figures) {
  const History& h = track.history;
  const double weight = impactor.mass * standard_gravity;
  std::size_t i = 1;
  while (i < h.size() && !(h.velocity[i] < 0 && h.force[i] < weight)) ++i;
  if (i == h.size()) {
    figures.force_below_weight = figures.release;
    return;
  }
  if (h.force[i - 1] <= weight) {
    // The force is below the weight from the start of the rebound.
    const double v = h.velocity[i - 1];
    const double share = v > 0 ? v / (v - h.velocity[i]) : 0;
    figures.force_below_weight =
        Moment{h.time[i - 1] + share * (h.time[i] - h.time[i - 1]), std::min(v, 0.0)};
    return;
  }
  figures.force_below_weight = where_force_falls_below(weight, track, i - 1, impactor);
}

void read_contact_end(const Track& track, const Impactor& impactor, Figures& figures) {
  figures.contact_end.reset();
  if (figures.ending != Status::released) return;
  const std::vector<double>& force = track.history.force;
  const double least = contact_end_share * figures.peak_force;
  std::size_t last = force.size() - 1;
  while (last > 0 && !(force[last] > least)) --last;
  // If no entry is above, the peak is NaN or far from all entries.
  if (last > 0 && last + 1 < force.size())
    figures.contact_end = where_force_falls_below(least, track, last, impactor);
}

double work_on_pad(const Track& track) {
  const History& h = track.history;
  return work_of(track, h.force_of_pad(), h.penetration);
}

}  // namespace dashpad
