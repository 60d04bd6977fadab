// Curves out of compression tests: holds, cycles, single wrong strains, softening, and which file a fault is
// of.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/material_deck.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

class MeasuredCurveTest : public testing::Test {
 protected:
  /// kPa: 330.1 at a strain of 0.7.
  static double stress_at(double e) {
    return 100 * (e + 0.2 * std::tanh(30 * e) + 3 * std::pow(e, 4) / (1 - e));
  }

  /// A test with this stress at strains of 0.01 up to 0.7.
  static std::string table(const std::function<double(double)>& stress = stress_at) {
    std::string text = "strain,stress_kPa\n0,0\n";
    for (int i = 1; i <= 70; ++i) text += row(0.01 * i, stress(0.01 * i));
    return text;
  }
  static std::string row(double strain, double stress) {
    return fmt::format("{:.4f},{:.4f}\n", strain, stress);
  }

  input::DeckMaterial material(const std::vector<std::string>& texts,
                               const std::vector<double>& rates = {0.01}) {
    std::vector<std::filesystem::path> files;
    for (const std::string& text : texts)
      files.push_back(folder_.write(fmt::format("test{}.csv", files.size() + 1), text));
    return input::read_stress_tables(files, {rates}, {}).value();
  }
  static const TableCurve& base_of(const input::DeckMaterial& made) {
    return std::get<TableCurve>(std::get<Foam>(made.material.law).curves.base);
  }

  test::TemporaryFolder folder_;
};

/// A number in (-1, 1) that looks like noise.
double noise_at(int i) { return std::sin(37.0 * i * i) * std::cos(11.0 * i); }

TEST_F(MeasuredCurveTest, AHoldInMidTestIsLeftOutAndToldOf) {
  for (const double noise : {0.0, 0.001}) {
    std::string text = "strain,stress_kPa\n0,0\n";
    for (int i = 1; i <= 70; ++i) {
      text += row(0.01 * i, stress_at(0.01 * i));
      for (int k = 1; i == 30 && k <= 30; ++k)
        text += row(0.3 + noise * noise_at(k), stress_at(0.3) * (1 - 0.3 * (1 - std::exp(-k / 5.0))));
    }
    const input::DeckMaterial made = material({text});
    EXPECT_EQ(base_of(made).strain.size(), 70U) << noise;
    EXPECT_NEAR(base_of(made).stress[29], 1e3 * stress_at(0.3), 1) << noise;
    EXPECT_THAT(made.differences,
                Contains(HasSubstr(
                    "from line 32 to 62, the strain is held and the stress relaxes by 30 %; these points "
                    "were left out, but dashpad fit uses them.")))
        << noise;
  }
}

TEST_F(MeasuredCurveTest, OrdinaryLoadingHasNoHolds) {
  std::string rounded = "strain,stress_kPa\n0,0\n";  // to two digits, with noise
  for (int i = 1; i <= 980; ++i)
    rounded += fmt::format("{:.2f},{:.4f}\n", i / 1400.0, stress_at(i / 1400.0) * (1 + 0.02 * noise_at(i)));
  std::string loop = table();
  for (int i = 69; i >= 0; --i) loop += row(0.01 * i, 0.5 * stress_at(0.01 * i));
  for (const std::string& text : {table(), rounded, loop})
    EXPECT_THAT(material({text}).differences, Each(Not(HasSubstr("is held"))));
}

TEST_F(MeasuredCurveTest, NoisyCyclesToOneStrainGiveTheFirstLoading) {
  std::string text = "strain,stress_kPa\n0,0\n";
  int point = 0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    const double share = cycle == 0 ? 1 : 0.6;
    for (int i = 1; i <= 349; ++i)
      text += row(0.002 * i + 0.002 * noise_at(++point), share * stress_at(0.002 * i));
    for (int i = 349; i >= 1; --i)
      text += row(0.002 * i + 0.002 * noise_at(++point), 0.4 * stress_at(0.002 * i));
  }
  const input::DeckMaterial made = material({text});
  const TableCurve& base = base_of(made);
  EXPECT_NEAR(base.strain.back(), 0.698, 0.003);
  EXPECT_NEAR(base.stress.back(), 1e3 * stress_at(base.strain.back()), 0.03e3 * stress_at(0.698));
  EXPECT_THAT(made.differences, Contains(HasSubstr("the strain reverses on line 351 and rises again")));
  EXPECT_THAT(made.differences, Each(Not(HasSubstr("the stress falls near"))));
}

TEST_F(MeasuredCurveTest, CyclesThatGrowGoOn) {
  std::string text = "strain,stress_kPa\n0,0\n";
  for (const auto& [begin, end] : {std::pair{0, 20}, std::pair{20, 40}, std::pair{40, 70}}) {
    for (int i = 1; i <= end; ++i) text += row(0.01 * i, (i <= begin ? 0.7 : 1) * stress_at(0.01 * i));
    for (int i = end - 1; i >= 0; --i) text += row(0.01 * i, 0.5 * stress_at(0.01 * i));
  }
  const TableCurve base = base_of(material({text}));
  ASSERT_EQ(base.strain.size(), 70U);
  for (std::size_t i = 0; i < base.strain.size(); ++i)
    EXPECT_NEAR(base.stress[i], 1e3 * stress_at(base.strain[i]), 1) << base.strain[i];
}

TEST_F(MeasuredCurveTest, ASingleWrongStrainIsToldOf) {
  std::string text = "strain,stress_kPa\n0,0\n";
  for (int i = 1; i <= 70; ++i) text += row(i == 21 ? 0.95 : 0.01 * i, stress_at(0.01 * i));
  const input::DeckMaterial made = material({text});
  EXPECT_THAT(
      made.differences,
      Contains(HasSubstr("the strain on line 23, 0.95, is far from those beside it, 0.2 and 0.22; if it is "
                         "wrong, remove the line, since all smaller strains behind it were left out.")));
  EXPECT_THAT(made.differences, Each(Not(HasSubstr("rises again"))));
  EXPECT_THAT(material({table()}).differences, Each(Not(HasSubstr("is far from"))));
}

TEST_F(MeasuredCurveTest, AGentleFallIsNoNoise) {
  const auto yielding = [](double e) {
    return stress_at(e) * (1 + 0.5 * std::exp(-std::pow((e - 0.05) / 0.02, 2)));
  };
  EXPECT_THAT(
      material({table(yielding)}).differences,
      AllOf(Contains(HasSubstr("the stress falls near a strain of 0.")), Each(Not(HasSubstr("noise")))));
}

TEST_F(MeasuredCurveTest, AStressAtStrainZeroIsNotCalledNoStress) {
  const input::DeckMaterial made = material({"strain,stress_kPa\n0,15\n0.1,100\n0.3,150\n0.5,345\n"});
  EXPECT_THAT(made.differences,
              AllOf(Contains(HasSubstr("1 point before the first positive strain and stress was left out")),
                    Contains(HasSubstr("begins at 15 kPa, 4.3 % of the largest value"))));
}

TEST_F(MeasuredCurveTest, AFallIsToldOfItsOwnFile) {
  const std::string falling = table([](double e) { return (e < 0.295 ? 1.5 : 0.8) * stress_at(e); });
  try {
    material({table(), falling}, {0.01, 40});
    FAIL();
  } catch (const input::InputError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    const input::Fault& fault = error.faults().front();
    EXPECT_THAT(fault.file, HasSubstr("test2.csv"));
    EXPECT_EQ(fault.line, 32);  // the strain of 0.3
    EXPECT_THAT(fault.rule, AllOf(HasSubstr("the stress falls by 31 % at a strain of 0.3;"),
                                  HasSubstr("the curve of a higher rate may fall by at most 10 %")));
  }
}

}  // namespace
}  // namespace dashpad
