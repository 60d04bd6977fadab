#pragma once

#include "dashpad/validation/verdict.hpp"
#include "io/json_values.hpp"

namespace dashpad {

/// The report's statements with what we compute: check_claims().
Json claims_json(const validation::Study& study);

}  // namespace dashpad
