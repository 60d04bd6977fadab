#pragma once
/// The report's energy account (section 3.3, Eqs. 32 and 34 to 37, Table 3-2), in its units and with its
/// constants: 17.64 in/s to the mile per hour, 386.4 in/s2.

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
/// Its inverse: the stiffness that a time stands for, lb/in.
double stiffness_of_time(double weight_lb, double time_ms);

/// Eq. 34: F = V sqrt(K M), lb.
double elastic_peak_force_lb(double weight_lb, double speed_mph, double stiffness_lb_per_in);

/// Eq. 35: elastic work of a piecewise linear support at a force, in.lb. `points` as in ValidationData.
double support_energy_in_lb(const std::vector<StaticPoint>& points, double force_lb);

/// Eq. 36: U = (factor F)^exponent, in.lb, and its inverse.
double trend_energy_in_lb(double force_lb, double factor, double exponent);
double trend_force_lb(double energy_in_lb, double factor, double exponent);

/// Eq. 37: U* = U(F) - W_S(F) + F^2 / (2 K): the energy with the plate in place of the load cell, in.lb.
double energy_on_plate_in_lb(const ValidationData& data, double force_lb);

/// Table 3-2 from its first rows: U, U_R = ratio^2 U, W_S, V_R*/V = sqrt((U_R + W_S)/U), V_R*. The peak force
/// is given, as in the report, where it is read from the trend.
ExpectationExample expectation(const ValidationData& data, Projectile projectile, double speed_mph,
                               double peak_force_lb, double rebound_ratio);

/// Curve "A" (load cell) or "B" (plate) of Figures 3-9, 4-2 and 4-3: speed over force, mph.
double curve_a_speed_mph(const ValidationData& data, Projectile projectile, double force_lb);
double curve_b_speed_mph(const ValidationData& data, Projectile projectile, double force_lb);

double weight_of(const ValidationData& data, Projectile projectile);  ///< lb

/// A number that the report states, in its unit, and that follows from other numbers of the report (sections
/// 3.2, 3.3 and 4): computed again.
struct ReportClaim {
  std::string where;  ///< "section 3.3, Eq. 34"
  std::string claim;  ///< what is claimed, for people
  std::string unit;   ///< "1" for a pure number
  double printed = 0;
  double computed = 0;
  double tolerance = 0;  ///< half a unit of the last printed digit; wider where the text says "about"
  bool agrees = false;   ///< |computed - printed| <= tolerance
  std::string remark;    ///< why it does not agree, or what to beware of; may be empty
};

/// All of them, in the order of the report. Those of the model's runs are not among them.
std::vector<ReportClaim> check_claims(const ValidationData& data);

}  // namespace dashpad::report1986
