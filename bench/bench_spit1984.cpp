/// The program of 1984 beside the accurate solver: time per impact and errors, in one run.
///
/// c1 and c2 are the report's example with the 9- and the 21-parameter law. Errors are those of the peak
/// force and of the speed when the force falls below the sphere's weight, against data/reference-cases.csv.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "cases.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/spit1984/run.hpp"

namespace dashpad::bench {
namespace {

constexpr double inch = 0.0254, pound = 4.4482216152605;

void count_errors(benchmark::State& state, const oracle::ReferenceCase& reference, double peak_force,
                  double end_speed) {
  state.counters["force_error"] = std::abs(peak_force / reference.peak_force - 1);
  state.counters["speed_error"] = std::abs(end_speed / -reference.weight.velocity - 1);
}

void accurate(benchmark::State& state, const std::string& id) {
  const oracle::ReferenceCase reference = reference_of(id);
  Options options;
  options.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  Summary summary;
  while (state.KeepRunning()) summary = solve(reference.impact, options).summary;
  if (!summary.trustworthy()) state.SkipWithError(to_string(summary.status).c_str());
  count_errors(state, reference, *summary.peak_force, -summary.weight->velocity);
}

/// The reference cases have the constants of 1984 in their SI values already: undone, the deck says 20 mph.
void historical(benchmark::State& state, const std::string& id, spit1984::Arithmetic arithmetic,
                const spit1984::Defects& defects) {
  const oracle::ReferenceCase reference = reference_of(id);
  ImpactCase impact = reference.impact;
  impact.impactor.speed *= 17.6 / 17.64;
  impact.impactor.mass *= 386.4 * inch / standard_gravity;
  const spit1984::Deck deck = spit1984::deck_of(impact);
  spit1984::Settings settings;
  settings.arithmetic = arithmetic;
  settings.defects = defects;
  spit1984::Run run;
  while (state.KeepRunning()) run = spit1984::run(deck, settings);
  if (run.abend != spit1984::Abend::none)
    state.SkipWithError(("ABEND " + std::to_string(static_cast<int>(run.abend))).c_str());
  count_errors(state, reference, -run.peak_force_lb * pound, -run.history.back().speed_in_per_s * inch);
  state.counters["steps"] = static_cast<double>(run.history.size());
  state.counters["trials"] = static_cast<double>(run.trials);
}

void digits(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("digits")->DenseRange(2, 4)->Unit(benchmark::kMicrosecond);
}

using spit1984::all_mended;
using spit1984::Arithmetic;
constexpr spit1984::Defects as_printed;
constexpr spit1984::Defects no_residue{.edge_residue = false};

BENCHMARK_CAPTURE(accurate, c1, "c1")->Apply(digits);
BENCHMARK_CAPTURE(historical, c1_binary32, "c1", Arithmetic::binary32, as_printed)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(historical, c1_pdp10, "c1", Arithmetic::pdp10, as_printed)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(historical, c1_mended_binary32, "c1", Arithmetic::binary32, all_mended)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(accurate, c2, "c2")->Apply(digits);
BENCHMARK_CAPTURE(historical, c2_binary32, "c2", Arithmetic::binary32, as_printed)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(historical, c2_pdp10, "c2", Arithmetic::pdp10, as_printed)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(historical, c2_no_residue_binary32, "c2", Arithmetic::binary32, no_residue)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace dashpad::bench
