#pragma once
/// The report's numbers that follow from other numbers of the report, computed again (sections 3.2, 3.3 and
/// 4).

#include <string>
#include <vector>

#include "dashpad/report1986/validation/measured_tests.hpp"

namespace dashpad::report1986 {

/// A number that the report states, in its unit.
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
