#pragma once
/// Loading in the CVODE oracle: from first contact to the turning point, or to the bottom. See
/// cvode_impact.hpp.

#include <numbers>
#include <vector>

#include "oracle/contact_grid.hpp"
#include "oracle/impact_run.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/speed_root.hpp"

namespace dashpad::oracle {

template <class Formulas>
class LoadingPhase final : public OdeSystem {
 public:
  LoadingPhase(ImpactRun& run, const Formulas& law)
      : run_(run),
        law_(law),
        grid_(run.options.loading_columns, {run.options.axis_grading, run.options.edge_power}),
        inner_(grid_.points.size() - 1),
        weight_(inner_),
        relaxation_(inner_),
        point_(inner_),
        column_(inner_),
        ratio_(inner_ + 1),
        log_rest_(inner_) {
    for (std::size_t i = 0; i < inner_; ++i) log_rest_[i] = std::log(grid_.points[i].rest);
  }

  [[nodiscard]] const ChebyshevGrid& grid() const { return grid_; }

  /// Runs the phase. False when it ended the whole run (bottomed out or failed).
  bool run(TurningPoint& end) {
    double time = 0;
    const std::vector<double> start = just_after_contact(time);
    OdeSession session(*this, Method::bdf_dense, std::log(time), start);
    bool turned = false;
    while (!turned) {
      if (!session.step()) {
        run_.note_work(session);
        run_.result.ending = Ending::failed;
        return false;
      }
      if (!session.at_event()) continue;
      const double* state = session.state();
      time = std::exp(session.time());
      const auto& crossed = session.crossings();
      if (crossed[event_peak_motion] != 0) run_.result.peak_motion = state[motion];
      if (crossed[event_peak_force] != 0) run_.note_force(time, force_of(time, state));
      if (crossed[event_bottom] < 0) return bottom(session);
      if (crossed[event_corner] != 0) {
        run_.support.next_segment();
        prepare(time, state);
        turned = holding_margin(state) <= 0;
        session.restart();
      }
      turned = turned || crossed[event_turning] < 0;
    }
    end.time = time;
    const double* state = session.state();
    std::copy(state, state + 3, end.state.begin());
    const double force = force_of(end.time, state);
    run_.note_force(end.time, force);
    run_.note_drift(pad_force(), force);
    run_.note_work(session);
    run_.result.peak_penetration = state[penetration];
    run_.result.time_of_turning = end.time;
    ratio_.back() = law_.edge(law_.at_rate(0));
    end.ratio = ratio_;
    return true;
  }

  /// The independent variable is ln t: near first contact everything happens on the scale of t itself.
  bool derivative(double log_time, const double* state, double* slope) override {
    const double time = std::exp(log_time);
    if (!(state[penetration] > 0 && state[penetration] < run_.thickness)) return false;
    prepare(time, state);
    const double log_speed = speed_of_penetration(state);
    const double speed = speed_at(log_speed);
    const auto rate = rate_at(speed, log_speed);
    const double edge = law_.edge(rate);
    ratio_[inner_] = edge;
    const double force =
        run_.support.rigid() ? pad_force() : run_.support.force(state[motion] - state[penetration]);
    slope[motion] = state[velocity];
    slope[velocity] = -force / run_.mass;
    slope[penetration] = speed;
    const double growth = speed / state[penetration];
    for (std::size_t i = 0; i < inner_; ++i) {
      const double* row = &grid_.differentiate[i * (inner_ + 1)];
      double gradient = 0;
      for (std::size_t j = 0; j < inner_; ++j) gradient += row[j] * (ratio_[j] - edge);  // less rounding
      slope[first_column + i] = (edge - ratio_[i]) * point_[i].log_slope * rate.rate +
                                law_.regular(point_[i], column_[i], rate, ratio_[i], relaxation_[i]) +
                                gradient * grid_.points[i].share * growth;
    }
    for (std::size_t i = 0; i < first_column + inner_; ++i) slope[i] *= time;
    return true;
  }

  void allowances(const double* state, double* allowance) override {
    const double rtol = run_.options.rtol;
    const double atol = rtol * run_.options.atol;
    allowance[motion] = rtol * std::fabs(state[motion]) + atol * run_.thickness;
    allowance[velocity] = rtol * std::fabs(state[velocity]) + atol * run_.speed;
    const double gap = std::fmax(run_.thickness - state[penetration], 0);
    allowance[penetration] = rtol * std::fmin(state[penetration], gap) + 1e-12 * run_.thickness;
    for (std::size_t i = 0; i < inner_; ++i)
      allowance[first_column + i] = rtol * std::fabs(state[first_column + i]) + atol * ratio_scale_;
  }

  [[nodiscard]] int event_count() const override { return 5; }
  void events(double log_time, const double* state, double* values) override {
    prepare(std::exp(log_time), state);
    values[event_turning] = holding_margin(state) / margin_scale_;
    values[event_peak_force] = force_rate_now(state) / margin_scale_;
    values[event_peak_motion] = state[velocity];
    values[event_bottom] = (run_.thickness - state[penetration]) / run_.thickness - smallest_gap;
    values[event_corner] =
        run_.support.rigid() ? 1 : run_.support.to_corner_above(state[motion] - state[penetration]);
  }

 private:
  enum : std::size_t { event_turning, event_peak_force, event_peak_motion, event_bottom, event_corner };
  static constexpr double smallest_gap = 1e-7;
  static constexpr double start_penetration = 1e-7;  ///< over the thickness
  using Rate = typename Formulas::Rate;

  /// Everything that a penetration and a time fix: strains, weights, relaxation rates, stresses over A.
  void prepare(double time, const double* state) {
    const double deep = state[penetration];
    const double log_scale = std::log(deep / run_.thickness);
    double shape_integral = 0;
    for (std::size_t i = 0; i < inner_; ++i) {
      const GridPoint& place = grid_.points[i];
      const double strain = deep * place.rest / run_.thickness;
      const double complement = (run_.thickness - deep + deep * place.share) / run_.thickness;
      point_[i] = strain_point(strain, complement, log_scale + log_rest_[i], law_.m(), law_.n());
      column_[i] = law_.at_strain(point_[i]);
      relaxation_[i] = law_.relaxation(time, strain);
      const double element = 2 * std::numbers::pi * grid_.weights[i] * deep * point_[i].shape;
      shape_integral += element;
      weight_[i] = element * (run_.radius - deep * place.share);
      ratio_[i] = state[first_column + i];
    }
    // 2 pi integral of A'(e)/L (R - s) ds, by parts.
    singular_ = 2 * std::numbers::pi * point_[0].shape * run_.radius - shape_integral;
  }

  [[nodiscard]] double pad_force() const {
    double force = 0;
    for (std::size_t i = 0; i < inner_; ++i) force += weight_[i] * ratio_[i];
    return force;
  }
  [[nodiscard]] double force_of(double time, const double* state) {
    prepare(time, state);
    return run_.support.rigid() ? pad_force() : run_.support.force(state[motion] - state[penetration]);
  }
  /// d(pad force)/dt at a speed of penetration.
  [[nodiscard]] double pad_force_rate(double speed, const Rate& rate) const {
    double sum = 0;
    for (std::size_t i = 0; i < inner_; ++i)
      sum += weight_[i] * law_.regular(point_[i], column_[i], rate, ratio_[i], relaxation_[i]);
    return law_.edge(rate) * singular_ * speed + sum;
  }
  [[nodiscard]] Rate rate_at(double speed, double log_speed) const {
    if (log_speed <= log_of_no_speed) return law_.at_rate(0);
    return law_.at_rate(speed / run_.thickness, log_speed - std::log(run_.thickness));
  }
  [[nodiscard]] static double speed_at(double log_speed) {
    return log_speed <= log_of_no_speed ? 0 : std::exp(log_speed);
  }
  /// D: how much faster the support's force grows than that of holding the pad.
  [[nodiscard]] double holding_margin(const double* state) const {
    if (run_.support.rigid()) return state[velocity] * margin_scale_;
    return run_.support.stiffness() * state[velocity] - pad_force_rate(0, law_.at_rate(0));
  }
  /// ln v; log_of_no_speed where the margin is spent.
  [[nodiscard]] double speed_of_penetration(const double* state) {
    if (run_.support.rigid()) return state[velocity] > 0 ? std::log(state[velocity]) : log_of_no_speed;
    if (holding_margin(state) <= 0) return log_of_no_speed;
    const double stiffness = run_.support.stiffness();
    return root_.find([&](double log_speed) {
      const double speed = speed_at(log_speed);
      return pad_force_rate(speed, rate_at(speed, log_speed)) - stiffness * (state[velocity] - speed);
    });
  }
  [[nodiscard]] double force_rate_now(const double* state) {
    const double log_speed = speed_of_penetration(state);
    const double speed = speed_at(log_speed);
    if (run_.support.rigid()) return pad_force_rate(speed, rate_at(speed, log_speed));
    return run_.support.stiffness() * (state[velocity] - speed);
  }

  std::vector<double> just_after_contact(double& time) {
    std::vector<double> state(first_column + inner_);
    state[velocity] = run_.speed;
    state[penetration] = start_penetration * run_.thickness;
    ratio_scale_ = law_.edge(law_.at_rate(run_.speed / run_.thickness));
    margin_scale_ = run_.support.rigid() ? ratio_scale_ * run_.radius * run_.speed
                                         : run_.support.stiffness() * run_.speed;
    time = state[penetration] / run_.speed;
    root_.guess(std::log(run_.speed));
    double speed = run_.speed;
    for (int k = 0; k < 4; ++k) {
      prepare(time, state.data());
      const Rate rate = law_.at_rate(speed / run_.thickness);
      for (std::size_t i = 0; i < inner_; ++i)
        state[first_column + i] = ratio_[i] = law_.started(point_[i], column_[i], rate);
      if (!run_.support.rigid()) {
        state[motion] = state[penetration] + run_.support.deflection(pad_force());
        speed = speed_at(speed_of_penetration(state.data()));
      } else {
        state[motion] = state[penetration];
      }
      time = state[motion] / run_.speed;
    }
    return state;
  }

  bool bottom(OdeSession& session) {
    const double* state = session.state();
    const double time = std::exp(session.time());
    prepare(time, state);
    const double speed = speed_at(speed_of_penetration(state));
    const double left = (run_.thickness - state[penetration]) / speed;
    run_.result.peak_penetration = run_.thickness;
    run_.result.peak_motion = std::fmax(run_.result.peak_motion, state[motion] + left * state[velocity]);
    run_.result.bottomed = Moment{time + left, state[velocity]};
    run_.result.ending = Ending::bottomed_out;
    run_.note_work(session);
    return false;
  }

  ImpactRun& run_;
  Formulas law_;
  ChebyshevGrid grid_;
  std::size_t inner_;  ///< columns inside the edge
  std::vector<double> weight_;
  std::vector<double> relaxation_;
  std::vector<StrainPoint> point_;
  std::vector<typename Formulas::Column> column_;
  std::vector<double> ratio_;
  std::vector<double> log_rest_;
  double singular_ = 0;
  double ratio_scale_ = 1;   ///< Pa
  double margin_scale_ = 1;  ///< N/s
  SpeedRoot root_;
};

}  // namespace dashpad::oracle
