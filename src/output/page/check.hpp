#pragma once
/// Whether what a page of figures is made of fits together.

#include "dashpad/output/document.hpp"

namespace dashpad::output {

/// Throws std::invalid_argument if columns of a series or rows of a table differ in length, if an axis
/// cannot have its limits, or a bar its ends.
void check(const Document& page);

}  // namespace dashpad::output
