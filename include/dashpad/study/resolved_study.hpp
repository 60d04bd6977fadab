#pragma once
/// All that the rows of a study depend on, with what its file only names (cards, data files) written out.

#include <string>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// JSON in SI. Two studies with the same text here have the same rows.
std::string resolved_text(const Study& study);

}  // namespace dashpad::study
