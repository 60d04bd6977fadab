// main() of the programs that use Google Benchmark: like its own, with the facts of machine.hpp in the
// results.

#include <benchmark/benchmark.h>

#include "machine.hpp"

int main(int count, char** arguments) {
  for (const auto& [key, value] : dashpad::bench::machine_facts()) benchmark::AddCustomContext(key, value);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
