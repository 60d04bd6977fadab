// A law that is none of the list goes through columns and solver by its own file alone.

#include <gtest/gtest.h>

#include "impact/march.hpp"
#include "model/contact/column_field.hpp"
#include "power_maxwell.hpp"
#include "shared/run_once.hpp"
#include "shared/samples.hpp"

namespace dashpad::scalar {

#define DASHPAD_FORMULAS
#include "power_maxwell.hpp"
#undef DASHPAD_FORMULAS

namespace {
#include "model/contact/sweep_columns.hpp"
}  // namespace

}  // namespace dashpad::scalar

namespace dashpad::test {
namespace {

constexpr double resolution = 0.02;

Figures run_with(const PowerMaxwell& law, const ImpactCase& impact) {
  ColumnField<PowerMaxwell> field(law, impact.pad.thickness, sections_of(impact.impactor.nose),
                                  ColumnMath::plain, scalar::sweep_of<double, PowerMaxwell>());
  Track track;
  const Options options;
  March march(impact, field, options);
  return march.run(resolution, track);
}

/// With m = 1, n = 0 and a relaxation that takes far longer than the impact it is a spring: law 1.
TEST(new_law, slow_to_forget_is_elastic) {
  for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
    const ImpactCase impact = impact_on(Elastic{3e5}, support);
    const Figures expected = run_once(impact, resolution).figures;
    const Figures found = run_with({3e5, 1, 0, 1e9}, impact);
    expect_relative(found.peak_force, expected.peak_force, 1e-3, "peak force");
    expect_relative(found.peak_penetration, expected.peak_penetration, 1e-3, "penetration");
    expect_relative(found.release.value().velocity, expected.release.value().velocity, 1e-3, "rebound");
  }
}

/// It has no unloading rule, and loads as law 4 without a rate stress does.
TEST(new_law, loads_as_the_nine_parameter_law_without_a_rate_stress) {
  NineParameter law = sample_law<NineParameter>();
  law.rate_modulus = 0;
  const ImpactCase impact = impact_on(law);
  const Figures expected = run_once(impact, resolution).figures;
  const Figures found = run_with(
      {law.asymptotic_modulus, law.contact_exponent, law.compaction_exponent, law.relaxation_time}, impact);
  expect_relative(found.peak_force, expected.peak_force, 1e-3, "peak force");
  expect_relative(found.peak_penetration, expected.peak_penetration, 1e-3, "penetration");
}

TEST(new_law, has_its_slope_from_its_formula) {
  const PowerMaxwell law{2e5, 0.7, 1.1, 5e-3};
  const PowerShape power(law.exponents());
  const double strain = 0.4, width = 1e-5;
  const auto envelope_of = [&](double e) { return envelope(law, power, strain_of(e), {}, e); };
  expect_relative(envelope_slope(law, power, strain_of(strain), {}, strain),
                  (envelope_of(strain + width) - envelope_of(strain - width)) / (2 * width), 1e-8, "slope");
}

}  // namespace
}  // namespace dashpad::test
