/// Time per impact through solve(), and of the parts in which it goes: a try of a step, per column.

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "cases.hpp"
#include "dashpad/impact/solve.hpp"
#include "model/contact/column_field.hpp"

namespace dashpad::bench {
namespace {

/// The argument is the number of digits asked for: tolerance 1e-digits.
void impact(benchmark::State& state, const std::string& id) {
  const ImpactCase impact = impact_of(id);
  Options options;
  options.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)));
  Summary summary;
  while (state.KeepRunning()) summary = solve(impact, options).summary;
  if (!summary.trustworthy()) state.SkipWithError(to_string(summary.status).c_str());
  state.counters["runs"] = summary.runs;
  state.counters["steps"] = static_cast<double>(summary.steps);
  if (summary.stations > 0) state.counters["stations"] = static_cast<double>(summary.stations);
}

/// What solve() takes before its first step, whatever the case: the storage of a history.
void storage(benchmark::State& state) {
  while (state.KeepRunning()) {
    Solver solver;
    benchmark::DoNotOptimize(solver);
  }
}

/// One try of a step on a contact of some hundred columns at half the pad's depth, or on its way back. The
/// time is that of all columns; "column" is the time of one.
template <class Law>
void try_step(benchmark::State& state, const Law& law, bool unloading) {
  constexpr double thickness = 0.0254, radius = 0.0762, speed = 4, step = 2e-5;
  ColumnField<Law> field(law, thickness, Sphere{radius}.sections());
  field.start(0.05);
  double time = 0;
  while (speed * time < thickness / 2) {
    field.accept(field.trial(speed * step, time, step));
    time += step;
  }
  const double advance = (unloading ? -1 : 1) * speed * step;
  while (state.KeepRunning()) benchmark::DoNotOptimize(field.trial(advance, time, step));
  const auto columns = static_cast<double>(field.stations());
  state.counters["columns"] = columns;
  state.counters["column"] = benchmark::Counter(
      columns, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void digits(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("digits")->DenseRange(3, 4)->Unit(benchmark::kMicrosecond);
}
BENCHMARK_CAPTURE(impact, c1, "c1")->Apply(digits);
BENCHMARK_CAPTURE(impact, c2, "c2")->Apply(digits);
BENCHMARK_CAPTURE(impact, c3, "c3")->Apply(digits);
BENCHMARK_CAPTURE(impact, c7, "c7")->Apply(digits);
BENCHMARK_CAPTURE(impact, c9, "c9")->Apply(digits);
BENCHMARK_CAPTURE(impact, f1, "f1")->Apply(digits);
BENCHMARK(storage);
BENCHMARK_CAPTURE(try_step, nine_parameter_loading, oracle::ensolite_nine(), false);
BENCHMARK_CAPTURE(try_step, nine_parameter_unloading, oracle::ensolite_nine(), true);
BENCHMARK_CAPTURE(try_step, twenty_one_parameter_loading, oracle::ensolite_twenty_one(), false);
BENCHMARK_CAPTURE(try_step, twenty_one_parameter_unloading, oracle::ensolite_twenty_one(), true);

}  // namespace
}  // namespace dashpad::bench
