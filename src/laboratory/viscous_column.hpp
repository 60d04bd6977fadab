#pragma once
/// A column with memory on its way through a history, arc by arc.

#include <array>
#include <vector>

#include "laboratory/viscous_stress.hpp"
#include "model/root.hpp"

namespace dashpad::laboratory {

template <HasMemory Law>
class ViscousColumn {
 public:
  explicit ViscousColumn(const Law& law) : law_(law) {}

  /// Goes on to the next arc. The rule for tension is that of dashpad/laboratory/column_test.hpp.
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

  /// `x` s after the arc's start, within the contact.
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

  /// Where the stress is computed on the way, as fractions of an arc: closer at its ends, where the singular
  /// quadratures are. They do not depend on the places of output, so neither does any stress.
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
