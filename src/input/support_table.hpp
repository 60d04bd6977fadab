#pragma once
/// The table [support] of a case.

#include "dashpad/model/support/support.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

struct SupportEntry {
  Support support = {};  ///< rigid after a fault
  Backing backing = {};
  bool is_known = true;  ///< without a fault
};

SupportEntry read_support(TableReader& table);

}  // namespace dashpad::input
