#pragma once
/// The printed report of the 1984 program, in the layout of the report's Appendix C.

#include <string>

#include "dashpad/spit1984/run.hpp"

namespace dashpad::spit1984 {

/// The two devices that the listing writes to. The line printer (unit 21) printed Appendix C. Only the
/// terminal (unit 5) is told of iterations stopped at the precision limit and of ABENDs 903 and 904.
enum class Device { printer, terminal };

/// The whole report: FORMAT statements 6000 and 601 to 613. Lines end in '\n'. The first character of each
/// Fortran record is carriage control and becomes what it did: '1' a form feed, '0' an empty line before.
std::string listing(const Deck& deck, const Run& run, Device device);

}  // namespace dashpad::spit1984
