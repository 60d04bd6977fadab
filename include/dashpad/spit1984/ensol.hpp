#pragma once
/// The main program ENSOL of the report's Appendix C: a dialogue at a terminal that fills a deck.

#include <iosfwd>
#include <optional>

#include "dashpad/spit1984/deck.hpp"

namespace dashpad::spit1984 {

/// Asks on `terminal` what ENSOL asked, in its words and order, and reads the answers as its FORMATs I, E10.0
/// and 2F did. Absent where the input ends before the last answer.
///
/// Models 4 and 5 get the parameters of Ensolite AAC. ENSOL never asked for those of models 1 to 3: they stay
/// zero, as they did in 1984. Throws std::runtime_error where `terminal` can no longer be written to.
std::optional<Deck> ensol(std::istream& input, std::ostream& terminal);

}  // namespace dashpad::spit1984
