#include "oracle/maxwell_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "oracle/gauss.hpp"

namespace dashpad::oracle {

namespace {

constexpr int panels = 12;           ///< of the whole contact
constexpr std::size_t columns = 48;  ///< of unloading
constexpr auto branches = MaxwellFormulas::branches;

/// A force and its slope over the penetration at fixed memory.
struct Force {
  double value = 0;  ///< N
  double slope = 0;  ///< N/m
  friend Force operator+(Force a, Force b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Force operator*(double k, Force a) { return {k * a.value, k * a.slope}; }
};

/// The penetration after a step of loading, for the history of the columns.
struct Instant {
  double time = 0;
  double depth = 0;  ///< Y, m
  double speed = 0;  ///< dY/dt, m/s
};

/// Motion, support and the events of both phases.
class MaxwellPhase : public OdeSystem {
 protected:
  MaxwellPhase(ImpactRun& run, const MaxwellFormulas& law) : run_(run), law_(law) {}

  enum : std::size_t {
    event_top,
    event_weight,
    event_contact_end,
    event_bottom,
    event_above,
    event_below,
    common_events
  };
  /// The first memory among the unknowns.
  static constexpr std::size_t memory = 2;

  /// Of the pad, at a penetration in m.
  [[nodiscard]] virtual Force pad_force(double y, const double* state) const = 0;

  /// The penetration at which the pad carries what the support gives, by Newton's rule.
  double find(const double* state) {
    const double x = state[motion];
    if (run_.support.rigid()) return x;
    const double full = run_.thickness * (1 - 1e-9);
    double y = std::min(found_, full);
    for (int i = 0; i < 60; ++i) {
      const Force pad = pad_force(y, state);
      const double step = (pad.value - run_.support.force(x - y)) / (pad.slope + run_.support.stiffness());
      y = y - step < full ? y - step : (y + full) / 2;
      if (std::fabs(step) < 1e-15 * run_.thickness) break;
    }
    return found_ = y;
  }

  void move(const double* state, double force, double* slope) const {
    slope[motion] = state[velocity];
    slope[velocity] = -std::fmax(force, 0) / run_.mass;
  }
  void allow_motion(const double* state, double* allowance) const {
    const double rtol = run_.options.rtol;
    const double atol = rtol * run_.options.atol;
    allowance[motion] = rtol * std::fabs(state[motion]) + atol * run_.thickness;
    allowance[velocity] = rtol * std::fabs(state[velocity]) + atol * run_.speed;
  }
  void common(const double* state, double y, double force, double* values) const {
    const bool rebound = state[velocity] < 0;
    const double deflection = state[motion] - y;
    values[event_top] = state[velocity];
    values[event_weight] = rebound ? force - run_.mass * run_.options.gravity : 1;
    values[event_contact_end] = rebound ? force - contact_end_share * run_.result.peak_force : 1;
    values[event_bottom] = run_.thickness * (1 - 1e-7) - y;
    values[event_above] = run_.support.rigid() ? 1 : run_.support.to_corner_above(deflection);
    values[event_below] = run_.support.rigid() ? 1 : run_.support.to_corner_below(deflection);
  }
  /// Notes what happened; false where the impact has ended.
  bool note(OdeSession& session) {
    CvodeImpact& result = run_.result;
    const double now = session.time();
    const double* state = session.state();
    const auto& crossed = session.crossings();
    if (crossed[event_top] < 0 && result.peak_motion == 0) result.peak_motion = state[motion];
    if (crossed[event_bottom] < 0) {
      result.bottomed = Moment{now, state[velocity]};
      result.ending = Ending::bottomed_out;
      return false;
    }
    if (crossed[event_weight] < 0) result.weight = Moment{now, state[velocity]};
    if (crossed[event_contact_end] < 0) result.contact_end = Moment{now, state[velocity]};
    if (crossed[event_above] < 0 || crossed[event_below] < 0) {
      crossed[event_above] < 0 ? run_.support.next_segment() : run_.support.last_segment();
      session.restart();
    }
    return true;
  }
  void release(double now, double speed) {
    run_.result.release = Moment{now, speed};
    run_.result.energy_absorbed = 1 - speed * speed / (run_.speed * run_.speed);
    run_.result.ending = Ending::released;
  }

  ImpactRun& run_;
  const MaxwellFormulas& law_;
  double found_ = 0;  ///< the last penetration, m
};

/// Loading below a sphere; the whole impact below a disc.
class MaxwellLoading final : public MaxwellPhase {
 public:
  MaxwellLoading(ImpactRun& run, const MaxwellFormulas& law, const Nose& nose) : MaxwellPhase(run, law) {
    if (const auto* disc = std::get_if<FlatDisc>(&nose))
      flat_ = std::numbers::pi * disc->radius * disc->radius;
    else if (!std::holds_alternative<Sphere>(nose))
      throw std::invalid_argument("CVODE oracle: below slow foams a sphere or a disc");
  }

  /// True where a sphere's loading has ended; then the history and the last state are there.
  bool run() {
    OdeSession session(*this, Method::adams_fixed, 0, {0, run_.speed, 0, 0});
    history_.push_back({0, 0, run_.speed});
    bool turned = false;
    while (!turned && session.step()) {
      const double* state = session.state();
      const double y = find(state);
      run_.note_force(session.time(), pad_force(y, state).value);
      run_.result.peak_penetration = std::max(run_.result.peak_penetration, y);
      history_.push_back({session.time(), y, rate(y, state)});
      if (!session.at_event()) continue;
      turned = session.crossings()[event_turning] < 0 && flat_ == 0;
      if (session.crossings()[event_turning] < 0 && run_.result.time_of_turning == 0)
        run_.result.time_of_turning = session.time();
      if (session.crossings()[event_release] < 0) {
        release(session.time(), state[velocity]);
        break;
      }
      if (!note(session)) break;
    }
    run_.note_work(session);
    std::copy_n(session.state(), last_.size(), last_.begin());
    return turned && run_.result.ending == Ending::failed;
  }
  [[nodiscard]] const std::vector<Instant>& history() const { return history_; }
  [[nodiscard]] const std::array<double, memory + branches>& last() const { return last_; }
  [[nodiscard]] double last_force() const { return pad_force(history_.back().depth, last_.data()).value; }

  bool derivative(double, const double* state, double* slope) override {
    const double y = find(state);
    if (!(y < run_.thickness)) return false;
    move(state, pad_force(y, state).value, slope);
    const double elastic = integral(y).value;
    for (std::size_t i = 0; i < branches; ++i)
      slope[memory + i] = (elastic - state[memory + i]) / law_.time[i];
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    allow_motion(state, allowance);
    const double rtol = run_.options.rtol;
    const double scale = rtol * run_.options.atol * integral(0.5 * run_.thickness).value;
    for (std::size_t i = 0; i < branches; ++i)
      allowance[memory + i] = rtol * std::fabs(state[memory + i]) + scale;
  }
  [[nodiscard]] int event_count() const override { return static_cast<int>(event_peak) + 1; }
  void events(double, const double* state, double* values) override {
    const double y = find(state);
    const Force pad = pad_force(y, state);
    common(state, y, pad.value, values);
    const double relaxing = relaxation(y, state);
    // What gives dY/dt its sign.
    values[event_turning] =
        run_.support.rigid() ? state[velocity] : state[velocity] + relaxing / run_.support.stiffness();
    values[event_release] = state[velocity] < 0 ? pad.value : 1;
    values[event_peak] = y > 0 ? pad.slope * state[velocity] - relaxing : 1;
  }

 private:
  enum : std::size_t { event_turning = common_events, event_release, event_peak };

  /// P of the lasting stress.
  [[nodiscard]] Force integral(double y) const {
    if (y <= 0) return {};
    const double top = y / run_.thickness;
    if (flat_ > 0) return {flat_ * law_.lasting(top), flat_ * law_.lasting_slope(top) / run_.thickness};
    const double low = std::sqrt(std::fmax(y - run_.radius, 0) / y);
    // 2 pi (R - s) ds with s = Y (1 - x^2).
    return gauss(low, 1, panels, [&](double x) {
      const double measure = 4 * std::numbers::pi * (run_.radius - y * (1 - x * x)) * x * y;
      return measure * Force{law_.lasting(top * x * x), law_.lasting_slope(top * x * x) / run_.thickness};
    });
  }
  [[nodiscard]] Force pad_force(double y, const double* state) const override {
    Force pad = law_.sudden * integral(y);
    for (std::size_t i = 0; i < branches; ++i) pad.value -= law_.share[i] * state[memory + i];
    return pad;
  }
  /// How fast the force falls while the penetration is held, N/s.
  [[nodiscard]] double relaxation(double y, const double* state) const {
    const double elastic = integral(y).value;
    double sum = 0;
    for (std::size_t i = 0; i < branches; ++i)
      sum += law_.share[i] * (elastic - state[memory + i]) / law_.time[i];
    return sum;
  }
  /// dY/dt from d(pad force)/dt = Ks (V - dY/dt).
  [[nodiscard]] double rate(double y, const double* state) const {
    if (run_.support.rigid()) return state[velocity];
    const double stiffness = run_.support.stiffness();
    return (stiffness * state[velocity] + relaxation(y, state)) / (pad_force(y, state).slope + stiffness);
  }

  double flat_ = 0;  ///< area of a disc, m2
  std::vector<Instant> history_;
  std::array<double, memory + branches> last_{};
};

/// Unloading below a sphere.
class MaxwellUnloading final : public MaxwellPhase {
 public:
  MaxwellUnloading(ImpactRun& run, const MaxwellFormulas& law, const MaxwellLoading& before)
      : MaxwellPhase(run, law), deepest_(before.history().back().depth), before_(before) {
    found_ = deepest_;
    low_ = std::sqrt(std::fmax(deepest_ - run.radius, 0) / deepest_);
    for (std::size_t k = 0; k < columns; ++k) {
      const double angle = std::numbers::pi * double(k) / (columns - 1);
      place_[k] = low_ + (1 - low_) * (1 - std::cos(angle)) / 2;
      weight_[k] = (k % 2 == 0 ? 1 : -1) * (k == 0 || k == columns - 1 ? 0.5 : 1.0);
    }
  }

  void run() {
    std::vector<double> start{before_.last()[motion], before_.last()[velocity]};
    for (std::size_t i = 0; i < branches; ++i)
      for (const double x : place_) start.push_back(remembered(depth_at(x), law_.time[i]));
    run_.note_drift(pad_force(deepest_, start.data()).value, before_.last_force());
    OdeSession session(*this, Method::adams_fixed, before_.history().back().time, start);
    while (session.step()) {
      if (!session.at_event()) continue;
      if (session.crossings()[event_again] < 0) {
        run_.result.ending = Ending::reloading;
        break;
      }
      if (session.crossings()[event_release] < 0) {
        release(session.time(), session.state()[velocity]);
        break;
      }
      if (!note(session)) break;
    }
    run_.note_work(session);
  }

  bool derivative(double, const double* state, double* slope) override {
    const double y = find(state);
    if (!(y < run_.thickness)) return false;
    move(state, pad_force(y, state).value, slope);
    for (std::size_t k = 0; k < columns; ++k) {
      const double lasting = law_.lasting(strain(y, place_[k]));
      for (std::size_t i = 0; i < branches; ++i) {
        const std::size_t at = memory + i * columns + k;
        slope[at] = (lasting - state[at]) / law_.time[i];
      }
    }
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    allow_motion(state, allowance);
    const double rtol = run_.options.rtol;
    const double scale = rtol * run_.options.atol * law_.lasting(0.5);
    for (std::size_t at = memory; at < memory + branches * columns; ++at)
      allowance[at] = rtol * std::fabs(state[at]) + scale;
  }
  [[nodiscard]] int event_count() const override { return static_cast<int>(event_again) + 1; }
  void events(double, const double* state, double* values) override {
    const double y = find(state);
    common(state, y, pad_force(y, state).value, values);
    double most = -law_.lasting(0.5);
    for (std::size_t k = 0; k < columns; ++k) most = std::fmax(most, stress_of(k, y, state));
    values[event_release] = state[velocity] < 0 ? most : 1;
    values[event_again] = deepest_ * (1 + 1e-7) - y;
  }

 private:
  enum : std::size_t { event_release = common_events, event_again };

  [[nodiscard]] double depth_at(double x) const { return deepest_ * (1 - x * x); }
  [[nodiscard]] double strain(double y, double x) const { return (y - depth_at(x)) / run_.thickness; }

  /// r at the end of loading: the integral of p exp(-(T - t) / tau) / tau since the column was touched.
  [[nodiscard]] double remembered(double depth, double time) const {
    const std::vector<Instant>& all = before_.history();
    const double end = all.back().time;
    double sum = 0;
    for (std::size_t j = 1; j < all.size(); ++j) {
      const Instant &a = all[j - 1], &b = all[j];
      if (b.depth <= depth || b.time <= a.time) continue;
      const double span = b.time - a.time;
      // Hermite's cubic from step to step.
      const auto depth_then = [&](double t) {
        const double u = (t - a.time) / span, w = 1 - u;
        return w * w * (1 + 2 * u) * a.depth + u * u * (1 + 2 * w) * b.depth +
               u * w * span * (w * a.speed - u * b.speed);
      };
      double from = a.time;
      if (a.depth < depth) {
        double beyond = b.time;
        for (int i = 0; i < 60; ++i) {
          const double middle = (from + beyond) / 2;
          (depth_then(middle) < depth ? from : beyond) = middle;
        }
      }
      const int count = std::min(1 + static_cast<int>(2 * span / time), 50);
      sum += gauss(from, b.time, count, [&](double t) {
        return law_.lasting((depth_then(t) - depth) / run_.thickness) * std::exp((t - end) / time) / time;
      });
    }
    return sum;
  }

  /// What the branches remember of a column, weighted by their shares.
  [[nodiscard]] double memory_of(std::size_t k, const double* state) const {
    double sum = 0;
    for (std::size_t i = 0; i < branches; ++i) sum += law_.share[i] * state[memory + i * columns + k];
    return sum;
  }
  [[nodiscard]] double stress_of(std::size_t k, double y, const double* state) const {
    return law_.sudden * law_.lasting(strain(y, place_[k])) - memory_of(k, state);
  }

  [[nodiscard]] Force pad_force(double y, const double* state) const override {
    std::array<double, columns> kept{};
    for (std::size_t k = 0; k < columns; ++k) kept[k] = memory_of(k, state);
    const auto stress = [&](double x) {
      // Barycentric interpolation of the memory.
      double above = 0, below = 0;
      for (std::size_t k = 0; k < columns; ++k) {
        if (x == place_[k]) return law_.sudden * law_.lasting(strain(y, x)) - kept[k];
        const double part = weight_[k] / (x - place_[k]);
        above += part * kept[k], below += part;
      }
      return law_.sudden * law_.lasting(strain(y, x)) - above / below;
    };
    const auto part = [&](double x) {
      const double measure = 4 * std::numbers::pi * (run_.radius - depth_at(x)) * x * deepest_;
      return measure * Force{stress(x), law_.sudden * law_.lasting_slope(strain(y, x)) / run_.thickness};
    };
    Force sum;
    double begin = low_;
    for (std::size_t k = 0; k < columns; ++k) {
      const bool presses = stress_of(k, y, state) > 0;
      const bool pressed = k > 0 ? stress_of(k - 1, y, state) > 0 : presses;
      if (presses != pressed) {
        double before = place_[k - 1], after = place_[k];
        for (int i = 0; i < 50; ++i) {
          const double middle = (before + after) / 2;
          ((stress(middle) > 0) == pressed ? before : after) = middle;
        }
        if (pressed) sum = sum + gauss(begin, before, panels, part);
        begin = after;
      }
      if (presses && k == columns - 1) sum = sum + gauss(begin, 1, panels, part);
    }
    return sum;
  }

  const double deepest_;
  const MaxwellLoading& before_;
  double low_ = 0;  ///< of x
  std::array<double, columns> place_{}, weight_{};
};

}  // namespace

MaxwellFormulas::MaxwellFormulas(const ViscoelasticFoam& law)
    : share{law.first_share, law.second_share},
      time{law.first_time, law.second_time},
      sudden(1 + law.first_share + law.second_share),
      terms_{{{2 * law.first_modulus / law.first_exponent, law.first_exponent},
              {2 * law.second_modulus / law.second_exponent, law.second_exponent}}} {}

double MaxwellFormulas::lasting(double strain) const {
  const double stretch = 1 - strain;
  double sum = 0;
  for (const auto& [factor, exponent] : terms_)
    sum -= factor * std::expm1(exponent * std::log1p(-strain)) / stretch;
  return sum;
}

double MaxwellFormulas::lasting_slope(double strain) const {
  const double stretch = 1 - strain;
  double sum = 0;
  for (const auto& [factor, exponent] : terms_)
    sum += factor * (1 + (exponent - 1) * std::pow(stretch, exponent)) / (stretch * stretch);
  return sum;
}

void solve_maxwell(ImpactRun& run, const MaxwellFormulas& law, const Nose& nose) {
  MaxwellLoading loading(run, law, nose);
  if (loading.run()) MaxwellUnloading(run, law, loading).run();
}

}  // namespace dashpad::oracle
