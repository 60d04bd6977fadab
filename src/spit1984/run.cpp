#include "dashpad/spit1984/run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "spit1984/contact.hpp"
#include "spit1984/support_secant.hpp"

namespace dashpad::spit1984 {

namespace {

/// Subroutine SPIT: the time steps of the impact, and the iteration in each of them.
///
/// Numbers in comments are the statement numbers of the listing (report, Appendix B) and of its flow chart
/// (Figure A-2). Vector indices are the listing's: 1 is one step before contact, 2 is first contact.
template <class Real>
class Spit {
 public:
  Spit(const Deck& deck, const Settings& settings)
      : settings_(settings),
        radius_(Real(deck.radius_in)),
        thickness_(Real(deck.thickness_in)),
        weight_(Real(deck.weight_lb)),
        mass_(weight_ / gravity_),
        support_(deck, settings.defects.idle_segments),
        time_step_(Real(deck.time_step_ms) / Real(1000)),
        contact_(deck, settings),
        stiffness_(support_.initial()) {
    // Index 0 is not used.
    const auto size = static_cast<std::size_t>(settings.max_steps) + 1;
    for (std::vector<Real>* history : {&acceleration_, &force_, &time_, &speed_, &motion_, &penetration_})
      history->resize(size);
    const Real speed = mph_ * Real(deck.speed_mph);
    for (int k = 1; k <= 3; ++k) {
      time_[k] = Real(k - 2) * time_step_;
      motion_[k] = speed * time_[k];
      speed_[k] = speed;
    }
  }

  /// Computes the whole impact. Call once.
  Run run(const Progress& progress) {
    for (;;) {
      if (progress) progress(step_);
      const Outcome outcome = advance_one_step();
      if (outcome == Outcome::abend) break;
      if (outcome == Outcome::step_done && speed_[step_] < Real(0) && abs(force_[step_]) < weight_) break;
      if (!update_motion()) break;
    }
    return collected();
  }

 private:
  /// The result of a step or of its iteration.
  enum class Outcome { step_done, held, abend };

  /// 50 to 90: the estimators from the two steps before, and the direction of the march.
  Outcome advance_one_step() {
    const int before = step_ - 1, last = step_;
    ++step_;
    y1_ = penetration_[before];
    f1_ = force_[before] + stiffness_ * (motion_[step_] - penetration_[before]);
    y2_ = penetration_[last];
    f2_ = force_[last] + stiffness_ * (motion_[step_] - penetration_[last]);
    iterations_ = 0;
    halvings_ = 0;
    contact_.start_step();
    Real advance = abs(y2_ - y1_);
    const Real least = Real(0.005) * abs(y2_);
    if (advance < least) advance = least;
    if (advance == Real(0)) advance = Real(0.005) * thickness_;
    if (f2_ == Real(0)) {  // 80
      penetration_[step_] = penetration_[last];
      force_[step_] = force_[last];
      return Outcome::held;
    }
    return iterate(f2_ < Real(0) ? -advance : advance);
  }

  /// 90 to 240: marches by `advance` until the force error changes sign, then bisects (Eqs. 25, 26).
  Outcome iterate(Real advance) {
    const int before = step_ - 2, last = step_ - 1;
    const Real zero = Real(0);
    bool bisecting = false;
    y3_ = y2_ + advance;
    for (;;) {
      if (y3_ >= thickness_) y3_ = Real(0.5) * (thickness_ + penetration_[last]);  // 100
      if (y3_ > radius_) y3_ = radius_;
      if (y3_ < zero && !halve_time_step()) return Outcome::abend;  // 105
      if (!try_penetration()) return end(Abend::too_many_contact_divisions);

      Real error = f3_;
      if (force_[step_] != zero) error = error / force_[step_];
      if (abs(error) <= Real(settings_.equilibrium_tolerance)) break;
      if (y2_ + y3_ != zero && abs((y2_ - y3_) / (y2_ + y3_)) <= Real(settings_.precision_tolerance)) {
        result_.precision_stops.push_back({step_, to_double(force_[step_]), to_double(error)});
        break;
      }
      if (++iterations_ > settings_.max_iterations) return end(Abend::too_many_iterations);  // 230

      const Real primary = f2_ * f3_;
      if (primary == zero) {  // 232: no change of penetration
        penetration_[step_] = penetration_[last];
        return Outcome::step_done;
      }
      if (bisecting && !(primary < zero)) {  // 233: between the first and the last?
        const Real secondary = f1_ * f3_;
        if (secondary == zero) {  // 236
          penetration_[step_] = penetration_[before];
          return Outcome::step_done;
        }
        if (!(secondary < zero)) return end(Abend::bisection_failed);  // 237
      } else {  // 231: the root is between the last two; 238: not yet, march on
        y1_ = y2_;
        f1_ = f2_;
        bisecting = primary < zero;
      }
      y2_ = y3_;  // 234
      f2_ = f3_;
      contact_.restore();
      y3_ = bisecting ? Real(0.5) * (y1_ + y2_) : y2_ + advance;  // 235, 90
    }
    penetration_[step_] = y3_;  // 240
    return Outcome::step_done;
  }

  /// 105: contact ends within the step, since the penetration would be negative. Restarts the step at half
  /// its length with part of the last change of penetration. After seven halvings, estimates the error of the
  /// speed two steps back, where the data are better (Eq. 27), ends the run and returns false.
  bool halve_time_step() {
    const int before = step_ - 2, last = step_ - 1;
    time_step_ = Real(0.5) * time_step_;
    motion_[step_] = motion_[last] + speed_[last] * time_step_;
    speed_[step_] = speed_[last] + acceleration_[last] * time_step_;
    time_[step_] = time_[last] + time_step_;
    ++halvings_;
    ++result_.halvings;
    const Real part = Real(1.0 / static_cast<double>(1 << halvings_));
    y3_ = penetration_[last] + (penetration_[last] - penetration_[before]) * part;
    iterations_ = 0;
    if (halvings_ <= 7) return true;
    step_ = before;
    const Real speed = speed_[step_];
    const Real way = motion_[step_] - thickness_ * last_residual_strain_;
    result_.speed_error = to_double(Real(0.5) * acceleration_[step_] * way / (speed * speed));
    end(Abend::rate_sensitive_instability);
    return false;
  }

  /// 110 to 222: computes the force of the trial y3 and its distance from equilibrium (Eq. 20). False if the
  /// contact field is full.
  bool try_penetration() {
    ++result_.trials;
    const std::optional<Real> force = contact_.force(y3_, time_step_, time_[step_]);
    if (!force) return false;
    force_[step_] = *force;
    const Real deflection = motion_[step_] - y3_;
    stiffness_ = support_.secant(deflection);
    f3_ = *force + stiffness_ * deflection;
    return true;
  }

  /// 242 to 251: advances the motion by central differences (Eqs. 14, 15) and accepts stresses and strains.
  /// False if the time history is full.
  bool update_motion() {
    const int last = step_ - 1, next = step_ + 1;
    if (next > settings_.max_steps) {
      end(Abend::too_many_time_steps);
      return false;
    }
    acceleration_[step_] = force_[step_] / mass_;
    motion_[next] =
        Real(2) * motion_[step_] - motion_[last] + acceleration_[step_] * (time_step_ * time_step_);
    speed_[next] = (motion_[next] - motion_[step_]) / time_step_;
    time_[next] = time_[step_] + time_step_;
    contact_.accept();
    last_residual_strain_ = contact_.residual_strain();
    if (!(peak_force_ < force_[step_])) {
      peak_force_ = force_[step_];
      time_of_peak_force_ = Real(1000) * time_[step_];
    }
    return true;
  }

  Outcome end(Abend abend) {
    result_.abend = abend;
    result_.last_step_accepted =
        abend == Abend::too_many_time_steps || abend == Abend::rate_sensitive_instability;
    return Outcome::abend;
  }

  /// 260 to 290: the results in the printed units, computed in the arithmetic of the program.
  [[nodiscard]] Run collected() const {
    Run run = result_;
    const Real milliseconds = Real(1000);
    for (int k = 2; k <= step_; ++k)
      run.history.push_back({to_double(milliseconds * time_[k]), to_double(force_[k]),
                             to_double(acceleration_[k] / gravity_), to_double(speed_[k]),
                             to_double(motion_[k]), to_double(penetration_[k])});
    run.max_stations = contact_.max_stations();
    run.rebound_speed_mph = to_double(speed_[step_] / mph_);
    run.duration_ms = to_double(milliseconds * time_[step_]);
    run.time_of_peak_force_ms = to_double(time_of_peak_force_);
    run.peak_force_lb = to_double(peak_force_);
    run.tangent_stiffness_lb_per_in = support_.printed();
    return run;
  }

  const Settings settings_;
  const Real mph_ = Real(17.64), gravity_ = Real(386.4);
  const Real radius_, thickness_, weight_, mass_;
  SupportSecant<Real> support_;

  // Time history: A, F, T, V, X, XP
  std::vector<Real> acceleration_, force_, time_, speed_, motion_, penetration_;
  int step_ = 2;      ///< K
  Real time_step_{};  ///< DDT

  Contact<Real> contact_;

  // The iteration of a step
  Real y1_{}, y2_{}, y3_{}, f1_{}, f2_{}, f3_{};  ///< penetrations and their forces out of equilibrium
  int iterations_ = 0;                            ///< ITER
  int halvings_ = 0;                              ///< NEXP
  Real stiffness_{};                              ///< STIF
  Real last_residual_strain_{};                   ///< ERES

  Real peak_force_{}, time_of_peak_force_{};
  Run result_;
};

}  // namespace

const char* to_string(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::binary32: return "binary32";
    case Arithmetic::binary64: return "binary64";
    case Arithmetic::pdp10: break;
  }
  return "pdp10";
}

AbendText text_of(Abend abend) {
  switch (abend) {
    case Abend::too_many_iterations:
      return {
          "too many iterations",
          "during the impact, this means that the penetration converges too slowly; raise "
          "--equilibrium-tolerance or --most-iterations, or reduce --time-step. Near the end of rebound, it "
          "means that the strain-rate sensitivity is too high; the last step but one is the last reliable "
          "one, and Eq. 27 estimates its speed error"};
    case Abend::bisection_failed:
      return {"bisection failed",
              "no pair of trials brackets equilibrium, which points to an unusual sensitivity to the strain "
              "rate; check the law and its parameters"};
    case Abend::too_many_time_steps:
      return {"too many time steps",
              "the time history was full before the end of the impact; raise --most-steps"};
    case Abend::rate_sensitive_instability:
      return {"rate-sensitive instability",
              "the end of contact cannot be found. The results are usable if the speed error is a small "
              "fraction; the error in the coefficient of restitution is about twice that fraction times the "
              "ratio of impact speed to rebound speed. Otherwise, halve --time-step"};
    case Abend::too_many_contact_divisions:
      return {"too many contact divisions",
              "the contact field was full before the maximum penetration; raise --most-stations"};
    case Abend::none: break;
  }
  return {"", ""};
}

double longest_time_step_ms(const Deck& deck) {
  const auto tangents = SupportSecant<double>(deck, true).printed();
  const double stiffest = *std::max_element(tangents.begin(), tangents.end());
  return 1000 * 0.25 * std::sqrt(deck.weight_lb / 386.4 / stiffest);
}

Run run(const Deck& deck, const Settings& settings, const Progress& progress) {
  if (const auto broken = violations(deck); !broken.empty())
    throw std::invalid_argument(broken.front().key + ": " + broken.front().rule);
  if (settings.max_steps < 3 || settings.max_stations < 2)
    throw std::invalid_argument("dimensions: must allow at least three time steps and two stations");
  switch (settings.arithmetic) {
    case Arithmetic::binary32: return Spit<float>(deck, settings).run(progress);
    case Arithmetic::binary64: return Spit<double>(deck, settings).run(progress);
    case Arithmetic::pdp10: break;
  }
  return Spit<Pdp10>(deck, settings).run(progress);
}

}  // namespace dashpad::spit1984
