// How hard is the blow? A headform of 5 kg strikes a helmet pad of 45 mm at 3.048 m/s (10 ft/s).
//
//   first_impact [FOLDER]      FOLDER has the folder materials; by default it is the working folder
//
// Prints the peak and HIC15, each with the 95 % interval by what is not known of foam and model:
//
//   Peak acceleration  38.4 g  (35.7 to 41.2 g)
//   HIC15              55.1    (49.6 to 62.3)

#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/uncertainty/intervals.hpp"

int main(int count, char** arguments) try {
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";

  // The case, in SI units. The foam is a card; your_own_foam.cpp gives one in code.
  dashpad::ImpactCase impact;
  impact.title = "Headform on a helmet pad";
  impact.impactor = {.mass = 5, .nose = dashpad::Sphere{0.075}, .speed = 3.048};  // kg, m, m/s
  impact.pad.thickness = 0.045;                                                   // m
  impact.pad.material = dashpad::input::read_material(folder / "materials/team-wendy-hard-pu.toml").value();
  impact.pad.neighbours = dashpad::nominal_neighbours(impact.pad);  // 0 without this line
  impact.support = dashpad::Support::rigid();

  const dashpad::Options options;
  dashpad::Solution solution = dashpad::solve(impact, options);
  dashpad::uncertainty::add_intervals(impact, options, solution);  // some more impacts

  // What is doubtful about the result. Here: nothing.
  for (const dashpad::Flag& flag : dashpad::flags(solution.summary)) std::printf("%s\n", flag.text.c_str());

  // No figures without a whole pulse, as when the pad bottoms out on a rigid support.
  const std::optional<dashpad::injury::InjuryFigures> figures =
      dashpad::injury::whole_pulse_figures(solution);
  if (!solution.summary.trustworthy() || !figures || !solution.summary.intervals) {
    std::printf("no result: %s\n", dashpad::to_string(solution.summary.status).c_str());
    return 1;
  }
  constexpr double g = dashpad::standard_gravity;
  std::printf("Peak acceleration  %.1f g", figures->peak.magnitude / g);
  if (const auto* const peak = solution.summary.intervals->find("peak_acceleration"))
    std::printf("  (%.1f to %.1f g)", peak->low / g, peak->high / g);
  std::printf("\nHIC15              %.1f  ", figures->hic15.value);
  if (const auto* const hic15 = solution.summary.intervals->find("hic15"))
    std::printf("  (%.1f to %.1f)", hic15->low, hic15->high);
  std::printf("\n");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
