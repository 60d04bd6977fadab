#pragma once
/// Texts, figures, bars and tables as HTML. Whatever text a user has given is text there, too.

#include <string>
#include <vector>

#include "dashpad/output/document.hpp"

namespace dashpad::output {

std::string text_html(const std::string& text);
/// In lines that do not end between a number and its unit.
std::string prose_html(const std::string& text);
std::string paragraphs_html(const std::vector<std::string>& texts);
/// Lines stay lines.
std::string lines_html(const std::string& text);

const char* class_of_tone(Tone tone);
/// Beside the colour, which not all see; empty for a plain tone.
const char* sign_of_tone(Tone tone);

std::string key_figure_html(const ValueRow& figure);
/// Its first words, in capitals, are set apart.
std::string warning_html(const std::string& line);
std::string range_html(const RangeBar& of);
std::string table_html(const Table& of);

}  // namespace dashpad::output
