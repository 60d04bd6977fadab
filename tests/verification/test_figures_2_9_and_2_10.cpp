/// What the report's section 2.3 says of its preliminary analyses (Eqs. 29 to 31, Figures 2-9 and 2-10), one
/// sentence after the other: largest strain 0.95, rates of 1 and 100 per second, twenty steps up and twenty
/// down. "1984" is subroutine PAD in the arithmetic of the PDP-10; "exact" is the laboratory.
///
/// Not every sentence comes back. Where one does not, the test says what is true instead.

#include <gtest/gtest.h>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/spit1984/run.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double largest_strain = 0.95;
constexpr int steps_each_way = 20;  ///< up, and down
constexpr double psi = 6894.757293168361;

struct Analysis {
  std::vector<double> strain;
  std::vector<double> spit;   ///< 1984, psi, at the ends of the steps
  std::vector<double> exact;  ///< psi, at the same times
  laboratory::CushionFigures figures;
};

PadLaw nine() { return sample_law<NineParameter>(); }
PadLaw twenty_one() { return sample_law<TwentyOneParameter>(); }

Analysis analyse(const PadLaw& law, bool parabolic, double rate) {
  Analysis result;
  for (int k = 0; k <= 2 * steps_each_way; ++k) {
    const double t = k / double(steps_each_way);
    result.strain.push_back(largest_strain * (parabolic ? t * (2 - t) : t < 1 ? t : 2 - t));
  }
  result.strain.back() = 0;
  const double up = largest_strain / rate;
  const auto deck = spit1984::deck_of(impact_on(law, Support::linear(1e5)));
  result.spit = spit1984::column_stresses(deck.pad, deck.pad_parameters, result.strain, up / steps_each_way);
  const laboratory::StrainHistory history = parabolic ? laboratory::parabolic_test(rate, largest_strain)
                                                      : laboratory::constant_rate_test(rate, largest_strain);
  const laboratory::ColumnTest test = laboratory::drive(law, history);
  for (int k = 0; k <= 2 * steps_each_way; ++k) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < test.size(); ++i)
      if (std::abs(test.time[i] - k * up / steps_each_way) <
          std::abs(test.time[nearest] - k * up / steps_each_way))
        nearest = i;
    EXPECT_NEAR(test.time[nearest], k * up / steps_each_way, 1e-9 * up);
    result.exact.push_back(test.stress[nearest] / psi);
  }
  result.figures = laboratory::cushion_figures(test);
  return result;
}

/// "the first calculation of stress during unloading exceeded the last calculation of stress during loading"
bool has_artefact(const std::vector<double>& stress) {
  return stress[steps_each_way + 1] > stress[steps_each_way];
}

/// Said of the constant rate. Not so here: the strain falls by a twentieth in the first step, and PAD takes
/// the slope at its start for all of it. At 100/s it comes out tensile. The exact stress is continuous.
TEST(ConstantRate, FirstUnloadingStepOvershootsIntoTensionInsteadOfRising) {
  for (const PadLaw& law : {nine(), twenty_one()}) {
    const Analysis fast = analyse(law, false, 100);
    EXPECT_GT(fast.spit[steps_each_way], 0);
    EXPECT_LT(fast.spit[steps_each_way + 1], 0);
    for (const double rate : {1.0, 100.0}) {
      const laboratory::ColumnTest test =
          laboratory::drive(law, laboratory::constant_rate_test(rate, largest_strain), 100000);
      const double jump = std::abs(test.stress[100001] - test.stress[100000]);
      EXPECT_LT(jump, 1e-3 * test.stress[100000]) << "one place of 100,000 later";
      EXPECT_FALSE(has_artefact(analyse(law, false, rate).exact));
    }
  }
}

/// "Neither model shows evidence of the stress-discontinuity artifact" at 100/s, parabolic: so it is.
TEST(Parabola, ShowsNoArtefactAtOneHundredPerSecond) {
  for (const PadLaw& law : {nine(), twenty_one()}) {
    const Analysis fast = analyse(law, true, 100);
    EXPECT_FALSE(has_artefact(fast.spit));
    EXPECT_FALSE(has_artefact(fast.exact));
    // The peak of 1984 is 11 to 14 % low, for its long steps.
    EXPECT_NEAR(fast.spit[steps_each_way] / fast.exact[steps_each_way], 0.875, 0.02);
  }
}

/// "The artifact does appear for the case of 1 per second in the 9-parameter model, but ... is small": in the
/// exact solution, a rise of 3.5 % at the first place of unloading. The listing's own update cannot have
/// printed it with these steps: 47.5 ms are more than twice the relaxation time of 8.81 ms, so it diverges.
TEST(Parabola, ShowsASmallArtefactAtOnePerSecondInTheNineParameterLaw) {
  const Analysis slow = analyse(nine(), true, 1);
  EXPECT_TRUE(has_artefact(slow.exact));
  EXPECT_NEAR(slow.exact[steps_each_way + 1] / slow.exact[steps_each_way], 1.035, 0.001);
  EXPECT_GT(std::abs(slow.spit[steps_each_way]), 1e9) << "psi";
  const double growth = 0.0475 / 8.81e-3 - 1;  // of an error in a step, by Eq. 16
  EXPECT_NEAR(std::abs(slow.spit[2 * steps_each_way] / slow.spit[2 * steps_each_way - 1]), growth, 0.01);
  EXPECT_FALSE(has_artefact(analyse(twenty_one(), true, 1).exact));
  EXPECT_FALSE(has_artefact(analyse(twenty_one(), true, 1).spit));
}

/// "Both models show an increase of hysteresis as the strain rate increases, but the effect is more
/// pronounced in the 9-parameter model": so it is.
TEST(Parabola, LosesMoreEnergyAtTheHigherRate) {
  const double nine_slow = analyse(nine(), true, 1).figures.hysteresis;
  const double nine_fast = analyse(nine(), true, 100).figures.hysteresis;
  const double other_slow = analyse(twenty_one(), true, 1).figures.hysteresis;
  const double other_fast = analyse(twenty_one(), true, 100).figures.hysteresis;
  EXPECT_NEAR(nine_slow, 0.1740, 1e-4);
  EXPECT_NEAR(nine_fast, 0.3581, 1e-4);
  EXPECT_NEAR(other_slow, 0.1836, 1e-4);
  EXPECT_NEAR(other_fast, 0.3269, 1e-4);
  EXPECT_GT(nine_fast - nine_slow, other_fast - other_slow);
  EXPECT_GT(other_fast, other_slow);
}

/// "the 9-parameter model has a higher stress response to loading and a higher peak stress": the peak is, and
/// the stress at high strain. At low strain it is the other way round.
TEST(Parabola, IsStifferInTheNineParameterLawAtHighStrainOnly) {
  for (const double rate : {1.0, 100.0}) {
    const Analysis one = analyse(nine(), true, rate);
    const Analysis other = analyse(twenty_one(), true, rate);
    EXPECT_GT(one.figures.peak_stress, other.figures.peak_stress);
    for (int k = 1; k < steps_each_way; ++k) {
      const double strain = one.strain[static_cast<std::size_t>(k)];
      const double difference =
          one.exact[static_cast<std::size_t>(k)] - other.exact[static_cast<std::size_t>(k)];
      const double crossing = rate == 1 ? 0.90 : 0.485;
      if (strain > crossing + 0.01) {
        EXPECT_GT(difference, 0) << "rate " << rate << ", strain " << strain;
      } else if (strain < 0.12) {
        EXPECT_LT(difference, 0) << "rate " << rate << ", strain " << strain;
      }
    }
  }
  const double nine_peak = analyse(nine(), true, 100).figures.peak_stress;
  const double other_peak = analyse(twenty_one(), true, 100).figures.peak_stress;
  EXPECT_NEAR(nine_peak / psi, 448.3, 0.1);
  EXPECT_NEAR(other_peak / psi, 299.65, 0.1);
  // At 1/s the 9-parameter stress falls off before the strain turns, and is the lower one there.
  EXPECT_NEAR(analyse(nine(), true, 1).figures.peak_stress / psi, 285.923, 0.02);
  EXPECT_LT(analyse(nine(), true, 1).exact[steps_each_way],
            analyse(twenty_one(), true, 1).exact[steps_each_way]);
}

}  // namespace
}  // namespace dashpad::test
