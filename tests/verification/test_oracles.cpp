/// The oracles themselves, before anything is compared with them: at the start, in motion, by substitution
/// into their equations, and against the reference solutions of data/reference-cases.csv.

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "dashpad/model/pad/law.hpp"
#include "model/pad/column_law.hpp"
#include "oracle/any_impact.hpp"
#include "oracle/closed_forms.hpp"
#include "oracle/column_history.hpp"
#include "oracle/contact_grid.hpp"
#include "oracle/cvode_impact.hpp"
#include "oracle/law_formulas.hpp"
#include "oracle/reference_cases.hpp"
#include "oracle/speed_root.hpp"

namespace dashpad::oracle {
namespace {

const std::filesystem::path reference_file =
    std::filesystem::path(DASHPAD_SOURCE_DIR) / "data/reference-cases.csv";

const LinearViscoelastic zener{140e3, 420e3, 5e-3};

/// Central difference, step relative to x.
template <class Function>
double slope_of(const Function& f, double x, double step = 1e-4) {
  const double h = step * x;
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

void expect_relative(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(value, expected, tolerance * std::fabs(expected)) << what;
}

// --- The law formulas of the oracles, against the library's laws (two independent writings)
// -------------------

template <class Formulas, class Law>
void compare_envelopes(const Law& law) {
  constexpr double rounding = 1e-11;  // of the difference quotient
  const Formulas formulas(law);
  for (const double strain : {1e-6, 1e-3, 0.1, 0.5, 0.9, 0.99})
    for (const double rate : {-300.0, -10.0, -1e-3, 1e-3, 1.0, 40.0, 500.0})
      for (const double factor : {1.0, 1.3, 2.5}) {
        const double largest = std::fmin(factor * strain, 0.995);
        const StrainPoint point = strain_point(strain, 1 - strain, formulas.m(), formulas.n());
        const auto column = formulas.at_strain(point);
        const auto terms = formulas.at_rate(rate);
        const Envelope ours = formulas.envelope(point, column, terms, largest);
        const PowerShape power(law.exponents());
        const double library = dashpad::envelope(law, power, strain_of(strain), law.rate_part(rate), largest);
        const std::string where = " e " + std::to_string(strain) + " rate " + std::to_string(rate);
        EXPECT_NEAR(ours.value, library, 1e-11 * (std::fabs(library) + point.shape * 1e5)) << where;
        const auto value_at = [&](double e) {
          const StrainPoint near = strain_point(e, 1 - e, formulas.m(), formulas.n());
          return formulas.envelope(near, formulas.at_strain(near), terms, largest).value;
        };
        EXPECT_NEAR(ours.slope, slope_of(value_at, strain),
                    1e-7 * (std::fabs(ours.slope) + 1e5) + rounding * std::fabs(ours.value) / strain)
            << where;
        expect_relative(formulas.relaxation(0.01, strain), dashpad::relaxation_rate(law, power, 0.01, strain),
                        1e-13, where);
      }
}

TEST(OracleFormulas, AgreeWithTheLibrarysLawsAndWithTheirOwnSlopes) {
  compare_envelopes<LinearFormulas>(zener);
  compare_envelopes<NineFormulas>(ensolite_nine());
  compare_envelopes<TwentyOneFormulas>(ensolite_twenty_one());
}

template <class Formulas, class Law>
void compare_splitting(const Law& law) {
  const Formulas formulas(law);
  for (const double strain : {1e-4, 0.2, 0.95})
    for (const double rate : {0.1, 200.0}) {
      const StrainPoint point = strain_point(strain, 1 - strain, formulas.m(), formulas.n());
      const auto column = formulas.at_strain(point);
      const auto terms = formulas.at_rate(rate);
      const double h = formulas.relaxation(0.003, strain);
      const double q = 7e4;
      const Envelope envelope = formulas.envelope(point, column, terms, strain);
      const double whole = formulas.envelope_rate(envelope, terms) + h * (envelope.value - q * point.shape);
      const double split = point.shape * (formulas.edge(terms) * point.log_slope * rate +
                                          formulas.regular(point, column, terms, q, h));
      expect_relative(split, whole, 1e-12, std::to_string(strain));
    }
}

TEST(OracleFormulas, SplitTheirStressRateIntoSingularAndRegularPart) {
  compare_splitting<LinearFormulas>(zener);
  compare_splitting<NineFormulas>(ensolite_nine());
  compare_splitting<TwentyOneFormulas>(ensolite_twenty_one());
}

// --- Closed forms
// -------------------------------------------------------------------------------------------

TEST(ElasticBounce, ForceIsItsContactIntegralAndEnergyItsWork) {
  const double radius = 0.05, modulus = 3e5, thickness = 0.2;
  const ElasticBounce bounce(2, radius, 3, modulus, thickness);
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;
  for (const double deep : {0.01, 0.05, 0.09}) {  // below, at and above the radius
    const double stress_sum = Quadrature::integrate(
        [&](double s) { return (deep - s) / thickness * (radius - s); }, 0.0, std::fmin(deep, radius));
    expect_relative(bounce.force(deep), 2 * std::numbers::pi * modulus * stress_sum, 1e-13, "force");
    expect_relative(slope_of([&](double y) { return bounce.energy(y); }, deep), bounce.force(deep), 1e-8,
                    "work");
  }
  EXPECT_EQ(bounce.force(0), 0);
  EXPECT_EQ(bounce.energy(0), 0);
  expect_relative(bounce.energy(bounce.peak_penetration()), 9, 1e-14, "impact energy");
}

TEST(ElasticBounce, OfAHugeSphereTakesTheTimeOfAQuadraticSpring) {
  // F = pi E R Y^2/L up to Y/R: T = 2 (Ymax/V) integral of dx/sqrt(1 - x^3) = 2.804365... Ymax/V.
  const ElasticBounce bounce(1, 1e6, 2, 1, 1);
  const double integral = std::sqrt(std::numbers::pi) * std::tgamma(1 / 3.0) / (3 * std::tgamma(5 / 6.0));
  expect_relative(bounce.contact_time(), 2 * integral * bounce.peak_penetration() / 2, 1e-8, "time");
  expect_relative(bounce.peak_penetration(), std::cbrt(3 * 2 / (std::numbers::pi * 1e6)), 1e-8, "depth");
}

TEST(LinearColumn, StartsAtRestAndSolvesItsEquation) {
  const double rate = 30;
  EXPECT_EQ(linear_column_at_constant_rate(zener, rate, 0), 0);
  EXPECT_EQ(linear_column_after_step(zener, 0.2, 0), 0.2 * zener.initial_modulus);
  const double h = 1 / zener.relaxation_time;
  for (const double time : {1e-4, 3e-3, 2e-2}) {
    const auto stress = [&](double t) { return linear_column_at_constant_rate(zener, rate, t); };
    expect_relative(
        slope_of(stress, time),
        zener.initial_modulus * rate + h * (zener.asymptotic_modulus * rate * time - stress(time)), 1e-9,
        "constant rate");
    const auto step = [&](double t) { return linear_column_after_step(zener, 0.2, t); };
    EXPECT_NEAR(slope_of(step, time), h * (0.2 * zener.asymptotic_modulus - step(time)), 1e-8 * h * step(0))
        << "step";
  }
}

TEST(NineColumn, FromRestIsItsEnvelopeAndOtherwiseRelaxesTowardsIt) {
  const NineParameter law = ensolite_nine();
  const NineFormulas formulas(law);
  const double rate = 80;
  const auto rates = formulas.at_rate(rate);
  const auto envelope = [&](double strain) {
    return formulas.envelope(strain_point(strain, 1 - strain, formulas.m(), formulas.n()), {}, rates, 0);
  };
  EXPECT_EQ(nine_column_at_constant_rate(law, {}, rate, 0), 0);
  expect_relative(nine_column_at_constant_rate(law, {}, rate, 5e-3), envelope(0.4).value, 1e-13, "from rest");
  const ColumnStart start{2e4, 0.1, 3e-3};
  EXPECT_EQ(nine_column_at_constant_rate(law, start, rate, start.time), start.stress);
  for (const double time : {3.5e-3, 8e-3, 12e-3}) {
    const auto stress = [&](double t) { return nine_column_at_constant_rate(law, start, rate, t); };
    const Envelope g = envelope(start.strain + rate * (time - start.time));
    expect_relative(slope_of(stress, time), g.slope * rate + (g.value - stress(time)) / law.relaxation_time,
                    1e-7, "substituted");
  }
}

TEST(TwentyOneColumn, SolvesItsEquationFromAnyStart) {
  const TwentyOneParameter law = ensolite_twenty_one();
  const TwentyOneFormulas formulas(law);
  const double rate = 80;
  const auto rates = formulas.at_rate(rate);
  EXPECT_EQ(twenty_one_column_at_constant_rate(law, {}, rate, 0), 0);
  const ColumnStart start{2e4, 0.1, 3e-3};
  EXPECT_EQ(twenty_one_column_at_constant_rate(law, start, rate, start.time), start.stress);
  for (const double time : {3.5e-3, 8e-3, 12e-3}) {
    const auto stress = [&](double t) { return twenty_one_column_at_constant_rate(law, start, rate, t); };
    const double strain = start.strain + rate * (time - start.time);
    const StrainPoint point = strain_point(strain, 1 - strain, formulas.m(), formulas.n());
    const Envelope g = formulas.envelope(point, formulas.at_strain(point), rates, 0);
    expect_relative(slope_of(stress, time),
                    g.slope * rate + formulas.relaxation(time, strain) * (g.value - stress(time)), 1e-7,
                    "substituted");
  }
}

TEST(ColumnHistory, AgreesWithTheClosedFormsAtConstantRate) {
  const double rate = 60;
  const StrainHistory ramp{[&](double t) { return rate * t; }, [&](double) { return rate; }, 1, 2e-3};
  const double time = 9e-3;
  expect_relative(column_stress(zener, ramp, time), linear_column_at_constant_rate(zener, rate, time), 1e-11,
                  "2");
  expect_relative(column_stress(ensolite_nine(), ramp, time),
                  nine_column_at_constant_rate(ensolite_nine(), {}, rate, time), 1e-11, "4");
  expect_relative(column_stress(ensolite_twenty_one(), ramp, time),
                  twenty_one_column_at_constant_rate(ensolite_twenty_one(), {0, 0, 2e-3}, rate, time + 2e-3),
                  1e-10, "5");
}

template <class Formulas, class Law>
void substitute_history(const Law& law) {
  const Formulas formulas(law);
  const double frequency = 200, largest = 0.8;
  const double turning = std::numbers::pi / (2 * frequency);
  const StrainHistory wave{[=](double t) { return largest * std::sin(frequency * t); },
                           [=](double t) { return largest * frequency * std::cos(frequency * t); }, turning,
                           1e-3};
  for (const double time : {1e-4, 3e-3, 6e-3, 9e-3, 1.1e-2}) {  // loading and, from 7.85 ms, unloading
    const auto stress = [&](double t) { return column_stress(law, wave, t); };
    const StrainPoint point =
        strain_point(wave.strain(time), 1 - wave.strain(time), formulas.m(), formulas.n());
    const auto rates = formulas.at_rate(wave.rate(time));
    const Envelope g = formulas.envelope(point, formulas.at_strain(point), rates, largest);
    const double expected = formulas.envelope_rate(g, rates) +
                            formulas.relaxation(wave.touched + time, point.strain) * (g.value - stress(time));
    expect_relative(slope_of(stress, time, 1e-3), expected, 1e-6, "t = " + std::to_string(time));
  }
}

TEST(ColumnHistory, SolvesTheLawsEquationOnLoadingAndUnloading) {
  substitute_history<LinearFormulas>(zener);
  substitute_history<NineFormulas>(ensolite_nine());
  substitute_history<TwentyOneFormulas>(ensolite_twenty_one());
}

// --- The parts of the CVODE oracle
// ------------------------------------------------------------------------------

TEST(ChebyshevGrid, IntegratesAndDifferentiatesWhatAContactNeeds) {
  const ChebyshevGrid grid(40, {0.02, 4});
  double near_bottom = 0, edge = 0;
  const double gap = 5e-3;
  std::vector<double> values;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    near_bottom += grid.weights[i] / (gap + grid.points[i].share);
    edge += grid.weights[i] * std::pow(grid.points[i].rest, 0.675);
    values.push_back(std::exp(grid.points[i].share));
  }
  expect_relative(near_bottom, std::log1p(1 / gap), 1e-6, "1/(gap + x)");
  expect_relative(edge, 1 / 1.675, 1e-9, "(1 - x)^0.675");
  for (const std::size_t i : {0U, 10U, 30U}) {
    double slope = 0;
    for (std::size_t j = 0; j < values.size(); ++j)
      slope += grid.differentiate[i * values.size() + j] * values[j];
    expect_relative(slope, values[i], 1e-8, "d/dx exp(x)");
  }
  for (const double rest : {0.9, 0.5, 1e-3})
    expect_relative(grid.interpolate(values, grid_coordinate(rest, grid.grading)), std::exp(1 - rest), 1e-9,
                    "exp");
}

/// Integral of max(g, 0) over [0, 1] with a disc and a ring, g = cos(3 pi x) + 0.3 - x/2.
double positive_integral(int count) {
  PositiveParts parts(count);
  std::vector<double> g;
  for (int i = 0; i < count; ++i) {
    const double x = i / (count - 1.0);
    g.push_back(std::cos(3 * std::numbers::pi * x) + 0.3 - x / 2);
  }
  parts.find(g.data(), std::vector<char>(g.size(), 1));
  EXPECT_EQ(parts.runs(), 2);
  double sum = 0;
  for (std::size_t i = 0; i < g.size(); ++i) sum += parts.weights()[i] * g[i] / (count - 1.0);
  return sum;
}

TEST(PositiveParts, ConvergeWithOrderFourOverADiscAndARing) {
  const double best = positive_integral(6401);
  const double coarse = std::fabs(positive_integral(51) - best);
  const double fine = std::fabs(positive_integral(201) - best);
  const double order = std::log2(coarse / fine) / 2;
  EXPECT_GT(order, 3.2) << coarse << " " << fine;
  EXPECT_LT(order, 5.5) << coarse << " " << fine;
  EXPECT_LT(fine, 1e-7);
}

TEST(SpeedRoot, FollowsARootOverManyDecadesAndSaysWhenThereIsNone) {
  SpeedRoot root(std::log(3.0));
  for (const double force : {1.0, 0.1, 1e-3, 1e-6, 1e-12, 0.5}) {
    const double found = root.find([&](double x) { return std::exp(0.166 * x) + std::exp(x) - force; });
    expect_relative(std::exp(0.166 * found) + std::exp(found), force, 1e-11, std::to_string(force));
  }
  EXPECT_LE(root.find([](double x) { return std::exp(x) + 1e-3; }), log_of_no_speed);
}

// --- The CVODE oracle
// -------------------------------------------------------------------------------------------

struct Tolerances {
  double figure;        ///< forces, lengths, speeds
  double time;          ///< of peak force and of the weight event
  double release_time;  ///< the last, tiny ring of contact decides it
};

void expect_reference(const CvodeImpact& oracle, const ReferenceCase& reference, Tolerances tolerances) {
  ASSERT_EQ(oracle.ending, Ending::released);
  expect_relative(oracle.peak_force, reference.peak_force, tolerances.figure, "peak force");
  expect_relative(oracle.time_of_peak_force, reference.time_of_peak_force, tolerances.time, "its time");
  expect_relative(oracle.peak_motion, reference.peak_motion, tolerances.figure, "peak motion");
  expect_relative(oracle.peak_penetration, reference.peak_penetration, tolerances.figure, "peak penetration");
  expect_relative(oracle.weight.value().velocity, reference.weight.velocity, tolerances.figure,
                  "weight speed");
  expect_relative(oracle.weight.value().time, reference.weight.time, tolerances.time, "weight time");
  expect_relative(oracle.release.value().velocity, reference.release.velocity, tolerances.figure,
                  "release speed");
  expect_relative(oracle.release.value().time, reference.release.time, tolerances.release_time,
                  "release time");
  expect_relative(oracle.contact_end.value().velocity, reference.contact_end.velocity, tolerances.figure,
                  "contact end speed");
  expect_relative(oracle.contact_end.value().time, reference.contact_end.time, tolerances.time,
                  "contact end time");
  EXPECT_NEAR(oracle.energy_absorbed, reference.energy_loss, 2 * tolerances.figure) << "energy loss";
}

class CvodeReference : public testing::TestWithParam<const char*> {};

TEST_P(CvodeReference, IsReachedByTheDefaults) {
  const ReferenceCase reference = reference_case(reference_file, GetParam());
  CvodeOptions options;
  options.gravity = reference_gravity;
  expect_reference(solve_with_cvode(reference.impact, options), reference, {2e-6, 4e-6, 4e-5});
}

TEST_P(CvodeReference, IsReachedWithFewColumnsToOneInTenThousand) {
  const ReferenceCase reference = reference_case(reference_file, GetParam());
  CvodeOptions options;
  options.gravity = reference_gravity;
  options.loading_columns = 24;
  options.unloading_columns = 120;
  options.rtol = 1e-7;
  options.atol = 1;
  expect_reference(solve_with_cvode(reference.impact, options), reference, {1e-4, 1e-4, 1e-3});
}

INSTANTIATE_TEST_SUITE_P(Cases, CvodeReference, testing::Values("c1", "c2", "c3", "c7"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(CvodeOracle, MeetsTheBottomOfAPadOnARigidSupport) {
  // Case c6 of the same file, given there in words.
  ImpactCase impact;
  impact.impactor = {6.79840198938, Sphere{3.25 * 0.0254}, 6.72084};
  impact.pad.thickness = 1.5 * 0.0254;
  impact.pad.material.law = ensolite_nine();
  CvodeOptions options;
  options.axis_grading = 1e-5;
  const CvodeImpact oracle = solve_with_cvode(impact, options);
  ASSERT_EQ(oracle.ending, Ending::bottomed_out);
  expect_relative(oracle.bottomed.value().time, 5.930705e-3, 1e-6, "time");
  expect_relative(oracle.bottomed.value().velocity, 198.8148 * 0.0254, 1e-5, "velocity");
}

TEST(CvodeOracle, AgreesWithTheEnergyIntegralOfAnElasticPad) {
  for (const double speed : {0.5, 3.0}) {  // shallow, and deeper than the radius
    ImpactCase impact;
    impact.impactor = {2, Sphere{0.05}, speed};
    impact.pad.thickness = 0.5;
    impact.pad.material.law = Elastic{3e5};
    const ElasticBounce bounce(2, 0.05, speed, 3e5, 0.5);
    EXPECT_EQ(bounce.peak_penetration() > 0.05, speed > 1);
    const CvodeImpact oracle = solve_with_cvode(impact);
    ASSERT_EQ(oracle.ending, Ending::released);
    expect_relative(oracle.peak_force, bounce.peak_force(), 1e-7, "peak force");
    expect_relative(oracle.peak_penetration, bounce.peak_penetration(), 1e-7, "depth");
    expect_relative(oracle.release.value().time, bounce.contact_time(), 1e-7, "contact time");
    expect_relative(oracle.release.value().velocity, -speed, 1e-7, "no energy lost");
  }
}

TEST(CvodeOracle, OfALinearPadThatHardlyRelaxesIsThatOfAnElasticOne) {
  ImpactCase impact;
  impact.impactor = {4, Sphere{0.08}, 2};
  impact.pad.thickness = 0.06;
  impact.support = Support::linear(2e5);
  impact.pad.material.law = LinearViscoelastic{3e5, 3e5 * (1 + 1e-9), 5e-3};
  const CvodeImpact columns = solve_with_cvode(impact);
  impact.pad.material.law = Elastic{3e5};
  const CvodeImpact elastic = solve_with_cvode(impact);
  ASSERT_EQ(columns.ending, Ending::released);
  expect_relative(columns.peak_force, elastic.peak_force, 1e-6, "peak force");
  expect_relative(columns.release.value().velocity, elastic.release.value().velocity, 1e-6, "release speed");
  expect_relative(columns.release.value().time, elastic.release.value().time, 1e-6, "release time");
}

TEST(CvodeOracle, IsNotChangedByASupportCornerWithoutChangeOfSlope) {
  ReferenceCase reference = reference_case(reference_file, "c1");
  const CvodeImpact straight = solve_with_cvode(reference.impact);
  const double stiffness =
      reference.impact.support.points().front().force / reference.impact.support.points().front().deflection;
  reference.impact.support = Support::through({{0.02, 0.02 * stiffness}, {0.05, 0.05 * stiffness}});
  const CvodeImpact cornered = solve_with_cvode(reference.impact);
  ASSERT_EQ(cornered.ending, Ending::released);
  expect_relative(cornered.peak_force, straight.peak_force, 1e-7, "peak force");
  expect_relative(cornered.release.value().velocity, straight.release.value().velocity, 1e-6,
                  "release speed");
}

TEST(CvodeOracle, KeepsPadAndSupportInEquilibrium) {
  const CvodeImpact oracle = solve_with_cvode(reference_case(reference_file, "c3").impact);
  EXPECT_LT(oracle.drift, 1e-5);
  EXPECT_LT(oracle.turning_speed, -0.01);  // the finite jump
}

// --- The general oracle
// -----------------------------------------------------------------------------------------

TEST(AnyOracle, FollowsLawsFourAndFiveOnASpringToTheReference) {
  for (const char* id : {"c1", "c2", "c3"}) {
    const ReferenceCase reference = reference_case(reference_file, id);
    const AnyImpact oracle = solve_any(reference.impact);
    ASSERT_EQ(oracle.ending, AnyImpact::Ending::released) << id;
    expect_relative(oracle.peak_force, reference.peak_force, 1e-5, id);
    expect_relative(oracle.peak_motion, reference.peak_motion, 1e-5, id);
    expect_relative(oracle.peak_penetration, reference.peak_penetration, 1e-5, id);
    expect_relative(oracle.rebound_speed, -reference.release.velocity, 2e-5, id);
    expect_relative(oracle.contact_end.value().time, reference.contact_end.time, 2e-5, id);
  }
}

TEST(AnyOracle, OfElasticLayersIsThatOfOneLayerBelowAnyNose) {
  for (const Nose& nose : {Nose{Sphere{0.05}}, Nose{Cone{0.05, 0.9, 0.01}}}) {
    ImpactCase impact;
    impact.impactor = {2, nose, 2};
    impact.pad.thickness = 0.06;
    impact.support = Support::linear(5e5);
    for (const auto& [thickness, modulus] : {std::pair{0.02, 2e5}, std::pair{0.04, 8e5}}) {
      PadLayer layer;
      layer.thickness = thickness;
      layer.material.law = Elastic{modulus};
      impact.pad.layers.push_back(layer);
    }
    const AnyImpact layers = solve_any(impact);
    impact.pad.layers.clear();
    impact.pad.material.law = Elastic{0.06 / (0.02 / 2e5 + 0.04 / 8e5)};
    const AnyImpact one = solve_any(impact);
    ASSERT_EQ(layers.ending, AnyImpact::Ending::released);
    ASSERT_EQ(one.ending, AnyImpact::Ending::released);
    expect_relative(layers.peak_force, one.peak_force, 1e-5, "peak force");
    expect_relative(layers.peak_penetration, one.peak_penetration, 1e-5, "peak penetration");
    // On the way back the edge of the contact lies between two columns.
    expect_relative(layers.rebound_speed, one.rebound_speed, 1e-4, "rebound speed");
    expect_relative(layers.contact_end.value().time, one.contact_end.value().time, 2e-4, "end of contact");
  }
}

TEST(Compare, GivesRelativeDifferencesOfWhatBothHave) {
  Summary summary;
  summary.peak_force = 101;
  summary.peak_motion = 2;
  CvodeImpact oracle;
  oracle.ending = Ending::released;
  oracle.peak_force = 100;
  oracle.peak_motion = 2;
  oracle.peak_penetration = 1;
  summary.peak_penetration = 1;
  const Differences differences = compare(summary, oracle);
  EXPECT_NEAR(differences.peak_force.value(), 0.01, 1e-12);
  EXPECT_FALSE(differences.release_time);
  EXPECT_NEAR(differences.largest(), 0.01, 1e-12);
  EXPECT_NE(differences.text().find("peak force 1.00e-02"), std::string::npos);
}

}  // namespace
}  // namespace dashpad::oracle
