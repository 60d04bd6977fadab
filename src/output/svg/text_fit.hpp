#pragma once
/// Texts in a given width. Nobody knows the reader's font, so there is room for a wide one.

#include <string>
#include <string_view>
#include <vector>

namespace dashpad::output {

/// `text` with blanks that are no place to break a line where a unit follows its number.
std::string quantities_whole(std::string_view text);

/// A bold text has room where one that is so many times as large has.
inline constexpr double size_for_bold = 1.17;

/// Room in px for a text of that size, also in a wide font.
double text_room(std::string_view text, double size);

/// `text`, readable, cut with "…" where it has no room in `width`. All in px.
std::string fitting(std::string_view text, double size, double width);

/// `text`, readable, in lines that have room in `width`, where possible broken at spaces. All in px.
std::vector<std::string> lines_within(std::string_view text, double size, double width);

}  // namespace dashpad::output
