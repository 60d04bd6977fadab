#pragma once
/// Numbers and foreign text as people read them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {

/// The number with significant digits and trailing zeros: "8.9408", "5768.8". Whole numbers keep all digits:
/// "123457". "none" if it is not finite.
std::string significant(double value, int digits = 5);

/// The same without trailing zeros: "25.4".
std::string brief(double value, int digits = 5);

/// "1230", "0.0123": three digits, and no exponent from 0.0001 to below a million.
std::string plain_number(double value);

/// The unit in which people see an SI unit: g for accelerations, "" for pure numbers, "in·lbf" for in.lbf.
ScaledUnit shown_as(const std::string& si_unit, const UnitSystem& units);

/// A number and its unit, which may be empty: "25.4 mm".
std::string with_unit(const std::string& number, const std::string& unit);

/// An SI value as people see it, with its unit, brief: "25.4 mm", "80 g". Pure numbers have no unit.
std::string brief_quantity(double value, const std::string& si_unit, const UnitSystem& units, int digits = 5);

/// A fraction as a percentage of two digits: "0.0031 %". "unknown" if not finite.
std::string percentage(double fraction);

/// A unit as it is shown: "in.lbf" gives "in·lbf"; "1" gives "".
std::string shown_unit(const std::string& unit);

/// The number with that many significant digits that is nearest to `value`.
double rounded_to(double value, int digits);

/// UTF-8 characters, which is what a column of a terminal holds: units have a · and a ³.
std::size_t width_of(std::string_view text);

/// "1 figure", "2 figures".
std::string plural(std::size_t count, const std::string& noun);

/// "a sphere", "an ellipsoid".
std::string with_article(const std::string& words);

/// Bytes of the UTF-8 character at the front of `text`; 0 if there is none (RFC 3629).
std::size_t character_length(std::string_view text);

/// Text made safe for one line of a terminal: line breaks, other control characters and changes of the
/// writing direction become spaces.
std::string one_line(std::string_view text);
/// The same for several lines, keeping line breaks and tabs; bytes that are not UTF-8 become U+FFFD.
std::string without_controls(std::string_view text);

/// A name as a message quotes it: at most `most` bytes, then "...", never half a character.
std::string quoted_part(std::string_view text, std::size_t most = 60);
/// A message in which no word is longer than a message can be of use: of such a word the beginning.
std::string without_endless_words(std::string_view line);

/// Every place of `old`, from left to right; what took its place is not looked at again.
void replace_all(std::string& text, std::string_view old, std::string_view fresh);

/// Breaks a line at blanks into lines of at most 100 columns, if possible, and indents all but the first.
std::string wrapped(std::string_view line, std::size_t indent);

/// A field of a table separated by commas, in quotes if it needs them.
std::string csv_field(const std::string& text);

/// A fingerprint of texts and of where each ends, 16 hexadecimal digits: FNV-1a.
std::string fingerprint(const std::vector<std::string>& texts);

}  // namespace dashpad
