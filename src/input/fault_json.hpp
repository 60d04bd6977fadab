#pragma once
/// Faults as data.

#include "dashpad/input/fault.hpp"
#include "json/json_values.hpp"

namespace dashpad {

/// {"file", "line" (null if unknown), "key", "value" (as written), "rule"}; texts are empty where there is
/// none.
inline Json fault_json(const input::Fault& fault) {
  return {{"file", fault.file},
          {"line", fault.line > 0 ? Json(fault.line) : Json(nullptr)},
          {"key", fault.key},
          {"value", fault.value},
          {"rule", fault.rule}};
}

}  // namespace dashpad
