#pragma once
/// A limit over the levels of a study without draws.

#include <string>

#include "dashpad/study/answers.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

/// "HIC15 exceeds 1000"
std::string exceeds(const study::StudyLimit& limit, const UnitSystem& units);

/// Over one factor, from where on the limit is exceeded, or with which of its names; over two, up to where it
/// is kept at the ends of the second. Empty where that is no sentence: with other factors, undecided rows,
/// and where it changes more than once or not at all.
std::string where_exceeded(const study::StudyAnswers& answers, const study::StudyLimit& limit,
                           const UnitSystem& units);

}  // namespace dashpad::output
