#pragma once
/// Doubles as a number type of src/model/pad/formulas.hpp.

#include <cstddef>

#include "dashpad/quantities/portable_math.hpp"

namespace dashpad::scalar {

using portable::exp;
using portable::log;
using portable::pow;

/// Evaluates only the chosen alternative.
template <class Yes, class No>
auto choose(bool where, Yes&& yes, No&& no) {
  return where ? yes() : no();
}

inline double max(double a, double b) { return a > b ? a : b; }
inline double min(double a, double b) { return a < b ? a : b; }
inline bool both(bool a, bool b) { return a && b; }
inline bool all(bool given) { return given; }
inline double select(bool where, double yes, double no) { return where ? yes : no; }

/// Loads and stores numbers of a type, one or several at a time.
template <class N>
struct Register;
template <>
struct Register<double> {
  static constexpr std::size_t size() { return 1; }
  static double load(const double* from) { return *from; }
  static void store(double x, double* to) { *to = x; }
  static double first(std::size_t, double x) { return x; }
};

}  // namespace dashpad::scalar
