#pragma once
/// Closed forms (up to a quadrature or a root) against which columns and impacts are checked.
/// SI; stress, strain and force positive in compression.

#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"
#include "dashpad/model/pad/twenty_one_parameter.hpp"

namespace dashpad::oracle {

/// A rigid sphere on an elastic pad (law 1) on a rigid support: M d2Y/dt2 = -F(Y) from the energy integral.
class ElasticBounce {
 public:
  /// kg, m, m/s, Pa, m; all > 0.
  ElasticBounce(double mass, double radius, double speed, double modulus, double thickness);

  /// F(Y) = 2 pi (E/L) integral of (Y - s)(R - s) ds from 0 to min(Y, R), N.
  [[nodiscard]] double force(double y) const;
  /// Integral of F from 0 to Y, J.
  [[nodiscard]] double energy(double y) const;
  [[nodiscard]] double peak_penetration() const { return deepest_; }
  [[nodiscard]] double peak_force() const { return force(deepest_); }
  /// 2 integral of dY/|V|; Y = Ymax (1 - w^2) removes the singularity at the turning point.
  [[nodiscard]] double contact_time() const;

 private:
  [[nodiscard]] double mean_force(double low, double high) const;

  double mass_, radius_, factor_;  ///< factor: 2 pi E/L
  double deepest_ = 0;
};

/// Law 2, strain = rate * t from rest: E_inf r t + (E_0 - E_inf) tau r (1 - exp(-t/tau)), Pa.
double linear_column_at_constant_rate(const LinearViscoelastic& law, double rate, double time);
/// Law 2, strain applied at once at t = 0 and held: (E_inf + (E_0 - E_inf) exp(-t/tau)) e, Pa.
double linear_column_after_step(const LinearViscoelastic& law, double strain, double time);

/// Where a column starts: its state, and the time since the impact's first contact.
struct ColumnStart {
  double stress = 0;  ///< Pa
  double strain = 0;
  double time = 0;  ///< s
};

/// Law 4 loaded at a constant rate (> 0): G(e) + (stress0 - G(e0)) exp(-(t - t0)/tau), G = A B. From
/// rest, stress0 = e0 = 0, it is A B exactly. Pa.
double nine_column_at_constant_rate(const NineParameter& law, ColumnStart start, double rate, double time);

/// Law 5 loaded at a constant rate (> 0): G(e) + (stress0 - G(e0)) exp(-H), with
/// H = integral of a t^(a-1)/(b c^e) dt by quadrature in u = t^a, where it is not singular. Pa.
double twenty_one_column_at_constant_rate(const TwentyOneParameter& law, ColumnStart start, double rate,
                                          double time);

}  // namespace dashpad::oracle
