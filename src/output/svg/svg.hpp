#pragma once
/// The parts of SVGs: numbers, texts and their widths, colours, elements; and conversions to pictures.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dashpad::output {

/// px.
struct Place {
  double x = 0;
  double y = 0;
};

/// A length or place in px: at most two decimals, never "-0"; what is not finite is 0.
std::string px(double value);

/// Valid UTF-8 in one line: control characters become spaces, bytes that are not UTF-8 "�".
std::string readable(std::string_view text);
/// `text`, readable, and at most `length` characters long. Where it is cut it ends with "…".
std::string shortened(std::string_view text, std::size_t length);
/// Anybody's text as XML character data or attribute: readable(), and without a character that has a meaning.
std::string xml_text(std::string_view text);
/// `text` with blanks that are no place to break a line where a unit follows its number.
std::string quantities_whole(std::string_view text);

/// A bold text has room where one that is so many times as large has.
inline constexpr double size_for_bold = 1.17;
/// Room in px for a text of that size, also in a wide font: nobody knows the reader's.
double text_room(std::string_view text, double size);
/// `text`, readable, cut with "…" where it has no room in `width`. All in px.
std::string fitting(std::string_view text, double size, double width);
/// `text`, readable, in lines that have room in `width`, where possible broken at spaces. All in px.
std::vector<std::string> lines_within(std::string_view text, double size, double width);

/// Red, green and blue, from 0 to 255.
using Colour = std::array<double, 3>;
/// A colour, "#rrggbb", on a scale of two or more equidistant colours; `share` runs from 0 to 1.
std::string colour_on_scale(std::span<const Colour> stops, double share);

// Elements, each with its class and in a line of its own.

std::string line_element(std::string_view style, Place from, Place to);
std::string rectangle_element(std::string_view style, double x, double y, double width, double height);
/// Straight from place to place; `closed` back to the first.
std::string path_element(std::string_view style, const std::vector<Place>& places, bool closed);
std::string path_element(std::string_view style, std::string_view data);
/// The data of a path through these places.
std::string path_data(const std::vector<Place>& places, bool closed);
/// A line of text that begins there, or as the class says.
std::string text_element(std::string_view style, Place place, std::string_view text);
/// Several lines of text, the first there, each `distance` below the one before.
std::string text_elements(std::string_view style, Place first, double distance,
                          const std::vector<std::string>& lines);
/// `anchor`: "start", "middle" or "end".
std::string text_element(std::string_view style, Place place, std::string_view anchor, std::string_view text);

// Conversions by librsvg and cairo. They throw std::runtime_error with the message of the library.

/// A PNG with two pixels to one px.
std::string png_of(std::string_view svg);
/// A PDF of one page as large as the SVG, at 96 px to an inch, without a date.
std::string pdf_of(std::string_view svg, const std::string& title);

}  // namespace dashpad::output
