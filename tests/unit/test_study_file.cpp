/// Study files: what is read from a good one, and what is said about bad ones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "dashpad/study/responses.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"
#include "sample_case.hpp"

namespace dashpad::study {
namespace {

using test::edited;

const std::string good_study = R"(title = "A study"
case = "case.toml"
samples = 100
sampling = "latin-hypercube"
seed = 7
tolerance = 1e-4
responses = ["peak_force", "hic15"]
[factors."impactor.speed"]
values = ["10 mph", "20 mph"]
[factors."pad.thickness"]
distribution = "normal"
mean = "1 in"
deviation = "0.1 in"
lowest = "0.5 in"
[factors."support.stiffness"]
distribution = "lognormal"
median = "600 lbf/in"
spread = 0.1
[[correlations]]
between = ["pad.thickness", "support.stiffness"]
value = 0.4
)";

/// In place of the card of the case.
const std::string foam_in_line = R"(law = "foam"
[pad.curve]
form = "avalle"
rate = "0.01 1/s"
plateau_stress = "100 kPa"
modulus = "2 MPa"
plateau_exponent = 1
densification_stress = "40 kPa"
densification_exponent = 2
highest_strain = 0.8
[pad.rate]
form = "power"
exponent = 0.1
exponent_slope = 0
highest_rate = "1000 1/s")";

/// A grid of one factor, whose lines these are.
std::string grid_of(const std::string& key, const std::string& lines) {
  return "case = \"case.toml\"\n[factors.\"" + key + "\"]\n" + lines + "\n";
}

class StudyFile : public ::testing::Test {
 protected:
  Study read(const std::string& text) {
    folder_.write("case.toml", case_);
    return read_study(folder_.write("study.toml", text), test::materials, test::source / "standards").value();
  }
  std::vector<input::Fault> faults_in(const std::string& text) {
    try {
      read(text);
    } catch (const input::InputError& error) {
      return error.faults();
    }
    return {};
  }
  /// One fault, with this line, key and part of the rule.
  void expect_fault(const std::string& text, int line, const std::string& key, const std::string& rule) {
    const auto faults = faults_in(text);
    ASSERT_EQ(faults.size(), 1u) << input::InputError(faults).what() << text;
    EXPECT_EQ(faults[0].line, line) << to_string(faults[0]);
    EXPECT_EQ(faults[0].key, key) << to_string(faults[0]);
    EXPECT_NE(faults[0].rule.find(rule), std::string::npos) << to_string(faults[0]);
  }
  std::vector<double> levels_of(const std::string& key, const std::string& lines) {
    return std::get<Levels>(read(grid_of(key, lines)).factors.at(0).spread).values;
  }

  std::string case_ = test::good_case;
  test::TemporaryFolder folder_;
};

TEST_F(StudyFile, is_read) {
  const Study study = read(good_study);
  EXPECT_EQ(study.title, "A study");
  EXPECT_EQ(study.text, good_study);
  EXPECT_EQ(study.base.title, "A case");
  EXPECT_EQ(study.samples, 100u);
  EXPECT_EQ(study.sampling, Sampling::latin_hypercube);
  EXPECT_EQ(study.seed, 7u);
  EXPECT_EQ(study.options.tolerance, 1e-4);
  EXPECT_EQ(study.options.time_limit, 0.2);
  EXPECT_FALSE(study.indices);
  EXPECT_EQ(study.responses, (std::vector<std::string>{"peak_force", "hic15"}));
  ASSERT_EQ(study.factors.size(), 3u);
  EXPECT_EQ(study.factors[0].key, "impactor.speed");
  EXPECT_EQ(study.factors[0].unit, "m/s");
  EXPECT_DOUBLE_EQ(std::get<Levels>(study.factors[0].spread).values.at(1), 8.9408);
  EXPECT_DOUBLE_EQ(std::get<Normal>(study.factors[1].spread).mean, 0.0254);
  EXPECT_DOUBLE_EQ(std::get<Normal>(study.factors[1].spread).deviation, 0.00254);
  EXPECT_DOUBLE_EQ(*study.factors[1].lowest, 0.0127);
  EXPECT_FALSE(study.factors[1].highest);
  EXPECT_NEAR(std::get<Lognormal>(study.factors[2].spread).median, 105076.1, 0.1);
  ASSERT_EQ(study.correlations.size(), 1u);
  EXPECT_EQ(study.correlations[0].first, 1u);
  EXPECT_EQ(study.correlations[0].second, 2u);
  EXPECT_EQ(study.correlations[0].value, 0.4);
  EXPECT_EQ(Design(study).rows(), 200u);
}

TEST_F(StudyFile, has_defaults) {
  const Study study = read(grid_of("impactor.speed", "values = [\"1 m/s\"]"));
  EXPECT_EQ(study.samples, 1u);
  EXPECT_EQ(study.sampling, Sampling::sobol);
  EXPECT_EQ(study.seed, 1u);
  EXPECT_EQ(study.options.tolerance, 1e-3);
  EXPECT_EQ(study.responses, default_responses());
}

TEST_F(StudyFile, keys_need_no_quotes) {
  const Study study = read(
      "case = \"case.toml\"\n[factors.impactor]\nspeed = { values = [\"1 m/s\"] }\n"
      "[factors.pad.parameters.rate_exponent]\nvalues = [0.1, 0.2]\n");
  ASSERT_EQ(study.factors.size(), 2u);
  EXPECT_EQ(study.factors[0].key, "impactor.speed");
  EXPECT_EQ(study.factors[1].key, "pad.parameters.rate_exponent");
}

TEST_F(StudyFile, has_ranges) {
  EXPECT_EQ(levels_of("impactor.speed", "from = \"1 m/s\"\nto = \"2 m/s\"\ncount = 3"),
            (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(levels_of("impactor.speed", "from = \"4 m/s\"\nto = \"1 m/s\"\ncount = 2"),
            (std::vector{4., 1.}));
  const auto logarithmic =
      levels_of("support.scale", "from = 0.1\nto = 10\ncount = 5\nspacing = \"logarithmic\"");
  ASSERT_EQ(logarithmic.size(), 5u);
  EXPECT_EQ(logarithmic.front(), 0.1);
  EXPECT_NEAR(logarithmic[1], std::pow(10, -0.5), 1e-15);
  EXPECT_NEAR(logarithmic[2], 1, 1e-15);
  EXPECT_EQ(logarithmic.back(), 10);
}

TEST_F(StudyFile, varies_the_numbers_of_curves) {
  case_ = edited(case_, "material = \"ensolite-aac-9\"", foam_in_line);
  const Study study = read(R"(case = "case.toml"
responses = ["peak_force"]
[factors."pad.curve.plateau_stress"]
values = ["100 kPa", "0.2 MPa"]
[factors.pad.rate.exponent]
values = [0, 0.1]
)");
  ASSERT_EQ(study.factors.size(), 2u);
  EXPECT_EQ(study.factors[0].unit, "Pa");
  EXPECT_EQ(std::get<Levels>(study.factors[0].spread).values, (std::vector<double>{1e5, 2e5}));
  EXPECT_EQ(study.factors[1].key, "pad.rate.exponent");
  const Design design(study);
  Worker worker(study, design);
  for (std::uint64_t row = 0; row < 4; ++row) {
    Foam expected = std::get<Foam>(study.base.pad.material.law);
    std::get<AvalleCurve>(expected.curves.base).plateau_stress = row < 2 ? 1e5 : 2e5;
    std::get<PowerRateEffect>(expected.curves.rate_effect).exponent = row % 2 == 0 ? 0 : 0.1;
    EXPECT_EQ(std::get<Foam>(worker.case_of(row).pad.material.law), expected) << row;
  }
  const auto rows = worker.compute(0, 4);
  for (const std::size_t row : {0U, 1U, 2U})
    EXPECT_NE(rows[row].outcome.values.at(0), rows[row + 1].outcome.values.at(0)) << row;
}

TEST_F(StudyFile, takes_a_weight_for_a_mass) {
  const Study study = read(grid_of("impactor.weight", "values = [\"9.80665 N\"]"));
  ImpactCase impact = study.base;
  Application{study}(std::vector{9.80665}, impact);
  EXPECT_DOUBLE_EQ(impact.impactor.mass, 1);
}

TEST_F(StudyFile, chooses_materials_by_name_and_by_file) {
  folder_.write(
      "mine.toml",
      "title = \"Mine\"\nsource = \"a test\"\nlaw = \"elastic\"\n[parameters]\nmodulus = \"1 MPa\"\n");
  const Study study = read(grid_of("pad.material", "values = [\"ensolite-aac-21\", \"mine.toml\"]"));
  ASSERT_EQ(study.materials.size(), 2u);
  ImpactCase impact = study.base;
  Application{study}(std::vector{1.}, impact);
  EXPECT_EQ(std::get<Elastic>(impact.pad.material.law).modulus, 1e6);
  Application{study}(std::vector{0.}, impact);
  EXPECT_EQ(impact.pad.material.name, "ensolite-aac-21");
}

TEST_F(StudyFile, reads_measured_values) {
  const std::string measured = R"(case = "case.toml"
samples = 10
[factors."impactor.speed"]
distribution = "empirical"
file = "speeds.csv"
)";
  const auto values = [&](const std::string& csv, const std::string& column = "") {
    folder_.write("speeds.csv", csv);
    return std::get<Empirical>(read(measured + column).factors.at(0).spread).values;
  };
  EXPECT_EQ(values("speed [m/s]\n3\n1\n2\n"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(values("# measured\nspeed [km/h]\r\n3.6\r\n7.2\r\n"), (std::vector<double>{1, 2}));
  EXPECT_EQ(values("test;speed [m/s]\n1;2,5\n2;1,5\n", "column = \"speed\"\n"), (std::vector{1.5, 2.5}));
  const auto expect_csv_fault = [&](const std::string& csv, int line, const std::string& rule) {
    folder_.write("speeds.csv", csv);
    const auto faults = faults_in(measured);
    ASSERT_EQ(faults.size(), 2u) << csv;
    EXPECT_EQ(faults[0].line, 5);
    EXPECT_EQ(faults[1].line, line);
    EXPECT_NE(faults[1].rule.find(rule), std::string::npos) << to_string(faults[1]);
  };
  expect_csv_fault("speed\n1\n2\n", 1, "unit");
  expect_csv_fault("speed [kg]\n1\n2\n", 1, "");
  expect_csv_fault("1\n2\n3\n", 1, "names the column");
  expect_csv_fault("speed [m/s]\n1\nfast\n", 3, "");
  expect_csv_fault("speed [m/s]\n1\nnan\n", 3, "");
  expect_csv_fault("a,speed [m/s]\n1,2\n3,4\n", 1, "several columns");
  expect_csv_fault("", 0, "empty");
}

TEST_F(StudyFile, reports_all_faults_at_once) {
  const auto faults = faults_in(R"(case = "case.toml"
samples = 10.5
sampling = "sobel"
tolerance = 1
responses = ["peak_farce", 3]
indices = 1
[factors."impactor.sped"]
values = ["10 mph"]
[factors."impactor.radius"]
distribution = "normal"
mean = "3 kg"
deviation = "1 in"
[factors."pad.thickness"]
distribution = "uniform"
low = "2 in"
high = "1 in"
colour = "red"
[[correlations]]
between = ["pad.thickness", "pad.thikness"]
value = 2
)");
  std::vector<std::pair<int, std::string>> found;
  for (const input::Fault& fault : faults) found.emplace_back(fault.line, fault.key);
  const std::vector<std::pair<int, std::string>> expected{{2, "samples"},
                                                          {3, "sampling"},
                                                          {4, "tolerance"},
                                                          {5, "responses[2]"},
                                                          {5, "responses[1]"},
                                                          {6, "indices"},
                                                          {7, "factors.impactor.sped"},
                                                          {11, "factors.impactor.radius.mean"},
                                                          {13, "factors.pad.thickness"},
                                                          {17, "factors.pad.thickness.colour"},
                                                          {19, "correlations[1].between[2]"}};
  EXPECT_EQ(found, expected) << input::InputError(faults).what();
}

TEST_F(StudyFile, names_what_was_meant) {
  expect_fault(grid_of("impactor.sped", "values = [\"1 m/s\"]"), 2, "factors.impactor.sped",
               "did you mean \"impactor.speed\"?");
  expect_fault(grid_of("pad.parameters.relaxation_tim", "values = [\"1 s\"]"), 2,
               "factors.pad.parameters.relaxation_tim", "did you mean \"pad.parameters.relaxation_time\"?");
  expect_fault("responses = [\"hic16\"]\n" + grid_of("impactor.speed", "values = [\"1 m/s\"]"), 1,
               "responses[1]", "did you mean \"hic15\"?");
}

TEST_F(StudyFile, refuses_bad_levels) {
  const std::string key = "factors.impactor.speed";
  const auto expect = [&](const std::string& lines, int line, const std::string& end,
                          const std::string& rule) {
    expect_fault(grid_of("impactor.speed", lines), line, key + end, rule);
  };
  expect("values = []", 3, ".values", "one value");
  expect("values = [\"1 kg\"]", 3, ".values[1]", "");
  expect("values = [\"1 m/s\", 2]", 3, ".values[2]", "unit");
  expect("values = [\"nan m/s\"]", 3, ".values[1]", "");
  expect("values = [\"1 m/s\"]\nlowest = \"1 m/s\"", 2, "", "only to a distribution");
  expect("values = [\"1 m/s\"]\ncount = 2", 2, ".values", "give one of");
  expect("from = \"1 m/s\"\nto = \"2 m/s\"\ncount = 1", 5, ".count", "from 2 to");
  expect("from = \"1 m/s\"\nto = \"2 m/s\"\ncount = 2.5", 5, ".count", "whole");
  expect("from = \"1 m/s\"\nto = \"1 m/s\"\ncount = 2", 4, ".to", "differ");
  expect("from = \"0 m/s\"\nto = \"1 m/s\"\ncount = 2\nspacing = \"logarithmic\"", 6, ".spacing",
         "more than 0");
  expect_fault(grid_of("pad.parameters.rate_exponent", "values = [nan]"), 3,
               "factors.pad.parameters.rate_exponent.values[1]", "finite");
}

TEST_F(StudyFile, refuses_bad_distributions) {
  const auto expect = [&](const std::string& lines, const std::string& rule) {
    expect_fault("samples = 5\n" + grid_of("impactor.speed", lines), 3, "factors.impactor.speed", rule);
  };
  expect("distribution = \"normal\"\nmean = \"5 m/s\"\ndeviation = \"0 m/s\"",
         "deviation must be more than 0");
  expect("distribution = \"normal\"\nmean = \"5 m/s\"\ndeviation = \"-1 m/s\"",
         "deviation must be more than 0");
  expect("distribution = \"lognormal\"\nmedian = \"0 m/s\"\nspread = 1", "median must be more than 0");
  expect("distribution = \"lognormal\"\nmedian = \"5 m/s\"\nspread = 0", "spread must be more than 0");
  expect("distribution = \"uniform\"\nlow = \"5 m/s\"\nhigh = \"5 m/s\"", "low must be less than high");
  expect("distribution = \"triangular\"\nlow = \"1 m/s\"\nmode = \"6 m/s\"\nhigh = \"5 m/s\"", "mode");
  const std::string normal = "distribution = \"normal\"\nmean = \"20 m/s\"\ndeviation = \"1 m/s\"\n";
  expect(normal + "lowest = \"22 m/s\"\nhighest = \"21 m/s\"", "lowest must be less than highest");
  expect(normal + "lowest = \"26 m/s\"", "leave a probability");
}

TEST_F(StudyFile, refuses_levels_and_ends_that_make_no_case) {
  expect_fault(grid_of("impactor.speed", "values = [\"1 m/s\", \"0 m/s\"]"), 2, "factors.impactor.speed",
               "impactor.speed = 0: must be more than 0");
  expect_fault(grid_of("support.scale", "values = [1, -1]"), 2, "factors.support.scale", "");
  expect_fault(grid_of("pad.parameters.contact_exponent", "values = [0.5, 1.5]"), 2,
               "factors.pad.parameters.contact_exponent", "at most 1");
  const std::string normal =
      "samples = 5\n" +
      grid_of("impactor.speed", "distribution = \"normal\"\nmean = \"5 m/s\"\ndeviation = \"1 m/s\"");
  expect_fault(normal, 3, "factors.impactor.speed",
               "6 standard deviations below the centre; use lowest to cut it off");
  EXPECT_NO_THROW(read(normal + "lowest = \"1 m/s\"\n"));
  expect_fault("samples = 5\n" + grid_of("impactor.speed",
                                         "distribution = \"uniform\"\nlow = \"-1 m/s\"\nhigh = \"5 m/s\""),
               3, "factors.impactor.speed", "(at the lower end)");
}

/// Of a rule between several numbers that one is named which stands in the same table.
TEST_F(StudyFile, refuses_numbers_that_make_no_curve) {
  case_ = edited(case_, "material = \"ensolite-aac-9\"", foam_in_line);
  expect_fault(grid_of("pad.curve.densification_exponent", "values = [2, 30]"), 2,
               "factors.pad.curve.densification_exponent",
               "pad.curve.densification_exponent = 30: must be at least 0.5 and at most 20");
  expect_fault(grid_of("pad.curve.modulus", "values = [\"100 kg\"]"), 3,
               "factors.pad.curve.modulus.values[1]", "");
  expect_fault(grid_of("pad.rate.highest_rate", "values = [\"1e-3 1/s\"]"), 2,
               "factors.pad.rate.highest_rate", "more than the previous rate");
  expect_fault(R"(case = "case.toml"
[factors."pad.parameters.friction"]
values = [0.1]
[factors."pad.rate.exponent"]
values = [0.1]
[factors."pad.curve.densification_stress"]
values = ["0 Pa"]
)",
               6, "factors.pad.curve.densification_stress", "pad.curve.highest_strain = 0.8: the curve must");
  case_ = edited(case_, "[pad.curve]",
                 "[pad.unloading]\nstress_unit = \"kPa\"\nstrain = [0.2, 0.5, 0.8]\nstress = [50, 60, 70]\n"
                 "[pad.curve]");
  expect_fault(grid_of("pad.curve.plateau_stress", "values = [\"20 kPa\"]"), 2,
               "factors.pad.curve.plateau_stress",
               "pad.unloading.stress[1] = 50000: must be at most the loading stress");
}

TEST_F(StudyFile, refuses_bad_sizes) {
  const std::string thousand = "from = 1\nto = 2\ncount = 1000000\n";
  expect_fault("case = \"case.toml\"\n[factors.\"support.scale\"]\n" + thousand +
                   "[factors.\"pad.parameters.rate_exponent\"]\nfrom = 0.1\nto = 0.2\ncount = 1000000\n",
               2, "factors", "1e+12 rows");
  expect_fault(edited(good_study, "samples = 100", "samples = 1000000000000"), 3, "samples",
               "from 1 to 1000000000");
  expect_fault(edited(good_study, "samples = 100", "samples = 1000000000"), 3, "samples", "2e+09 rows");
  expect_fault(edited(good_study, "seed = 7", "seed = -1"), 5, "seed", "whole number");
  expect_fault(edited(good_study, "samples = 100", "samples = 0"), 3, "samples", "whole number");
  expect_fault(edited(good_study, "samples = 100\n", ""), 0, "samples", "is missing");
  expect_fault("samples = 5\n" + grid_of("impactor.speed", "values = [\"1 m/s\"]"), 1, "samples",
               "no factor");
  expect_fault("case = \"case.toml\"\n", 0, "factors", "is missing");
  expect_fault("case = \"case.toml\"\n[factors]\n", 2, "factors", "at least one factor");
}

TEST_F(StudyFile, refuses_bad_correlations) {
  expect_fault(edited(good_study, "value = 0.4", "value = 1"), 19, "correlations[1]", "less than 1");
  expect_fault(edited(good_study, "\"pad.thickness\", \"support", "\"impactor.speed\", \"support"), 19,
               "correlations[1]", "distribution");
  expect_fault(
      edited(good_study, "\"pad.thickness\", \"support.stiffness\"", "\"pad.thickness\", \"pad.thickness\""),
      19, "correlations[1]", "different");
  expect_fault(edited(good_study, "seed = 7", "indices = true"), 19, "correlations", "independent");
  expect_fault(edited(edited(good_study, "[[correlations]]", R"([factors."impactor.radius"]
distribution = "uniform"
low = "2 in"
high = "4 in"
[[correlations]]
between = ["pad.thickness", "impactor.radius"]
value = 0.9
[[correlations]]
between = ["support.stiffness", "impactor.radius"]
value = -0.9
[[correlations]])"),
                      "value = 0.4", "value = 0.9"),
               23, "correlations", "positive definite");
}

/// Each entry of these lists is compared with all others: a list that is far too long has one fault, at once.
TEST_F(StudyFile, refuses_endless_lists) {
  std::string names, materials, correlations;
  for (int i = 0; i < 5000; ++i) {
    names += fmt::format("\"r{}\", ", i);
    materials += "\"elastic\", ";
    correlations += "[[correlations]]\nbetween = [\"impactor.speed\", \"impactor.speed\"]\nvalue = 0.1\n";
  }
  const std::string values = "values = [\"1 m/s\"]";
  expect_fault("responses = [" + names + "]\n" + grid_of("impactor.speed", values), 1, "responses",
               "contains 5000 names, but there are only ");
  expect_fault(grid_of("pad.material", "values = [" + materials + "]"), 3, "factors.pad.material.values",
               "must have between 1 and 1000 materials");
  expect_fault(grid_of("impactor.speed", values + "\n" + correlations), 4, "correlations",
               "there are 5000 correlations, but fewer pairs of factors");
}

TEST_F(StudyFile, refuses_factors_that_contradict) {
  const auto two = [](const std::string& first, const std::string& second) {
    return "case = \"case.toml\"\n" + first + second;
  };
  const std::string mass = "[factors.\"impactor.mass\"]\nvalues = [\"1 kg\"]\n";
  const std::string weight = "[factors.\"impactor.weight\"]\nvalues = [\"1 N\"]\n";
  const std::string material = "[factors.\"pad.material\"]\nvalues = [\"ensolite-aac-9\"]\n";
  const std::string exponent = "[factors.\"pad.parameters.rate_exponent\"]\nvalues = [0.1]\n";
  const std::string stiffness = "[factors.\"support.stiffness\"]\nvalues = [\"1 kN/m\"]\n";
  const std::string scale = "[factors.\"support.scale\"]\nvalues = [2]\n";
  expect_fault(two(mass, weight), 4, "factors.impactor.weight", "not both");
  expect_fault(two(exponent, material), 4, "factors.pad.material", "not both");
  case_ = edited(case_, "material = \"ensolite-aac-9\"", foam_in_line);
  const std::string modulus = "[factors.\"pad.curve.modulus\"]\nvalues = [\"1 MPa\"]\n";
  expect_fault(two(modulus, material), 4, "factors.pad.material", "not both");
  expect_fault(two(stiffness, scale), 4, "factors.support.scale", "not both");
  expect_fault(two(mass, "[factors.impactor.mass]\nvalues = [\"1 kg\"]\n"), 2, "factors.impactor.mass",
               "twice");
}

TEST_F(StudyFile, refuses_what_the_case_has_not) {
  case_ = edited(case_, "type = \"linear\"\nstiffness = \"600 lbf/in\"", "type = \"rigid\"");
  expect_fault(grid_of("support.stiffness", "values = [\"1 kN/m\"]"), 2, "factors.support.stiffness",
               "rigid");
  case_ = edited(case_, "type = \"rigid\"",
                 "type = \"curve\"\npoints = [[\"1 mm\", \"1 kN\"], [\"2 mm\", \"3 kN\"]]");
  expect_fault(grid_of("support.stiffness", "values = [\"1 kN/m\"]"), 2, "factors.support.stiffness",
               "support.scale");
  EXPECT_NO_THROW(read(grid_of("support.scale", "values = [2]")));
}

TEST_F(StudyFile, says_which_curves_the_pad_has) {
  const std::string key = "factors.pad.curve.contact_exponent", rate_key = "factors.pad.rate.exponents";
  const std::string curve = grid_of("pad.curve.contact_exponent", "values = [0.5]");
  const std::string rate = grid_of("pad.rate.exponents", "values = [0.1]");
  expect_fault(curve, 2, key,
               "the law of the pad, nine-parameter, is not defined by curves; available: "
               "pad.parameters.asymptotic_modulus, pad.parameters.contact_exponent, ");
  case_ = edited(case_, "material = \"ensolite-aac-9\"", foam_in_line);
  expect_fault(curve, 2, key,
               "the curve of the pad has the form avalle; available: pad.curve.plateau_stress, "
               "pad.curve.modulus, pad.curve.plateau_exponent, pad.curve.densification_stress, "
               "pad.curve.densification_exponent, pad.curve.highest_strain");
  expect_fault(rate, 2, rate_key,
               "the rate effect of the pad has the form power; available: pad.rate.exponent, "
               "pad.rate.exponent_slope, pad.rate.highest_rate");
  case_ = edited(test::good_case, "ensolite-aac-9", "ff-leap");
  expect_fault(curve, 2, key, "the curve of the pad has the form table, which has no numbers that can vary");
  expect_fault(rate, 2, rate_key,
               "the rate effect of the pad has the form none, which has no numbers that can vary");
  expect_fault("case = \"case.toml\"\n[factors.pad.curve.modulus]\nvalues = [\"1 MPa\"]\n", 2,
               "factors.pad.curve", "the form table");
}

TEST_F(StudyFile, reports_faults_of_the_case_and_of_cards) {
  case_ = edited(case_, "20 mph", "20");
  const auto faults = faults_in(grid_of("pad.material", "values = [\"ensolite-aac-8\"]"));
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_NE(faults[0].rule.find("did you mean"), std::string::npos);
  EXPECT_EQ(faults[1].key, "impactor.speed");
  // What the case would have is not known.
  for (const char* key : {"pad.parameters.x", "pad.curve.x", "pad.rate.x", "support.x"})
    expect_fault(grid_of(key, "values = [1]"), 5, "impactor.speed", "");
  expect_fault("case = \"case.toml\"\n[factors.pad.curve.x]\nvalues = [1]\n", 5, "impactor.speed", "");
  expect_fault("case = \"none.toml\"\n[factors.\"impactor.speed\"]\nvalues = [\"1 m/s\"]\n", 0, "", "");
}

TEST(study_examples, are_good) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::source / "examples/studies")) {
    if (entry.path().extension() != ".toml") continue;
    ++count;
    EXPECT_NO_THROW(Design(read_study(entry.path(), test::materials, test::source / "standards").value()))
        << entry.path();
  }
  EXPECT_GE(count, 4);
}

}  // namespace
}  // namespace dashpad::study
