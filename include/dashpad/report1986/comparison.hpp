#pragma once
/// Compares one impact by the accurate solver with the same impact by the program of 1984.

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

/// One way of computing the impact. SI; compression is positive, speeds are magnitudes.
struct ComparedRun {
  std::string name;
  std::string remark;                        ///< why the figures cannot be trusted; empty if they can
  bool finished = false;                     ///< reached the end of contact
  bool trustworthy = false;                  ///< meets the tolerance; always false for the program of 1984
  std::optional<double> peak_force;          ///< N; up to the last accepted step if the run is unfinished
  std::optional<double> time_of_peak_force;  ///< s
  double peak_penetration = 0;               ///< m
  double peak_motion = 0;                    ///< m
  /// The end by the 1984 program's criterion: the force falls below the sphere's weight on rebound. Absent if
  /// the run is unfinished.
  std::optional<double> end_time;   ///< s
  std::optional<double> end_speed;  ///< m/s
  std::vector<double> time, force, penetration;
};

struct Comparison {
  /// In this order: the accurate solver with exact units; the same with the constants of 1984, the reference
  /// for all others; the program of 1984 in pdp10, binary32 and binary64; the program with its defects
  /// mended, in binary64.
  std::vector<ComparedRun> runs;
  static constexpr std::size_t reference = 1, program = 2;
  double time_step = 0;  ///< of the 1984 program, s
  int dimension = 0;     ///< of its time history and its contact field
};

/// Receives the number of the 1984 program's time steps that are done, and about how many there are.
using ComparisonProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Computes all runs. `time_step` is that of the 1984 program, s; below 0.1 ms its dimensions of 1000 grow in
/// proportion. Throws std::invalid_argument for a case with violations() or what_a_deck_cannot_say().
Comparison compare(const ImpactCase& impact, const Options& options, double time_step,
                   const ComparisonProgress& progress = {});

/// The error of the 1984 program, the warnings of each run, and a table with one row per run.
output::Document comparison_document(const Comparison& comparison, const ImpactCase& impact,
                                     const UnitSystem& units,
                                     output::Pictures pictures = output::Pictures::left_out);

/// The same table as JSON, SI.
std::string comparison_json(const Comparison& comparison);

/// Force and penetration over time. Unfinished runs are drawn as far as they stay within the scale.
output::Plot comparison_plot(const Comparison& comparison, const ImpactCase& impact, const UnitSystem& units);

}  // namespace dashpad::report1986
