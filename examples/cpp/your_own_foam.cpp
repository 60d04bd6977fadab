// How thick must a pad of your own foam be? The foam is known by the points of a slow and a fast compression
// test.
//
// A headform of 4.5 kg falls on it from 1 m; the peak is to stay below 100 g. Prints the thickness from which
// it does, with the interval by what the tests leave open, and reservations, of which there are none here:
//
//   Passes from 31.8 mm (95 % interval 29.7 to 34.5 mm)

#include <cstdio>
#include <exception>

#include "dashpad/injury/standard.hpp"
#include "dashpad/margin/margin.hpp"

namespace {

/// A foam by its curves, stress over strain. The numbers are made up.
dashpad::Material foam() {
  dashpad::FoamCurves curves;
  curves.slowest_rate = 0.01;  // 1/s, of the base curve
  curves.base = dashpad::TableCurve{.strain = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7},
                                    .stress = {66e3, 124e3, 169e3, 199e3, 216e3, 243e3, 295e3, 399e3, 633e3}};
  const dashpad::TableCurve fast{.strain = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6},
                                 .stress = {203e3, 277e3, 326e3, 354e3, 399e3, 484e3, 654e3}};  // Pa
  curves.rate_effect = dashpad::CurvesRateEffect{.curves = {{.rate = 200, .curve = fast}}};
  dashpad::Material material;
  material.name = dashpad::foam_of_the_case;
  // On the way back 35 % of the stress are left when the foam is nearly unloaded.
  material.law = dashpad::Foam{.unloading_factor = 0.35, .curves = curves, .unloading_curve = {}};
  return material;
}

}  // namespace

int main() try {
  dashpad::ImpactCase impact;
  impact.impactor = {.mass = 4.5, .nose = dashpad::Sphere{0.08}};  // kg, m
  impact.impactor.speed = dashpad::injury::speed_after_fall(1.0);  // m
  impact.pad.thickness = 0.025;                                    // m; the search begins around it
  impact.pad.material = foam();
  impact.pad.neighbours = dashpad::nominal_neighbours(impact.pad);

  dashpad::margin::Question question;
  question.impacts = {{.impact = impact,
                       .limits = {{.figure = &dashpad::result_quantity("peak_acceleration"),
                                   .value = 100 * dashpad::standard_gravity,
                                   .title = "Peak acceleration"}}}};
  question.key = "pad.thickness";
  question.unit = "m";
  dashpad::margin::choose_range(question);  // a quarter to four times the thickness of the case
  for (const dashpad::Violation& broken : dashpad::margin::violations(question)) {
    std::fprintf(stderr, "%s: %s\n", broken.key.c_str(), broken.rule.c_str());
    return 2;
  }

  const dashpad::margin::Answer answer = dashpad::margin::solve_for(question);
  for (const dashpad::margin::Turn& turn : answer.turns) {  // all of them in the range; here one
    std::printf("Passes %s %.1f mm", turn.passes_above ? "from" : "up to", 1e3 * turn.value);
    if (turn.interval)
      std::printf(" (95 %% interval %.1f to %.1f mm)", 1e3 * turn.interval->first,
                  1e3 * turn.interval->second);
    std::printf("\n");
  }
  for (const dashpad::Flag& flag : answer.reservations) std::printf("%s\n", flag.text.c_str());
  return answer.turns.empty() ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
