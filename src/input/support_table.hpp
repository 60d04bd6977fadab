#pragma once
/// The table [support] of a case.

#include "dashpad/model/support/support.hpp"
#include "input/table_reader.hpp"

namespace dashpad::input {

/// A rigid support after a fault.
Support read_support(TableReader& table);

}  // namespace dashpad::input
