#pragma once
/// Material cards as files.

#include <string>

#include "dashpad/model/pad/material.hpp"

namespace dashpad::output {

/// The card of a material as TOML in SI that read_material() reads as the same numbers.
std::string card_toml(const Material& material);

/// The part of a card that a case contains, too: the line `law = "..."`, then the law's tables and [fitted],
/// each with `prefix` ("pad.") before its name.
std::string law_toml(const Material& material, const std::string& prefix = "");

}  // namespace dashpad::output
