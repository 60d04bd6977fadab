#pragma once
/// Whether text can be a unit at all, before UDUNITS-2 sees it: that library reads "20 mph" as a unit of its
/// own, and clocks and logarithms besides.

#include <string>
#include <string_view>

namespace dashpad {

/// Without blanks at the ends, with signs that look like another (the Greek letter mu, the hard space, raised
/// digits) in the form that UDUNITS-2 knows, and "/s" as "1/s".
std::string tidy_unit(std::string_view text);

enum class UnitText { plain, holds_number, not_a_unit };

/// Plain: names, exponents, and the signs / * . ^ ( ) between them. The only number beside exponents is the 1
/// of "1/s".
UnitText kind_of_unit_text(std::string_view text);

}  // namespace dashpad
