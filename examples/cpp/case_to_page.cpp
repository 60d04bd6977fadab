// Does a helmet pad keep to EN 1078? The case is a file; the answer is also a page for those who ask why.
//
//   case_to_page [FOLDER]      FOLDER has examples, materials and standards; by default the working folder
//
// Writes helmet-pad.html and helmet-pad.svg. Prints the verdict, the limit with what the pad makes of it, and
// the reservations:
//
//   EN 1078, bicycle helmets: pass, with reservations
//   Peak acceleration 94.7 g, at most 250 g
//   EXTRAPOLATED STRAIN
//   NO INTERVAL
//   UNVERIFIED
//   SECONDARY SOURCE

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/uncertainty/intervals.hpp"

int main(int count, char** arguments) try {
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";
  namespace injury = dashpad::injury;
  namespace output = dashpad::output;

  // All faults of the file, as values; value(), as below, throws them.
  const auto read =
      dashpad::input::read_case(folder / "examples/helmet-pad-10fps.toml", folder / "materials");
  for (const dashpad::input::Fault& fault : read.faults())
    std::fprintf(stderr, "%s\n", to_string(fault).c_str());
  if (!read) return 2;
  const injury::Standard standard = dashpad::input::read_standard(folder / "standards/en-1078.toml").value();

  // The standard has its own headform and speed.
  const dashpad::ImpactCase impact = injury::with_impactor_of(standard, read->impact);
  dashpad::Solution solution = dashpad::solve(impact, read->options);
  dashpad::uncertainty::add_intervals(impact, read->options, solution, injury::dwell_levels(standard));
  const injury::Assessment assessment = injury::assess(standard, impact, solution);

  const dashpad::UnitSystem& units = dashpad::unit_system("si");
  std::printf("%s: %s\n", standard.title.c_str(), injury::to_string(assessment).c_str());
  for (const injury::CriterionResult& result : assessment.results) {
    const auto [scale, unit] = dashpad::scaled_unit(result.criterion.quantity->si_unit, units);
    if (result.value)
      std::printf("%s %.1f %s, at most %.0f %s\n", injury::title_of(result.criterion).c_str(),
                  *result.value * scale, unit.c_str(), result.criterion.limit * scale, unit.c_str());
  }
  for (const dashpad::Flag& reservation : assessment.reservations)
    std::printf("%s\n", reservation.name.c_str());  // its text says more

  const output::AssessmentReport report{standard, read->impact, impact, solution, assessment};
  std::ofstream("helmet-pad.html") << output::to_html(
      output::assessment_document(report, units, output::Pictures::drawn));
  std::ofstream("helmet-pad.svg") << output::impact_drawing(impact, solution, units,
                                                            output::PictureFormat::svg);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
