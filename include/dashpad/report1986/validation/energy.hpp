#pragma once
/// The report's energy account (section 3.3, Eqs. 32 and 34 to 37, Table 3-2), in its units and constants.

#include <string>
#include <vector>

#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

inline constexpr double inch_per_s_of_mph = 17.64;  ///< the report's; 17.6 would be exact
inline constexpr double gravity_in_per_s2 = 386.4;  ///< the report's; standard gravity is 386.09

/// Mass of a weight, lb s2/in.
double mass_of(double weight_lb);

/// Impact energy M V^2 / 2, in.lb.
double impact_energy_in_lb(double weight_lb, double speed_mph);

/// Eq. 32: T = (pi/2) sqrt(M/K), ms.
double elastic_time_to_peak_ms(double weight_lb, double stiffness_lb_per_in);
/// The inverse of Eq. 32: the stiffness that gives this time to peak, lb/in.
double stiffness_of_time(double weight_lb, double time_ms);

/// Eq. 34: F = V sqrt(K M), lb.
double elastic_peak_force_lb(double weight_lb, double speed_mph, double stiffness_lb_per_in);

/// Eq. 35: elastic work of a piecewise linear support up to a force, in.lb. `points` as in ValidationData.
double support_energy_in_lb(const std::vector<StaticPoint>& points, double force_lb);

/// Eq. 36: U = (factor F)^exponent, in.lb, and its inverse.
double trend_energy_in_lb(double force_lb, double factor, double exponent);
double trend_force_lb(double energy_in_lb, double factor, double exponent);

/// Eq. 37: U* = U(F) - W_S(F) + F^2 / (2 K), the energy with the plate in place of the load cell, in.lb.
double energy_on_plate_in_lb(const ValidationData& data, double force_lb);

/// Table 3-2: U, U_R = ratio^2 U, W_S, V_R*/V = sqrt((U_R + W_S)/U) and V_R*. The peak force is an argument
/// because the report reads it from its trend.
ExpectationExample expectation(const ValidationData& data, Projectile projectile, double speed_mph,
                               double peak_force_lb, double rebound_ratio);

/// Speed over force, mph: curve "A" (load cell) or "B" (plate) of Figures 3-9, 4-2 and 4-3.
double curve_a_speed_mph(const ValidationData& data, Projectile projectile, double force_lb);
double curve_b_speed_mph(const ValidationData& data, Projectile projectile, double force_lb);

double weight_of(const ValidationData& data, Projectile projectile);  ///< lb

/// A number that the report states, recomputed from its other numbers (sections 3.2, 3.3 and 4).
struct ReportClaim {
  std::string where;  ///< "section 3.3, Eq. 34"
  std::string claim;  ///< the statement, for people
  std::string unit;   ///< "1" for a pure number
  double printed = 0;
  double computed = 0;
  double tolerance = 0;  ///< half a unit of the last printed digit; wider where the text says "about"
  bool agrees = false;   ///< |computed - printed| <= tolerance
  std::string remark;    ///< why it does not agree, or a caveat; may be empty
};

/// All claims in the order of the report, except those about the model's runs.
std::vector<ReportClaim> check_claims(const ValidationData& data);

}  // namespace dashpad::report1986
