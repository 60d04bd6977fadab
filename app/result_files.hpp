#pragma once
/// The result of one solved impact, as shown and written by dashpad run and dashpad study replay.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/reading.hpp"
#include "output_files.hpp"

namespace dashpad::app {

/// Adds --json, --csv, --report, --markdown, --png, --drawing, --units and --all.
void add_result_files(CLI::App& app, OutputFiles& files);

/// Adds to `errors` what forbids writing them.
void judge_result_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                        std::vector<std::string>& errors);

struct SolvedCase {
  const ImpactCase& impact;
  const Options& options;
  const Solution& solution;
  std::span<const Blow> blows = {};  ///< the blows of a series; `solution` is that of the last
};

/// Writes the files, then shows the summary between `heading` and `after`. Throws as PendingFile does.
void publish(const OutputFiles& files, const SolvedCase& solved, std::string_view heading = "",
             std::string_view after = "");

}  // namespace dashpad::app
