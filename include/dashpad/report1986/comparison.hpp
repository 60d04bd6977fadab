#pragma once
/// One impact through the accurate solver and through the program of 1984, side by side.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::report1986 {

/// One way to compute the impact. SI; compression positive, speeds as magnitudes.
struct ComparedRun {
  std::string name;
  std::string remark;                ///< why its figures are not to be trusted; empty if nothing is wrong
  bool finished = false;             ///< came to the end of contact
  bool trustworthy = false;          ///< the accurate solver's tolerance is met; never of the program of 1984
  std::optional<double> peak_force;  ///< N; of an unfinished run: until its last accepted step
  std::optional<double> time_of_peak_force;  ///< s
  double peak_penetration = 0;               ///< m
  double peak_motion = 0;                    ///< m
  /// When the force falls below the sphere's weight on rebound, the end of the 1984 program. Of finished
  /// runs.
  std::optional<double> end_time;   ///< s
  std::optional<double> end_speed;  ///< m/s
  std::vector<double> time, force, penetration;
};

struct Comparison {
  /// The accurate solver with exact units; the accurate solver with the constants of 1984, which is what the
  /// rest is compared with; the program of 1984 in pdp10, binary32 and binary64 arithmetic; the program with
  /// its defects mended, in binary64.
  std::vector<ComparedRun> runs;
  static constexpr std::size_t reference = 1, program = 2;
  double time_step = 0;  ///< of the 1984 program, s
  int dimension = 0;     ///< of its time history and its contact field
};

/// Is told how many time steps of the 1984 program are done, of about how many, all runs together.
using ComparisonProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Runs all of them. `time_step` is that of the 1984 program, s; for steps below 0.1 ms its dimensions of
/// 1000 are enlarged in proportion. Throws std::invalid_argument for a case with violations() or with
/// what_a_deck_cannot_say().
Comparison compare(const ImpactCase& impact, const Options& options, double time_step,
                   const ComparisonProgress& progress = {});

/// How far the program of 1984 is off, what to beware of in each run, and a row a run.
output::Document comparison_document(const Comparison& comparison, const ImpactCase& impact,
                                     const UnitSystem& units,
                                     output::Pictures pictures = output::Pictures::left_out);

/// The table as JSON, SI.
std::string comparison_json(const Comparison& comparison);

/// Force over time and penetration over time. Unfinished runs are drawn as far as they stay in sight.
output::Plot comparison_plot(const Comparison& comparison, const ImpactCase& impact, const UnitSystem& units);

}  // namespace dashpad::report1986
