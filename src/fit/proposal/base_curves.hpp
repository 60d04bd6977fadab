#pragma once
/// Base curves for tests: the slowest one as a table, or formulas with where to start.

#include <optional>
#include <string>
#include <vector>

#include "fit/proposal/evidence.hpp"

namespace dashpad::fit {

/// The slowest test as a table, and where a formula may start.
struct Beginning {
  std::size_t slowest = 0;    ///< index of the test
  TableCurve table;           ///< its loading
  double modulus = 0;         ///< Pa, of its beginning
  double plateau = 0;         ///< Pa, a third of the way to its highest strain
  double highest_strain = 0;  ///< of all tests
};

/// Adds what the reader of the table says of the slowest test to `remarks`; absent after a fault.
std::optional<Beginning> beginning_of(const ReadTests& tests, std::vector<std::string>& remarks,
                                      std::vector<input::Fault>& faults);

/// Makes a number of the case an unknown, by its logarithm if its bounds are positive and far apart.
void seek(Fit& fit, const std::string& key, double lowest, double highest, double start);

/// A base curve with what is sought of it.
struct Base {
  std::string name;
  BaseCurve curve;
  void (*seek)(Fit& fit, const Beginning& from) = [](Fit&, const Beginning&) {};
};

/// The formulas that are tried, each with its unknowns.
std::vector<Base> formulas(const Beginning& from);

}  // namespace dashpad::fit
