#include "impact/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dashpad/quantities/constants.hpp"
#include "impact/numerics.hpp"

namespace dashpad {
namespace {

constexpr double unknown = infinite;

constexpr double Figures::*extrapolated_numbers[]{&Figures::peak_force,      &Figures::time_of_peak_force,
                                                  &Figures::peak_motion,     &Figures::peak_penetration,
                                                  &Figures::final_velocity,  &Figures::peak_transmitted,
                                                  &Figures::peak_deflection, &Figures::set,
                                                  &Figures::crushing_force,  &Figures::body_velocity,
                                                  &Figures::last_swing,      &Figures::slowest_swing};
constexpr double EnergyLedger::*extrapolated_energies[]{&EnergyLedger::support, &EnergyLedger::support_loss,
                                                        &EnergyLedger::moving,  &EnergyLedger::weight,
                                                        &EnergyLedger::pad,     &EnergyLedger::sheet};
constexpr std::optional<Moment> Figures::*extrapolated_moments[]{&Figures::force_below_weight,
                                                                 &Figures::contact_end, &Figures::release,
                                                                 &Figures::bottomed, &Figures::rest};

/// Calls visit(the member of each run) for every number that is extrapolated.
template <class Visit, class... Run>
void for_each_number(Visit&& visit, Run&... runs) {
  for (const auto number : extrapolated_numbers) visit(runs.*number...);
  for (const auto energy : extrapolated_energies) visit(runs.energy.*energy...);
  for (const auto moment : extrapolated_moments) {
    if (!((runs.*moment).has_value() && ...)) continue;
    visit((runs.*moment)->time...);
    visit((runs.*moment)->velocity...);
  }
}

bool is_finite(const Figures& run) {
  bool finite = true;
  for_each_number([&finite](double x) { finite = finite && std::isfinite(x); }, run);
  return finite && std::isfinite(run.peak_pad_rate);
}

std::array<double*, 10> all(ErrorEstimates& e) {
  static_assert(sizeof(ErrorEstimates) == 10 * sizeof(double), "each has its entry here");
  return {&e.peak_force,  &e.time_of_peak_force, &e.peak_motion, &e.peak_penetration, &e.rebound_speed,
          &e.contact_end, &e.force_below_weight, &e.bottomed,    &e.energy_absorbed,  &e.support};
}

/// Whether a run went through the impact and has finite figures.
bool is_sound(const Figures& run) { return run.ending != Status::tolerance_not_met && is_finite(run); }

/// Whether two runs ended alike.
bool same_kind(const Figures& a, const Figures& b) {
  return a.ending == b.ending && std::ranges::all_of(extrapolated_moments, [&](const auto moment) {
           return moment == &Figures::rest || (a.*moment).has_value() == (b.*moment).has_value();
         });
}

Figures extrapolate(const Figures& fine, const Figures& coarse) {
  Figures result = fine;
  for_each_number([](double& x, const double& f, const double& c) { x = f + (f - c) / 3; }, result, fine,
                  coarse);
  // The correction of a tiny magnitude may exceed it.
  for (double Figures::*figure :
       {&Figures::peak_transmitted, &Figures::peak_deflection, &Figures::set, &Figures::crushing_force})
    if (result.*figure < 0) result.*figure = fine.*figure;
  return result;
}

}  // namespace

Refinement::Refinement(const ImpactCase& impact, double tolerance)
    : speed_(impact.impactor.speed),
      energy_(impact.impactor.mass * speed_ * speed_ / 2),
      has_corners_at_once_(!impact.support.corners().empty() && impact.backing.mass == 0),
      tolerance_(tolerance),
      allows_two_(tolerance >= numerics.min_tolerance_of_two_runs) {
  for (double* value : all(errors_)) *value = unknown;
}

bool Refinement::add(const Figures& run, double apart) {
  ++runs_;
  settled_ = false;
  if (!is_sound(run)) {
    if (!has_sound_run_) reported_ = run;
    return !has_sound_run_;
  }
  const Figures before = extrapolated_;
  const bool comparable = has_sound_run_ && same_kind(run, last_run_);
  reloads_alike_ = run.reloadings == last_run_.reloadings || run.ending == Status::at_rest;
  extrapolated_ = comparable ? extrapolate(run, last_run_) : run;
  last_run_ = run;
  has_sound_run_ = true;
  if (comparable)
    judge(run, before, apart);
  else
    is_met_ = false;
  if (!comparable && compared_) return false;
  compared_ = comparable;
  reported_ = extrapolated_;
  return true;
}

double distance_between(const History& fine, const History& coarse, const Impactor& impactor) {
  const double largest_motion = *std::ranges::max_element(fine.motion);
  double distance = 0;
  const auto count = [&distance](double difference) {
    if (std::isnan(difference) || difference > distance) distance = difference;
  };
  std::size_t j = 0;
  for (std::size_t i = 0; i < coarse.size() && coarse.time[i] <= fine.time.back(); ++i) {
    while (j + 2 < fine.size() && fine.time[j + 1] <= coarse.time[i]) ++j;
    const double step = fine.time[j + 1] - fine.time[j];
    if (!(step > 0)) continue;
    const double u = (coarse.time[i] - fine.time[j]) / step, v = 1 - u;
    const auto between = [&](const std::vector<double>& value, double slope, double slope_then) {
      return value[j] * v * v * (1 + 2 * u) + value[j + 1] * u * u * (1 + 2 * v) +
             step * u * v * (slope * v - slope_then * u);
    };
    const double velocity = between(fine.velocity, fine.acceleration[j] + impactor.gravity,
                                    fine.acceleration[j + 1] + impactor.gravity);
    const double motion = between(fine.motion, fine.velocity[j], fine.velocity[j + 1]);
    count(std::abs(velocity - coarse.velocity[i]) / impactor.speed);
    count(std::abs(motion - coarse.motion[i]) / largest_motion);
  }
  return distance;
}

void Refinement::judge(const Figures& run, const Figures& before, double apart) {
  const Figures& now = extrapolated_;
  const auto absorbed = [&](const Figures& f) {
    const double v = f.final_velocity / speed_;
    return 1 - v * v -
           (f.energy.support + f.energy.support_loss + f.energy.moving - f.energy.weight) / energy_;
  };
  const double residual = std::abs(absorbed(now) - (now.energy.pad + now.energy.sheet) / energy_);
  // Impactors that come to rest may do so a swing too early in both of two runs.
  const bool may_be_two =
      allows_two_ && now.ending == Status::released && !now.bottomed && !has_corners_at_once_;
  const bool are_two = runs_ == 2;
  apart = are_two || may_be_two ? apart + numerics.residuals_of_two_runs * residual : unknown;
  // Eq. 31. std::max would ignore NaN.
  const auto change = [](double x, double x_before, double x_run, double scale) {
    if (!std::isfinite(x) || !std::isfinite(x_before) || !std::isfinite(x_run)) return unknown;
    const double difference =
        std::max({std::abs(x - x_before), std::abs(x - x_run), numerics.rounding_of_figures * std::abs(x)});
    return difference == 0 ? 0 : difference / scale;
  };
  // Eq. 31a, if it is less.
  const auto error = [&](double x, double x_before, double x_run, double scale) {
    const double by_three = change(x, x_before, x_run, scale);
    if (by_three == 0 || !std::isfinite(by_three)) return by_three;
    const double by_two = std::isfinite(apart) ? 4.0 / 3 * std::abs(x - x_run) / scale + apart : unknown;
    return are_two ? by_two : std::min(by_three, by_two);
  };
  // The distance is relative to the impact speed, and says little of the slow motion after the peak.
  const auto error_after_peak = [&](double x, double x_before, double x_run, double scale) {
    return are_two ? error(x, x_before, x_run, scale) : change(x, x_before, x_run, scale);
  };
  const auto relative = [&](double Figures::*figure) {
    return error(now.*figure, before.*figure, run.*figure, std::abs(now.*figure));
  };
  errors_ = {};
  // On a rigid support a bottomed pad has no peak force; what matters is time and speed at bottoming.
  const bool ended_in_lock = now.ending == Status::bottomed_out;
  if (!ended_in_lock) {
    errors_.peak_force = relative(&Figures::peak_force);
    errors_.time_of_peak_force =
        error(now.time_of_peak_force, before.time_of_peak_force, run.time_of_peak_force,
              now.contact_end ? now.contact_end->time : now.time_of_peak_force);
  }
  errors_.peak_motion = relative(&Figures::peak_motion);
  errors_.peak_penetration = relative(&Figures::peak_penetration);
  double worst = errors_.peak_force;
  if (is_still_sinking(now.left_to_sink, now.peak_penetration, tolerance_))
    errors_.peak_motion = errors_.peak_penetration = unknown;
  else
    worst = std::max({worst, errors_.peak_motion, errors_.peak_penetration});
  const auto of_speed = [&](const auto& estimate, std::optional<Moment> Figures::*figure) {
    const double v = (now.*figure)->velocity;
    return estimate(v, (before.*figure)->velocity, (run.*figure)->velocity,
                    std::max(std::abs(v), numerics.min_speed * speed_));
  };
  // The larger of those of time and velocity.
  const auto moment = [&](const auto& estimate, std::optional<Moment> Figures::*figure) {
    if (!(now.*figure)) return 0.0;
    const double t = (now.*figure)->time;
    return std::max(estimate(t, (before.*figure)->time, (run.*figure)->time, std::abs(t)),
                    of_speed(estimate, figure));
  };
  // The time of release is ill-posed (theory.md, Eq. 27); the speed then is not.
  if (now.release) {
    errors_.rebound_speed = std::max(of_speed(error_after_peak, &Figures::release),
                                     numerics.fastest_fall_of_error * rebound_change_);
    rebound_change_ = of_speed(change, &Figures::release);
  }
  errors_.contact_end = moment(error_after_peak, &Figures::contact_end);
  errors_.force_below_weight = moment(error_after_peak, &Figures::force_below_weight);
  const double fall = ended_in_lock ? numerics.fastest_fall_of_error : numerics.fastest_fall_of_bottoming;
  errors_.bottomed = std::max(moment(error_after_peak, &Figures::bottomed), fall * bottomed_change_);
  bottomed_change_ = moment(change, &Figures::bottomed);
  // The first run may meet the bottom a step early or late.
  const double of_bottoming = errors_.bottomed / (runs_ == 3 ? numerics.share_of_bottoming : 1);
  worst =
      std::max({worst, errors_.rebound_speed, errors_.contact_end, errors_.force_below_weight, of_bottoming});
  const auto of_support = [&](double Figures::*figure, double scale) {
    if (now.*figure == 0 && before.*figure == 0 && run.*figure == 0) return 0.0;
    return scale > 0 ? error(now.*figure, before.*figure, run.*figure, scale) : unknown;
  };
  // Deflections and sets count relative to the peak deflection, bodies' speeds to the impact speed.
  const auto of_ways = [&](double scale) {
    return std::max(of_support(&Figures::peak_deflection, scale), of_support(&Figures::set, scale));
  };
  const double of_others = std::max(of_support(&Figures::peak_transmitted, now.peak_transmitted),
                                    of_support(&Figures::body_velocity, speed_));
  errors_.support = std::max(of_others, of_ways(now.peak_deflection));
  worst = std::max(
      {worst, of_others, of_ways(std::max(now.peak_deflection, numerics.min_deflection * now.peak_motion))});
  const auto of_absorbed = [&](double scale) {
    // A small difference of large numbers has their rounding.
    return std::max(error_after_peak(absorbed(now), absorbed(before), absorbed(run), scale),
                    numerics.rounding_of_figures / scale);
  };
  errors_.energy_absorbed = of_absorbed(1);
  // The absorbed share is held to ten times the tolerance, relative to itself or a twentieth of the energy.
  double of_energy = std::max(of_absorbed(10 * std::max(absorbed(now), 0.05)), residual);
  // The last swing adds an unknown share unless the speeds of swings differ clearly from the limit of rest.
  const double slow = numerics.speed_at_rest * speed_;
  const auto is_beyond = [&](double side, double x, double x_before, double x_run) {
    return x_run == 0 || side * (x - slow) > std::max(std::abs(x - x_before), std::abs(x - x_run));
  };
  if (!is_beyond(-1, now.last_swing, before.last_swing, run.last_swing) ||
      !is_beyond(1, now.slowest_swing, before.slowest_swing, run.slowest_swing))
    errors_.energy_absorbed = of_energy = unknown;
  // A reloading that only one of two runs has may matter or not: one more run decides.
  const bool enough = reloads_alike_ ? !are_two || may_be_two : runs_ > 3;
  // The moment of a flat peak is poorly determined, whatever the step: it is not held to the tolerance.
  const auto is_within = [&](double allowed) {
    return enough && worst <= allowed && of_energy <= tolerance_ &&
           errors_.time_of_peak_force <= numerics.loosest_time_of_peak;
  };
  settled_ = is_within(is_met_ || tolerance_ >= numerics.min_tolerance_in_full ? tolerance_ : tolerance_ / 2);
  is_met_ = is_within(tolerance_);
  for (double* value : all(errors_)) *value *= numerics.safety_factor;
}

}  // namespace dashpad
