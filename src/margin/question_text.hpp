#pragma once
/// Questions as the command line asks them: their limits, and what is wrong with them.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/input/reading.hpp"
#include "dashpad/margin/margin.hpp"

namespace dashpad::margin {

/// A limit as --until states it, such as "hic15 <= 700".
input::Reading<Limit> read_limit(const std::string& text);

/// An aim, such as "hic15 = 700", is asked for alone: not with other limits, nor with what else is asked for,
/// standards and what is drawn.
std::vector<input::Fault> faults_of_aims(const std::vector<Limit>& limits, std::size_t others);

/// The case whose figures have limits of the user. If its drop height is asked for, it has gravity, as a case
/// that states the height.
Judged judged_by(std::vector<Limit> limits, const ImpactCase& impact, const std::string& key);

/// violations() of a question, under the options and numbers that they are about.
std::vector<input::Fault> faults_of(const Question& question);

}  // namespace dashpad::margin
