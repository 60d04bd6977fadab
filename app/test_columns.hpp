#pragma once
/// The options that say what the columns of compression tests are.

#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "dashpad/input/measurement/tables.hpp"

namespace dashpad::app {

struct TestColumnsRequest {
  std::vector<std::string> rates;
  std::optional<std::string> thickness, area;
  input::StressStrainColumns columns;  ///< as given

  /// Whether an option but --rate was given.
  [[nodiscard]] bool has_columns() const;
};

/// Adds --rate, --strain, --stress, --strain-unit, --stress-unit, --thickness and --area.
void add_test_columns(CLI::App& app, TestColumnsRequest& request);
/// The rates, 1/s, of at most so many files, and the columns.
std::vector<double> rates_of(const TestColumnsRequest& request, std::size_t files,
                             std::vector<std::string>& errors);
input::StressStrainColumns columns_of(const TestColumnsRequest& request, std::vector<std::string>& errors);

}  // namespace dashpad::app
