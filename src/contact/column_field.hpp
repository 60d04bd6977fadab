#pragma once
/// The sphere on a pad with memory: a field of columns at fixed depths, each with its own stress history.
///
///   strain(s) = (Y - s) / L                                                        (theory.md, Eq. 4)
///   F = 2 pi int max(stress(s), 0) (R - s) ds, over s in [0, min(Y, R)]            (theory.md, Eq. 5)
///     = 2 pi L int max(g, 0) dw,  g = stress / A (R - s),  dw = A d(strain)        (theory.md, Eq. 23)
///
/// s is the depth at which the sphere's surface meets a column: the column is touched when Y passes s. g is
/// smooth in w at the contact edge and at full compression alike; it is taken as linear between stations.
/// Stations lie closer towards the axis, and are added there as the gap L - Y closes.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <type_traits>

#include "contact/columns.hpp"
#include "contact/contact.hpp"
#include "contact/sweep.hpp"
#include "dashpad/pad/law.hpp"

namespace dashpad {

template <IsViscous Law>
class ColumnField {
 public:
  /// All storage is taken here: later calls do not allocate.
  ColumnField(const Law& law, double thickness, double radius, ColumnMath math = ColumnMath::vector)
      : law_(law), power_(law.exponents()), thickness_(thickness), radius_(radius), math_(math) {}

  /// Another pad in the same storage.
  void set(const Law& law, double thickness, double radius, ColumnMath math) {
    law_ = law;
    math_ = math;
    if (law.exponents() != power_.exponents()) power_ = PowerShape(law.exponents());
    thickness_ = thickness;
    radius_ = radius;
  }

  /// The pad follows its law back on unloading.
  [[nodiscard]] bool recovers() const { return true; }
  /// The pad locks when this gap is not enough to carry the force (design limit: 1e-9 of the thickness).
  [[nodiscard]] double lock_penetration() const { return thickness_ * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return columns_.size(); }
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
    const double depth = columns_.depth()[j];
    return {depth, (penetration_ - depth) / thickness_, columns_.now.stress[j]};
  }

  /// `resolution` is the relative spacing of stations aimed at; `expected` the largest penetration that is
  /// expected, m, over which they are spread.
  void start(double resolution, double expected = std::numeric_limits<double>::infinity()) {
    clear(resolution);
    lay_columns(expected, std::min(thickness_, radius_));
    for (std::size_t j = 0; j < columns_.size(); ++j) set_at_rest(columns_.now, j);
  }
  /// No columns yet: they are laid when the pad is unloaded.
  void clear(double resolution) {
    resolution_ = resolution;
    penetration_ = largest_penetration_ = 0;
    live_ = 0;
    updates_ = 0;
    last_ = {};
    correction_ = 1;
    columns_.clear();
  }

  /// Columns for the unloading of a pad that was only loaded so far, in the state to which `steps` have led.
  /// Their integral, which has the error of the stations, is made to go on from the force of the loading.
  void begin_after(const std::vector<LoadingStep>& steps, double force) {
    penetration_ = largest_penetration_ = steps.empty() ? 0 : steps.back().penetration;
    last_ = {};
    columns_.clear();
    lay_columns(penetration_, std::min(penetration_, radius_));
    if (penetration_ <= 0) return;
    live_ = columns_.size();
    const SweepStep step{columns_.depth(), live_, thickness_, radius_, 0, penetration_, penetration_};
    replay(law_, power_, steps, step, columns_.now);
    updates_ += live_ * steps.size();
    const double edge = steps.back().modulus * std::max(radius_ - penetration_, 0.0);
    correction_ = force / integrate(columns_.now, live_, penetration_, edge);
  }

  PadTrial trial(double advance, double from, double step) {
    const double rate = advance / (thickness_ * step);
    trial_ = penetration_ + advance;
    // The tries of one step share their time.
    if (from != last_.from || step != last_.step) time_part_ = law_.time_part(from, from + step);
    last_ = {advance, from, step, 0};
    rate_part_ = law_.rate_part(rate);
    const double* depth = columns_.depth();
    trial_live_ = static_cast<std::size_t>(std::lower_bound(depth, depth + columns_.size(), trial_) - depth);
    updates_ += trial_live_;
    if (trial_live_ == 0) return last_;
    if (math_ == ColumnMath::vector)
      sweep(law_, power_, rate_part_, time_part_, sweep_step(), columns_.now, columns_.next_state);
    else
      step_one_by_one();
    const double edge =
        rate >= 0 ? law_.edge_ratio(rate_part_) * std::max(radius_ - trial_, 0.0) : unknown_edge;
    last_.force = correction_ * integrate(columns_.next_state, trial_live_, trial_, edge);
    return last_;
  }

  [[nodiscard]] double force_rate_when_held(const PadTrial& trial) {
    recall(trial);
    if (trial_live_ == 0) return 0;
    const Columns& next = columns_.next_state;
    double edge = 0;
    double sum = math_ == ColumnMath::vector
                     ? sum_of_held(held_rate(law_, trial.end()), sweep_step(), next, edge)
                     : held_one_by_one(trial.end(), edge);
    sum += edge * (next.measure[trial_live_ - 1] - edge_measure(trial_)) / 2;
    return correction_ * 2 * std::numbers::pi * thickness_ * sum;
  }

  /// Of any column, tension negative: contact is lost where it crosses zero.
  [[nodiscard]] double largest_stress(const PadTrial& trial) {
    recall(trial);
    if (trial_live_ == 0) return -std::numeric_limits<double>::min();
    return *std::max_element(columns_.next_state.stress, columns_.next_state.stress + trial_live_);
  }

  void accept(const PadTrial& trial) {
    recall(trial);
    penetration_ = trial_;
    largest_penetration_ = std::max(largest_penetration_, penetration_);
    for (std::size_t j = trial_live_; j < columns_.size(); ++j) set_at_rest(columns_.next_state, j);
    std::swap(columns_.now, columns_.next_state);
    live_ = trial_live_;
    last_ = {};
    if (penetration_ == largest_penetration_) grade_axis();
  }

  /// Outer radius of the stressed area, m.
  [[nodiscard]] double contact_radius() const {
    double depth = std::min(penetration_, radius_);
    const double* stress = columns_.now.stress;
    std::size_t j = live_;
    while (j > 0 && stress[j - 1] <= 0) --j;
    if (j == 0) return 0;
    if (j < live_) {
      const double inner = columns_.depth()[j - 1];
      depth = inner + (columns_.depth()[j] - inner) * stress[j - 1] / (stress[j - 1] - stress[j]);
    }
    return std::sqrt(depth * (2 * radius_ - depth));
  }

 private:
  static constexpr double unknown_edge = -1;
  using StrainPart = typename Law::StrainPart;
  static constexpr std::size_t numbers = sizeof(StrainPart) / sizeof(double);
  using Numbers = std::array<double, numbers>;

  [[nodiscard]] Strain strain_at(double penetration, double depth) const {
    return {(penetration - depth) / thickness_, ((thickness_ - penetration) + depth) / thickness_};
  }
  [[nodiscard]] SweepStep sweep_step() const {
    return {columns_.depth(), trial_live_, thickness_, radius_, penetration_, trial_, largest_penetration_};
  }
  static StrainPart part_of(const Columns& columns, std::size_t j) {
    Numbers part;
    for (std::size_t k = 0; k < numbers; ++k) part[k] = columns.part[k][j];
    return std::bit_cast<StrainPart>(part);
  }
  void set_column(const Columns& columns, std::size_t j, double stress, const StrainPart& strain_part,
                  const PowerShape::Value& power) const {
    const auto part = std::bit_cast<Numbers>(strain_part);
    for (std::size_t k = 0; k < numbers; ++k) columns.part[k][j] = part[k];
    columns.stress[j] = stress;
    columns.shape[j] = power.shape;
    columns.measure[j] = power.measure;
    columns.ratio[j] = power.shape > 0 ? stress / power.shape * (radius_ - columns_.depth()[j]) : 0;
  }
  void set_at_rest(const Columns& columns, std::size_t j) const {
    set_column(columns, j, 0, law_.strain_part({}, {}), {});
  }
  /// The plain form of the sweep over the columns.
  void step_one_by_one() {
    for (std::size_t j = 0; j < trial_live_; ++j) {
      const double depth = columns_.depth()[j];
      const Strain strain = strain_at(trial_, depth);
      const double before = std::max((penetration_ - depth) / thickness_, 0.0);
      const double largest = (largest_penetration_ - depth) / thickness_;
      const auto power = power_.at(strain);
      const auto part = law_.strain_part(strain, power);
      const double stress_before = columns_.now.stress[j];
      const double remainder =
          stress_before - law_.envelope(part_of(columns_.now, j), rate_part_, before, largest);
      const double envelope = law_.envelope(part, rate_part_, strain.value, largest);
      double stress =
          envelope + remainder * law_.decay(time_part_, before, strain.value, share_of_step(depth));
      // A column in tension does not press again while its envelope is in tension (theory.md, Eq. 30).
      if (stress_before <= 0 && envelope < 0) stress = std::min(stress, 0.0);
      set_column(columns_.next_state, j, stress, part, power);
    }
  }
  /// For how much of the trial step the sphere touches a column.
  [[nodiscard]] double share_of_step(double depth) const {
    return depth > penetration_ ? (trial_ - depth) / (trial_ - penetration_) : 1;
  }
  double held_one_by_one(double time, double& edge) const {
    const Columns& next = columns_.next_state;
    const auto still = law_.rate_part(0);
    const double largest_penetration = std::max(largest_penetration_, trial_);
    double sum = 0;
    edge = 0;
    for (std::size_t j = 0; j < trial_live_; ++j) {
      double g = 0;
      if (next.stress[j] > 0) {
        const double depth = columns_.depth()[j];
        const double strain = (trial_ - depth) / thickness_;
        const double largest = (largest_penetration - depth) / thickness_;
        g = law_.relaxation_rate(time, strain) *
            (law_.envelope(part_of(next, j), still, strain, largest) - next.stress[j]) / next.shape[j] *
            (radius_ - depth);
      }
      if (j > 0) sum += (edge + g) / 2 * (next.measure[j - 1] - next.measure[j]);
      edge = g;
    }
    return sum;
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
  static double cell(const Columns& columns, std::size_t j) {
    return positive_part(columns.ratio[j], columns.ratio[j + 1], columns.measure[j] - columns.measure[j + 1]);
  }
  [[nodiscard]] double cells(const Columns& columns, std::size_t count) const {
    if (math_ == ColumnMath::vector) return sum_of_cells(columns, count);
    double sum = 0;
    for (std::size_t j = 0; j < count; ++j) sum += cell(columns, j);
    return sum;
  }

  /// Eq. 23 over the first `live` columns and on to the contact edge, where g is `edge`.
  [[nodiscard]] double integrate(const Columns& columns, std::size_t live, double penetration,
                                 double edge) const {
    const bool unloading = edge == unknown_edge;
    const double last = columns.ratio[live - 1];
    const double width = columns.measure[live - 1] - edge_measure(penetration);
    double sum = 0;
    if (unloading) {
      // The stress at the edge is not known: g goes on as between the last two columns, within bounds, since
      // these may lie close together.
      edge = last;
      if (live > 1) {
        const std::size_t j = live - 2;
        const double* g = columns.ratio;
        const double* w = columns.measure;
        // A column in tension lets go with a stress without bound: for the cell inside it that counts no more
        // than the line through the next two columns, so that the force does not jump when it is gone.
        double outer = last;
        if (last < 0 && j > 0)
          outer =
              std::max(last, std::min(0.0, g[j] + (g[j] - g[j - 1]) * (w[j] - w[j + 1]) / (w[j - 1] - w[j])));
        sum = cells(columns, j) + bounded(positive_part(g[j], outer, w[j] - w[j + 1]), columns, j, j + 1,
                                          columns_.depth()[j + 1]);
        edge += (last - g[j]) * width / (w[j] - w[j + 1]);
      }
      edge = std::min(edge, 0.0);
      sum += bounded(positive_part(last, edge, width), columns, live - 1, live - 1, penetration);
    } else {
      sum = cells(columns, live - 1) + positive_part(last, edge, width);
    }
    return 2 * std::numbers::pi * thickness_ * sum;
  }

  /// On unloading a column may still push as its strain vanishes: stress over A then has no bound, but the
  /// cell's force has one, its width times its stress.
  [[nodiscard]] double bounded(double cell, const Columns& columns, std::size_t a, std::size_t b,
                               double outer_depth) const {
    const double* depth = columns_.depth();
    const double top =
        std::max({columns.stress[a] * (radius_ - depth[a]), columns.stress[b] * (radius_ - depth[b]), 0.0});
    return std::min(cell, 1.5 * top * (std::min(outer_depth, radius_) - depth[a]) / thickness_);
  }

  /// Columns from the axis on to the depth `end`, their state still to be set: evenly as far as the contact
  /// is expected to grow, closer towards the axis, which is touched first and carries the steepest stress
  /// when the gap closes.
  void lay_columns(double expected, double end) {
    const double widest = 0.8 * resolution_ * std::min(expected, end);
    const double gap = thickness_ - penetration_;
    columns_.append(0);
    for (double depth = std::min(0.2 * widest, 8 * resolution_ * gap);
         depth < end * (1 - 1e-9) && columns_.size() < ColumnStorage::most;
         depth += std::min({std::max(widest, resolution_ * (depth - expected)),
                            8 * resolution_ * (gap + depth), 3 * resolution_ * depth}))
      columns_.append(depth);
    columns_.fill_spare();
  }

  /// Near the axis the stress varies over the gap: cells there are split as the gap closes.
  void grade_axis() {
    const double gap = thickness_ - penetration_;
    const double widest = 8 * resolution_;
    const double* depth = columns_.depth();
    for (std::size_t j = 0; j + 1 < live_ && depth[j] <= 4 * gap && columns_.size() < ColumnStorage::most;
         ++j)
      while (depth[j + 1] - depth[j] > widest * (gap + depth[j]) && columns_.size() < ColumnStorage::most)
        insert_after(j, std::sqrt((gap + depth[j]) * (gap + depth[j + 1])) - gap);
  }

  /// The new column's stress over its envelope lies on the line between its neighbours': both are smooth
  /// there, whatever the envelope's shape.
  void insert_after(std::size_t j, double depth) {
    const Columns& now = columns_.now;
    const Strain strain = strain_at(penetration_, depth);
    const auto power = power_.at(strain);
    const auto part = law_.strain_part(strain, power);
    const double outer = relaxed(j + 1);
    const double relative = outer + (relaxed(j) - outer) * (power.measure - now.measure[j + 1]) /
                                        (now.measure[j] - now.measure[j + 1]);
    columns_.insert(j + 1, depth);
    set_column(columns_.now, j + 1, relative * law_.envelope(part, rate_part_, strain.value, strain.value),
               part, power);
    ++live_;
  }

  /// Stress over envelope of a column while loading.
  [[nodiscard]] double relaxed(std::size_t j) const {
    const double strain = (penetration_ - columns_.depth()[j]) / thickness_;
    return columns_.now.stress[j] / law_.envelope(part_of(columns_.now, j), rate_part_, strain, strain);
  }

  /// Makes a trial from the accepted state the last one.
  void recall(const PadTrial& wanted) {
    if (!last_.is_over(wanted.advance, wanted.from, wanted.step))
      trial(wanted.advance, wanted.from, wanted.step);
  }

  Law law_;
  PowerShape power_;
  double thickness_;
  double radius_;
  ColumnMath math_;
  double resolution_ = 0.05;
  double penetration_ = 0;
  double largest_penetration_ = 0;
  double trial_ = 0;
  typename Law::RatePart rate_part_{};  ///< of the last trial
  typename Law::TimePart time_part_{};  ///< likewise
  PadTrial last_;                       ///< without step: none from the accepted state
  double correction_ = 1;               ///< of the contact integral
  std::size_t live_ = 0;                ///< columns under strain in the accepted state
  std::size_t trial_live_ = 0;          ///< and in the trial
  std::size_t updates_ = 0;
  ColumnStorage columns_;
};

}  // namespace dashpad
