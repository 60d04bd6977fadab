#pragma once
/// What `dashpad material-test` was asked for.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "dashpad/laboratory/material_test.hpp"

namespace dashpad::app {

/// As on the command line; absent where not given.
struct MaterialTestRequest {
  std::string material;
  std::string test = "constant-rate";
  std::vector<std::string> rates, stress_limits;
  std::optional<std::string> strain, hold, stress, low, history;
  std::optional<int> cycles, steps;
  bool explicit_1984 = false;
};

/// Adds --test and all that describes it.
void add_test_options(CLI::App& sub, MaterialTestRequest& request);

/// The test. Adds to `wrong` all that is wrong with it, the rows of the history among it.
laboratory::MaterialTest test_of(const MaterialTestRequest& request, std::vector<std::string>& wrong);

}  // namespace dashpad::app
