#pragma once
/// A nose on a pad of layers: columns of layers in series at fixed depths (theory.md, Eqs. 51 to 55).
///
///   F = a0 max(stress(0), 0) + int max(stress(s), 0) a'(s) ds, over s in [0, min(Y, d)]   (theory.md, Eq. 6)
///   int = 2 pi L int max(g, 0) dw,  g = stress a' / (2 pi A),  dw = A d(y / L)           (theory.md, Eq. 55)
///
/// A is the stress of the column pressed slowly, and w its area: stress over A is smooth at the contact edge
/// and near full compression. Between stations g is a line in w with the bend of parabolas through the next
/// columns. Each layer of each column keeps its own strain, largest strain and slip, since its share of the
/// shortening changes with the rate.
///
/// Lengths in m, stress in Pa, compression positive.

#include <cstddef>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "model/contact/contact.hpp"
#include "model/contact/station_layout.hpp"
#include "model/pad/layer/series.hpp"

namespace dashpad {

class LayeredContact {
 public:
  using Parts = std::vector<LayerSeries::Part>;

  LayeredContact(const Parts& parts, const Sections& nose) : parts_(parts), series_(parts), nose_(nose) {
    places_.reserve(max_stations);
    for (std::vector<State>* moment : {&now_, &next_}) moment->reserve(max_stations);
  }
  void set(const Parts& parts, const Sections& nose);

  [[nodiscard]] bool recovers() const { return true; }
  [[nodiscard]] double first_force() const { return 0; }
  [[nodiscard]] double lock_penetration() const { return series_.thickness() * (1 - 1e-9); }
  [[nodiscard]] std::size_t stations() const { return places_.size(); }
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
  /// Where a column is, and what the integrals of the last trial take from it.
  struct Place {
    double depth = 0;                ///< depth at which the nose's surface meets it, m
    Sections::Weights weights = {};  ///< weights of the cell between it and the next
    double shape = 0;                ///< A, Pa
    double measure = 0;              ///< w, Pa
    double chord = 0;                ///< d(stress)/dy over the last step, Pa/m; the guess for the next
    double rate = 0;                 ///< rate of the stress while the nose is held, Pa/s
  };
  /// State of a column.
  struct State {
    double stress = 0;       ///< Pa; below 0 where the column is free of stress
    double y = 0;            ///< shortening, m
    double flexibility = 0;  ///< dy/d(stress) over the step, m/Pa
    LayerStates layers;
    PerLayer layer_flexibility{};
  };

  /// By how much the guess from the step before missed a column; the next one's misses alike.
  struct Miss {
    bool is_known = false;
    PerLayer strain{};             ///< strain less its guess
    PerLayer flexibility{};        ///< flexibility of a layer over its guess, at most a factor of two
    double total_flexibility = 1;  ///< the same for the column
  };

  [[nodiscard]] Shortening shortening(std::size_t j, double penetration) const;
  [[nodiscard]] LayerStates states_before(std::size_t j) const;
  /// The guess from the last trial of this step.
  [[nodiscard]] ColumnGuess guess_by_trial(std::size_t j, double y) const;
  /// The guess from the step before.
  [[nodiscard]] ColumnGuess guess_by_step(std::size_t j, const LayerStates& now, double y) const;
  [[nodiscard]] ColumnGuess corrected(ColumnGuess guess) const;
  void learn_miss(const ColumnGuess& guess, const LayerSeries::Solution& found);
  void solve_column(std::size_t j);
  void complete_states();
  void move_on(double further);
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
  template <class Value>
  [[nodiscard]] double bend(const Cell& cell, Value&& value) const;
  /// A and w at the edge of the contact.
  [[nodiscard]] FoamCurve::Point edge_of_contact() const;
  [[nodiscard]] Strain pad_strain(const Shortening& shortening) const;
  void recall(const PadTrial& wanted) {
    if (!last_.is_same_step_as(wanted)) trial(wanted.advance, wanted.from, wanted.step);
  }

  Parts parts_;
  LayerSeries series_;
  Sections nose_;
  std::vector<Place> places_;
  std::vector<State> now_;
  std::vector<State> next_;  ///< at the end of the last trial
  double precision_ = 0;     ///< of the layers' strains, as a share of their change over a step
  double penetration_ = 0;
  double last_step_ = 0;      ///< length of the last step, s; 0: there was none
  std::size_t touched_ = 0;   ///< columns that the nose has reached so far
  PadTrial last_;             ///< step 0: no trial from the accepted state
  Miss miss_;                 ///< of the column solved last in this trial
  bool is_complete_ = false;  ///< complete_states() was called since the last trial
  bool has_trial_ = false;    ///< whether the last trial had the same start and length
  double trial_penetration_ = 0;
  std::size_t trial_touched_ = 0;
  std::size_t trial_live_ = 0;  ///< columns under the nose at the end of the trial
  std::size_t updates_ = 0;
  std::size_t nested_updates_ = 0;
};

static_assert(FollowsRate<LayeredContact>);

}  // namespace dashpad
