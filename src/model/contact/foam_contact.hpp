#pragma once
/// A nose on a foam whose columns share what they remember (theory.md, Eqs. 32 to 38).
///
///   F = a0 max(stress(0), 0) + int max(stress(s), 0) a'(s) ds, over s in [0, min(Y, d)]   (theory.md, Eq. 6)
///
/// The stress of a column follows from its strain, from the largest strain that it has seen, which lies by
/// the same amount above the strain for all columns, and from the slip rate, which is one for all. So nothing
/// is kept for a column, and the integral is taken anew for every trial, by four points of Gauss in each of a
/// number of panels: even in the root of the strain up to the last tested strain, even in the logarithm of
/// its complement beyond. On unloading columns let go, those at the edge first as a rule, so the integral
/// goes from one strain where the stress is nothing to the next.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <variant>

#include "dashpad/model/nose/sections.hpp"
#include "model/contact/contact.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {

class FoamContact {
 public:
  using Law = std::variant<Foam, CrushableFoam>;

  /// Every stress is multiplied by `factor`.
  FoamContact(const Law& law, double thickness, const Sections& nose, double factor = 1)
      : law_(law), stress_(made_of(law)), thickness_(thickness), nose_(nose), factor_(factor) {}
  void set(const Law& law, double thickness, const Sections& nose, double factor = 1) {
    if (!(law == law_)) {
      law_ = law;
      stress_ = made_of(law);
    }
    thickness_ = thickness;
    nose_ = nose;
    factor_ = factor;
  }

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  [[nodiscard]] double lock_penetration() const { return thickness_ * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return stations_; }
  [[nodiscard]] std::size_t updates() const { return updates_; }

  void start(double resolution, double) {
    panels_ = panels_at_one / std::sqrt(resolution);
    penetration_ = largest_ = pressing_ = 0;
    elastic_strain_ = 0;
    rate_ = rate_step_ = 0;
    stations_ = updates_ = 0;
    last_ = {};
  }

  PadTrial trial(double advance, double from, double step) {
    last_ = {advance, from, step, 0};
    trial_penetration_ = penetration_ + advance;
    trial_largest_ = std::max(largest_, trial_penetration_);
    trial_rate_ = advance / (thickness_ * step);
    // The rate within the step goes on as from the last step to this one, but keeps its sign.
    const double trend = rate_step_ > 0 ? (trial_rate_ - rate_) * step / (step + rate_step_) : 0;
    const double at_end =
        std::clamp(trial_rate_ + trend, std::min(0.0, 2 * trial_rate_), std::max(0.0, 2 * trial_rate_));
    trial_strain_ = stress_.slip().after(elastic_strain_, 2 * trial_rate_ - at_end, at_end, step);
    last_.force = factor_ * integrate();
    return last_;
  }

  [[nodiscard]] double force_rate_when_held(const PadTrial& trial) {
    recall(trial);
    return factor_ * relaxing_;
  }
  [[nodiscard]] double largest_stress(const PadTrial& trial) {
    recall(trial);
    return trial_penetration_ > 0 ? largest_stress_ : -std::numeric_limits<double>::min();
  }

  void accept(const PadTrial& trial) {
    recall(trial);
    penetration_ = trial_penetration_;
    largest_ = trial_largest_;
    elastic_strain_ = trial_strain_;
    rate_ = trial_rate_;
    rate_step_ = trial.step;
    pressing_ = trial_pressing_;
    last_ = {};
  }

  /// Outer radius of the stressed area, m.
  [[nodiscard]] double contact_radius() const { return pressing_ > 0 ? nose_.radius(pressing_) : 0; }

  /// A column in the accepted state, by the depth at which the nose's surface meets it.
  struct Column {
    double strain = 0;
    double stress = 0;  ///< Pa, tension negative
  };
  [[nodiscard]] Column column(double depth) const {
    const double strain = (penetration_ - depth) / thickness_;
    const FoamStress::Place place = stress_.at({strain, ((thickness_ - penetration_) + depth) / thickness_});
    const double u = stress_.slip().slip_rate(elastic_strain_);
    const Strain largest = strain_of(strain + (largest_ - penetration_) / thickness_);
    return {strain, factor_ * (stress_.lasting(place, largest) +
                               stress_.of_rate(place, stress_.overstress().at(u), u).stress)};
  }

 private:
  /// Panels times the root of the resolution: the rule is of an order far above that of the step.
  static constexpr double panels_at_one = 0.9;
  static constexpr double most_panels = 2000;
  static constexpr std::size_t looks = 24;  ///< for rings, where the axis does not press
  struct Node {
    double place = 0;
    double weight = 0;
  };
  static constexpr std::array<Node, 4> gauss{{{0.06943184420297371, 0.17392742256872693},
                                              {0.33000947820757187, 0.32607257743127307},
                                              {0.66999052179242813, 0.32607257743127307},
                                              {0.93056815579702629, 0.17392742256872693}}};

  static FoamStress made_of(const Law& law) {
    return std::visit([](const auto& of) { return FoamStress(of); }, law);
  }
  static int panels_of(double wanted, int least) {
    return static_cast<int>(std::clamp(std::ceil(wanted), double(least), most_panels));
  }
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }

  /// The force at the end of the trial; on the way what else is asked for.
  double integrate() {
    relaxing_ = 0;
    largest_stress_ = -std::numeric_limits<double>::infinity();
    trial_pressing_ = 0;
    points_ = 0;
    const double Y = trial_penetration_;
    if (Y <= 0) return 0;
    slip_rate_ = stress_.slip().slip_rate(trial_strain_);
    at_rate_ = stress_.overstress().at(slip_rate_);
    ahead_ = (trial_largest_ - Y) / thickness_;
    gap_ = (thickness_ - Y) / thickness_;
    const double top = Y / thickness_;
    double force = 0;
    if (nose_.tip > 0) force = add(stress_.at({top, gap_}), nose_.tip);
    const double end = std::min(Y, nose_.depth);
    if (end <= 0) return force;
    const double edge = (Y - end) / thickness_;
    if (ahead_ <= 0 && slip_rate_ >= 0) return force + integral(edge, edge, top, top);

    const auto at = [&](double root) { return sign_at(root * root, top); };
    const double low = std::sqrt(edge);
    const double high = std::sqrt(top);
    const double first = low + 1e-6 * (high - low);
    const double f_first = at(first);
    const double f_high = at(high);
    if (f_high > 0) {
      if (f_first >= 0) return force + integral(edge, edge, top, top);
      const double root = crossing(at, first, f_first, high, f_high);
      return force + integral(edge, root * root, top, top);
    }
    // The axis has let go. A ring around it may go on pressing, or several.
    std::array<double, looks + 1> places;
    for (std::size_t i = 0; i < looks; ++i) places[i] = low + (high - low) * double(i + 1) / looks;
    places[looks] = std::max(std::sqrt(std::clamp(most_pressing(top), edge, top)), first);
    std::sort(places.begin(), places.end());
    double before = first;
    double f_before = f_first;
    double from = low;
    for (const double place : places) {
      const double f = at(place);
      if (f > 0 && f_before <= 0) from = crossing(at, before, f_before, place, f);
      if (f <= 0 && f_before > 0) {
        const double to = crossing(at, before, f_before, place, f);
        force += integral(edge, from * from, to * to, top);
      }
      before = place;
      f_before = f;
    }
    return force;
  }

  /// Of the stress between two strains of the contact, which ends at the strains `edge` and `top`.
  double integral(double edge, double from, double to, double top) {
    if (to <= from) return 0;
    const double Y = trial_penetration_;
    const double last = stress_.curve().last_strain();
    if (trial_pressing_ == 0) trial_pressing_ = Y - from * thickness_;
    double force = 0;
    if (from < last) {
      const double low = std::sqrt(from);
      const double high = std::sqrt(std::min(to, last));
      const double share = (high - low) / (std::sqrt(std::min(top, last)) - std::sqrt(edge));
      const int panels = panels_of(panels_ * share, 2);
      const double width = (high - low) / panels;
      for (int i = 0; i < panels; ++i)
        for (const Node& node : gauss) {
          const double root = low + width * (i + node.place);
          const double depth = Y - root * root * thickness_;
          force += add(stress_.within(root), 2 * root * width * node.weight * weight_at(depth));
        }
    }
    if (to > last) {
      // Complements of the strains at both ends; that of the axis is known without cancellation.
      const double inner = gap_ + (top - to);
      const double outer = from > last ? gap_ + (top - from) : 1 - last;
      const double range = std::log(outer / inner);
      const int panels = panels_of(panels_ * range, 1);
      const double width = range / panels;
      for (int i = 0; i < panels; ++i)
        for (const Node& node : gauss) {
          const double complement = inner * std::exp(width * (i + node.place));
          const double depth = (complement - gap_) * thickness_;
          force += add(stress_.beyond({1 - complement, complement}),
                       complement * width * node.weight * weight_at(depth));
        }
    }
    return force;
  }
  /// a'(s) L: the area of columns by their strain, m2.
  [[nodiscard]] double weight_at(double depth) const {
    return 2 * std::numbers::pi * thickness_ * nose_.rate(depth);
  }
  [[nodiscard]] Strain largest_of(Strain strain) const {
    return {strain.value + ahead_, strain.complement - ahead_};
  }
  /// Whose sign is that of the stress; of foam the stress over the base curve, which is smooth to the edge.
  double sign_at(double strain, double top) {
    ++updates_;
    const Strain at{strain, gap_ + (top - strain)};
    const FoamStress::Place place = stress_.at(at);
    // Without its floor the stress of a crushed foam changes its sign at the gap.
    const double least = slip_rate_ <= 0 ? -std::numeric_limits<double>::infinity() : 0;
    const double stress =
        stress_.lasting(place, largest_of(at), least) + stress_.of_rate(place, at_rate_, slip_rate_).stress;
    largest_stress_ = std::max(largest_stress_, stress);
    return stress_.stays_crushed() ? stress : stress / place.base.stress;
  }
  /// The strain at which a crushed foam presses longest: beyond, its unloading is as steep as its crush
  /// curve.
  [[nodiscard]] double most_pressing(double top) const {
    return stress_.stays_crushed() ? stress_.longest_pressed(ahead_) - ahead_ : top;
  }
  /// A root of f between two places with values of unlike signs, by the rule of Illinois.
  template <class F>
  static double crossing(F&& f, double low, double f_low, double high, double f_high) {
    // The stress is nothing there: an error of the root counts by its square, against what is left to the
    // axis.
    const double end = high;
    for (int i = 0, side = 0; i < 60 && high - low > 1e-5 * (end - low); ++i) {
      const double middle = (low * f_high - high * f_low) / (f_high - f_low);
      const double value = f(middle);
      if (value == 0) return middle;
      if ((value < 0) == (f_low < 0)) {
        low = middle;
        f_low = value;
        if (side < 0) f_high /= 2;
        side = -1;
      } else {
        high = middle;
        f_high = value;
        if (side > 0) f_low /= 2;
        side = 1;
      }
    }
    return (low * f_high - high * f_low) / (f_high - f_low);
  }
  double add(const FoamStress::Place& place, double area) {
    ++points_;
    stations_ = std::max(stations_, points_);
    ++updates_;
    const FoamStress::Rate rate = stress_.of_rate(place, at_rate_, slip_rate_);
    const double stress = stress_.lasting(place, largest_of(place.strain)) + rate.stress;
    largest_stress_ = std::max(largest_stress_, stress);
    if (stress <= 0) return 0;
    relaxing_ += area * rate.relaxing;
    return area * stress;
  }

  Law law_;
  FoamStress stress_;
  double thickness_;
  Sections nose_;
  double factor_ = 1;
  double panels_ = 8;
  double penetration_ = 0;
  double largest_ = 0;         ///< penetration so far
  double elastic_strain_ = 0;  ///< g of theory.md, Eq. 34
  double rate_ = 0;            ///< of the last step, 1/s
  double rate_step_ = 0;       ///< its length, s; 0: there was none
  double pressing_ = 0;        ///< depth up to which columns press, m
  PadTrial last_;
  double trial_penetration_ = 0;
  double trial_largest_ = 0;
  double trial_strain_ = 0;
  double trial_rate_ = 0;
  double trial_pressing_ = 0;
  double ahead_ = 0;  ///< of the largest strain, over the strain
  double gap_ = 0;    ///< above the axis, of the thickness
  double slip_rate_ = 0;
  Overstress::AtRate at_rate_;
  double relaxing_ = 0;
  double largest_stress_ = 0;
  std::size_t points_ = 0;    ///< of the contact integral in this trial
  std::size_t stations_ = 0;  ///< the most of them since the start
  std::size_t updates_ = 0;
};

static_assert(IsContact<FoamContact>);

}  // namespace dashpad
