#pragma once
/// An SVG as pixels and as a document, by librsvg and cairo.

#include <string>
#include <string_view>

namespace dashpad::output {

// Both throw std::runtime_error with the words of the library that failed.

/// With two pixels to one px.
std::string png_of(std::string_view svg);

/// One page as large as the SVG, 96 px to an inch. It holds no date.
std::string pdf_of(std::string_view svg, const std::string& title);

}  // namespace dashpad::output
