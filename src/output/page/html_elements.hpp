#pragma once
/// Texts, figures, bars, tables and SVGs as HTML. Whatever text a user has given is text there, too.

#include <set>
#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

std::string text_html(const std::string& text);
/// The text as HTML in which no line ends between a number and its unit.
std::string prose_html(const std::string& text);
std::string paragraphs_html(const std::vector<std::string>& texts);
/// Lines stay lines.
std::string lines_html(const std::string& text);

const char* class_of_tone(Tone tone);
/// A sign for readers who do not see the colour; empty for a plain tone.
const char* sign_of_tone(Tone tone);

std::string key_figure_html(const ValueRow& figure);
/// A warning; the words in capitals at its front are set apart.
std::string warning_html(const std::string& line);
std::string range_html(const RangeBar& range);
std::string table_html(const Table& table);

/// The SVGs of a page. Their styles go into its head, once each, so that a drawing in other units can replace
/// the first one without removing its style.
class InlineSvgs {
 public:
  /// The element without its style.
  std::string add(std::string svg);
  /// The same of a plot, `width` px wide; a sentence if there is nothing to draw.
  std::string add(const Plot& plot, double width);
  /// A drawing with two pictures, followed by each half alone; the style of the page chooses what is shown.
  std::string add_with_halves(std::string svg);
  /// The texts of all styles so far.
  [[nodiscard]] const std::set<std::string>& styles() const { return styles_; }

 private:
  std::set<std::string> styles_;
};

/// The texts of an SVG that this library has made, in their order, its description first.
std::vector<std::string> texts_in(const std::string& svg);
/// Whether two of them differ in nothing but their texts.
bool differ_in_texts_only(const std::string& one, const std::string& other);

}  // namespace dashpad::output
