#pragma once
/// What the factors of a study are called.

#include <string>

namespace dashpad::output {

/// "thickness of the pad" of pad.thickness, "plateau stress of the foam" of pad.curve.plateau_stress; a key
/// that is no quantity of a case stays as it is.
std::string factor_words(const std::string& key);

/// The same, to begin a text with: "Thickness of the pad".
std::string factor_title(const std::string& key);

}  // namespace dashpad::output
