// How often the 95 % intervals of fits hold the truth: bench_fit [DATA SETS OF EACH KIND], 200 by default.
//
// Three kinds of made-up data (tests/shared/synthetic_fits.hpp), each with seeds 1 to that number.

#include <cstdio>
#include <cstdlib>

#include "shared/synthetic_fits.hpp"

int main(int argument_count, char** arguments) {
  using namespace dashpad::test;
  const int sets = argument_count > 1 ? std::atoi(arguments[1]) : 200;
  Coverage all;
  for (const auto make : {avalle_loops, hyperfoam_rates, nine_parameter_impacts}) {
    Coverage of;
    for (int seed = 1; seed <= sets; ++seed) count(make(static_cast<std::uint64_t>(seed)), of);
    std::printf("%-65s %4d intervals, %5.1f %% hold the truth; %d open, %d fits failed\n",
                make(1).name.c_str(), of.intervals, 100 * of.share(), of.open, of.failed);
    std::fflush(stdout);
    all.intervals += of.intervals;
    all.hold += of.hold;
  }
  std::printf("%-65s %4d intervals, %5.1f %%\n", "all", all.intervals, 100 * all.share());
}
