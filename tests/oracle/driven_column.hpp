#pragma once
/// One column under a prescribed strain, by CVODE: the rate form of the law (law_formulas.hpp) in time steps.
/// Independent of dashpad's laboratory, which has no steps and another form of the equation.

#include <algorithm>
#include <cmath>
#include <vector>

#include "dashpad/laboratory/column_test.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/ode_session.hpp"

namespace dashpad::oracle {

/// Stresses (Pa) at increasing times > 0, s since first contact. Where the stress falls to zero on unloading
/// it stays zero until the strain grows; then it starts from zero. The first piece must load.
template <class Formulas>
class DrivenColumn final : public OdeSystem {
 public:
  using Law = typename Formulas::Law;
  explicit DrivenColumn(const Law& law) : formulas_(law) {}

  std::vector<double> stresses(const std::vector<laboratory::StrainPiece>& pieces,
                               const std::vector<double>& times, double scale) {
    scale_ = scale;
    times_ = times;
    result_.clear();
    double begin = 0;
    for (const laboratory::StrainPiece& piece : pieces) {
      piece_ = piece;
      begin_ = begin;
      const double vertex = piece.acceleration == 0 ? 0 : -piece.rate / piece.acceleration;
      const bool turns = vertex > 0 && vertex < piece.duration;
      if (turns) follow(begin, begin + vertex);
      follow(turns ? begin + vertex : begin, begin + piece.duration);
      begin += piece.duration;
    }
    result_.resize(times.size(), 0.0);
    return result_;
  }

  bool derivative(double time, const double* state, double* slope) override {
    const double strain = piece_.strain_at(time - begin_);
    if (strain <= 0 || strain >= 1) return false;
    double rate = piece_.rate_at(time - begin_);
    rate = direction_ > 0 ? std::fmax(rate, 0.0) : direction_ < 0 ? std::fmin(rate, -0.0) : 0;
    const StrainPoint point = strain_point(strain, 1 - strain, formulas_.m(), formulas_.n());
    const auto terms = formulas_.at_rate(rate);
    const Envelope envelope = formulas_.envelope(point, formulas_.at_strain(point), terms, largest_);
    slope[0] = formulas_.envelope_rate(envelope, terms) +
               formulas_.relaxation(time, strain) * (envelope.value - state[0]);
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    allowance[0] = 1e-11 * std::fabs(state[0]) + 1e-12 * scale_;
  }
  void events(double time, const double* state, double* values) override {
    values[0] = time - target_;
    values[1] = direction_ < 0 ? state[0] : 1;
  }
  [[nodiscard]] int event_count() const override { return 2; }

 private:
  /// One stretch that does not turn.
  void follow(double from, double to) {
    const double middle = piece_.rate_at((from + to) / 2 - begin_);
    direction_ = middle > 0 ? 1 : middle < 0 ? -1 : 0;
    if (direction_ > 0) lost_ = false;
    double time = from;
    if (from == 0) {
      // Past the infinite slope at strain zero: so early, the rate is constant and the stress A q.
      time = 1e-10 / piece_.rate;
      const StrainPoint point = strain_point(1e-10, 1 - 1e-10, formulas_.m(), formulas_.n());
      const auto terms = formulas_.at_rate(piece_.rate);
      stress_ = point.shape * formulas_.started(point, formulas_.at_strain(point), terms);
    }
    while (result_.size() < times_.size() && times_[result_.size()] <= to) {
      const double target = times_[result_.size()];
      if (target > time) advance(time, target);
      time = std::max(time, target);
      result_.push_back(stress_);
    }
    if (to > time) advance(time, to);
    largest_ = std::max(largest_, piece_.strain_at(to - begin_));
  }

  void advance(double from, double to) {
    if (lost_) return;
    target_ = to;
    OdeSession session(*this, Method::bdf_dense, from, {stress_});
    while (session.step()) {
      stress_ = session.state()[0];
      if (!session.at_event()) continue;
      if (session.crossings()[1] != 0) lost_ = true;
      break;
    }
    // At strain zero CVODE gives up: the stress is tensile before.
    if (!session.at_event()) lost_ = true;
    if (lost_) stress_ = 0;
  }

  Formulas formulas_;
  laboratory::StrainPiece piece_;
  double begin_ = 0;
  int direction_ = 0;
  double target_ = 0, largest_ = 0, stress_ = 0, scale_ = 1;
  bool lost_ = false;
  std::vector<double> times_, result_;
};

}  // namespace dashpad::oracle
