#pragma once
/// Subroutine SPIT: the march through the impact and the iteration of each step.
///
/// Numbers in comments are the statement numbers of the listing (report, Appendix B) and of its flow chart
/// (Figure A-2). Vector indices are the listing's: 1 is one step before contact, 2 is first contact, 0 is not
/// used.

#include <vector>

#include "dashpad/spit1984/run.hpp"
#include "spit1984/pad.hpp"
#include "spit1984/support_secant.hpp"

namespace dashpad::spit1984 {

template <class Real>
class Spit {
 public:
  Spit(const Deck& deck, const Settings& settings);
  /// The whole impact; once.
  Run run();

 private:
  /// How a step, or its iteration, ends.
  enum class Outcome { step_done, held, abend };

  [[nodiscard]] static Real number(double value) { return Real(value); }

  Outcome advance_one_step();
  Outcome iterate(Real advance);
  bool halve_time_step();
  bool try_penetration();
  bool widen_contact();
  bool add_station(Real radius);
  [[nodiscard]] Real outermost() const;
  void restore_contact();
  void find_strains();
  void drop_tensile_edge();
  [[nodiscard]] Real contact_force() const;
  bool update_motion();
  Outcome end(Abend abend);
  [[nodiscard]] Run collected() const;

  const Deck deck_;
  const Settings settings_;
  const Real pi_ = number(3.141593), mph_ = number(17.64), gravity_ = number(386.4);
  const Real radius_, thickness_, weight_, mass_;
  const Real station_spacing_;  ///< DR
  PadParameters<Real> pad_parameters_;
  SupportSecant<Real> support_;

  // Time history: A, F, T, V, X, XP
  std::vector<Real> acceleration_, force_, time_, speed_, motion_, penetration_;
  int step_ = 2;      ///< K
  Real time_step_{};  ///< DDT

  // Contact
  ContactField<Real> field_;
  int stations_ = 1;         ///< MAXR
  Real edge_{};              ///< RLAST: the widest contact so far
  int stations_before_ = 0;  ///< LAST, what a rejected trial goes back to
  Real edge_before_{};       ///< RL
  Real trial_edge_{};        ///< RMAX

  // The iteration of a step
  Real y1_{}, y2_{}, y3_{}, f1_{}, f2_{}, f3_{};  ///< penetrations and their forces out of equilibrium
  int iterations_ = 0;                            ///< ITER
  int halvings_ = 0;                              ///< NEXP
  Real stiffness_{};                              ///< STIF
  Real residual_strain_{};                        ///< TIME on return from PAD
  Real last_residual_strain_{};                   ///< ERES

  Real peak_force_{}, time_of_peak_force_{};
  Run result_;
};

template <class Real>
Spit<Real>::Spit(const Deck& deck, const Settings& settings)
    : deck_(deck),
      settings_(settings),
      radius_(number(deck.radius_in)),
      thickness_(number(deck.thickness_in)),
      weight_(number(deck.weight_lb)),
      mass_(weight_ / gravity_),
      station_spacing_(radius_ / number(100)),
      support_(deck, settings.defects.idle_segments),
      time_step_(number(deck.time_step_ms) / number(1000)),
      field_(static_cast<std::size_t>(settings.most_stations)),
      stiffness_(support_.initial()) {
  for (std::size_t i = 0; i < pad_parameters_.size(); ++i)
    pad_parameters_[i] = number(deck.pad_parameters[i]);
  // One entry more than the dimension: the motion is known a step ahead.
  const auto size = static_cast<std::size_t>(settings.most_steps) + 2;
  for (std::vector<Real>* history : {&acceleration_, &force_, &time_, &speed_, &motion_, &penetration_})
    history->resize(size);
  const Real speed = mph_ * number(deck.speed_mph);
  for (int k = 1; k <= 3; ++k) {
    time_[k] = number(k - 2) * time_step_;
    motion_[k] = speed * time_[k];
    speed_[k] = speed;
  }
}

template <class Real>
Run Spit<Real>::run() {
  for (;;) {
    const Outcome outcome = advance_one_step();
    if (outcome == Outcome::abend) break;
    if (outcome == Outcome::step_done && speed_[step_] < number(0) && abs(force_[step_]) < weight_) break;
    if (!update_motion()) break;
  }
  return collected();
}

/// 50 to 90: the estimators from the two steps before, and the direction of the march.
template <class Real>
auto Spit<Real>::advance_one_step() -> Outcome {
  const int before = step_ - 1, last = step_;
  ++step_;
  y1_ = penetration_[before];
  f1_ = force_[before] + stiffness_ * (motion_[step_] - penetration_[before]);
  y2_ = penetration_[last];
  f2_ = force_[last] + stiffness_ * (motion_[step_] - penetration_[last]);
  iterations_ = 0;
  halvings_ = 0;
  if (!settings_.defects.stale_contact) {
    stations_before_ = stations_;
    edge_before_ = edge_;
  }
  Real advance = abs(y2_ - y1_);
  const Real least = number(0.005) * abs(y2_);
  if (advance < least) advance = least;
  if (advance == number(0)) advance = number(0.005) * thickness_;
  if (f2_ == number(0)) {  // 80
    penetration_[step_] = penetration_[last];
    force_[step_] = force_[last];
    return Outcome::held;
  }
  return iterate(f2_ < number(0) ? -advance : advance);
}

/// 90 to 240: marches by `advance` until the force error changes sign, then bisects a triplet (Eqs. 25, 26).
template <class Real>
auto Spit<Real>::iterate(Real advance) -> Outcome {
  const int before = step_ - 2, last = step_ - 1;
  const Real zero = number(0);
  bool bisecting = false;
  y3_ = y2_ + advance;
  for (;;) {
    if (y3_ >= thickness_) y3_ = number(0.5) * (thickness_ + penetration_[last]);  // 100
    if (y3_ > radius_) y3_ = radius_;
    if (y3_ < zero && !halve_time_step()) return Outcome::abend;  // 105
    if (!try_penetration()) return end(Abend::too_many_contact_divisions);

    Real error = f3_;
    if (force_[step_] != zero) error = error / force_[step_];
    if (abs(error) <= number(settings_.equilibrium_tolerance)) break;
    if (y2_ + y3_ != zero && abs((y2_ - y3_) / (y2_ + y3_)) <= number(settings_.precision_tolerance)) {
      result_.precision_stops.push_back({step_, to_double(force_[step_]), to_double(error)});
      break;
    }
    if (++iterations_ > settings_.most_iterations) return end(Abend::too_many_iterations);  // 230

    const Real primary = f2_ * f3_;
    if (primary == zero) {  // 232: no change of penetration
      penetration_[step_] = penetration_[last];
      return Outcome::step_done;
    }
    if (primary < zero) {  // 231: the root is between the last two
      y1_ = y2_;
      f1_ = f2_;
      y2_ = y3_;
      f2_ = f3_;
      bisecting = true;
    } else if (bisecting) {  // 233: between the first and the last?
      const Real secondary = f1_ * f3_;
      if (secondary == zero) {  // 236
        penetration_[step_] = penetration_[before];
        return Outcome::step_done;
      }
      if (!(secondary < zero)) return end(Abend::bisection_failed);  // 237
      y2_ = y3_;                                                     // 234
      f2_ = f3_;
    } else {  // 238: not yet; march on
      y1_ = y2_;
      f1_ = f2_;
      y2_ = y3_;
      f2_ = f3_;
    }
    restore_contact();
    y3_ = bisecting ? number(0.5) * (y1_ + y2_) : y2_ + advance;  // 235, 90
  }
  penetration_[step_] = y3_;  // 240
  return Outcome::step_done;
}

/// 105: the penetration would be negative, contact ends within the step. Restarts it at half the time step
/// with part of the last change of penetration. False after seven halvings: the error of the speed is
/// estimated two steps back, where the data are better (Eq. 27), and the run ends.
template <class Real>
bool Spit<Real>::halve_time_step() {
  const int before = step_ - 2, last = step_ - 1;
  time_step_ = number(0.5) * time_step_;
  motion_[step_] = motion_[last] + speed_[last] * time_step_;
  speed_[step_] = speed_[last] + acceleration_[last] * time_step_;
  time_[step_] = time_[last] + time_step_;
  ++halvings_;
  ++result_.halvings;
  const Real part = number(1.0 / static_cast<double>(1 << halvings_));
  y3_ = penetration_[last] + (penetration_[last] - penetration_[before]) * part;
  iterations_ = 0;
  if (halvings_ <= 7) return true;
  step_ = before;
  const Real speed = speed_[step_];
  const Real way = motion_[step_] - thickness_ * last_residual_strain_;
  result_.speed_error = to_double(number(0.5) * acceleration_[step_] * way / (speed * speed));
  end(Abend::rate_sensitive_instability);
  return false;
}

/// 110 to 222: the force of the trial y3 and how far it is from equilibrium (Eq. 20). False when the contact
/// field is full.
template <class Real>
bool Spit<Real>::try_penetration() {
  ++result_.trials;
  if (!widen_contact()) return false;
  find_strains();
  residual_strain_ = update_stresses(deck_.pad, pad_parameters_, field_, stations_, time_step_, time_[step_]);
  drop_tensile_edge();
  force_[step_] = contact_force();
  const Real deflection = motion_[step_] - y3_;
  stiffness_ = support_.secant(deflection);
  f3_ = force_[step_] + stiffness_ * deflection;
  return true;
}

/// 110 to 140: stations at equal distances up to the contact radius, and one on it unless another is close.
template <class Real>
bool Spit<Real>::widen_contact() {
  const Real edge = square_root(number(2) * radius_ * y3_ - y3_ * y3_);
  trial_edge_ = edge;
  if (edge <= edge_) return true;
  if (settings_.defects.stale_contact) {
    edge_before_ = edge_;
    stations_before_ = stations_;
  }
  const int whole = truncated((edge - edge_) / station_spacing_);
  for (int j = 0; j < whole; ++j)
    if (!add_station(outermost() + station_spacing_)) return false;
  const Real rest = (edge - outermost()) / station_spacing_;
  if (!(rest < number(0.1)) && !add_station(edge)) return false;
  if (stations_ > result_.most_stations) result_.most_stations = stations_;
  edge_ = edge;
  return true;
}

template <class Real>
bool Spit<Real>::add_station(Real radius) {
  if (++stations_ > settings_.most_stations) return false;
  field_.radius[stations_ - 1] = radius;
  return true;
}

/// R(MAXR). Where no station is left, the listing reads R(0), which is not in the vector; here it is the
/// axis.
template <class Real>
Real Spit<Real>::outermost() const {
  return stations_ > 0 ? field_.radius[stations_ - 1] : number(0);
}

/// 235, 238: the contact before the rejected trial; with the defect, before the last one that widened it.
template <class Real>
void Spit<Real>::restore_contact() {
  stations_ = stations_before_;
  edge_ = edge_before_;
}

/// 150.
template <class Real>
void Spit<Real>::find_strains() {
  for (int i = 0; i < stations_; ++i) {
    const Real ratio = field_.radius[i] / radius_;
    const Real depth = radius_ * (number(1) - square_root(number(1) - ratio * ratio));
    field_.new_strain[i] = (depth - y3_) / thickness_;
  }
  if (!settings_.defects.edge_residue && stations_ > 1 && outermost() == trial_edge_)
    field_.new_strain[stations_ - 1] = number(0);
}

/// 170: tensile stresses at the edge become zero and their stations leave. Laws 4 and 5 set the stress of the
/// outermost station to zero themselves, so for them this never finds any.
template <class Real>
void Spit<Real>::drop_tensile_edge() {
  if (!settings_.defects.tension)
    for (int i = 0; i < stations_; ++i)
      if (field_.new_stress[i] > number(0)) field_.new_stress[i] = number(0);
  while (stations_ > 0 && field_.new_stress[stations_ - 1] > number(0)) {
    field_.new_stress[stations_ - 1] = number(0);
    --stations_;
  }
}

/// 181 to 220: trapezoidal rule over rings (Eq. 17). Negative in compression.
template <class Real>
Real Spit<Real>::contact_force() const {
  Real sum = number(0);
  if (stations_ == 1) sum = field_.new_stress[0] * (field_.radius[1] * field_.radius[1]);
  for (int i = 1; i < stations_; ++i)
    sum = sum + (field_.new_stress[i] + field_.new_stress[i - 1]) *
                    (field_.radius[i] * field_.radius[i] - field_.radius[i - 1] * field_.radius[i - 1]);
  return pi_ * sum / number(2);
}

/// 242 to 251: motion by central differences (Eqs. 14, 15); the stresses and strains become the old ones.
/// False when the time history is full.
template <class Real>
bool Spit<Real>::update_motion() {
  const int last = step_ - 1, next = step_ + 1;
  if (next > settings_.most_steps) {
    end(Abend::too_many_time_steps);
    return false;
  }
  acceleration_[step_] = force_[step_] / mass_;
  motion_[next] =
      number(2) * motion_[step_] - motion_[last] + acceleration_[step_] * (time_step_ * time_step_);
  speed_[next] = (motion_[next] - motion_[step_]) / time_step_;
  time_[next] = time_[step_] + time_step_;
  for (int i = 0; i < stations_; ++i) {
    field_.strain[i] = field_.new_strain[i];
    const Real magnitude = abs(field_.strain[i]);
    if (field_.largest_strain[i] < magnitude) field_.largest_strain[i] = magnitude;
    field_.stress[i] = field_.new_stress[i];
  }
  last_residual_strain_ = residual_strain_;
  if (!(peak_force_ < force_[step_])) {
    peak_force_ = force_[step_];
    time_of_peak_force_ = number(1000) * time_[step_];
  }
  return true;
}

template <class Real>
auto Spit<Real>::end(Abend abend) -> Outcome {
  result_.abend = abend;
  return Outcome::abend;
}

/// 260 to 290: what is printed, in the printed units, still in the arithmetic of the program.
template <class Real>
Run Spit<Real>::collected() const {
  Run run = result_;
  const Real milliseconds = number(1000);
  for (int k = 2; k <= step_; ++k)
    run.history.push_back({to_double(milliseconds * time_[k]), to_double(force_[k]),
                           to_double(acceleration_[k] / gravity_), to_double(speed_[k]),
                           to_double(motion_[k]), to_double(penetration_[k])});
  run.rebound_speed_mph = to_double(speed_[step_] / mph_);
  run.duration_ms = to_double(milliseconds * time_[step_]);
  run.time_of_peak_force_ms = to_double(time_of_peak_force_);
  run.peak_force_lb = to_double(peak_force_);
  run.tangent_stiffness_lb_per_in = support_.printed();
  return run;
}

}  // namespace dashpad::spit1984
