#pragma once
/// Unloading in the CVODE oracle: from the turning point to release. See cvode_impact.hpp.

#include <algorithm>
#include <numbers>
#include <vector>

#include "oracle/contact_grid.hpp"
#include "oracle/impact_run.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/speed_root.hpp"

namespace dashpad::oracle {

template <class Formulas>
class UnloadingPhase final : public OdeSystem {
 public:
  UnloadingPhase(ImpactRun& run, const Formulas& law, const ChebyshevGrid& loaded, const TurningPoint& turn)
      : run_(run),
        law_(law),
        count_(static_cast<std::size_t>(run.options.unloading_columns)),
        deepest_(turn.state[penetration]),
        state_(first_column + count_),
        time_(turn.time),
        places_(count_),
        element_(count_),
        relaxation_(count_),
        largest_(count_),
        point_(count_),
        column_(count_),
        holding_(count_, true),
        usable_(count_),
        parts_(run.options.unloading_columns) {
    const Grading grading{run.options.axis_grading, 3};
    const auto intervals = static_cast<double>(count_ - 1);
    std::copy(turn.state.begin(), turn.state.end(), state_.begin());
    for (std::size_t i = 0; i < count_; ++i) {
      const GridPoint& place = places_[i] = grid_point(static_cast<double>(i) / intervals, grading);
      largest_[i] = deepest_ * place.rest / run.thickness;
      element_[i] =
          2 * std::numbers::pi * deepest_ * place.slope / intervals * (run.radius - deepest_ * place.share);
      if (place.rest == 0) continue;  // the edge itself carries nothing
      const double complement = (run.thickness - deepest_ + deepest_ * place.share) / run.thickness;
      const StrainPoint point = strain_point(largest_[i], complement, law.m(), law.n());
      state_[first_column + i] =
          point.shape * loaded.interpolate(turn.ratio, grid_coordinate(place.rest, loaded.grading));
      stress_scale_ = std::fmax(stress_scale_, state_[first_column + i]);
    }
    holding_.back() = false;
  }

  void run() {
    force_scale_ = run_.result.peak_force;
    prepare(time_, state_.data());
    if (!run_.support.rigid()) find_first_speed();
    run_.result.turning_speed = speed_of_penetration(state_.data());
    OdeSession session(*this, Method::adams_fixed, time_, state_);
    for (;;) {
      if (!session.step()) {
        run_.result.ending = Ending::failed;
        break;
      }
      double* state = session.state();
      prepare(session.time(), state);
      if (session.at_event() && handle(session)) break;
      if (parts_.empty()) {  // between two steps, without an event: the last columns went together
        released(session);
        break;
      }
      if (!run_.support.rigid() && run_.support.stiffness() * (state[velocity] - rounding * run_.speed) >
                                       pad_force_rate(law_.at_rate(0))) {
        run_.result.ending = Ending::reloading;
        break;
      }
      // Columns that let go do not come back.
      for (std::size_t i = 0; i < count_; ++i) holding_[i] = holding_[i] && state[first_column + i] > 0;
    }
    run_.note_work(session);
  }

  bool derivative(double time, const double* state, double* slope) override {
    prepare(time, state);
    const double speed = speed_of_penetration(state);
    const auto rate = law_.at_rate(speed / run_.thickness);
    slope[motion] = state[velocity];
    slope[velocity] = -force_of(state) / run_.mass;
    slope[penetration] = speed;
    for (std::size_t i = 0; i < count_; ++i)
      slope[first_column + i] = usable_[i] ? stress_rate(i, rate, state) : 0;
    return true;
  }

  void allowances(const double* state, double* allowance) override {
    const double rtol = run_.options.rtol;
    const double atol = rtol * run_.options.atol;
    allowance[motion] = rtol * std::fabs(state[motion]) + atol * run_.thickness;
    allowance[velocity] = rtol * std::fabs(state[velocity]) + atol * run_.speed;
    const double gap = std::fmax(run_.thickness - state[penetration], 0);
    allowance[penetration] = rtol * gap + 1e-12 * run_.thickness;
    for (std::size_t i = 0; i < count_; ++i) {
      const double stress = state[first_column + i];
      allowance[first_column + i] =
          holding_[i] && stress > 0 ? rtol * stress + atol * stress_scale_ * 0.1 : no_limit;
    }
  }

  [[nodiscard]] int event_count() const override { return 6; }
  void events(double time, const double* state, double* values) override {
    prepare(time, state);
    const double force = force_of(state);
    values[event_weight] =
        state[velocity] < 0 ? (force - run_.mass * run_.options.gravity) / force_scale_ : 1;
    values[event_contact_end] =
        state[velocity] < 0 ? (force - contact_end_share * run_.result.peak_force) / force_scale_ : 1;
    values[event_release] = largest_stress(state) / stress_scale_;
    values[event_peak_motion] = state[velocity];
    values[event_peak_force] = force_rate_now(state);
    values[event_corner] =
        run_.support.rigid() ? 1 : run_.support.to_corner_below(state[motion] - state[penetration]);
  }

 private:
  enum : std::size_t {
    event_weight,
    event_contact_end,
    event_release,
    event_peak_motion,
    event_peak_force,
    event_corner
  };
  static constexpr double no_limit = 1e30;
  static constexpr double rounding = 1e-6;  ///< of the turning point rule, in impact speeds
  using Rate = typename Formulas::Rate;

  void prepare(double time, const double* state) {
    const double back = deepest_ - state[penetration];
    for (std::size_t i = 0; i < count_; ++i) {
      const double strain = largest_[i] - back / run_.thickness;
      usable_[i] = holding_[i] && strain > 0;
      if (!usable_[i]) continue;
      const double complement =
          (run_.thickness - state[penetration] + deepest_ * places_[i].share) / run_.thickness;
      point_[i] = strain_point(strain, complement, law_.m(), law_.n());
      column_[i] = law_.at_strain(point_[i]);
      relaxation_[i] = law_.relaxation(time, strain);
    }
    parts_.find(state + first_column, usable_);
    columns_ = state + first_column;
  }

  [[nodiscard]] double stress_rate(std::size_t k, const Rate& rate, const double* state) const {
    const Envelope envelope = law_.envelope(point_[k], column_[k], rate, largest_[k]);
    return law_.envelope_rate(envelope, rate) + relaxation_[k] * (envelope.value - state[first_column + k]);
  }
  [[nodiscard]] double pad_force_rate(const Rate& rate) const {
    const std::vector<double>& weight = parts_.weights();
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if (weight[i] != 0) sum += weight[i] * element_[i] * stress_rate(i, rate, columns_ - first_column);
    return sum;
  }
  [[nodiscard]] double pad_force() const {
    const std::vector<double>& weight = parts_.weights();
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += weight[i] * element_[i] * columns_[i];
    return sum;
  }
  [[nodiscard]] double force_of(const double* state) const {
    return run_.support.rigid() ? pad_force() : run_.support.force(state[motion] - state[penetration]);
  }
  /// Negative where the pad lets go faster than the support asks for, x = ln|v|.
  [[nodiscard]] double imbalance(double log_speed, const double* state) const {
    const double speed = std::exp(log_speed);
    return run_.support.stiffness() * (state[velocity] + speed) -
           pad_force_rate(law_.at_rate(-speed / run_.thickness));
  }
  /// The finite root: sought from fast to slow, so that the root at rest is not taken for it.
  void find_first_speed() {
    double log_speed = std::log(10 * run_.speed);
    while (log_speed > log_of_no_speed / 2 && imbalance(log_speed, state_.data()) > 0) log_speed -= 0.1;
    root_.guess(log_speed + 0.05);
  }
  [[nodiscard]] double speed_of_penetration(const double* state) {
    if (run_.support.rigid()) return std::fmin(state[velocity], 0);
    return -std::exp(root_.find([&](double log_speed) { return imbalance(log_speed, state); }));
  }
  [[nodiscard]] double force_rate_now(const double* state) {
    const double speed = speed_of_penetration(state);
    if (run_.support.rigid()) return pad_force_rate(law_.at_rate(speed / run_.thickness)) / force_scale_;
    return state[velocity] - speed;
  }
  /// Of the parabola through the largest node and its neighbours.
  [[nodiscard]] double largest_stress(const double* state) const {
    const double* stress = state + first_column;
    std::size_t top = 0;
    while (top + 1 < count_ && !holding_[top]) ++top;
    for (std::size_t i = top; i < count_; ++i)
      if (holding_[i] && stress[i] > stress[top]) top = i;
    if (top == 0 || top + 1 == count_) return stress[top];
    const double left = stress[top - 1];
    const double right = stress[top + 1];
    const double bend = 2 * stress[top] - left - right;
    return stress[top] + (bend > 0 ? (right - left) * (right - left) / (8 * bend) : 0);
  }

  /// True when the run is over.
  bool handle(OdeSession& session) {
    const double* state = session.state();
    const auto& crossed = session.crossings();
    if (crossed[event_peak_motion] != 0) run_.result.peak_motion = state[motion];
    if (crossed[event_peak_force] != 0) run_.note_force(session.time(), force_of(state));
    if (crossed[event_weight] < 0 && !run_.result.weight)
      run_.result.weight = Moment{session.time(), state[velocity]};
    if (crossed[event_contact_end] < 0) run_.result.contact_end = Moment{session.time(), state[velocity]};
    if (crossed[event_release] < 0) {
      released(session);
      return true;
    }
    if (crossed[event_corner] != 0) {
      run_.support.last_segment();
      session.restart();
    }
    return false;
  }
  void released(OdeSession& session) {
    const double* state = session.state();
    run_.result.release = Moment{session.time(), state[velocity]};
    run_.note_drift(pad_force(), force_of(state));
    const double ratio = state[velocity] / run_.speed;
    run_.result.energy_absorbed = 1 - ratio * ratio;
    run_.result.ending = Ending::released;
  }

  ImpactRun& run_;
  Formulas law_;
  std::size_t count_;
  double deepest_;
  std::vector<double> state_;
  double time_;
  double stress_scale_ = 0;  ///< Pa
  double force_scale_ = 1;   ///< N
  std::vector<GridPoint> places_;
  std::vector<double> element_;  ///< 2 pi (R - s) ds of a node
  std::vector<double> relaxation_;
  std::vector<double> largest_;  ///< e*
  std::vector<StrainPoint> point_;
  std::vector<typename Formulas::Column> column_;
  std::vector<char> holding_;  ///< columns that have not let go
  std::vector<char> usable_;   ///< and that the law can be asked for in the present state
  PositiveParts parts_;
  const double* columns_ = nullptr;
  SpeedRoot root_;
};

}  // namespace dashpad::oracle
