#pragma once
/// A compression test from a table of numbers: CSV in, strains and stresses out, with times if there are any.

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// Which columns, by their header with or without its unit, and the units that the header does not say.
struct StressStrainColumns {
  std::string strain = "strain";
  std::string stress = "stress";
  std::string time = {};         ///< empty: the table has no times
  std::string strain_unit = {};  ///< "fraction" or "percent"; empty: from the header, which must say it
  std::string stress_unit = {};  ///< empty: from the header
  std::string time_unit = {};    ///< empty: from the header
};

struct StressStrainTable {
  std::vector<double> time = {};    ///< s, increasing; empty without a column of times
  std::vector<double> strain = {};  ///< engineering strain, below 1; may be below 0 by what noise makes
  std::vector<double> stress = {};  ///< Pa
};

/// Separators, quotes, comments, decimal commas and header as in pulse_csv.hpp; the header is needed. Two
/// rows at least, 10,000 at most. Gives all faults, each with its line, or the first 200: a column that is
/// missing, a unit that nobody stated, numbers that are not finite, times that do not increase, a strain of 1
/// or more (per cent taken for a fraction), strains that are negative in compression.
Reading<StressStrainTable> read_stress_strain_csv(const std::filesystem::path& file,
                                                  const StressStrainColumns& columns);

}  // namespace dashpad::input
