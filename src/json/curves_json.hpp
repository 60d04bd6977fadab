#pragma once
/// The curves of a foam as they stand in every JSON, in SI.

#include "dashpad/model/pad/law.hpp"
#include "json/json_values.hpp"

namespace dashpad {

/// The entries "curve", "rate" and "unloading", the last of which may be null; null for a law without curves.
Json curves_json(const PadLaw& law);

/// Reads them back. Throws what nlohmann::json throws, or std::runtime_error, where something is missing.
void set_curves(PadLaw& law, const Json& json);

}  // namespace dashpad
