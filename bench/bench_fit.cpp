// How often the 95 % intervals of fits hold the truth: bench_fit [DATA SETS OF EACH KIND], 200 by default.
//
// Three kinds of made-up data (tests/shared/synthetic_fits.hpp), each with seeds 1 to that number; and of
// each the peak force of an impact that the fit has not seen. Flat directions are counted apart.

#include <cstdio>
#include <cstdlib>

#include "shared/synthetic_fits.hpp"

int main(int argument_count, char** arguments) {
  using namespace dashpad::test;
  struct Kind {
    SyntheticFit (*make)(std::uint64_t);
    double speed;  ///< m/s, of the impact that is held out
  };
  const int sets = argument_count > 1 ? std::atoi(arguments[1]) : 200;
  Coverage all;
  for (const auto& [make, speed] :
       {Kind{drifting_avalle_loops, 1.5}, Kind{hyperfoam_rates, 1.5}, Kind{nine_parameter_impacts, 2.6}}) {
    Coverage of;
    for (int seed = 1; seed <= sets; ++seed) {
      SyntheticFit made = make(static_cast<std::uint64_t>(seed));
      hold_out_an_impact(made, speed);
      count(made, of);
    }
    std::printf(
        "%s\n  %d intervals, %.1f %% hold the truth; %d open, %d fits failed, %d with flat directions\n",
        make(1).name.c_str(), of.intervals, 100 * of.share(), of.open, of.failed, of.flat);
    for (const auto& [key, holds] : of.hold_of) std::printf("  %-40s %d of %d\n", key.c_str(), holds, sets);
    std::fflush(stdout);
    all.intervals += of.intervals;
    all.hold += of.hold;
  }
  std::printf("all\n  %d intervals, %.1f %%\n", all.intervals, 100 * all.share());
}
