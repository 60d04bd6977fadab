#pragma once
/// The parts of a strain history in which the strain only grows, only falls, or stands still; when in one of
/// them a column carries stress; and places within a history where a value is wanted.

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

/// A parabola in time that does not turn. It is evaluated from its nearer end, so that a strain or a rate
/// which vanishes at an end does so without cancellation.
struct Stretch {
  double time = 0;      ///< of its start, s since first contact
  double duration = 0;  ///< s
  Motion start;
  Motion end;
  double acceleration = 0;  ///< of the strain, 1/s2

  /// `x` s after the start, best near it.
  [[nodiscard]] Motion after_start(double x) const;
  /// `y` s before the end, best near it.
  [[nodiscard]] Motion before_end(double y) const;
  [[nodiscard]] Motion at(double x) const {
    return x <= duration / 2 ? after_start(x) : before_end(duration - x);
  }
  [[nodiscard]] Stretch part(double from, double to) const;
  /// 1: the strain grows, -1: it falls, 0: it stands still.
  [[nodiscard]] int direction() const;
};

struct Arc : Stretch {
  double piece_duration = 0;
  double offset = 0;  ///< of its start in its piece, s
};

/// A piece that turns is split at its vertex. The history must have no violations().
std::vector<Arc> arcs_of(const StrainHistory& history);

/// When in an arc a column carries stress; times from the arc's start.
struct Contact {
  bool any = false;
  double from = 0;
  double to = 0;
  bool taken_up = false;  ///< at `from`, after it was lost
  bool lost = false;      ///< at `to`
};

/// Where in an arc a column presses whose stress is known at every moment of it: asks `presses(x)` at even
/// places, and finds the crossings between them. `lost`: whether the column did not press before the arc;
/// then whether it does after it.
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

/// Of a whole history, s.
double duration_of(const StrainHistory& history);

/// When the strain first stops to grow, s; 0 if it never grows.
double end_of_first_loading(const StrainHistory& history);

/// At a time from 0 to the end.
double strain_at(const StrainHistory& history, double time);

/// The same history in more pieces: one ends at each of `times` (increasing, s), so that it becomes a place
/// of output.
StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times);

// Integrals with their estimated errors, by the two rules of Boost.Math that the laboratory needs.

/// A number and how far it may be off.
struct WithError {
  double value = 0;
  double error = 0;  ///< estimated, >= 0
};

/// One application of the rule of 15 points; the error is the distance from the one of 7, far too large.
template <class F>
WithError bisected(F&& f, double from, double to, double relative, double absolute, int depth) {
  // Boost forgets the length of the interval in the error, so it gets one of length 2.
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

/// Of a smooth function, to a fraction of the integral of its magnitude. (The adaptive rule of Boost compares
/// with the integral itself, and does not end where that is nearly zero.)
template <class F>
WithError integral(F&& f, double from, double to, double tolerance = 1e-11, int depth = 15) {
  return to > from ? bisected(f, from, to, tolerance, -1, depth) : WithError{};
}

/// Of a function that may have an infinite slope or an integrable infinity where it begins. From 0 on is
/// best: there the distance from the beginning has no rounding.
template <class F>
WithError integral_from_singularity(F&& f, double from, double to, double tolerance = 1e-12) {
  thread_local boost::math::quadrature::tanh_sinh<double> rule(12);
  if (!(to > from)) return {};
  WithError result;
  result.value = rule.integrate(f, from, to, tolerance, &result.error);
  return result;
}

// The record of a material test while it is written.

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
  /// Done since the last place.
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

// The rules that what is asked of a test breaks, thrown together.

class Rules {
 public:
  Rules& require(bool is_kept, const std::string& name, double value, const std::string& rule) {
    if (!is_kept) text_ += fmt::format("{}{} is {}: {}", text_.empty() ? "" : "; ", name, value, rule);
    return *this;
  }
  Rules& positive(const char* name, double value, const char* unit) {
    return require(value > 0 && std::isfinite(value), name, value,
                   fmt::format("must be more than 0 ({})", unit));
  }
  Rules& rate(double value) { return positive("rate", value, "1/s"); }
  Rules& peak(double value) {
    return require(value > 0 && value < 1, "strain", value, "must be more than 0 and less than 1");
  }
  Rules& none_of(const std::vector<Violation>& broken) {
    for (const Violation& violation : broken) require(false, violation.key, violation.value, violation.rule);
    return *this;
  }
  /// Throws std::invalid_argument that says them all; nothing where none is broken.
  void done() const {
    if (!text_.empty()) throw std::invalid_argument(text_);
  }

 private:
  std::string text_;
};

}  // namespace dashpad::laboratory
