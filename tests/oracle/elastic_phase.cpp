#include "oracle/elastic_phase.hpp"

#include <numbers>

namespace dashpad::oracle {

namespace {

class ElasticPhase final : public OdeSystem {
 public:
  ElasticPhase(ImpactRun& run, double modulus)
      : run_(run), factor_(2 * std::numbers::pi * modulus / run.thickness) {}

  void run() {
    OdeSession session(*this, Method::adams_fixed, 0, {0, run_.speed, 0});
    while (session.step()) {
      const double* state = session.state();
      if (!session.at_event()) continue;
      const auto& crossed = session.crossings();
      if (crossed[event_turning] < 0) {
        run_.result.peak_motion = state[motion];
        run_.result.peak_penetration = state[penetration];
        run_.result.time_of_turning = session.time();
        run_.note_force(session.time(), force_of(state));
        run_.note_drift(pad_force(state[penetration]), force_of(state));
      }
      if (crossed[event_bottom] < 0) {
        run_.result.bottomed = Moment{session.time(), state[velocity]};
        run_.result.ending = Ending::bottomed_out;
        break;
      }
      if (crossed[event_weight] < 0) run_.result.weight = Moment{session.time(), state[velocity]};
      if (crossed[event_contact_end] < 0) run_.result.contact_end = Moment{session.time(), state[velocity]};
      if (crossed[event_above] != 0 || crossed[event_below] != 0) {
        crossed[event_above] != 0 ? run_.support.next_segment() : run_.support.last_segment();
        session.restart();
      }
      if (crossed[event_release] < 0) {
        run_.result.release = Moment{session.time(), state[velocity]};
        const double ratio = state[velocity] / run_.speed;
        run_.result.energy_absorbed = 1 - ratio * ratio;
        run_.result.ending = Ending::released;
        break;
      }
    }
    run_.note_work(session);
  }

  bool derivative(double, const double* state, double* slope) override {
    double speed = state[velocity];
    if (!run_.support.rigid()) {
      const double stiffness = run_.support.stiffness();
      speed *= stiffness / (pad_stiffness(state[penetration]) + stiffness);
    }
    slope[motion] = state[velocity];
    slope[velocity] = -force_of(state) / run_.mass;
    slope[penetration] = speed;
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    const double rtol = run_.options.rtol;
    const double atol = rtol * run_.options.atol;
    allowance[motion] = rtol * std::fabs(state[motion]) + atol * run_.thickness;
    allowance[velocity] = rtol * std::fabs(state[velocity]) + atol * run_.speed;
    allowance[penetration] = rtol * std::fabs(state[penetration]) + atol * run_.thickness;
  }
  [[nodiscard]] int event_count() const override { return 7; }
  void events(double, const double* state, double* values) override {
    const bool rebound = state[velocity] < 0;
    const double deflection = state[motion] - state[penetration];
    values[event_turning] = state[velocity];
    values[event_weight] = rebound ? force_of(state) - run_.mass * run_.options.gravity : 1;
    values[event_contact_end] = rebound ? force_of(state) - contact_end_share * run_.result.peak_force : 1;
    values[event_release] = rebound ? state[penetration] : 1;
    values[event_bottom] = run_.thickness - state[penetration];
    values[event_above] = run_.support.rigid() ? 1 : run_.support.to_corner_above(deflection);
    values[event_below] = run_.support.rigid() ? 1 : run_.support.to_corner_below(deflection);
  }

 private:
  enum : std::size_t {
    event_turning,
    event_weight,
    event_contact_end,
    event_release,
    event_bottom,
    event_above,
    event_below
  };

  /// 2 pi (E/L) integral of (Y - s)(R - s) ds over the contact; deeper than R, over the whole nose.
  [[nodiscard]] double pad_force(double deep) const {
    const double nose = std::fmin(deep, run_.radius);
    return factor_ * nose * (run_.radius * deep - (run_.radius + deep) * nose / 2 + nose * nose / 3);
  }
  [[nodiscard]] double pad_stiffness(double deep) const {
    const double nose = std::fmin(deep, run_.radius);
    return factor_ * nose * (run_.radius - nose / 2);
  }
  [[nodiscard]] double force_of(const double* state) const {
    return run_.support.rigid() ? pad_force(state[penetration])
                                : run_.support.force(state[motion] - state[penetration]);
  }

  ImpactRun& run_;
  double factor_;
};

}  // namespace

void solve_elastic(ImpactRun& run, double modulus) { ElasticPhase(run, modulus).run(); }

}  // namespace dashpad::oracle
