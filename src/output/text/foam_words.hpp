#pragma once
/// A foam in words: where it comes from, and how far it is known.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The smallest relative uncertainty of a figure that rests on a foam beyond its tests.
inline constexpr double known_beyond_tests = 0.15;

/// "tested" for laws with curves, "fitted" for others.
const char* how_known(const Material& material);

/// Whether a strain lies beyond the highest one by more than rounding.
bool is_beyond(double strain, const FittedRange& range);

/// The material's title with its name and law.
std::string material_words(const Material& material);

}  // namespace dashpad::output
