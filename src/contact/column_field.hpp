#pragma once
/// The sphere on a pad with memory: a field of columns at fixed depths, each with its own stress history.
///
///   strain(s) = (Y - s) / L                                                        (theory.md, Eq. 4)
///   F = 2 pi int max(stress(s), 0) (R - s) ds, over s in [0, min(Y, R)]            (theory.md, Eq. 5)
///     = 2 pi L int max(g, 0) dw,  g = stress / A (R - s),  dw = A d(strain)        (theory.md, Eq. 23)
///
/// s is the depth at which the sphere's surface meets a column: the column is touched when Y passes s. g is
/// smooth in w at the contact edge and at full compression alike; it is taken as linear between stations.
/// Stations follow the contact edge as it moves out and are graded towards the axis as the gap L - Y closes.
///
/// A step is tried (any number of times) and then accepted; only acceptance changes the state.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "dashpad/pad/law.hpp"

namespace dashpad {

template <IsViscous Law>
class ColumnField {
 public:
  /// All storage is taken here: later calls do not allocate.
  ColumnField(const Law& law, double thickness, double radius)
      : law_(law), power_(law.exponents()), thickness_(thickness), radius_(radius) {
    for (auto* columns : {&now_, &next_}) columns->reserve(most_stations);
    depth_.reserve(most_stations);
  }

  /// The pad follows its law back on unloading.
  [[nodiscard]] bool recovers() const { return true; }
  /// The pad locks when this gap is not enough to carry the force (design limit: 1e-9 of the thickness).
  [[nodiscard]] double lock_penetration() const { return thickness_ * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return depth_.size(); }
  /// Columns updated in all trials since the start: the cost of the run.
  [[nodiscard]] std::size_t updates() const { return updates_; }

  struct Column {
    double depth = 0;   ///< s, m
    double strain = 0;  ///< > 0
    double stress = 0;  ///< Pa, tension negative
  };
  /// Columns under strain in the accepted state, from the axis outwards.
  [[nodiscard]] std::size_t strained_columns() const { return live_; }
  [[nodiscard]] Column column(std::size_t j) const {
    return {depth_[j], (penetration_ - depth_[j]) / thickness_, now_.stress[j]};
  }

  /// `resolution` is the relative spacing of stations aimed at.
  void start(double resolution) {
    resolution_ = resolution;
    penetration_ = largest_penetration_ = 0;
    live_ = 0;
    updates_ = 0;
    depth_.assign(1, 0.0);
    for (auto* columns : {&now_, &next_}) columns->resize(1);
    now_.set(0, 0, law_.strain_part({}, {}), {});
  }

  /// Pad force after the penetration has advanced by `advance` from the accepted state, evenly over
  /// [from, from + step] in time. The advance may be far below the rounding of the penetration.
  double trial(double advance, double from, double step) {
    const double penetration = penetration_ + advance;
    const double rate = advance / (thickness_ * step);
    rate_part_ = law_.rate_part(rate);
    const auto time_part = law_.time_part(from, from + step);
    trial_ = penetration;
    trial_live_ = depth_.size();
    updates_ += trial_live_;
    for (std::size_t j = 0; j < depth_.size(); ++j) {
      const Strain strain = strain_at(penetration, depth_[j]);
      if (strain.value <= 0) {
        trial_live_ = j;
        break;
      }
      const double before = std::max((penetration_ - depth_[j]) / thickness_, 0.0);
      const double largest = (largest_penetration_ - depth_[j]) / thickness_;
      const auto power = power_.at(strain);
      const auto part = law_.strain_part(strain, power);
      const double stress = law_.envelope(part, rate_part_, strain.value, largest) +
                            (now_.stress[j] - law_.envelope(now_.part[j], rate_part_, before, largest)) *
                                law_.decay(time_part, before, strain.value);
      next_.set(j, stress, part, power);
    }
    const double edge =
        rate >= 0 ? law_.edge_ratio(rate_part_) * std::max(radius_ - penetration, 0.0) : unknown_edge;
    return integrate(next_, next_.stress, trial_live_, penetration, edge);
  }

  /// dF/dt if the penetration of the last trial were held from its end on (`time` in s since contact).
  [[nodiscard]] double force_rate_when_held(double time) {
    const auto still = law_.rate_part(0);
    const double largest_penetration = std::max(largest_penetration_, trial_);
    double sum = 0;
    double before = 0;
    for (std::size_t j = 0; j < trial_live_; ++j) {
      double g = 0;
      if (next_.stress[j] > 0) {
        const double strain = (trial_ - depth_[j]) / thickness_;
        const double largest = (largest_penetration - depth_[j]) / thickness_;
        g = law_.relaxation_rate(time, strain) *
            (law_.envelope(next_.part[j], still, strain, largest) - next_.stress[j]) / next_.shape[j] *
            (radius_ - depth_[j]);
      }
      if (j > 0) sum += (before + g) / 2 * (next_.measure[j - 1] - next_.measure[j]);
      before = g;
    }
    if (trial_live_ > 0) sum += before * (next_.measure[trial_live_ - 1] - edge_measure(trial_)) / 2;
    return 2 * std::numbers::pi * thickness_ * sum;
  }

  /// Largest stress of any column after a step, tension negative: contact is lost where it crosses zero.
  double largest_stress(double advance, double from, double step) {
    trial(advance, from, step);
    if (trial_live_ == 0) return -std::numeric_limits<double>::min();
    return *std::max_element(next_.stress.begin(),
                             next_.stress.begin() + static_cast<std::ptrdiff_t>(trial_live_));
  }

  /// Accepts the last trial step.
  void accept() {
    for (std::size_t j = trial_live_; j < depth_.size(); ++j) next_.set(j, 0, law_.strain_part({}, {}), {});
    std::swap(now_, next_);
    penetration_ = trial_;
    live_ = trial_live_;
    if (penetration_ > largest_penetration_) {
      largest_penetration_ = penetration_;
      follow_edge();
      grade_axis();
    }
  }

  /// Outer radius of the stressed area, m.
  [[nodiscard]] double contact_radius() const {
    std::size_t j = live_;
    while (j > 0 && now_.stress[j - 1] <= 0) --j;
    if (j == 0) return 0;
    double depth = std::min(penetration_, radius_);
    if (j < live_) {
      const double inner = now_.stress[j - 1];
      depth = depth_[j - 1] + (depth_[j] - depth_[j - 1]) * inner / (inner - now_.stress[j]);
    }
    return std::sqrt(depth * (2 * radius_ - depth));
  }

 private:
  static constexpr std::size_t most_stations = 20'000;
  static constexpr double unknown_edge = -1;

  struct Columns {
    std::vector<double> stress;
    std::vector<typename Law::StrainPart> part;
    std::vector<double> shape;    ///< A
    std::vector<double> measure;  ///< w
    void reserve(std::size_t n) { stress.reserve(n), part.reserve(n), shape.reserve(n), measure.reserve(n); }
    void resize(std::size_t n) { stress.resize(n), part.resize(n), shape.resize(n), measure.resize(n); }
    void set(std::size_t j, double s, const typename Law::StrainPart& p, const PowerShape::Value& power) {
      stress[j] = s, part[j] = p, shape[j] = power.shape, measure[j] = power.measure;
    }
  };

  [[nodiscard]] Strain strain_at(double penetration, double depth) const {
    return {(penetration - depth) / thickness_, ((thickness_ - penetration) + depth) / thickness_};
  }
  [[nodiscard]] double ratio(const Columns& columns, const std::vector<double>& value, std::size_t j) const {
    return value[j] / columns.shape[j] * (radius_ - depth_[j]);
  }
  /// w at the outer end of the contact: 0, or where the sphere's side begins.
  [[nodiscard]] double edge_measure(double penetration) const {
    return penetration <= radius_ ? 0 : power_.at(strain_at(penetration, radius_)).measure;
  }
  /// Integral of max(g, 0) over a cell in which g is linear.
  static double positive_part(double g, double h, double width) {
    if (g >= 0 && h >= 0) return (g + h) / 2 * width;
    if (g <= 0 && h <= 0) return 0;
    const double top = std::max(g, h);
    return top * top / (top - std::min(g, h)) / 2 * width;
  }

  /// Eq. 23 over the first `live` columns and on to the contact edge, where g is `edge`.
  [[nodiscard]] double integrate(const Columns& columns, const std::vector<double>& value, std::size_t live,
                                 double penetration, double edge) const {
    if (live == 0) return 0;
    const bool unloading = edge == unknown_edge;
    double sum = 0;
    double inner = ratio(columns, value, 0);
    double before = inner;
    for (std::size_t j = 1; j < live; ++j) {
      before = inner;
      inner = ratio(columns, value, j);
      const double cell = positive_part(before, inner, columns.measure[j - 1] - columns.measure[j]);
      sum += unloading && j + 1 == live ? bounded(cell, value, j - 1, j, depth_[j]) : cell;
    }
    const double width = columns.measure[live - 1] - edge_measure(penetration);
    if (unloading) {
      // The stress at the edge is not known: g goes on as between the last two columns, within bounds, since
      // these may lie close together.
      edge = inner;
      if (live > 1)
        edge += (inner - before) * width / (columns.measure[live - 2] - columns.measure[live - 1]);
      edge = penetration > radius_ ? 0 : std::min(edge, 2 * std::max(inner, 0.0));
      sum += bounded(positive_part(inner, edge, width), value, live - 1, live - 1, penetration);
    } else {
      sum += positive_part(inner, edge, width);
    }
    return 2 * std::numbers::pi * thickness_ * sum;
  }

  /// On unloading a column may still push as its strain vanishes: stress over A then has no bound, but the
  /// cell's force has one, its width times its stress.
  [[nodiscard]] double bounded(double cell, const std::vector<double>& stress, std::size_t a, std::size_t b,
                               double outer_depth) const {
    const double top = std::max({stress[a] * (radius_ - depth_[a]), stress[b] * (radius_ - depth_[b]), 0.0});
    return std::min(cell, 1.5 * top * (std::min(outer_depth, radius_) - depth_[a]) / thickness_);
  }

  /// A new station at the contact edge when it has moved on far enough.
  void follow_edge() {
    if (penetration_ >= radius_ || depth_.size() >= most_stations) return;
    if (penetration_ - depth_.back() < 0.2 * resolution_ * penetration_) return;
    depth_.push_back(penetration_);
    next_.resize(depth_.size());
    now_.resize(depth_.size());
    now_.set(depth_.size() - 1, 0, law_.strain_part({}, {}), {});
  }

  /// Near the axis the stress varies over the gap: cells there are split as the gap closes.
  void grade_axis() {
    const double gap = thickness_ - penetration_;
    const double widest = 8 * resolution_;
    for (std::size_t j = 0; j + 1 < live_ && depth_[j] <= 4 * gap && depth_.size() < most_stations; ++j)
      while (depth_[j + 1] - depth_[j] > widest * (gap + depth_[j]) && depth_.size() < most_stations)
        insert_after(j, std::sqrt((gap + depth_[j]) * (gap + depth_[j + 1])) - gap);
  }

  /// The new column's stress over its envelope lies on the line between its neighbours': both are smooth
  /// there, whatever the envelope's shape.
  void insert_after(std::size_t j, double depth) {
    const Strain strain = strain_at(penetration_, depth);
    const auto power = power_.at(strain);
    const auto part = law_.strain_part(strain, power);
    const double outer = relaxed(j + 1);
    const double relative = outer + (relaxed(j) - outer) * (power.measure - now_.measure[j + 1]) /
                                        (now_.measure[j] - now_.measure[j + 1]);
    const auto at = static_cast<std::ptrdiff_t>(j + 1);
    depth_.insert(depth_.begin() + at, depth);
    now_.stress.insert(now_.stress.begin() + at,
                       relative * law_.envelope(part, rate_part_, strain.value, strain.value));
    now_.part.insert(now_.part.begin() + at, part);
    now_.shape.insert(now_.shape.begin() + at, power.shape);
    now_.measure.insert(now_.measure.begin() + at, power.measure);
    next_.resize(depth_.size());
    ++live_;
  }

  /// Stress over envelope of a column while loading.
  [[nodiscard]] double relaxed(std::size_t j) const {
    const double strain = (penetration_ - depth_[j]) / thickness_;
    return now_.stress[j] / law_.envelope(now_.part[j], rate_part_, strain, strain);
  }

  Law law_;
  PowerShape power_;
  double thickness_;
  double radius_;
  double resolution_ = 0.05;
  double penetration_ = 0;
  double largest_penetration_ = 0;
  double trial_ = 0;
  typename Law::RatePart rate_part_{};  ///< of the last trial
  std::size_t live_ = 0;                ///< columns under strain in the accepted state
  std::size_t trial_live_ = 0;          ///< and in the trial
  std::size_t updates_ = 0;
  std::vector<double> depth_;  ///< s, increasing
  Columns now_;
  Columns next_;
};

}  // namespace dashpad
