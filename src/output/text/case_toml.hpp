#pragma once
/// A case as a case file that repeats it, and what the writers of cases and cards make of texts and numbers.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

/// The case as TOML in SI, which read_case() reads as the same numbers. It contains the law, so that no card
/// is needed; the source of the material is a comment.
std::string case_toml(const ImpactCase& impact, const Options& options);

/// A basic string of TOML, in one line; what is not UTF-8 is mended.
std::string toml_string(const std::string& text);

/// The shortest number that reads back exactly, as a text with its unit unless that is 1.
std::string toml_value(double number, const std::string& unit);

/// `key = value` and the end of the line.
std::string toml_line(const std::string& key, double number, const std::string& unit);
std::string toml_line(const std::string& key, const std::string& text);

/// `key = [...]`, folded to lines of 110 columns.
std::string toml_line(const std::string& key, const std::vector<double>& numbers);

}  // namespace dashpad::output
