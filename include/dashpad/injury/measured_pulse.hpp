#pragma once
/// A measured pulse, with all that is needed to say later where it came from.

#include <string>
#include <vector>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// A column of a table or a channel of a test, and its unit.
struct MeasuredColumn {
  std::string name = {};         ///< as in the file, UTF-8; "column 2" where the file has no name
  int number = 0;                ///< from 1
  std::string unit = {};         ///< as given or as in the file; empty if nobody said
  std::string unit_origin = {};  ///< "given", "header"; "format" where the file format fixes it
  double factor = 1;             ///< one unit in SI
  std::string sensitivity = {};  ///< as given, "10 mV/g", where the unit is one of volts; else empty
};

struct MeasuredPulse {
  Pulse pulse = {};         ///< the resultant, if there is one
  std::string format = {};  ///< "CSV", "ISO-MME"
  MeasuredColumn time = {};
  /// The time of the first sample as in the file, "1764068400.1234 s", where the times of the pulse count
  /// from there, since its clock began more than a thousand times the length of the record ago; else empty.
  std::string counts_from = {};
  std::vector<MeasuredColumn> acceleration = {};  ///< one, or the two or three of a resultant
  bool resultant = false;
  /// The directions of a resultant, m/s2, at the times of the pulse; empty without. Filters are for these:
  /// the resultant of noise has a mean, which no filter takes away.
  std::vector<std::vector<double>> components = {};
  std::vector<std::string> remarks =
      {};  ///< repairs and readings that the user should know of, a sentence each
};

/// sqrt(x^2 + y^2 + z^2) at each time.
std::vector<double> resultant_of(const std::vector<std::vector<double>>& components);

}  // namespace dashpad::injury
