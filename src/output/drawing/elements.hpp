#pragma once
/// The elements of the drawing, each with its class; all places in px.

#include <string>
#include <string_view>
#include <vector>

namespace dashpad::output {

struct Place {
  double x = 0;
  double y = 0;
};

std::string line_element(std::string_view style, Place from, Place to);
std::string rectangle_element(std::string_view style, double x, double y, double width, double height);
/// Straight from place to place; `closed` back to the first.
std::string path_element(std::string_view style, const std::vector<Place>& places, bool closed);
/// A line of text; `anchor`: "start", "middle" or "end".
std::string text_element(std::string_view style, Place place, std::string_view anchor, std::string_view text);

/// The data of a path through these places.
std::string path_data(const std::vector<Place>& places, bool closed);

/// Sizes of the drawing's texts, px: pages from 390 px on show them at 12 px and more.
inline constexpr double text_size = 15;
inline constexpr double small_text_size = 14;
inline constexpr double heading_size = 15;

/// `text` with spaces at which no line is broken: for a number and its unit.
std::string unbroken(std::string text);

/// Stands for the drawing's own name, in ids and what refers to them, until impact_drawing() puts it there;
/// no readable text has this character.
inline constexpr std::string_view own_name = "\x01";

}  // namespace dashpad::output
