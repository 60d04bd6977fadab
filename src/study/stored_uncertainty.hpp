#pragma once
/// The uncertainty of a foam in the store of a study that draws it.

#include "dashpad/model/pad/material.hpp"
#include "json/json_values.hpp"

namespace dashpad::study {

Json uncertainty_json(const Uncertainty& uncertainty);
/// Throws an exception of JSON for what it cannot be.
Uncertainty uncertainty_of(const Json& json);

}  // namespace dashpad::study
