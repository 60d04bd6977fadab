/// The head injury criterion and the severity index of a pulse of a million samples, by kind of pulse. The
/// kinds are those that could defeat the search: ties, noise, many peaks, flat tops.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>

#include "dashpad/injury/metrics.hpp"

namespace dashpad::bench {
namespace {

constexpr double step = 1e-5;  // s: 15 ms are 1500 samples
constexpr double pi = std::numbers::pi;

std::mt19937_64 random_bits(1);
double noise() {
  static std::normal_distribution<double> normal;
  return normal(random_bits);
}

/// `level` of 0 <= s <= 1.
template <class F>
Pulse sampled(F&& level) {
  constexpr int size = 1'000'000;
  Pulse pulse;
  for (int i = 0; i < size; ++i) {
    pulse.time.push_back(step * i);
    pulse.acceleration.push_back(level(static_cast<double>(i) / (size - 1)));
  }
  return pulse;
}

/// The argument is the longest window in samples, 0 for none.
template <class F>
void criterion(benchmark::State& state, F level) {
  const Pulse pulse = sampled(level);
  const double window =
      state.range(0) == 0 ? injury::unlimited_window : step * static_cast<double>(state.range(0));
  while (state.KeepRunning()) benchmark::DoNotOptimize(injury::hic(pulse, window));
}

void index(benchmark::State& state) {
  const Pulse pulse = sampled([](double s) { return std::sin(2 * pi * 99 * s); });
  while (state.KeepRunning()) benchmark::DoNotOptimize(injury::severity_index(pulse));
}

void windows(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("samples")->Arg(10)->Arg(1500)->Arg(150'000)->Arg(0)->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(criterion, constant, [](double) { return 1.0; })->Apply(windows);
BENCHMARK_CAPTURE(criterion, nearly_constant, [](double) { return 1 + 1e-9 * noise(); })->Apply(windows);
BENCHMARK_CAPTURE(criterion, slow_ramp, [](double s) { return 1 + 1e-6 * s; })->Apply(windows);
BENCHMARK_CAPTURE(criterion, half_sine, [](double s) { return std::sin(pi * s); })->Apply(windows);
BENCHMARK_CAPTURE(criterion, noisy_half_sine, [](double s) {
  return std::sin(pi * s) + 0.05 * noise();
})->Apply(windows);
BENCHMARK_CAPTURE(criterion, five_peaks, [](double s) {
  return std::abs(std::sin(5 * pi * s));
})->Apply(windows);
BENCHMARK_CAPTURE(criterion, sine, [](double s) { return std::sin(2 * pi * 777 * s); })->Apply(windows);
BENCHMARK_CAPTURE(criterion, square_wave, [](double s) {
  return std::fmod(1e5 * s + 1e-7, 1) < 0.5 ? 1 : -1;
})->Apply(windows);
BENCHMARK_CAPTURE(criterion, alternating, [](double s) {
  return std::lround(999'999 * s) % 2 == 0 ? 1 : -1;
})->Apply(windows);
BENCHMARK_CAPTURE(criterion, white_noise, [](double) { return noise(); })->Apply(windows);
BENCHMARK_CAPTURE(criterion, random_walk, [a = 0.0](double) mutable { return a += noise(); })->Apply(windows);
BENCHMARK_CAPTURE(criterion, spike, [](double s) {
  return std::abs(s - 0.5) < 6e-7 ? 1 : 0;
})->Apply(windows);
/// Every window from the start has nearly the same value.
BENCHMARK_CAPTURE(criterion, ties_of_all_lengths, [](double s) {
  return std::pow(s + 1e-6, -0.4);
})->Apply(windows);
BENCHMARK(index)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dashpad::bench
