#pragma once
/// The stress of a column with memory at the end of a stretch of strain.
///
/// On a straight stretch, with H the integral of h over it (theory.md, Eq. 9):
///
///   stress_1 = G(e1) + (stress_0 - G(e0)) exp(-H)
///
/// On a parabolic one, with H(t) the integral of h from t to the end (the solution of theory.md, Eq. 8):
///
///   stress_1 = stress_0 exp(-H) + integral of exp(-H(t)) (dG/de de/dt + h G) dt
///
/// This form needs no derivative by the rate, so the infinite slope of the envelope at rate zero does no
/// harm. dG/de ~ e^(m-1) at strain zero is integrated over z in t = z^(1/m), where it is finite.

#include <algorithm>
#include <array>
#include <vector>

#include "dashpad/model/pad/law.hpp"
#include "laboratory/arc.hpp"
#include "model/pad/column_law.hpp"
#include "model/root.hpp"

namespace dashpad::laboratory {

/// H between two times of a stretch, counted from its start, s.
template <HasMemory Law>
WithError relaxation(const Law& law, const Stretch&, double from, double to) {
  return {(to - from) * law.relaxation_rate(0), 0};
}

/// The same for law 5, whose h depends on time and strain; over u = t^a it has no singularity.
inline WithError relaxation(const TwentyOneParameter& law, const Stretch& stretch, double from, double to) {
  const double a = law.relaxation_exponent;
  const double log_base = std::log(law.relaxation_strain_base);
  const auto fading = [&](double x) { return std::exp(-log_base * stretch.at(x).strain); };
  const double early = stretch.time + from;
  const double late = stretch.time + to;
  if (4 * early > to - from)
    return integral(
        [&](double x) { return a / law.relaxation_scale * std::pow(stretch.time + x, a - 1) * fading(x); },
        from, to, 1e-12, 5);
  const auto in_power = [&](double u) {
    return fading(std::clamp(std::pow(u, 1 / a) - stretch.time, from, to)) / law.relaxation_scale;
  };
  return integral_from_singularity(in_power, std::pow(early, a), std::pow(late, a));
}

template <HasMemory Law>
class ViscousStress {
 public:
  explicit ViscousStress(const Law& law) : law_(law), power_(law.exponents()) {}

  /// Stress at the end of a stretch that begins with `stress`, Pa, and the largest strain so far. On
  /// unloading the strain at the end must be above 0: at 0 the envelopes of laws 4 and 5 have no lower bound.
  [[nodiscard]] WithError after(const Stretch& stretch, WithError stress, double largest) const {
    const WithError H = relaxation(law_, stretch, 0, stretch.duration);
    const double kept = std::exp(-H.value);
    if (stretch.acceleration == 0) {
      const double from = stress.value - envelope(stretch.start, largest);
      const double to = envelope(stretch.end, largest);
      return {to + from * kept, kept * (stress.error + std::abs(from) * H.error) + rounding * std::abs(to)};
    }
    const WithError added = memory(remembered(stretch), largest);
    const double value = stress.value * kept + added.value;
    return {value, kept * stress.error + added.error + (std::abs(stress.value) + std::abs(value)) * H.error +
                       rounding * std::abs(value)};
  }

 private:
  static constexpr double rounding = 4e-16;

  [[nodiscard]] double envelope(Motion motion, double largest) const {
    return dashpad::envelope(law_, power_, strain_of(motion.strain), law_.rate_part(motion.rate), largest);
  }

  /// The integrand exp(-H(t)) (dG/de de/dt + h G) `x` s after the start of the stretch.
  [[nodiscard]] double integrand(const Stretch& stretch, double x, Motion motion, double largest) const {
    if (motion.strain < scalar::min_strain) return 0;
    const Strain strain = strain_of(motion.strain);
    const auto rate = law_.rate_part(motion.rate);
    const double slope = envelope_slope(law_, power_, strain, rate, largest);
    const double h = relaxation_rate(law_, power_, stretch.time + x, motion.strain);
    const double kept = std::exp(-relaxation(law_, stretch, x, stretch.duration).value);
    return kept * (slope * motion.rate + h * envelope(motion, largest));
  }

  /// The last part of a stretch, in which exp(-H(t)) is above e^-40. Without this cut a quadrature over many
  /// relaxation times could miss all that counts.
  [[nodiscard]] Stretch remembered(const Stretch& stretch) const {
    double from = 0;
    for (;;) {
      const double later = from + (stretch.duration - from) / 2;
      if (later <= from || relaxation(law_, stretch, later, stretch.duration).value < 40) break;
      from = later;
    }
    return from == 0 ? stretch : stretch.part(from, stretch.duration);
  }

  /// The integral over both halves of a stretch, with times counted from its nearer end.
  [[nodiscard]] WithError memory(const Stretch& stretch, double largest) const {
    const double half = stretch.duration / 2;
    const auto first = [&](double x) { return integrand(stretch, x, stretch.after_start(x), largest); };
    const auto second = [&](double y) {
      return integrand(stretch, stretch.duration - y, stretch.before_end(y), largest);
    };
    WithError early;
    if (stretch.start.strain == 0)
      early = from_zero_strain(first, half);
    else if (stretch.start.rate == 0)
      early = integral_from_singularity(first, 0, half);
    else
      early = integral(first, 0, half);
    const WithError late =
        stretch.end.rate == 0 ? integral_from_singularity(second, 0, half) : integral(second, 0, half);
    return {early.value + late.value, early.error + late.error};
  }

  template <class F>
  [[nodiscard]] WithError from_zero_strain(F&& f, double half) const {
    const double m = power_.exponents().m;
    const double least = std::pow(1e-140, m);  // below, the integrand is constant in z and x underflows
    const auto in_power = [&](double z) {
      z = std::max(z, least);
      const double x = half * std::pow(z, 1 / m);
      return f(x) * x / (m * z);
    };
    return integral_from_singularity(in_power, 0, 1);
  }

  Law law_;
  PowerShape power_;
};

/// A column with memory, led through a history arc by arc.
template <HasMemory Law>
class ViscousColumn {
 public:
  explicit ViscousColumn(const Law& law) : law_(law) {}

  /// Enters the next arc. The rule for tension is in dashpad/laboratory/column_test.hpp.
  Contact enter(const Arc& arc) {
    const int direction = arc.direction();
    arc_ = arc;
    Contact contact{!lost_ || direction > 0, 0, arc.duration, lost_ && direction > 0, false};
    if (!contact.any) return contact;
    lost_ = false;
    nodes_ = {{0, stress_}};
    for (std::size_t i = 1; i < node_places.size(); ++i) {
      const double x = node_places[i] * arc.duration;
      const bool at_zero = i + 1 == node_places.size() && arc.end.strain == 0;
      const WithError stress = direction < 0 && at_zero ? WithError{-1, 0} : at(x);
      if (direction < 0 && stress.value <= 0) {
        contact.to = moment_of_loss(node_places[i - 1] * arc.duration, x);
        contact.lost = lost_ = true;
        break;
      }
      nodes_.push_back({x, stress});
    }
    return contact;
  }

  /// Stress `x` s after the arc's start, within the contact, Pa.
  [[nodiscard]] WithError at(double x) const {
    if (x == 0) return nodes_.front().stress;
    auto node = nodes_.end() - 1;
    while (node->x >= x) --node;
    return law_.after(arc_.part(node->x, x), node->stress, largest_);
  }

  void leave() {
    stress_ = lost_ ? WithError{} : at(arc_.duration);
    largest_ = std::max(largest_, arc_.end.strain);
  }

 private:
  struct Node {
    double x = 0;
    WithError stress;
  };

  /// Places of an arc at which the stress is computed, as fractions of it: closer at its ends, where the
  /// quadratures are singular. They do not depend on the places of output, so no stress does.
  static constexpr int ends = 5, middle = 32;
  static constexpr auto node_places = [] {
    std::array<double, middle + 1 + 2 * ends> places{};
    std::size_t n = 1;
    double x = 1.0 / middle;
    for (int i = 0; i < ends; ++i) x /= 4;
    for (int i = 0; i < ends; ++i, x *= 4) places[n++] = x;
    for (int i = 1; i < middle; ++i) places[n++] = i / static_cast<double>(middle);
    for (std::size_t i = ends; i > 0; --i) places[n++] = 1 - places[i];
    places[n] = 1;
    return places;
  }();

  [[nodiscard]] double moment_of_loss(double before, double after) const {
    const double scale = std::max(at(before).value, 1e-300);
    const auto stress = [&](double x) {
      if (arc_.part(0, x).end.strain <= 0) return -scale;
      return std::max(at(x).value, -scale);
    };
    const double high = stress(after);
    const double low = before == 0 ? stress_.value : stress(before);
    if (low <= 0) return before;
    if (high >= 0) return after;
    return narrowed({.low = before, .high = after, .f_low = low, .f_high = high}, stress).low;
  }

  ViscousStress<Law> law_;
  Arc arc_;
  std::vector<Node> nodes_;
  WithError stress_;
  double largest_ = 0;
  bool lost_ = false;
};

}  // namespace dashpad::laboratory
