#pragma once
/// A nose on a pad of layers: columns of layers in series at fixed depths (theory.md, Eqs. 51 to 55).
///
///   F = a0 max(stress(0), 0) + int max(stress(s), 0) a'(s) ds, over s in [0, min(Y, d)]   (theory.md, Eq. 6)
///   int = 2 pi L int max(g, 0) dw,  g = stress a' / (2 pi A),  dw = A d(y / L)            (theory.md, Eq.
///   55)
///
/// A is the stress of the column pressed slowly, and w its area: stress over A is smooth at the contact edge
/// and near full compression, and g is taken as linear in w between stations. Each layer of each column keeps
/// its own strain, largest strain and slip, since the layers' shares of a column's shortening change with its
/// rate.
///
/// Lengths in m, stress in Pa, compression positive.

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "model/contact/contact.hpp"
#include "model/contact/station_layout.hpp"
#include "model/pad/layer/series.hpp"

namespace dashpad {

/// The columns of a pad of layers: one array for each quantity, allocated once.
class LayerColumns {
 public:
  /// State of the columns at one moment.
  struct Moment {
    double* stress = nullptr;       ///< Pa; below 0 where the column is free of stress
    double* y = nullptr;            ///< shortening, m
    double* flexibility = nullptr;  ///< dy/d(stress) over the step, m/Pa
    /// Arrays for each layer.
    std::array<double*, max_layers> strain{}, largest{}, rate{}, memory{}, layer_flexibility{};
  };

  explicit LayerColumns(std::size_t layers) : layers_(layers) {
    memory_ = std::make_unique_for_overwrite<double[]>((6 + 2 * (3 + 5 * layers)) * max_stations);
    double* next = memory_.get();
    const auto take = [&next] {
      double* array = next;
      next += max_stations;
      return array;
    };
    for (double** array : {&depth_, &inner_, &outer_, &shape, &measure, &chord}) *array = take();
    for (Moment* moment : {&now, &next_moment}) {
      for (double** array : {&moment->stress, &moment->y, &moment->flexibility}) *array = take();
      for (auto* each :
           {&moment->strain, &moment->largest, &moment->rate, &moment->memory, &moment->layer_flexibility})
        for (std::size_t i = 0; i < layers; ++i) (*each)[i] = take();
    }
  }

  [[nodiscard]] std::size_t layers() const { return layers_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const double* depth() const { return depth_; }
  /// Weights a'(s) / (2 pi) of the cell between a column and the next, m: at the column and at the next.
  [[nodiscard]] const double* inner_weight() const { return inner_; }
  [[nodiscard]] const double* outer_weight() const { return outer_; }

  void clear() { size_ = 0; }
  void append(double depth) { depth_[size_++] = depth; }
  void set_weights(std::size_t cell, double inner, double outer) {
    inner_[cell] = inner;
    outer_[cell] = outer;
  }

  Moment now;
  Moment next_moment;
  // Values of the last trial.
  double* shape = nullptr;    ///< A, Pa
  double* measure = nullptr;  ///< w, Pa
  double* chord = nullptr;    ///< d(stress)/dy over the last step, Pa/m; the guess for the next

 private:
  std::size_t layers_;
  std::unique_ptr<double[]> memory_;
  double* depth_ = nullptr;
  double* inner_ = nullptr;
  double* outer_ = nullptr;
  std::size_t size_ = 0;
};

class LayeredContact {
 public:
  using Parts = std::vector<LayerSeries::Part>;

  LayeredContact(const Parts& parts, const Sections& nose);
  void set(const Parts& parts, const Sections& nose);

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  [[nodiscard]] double lock_penetration() const { return series_.thickness() * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return columns_.size(); }
  /// Number of layer stresses computed in all trials since the start.
  [[nodiscard]] std::size_t updates() const { return updates_; }
  /// Number of these for a root within a root.
  [[nodiscard]] std::size_t nested_updates() const { return nested_updates_; }

  void start(double resolution, double expected);
  PadTrial trial(double advance, double from, double step);
  [[nodiscard]] double force_rate_when_held(const PadTrial& trial);
  /// dF/dY of the slow stress alone, N/m; what a change of the rate adds does not act like a spring.
  [[nodiscard]] double lasting_stiffness(const PadTrial& trial);
  [[nodiscard]] double largest_stress(const PadTrial& trial);
  void accept(const PadTrial& trial);

  /// Outer radius of the stressed area in the accepted state, m.
  [[nodiscard]] double contact_radius() const;

  /// A column in the accepted state.
  struct Column {
    double depth = 0;   ///< depth at which the nose's surface meets it, m
    double strain = 0;  ///< strain of the whole column, y / L
    double stress = 0;  ///< Pa; below 0 where it is free of stress
  };
  /// Number of columns that the nose has reached so far, from the axis outwards.
  [[nodiscard]] std::size_t touched_columns() const { return touched_; }
  [[nodiscard]] Column column(std::size_t j) const;
  [[nodiscard]] std::size_t layers() const { return series_.size(); }
  /// Strain of a layer on the axis in the accepted state.
  [[nodiscard]] double axis_strain(std::size_t layer) const;

 private:
  [[nodiscard]] Shortening shortening(std::size_t j, double penetration) const;
  [[nodiscard]] LayerStates states_before(std::size_t j) const;
  [[nodiscard]] ColumnGuess guess(std::size_t j, const LayerStates& now, double y) const;
  void solve_column(std::size_t j);
  void weigh_columns();
  [[nodiscard]] double integrate() const;
  /// A cell between two columns, or from the last one to the edge of the contact.
  struct Cell {
    std::size_t inner = 0;
    std::size_t outer = 0;
    Sections::Weights weights;
    double width = 0;  ///< width in w, Pa
  };
  template <class Visit>
  void for_each_cell(Visit&& visit) const;
  /// g at both ends of a cell, Pa m.
  struct Ends {
    double inner = 0;
    double outer = 0;
  };
  [[nodiscard]] Ends g(const Cell& cell) const;
  /// A and w at the edge of the contact.
  [[nodiscard]] FoamCurve::Point edge_of_contact() const;
  [[nodiscard]] Strain pad_strain(const Shortening& shortening) const;
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }

  Parts parts_;
  LayerSeries series_;
  Sections nose_;
  LayerColumns columns_;
  double penetration_ = 0;
  double largest_ = 0;       ///< largest penetration so far, m
  double last_step_ = 0;     ///< length of the last step, s; 0: there was none
  std::size_t touched_ = 0;  ///< columns that the nose has reached so far
  PadTrial last_;            ///< step 0: no trial from the accepted state
  bool has_trial_ = false;   ///< whether the last trial had the same start and length
  double trial_penetration_ = 0;
  std::size_t trial_touched_ = 0;
  std::size_t trial_live_ = 0;  ///< columns under the nose at the end of the trial
  std::size_t updates_ = 0;
  std::size_t nested_updates_ = 0;
};

static_assert(FollowsRate<LayeredContact>);

}  // namespace dashpad
