#pragma once
/// One step of all columns under strain, by vectors of columns: strain, envelope, stress (theory.md, Eq. 7)
/// and g (Eq. 23). The instruction set is that of the processor the program runs on.
///
/// The plain form of the same formulas is in the laws (dashpad/pad/law.hpp) and in
/// contact/column_field.hpp; tests/property/test_vector_path.cpp compares the two.

#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/columns.hpp"
#include "contact/loading_force.hpp"
#include "dashpad/pad/law.hpp"

namespace dashpad {

/// How columns are computed: by vectors, or one by one with the laws' own functions.
enum class ColumnMath { vector, plain };

/// What is the same for all columns of a step. Lengths in m.
struct SweepStep {
  const double* depth = nullptr;
  std::size_t count = 0;  ///< columns under strain after the step, > 0
  double thickness = 0;
  double radius = 0;
  double before = 0;   ///< penetration before the step
  double after = 0;    ///< and after it
  double largest = 0;  ///< largest penetration so far
};

/// Fills `next` from `now`.
void sweep(const LinearViscoelastic& law, const PowerShape& power, const LinearViscoelastic::RatePart& rate,
           const LinearViscoelastic::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next);
void sweep(const NineParameter& law, const PowerShape& power, const NineParameter::RatePart& rate,
           const NineParameter::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next);
void sweep(const TwentyOneParameter& law, const PowerShape& power, const TwentyOneParameter::RatePart& rate,
           const TwentyOneParameter::TimePart& time, const SweepStep& step, const Columns& now,
           const Columns& next);

/// The state of `step.count` columns after a loading that is known step by step, from rest.
void replay(const NineParameter& law, const PowerShape& power, const std::vector<LoadingStep>& steps,
            const SweepStep& step, const Columns& columns);

/// Sum of the positive parts of the first `cells` cells between neighbouring columns, in which g is linear
/// in w.
double sum_of_cells(const Columns& columns, std::size_t cells);

/// The rate at which held columns relax: h (G - stress) / A (R - s) where they press, else 0. G is
/// `still` times the law's first strain part, h is `rate` times exp(-log_base strain).
struct HeldRate {
  double still = 1;
  double rate = 0;  ///< 1/s
  double log_base = 0;
};
inline HeldRate held_rate(const LinearViscoelastic& law, double time) {
  return {1, law.relaxation_rate(time, 0), 0};
}
inline HeldRate held_rate(const NineParameter& law, double time) {
  return {law.asymptotic_modulus, law.relaxation_rate(time, 0), 0};
}
inline HeldRate held_rate(const TwentyOneParameter& law, double time) {
  return {1, law.relaxation_rate(time, 0), std::log(law.relaxation_strain_base)};
}
/// Integral over w of that rate from column to column, all of `step.count`; the last column's value is left
/// in `edge`.
double sum_of_held(const HeldRate& held, const SweepStep& step, const Columns& columns, double& edge);

}  // namespace dashpad
