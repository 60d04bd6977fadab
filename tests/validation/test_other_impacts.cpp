/// Impacts that others measured, as far as what they left out allows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

/// Eight playground surfaces on 0.3 m of wood fibre, second and third drop of a hemispherical head of 4.5 kg
/// from 3 m: peak in g, HIC. US Access Board and USDA Forest Products Laboratory, Laufenberg and Winandy
/// 2003, tables 1 and 4 (a work of the US Government).
struct Drop {
  double peak, hic;
};
constexpr Drop as_new[] = {{52, 244}, {57, 272}, {53, 213}, {62, 251}, {67, 332}, {62, 315},
                           {68, 350}, {63, 357}, {68, 274}, {76, 307}, {55, 236}, {54, 248},
                           {56, 312}, {60, 324}, {65, 325}, {69, 406}};
constexpr Drop after_half_a_year[] = {{72, 275},  {71, 265},  {81, 308},  {79, 320}, {139, 825}, {130, 740},
                                      {109, 564}, {109, 541}, {83, 285},  {81, 306}, {85, 339},  {90, 387},
                                      {83, 313},  {87, 318},  {103, 493}, {101, 472}};

/// What a pulse of this peak is worth: of pulses of one shape and velocity change HIC grows as this power.
double worth(double peak, double hic) { return hic / std::pow(peak, 1.5); }

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Pads of the same depth from foams of all kinds, their stress multiplied by 0.02 to 1000, with peaks as
/// those measured. Each foam has a stress that gives the least peak: softer pads are struck through, stiffer
/// ones hold the head.
struct Computed {
  Range struck_through, held;
};
Computed computed() {
  Computed result;
  for (const char* card : {"vn600", "team-wendy-hard-pu", "plastazote-ld33", "ff-leap", "eps-15"}) {
    ImpactCase impact;
    impact.impactor = {.mass = 4.5, .nose = Sphere{0.08}, .speed = 7.67};  // 0.08 m: a guess
    impact.pad = {0.3, input::read_material(test::material_folder / (std::string(card) + ".toml")).value()};
    std::vector<Drop> drops;
    for (int i = 0; i <= 24; ++i) {
      impact.pad.condition.scale = 0.02 * std::pow(5e4, i / 24.0);
      if (const auto figures = injury::whole_pulse_figures(solve(impact, {.tolerance = 1e-3})))
        drops.push_back({figures->peak.magnitude / standard_gravity, figures->hic_unlimited.value});
    }
    const auto best = std::ranges::min_element(drops, {}, &Drop::peak);
    for (auto drop = drops.begin(); drop != drops.end(); ++drop)
      if (drop->peak >= 50 && drop->peak <= 140)
        (drop < best ? result.struck_through : result.held).add(worth(drop->peak, drop->hic));
  }
  return result;
}

/// Without the surfaces' curves no peak can be predicted. But what HIC goes with a peak is the pulse's shape:
/// new surfaces have that of pads which hold the head, aged ones that of pads which are struck through.
TEST(PlaygroundSeries, PulsesAreThoseOfPadsThatHoldAndOfPadsStruckThrough) {
  const Computed ours = computed();
  EXPECT_NEAR(ours.struck_through.low, 0.36, 0.02);
  EXPECT_NEAR(ours.held.high, 0.87, 0.02);
  std::vector<double> fresh, aged;
  for (const auto& [peak, hic] : as_new) fresh.push_back(worth(peak, hic));
  for (const auto& [peak, hic] : after_half_a_year) aged.push_back(worth(peak, hic));
  for (const auto& worths : {fresh, aged})
    for (const double each : worths) {
      EXPECT_GT(each, ours.struck_through.low);
      EXPECT_LT(each, ours.held.high);
    }
  for (const double each : aged) EXPECT_LT(each, ours.struck_through.high);
  const auto held = std::ranges::count_if(fresh, [&](double each) { return each > ours.held.low; });
  EXPECT_GE(held, 12) << "of 16";
  std::ranges::sort(fresh);
  std::ranges::sort(aged);
  EXPECT_GT(fresh[7], ours.held.low) << "median";
  EXPECT_LT(aged[8], ours.held.low) << "median";
}

/// One impact of a headform on an elastomer pad. Its pulse comes out by two numbers of the pad; it does not
/// tell the radius of the crown, which nobody wrote down: what is known of it is the prior.
TEST(MepPad, PulseIsMetAndDoesNotTellTheRadius) {
  const fit::FitReport report = fit::run_fit(
      fit::read_fit(test::source_folder / "examples/fits/mep-pad.toml", test::material_folder).value().fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  ASSERT_EQ(report.pulses.size(), 1U);
  const fit::MetPulse& pulse = report.pulses.front();
  EXPECT_LT(*pulse.rms, 0.015 * pulse.measured_peak);
  EXPECT_NEAR(*pulse.computed_peak, pulse.measured_peak, 0.015 * pulse.measured_peak);
  const auto radius = std::ranges::find(report.unknowns, "impactor.radius", &fit::FittedUnknown::key);
  ASSERT_NE(radius, report.unknowns.end());
  EXPECT_NEAR(radius->value, 0.075, 0.002);
  EXPECT_NEAR(*radius->standard_error, 0.010, 0.001) << "that of the prior";
}

}  // namespace
}  // namespace dashpad
