#pragma once
/// The impacts that are timed: reference cases of data/reference-cases.csv. c1 and c2 are the report's
/// dashboard example with the 9- and the 21-parameter law.

#include <string>

#include "oracle/reference_cases.hpp"

namespace dashpad::bench {

inline oracle::ReferenceCase reference_of(const std::string& id) {
  return oracle::reference_case(std::filesystem::path(DASHPAD_SOURCE_DIR) / "data/reference-cases.csv", id);
}

inline ImpactCase impact_of(const std::string& id) { return reference_of(id).impact; }

}  // namespace dashpad::bench
