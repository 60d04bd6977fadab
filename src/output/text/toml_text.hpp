#pragma once
/// Texts, numbers and entries as TOML, for the writers of cases and cards.

#include <string>
#include <vector>

namespace dashpad::output {

/// A basic string of TOML, in one line; what is not UTF-8 is mended.
std::string toml_string(const std::string& text);

/// A number with the fewest digits that are read as the same number; a text with its unit where that is
/// not 1.
std::string toml_value(double number, const std::string& unit);

/// `key = value` and the end of the line.
std::string toml_line(const std::string& key, double number, const std::string& unit);
std::string toml_line(const std::string& key, const std::string& text);

/// `key = [...]`, folded to lines of 110 columns.
std::string toml_line(const std::string& key, const std::vector<double>& numbers);

}  // namespace dashpad::output
