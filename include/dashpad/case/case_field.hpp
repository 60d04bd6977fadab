#pragma once
/// The numbers that a case may give beside those of its law, its nose and the curve of its support: read from
/// the tables that stand with the structures, for documents, schemas and whoever asks for a list.

#include <string>
#include <vector>

#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct CaseField {
  std::string table;  ///< "pad", "pad.layers"
  std::string key;    ///< in that table: "area"
  std::string unit;   ///< SI; "1" for a pure number
  std::string rule;   ///< "must be at least 0 m"
  LeftOut left_out = LeftOut::refused;
  double default_value = 0;  ///< SI, of LeftOut::as_default; NaN for one that is absent then
  std::string meaning;
};

/// In the order of case files.
std::vector<CaseField> case_fields();

}  // namespace dashpad
