#pragma once
/// A nose on a pad with memory: a field of columns at fixed depths, each with its own stress history.
///
///   strain(s) = (Y - s) / L                                                        (theory.md, Eq. 5)
///   F = a0 max(stress(0), 0) + int max(stress(s), 0) a'(s) ds, over s in [0, min(Y, d)]   (theory.md, Eq. 6)
///   int = 2 pi L int max(g, 0) dw,  g = stress a' / (2 pi A),  dw = A d(strain)      (theory.md, Eq. 20)
///
/// s is the depth at which the nose's surface meets a column; a(s) is the area of the nose's section, a0 that
/// of its flat tip (theory.md, Eq. 3): the column is touched when Y passes s. g is smooth in w both at the
/// contact edge and at full compression; it is taken as linear between stations. Stations are denser towards
/// the axis, and are added there as the gap L - Y closes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/pad/law.hpp"
#include "dashpad/quantities/constants.hpp"
#include "model/contact/contact.hpp"
#include "model/contact/station_layout.hpp"
#include "model/contact/sweep.hpp"
#include "model/pad/column_law.hpp"

namespace dashpad {

template <HasMemory Law>
class ColumnField {
 public:
  /// Allocates all memory; later calls do not.
  ColumnField(const Law& law, double thickness, const Sections& nose, ColumnMath math = ColumnMath::vector)
      : ColumnField(law, thickness, nose, math, sweeps(math).of<Law>()) {}
  /// The same with a given sweep, for a law that is not in PadLaw.
  ColumnField(const Law& law, double thickness, const Sections& nose, ColumnMath math,
              const SweepOf<Law>& sweep)
      : law_(law),
        power_(law.exponents()),
        thickness_(thickness),
        nose_(nose),
        sweep_(sweep),
        sweeps_(&sweeps(math)) {}

  /// Changes to another pad in the same memory.
  void set(const Law& law, double thickness, const Sections& nose, ColumnMath math) {
    law_ = law;
    sweeps_ = &sweeps(math);
    sweep_ = sweeps_->of<Law>();
    if (law.exponents() != power_.exponents()) power_ = PowerShape(law.exponents());
    thickness_ = thickness;
    nose_ = nose;
  }

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  /// Penetration at which the pad locks, m: a gap of 1e-9 of the thickness is left (theory.md, Eq. 29).
  [[nodiscard]] double lock_penetration() const { return thickness_ * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return columns_.size(); }
  /// Number of column updates in all trials since the start, the cost of the run.
  [[nodiscard]] std::size_t updates() const { return updates_; }

  struct Column {
    double depth = 0;   ///< s, m
    double strain = 0;  ///< > 0
    double stress = 0;  ///< Pa, tension negative
  };
  /// Number of columns under strain in the accepted state; they are the first from the axis outwards.
  [[nodiscard]] std::size_t strained_columns() const { return live_; }
  [[nodiscard]] Column column(std::size_t j) const {
    const double depth = columns_.depth()[j];
    return {depth, (penetration_ - depth) / thickness_, columns_.now.stress[j]};
  }

  /// Starts a run, with the relative spacing of stations and the largest penetration for them, m.
  void start(double resolution, double expected = infinite) {
    clear(resolution);
    lay_columns(expected, thickness_);
  }
  /// Starts a run without columns, which are laid when the pad is first unloaded.
  void clear(double resolution) {
    resolution_ = resolution;
    penetration_ = largest_penetration_ = 0;
    live_ = 0;
    updates_ = 0;
    last_ = {};
    correction_ = 1;
    columns_.clear();
  }

  /// Lays columns for the unloading of a pad that was only loaded so far, in the state after `steps`. Their
  /// integral, which has the error of the stations, is scaled to continue from `force`, N.
  void begin_after(const std::vector<LoadingStep>& steps, double force) {
    penetration_ = largest_penetration_ = steps.empty() ? 0 : steps.back().penetration;
    last_ = {};
    columns_.clear();
    lay_columns(penetration_, penetration_);
    if (penetration_ <= 0) return;
    live_ = columns_.size();
    const SweepStep step{columns_.depth(), live_, thickness_, 0, penetration_, penetration_};
    sweeps_->replay(power_, steps.data(), steps.data() + steps.size(), step, columns_.now);
    updates_ += live_ * steps.size();
    correction_ = force / integrate(columns_.now, live_, penetration_, steps.back().modulus);
  }

  PadTrial trial(double advance, double from, double step) {
    const double rate = advance / (thickness_ * step);
    trial_ = penetration_ + advance;
    const PadTrial next{advance, from, step, 0};
    if (!next.shares_time_with(last_)) time_part_ = law_.time_part(from, from + step);
    // Series belong to trials from the accepted state.
    if (last_.step == 0) series_columns_ = 0;
    last_ = next;
    rate_part_ = law_.rate_part(rate);
    const double* depth = columns_.depth();
    trial_live_ = static_cast<std::size_t>(std::lower_bound(depth, depth + columns_.size(), trial_) - depth);
    updates_ += trial_live_;
    if (trial_live_ == 0) return last_;
    step_columns();
    const double edge = rate >= 0 ? law_.edge_ratio(rate_part_) : unknown_edge;
    last_.force = correction_ * integrate(*next_, trial_live_, trial_, edge);
    return last_;
  }

  [[nodiscard]] double force_rate_when_held(const PadTrial& trial) {
    recall(trial);
    if (trial_live_ == 0) return 0;
    const Columns& next = *next_;
    double edge = 0;
    double sum = sweep_.sum_of_held(law_, power_, trial.end(), sweep_step(), columns_.weights(), next, edge);
    sum += edge * edge_weights(trial_live_, trial_).inner *
           (next.measure[trial_live_ - 1] - edge_measure(trial_)) / 2;
    return correction_ * (tip_rate_when_held(trial.end()) + 2 * std::numbers::pi * thickness_ * sum);
  }

  /// Whether the step is so long that the force depends only on its rate, not on the state before.
  [[nodiscard]] bool forgets(const PadTrial& trial) const {
    constexpr double relaxation_times = 20;
    return trial.step * law_.relaxation_rate(trial.from) > relaxation_times;
  }

  /// Largest stress of any column, Pa, tension negative: contact is lost where it crosses zero.
  [[nodiscard]] double largest_stress(const PadTrial& trial) {
    recall(trial);
    if (trial_live_ == 0) return not_pressed;
    return *std::max_element(next_->stress, next_->stress + trial_live_);
  }

  void accept(const PadTrial& trial) {
    recall(trial);
    for (std::size_t j = trial_live_; j < columns_.size(); ++j) let_go(j);
    penetration_ = trial_;
    largest_penetration_ = std::max(largest_penetration_, penetration_);
    std::swap(columns_.now, *next_);
    live_ = trial_live_;
    last_ = {};
    if (penetration_ == largest_penetration_) grade_axis();
  }

  /// Pressing columns in the accepted state: their number, and the depth at which their stress ends, m.
  struct Stressed {
    std::size_t columns = 0;
    double depth = 0;
  };
  [[nodiscard]] Stressed stressed() const {
    const double* stress = columns_.now.stress;
    std::size_t j = live_;
    while (j > 0 && stress[j - 1] <= 0) --j;
    if (j == 0) return {};
    if (j == live_) return {j, std::min(penetration_, nose_.depth)};
    const double inner = columns_.depth()[j - 1];
    return {j, inner + (columns_.depth()[j] - inner) * stress[j - 1] / (stress[j - 1] - stress[j])};
  }
  /// Outer radius of the stressed area, m.
  [[nodiscard]] double contact_radius() const {
    const Stressed part = stressed();
    return part.columns == 0 ? 0 : nose_.radius(part.depth);
  }

 private:
  static constexpr double unknown_edge = -1;
  using Formulas = scalar::Formulas<Law>;

  [[nodiscard]] Strain strain_at(double penetration, double depth) const {
    return {(penetration - depth) / thickness_, ((thickness_ - penetration) + depth) / thickness_};
  }
  [[nodiscard]] SweepStep sweep_step() const {
    return {columns_.depth(), trial_live_, thickness_, penetration_, trial_, largest_penetration_};
  }
  /// Computes the columns after the trial: by series, if it ends near one whose columns were all computed, as
  /// the second and third trial of a search do, except for the outermost, whose strain it changes too much.
  void step_columns() {
    SweepStep step = sweep_step();
    if (series_columns_ > 0) {
      next_ = &columns_.moved;
      step.count = std::min(trial_live_, series_columns_);
      const MovedStep move{(trial_ - series_at_) / thickness_, max_bend_of_series(resolution_)};
      const std::size_t moved = sweep_.move(law_, power_, rate_part_, time_part_, step, columns_.now, *next_,
                                            move, columns_.tried, columns_.series);
      // Vectors of any number of lanes must leave the same columns to be computed.
      step.first = moved == step.count ? moved : moved - moved % 4;
      step.count = trial_live_;
      if (2 * step.first >= step.count) {
        sweep_.step(law_, power_, rate_part_, time_part_, step, columns_.now, *next_, nullptr);
        return;
      }
      step.first = 0;
    }
    next_ = &columns_.tried;
    sweep_.step(law_, power_, rate_part_, time_part_, step, columns_.now, *next_, &columns_.series);
    series_at_ = trial_;
    series_columns_ = trial_live_;
  }
  /// The numbers of a column's strain part.
  static std::array<double, Formulas::parts> parts_of(const Columns& columns, std::size_t j) {
    std::array<double, Formulas::parts> part;
    for (std::size_t k = 0; k < part.size(); ++k) part[k] = columns.part[k][j];
    return part;
  }
  /// Sets a column that the nose no longer touches to strain zero. The stresses of its branches continue to
  /// relax, and count again when the nose comes back.
  void let_go(std::size_t j) const {
    for (double* array : next_->all()) array[j] = 0;
    if constexpr (scalar::carries_branches<Law, double>) {
      std::array<double, Formulas::parts> left = parts_of(columns_.now, j);
      if (left[1] == 0 && left[2] == 0) return;
      const Formulas formulas{law_, power_, rate_part_, time_part_};
      // The strain vanished within a share of the step.
      const std::array<double, Formulas::parts> strained{left[0]};
      const double share = left[0] > 0 ? (penetration_ - columns_.depth()[j]) / (penetration_ - trial_) : 1;
      std::array<double, Formulas::parts> fallen{};
      static_cast<void>(formulas.carry(strained.data(), fallen.data(), share));
      formulas.relax(fallen.data(), 1 - share);
      formulas.relax(left.data(), 1.0);
      for (std::size_t k = 1; k < left.size(); ++k) next_->part[k][j] = left[k] + fallen[k];
    }
  }
  /// Force on the flat tip, below which the strain is that of the axis, N.
  [[nodiscard]] double on_tip(double stress) const {
    return nose_.tip > 0 ? nose_.tip * std::max(stress, 0.0) : 0;
  }
  [[nodiscard]] double tip_rate_when_held(double time) const {
    const double stress = next_->stress[0];
    if (!(nose_.tip > 0 && stress > 0)) return 0;
    if constexpr (scalar::carries_branches<Law, double>) {
      return nose_.tip * Formulas{law_, power_, {}, {}}.relaxing(parts_of(*next_, 0).data());
    }
    const double strain = trial_ / thickness_;
    const double largest = std::max(largest_penetration_, trial_) / thickness_;
    const double still = envelope(law_, power_, strain_at(trial_, 0), law_.rate_part(0), largest);
    return nose_.tip * relaxation_rate(law_, power_, time, strain) * (still - stress);
  }

  /// w at the outer end of the contact: 0 at its edge, or the value at d where the nose grows no wider.
  [[nodiscard]] double edge_measure(double penetration) const {
    return penetration <= nose_.depth ? 0 : power_.at(strain_at(penetration, nose_.depth)).measure;
  }
  /// Integral over a cell of the positive part of what is linear from `inner` to `outer`.
  static double positive_part(double inner, double outer, double width) {
    return scalar::positive_mean(inner, outer) * width;
  }

  /// Weights of the last cell, between the outermost of `live` columns and the end of the contact.
  [[nodiscard]] Sections::Weights edge_weights(std::size_t live, double penetration) const {
    return nose_.weights(columns_.depth()[live - 1], std::min(penetration, nose_.depth));
  }

  /// Eq. 20 over the first `live` columns and on to the contact edge, where stress over A is `edge`.
  [[nodiscard]] double integrate(const Columns& columns, std::size_t live, double penetration,
                                 double edge) const {
    const bool unloading = edge == unknown_edge;
    const Sections::Weights to_edge = edge_weights(live, penetration);
    const CellWeights weights = columns_.weights();
    const double last = columns.ratio[live - 1] * to_edge.inner;
    const double width = columns.measure[live - 1] - edge_measure(penetration);
    double sum = 0;
    if (unloading) {
      // The stress at the edge is not known: g is continued from the last two columns, within bounds.
      edge = last;
      if (live > 1) {
        const std::size_t j = live - 2;
        const double* w = columns.measure;
        const auto inner_g = [&](std::size_t i) { return columns.ratio[i] * weights.inner[i]; };
        const auto outer_g = [&](std::size_t i) { return columns.ratio[i + 1] * weights.outer[i]; };
        const double end = outer_g(j);
        // Stress over A of a column in tension has no bound as its strain vanishes. The cell inside it is
        // limited to the line through the next two columns, so that the force does not jump when it is gone.
        double outer = end;
        if (end < 0 && j > 0) {
          const double slope = (outer_g(j - 1) - inner_g(j - 1)) / (w[j - 1] - w[j]);
          outer = std::max(end, std::min(0.0, inner_g(j) + slope * (w[j] - w[j + 1])));
        }
        sum = sweeps_->sum_of_cells(columns, weights, j) +
              bounded(positive_part(inner_g(j), outer, w[j] - w[j + 1]), columns, j, j + 1,
                      {weights.inner[j], weights.outer[j]}, columns_.depth()[j + 1]);
        edge += (end - inner_g(j)) * width / (w[j] - w[j + 1]);
      }
      edge = std::min(edge, 0.0);
      sum += bounded(positive_part(last, edge, width), columns, live - 1, live - 1, to_edge, penetration);
    } else {
      // If the last column is met again in tension, nothing presses at the edge.
      if (last < 0) edge = 0;
      sum = sweeps_->sum_of_cells(columns, weights, live - 1) +
            positive_part(last, edge * to_edge.outer, width);
    }
    return on_tip(columns.stress[0]) + 2 * std::numbers::pi * thickness_ * sum;
  }

  /// Limits the integral of a cell. On unloading a column may still press as its strain vanishes: stress over
  /// A then has no bound, but the cell's force is bounded by its width times its stress.
  [[nodiscard]] double bounded(double cell, const Columns& columns, std::size_t a, std::size_t b,
                               const Sections::Weights& weights, double outer_depth) const {
    const double outer = std::min(outer_depth, nose_.depth);
    // Where the area of the nose grows ever faster, the outer end of the cell has the larger weight.
    const double inner_weight = std::max(weights.inner, weights.outer);
    const double top = std::max({columns.stress[a] * inner_weight, columns.stress[b] * weights.outer, 0.0});
    return std::min(cell, 1.5 * top * (outer - columns_.depth()[a]) / thickness_);
  }

  /// Lays columns at rest from the axis to the depth `reach`, m, or as far as the nose grows wider.
  void lay_columns(double expected, double reach) {
    lay_stations(nose_, {resolution_, expected, reach, thickness_ - penetration_},
                 [this](double depth) { columns_.append(depth); });
    columns_.fill_spare();
    for (std::size_t j = 0; j + 1 < columns_.size(); ++j) weigh_cell(j);
  }
  /// Sets the weights of the cell from the j-th column outwards.
  void weigh_cell(std::size_t j) {
    const Sections::Weights weights = nose_.weights(columns_.depth()[j], columns_.depth()[j + 1]);
    columns_.set_weights(j, weights.inner, weights.outer);
  }
  /// Splits cells near the axis as the gap closes, since the stress varies over the gap there.
  void grade_axis() {
    const double gap = thickness_ - penetration_;
    const double widest = station_spacing.of_gap * resolution_;
    const double* depth = columns_.depth();
    for (std::size_t j = 0;
         j + 1 < live_ && depth[j] <= station_spacing.graded * gap && columns_.size() < max_stations; ++j)
      while (depth[j + 1] - depth[j] > widest * (gap + depth[j]) && columns_.size() < max_stations)
        insert_after(j, std::sqrt((gap + depth[j]) * (gap + depth[j + 1])) - gap);
  }

  /// Inserts a column while loading. Its stress over its envelope is interpolated linearly in w between its
  /// neighbours, which is smooth whatever the shape of the envelope.
  void insert_after(std::size_t j, double depth) {
    const Columns& now = columns_.now;
    const Formulas formulas{law_, power_, rate_part_, time_part_};
    const Strain strain = strain_at(penetration_, depth);
    const scalar::Strains<double> e{strain.value, strain.complement};
    std::array<double, Formulas::parts> part{};
    const auto at = formulas.strain_part(e, part.data());
    const double measure = measure_of(formulas, e, at);
    const double outer = relaxed(j + 1);
    const double relative =
        outer + (relaxed(j) - outer) * (measure - now.measure[j + 1]) / (now.measure[j] - now.measure[j + 1]);
    if constexpr (scalar::carries_branches<Law, double>) {
      // Each branch over the lasting stress is interpolated likewise.
      const double share = (measure - now.measure[j + 1]) / (now.measure[j] - now.measure[j + 1]);
      for (std::size_t k = 1; k < part.size(); ++k) {
        const auto over = [&](std::size_t i) {
          return now.part[0][i] > 0 ? now.part[k][i] / now.part[0][i] : 0;
        };
        part[k] = part[0] * (over(j + 1) + (over(j) - over(j + 1)) * share);
      }
    }
    columns_.insert(j + 1, depth);
    weigh_cell(j);
    weigh_cell(j + 1);
    double stress = relative * formulas.envelope(part.data(), strain.value, strain.value);
    if constexpr (scalar::carries_branches<Law, double>) stress = part[0] + part[1] + part[2];
    for (std::size_t k = 0; k < part.size(); ++k) now.part[k][j + 1] = part[k];
    now.stress[j + 1] = stress;
    now.shape[j + 1] = at.shape;
    now.measure[j + 1] = measure;
    now.ratio[j + 1] = stress / at.shape;
    ++live_;
  }

  /// Stress over envelope of a column while loading.
  [[nodiscard]] double relaxed(std::size_t j) const {
    const double strain = (penetration_ - columns_.depth()[j]) / thickness_;
    const Formulas formulas{law_, power_, rate_part_, time_part_};
    return columns_.now.stress[j] / formulas.envelope(parts_of(columns_.now, j).data(), strain, strain);
  }

  /// Repeats a trial from the accepted state unless it is the last one.
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }

  Law law_;
  PowerShape power_;
  double thickness_;
  Sections nose_;
  SweepOf<Law> sweep_;
  const Sweeps* sweeps_;
  double resolution_ = 0.05;
  double penetration_ = 0;
  double largest_penetration_ = 0;
  double trial_ = 0;
  typename Law::RatePart rate_part_{};  ///< rate part of the last trial; time_part_ likewise
  typename Law::TimePart time_part_{};
  PadTrial last_;               ///< step 0: no trial from the accepted state
  double correction_ = 1;       ///< factor of the contact integral
  std::size_t live_ = 0;        ///< columns under strain in the accepted state
  std::size_t trial_live_ = 0;  ///< columns under strain at the end of the trial
  std::size_t updates_ = 0;
  double series_at_ = 0;            ///< penetration about which there are series, m
  std::size_t series_columns_ = 0;  ///< columns that have them, from the axis on
  ColumnStorage columns_;
  Columns* next_ = &columns_.tried;  ///< the columns after the trial: tried or moved
};

}  // namespace dashpad
