#pragma once
/// The result of one solved impact, as dashpad run and dashpad study replay give it: files, and a summary for
/// people.

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

/// Tells `wrong` what forbids writing them, as judge_targets does.
void judge_result_files(const OutputFiles& files, const std::vector<input::InputFile>& inputs,
                        std::vector<std::string>& errors);

/// A case, and what came of it.
struct SolvedCase {
  const ImpactCase& impact;
  const Options& options;
  const Solution& solution;
  std::span<const Blow> blows = {};  ///< of a series, whose last one the solution is
};

/// Writes the files, then shows the summary between a heading and what follows it. Throws as PendingFile
/// does.
void publish(const OutputFiles& files, const SolvedCase& solved, std::string_view heading = "",
             std::string_view after = "");

}  // namespace dashpad::app
