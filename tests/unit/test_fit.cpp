/// Fits: the parts, and what is said about bad fit files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/fit.hpp"
#include "fit/determine.hpp"
#include "shared/temporary_folder.hpp"
#include "unit/sample_case.hpp"

namespace dashpad::fit {
namespace {

using test::edited;
using testing::HasSubstr;

// --- Least squares and profiles, against closed forms ---

/// y = a + b t with unit deviations, a and b from -10 to 10: coordinates in [0, 1].
LeastSquares straight_line(const std::vector<double>& t, const std::vector<double>& y) {
  return {2, t.size(), 1e-4, [t, y](std::span<const double> x, std::span<double> r) {
            for (std::size_t i = 0; i < t.size(); ++i)
              r[i] = -10 + 20 * x[0] + (-10 + 20 * x[1]) * t[i] - y[i];
            return true;
          }};
}

struct LineTest : testing::Test {
  std::vector<double> t{0, 1, 2, 3, 4, 5}, y{1.1, 2.8, 5.3, 6.9, 9.2, 10.9};
  LeastSquares line = straight_line(t, y);
  Minimum minimum = minimise(line, {0.5, 0.5});
  // Mean of t 2.5, sum of squares about it 17.5.
  double slope = [this] {
    double sum = 0;
    for (std::size_t i = 0; i < t.size(); ++i) sum += (t[i] - 2.5) * y[i];
    return sum / 17.5;
  }();
};

TEST_F(LineTest, IsTheOneOfTheNormalEquations) {
  ASSERT_TRUE(minimum.converged);
  EXPECT_NEAR(-10 + 20 * minimum.x[1], slope, 1e-6);
  EXPECT_NEAR(-10 + 20 * minimum.x[0], 36.2 / 6 - slope * 2.5, 1e-6);
}

TEST_F(LineTest, ProfileEndsWhereTheVarianceOfTheSlopeSays) {
  ProfileRequest request;
  request.coordinate = 1;
  request.threshold = 3.84;
  const ProfileEnd end = profile(line, minimum, request);
  ASSERT_TRUE(end.x);
  const double distance = std::sqrt(3.84 / 17.5) / 20;
  EXPECT_NEAR(*end.x - minimum.x[1], distance, 6e-3 * distance);
}

TEST_F(LineTest, ProfileIsOpenWhereTheBoundsComeFirst) {
  ProfileRequest request;
  request.coordinate = 1;
  request.threshold = 1e6;
  EXPECT_FALSE(profile(line, minimum, request).x);
}

/// A mean of values whose errors go together: its variance is that of as many values as they are worth, in
/// the standard error and in the sample alike.
TEST(FindUncertainty, WidensTheSampleAsItDoesTheErrors) {
  constexpr double scale = 1.5;
  std::vector<double> y;
  for (int i = 0; i < 60; ++i) y.push_back(0.5 + std::sin(0.2 * i));
  const LeastSquares mean{1, y.size(), 1e-4, [y](std::span<const double> x, std::span<double> r) {
                            for (std::size_t i = 0; i < y.size(); ++i) r[i] = 10 * (x[0] - y[i]);
                            return true;
                          }};
  Problem problem;
  problem.coordinates.resize(1);
  problem.blocks.resize(1);
  problem.blocks[0].measured = y;
  problem.blocks[0].curve = 0;
  Uncertainty of;
  const std::vector<double> x{0.5};
  ASSERT_TRUE(find_uncertainty(problem, mean, x, scale, of));
  const double worth = of.blocks.at(0).effective_points;
  ASSERT_LT(worth, 10);
  const double variance = scale / (100 * worth);
  EXPECT_NEAR(of.covariance.at(0), variance, 1e-6 * variance);
  EXPECT_NEAR(of.precision.at(0), 1 / variance, 1e-6 / variance);
  double pull = 0;  // half the slope of the misfit, here beside the minimum
  for (const double value : y) pull += 10 * 10 * (0.5 - value);
  ASSERT_GT(std::abs(pull), 100);
  const double gradient = pull * worth / (60 * scale);
  EXPECT_NEAR(of.gradient.at(0), gradient, 1e-6 * std::abs(gradient));
}

TEST(Minimise, StopsAtABound) {
  const LeastSquares beyond = straight_line({0, 1}, {30, 30});
  const Minimum minimum = minimise(beyond, {0.5, 0.5});
  EXPECT_TRUE(minimum.converged);
  EXPECT_DOUBLE_EQ(minimum.x[0], 1);
}

TEST(Autocorrelation, CountsWhatCorrelatedResidualsAreWorth) {
  std::vector<double> wave;
  for (int i = 0; i < 400; ++i) wave.push_back(std::sin(0.1 * i));
  const Autocorrelation autocorrelation = autocorrelation_of(wave);
  EXPECT_NEAR(autocorrelation.rho, std::cos(0.1), 5e-3);
  EXPECT_NEAR(autocorrelation.effective_points, 400 * (1 - autocorrelation.rho) / (1 + autocorrelation.rho),
              1e-9);
  std::vector<double> even;
  for (int i = 0; i < 400; ++i) even.push_back(i % 2 == 0 ? 1 : -1);
  EXPECT_EQ(autocorrelation_of(even).effective_points, 400);
}

TEST(Posterior, IsNormalWithinAndEvenWhereNothingIsKnown) {
  // The first is known to 0.05, of the second nothing.
  const std::vector<double> minimum{0.5, 0.3}, precision{400, 0, 0, 0}, gradient{0, 0};
  const auto draws = laplace_sample(minimum, precision, gradient, 4000, 1);
  double mean = 0, square = 0, second = 0;
  for (const auto& draw : draws) {
    mean += draw[0] / 4000;
    square += (draw[0] - 0.5) * (draw[0] - 0.5) / 4000;
    second += draw[1] / 4000;
    ASSERT_GE(draw[1], 0);
    ASSERT_LE(draw[1], 1);
  }
  EXPECT_NEAR(mean, 0.5, 0.004);
  EXPECT_NEAR(std::sqrt(square), 0.05, 0.003);
  EXPECT_NEAR(second, 0.5, 0.02);
}

TEST(Posterior, IsCutOffAtTheBounds) {
  // At a bound with the misfit rising by a slope: exponential with the mean 1 / 20.
  const auto draws =
      laplace_sample(std::vector<double>{0}, std::vector<double>{0}, std::vector<double>{20}, 4000, 1);
  double mean = 0;
  for (const auto& draw : draws) mean += draw[0] / 4000;
  EXPECT_NEAR(mean, 0.05, 0.004);
}

TEST(Posterior, IsEvenWhereTheMisfitHasNoCurvature) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto draws =
      laplace_sample(std::vector<double>{0.3}, std::vector<double>{none}, std::vector<double>{0}, 4000, 1);
  double mean = 0;
  for (const auto& draw : draws) mean += draw[0] / 4000;
  EXPECT_NEAR(mean, 0.5, 0.02);
}

// --- Along a path ---

TEST(StressAtEnds, IsTheLawOfAnElasticFoamUpAndDown) {
  const PadLaw law = Elastic{.modulus = 1e5};
  const auto history = laboratory::measured_test({0, 1, 3, 4, 7}, {0, 0.2, 0.6, 0.4, 0.1});
  const std::vector<double> stress = laboratory::stress_at_ends(law, history);
  ASSERT_EQ(stress.size(), 4u);
  for (const auto& [i, strain] : {std::pair{0, 0.2}, {1, 0.6}, {2, 0.4}, {3, 0.1}})
    EXPECT_NEAR(stress[static_cast<std::size_t>(i)], 1e5 * strain, 1e-6) << i;
}

TEST(StressAtEnds, IsWhatDriveSaysForEveryKindOfLaw) {
  Foam foam;
  foam.friction = 0.1;
  foam.unloading_factor = 0.4;
  foam.curves.base = HyperfoamCurve{50e3, 8, 0, 1, 0.7};
  foam.curves.slowest_rate = 0.01;
  foam.curves.rate_effect = PowerRateEffect{0.1, 0, 100};
  ViscoelasticFoam slow{20e3, 5, 0, 1, 2, 0.5, 0, 1};
  NineParameter nine{50e3, 0.7, 1.1, 0.01, 30e3, 0.2, 1e-5, 0.1};
  const auto history =
      laboratory::measured_test({0, 0.1, 0.3, 0.5, 0.6, 0.9}, {0, 0.1, 0.5, 0.3, 0.45, 0.05});
  for (const PadLaw& law : {PadLaw(foam), PadLaw(slow), PadLaw(nine), PadLaw(Elastic{1e5})}) {
    const auto ends = laboratory::stress_at_ends(law, history);
    const auto test = laboratory::drive(law, history, 50);
    ASSERT_EQ(ends.size(), 5u);
    double peak = 0;
    for (const double stress : test.stress) peak = std::max(peak, stress);
    double time = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      time += history.pieces[i].duration;
      for (std::size_t k = 0; k < test.size(); ++k)
        if (std::abs(test.time[k] - time) < 1e-12) {
          EXPECT_NEAR(ends[i], test.stress[k], 1e-7 * peak) << name_of(law) << " " << i;
          break;
        }
    }
  }
}

// --- The solver at a fixed resolution ---

struct FixedRunsTest : testing::Test {
  FixedRunsTest() {
    impact.impactor = {5, Sphere{.radius = 0.1}, 3};
    impact.pad.thickness = 0.05;
    Foam foam;
    foam.friction = 0.1;
    foam.unloading_factor = 0.4;
    foam.curves.base = HyperfoamCurve{60e3, 8, 8e3, -1, 0.7};
    foam.curves.slowest_rate = 0.01;
    foam.curves.rate_effect = PowerRateEffect{0.1, 0, 1000};
    impact.pad.material.law = foam;
  }
  ImpactCase impact;
};

TEST_F(FixedRunsTest, AreAsManyAsAskedFor) {
  for (const int runs : {1, 3, 5}) {
    const Summary summary = solve(impact, {.fixed_runs = runs}).summary;
    EXPECT_EQ(summary.runs, runs);
    ASSERT_TRUE(summary.peak_force);
  }
  const double exact = *solve(impact, {.tolerance = 1e-6}).summary.peak_force;
  EXPECT_NEAR(*solve(impact, {.fixed_runs = 3}).summary.peak_force, exact, 2e-3 * exact);
  EXPECT_THROW(solve(impact, {.fixed_runs = 11}), std::invalid_argument);
}

/// The largest second difference of peak force and rebound speed over their values, where a modulus changes
/// by 0.1 % from one impact to the next.
double roughness(ImpactCase impact, int runs) {
  std::vector<double> peak, rebound;
  for (int i = 0; i < 40; ++i) {
    std::get<HyperfoamCurve>(std::get<Foam>(impact.pad.material.law).curves.base).first_modulus =
        60e3 * (1 + 1e-3 * i);
    const Summary summary = solve(impact, {.fixed_runs = runs}).summary;
    peak.push_back(*summary.peak_force);
    rebound.push_back(*summary.rebound_speed);
  }
  double roughest = 0;
  for (const auto* figure : {&peak, &rebound})
    for (std::size_t i = 1; i + 1 < figure->size(); ++i)
      roughest =
          std::max(roughest, std::abs((*figure)[i - 1] - 2 * (*figure)[i] + (*figure)[i + 1]) / (*figure)[i]);
  return roughest;
}

/// Derivatives by differences over a hundredth of the bounds need that. It is the number of steps, which
/// changes, that is seen. On a rigid support the force of a foam with a rate effect has kinks just after the
/// turning, where the rate passes the slowest tested one: where they lie within a step is chance.
TEST_F(FixedRunsTest, MakeFiguresSmooth) {
  ImpactCase on_spring = impact, without_rate = impact;
  on_spring.support = Support::linear(1e5);
  std::get<Foam>(without_rate.pad.material.law).curves.rate_effect = {};
  EXPECT_LT(roughness(on_spring, 3), 2e-4);
  EXPECT_LT(roughness(without_rate, 3), 2e-4);
  EXPECT_LT(roughness(impact, 3), 2e-3);
  EXPECT_LT(roughness(impact, 5), 4e-4);
}

// --- Fit files ---

const std::string good_fit = R"(title = "A foam"
[pad]
law = "foam"
[pad.curve]
form = "power"
rate = "0.01 1/s"
modulus = "100 kPa"
contact_exponent = 0.8
compaction_exponent = 1
highest_strain = 0.7
[pad.rate]
form = "power"
exponent = 0.1
exponent_slope = 0
highest_rate = "100 1/s"
[unknowns]
"pad.curve.modulus" = {bounds = ["1 kPa", "1 MPa"]}
"pad.curve.compaction_exponent" = {bounds = [0, 4]}
[[tests]]
file = "test.csv"
strain_unit = "fraction"
rate = "0.01 1/s"
noise = "2 kPa"
)";

class FitFileTest : public testing::Test {
 protected:
  void SetUp() override {
    // 150 kPa e^0.8 / (1 - e)^1.5 and 3 kPa of a shifted zero.
    std::string csv = "strain,stress_kPa,time_s\n";
    for (int i = 1; i <= 30; ++i) {
      const double e = 0.02 * i;
      csv += std::to_string(e) + "," + std::to_string(150 * std::pow(e, 0.8) * std::pow(1 - e, -1.5) + 3) +
             "," + std::to_string(e / 0.01) + "\n";
    }
    write("test.csv", csv);
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  FitFile read(const std::string& text) {
    write("fit.toml", text);
    return read_fit(folder_.path() / "fit.toml", DASHPAD_SOURCE_DIR "/materials").value();
  }
  std::string faults_of(const std::string& text) {
    try {
      read(text);
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "";
  }

  test::TemporaryFolder folder_;
};

TEST_F(FitFileTest, IsReadWithUnitsAndDefaults) {
  const Fit fit = read(good_fit).fit;
  ASSERT_EQ(fit.unknowns.size(), 2u);
  EXPECT_EQ(fit.unknowns[0].lowest, 1e3);
  EXPECT_EQ(fit.unknowns[0].highest, 1e6);
  EXPECT_EQ(fit.unknowns[0].start, 100e3);
  EXPECT_TRUE(fit.unknowns[0].is_logarithmic);
  EXPECT_FALSE(fit.unknowns[1].is_logarithmic);
  ASSERT_EQ(fit.tests.size(), 1u);
  EXPECT_EQ(*fit.tests[0].noise, 2e3);
  EXPECT_EQ(fit.tests[0].strain.size(), 30u);
  EXPECT_EQ(fit.starts, 8);
}

TEST_F(FitFileTest, FindsTheOffsetOfTheForceZero) {
  const FitReport report = run_fit(read(edited(good_fit, "noise =", "offset = true\nnoise =")).fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  ASSERT_TRUE(report.tests[0].offset);
  EXPECT_NEAR(*report.tests[0].offset, 3e3, 5);
  EXPECT_NEAR(report.unknowns[0].value, 150e3, 50);
  EXPECT_NEAR(report.unknowns[1].value, 1.5, 1e-3);
  EXPECT_TRUE(report.unknowns[2].is_nuisance);
}

/// Of a misfit by more than the noise that was stated only the misfit counts: the same intervals whether a
/// third or a sixth of the true noise was stated.
TEST_F(FitFileTest, NoiseThatWasStatedTooSmallMakesNoIntervalNarrower) {
  std::string csv = "strain,stress_kPa,time_s\n";
  for (int i = 1; i <= 30; ++i) {
    const double e = 0.02 * i, noise = 3 * std::sin(7.0 * i * i);
    csv += std::to_string(e) + "," + std::to_string(150 * std::pow(e, 0.8) * std::pow(1 - e, -1.5) + noise) +
           "," + std::to_string(e / 0.01) + "\n";
  }
  write("test.csv", csv);
  const FitReport third = run_fit(read(edited(good_fit, "\"2 kPa\"", "\"0.7 kPa\"")).fit);
  const FitReport sixth = run_fit(read(edited(good_fit, "\"2 kPa\"", "\"0.35 kPa\"")).fit);
  const FitReport all = run_fit(read(good_fit).fit);
  ASSERT_TRUE(third.converged && sixth.converged && all.converged);
  EXPECT_GT(third.variance_scale, 4);
  EXPECT_NEAR(sixth.variance_scale / third.variance_scale, 4, 0.01);
  for (std::size_t i = 0; i < 2; ++i) {
    const FittedUnknown &a = third.unknowns[i], &b = sixth.unknowns[i];
    EXPECT_NEAR(*b.standard_error / *a.standard_error, 1, 0.01) << a.key;
    EXPECT_NEAR((*b.high - *b.low) / (*a.high - *a.low), 1, 0.03) << a.key;
    EXPECT_NEAR(*all.unknowns[i].standard_error / *a.standard_error, 1, 0.15) << a.key;
  }
}

TEST_F(FitFileTest, MakesACardThatIsReadAgain) {
  const FitReport report = run_fit(read(edited(good_fit, "noise =", "offset = true\nnoise =")).fit);
  write("card.toml", output::card_toml(report.material));
  const Material card = input::read_material(folder_.path() / "card.toml").value();
  EXPECT_THAT(card.source, HasSubstr("test.csv (30 points"));
  EXPECT_THAT(card.reservations, testing::Contains(HasSubstr("loading only")));
  EXPECT_EQ(std::get<Foam>(card.law).curves, std::get<Foam>(report.material.law).curves);
}

TEST_F(FitFileTest, PredictsWhatIsHeldOut) {
  const std::string held_out = good_fit +
                               "[[tests]]\nfile = \"test.csv\"\nstrain_unit = \"fraction\"\n"
                               "rate = \"1 1/s\"\nhold_out = true\n";
  const FitReport report = run_fit(read(held_out).fit);
  ASSERT_EQ(report.tests.size(), 2u);
  EXPECT_TRUE(report.tests[1].is_held_out);
  EXPECT_EQ(report.points, 30u);
  // The rate effect of the starting values: (1 / 0.01)^0.1 = 1.58.
  EXPECT_NEAR(report.tests[1].computed.back() / report.tests[0].computed.back(), std::pow(100, 0.1), 0.01);
  EXPECT_THAT(output::to_terminal(output::fit_document(report, unit_system("si")), output::Detail::main),
              HasSubstr("held out"));
}

TEST_F(FitFileTest, LeavesOpenWhatOneRateCannotTell) {
  // A number of the law that nothing in the data depends on.
  const FitReport report =
      run_fit(read(edited(good_fit, "[[tests]]",
                          "\"pad.parameters.unloading_factor\" = {bounds = [0, 1]}\n[[tests]]"))
                  .fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_EQ(report.unknowns[2].open(), "both");
  EXPECT_FALSE(report.unknowns[2].standard_error);
  EXPECT_EQ(report.flat_directions,
            std::vector<std::vector<std::string>>{{"pad.parameters.unloading_factor"}});
  EXPECT_THAT(output::to_terminal(output::fit_document(report, unit_system("si")), output::Detail::main),
              HasSubstr("is not determined by these data"));
}

TEST_F(FitFileTest, NamesEachFault) {
  struct Row {
    std::string old, fresh, said;
  };
  const std::vector<Row> rows{
      {"strain_unit = \"fraction\"\n", "strain_unit = \"kPa\"\n",
       "give strain_unit fraction, percent or microstrain"},
      {"file = \"test.csv\"", "file = \"nowhere.csv\"", "nowhere.csv"},
      {"rate = \"0.01 1/s\"\nnoise", "noise", "tests[1].rate"},
      {"noise = \"2 kPa\"", "noise = \"2 mm\"", "tests[1].noise"},
      {"noise = \"2 kPa\"", "columns = {strain = \"e\"}", "there is no column for the strain"},
      {"\"pad.curve.modulus\"", "\"pad.curve.plateau_stress\"", "has the form power"},
      {"bounds = [0, 4]", "bounds = [4, 0]", "the lower one first"},
      {"bounds = [0, 4]", "bounds = [0, 9]", "the upper bound, 9, is not allowed"},
      {"bounds = [0, 4]", "bounds = [2, 4]", "must lie within the bounds"},
      {"bounds = [0, 4]", "bounds = [0, 4], prior = {mean = 5, deviation = 1}",
       "its mean, 5, must lie within"},
      {"\"pad.curve.compaction_exponent\" = {bounds = [0, 4]}", "\"pad.rate.exponent\" = {bounds = [0, 0.5]}",
       "all tests have the same strain rate"},
      {"\"pad.curve.compaction_exponent\" = {bounds = [0, 4]}",
       "\"impactor.mass\" = {bounds = [\"1 kg\", \"2 kg\"]}", "needs [[impacts]]"},
      {"law = \"foam\"", "law = \"foamy\"", "did you mean \"foam\""},
      {"noise = \"2 kPa\"", "range = [0.5, 0.51]", "fewer than two points"},
      {"noise = \"2 kPa\"", "hold_out = true", "there are no data to fit"},
      {"[[tests]]", "[fit]\nstarts = 0\n[[tests]]", "fit.starts"},
  };
  for (const Row& row : rows)
    EXPECT_THAT(faults_of(edited(good_fit, row.old, row.fresh)), HasSubstr(row.said)) << row.fresh;
}

TEST_F(FitFileTest, AsksForUnknowns) {
  EXPECT_THAT(
      faults_of(edited(edited(good_fit, "\"pad.curve.modulus\" = {bounds = [\"1 kPa\", \"1 MPa\"]}\n", ""),
                       "\"pad.curve.compaction_exponent\" = {bounds = [0, 4]}\n", "")),
      HasSubstr("a fit needs at least one unknown"));
}

TEST_F(FitFileTest, AsksForAsManyDataAsUnknowns) {
  write("test.csv", "strain,stress_kPa\n0.1,10\n0.3,40\n");
  EXPECT_THAT(
      faults_of(edited(good_fit, "noise =", "offset = true\nnoise =")),
      HasSubstr("the number of measured values and priors, 2, must be at least the number of unknowns, "));
}

TEST_F(FitFileTest, NamesTheLinesOfBadData) {
  const std::string timed = edited(edited(good_fit, "rate = \"0.01 1/s\"\nnoise", "noise"),
                                   "noise =", "columns = {time = \"time\"}\nnoise =");
  EXPECT_EQ(faults_of(timed), "");
  write("test.csv", "strain,stress_kPa,time_s\n0.1,10,1\n0.2,nan,2\n0.3,40,1.5\n");
  const std::string said = faults_of(timed);
  EXPECT_THAT(said, HasSubstr("test.csv:3: stress_kPa"));
  EXPECT_THAT(said, HasSubstr("test.csv:4: time_s"));
  EXPECT_THAT(said, HasSubstr("must be later than the previous time"));
  write("test.csv", "strain,stress_kPa\n10,10\n20,20\n");
  EXPECT_THAT(faults_of(good_fit), HasSubstr("test.csv:2: strain"));
  EXPECT_THAT(faults_of(good_fit), HasSubstr("if it is in per cent"));
  write("test.csv", "strain,load_N\n0.1,10\n0.2,20\n");
  EXPECT_THAT(faults_of(good_fit),
              HasSubstr("for a stress, give the specimen area, such as area \"25 cm2\""));
}

}  // namespace
}  // namespace dashpad::fit
