#include "dashpad/report1986/validation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dashpad::report1986 {

namespace {

constexpr double half_pi = std::numbers::pi / 2;

double speed_of_energy_mph(double energy_in_lb, double weight_lb) {
  return std::sqrt(2 * energy_in_lb / mass_of(weight_lb)) / inch_per_s_of_mph;
}

double trend_energy(const ValidationData& data, double force_lb) {
  return trend_energy_in_lb(force_lb, data.constant("energy_trend_factor"),
                            data.constant("energy_trend_exponent"));
}

}  // namespace

double mass_of(double weight_lb) { return weight_lb / gravity_in_per_s2; }

double impact_energy_in_lb(double weight_lb, double speed_mph) {
  const double speed = inch_per_s_of_mph * speed_mph;
  return mass_of(weight_lb) * speed * speed / 2;
}

double elastic_time_to_peak_ms(double weight_lb, double stiffness_lb_per_in) {
  return 1e3 * half_pi * std::sqrt(mass_of(weight_lb) / stiffness_lb_per_in);
}

double stiffness_of_time(double weight_lb, double time_ms) {
  const double ratio = half_pi / (1e-3 * time_ms);
  return mass_of(weight_lb) * ratio * ratio;
}

double elastic_peak_force_lb(double weight_lb, double speed_mph, double stiffness_lb_per_in) {
  return inch_per_s_of_mph * speed_mph * std::sqrt(stiffness_lb_per_in * mass_of(weight_lb));
}

double support_energy_in_lb(const std::vector<StaticPoint>& points, double force_lb) {
  StaticPoint last;
  double energy = 0;
  double slope = 0;
  for (const StaticPoint& point : points) {
    slope = (point.force_lb - last.force_lb) / (point.deflection_in - last.deflection_in);
    if (force_lb <= point.force_lb) break;
    energy += (point.force_lb + last.force_lb) * (point.deflection_in - last.deflection_in) / 2;
    last = point;
  }
  if (points.empty() || force_lb <= 0) return 0;
  return energy + (force_lb * force_lb - last.force_lb * last.force_lb) / (2 * slope);
}

double trend_energy_in_lb(double force_lb, double factor, double exponent) {
  return std::pow(factor * force_lb, exponent);
}

double trend_force_lb(double energy_in_lb, double factor, double exponent) {
  return std::pow(energy_in_lb, 1 / exponent) / factor;
}

double energy_on_plate_in_lb(const ValidationData& data, double force_lb) {
  return trend_energy(data, force_lb) - support_energy_in_lb(data.load_cell, force_lb) +
         force_lb * force_lb / (2 * data.plate_stiffness_lb_per_in);
}

ExpectationExample expectation(const ValidationData& data, Projectile projectile, double speed_mph,
                               double peak_force_lb, double rebound_ratio) {
  ExpectationExample example{projectile, speed_mph};
  example.energy_in_lb = impact_energy_in_lb(weight_of(data, projectile), speed_mph);
  example.peak_force_lb = peak_force_lb;
  example.rebound_energy_in_lb = rebound_ratio * rebound_ratio * example.energy_in_lb;
  example.support_energy_in_lb = support_energy_in_lb(data.load_cell, peak_force_lb);
  example.speed_ratio =
      std::sqrt((example.rebound_energy_in_lb + example.support_energy_in_lb) / example.energy_in_lb);
  example.rebound_mph = example.speed_ratio * speed_mph;
  return example;
}

double curve_a_speed_mph(const ValidationData& data, Projectile projectile, double force_lb) {
  return speed_of_energy_mph(trend_energy(data, force_lb), weight_of(data, projectile));
}

double curve_b_speed_mph(const ValidationData& data, Projectile projectile, double force_lb) {
  return speed_of_energy_mph(energy_on_plate_in_lb(data, force_lb), weight_of(data, projectile));
}

double weight_of(const ValidationData& data, Projectile projectile) {
  const auto test = std::ranges::find(data.measured.tests, projectile, &MeasuredTest::projectile);
  if (test == data.measured.tests.end())
    throw std::out_of_range(std::string("no test has the projectile ") + to_string(projectile));
  return test->weight_lb;
}

}  // namespace dashpad::report1986
