#include "oracle/foam_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "oracle/gauss.hpp"
#include "oracle/outline.hpp"

namespace dashpad::oracle {

namespace {

constexpr int looks = 96;   ///< where the sign of the stress is asked
constexpr int panels = 16;  ///< of the whole contact

class FoamImpact final : public OdeSystem {
 public:
  FoamImpact(ImpactRun& run, const FoamFormulas& law, const Nose& nose)
      : run_(run),
        law_(law),
        nose_(outline_of(nose)),
        of_(run.backing),
        moves_(of_.mass > 0 || of_.damping > 0),
        inverse_body_(of_.body_mass > 0 ? 1 / of_.body_mass : 0),
        loading_(run.earlier == 0),
        largest_(run.earlier),
        crater_(law.stays_crushed() ? crater() : 0),
        found_(crater_) {
    if ((of_ != Backing{} && !moves_) || of_.loss_factor > 0 || of_.gap > 0 || of_.preload > 0)
      throw std::invalid_argument("CVODE oracle: a support with a damper or a panel");
  }

  void run() {
    std::vector<double> begin{crater_, run_.speed, crater_ / run_.thickness};
    if (moves_) begin.resize(unknowns_of_moving);
    OdeSession session(*this, Method::bdf_dense, 0, begin);
    std::array<double, 3> time{}, force{};
    int known = 0;
    CvodeImpact& result = run_.result;
    while (session.step()) {
      const double* state = session.state();
      const double now = session.time();
      const double y = find(state);
      const double f = contact_force(y, ahead(y), y / run_.thickness - state[slipped]);
      // The largest force between two steps of a phase: the vertex of a parabola.
      if (known > 0 && now <= time[2]) continue;
      time = {time[1], time[2], now}, force = {force[1], force[2], f};
      known = std::min(known + 1, 3);
      run_.note_force(now, f);
      if (known == 3) note_vertex(time, force);
      result.peak_penetration = std::max(result.peak_penetration, y);
      if (moves_ && crushes_on_) yield_ = state[deflection];
      if (loading_) largest_ = y;
      if (!session.at_event()) continue;
      const auto& crossed = session.crossings();
      bool changed = false;
      if (crossed[event_top] < 0 && result.peak_motion == 0) result.peak_motion = state[motion] - crater_;
      if (crossed[event_turning] < 0 && loading_) {
        loading_ = false, changed = true;
        largest_ = y;
        if (result.time_of_turning == 0) result.time_of_turning = now;
      }
      if (crossed[event_again] > 0 && !loading_) loading_ = changed = true;
      if (moves_ && crossed[event_yield] != 0) {
        crushes_on_ = !crushes_on_, changed = true;
        if (!crushes_on_) yield_ = state[deflection];
      }
      if (crossed[event_bottom] < 0) {
        result.bottomed = Moment{now, state[velocity]};
        result.ending = Ending::bottomed_out;
        break;
      }
      if (crossed[event_weight] < 0) result.weight = Moment{now, state[velocity]};
      if (crossed[event_contact_end] < 0) result.contact_end = Moment{now, state[velocity]};
      if (crossed[event_above] < 0 || crossed[event_below] < 0) {
        crossed[event_above] < 0 ? run_.support.next_segment() : run_.support.last_segment();
        changed = true;
      }
      if (crossed[event_release] < 0) {
        result.release = Moment{now, state[velocity]};
        const double ratio = state[velocity] / run_.speed;
        result.energy_absorbed = 1 - ratio * ratio;
        if (moves_) result.body_velocity = state[body_velocity];
        result.ending = Ending::released;
        break;
      }
      if (changed) session.restart(), known = 0;
    }
    run_.note_work(session);
  }

  bool derivative(double, const double* state, double* slope) override {
    const double y = find(state);
    if (!(y < run_.thickness)) return false;
    const double g = y / run_.thickness - state[slipped];
    if (std::fabs(g) > 60 * law_.lag()) return false;
    slope[motion] = state[velocity];
    const double force = std::fmax(contact_force(y, ahead(y), g), 0);
    slope[velocity] = run_.gravity - force / run_.mass;
    slope[slipped] = law_.slip_rate(g);
    if (!moves_) return true;
    slope[deflection] = rate_of_support(state, force);
    const double behind = spring(state[deflection]) + of_.damping * slope[deflection];
    slope[rate] = of_.mass > 0 ? (force - behind) / of_.mass - behind * inverse_body_ : 0;
    slope[body] = state[body_velocity];
    slope[body_velocity] = behind * inverse_body_;
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    const double rtol = run_.options.rtol;
    const double atol = rtol * run_.options.atol;
    allowance[motion] = rtol * std::fabs(state[motion]) + atol * run_.thickness;
    allowance[velocity] = rtol * std::fabs(state[velocity]) + atol * run_.speed;
    allowance[slipped] = rtol * std::fabs(state[slipped]) + rtol * law_.lag();
    if (!moves_) return;
    for (const std::size_t way : {deflection, body})
      allowance[way] = rtol * std::fabs(state[way]) + atol * run_.thickness;
    for (const std::size_t speed : {rate, body_velocity})
      allowance[speed] = rtol * std::fabs(state[speed]) + atol * run_.speed;
  }
  [[nodiscard]] int event_count() const override { return 10; }
  void events(double, const double* state, double* values) override {
    const double y = find(state);
    const double g = y / run_.thickness - state[slipped];
    const double away = ahead(y);
    const double force = contact_force(y, away, g);
    const double approach =
        moves_ ? state[velocity] - state[body_velocity] - rate_of_support(state, std::fmax(force, 0))
               : state[velocity];
    const bool rebound = approach < 0;
    values[event_yield] = !moves_ || of_.unloading_stiffness == 0 ? 1
                          : crushes_on_ ? rate_of_support(state, std::fmax(force, 0))
                                        : state[deflection] - yield_ * (1 + 1e-12);
    // d(pad force)/dt = Ks (V - v) gives the rate v the sign of this.
    double drive = approach;
    if (!moves_ && !run_.support.rigid()) {
      const double h = 1e-4 * law_.lag();
      const double by_g = (contact_force(y, away, g + h) - contact_force(y, away, g - h)) / (2 * h);
      drive += by_g * law_.slip_rate(g) / run_.support.stiffness();
    }
    values[event_top] = state[velocity];
    values[event_turning] = loading_ ? drive : 1;
    values[event_again] = loading_ ? -1 : y - largest_ * (1 + 1e-12);
    values[event_weight] = rebound ? force - run_.mass * run_.options.gravity : 1;
    values[event_contact_end] = rebound ? force - contact_end_share * run_.result.peak_force : 1;
    values[event_release] = rebound ? largest_stress(y, away, g) : 1;
    values[event_bottom] = run_.thickness * (1 - 1e-7) - y;
    const bool has_corners = !moves_ && !run_.support.rigid();
    values[event_above] = has_corners ? run_.support.to_corner_above(state[motion] - y) : 1;
    values[event_below] = has_corners ? run_.support.to_corner_below(state[motion] - y) : 1;
  }

 private:
  enum : std::size_t {
    event_top,
    event_turning,
    event_again,
    event_weight,
    event_contact_end,
    event_release,
    event_bottom,
    event_above,
    event_below,
    event_yield
  };
  /// The third unknown, and those of a support that moves.
  static constexpr std::size_t slipped = 2, deflection = 3, rate = 4, body = 5, body_velocity = 6;
  static constexpr std::size_t unknowns_of_moving = 7;

  /// Fs, of a linear support.
  [[nodiscard]] double spring(double x) const {
    if (crushes_on_ || of_.unloading_stiffness == 0) return run_.support.stiffness() * std::fmax(x, 0);
    return std::fmax(run_.support.stiffness() * yield_ - of_.unloading_stiffness * (yield_ - x), 0);
  }
  [[nodiscard]] double rate_of_support(const double* state, double force) const {
    return of_.mass > 0 ? state[rate] : (force - spring(state[deflection])) / of_.damping;
  }

  /// By how much the largest penetration is above that of now, in thicknesses.
  [[nodiscard]] double ahead(double y) const {
    return loading_ ? 0 : std::fmax(largest_ - y, 0) / run_.thickness;
  }

  /// Where the foam that was crushed before begins to press, by halving.
  [[nodiscard]] double crater() const {
    double free = 0, met = run_.earlier;
    for (int i = 0; i < 60; ++i) {
      const double y = (free + met) / 2;
      (largest_stress(y, ahead(y), 0) > 0 ? met : free) = y;
    }
    return met;
  }

  /// Stress at the root of the strain, from the axis: strain = top x^2.
  [[nodiscard]] double stress(double y, double strain, double away, double u) const {
    const double depth = std::fmax(y / run_.thickness - strain, 0);
    const double complement = (1 - y / run_.thickness) + depth;
    const double all = law_.stress(strain, complement, away, u);
    const bool in_crater = law_.stays_crushed() && run_.earlier > 0 && largest_ <= run_.earlier;
    if (!in_crater || away == 0) return all;
    const double lasting = law_.stress(strain, complement, away, 0);
    if (lasting <= 0 || strain <= 0) return lasting;
    return lasting * (1 + (all - lasting) / law_.base(strain, complement));
  }

  double contact_force(double y, double away, double g) const {
    if (y <= 0) return 0;
    const double top = y / run_.thickness;
    const double u = law_.slip_rate(g);
    const double on_tip = nose_.tip > 0 ? nose_.tip * std::fmax(stress(y, top, away, u), 0) : 0;
    if (nose_.end == 0) return on_tip;
    const double low = std::sqrt(std::fmax(y - nose_.end, 0) / y);  // of x
    const auto at = [&](double x) { return stress(y, top * x * x, away, u); };
    // a'(s) ds with s = Y (1 - x^2).
    const auto beside_axis = [&](double rest) {
      const double x = 1 - rest;
      return at(x) * nose_.widening(y * rest * (1 + x)) * 2 * x * y;
    };
    const auto part = [&](double x) { return beside_axis(1 - x); };
    const auto integral = [&](double from, double to) {
      const int count = std::max(static_cast<int>(std::ceil(panels * (to - from))), 1);
      if (!nose_.is_steep_at_tip || to < 1) return gauss(from, to, count, part);
      return gauss(0, 1, count,
                   [&](double v) { return beside_axis((to - from) * v * v) * 2 * (to - from) * v; });
    };
    // Also where the nose has a corner, and where the tested curve ends and its continuation begins.
    std::vector<double> corners;
    if (law_.last_strain() < top) corners.push_back(std::sqrt(law_.last_strain() / top));
    for (const double depth : nose_.corners)
      if (depth < y) corners.push_back(std::sqrt(1 - depth / y));
    std::ranges::sort(corners);
    const auto over = [&](double from, double to) {
      double part_of = 0;
      for (const double corner : corners)
        if (from < corner && corner < to) part_of += integral(from, corner), from = corner;
      return part_of + integral(from, to);
    };
    if (away == 0 && u >= 0) return on_tip + over(low, 1);
    double sum = on_tip;
    double before = low, begin = low;
    bool pressed = at(low + 1e-6 * (1 - low)) > 0;
    for (int i = 1; i <= looks; ++i) {
      const double x = low + (1 - low) * i / looks;
      const bool presses = at(x) > 0;
      if (presses != pressed) {
        double none = before, other = x;
        if (none == low) none = low + 1e-6 * (1 - low);
        for (int k = 0; k < 48; ++k) {
          const double middle = (none + other) / 2;
          ((at(middle) > 0) == pressed ? none : other) = middle;
        }
        if (pressed) sum += over(begin, none);
        begin = other;
        pressed = presses;
      }
      before = x;
    }
    if (pressed) sum += over(begin, 1);
    return sum;
  }

  /// Largest over the contact, with its sign; the penetration where the pad is left.
  double largest_stress(double y, double away, double g) const {
    const double top = y / run_.thickness;
    if (y <= 0) return top * law_.base(0.5 * law_.last_strain(), 1 - 0.5 * law_.last_strain());
    const double u = law_.slip_rate(g);
    if (nose_.end == 0) return stress(y, top, away, u);
    const double low = std::sqrt(std::fmax(y - nose_.end, 0) / y);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= looks; ++i) {
      const double x = low + (1 - low) * std::fmax(double(i) / looks, 1e-6);
      most = std::fmax(most, stress(y, top * x * x, away, u));
    }
    return most;
  }

  /// The penetration at which the pad carries what the support gives.
  double find(const double* state) {
    if (moves_) return state[motion] - state[deflection] - state[body];
    if (run_.support.rigid()) return state[motion];
    const double x = state[motion];
    const auto surplus = [&](double y) {
      return contact_force(y, ahead(y), y / run_.thickness - state[slipped]) - run_.support.force(x - y);
    };
    // Without force the pad goes with the support.
    const double scale = run_.support.stiffness() * run_.thickness;
    double low = std::min(found_, x), high = low;
    double f_low = surplus(low), f_high = f_low;
    double stride = 1e-7 * run_.thickness;
    if (f_low > 0)
      for (; f_low > 0; stride *= 4) high = low, f_high = f_low, low -= stride, f_low = surplus(low);
    else
      for (; f_high < 0; stride *= 4) {
        low = high, f_low = f_high;
        high = std::min(high + stride, run_.thickness * (1 - 1e-9));
        f_high = surplus(high);
        if (high >= run_.thickness * (1 - 1e-9)) break;
      }
    // The rule of Illinois.
    double y = low;
    for (int i = 0, side = 0; i < 100 && high - low > 1e-15 * run_.thickness; ++i) {
      y = f_high == f_low ? (low + high) / 2 : (low * f_high - high * f_low) / (f_high - f_low);
      const double f = surplus(y);
      if (std::fabs(f) < 1e-15 * scale) break;
      if (f < 0) {
        low = y, f_low = f;
        if (side < 0) f_high /= 2;
        side = -1;
      } else {
        high = y, f_high = f;
        if (side > 0) f_low /= 2;
        side = 1;
      }
    }
    return found_ = y;
  }

  void note_vertex(const std::array<double, 3>& t, const std::array<double, 3>& f) {
    if (!(f[1] >= f[0] && f[1] >= f[2])) return;
    const double a = t[0] - t[1], b = t[2] - t[1];
    const double fa = (f[0] - f[1]) / a, fb = (f[2] - f[1]) / b;
    const double curve = (fb - fa) / (b - a), rise = fa - curve * a;
    if (curve >= 0) return;
    const double at = -rise / (2 * curve);
    run_.note_force(t[1] + at, f[1] + rise * at / 2);
  }

  ImpactRun& run_;
  const FoamFormulas& law_;
  Outline nose_;
  Backing of_;
  bool moves_;
  double inverse_body_;
  bool crushes_on_ = true;
  double yield_ = 0;
  bool loading_;
  double largest_;
  double crater_;
  double found_;
};

}  // namespace

void solve_foam(ImpactRun& run, const FoamFormulas& law, const Nose& nose) {
  FoamImpact(run, law, nose).run();
}

}  // namespace dashpad::oracle
