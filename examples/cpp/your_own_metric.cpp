// What is different about later drops on one cushion, by a metric of your own? Here it is the rise time, from
// 10 % to 90 % of the peak.
//
//   your_own_metric [FOLDER]      FOLDER has examples and materials; by default the working folder
//
// Writes drop-1.csv to drop-5.csv, the histories in SI; numpy.genfromtxt("drop-1.csv", delimiter=",",
// names=True) reads one. Prints, for each drop, the peak, the rise time, and the time above 30 g:
//
//   drop  peak    rise time  above 30 g
//      1  38.1 g    12.6 ms      8.3 ms
//      2  42.7 g    11.8 ms      9.5 ms
//      3  43.4 g    12.2 ms      9.5 ms
//      4  43.5 g    12.2 ms      9.5 ms
//      5  43.5 g    12.2 ms      9.5 ms

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/output/impact.hpp"

namespace {

/// When |a| first reaches a level, s. Samples are not evenly spaced; between them a pulse is straight.
double first_time_at(const dashpad::Pulse& pulse, double level) {
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double before = std::abs(pulse.acceleration[i - 1]), here = std::abs(pulse.acceleration[i]);
    if (before < level && here >= level)
      return std::lerp(pulse.time[i - 1], pulse.time[i], (level - before) / (here - before));
  }
  return dashpad::no_value;
}

}  // namespace

int main(int count, char** arguments) try {
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";
  const auto file =
      dashpad::input::read_case(folder / "examples/five-drops-on-a-cushion.toml", folder / "materials")
          .value();
  constexpr double g = dashpad::standard_gravity;
  std::printf("drop  peak    rise time  above 30 g\n");
  for (const dashpad::Blow& drop : dashpad::solve_blows(file.impact, file.options)) {
    const dashpad::Solution& solution = drop.solution;
    const int number = solution.summary.blow;
    std::ofstream("drop-" + std::to_string(number) + ".csv")
        << dashpad::output::history_csv(solution.history, dashpad::plain_si());
    // A pulse that was cut or bottomed out has no whole pulse, and no figures of one.
    if (!solution.summary.trustworthy() || !dashpad::injury::has_whole_pulse(solution)) continue;

    const dashpad::Pulse pulse = dashpad::injury::pulse_of(solution.history);
    const double peak = dashpad::injury::peak(pulse).magnitude;
    const double rise = first_time_at(pulse, 0.9 * peak) - first_time_at(pulse, 0.1 * peak);
    const double above = dashpad::injury::cumulative_dwell(pulse, 30 * g);
    std::printf("%4d  %.1f g  %6.1f ms  %7.1f ms\n", number, peak / g, 1e3 * rise, 1e3 * above);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
