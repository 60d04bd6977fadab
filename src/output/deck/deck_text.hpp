#pragma once
/// What the texts for other programs have in common.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/output/deck/exports.hpp"

namespace dashpad::output {

/// Printable ASCII in one line: line breaks and other control characters become blanks, any other character
/// that is not ASCII becomes one "?". So does "&", with which LS-DYNA calls a parameter.
std::string plain_ascii(std::string_view text);

/// `text` as comments: folded at blanks, or where a word is too long within it, to lines of at most `width`
/// columns that each begin with `mark` and a blank.
std::string comment(std::string_view mark, std::string_view text, std::size_t width = 80);

/// Version, case, units, signs and flags, a line of text each.
std::vector<std::string> heading(const CurveFile& file);

/// The number in scientific notation with 14 significant digits (13 if negative), right-aligned in 20 columns
/// of which the first is blank.
std::string number_field(double value);

/// Two fields and the end of the line for each point.
std::string number_rows(const Curve& curve);

/// The curve with the numbers of the file's units, which the axes name in the place of SI units. Throws
/// std::invalid_argument if it breaks the rules of exports.hpp.
Curve in_units_of(const CurveFile& file, const Curve& curve);

/// "force (kN) over time (ms)", of a curve with its units as above.
std::string caption(const Curve& curve);

/// The number of the first curve. Throws std::invalid_argument if one of the file's numbers is out of range.
int checked_first_id(const CurveFile& file);

}  // namespace dashpad::output
