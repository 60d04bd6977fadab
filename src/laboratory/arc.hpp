#pragma once
/// Parts of a strain history in which the strain only grows, only falls or stays, the contact of a column
/// within them, and the record of a test.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "dashpad/laboratory/column_test.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad::laboratory {

struct Motion {
  double strain = 0;
  double rate = 0;  ///< 1/s
};

/// A strain that is a parabola in time and does not turn. It is evaluated from its nearer end, so that a
/// strain or a rate that vanishes at an end does so without cancellation.
struct Stretch {
  double time = 0;      ///< time of its start, s since first contact
  double duration = 0;  ///< s
  Motion start;
  Motion end;
  double acceleration = 0;  ///< 1/s2

  /// Motion `x` s after the start, most accurate near it.
  [[nodiscard]] Motion after_start(double x) const;
  /// Motion `y` s before the end, most accurate near it.
  [[nodiscard]] Motion before_end(double y) const;
  [[nodiscard]] Motion at(double x) const {
    return x <= duration / 2 ? after_start(x) : before_end(duration - x);
  }
  [[nodiscard]] Stretch part(double from, double to) const;
  /// 1 if the strain grows, -1 if it falls, 0 if it stays.
  [[nodiscard]] int direction() const;
};

struct Arc : Stretch {
  double piece_duration = 0;
  double offset = 0;  ///< time of its start within its piece, s
};

/// The arcs of a history, which must have no violations(): its pieces, split at their vertices.
std::vector<Arc> arcs_of(const StrainHistory& history);

/// The time within an arc in which a column carries stress, from the arc's start, s.
struct Contact {
  bool any = false;
  double from = 0;
  double to = 0;
  bool taken_up = false;  ///< contact begins again at `from`
  bool lost = false;      ///< contact is lost at `to`
};

/// The contact of a column whose stress is known at every moment of the arc: asks `presses(x)` at even places
/// and locates the crossings between them. `lost`: whether the column had lost contact before the arc, and on
/// return whether it has after it.
template <class Presses>
Contact pressing_part(const Arc& arc, bool& lost, Presses&& presses) {
  constexpr int places = 128;
  constexpr int halvings = 60;
  const auto crossing = [&](double before, double after) {
    const bool rises = presses(after);
    for (int i = 0; i < halvings; ++i) {
      const double middle = before + (after - before) / 2;
      (presses(middle) == rises ? after : before) = middle;
    }
    return rises ? after : before;
  };
  Contact contact{false, 0, arc.duration, false, false};
  bool pressed = presses(0.0);
  contact.any = pressed;
  double before = 0;
  for (int i = 1; i <= places && !contact.lost; ++i) {
    const double x = arc.duration * i / places;
    const bool presses_now = presses(x);
    if (presses_now && !contact.any) contact.from = crossing(before, x);
    contact.any = contact.any || presses_now;
    if (pressed && !presses_now) {
      contact.to = crossing(before, x);
      contact.lost = true;
    }
    pressed = presses_now;
    before = x;
  }
  contact.taken_up = contact.any && lost;
  lost = contact.lost || (lost && !contact.any);
  return contact;
}

/// Duration of a history, s.
double duration_of(const StrainHistory& history);

/// Time at which the strain first stops growing, s; 0 if it never grows.
double end_of_first_loading(const StrainHistory& history);

/// Strain at a time from 0 to the end.
double strain_at(const StrainHistory& history, double time);

/// The same history in more pieces: one ends at each of `times`, s, increasing, as a place of output.
StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times);

/// A number with its estimated error.
struct WithError {
  double value = 0;
  double error = 0;  ///< >= 0
};

/// Gauss-Kronrod quadrature with 15 points, bisected until the error estimate, the difference from the rule
/// of 7 points, is small enough; that estimate is far too large.
template <class F>
WithError bisected(F&& f, double from, double to, double relative, double absolute, int depth) {
  // Boost's error disregards the length of the interval, so it gets one of length 2.
  const double middle = from + (to - from) / 2;
  const double half = (to - from) / 2;
  const auto scaled = [&](double z) { return half * f(middle + half * z); };
  WithError result;
  double magnitude = 0;
  result.value = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(scaled, -1.0, 1.0, 0, 0,
                                                                               &result.error, &magnitude);
  if (absolute < 0) absolute = relative * magnitude;
  if (depth == 0 || !(result.error > absolute)) return result;
  const WithError first = bisected(f, from, middle, relative, absolute / 2, depth - 1);
  const WithError second = bisected(f, middle, to, relative, absolute / 2, depth - 1);
  return {first.value + second.value, first.error + second.error};
}

/// Integral of a smooth function, to a fraction of the integral of its magnitude. (Boost's adaptive rule
/// compares with the integral itself and does not end where that is nearly zero.)
template <class F>
WithError integral(F&& f, double from, double to, double tolerance = 1e-11, int depth = 15) {
  return to > from ? bisected(f, from, to, tolerance, -1, depth) : WithError{};
}

/// Integral of a function that may have an infinite slope or an integrable infinity at `from`, which is best
/// 0: the distance from it then has no rounding.
template <class F>
WithError integral_from_singularity(F&& f, double from, double to, double tolerance = 1e-12) {
  thread_local boost::math::quadrature::tanh_sinh<double> rule(12);
  if (!(to > from)) return {};
  WithError result;
  result.value = rule.integrate(f, from, to, tolerance, &result.error);
  return result;
}

/// The record of a material test while it is written.
class Record {
 public:
  void add(double time, Motion motion, WithError stress) {
    test_.time.push_back(time);
    test_.strain.push_back(motion.strain);
    test_.rate.push_back(motion.rate);
    test_.stress.push_back(std::max(stress.value, 0.0));
    test_.work.push_back(work_.value);
    largest_error_ = std::max(largest_error_, stress.error);
  }
  /// Adds the work done since the last place.
  void work(WithError done) {
    work_.value += done.value;
    work_.error += done.error;
  }
  void note(ColumnEvent::Kind kind, double time, double strain, double before, double after) {
    test_.events.push_back({kind, time, strain, before, after, test_.size() - 1});
  }
  [[nodiscard]] double stress() const { return test_.stress.back(); }

  ColumnTest finished() {
    test_.largest_strain = *std::max_element(test_.strain.begin(), test_.strain.end());
    const double peak = *std::max_element(test_.stress.begin(), test_.stress.end());
    test_.stress_error = peak > 0 ? largest_error_ / peak : 0;
    test_.work_error = work_.error;
    return std::move(test_);
  }

 private:
  ColumnTest test_;
  WithError work_;
  double largest_error_ = 0;
};

/// Collects the rules that a request for a test breaks.
class Rules {
 public:
  Rules& require(bool is_kept, const std::string& name, double value, const std::string& rule) {
    if (!is_kept) text_ += fmt::format("{}{} = {}: {}", text_.empty() ? "" : "; ", name, value, rule);
    return *this;
  }
  Rules& positive(const char* name, double value, const char* unit) {
    return require(value > 0 && std::isfinite(value), name, value,
                   fmt::format("must be more than 0, in {}", unit));
  }
  Rules& rate(double value) { return positive("rate", value, "1/s"); }
  Rules& peak(double value) {
    return require(value > 0 && value < 1, "strain", value, "must be more than 0 and less than 1");
  }
  Rules& none_of(const std::vector<Violation>& broken) {
    for (const Violation& violation : broken) require(false, violation.key, violation.value, violation.rule);
    return *this;
  }
  /// Throws std::invalid_argument that names all broken rules, if there are any.
  void done() const {
    if (!text_.empty()) throw std::invalid_argument(text_);
  }

 private:
  std::string text_;
};

}  // namespace dashpad::laboratory
