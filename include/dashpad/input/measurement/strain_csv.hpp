#pragma once
/// A strain history from a table of numbers: CSV in, times and strains out.

#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

struct StrainTable {
  std::vector<double> time = {};          ///< s, increasing
  std::vector<double> strain = {};        ///< the first is 0, all in [0, 1)
  std::vector<std::string> remarks = {};  ///< what was read otherwise than it stands, a sentence each
};

/// Separators, quotes, comments, decimal commas and header as in pulse_csv.hpp. The header is needed: it
/// names the time with its unit ("time [ms]", "t_s") and a column called strain, a pure number or in %
/// ("strain", "strain [%]"). Two rows at least, 10,000 at most; strain 0 first. Gives
/// all faults, each with its line, or the first 200.
Reading<StrainTable> read_strain_csv(const std::filesystem::path& file);

}  // namespace dashpad::input
