#pragma once
/// A source in words, as lists of references and tables have it.

#include <string>
#include <vector>

#include "dashpad/output/citation.hpp"

namespace dashpad::output {

/// "Avalle, M.; Ibba, A.: Mechanical models of cellular solids. International Journal ... 34 (2007) 3-27."
std::string reference_words(const Citation& citation);

/// What a record has no field of its own for, a sentence each: source, what is used, remarks.
std::vector<std::string> notes_of(const Citation& citation);

}  // namespace dashpad::output
