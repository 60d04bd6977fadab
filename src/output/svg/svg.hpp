#pragma once
/// What every SVG that Dashpad writes is made of: numbers, texts and how wide they are.

#include <string>
#include <string_view>

namespace dashpad::output {

/// A length or place in px: at most two decimals, never "-0"; what is not finite is 0.
std::string px(double value);

/// Anybody's text as XML character data or attribute: readable(), and without a character that has a meaning.
std::string xml_text(std::string_view text);

/// Width of a text in px in a sans-serif font of that size, by the widths of Helvetica's characters, which
/// common ones share within a few per cent; DejaVu Sans is a tenth wider.
double text_width(std::string_view text, double size);

}  // namespace dashpad::output
