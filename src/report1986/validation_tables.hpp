#pragma once
/// The tables of the validation, and their wording.

#include <map>
#include <string>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad::report1986 {

/// Tables by the names of their blocks in docs/validation.md.
using Tables = std::map<std::string, output::Table>;
Tables validation_tables(const Study& study);

/// Adds the tables of verdicts, errors by test, and the anomaly.
void add_verdict_tables(const Study& study, Tables& tables);

/// The reservation about the scores of held-out tests.
inline constexpr const char* seen_data =
    "This is not a blind test: each test is predicted by a foam that was fitted without it, but the form of "
    "the foam law was chosen with knowledge of all the tests.";

/// "+12.3 %", or "+0.012" for strain.
std::string bias_text(double value, Quantity quantity);
std::string scatter_text(double value, Quantity quantity);
/// "4, plus 1 without prediction".
std::string tests_text(std::size_t tests, int missing);
const char* passed_or_not(bool passed);

/// "explains it", "explains it in part", "does not explain it".
const char* words(Explanation explanation);

/// The number of scores that pass: "4 of 7".
struct Tally {
  int passed = 0, all = 0;
  void count(bool has_passed) { ++all, passed += has_passed ? 1 : 0; }
  [[nodiscard]] bool passes_all() const { return all > 0 && passed == all; }
};
Tally tally(const Study& study, Program program);

/// The verdict and the biases behind it.
output::Lead validation_lead(const Study& study, output::Pictures pictures);

}  // namespace dashpad::report1986
