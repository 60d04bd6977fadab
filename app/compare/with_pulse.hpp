#pragma once
/// `dashpad compare`: what was asked for, and the part that lays a measured pulse over a case.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "documents.hpp"
#include "pulse/request.hpp"

namespace dashpad::app {

struct CompareRequest {
  GivenCase given;
  std::optional<std::string> picture;
  std::optional<std::string> json;
  DocumentFiles documents;
  std::string units;
  double time_step_ms = 0.1;
  PulseRequest pulse;
  std::string align = injury::to_string(injury::Alignment::onset);
  std::string materials;
  bool force = false;
};

std::vector<Target> targets(const CompareRequest& request);

/// Adds --pulse and what goes with it, a group of its own in the help.
void add_pulse_options(CLI::App& sub, CompareRequest& request, CLI::Option* time_step);

/// The case beside the pulse of the request; returns the exit code.
int compare_with_pulse(const CompareRequest& request, const std::filesystem::path& materials);

}  // namespace dashpad::app
