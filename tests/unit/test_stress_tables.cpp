// Compression tests in tables: columns in many notations, and what becomes of noise, loops, cycles and
// relaxation.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/material_deck.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;

class StressTableTest : public testing::Test {
 protected:
  input::StressStrainTable read(const std::string& text, const input::StressStrainColumns& columns = {}) {
    return input::read_stress_strain_csv(folder_.write("test.csv", text), columns).value();
  }
  input::DeckMaterial material(const std::vector<std::string>& texts,
                               const std::vector<double>& rates = {0.01},
                               const input::StressStrainColumns& columns = {}) {
    std::vector<std::filesystem::path> files;
    for (const std::string& text : texts)
      files.push_back(folder_.write(fmt::format("test{}.txt", files.size() + 1), text));
    return input::read_stress_tables(files, {rates}, columns).value();
  }
  std::string said(auto&& read_it) {
    try {
      read_it();
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "";
  }
  test::TemporaryFolder folder_;
};

const Foam& foam_of(const input::DeckMaterial& made) { return std::get<Foam>(made.material.law); }
const TableCurve& base_of(const input::DeckMaterial& made) {
  return std::get<TableCurve>(foam_of(made).curves.base);
}

TEST_F(StressTableTest, EveryNotationIsTheSameTest) {
  const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
  const char* const in_quotes =
      R"table("Time","Compressive extension","Compressive load"
"(s)","(mm)","(N)"
"0.000","2.5","50"
"1","12.5","100"
)table";
  for (const std::string text :
       {"strain,stress_kPa\n0.1,20\n0.5,40\n", "strain_percent,stress [MPa]\n10,0.02\n50,0.04\n",
        "Dehnung [%];Spannung [kPa]\n10,0;20,0\n50,0;40,0\n",
        "Stauchung;Druckspannung\n%;kPa\n10;20\n50;40\n",
        "d\351formation (%);contrainte (kPa)\n10;20\n50;40\n",
        "deformaci\xc3\xb3n [mm/mm];esfuerzo [kPa]\n0,1;20\n0,5;40\n",
        "stress_kPa,strain\n-20,-0.1\n-40,-0.5\n", "strain,stress_kPa\n0.1,-20\n0.5,-40\n", in_quotes,
        "Weg / mm;Kraft / N\n2,5;50\n12,5;100\n", "Verformung [mm];Standardkraft [kN]\n2,5;0,05\n12,5;0,1\n",
        "No.,Crosshead displacement (mm),Load (N),true strain\n1,2.5,50,0.11\n2,12.5,100,0.7\n"}) {
    SCOPED_TRACE(text);
    ASSERT_EQ(said([&] { read(text, specimen); }), "");
    const input::StressStrainTable table = read(text, specimen);
    EXPECT_THAT(table.strain, Pointwise(DoubleNear(1e-12), {0.1, 0.5}));
    EXPECT_THAT(table.stress, Pointwise(DoubleNear(1e-7), {20e3, 40e3}));
  }
  EXPECT_THAT(read("stress_kPa,strain\n-40,-0.5\n-20,-0.1\n").strain, ElementsAre(0.1, 0.5));
  EXPECT_THAT(read("stress_kPa,strain\n-20,-0.1\n-40,-0.5\n").remarks,
              ElementsAre("strain: compression is negative in the file; its sign was reversed",
                          "stress_kPa: compression is negative in the file; its sign was reversed"));
  EXPECT_THAT(read("a,b,c\n0.1,1,20\n0.5,2,40\n",
                   {.strain = "a", .stress = "c", .strain_unit = "fraction", .stress_unit = "kPa"})
                  .stress,
              ElementsAre(20e3, 40e3));
}

TEST_F(StressTableTest, HeadersOfMachinesAreRead) {
  const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
  for (const std::string text :
       {"Width, Thick,\n50.0, 25.0, 1,\n2500.0,\nLoad (N), Disp (mm), Time,\n50, 2.5, 0,\n75, 7.5, 1,\n100, "
        "12.5, "
        "2,\n",
        "Foam "
        "blocks\nFoam;03.03.2025;7;\n25;1;10\n64;3;196.0;1.4\nZeit;Kraft;Weg\ns;N;mm\n0;50;2.5\n1;75;7.5\n2;"
        "100;12.5\n",
        "#STRESS_UNITS= kPa\n# Strain   Stress(kPa)\n#Loop= 1\n0.1 20\n0.3 30\n0.5 40\n",
        "strain [microstrain],stress_kPa\n100000,20\n300000,30\n500000,40\n",
        "strain (\xce\xbc\xce\xb5),stress_kPa\n100000,20\n300000,30\n500000,40\n",
        "Kraft Sollwert;Kraft;Weg\nN;N;mm\n-1;50;2,5\n-1;75;7,5\n-1;100;12,5\n",
        "Load setpoint,Load,Displacement "
        "command,Displacement,Cycles\nN,N,mm,mm,cycles\n1,50,9,2.5,1\n1,75,9,7.5,1\n1,"
        "100,9,12.5,1\n",
        "Strain (Extension),Stress\n(mm/mm),(kPa)\n0.1,20\n0.3,30\n0.5,40\n",
        "strain,stress_kPa\n0.1,20\n0.3,30\n0.5,40\nEOF\n"}) {
    SCOPED_TRACE(text);
    ASSERT_EQ(said([&] { read(text, specimen); }), "");
    const input::StressStrainTable table = read(text, specimen);
    EXPECT_THAT(table.strain, Pointwise(DoubleNear(1e-12), {0.1, 0.3, 0.5}));
    EXPECT_THAT(table.stress, Pointwise(DoubleNear(1e-7), {20e3, 30e3, 40e3}));
  }
  EXPECT_THAT(read("strain,stress_kPa\n0.1,20\n0.5,40\nEOF\n").remarks,
              ElementsAre("the text on line 4 behind the numbers was left out"));
}

TEST_F(StressTableTest, AForceInGramsIsAWeight) {
  const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
  const std::vector<double> weights{9.80665 / 25e-4, 2 * 9.80665 / 25e-4};
  for (const std::string text :
       {"Force,Distance,Time\ng,mm,sec\n1000,2.5,0\n2000,5,1\n", "Load [kg],Distance [mm]\n1,2.5\n2,5\n",
        "Load (grams),Distance [mm]\n1000,2.5\n2000,5\n"})
    EXPECT_THAT(read(text, specimen).stress, Pointwise(DoubleNear(1e-7), weights)) << text;
  input::StressStrainColumns given = specimen;
  given.stress_unit = "g";
  EXPECT_THAT(read("Force,Distance [mm]\n1000,2.5\n2000,5\n", given).stress,
              Pointwise(DoubleNear(1e-7), weights));
}

TEST_F(StressTableTest, ADisplacementCountsFromWhereItBeginsWithoutForce) {
  const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
  for (const std::string text : {"Displacement (mm),Force (N)\n10,0\n12.5,-50\n17.5,-75\n22.5,-100\n",
                                 "Weg [mm];Kraft [N]\n80;0\n77,5;50\n72,5;75\n67,5;100\n"}) {
    const input::StressStrainTable table = read(text, specimen);
    EXPECT_THAT(table.strain, Pointwise(DoubleNear(1e-12), {0.0, 0.1, 0.3, 0.5})) << text;
    EXPECT_THAT(table.remarks, Contains(HasSubstr(" without force and was counted from there"))) << text;
  }
  const input::StressStrainTable loaded =
      read("disp_mm,force_N\n5.25,2\n7.5,50\n12.5,75\n17.5,100\n", specimen);
  EXPECT_THAT(loaded.strain, Pointwise(DoubleNear(1e-12), {0.21, 0.3, 0.5, 0.7}));
  EXPECT_THAT(loaded.remarks,
              ElementsAre("disp_mm: begins at 5.25 mm with 2 % of the largest force and was counted "
                          "from 0; if the specimen is uncompressed there, subtract 5.25 mm from the "
                          "displacements"));
  EXPECT_THAT(read("disp_mm,force_N\n0.5,20\n7.5,50\n12.5,75\n17.5,100\n", specimen).remarks, IsEmpty());
}

/// A displacement over 20 mm that meets the foam 3 mm behind its beginning.
std::string approach(double begin, double noise) {
  std::string text = "disp_mm,force_N\n";
  for (int i = 0; i <= 80; ++i) {
    const double travel = 0.25 * (i - 12);
    const double force = travel > 0 ? 120 * std::tanh(travel / 0.6) + 0.1 * std::pow(travel, 3) : 0;
    text += fmt::format("{:.2f},{:.3f}\n", begin + 0.25 * i, force + noise * std::sin(37.0 * i * i));
  }
  return text;
}

TEST_F(StressTableTest, AnApproachWithoutForceIsLeftOut) {
  const input::StressStrainColumns specimen{.thickness = 0.025, .area = 25e-4};
  for (const double noise : {0.0, 0.5}) {
    SCOPED_TRACE(noise);
    const input::StressStrainTable own = read(approach(-3, noise), specimen);
    EXPECT_EQ(own.strain.front(), 0);
    EXPECT_NEAR(own.strain.back(), 17.0 / 25, 1e-12);
    EXPECT_THAT(
        own.remarks,
        ElementsAre("disp_mm: begins at -3 mm without force; the force begins at 0 mm, so the 0 of the "
                    "file was kept; 12 rows before were left out"));
  }
  const input::StressStrainTable shifted = read(approach(40, 0), specimen);
  EXPECT_EQ(shifted.strain.front(), 0);
  EXPECT_NEAR(shifted.strain.back(), 17.0 / 25, 1e-12);
  EXPECT_THAT(shifted.remarks,
              ElementsAre("disp_mm: begins at 40 mm without force; the force begins at 43 mm, which was "
                          "subtracted; 12 rows before were left out"));
  const input::StressStrainTable gap = read(approach(0, 0), specimen);
  EXPECT_NEAR(gap.strain.back(), 20.0 / 25, 1e-12);
  EXPECT_THAT(gap.remarks,
              ElementsAre("disp_mm: begins at 0 without force, and the force begins at 3 mm; if the "
                          "specimen is met there, subtract 3 mm from the displacements"));
  EXPECT_NEAR(base_of(material({approach(-40, 0)}, {0.01}, specimen)).strain.back(), 17.0 / 25, 1e-12);
}

TEST_F(StressTableTest, AForceThatWasNotZeroedIsToldOf) {
  std::string text = "strain,stress_kPa\n";
  for (int i = 0; i <= 70; ++i)
    text += fmt::format("{:.2f},{:.3f}\n", 0.01 * i, i < 10 ? 12 + 0.3 * (i % 3) : 12 + 8.0 * (i - 10));
  const input::StressStrainTable table = read(text);
  EXPECT_EQ(table.stress.front(), 12e3);
  EXPECT_THAT(table.remarks,
              ElementsAre(AllOf(HasSubstr("stress_kPa: in the first 11 rows it stays at 12.2"),
                                HasSubstr("2.5 % of the largest value; if it was not zeroed, subtract"))));
  EXPECT_THAT(read("strain,stress_kPa\n0,15\n0.1,100\n0.5,345\n").remarks,
              ElementsAre(HasSubstr(
                  "stress_kPa: begins at 15 kPa, 4.3 % of the largest value; if it was not zeroed")));
  EXPECT_THAT(read("strain,stress_kPa\n0,80\n0.1,100\n0.5,345\n").remarks,
              ElementsAre(HasSubstr("stress_kPa: begins at 80 kPa, 23 % of the largest value")));
  // Creep, a plateau from the first row on, and noise around 0.
  EXPECT_THAT(read("strain,stress_kPa\n0,100\n0.1,100\n0.5,101\n").remarks, IsEmpty());
  EXPECT_THAT(read("strain,stress_kPa\n0.05,20\n0.1,20\n0.2,21\n0.3,21\n0.4,22\n0.7,400\n").remarks,
              IsEmpty());
  EXPECT_THAT(read("strain,stress_kPa\n0,0.1\n0.01,-0.1\n0.02,0.1\n0.03,0\n0.04,-0.1\n0.7,100\n").remarks,
              IsEmpty());
}

TEST_F(StressTableTest, WhatIsNotClearIsOneFault) {
  const auto of = [&](const std::string& text, const input::StressStrainColumns& columns = {}) {
    return said([&] { read(text, columns); });
  };
  EXPECT_THAT(of("Weg [mm];Spannung [kPa]\n1;2\n3;4\n"),
              HasSubstr("is a displacement; for a strain, give the specimen thickness"));
  EXPECT_THAT(of("strain,load_N\n0.1,2\n0.3,4\n"),
              HasSubstr("is a force; for a stress, give the specimen area"));
  EXPECT_THAT(of("strain_1,strain_2,stress_kPa\n0.1,0.1,2\n0.3,0.3,4\n"),
              HasSubstr("several columns could be the strain"));
  EXPECT_THAT(of("strain,stress_kPa\n10,2\n30,4\n50,5\n"),
              AllOf(HasSubstr(":2: strain = 10: a strain must be below 1; if it is in per cent"),
                    testing::Not(HasSubstr(":3:"))));
  EXPECT_THAT(of("strain,stress [s]\n0.1,2\n0.3,4\n", {.stress = "stress"}),
              HasSubstr("give another unit with --stress-unit"));
  EXPECT_THAT(of("strain,stress\n0.1,2\n0.3,4\n"), HasSubstr("its unit is not stated"));
  const std::string twice = "strain,stress_kPa\n0.1,2\n0.3,4\n0.5,6\n";
  EXPECT_THAT(of(twice + twice),
              HasSubstr(":5: strain: is text among the numbers; if another table begins here"));
  EXPECT_THAT(of("<test><strain>0.1</strain></test>\n"), HasSubstr("is XML or HTML, not a table"));
  const std::string several = said([&] {
    material({"strain,force A_N,force B_N\n0.1,2,3\n0.3,4,5\n0.5,6,7\n"}, {0.01}, {.area = 25e-4});
  });
  EXPECT_THAT(
      several,
      HasSubstr("several columns could be the stress: force A_N, force B_N; choose one with --stress, "
                "or give each its rate in its header after an @"));
  EXPECT_EQ(std::ranges::count(several, '\n'), 0);
}

/// A test from 0 to a strain and back, with noise of a share of the largest stress.
std::string loop(double noise, bool with_way_back = true) {
  std::string text = "strain,stress_kPa\n";
  for (int i = 0; i <= (with_way_back ? 200 : 100); ++i) {
    const double e = 0.006 * (i <= 100 ? i : 200 - i);
    const double loading = 20 * std::tanh(e / 0.02) + 80 * e * e * e / 0.216;
    const double stress = i <= 100 ? loading : 0.4 * loading + 0.6 * loading * std::pow(e / 0.6, 6);
    text += fmt::format("{:.5f},{:.5f}\n", e, stress + noise * 100 * std::sin(37.0 * i * i));
  }
  return text;
}

TEST_F(StressTableTest, AMeasuredWayBackIsTheUnloadingCurve) {
  const input::DeckMaterial made = material({loop(0)});
  EXPECT_EQ(base_of(made).strain.size(), 100U);
  EXPECT_NEAR(base_of(made).stress.back(), 100e3, 1);
  ASSERT_TRUE(foam_of(made).unloading_curve);
  const TableCurve& back = *foam_of(made).unloading_curve;
  EXPECT_EQ(back.strain.back(), base_of(made).strain.back());
  EXPECT_NEAR(back.stress[49], 0.4 * 30e3 + 0.6 * 30e3 / 64, 30);  // at a strain of 0.3
  EXPECT_THAT(made.differences,
              Contains(HasSubstr("the strain reverses on line 102, where unloading begins")));
  EXPECT_THAT(made.assumptions, testing::Not(Contains(HasSubstr("unloading"))));
  EXPECT_THAT(material({loop(0, false)}).assumptions,
              Contains(HasSubstr("The unloading is not in the table")));
}

TEST_F(StressTableTest, NoiseIsTakenOutAndToldOf) {
  const input::DeckMaterial made = material({loop(0.004)});
  EXPECT_THAT(
      made.differences,
      Contains(HasSubstr("noise makes the stress rise and fall; it was smoothed so that it never falls")));
  const TableCurve& base = base_of(made);
  for (std::size_t i = 1; i < base.stress.size(); ++i) EXPECT_GE(base.stress[i], base.stress[i - 1]);
  for (std::size_t i = 0; i < base.strain.size(); ++i) {
    const double e = base.strain[i];
    EXPECT_NEAR(base.stress[i], 20e3 * std::tanh(e / 0.02) + 80e3 * e * e * e / 0.216, 600) << e;
  }
}

TEST_F(StressTableTest, SofteningIsLevelledAndToldOf) {
  const input::DeckMaterial made =
      material({"strain,stress_kPa\n0,0\n0.05,40\n0.1,32\n0.2,34\n0.5,60\n0.7,200\n"});
  EXPECT_THAT(base_of(made).stress, Pointwise(DoubleNear(1), {35333.0, 35333.0, 60e3, 200e3}));
  EXPECT_THAT(made.differences, Contains(HasSubstr("the stress falls near a strain of 0.05")));
}

TEST_F(StressTableTest, CyclesAndRelaxationLeaveTheLoading) {
  const input::DeckMaterial cycles =
      material({"strain,stress_kPa\n0,0\n0.1,20\n0.3,30\n0.15,8\n0.05,2\n0.2,22\n0.3,29\n0.5,60\n0.7,200\n0."
                "5,20\n0.2,5\n0,0\n"});
  EXPECT_THAT(base_of(cycles).strain, ElementsAre(0.1, 0.3, 0.5, 0.7));
  EXPECT_THAT(cycles.differences, Contains(AllOf(HasSubstr("the strain reverses on line 4 and rises again"),
                                                 HasSubstr("dashpad fit"))));
  const input::DeckMaterial relaxed =
      material({"strain,stress_kPa\n0,0\n0.1,20\n0.3,30\n0.5,60\n0.5,50\n0.5,45\n0.5,43\n"});
  EXPECT_THAT(base_of(relaxed).stress, ElementsAre(20e3, 30e3, 60e3));
  EXPECT_FALSE(foam_of(relaxed).unloading_curve);
  EXPECT_THAT(relaxed.differences, Contains(HasSubstr("the stress relaxes by 28 %")));
}

TEST_F(StressTableTest, SeveralFilesHaveTheirOwnRatesAndStrains) {
  const std::string slow = "strain,stress_kPa\n0,0\n0.1,20\n0.3,30\n0.7,200\n";
  const std::string fast = "strain,stress_kPa\n0,0\n0.05,15\n0.2,35\n0.5,120\n0.65,260\n";
  const input::DeckMaterial made = material({fast, slow}, {40, 0.01});
  EXPECT_EQ(foam_of(made).curves.slowest_rate, 0.01);
  EXPECT_THAT(base_of(made).strain, ElementsAre(0.1, 0.3, 0.7));
  const auto& effect = std::get<CurvesRateEffect>(foam_of(made).curves.rate_effect);
  ASSERT_EQ(effect.curves.size(), 1U);
  EXPECT_EQ(effect.curves.front().rate, 40);
  EXPECT_THAT(effect.curves.front().curve.strain, ElementsAre(0.05, 0.2, 0.5, 0.65));
  EXPECT_THAT(said([&] {
                material({fast, slow}, {40});
              }),
              HasSubstr("with several files, give a --rate for each"));
  const input::DeckMaterial below =
      material({slow, "strain,stress_kPa\n0,0\n0.1,18\n0.3,40\n0.7,250\n"}, {0.01, 10});
  EXPECT_THAT(
      below.differences,
      Contains(HasSubstr("test2.txt: the curve lay below the one for the next lower rate, by up to 2 kPa")));
}

TEST_F(StressTableTest, TablesAreToldFromDecksByTheirContent) {
  EXPECT_TRUE(input::is_stress_table(folder_.write("a.txt", "strain,stress_MPa\n0,0\n")));
  EXPECT_TRUE(input::is_stress_table(folder_.write("a.dat", "0 1\n")));
  EXPECT_FALSE(input::is_stress_table(folder_.write("deck.txt", "$ comment\n*KEYWORD\n")));
  EXPECT_FALSE(input::is_stress_table(folder_.write("deck.rad", "#RADIOSS STARTER\n/BEGIN\n")));
  EXPECT_FALSE(input::is_stress_table(folder_.write("words", "nothing\n")));
  EXPECT_TRUE(input::is_stress_table("/none/test.csv"));
  EXPECT_FALSE(input::is_stress_table("/none/test.k"));
}

}  // namespace
}  // namespace dashpad
