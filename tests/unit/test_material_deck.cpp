// Foams from decks of LS-DYNA and Radioss, and back into them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/input/material_deck.hpp"
#include "dashpad/output/card_toml.hpp"
#include "dashpad/output/material_deck.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Points of a curve in fields of 20 columns.
std::string points(std::initializer_list<std::pair<const char*, const char*>> pairs) {
  std::string text;
  for (const auto& [x, y] : pairs) text += fmt::format("{:>20}{:>20}\n", x, y);
  return text;
}

const std::string soft_points = points({{"0.0", "0.0"}, {"0.1", "0.02"}, {"0.4", "0.03"}, {"0.7", "0.11"}});
const std::string stiff_points = points({{"0.0", "0.0"}, {"0.1", "0.025"}, {"0.4", "0.04"}, {"0.7", "0.15"}});
const std::string curve_1 = "*DEFINE_CURVE\n         1         0\n" + soft_points;
const std::string curve_2 = "*DEFINE_CURVE\n         2         0\n" + stiff_points;

std::string low_density_foam(const std::string& hu = "       0.4", const std::string& shape = "       2.5") {
  return "*MAT_LOW_DENSITY_FOAM\n         7   1.0E-10       0.5         1          " + hu + "\n" + shape +
         "\n";
}

class MaterialDeckTest : public testing::Test {
 protected:
  std::vector<input::DeckMaterial> read(const std::string& text, const char* units = "t-mm-s") {
    return input::read_material_deck(folder_.write("deck.k", text), input::deck_system(units)).value();
  }
  Foam foam(const std::string& text, const char* units = "t-mm-s") {
    return std::get<Foam>(read(text, units).at(0).material.law);
  }
  CrushableFoam crushable(const std::string& text, const char* units = "t-mm-s") {
    return std::get<CrushableFoam>(read(text, units).at(0).material.law);
  }
  Material only(const std::string& text) { return read(text).at(0).material; }
  /// "LINE: key = value: rule" of each fault.
  std::vector<std::string> faults(const std::string& text, const char* units = "t-mm-s") {
    std::vector<std::string> lines;
    try {
      read(text, units);
    } catch (const input::InputError& error) {
      for (input::Fault fault : error.faults()) {
        fault.file.clear();
        lines.push_back(to_string(fault).substr(fault.line > 0 ? 1 : 0));
      }
    }
    return lines;
  }
  Material read_card(const std::string& text) {
    return input::read_material(folder_.write("card.toml", text)).value();
  }

  test::TemporaryFolder folder_;
};

const TableCurve soft_in_si{{0.1, 0.4, 0.7}, {20e3, 30e3, 110e3}};
const TableCurve stiff_in_si{{0.1, 0.4, 0.7}, {25e3, 40e3, 150e3}};

TEST_F(MaterialDeckTest, LowDensityFoam) {
  const auto all = read("*KEYWORD\n" + low_density_foam() + curve_1 + "*END\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].card, "*MAT_057");
  EXPECT_EQ(all[0].id, 7);
  EXPECT_EQ(all[0].line, 2);
  const Material& material = all[0].material;
  EXPECT_EQ(material.name, "material-7");
  EXPECT_EQ(material.basis, "solver card");
  EXPECT_EQ(material.density, 100);
  const Foam& foam = std::get<Foam>(material.law);
  EXPECT_EQ(foam.unloading_factor, 0.4);
  EXPECT_EQ(foam.unloading_shape, 2.5);
  EXPECT_EQ(foam.curves.slowest_rate, 0.01);
  EXPECT_EQ(foam.curves.base, BaseCurve(soft_in_si));
  EXPECT_EQ(foam.curves.rate_effect, RateEffect(NoRateEffect{}));
  EXPECT_THAT(all[0].assumptions, ElementsAre(HasSubstr("0.01 1/s")));
}

TEST_F(MaterialDeckTest, EveryFieldFormatIsReadAsTheSame) {
  const Foam fixed = foam(low_density_foam() + curve_1);
  const std::string long_card =
      fmt::format("{:>20}{:>20}{:>20}{:>20}{:>20}{:>20}\n{:>20}\n", 7, "1.0E-10", "0.5", 1, "", "0.4", "2.5");
  EXPECT_EQ(foam("*MAT_057 +\n" + long_card + curve_1), fixed);
  EXPECT_EQ(foam("*MAT_057+\n" + long_card + curve_1), fixed);
  const std::string long_curve = fmt::format("*DEFINE_CURVE\n{:>20}{:>20}\n", 1, 0) + soft_points;
  EXPECT_EQ(foam("*KEYWORD LONG=Y\n*MAT_057\n" + long_card + long_curve), fixed);
  EXPECT_EQ(foam("*KEYWORD LONG=Y\n*MAT_057 -\n" +
                 low_density_foam().substr(low_density_foam().find('\n') + 1) + long_curve),
            fixed);
  EXPECT_EQ(foam("*mat_low_density_foam\n7,1e-10,0.5,1,,0.4\n2.5\n"
                 "*define_curve\n1\n0,0\n 0.1 , 0.02 \n0.4,3-2\n0.7,1.1D-1\n"),
            fixed);
  EXPECT_EQ(foam("*MAT_057_TITLE\nA soft foam\n7,1e-10,0.5,1,,0.4\n2.5\n"
                 "$ a comment\n*DEFINE_CURVE_TITLE\nIts curve\n" +
                 curve_1.substr(curve_1.find('\n') + 1)),
            fixed);
}

TEST_F(MaterialDeckTest, TitlesNameTheCard) {
  const auto all = read("*MAT_057_TITLE\n  EPP 60 (soft)\n7,1e-10,0.5,1,,0.4\n2.5\n" + curve_1);
  EXPECT_EQ(all[0].material.title, "EPP 60 (soft)");
  EXPECT_EQ(all[0].material.name, "epp-60-soft");
}

TEST_F(MaterialDeckTest, CurvesAreScaledAndShifted) {
  const Foam plain = foam(low_density_foam() + curve_1);
  EXPECT_EQ(foam(low_density_foam() +
                 "*DEFINE_CURVE\n1,0,0.5,2.0,0.25,0.5\n-0.25,-0.5\n-0.05,-0.49\n0.55,-0.485\n1.15,-0.445\n")
                .curves.base.index(),
            plain.curves.base.index());
  const Foam scaled = foam(low_density_foam() +
                           "*DEFINE_CURVE\n1,0,0.5,2.0,0.25,0.5\n-0.25,-0.5\n0.25,-0.25\n"
                           "0.75,0.0\n1.25,0.5\n");
  EXPECT_EQ(scaled.curves.base, BaseCurve(TableCurve{{0.25, 0.5, 0.75}, {0.5e6, 1e6, 2e6}}));
}

TEST_F(MaterialDeckTest, UnitsAreThoseThatWereStated) {
  const Foam mpa = foam(low_density_foam() + curve_1);
  const Foam gpa = foam(low_density_foam() + curve_1, "kg-mm-ms");
  EXPECT_EQ(std::get<TableCurve>(gpa.curves.base).stress[0],
            1000 * std::get<TableCurve>(mpa.curves.base).stress[0]);
  EXPECT_EQ(input::deck_system("mm-t-s").name, "t-mm-s");
  EXPECT_EQ(input::deck_system("lbf-s2/in-in-s").name, "lbf-s2/in-in-s");
  EXPECT_THROW(input::deck_system("mm-g-s"), std::invalid_argument);
}

const std::string fu_chang_cards =
    "         9   5.0E-11       0.5                                                 3\n"
    "                             1.0                                           0.25\n"
    "\n"
    "                                                                             8.0\n";

TEST_F(MaterialDeckTest, FuChangFoamWithEachKindOfTable) {
  const std::string foam_text = "*MAT_FU_CHANG_FOAM\n" + fu_chang_cards;
  const std::string classic =
      "*DEFINE_TABLE\n         3\n" + points({{"0.002", ""}, {"50.0", ""}}) + curve_1 + curve_2;
  const auto all = read(foam_text + classic);
  const Foam& foam_of_table = std::get<Foam>(all[0].material.law);
  EXPECT_EQ(foam_of_table.unloading_factor, 0.25);
  EXPECT_EQ(foam_of_table.unloading_shape, 8);
  EXPECT_EQ(foam_of_table.curves.slowest_rate, 0.002);
  EXPECT_EQ(foam_of_table.curves.base, BaseCurve(soft_in_si));
  EXPECT_EQ(foam_of_table.curves.rate_effect, RateEffect(CurvesRateEffect{{{50, stiff_in_si}}, true}));
  EXPECT_THAT(all[0].assumptions, IsEmpty());
  EXPECT_THAT(all[0].differences, Contains(HasSubstr("solvers extrapolate")));
  EXPECT_THAT(all[0].material.reservations, Contains(HasSubstr("jumps")));

  const std::string by_number = points({{"0.002", "1"}, {"50.0", "2"}});
  EXPECT_EQ(foam(foam_text + curve_2 + "*DEFINE_TABLE_2D\n         3\n" + by_number + curve_1),
            foam_of_table);
  EXPECT_EQ(foam(foam_text + curve_2 + "*DEFINE_TABLE\n3\n" + by_number + curve_1), foam_of_table);
  EXPECT_EQ(foam(foam_text + "*DEFINE_TABLE_2D\n3,0.5\n0.004,1\n100,2\n" + curve_1 + curve_2), foam_of_table);
  Foam log_log = foam_of_table;
  std::get<CurvesRateEffect>(log_log.curves.rate_effect).linear = false;
  EXPECT_EQ(foam("*MAT_083_LOG_LOG_INTERPOLATION_TITLE\nTitle\n" + fu_chang_cards + classic), log_log);
}

TEST_F(MaterialDeckTest, RatesAreInTheUnitOfTime) {
  const Foam read =
      foam("*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n1e-5\n0.1\n" + curve_1 + curve_2, "kg-mm-ms");
  EXPECT_EQ(read.curves.slowest_rate, 0.01);
  EXPECT_EQ(std::get<CurvesRateEffect>(read.curves.rate_effect).curves[0].rate, 100);
}

TEST_F(MaterialDeckTest, AnUnstatedSlowestRateIsAssumed) {
  const std::string head = "*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n";
  EXPECT_EQ(foam(head + "0.0\n10.0\n" + curve_1 + curve_2).curves.slowest_rate, 0.01);
  EXPECT_EQ(foam(head + "0.0\n0.005\n" + curve_1 + curve_2).curves.slowest_rate, 0.0005);
}

TEST_F(MaterialDeckTest, UnloadingWithoutANumberIsThatOfTheSolver) {
  const auto blank = read(low_density_foam("          ", "          ") + curve_1);
  EXPECT_EQ(std::get<Foam>(blank[0].material.law).unloading_factor, 1);
  EXPECT_THAT(blank[0].assumptions, Contains(HasSubstr("HU is blank or 0")));
  // 083 has 0 for the unloading along the slowest curve.
  const auto fu_chang = read("*MAT_083\n9,5e-11,0.5,,,,,3\n0,1\n\n\n2.5\n*DEFINE_TABLE\n3\n0.01\n" + curve_1);
  EXPECT_EQ(std::get<Foam>(fu_chang[0].material.law).unloading_factor, 1);
  EXPECT_THAT(fu_chang[0].differences, Contains(HasSubstr("EXPON = 2.5")));
}

TEST_F(MaterialDeckTest, WhatACardCannotSayIsListed) {
  const auto all = read(
      "*MAT_057\n7,1e-10,0.5,1,0.2,0.4,3.0,0.1\n2.5,1,1,0.3,0.4,0.5,1\n"
      "*DEFINE_CURVE\n1\n-0.5,-1\n-0.1,-0.5\n0,0\n.1,.02\n.4,.03\n.7,.11\n");
  for (const char* const name : {"TC", "BETA", "DAMP", "FAIL", "BVFLAG", "ED", "BETA1", "KCON", "REF"})
    EXPECT_THAT(all[0].differences, Contains(testing::StartsWith(std::string(name) + " = ")));
  EXPECT_THAT(all[0].differences, Contains(HasSubstr("curve 1: 2 points in tension were left out")));
  EXPECT_EQ(std::get<Foam>(all[0].material.law).curves.base, BaseCurve(soft_in_si));
}

const std::string crushable_card =
    "*MAT_CRUSHABLE_FOAM\n         5   2.0E-11       4.0       0.0         1       0.1\n";

TEST_F(MaterialDeckTest, CrushableFoams) {
  const auto all = read(crushable_card + curve_1);
  const CrushableFoam& foam = std::get<CrushableFoam>(all[0].material.law);
  EXPECT_EQ(foam.unloading_modulus, 4e6);
  EXPECT_EQ(foam.curves.base, BaseCurve(soft_in_si));
  EXPECT_THAT(all[0].differences, AllOf(Contains(HasSubstr("TSC = 0.1")), Contains(HasSubstr("last slope"))));

  const CrushableFoam rates =
      crushable("*MAT_163\n5,2e-11,4,0,3\n1e20,1\n*DEFINE_TABLE\n3\n0.002\n50\n" + curve_1 + curve_2);
  EXPECT_EQ(rates.unloading_modulus, 4e6);
  EXPECT_EQ(rates.curves.rate_effect, RateEffect(CurvesRateEffect{{{50, stiff_in_si}}, true}));
}

TEST_F(MaterialDeckTest, AYieldStressAtStrainZeroIsReachedAlongTheModulus) {
  const auto all = read("*MAT_063\n5,2e-11,4,0,1\n*DEFINE_CURVE\n1\n0,0.2\n0.5,0.3\n0.7,0.5\n");
  const CrushableFoam& foam = std::get<CrushableFoam>(all[0].material.law);
  const TableCurve& curve = std::get<TableCurve>(foam.curves.base);
  ASSERT_EQ(curve.strain.size(), 5u);
  // 4 e = 0.2 + 0.2 e
  EXPECT_DOUBLE_EQ(curve.strain[2], 0.2 / 3.8);
  EXPECT_DOUBLE_EQ(curve.stress[2], 4e6 * 0.2 / 3.8);
  EXPECT_THAT(std::vector(curve.strain.begin() + 3, curve.strain.end()), ElementsAre(0.5, 0.7));
  EXPECT_TRUE(violations(all[0].material).empty());
  EXPECT_GE(foam.unloading_modulus, 4e6);
  EXPECT_THAT(all[0].differences, Contains(HasSubstr("rises along the elastic line")));
}

TEST_F(MaterialDeckTest, AModulusThatIsTooLowIsRaised) {
  const auto all = read("*MAT_063\n5,2e-11,0.25,0,1\n" + curve_1);
  EXPECT_TRUE(violations(all[0].material).empty());
  EXPECT_GT(std::get<CrushableFoam>(all[0].material.law).unloading_modulus, 0.25e6);
  EXPECT_THAT(all[0].assumptions, Contains(HasSubstr("steepest slope")));
}

const std::string radioss_functions =
    "/FUNCT/1\nsoft\n" + soft_points + "/FUNCT/2\nstiff\n#  X  Y\n" + stiff_points;
const std::string law_90 =
    "#RADIOSS STARTER\n/MAT/LAW90/7\nSoft foam\n#              RHO_I\n             1.0E-10\n"
    "                 0.5                 0.0\n"
    "         2         0                 0.0                 2.5                 0.4\n"
    "         1               0.002                 1.0\n"
    "         2                50.0                 0.0\n";

TEST_F(MaterialDeckTest, Law90) {
  const auto all = read(law_90 + radioss_functions + "/END\n");
  EXPECT_EQ(all[0].material.title, "Soft foam");
  EXPECT_EQ(all[0].material.density, 100);
  const Foam& foam = std::get<Foam>(all[0].material.law);
  EXPECT_EQ(foam.unloading_factor, 0.4);
  EXPECT_EQ(foam.unloading_shape, 2.5);
  EXPECT_EQ(foam.curves.slowest_rate, 0.002);
  EXPECT_EQ(foam.curves.base, BaseCurve(soft_in_si));
  EXPECT_EQ(foam.curves.rate_effect, RateEffect(CurvesRateEffect{{{50, stiff_in_si}}, true}));
}

TEST_F(MaterialDeckTest, Law70WithAnUnloadingFunction) {
  const std::string law_70 =
      "/MAT/FOAM_TAB/7\nFoam\n             1.0E-10\n"
      "                 0.5                 0.0                 1.0                 1.0         0\n"
      "                 0.0         0         1         1         0                 0.0                 0.0\n"
      "         2                 0.0                 1.0\n"
      "         1                 0.0                 0.5\n";
  const auto all = read(law_70 + radioss_functions);
  const Foam& foam = std::get<Foam>(all[0].material.law);
  EXPECT_EQ(foam.curves.base, BaseCurve(stiff_in_si));
  ASSERT_TRUE(foam.unloading_curve);
  EXPECT_EQ(*foam.unloading_curve, (TableCurve{{0.1, 0.4, 0.7}, {10e3, 15e3, 55e3}}));
  EXPECT_THAT(all[0].differences, Contains(HasSubstr("unloading function")));

  const std::string by_work = law_70.substr(0, law_70.find("         1         1         0")) +
                              "         1         0         4                 2.5                 0.4\n"
                              "         2                 0.0                 1.0\n";
  const Foam damaged = this->foam(by_work + radioss_functions);
  EXPECT_FALSE(damaged.unloading_curve);
  EXPECT_EQ(damaged.unloading_factor, 0.4);
  EXPECT_EQ(damaged.unloading_shape, 2.5);
}

TEST_F(MaterialDeckTest, Law33) {
  const std::string head = "/MAT/LAW33/7\nFoam\n             2.0E-11\n";
  const std::string elastic = "                 4.0         0         1                 1.0\n";
  const std::string nothing = "\n";
  const std::string function =
      "/FUNCT/1\nyield\n" + points({{"-0.7", "0.5"}, {"-0.5", "0.3"}, {"-0.1", "0.2"}, {"0.0", "0.0"}});
  const CrushableFoam foam = crushable(head + elastic + nothing + "                 0.0\n" + function);
  EXPECT_EQ(foam.unloading_modulus, 4e6);
  EXPECT_EQ(foam.curves.base, BaseCurve(TableCurve{{0.1, 0.5, 0.7}, {0.2e6, 0.3e6, 0.5e6}}));
  // Air of 0.1 MPa: 0.1 e / (1 - e) beside the skeleton.
  const auto with_air = read(head + elastic + "                 0.1\n" + "                 0.0\n" + function);
  const auto& curve = std::get<TableCurve>(std::get<CrushableFoam>(with_air[0].material.law).curves.base);
  EXPECT_DOUBLE_EQ(curve.stress[1], 0.3e6 + 0.1e6);
  EXPECT_THAT(with_air[0].differences, Contains(HasSubstr("air")));
}

TEST_F(MaterialDeckTest, Law33ByItsFormula) {
  const auto all = read(
      "/MAT/LAW33/7\nFoam\n             2.0E-11\n                 4.0\n\n"
      "                 0.1                 0.1                -1.0\n");
  const auto& curve = std::get<TableCurve>(std::get<CrushableFoam>(all[0].material.law).curves.base);
  EXPECT_DOUBLE_EQ(curve.stress.back(), 0.1e6 + 0.1e6 * (1 + curve.strain.back()));
  EXPECT_TRUE(violations(all[0].material).empty());
}

std::string law_62(const std::string& flags,
                   const std::string& ratios = "                 0.6                 0.2\n") {
  return "/MAT/LAW62/7\nSlow foam\n#              RHO_I\n             6.0E-11\n" + flags +
         "                0.15                0.04\n                 6.0                -1.0\n" + ratios +
         "                0.02                 0.3\n";
}
const std::string law_62_flags = "                 0.0         2         2                 0.0         1\n";

TEST_F(MaterialDeckTest, Law62GivesTheModuliOfASuddenStrain) {
  const auto all = read(law_62(law_62_flags));
  EXPECT_EQ(all[0].material.density, 60);
  const ViscoelasticFoam sample{30e3, 6, 8e3, -1, 3, 0.02, 1, 0.3};
  EXPECT_EQ(std::get<ViscoelasticFoam>(all[0].material.law), sample);
  EXPECT_THAT(all[0].assumptions, IsEmpty());
  EXPECT_THAT(all[0].differences, ElementsAre(HasSubstr("second Piola-Kirchhoff")));
  // Flag_Rigi 2: the moduli are those of the lasting stress.
  ViscoelasticFoam lasting = sample;
  lasting.first_modulus = 0.15e6, lasting.second_modulus = 0.04e6;
  EXPECT_EQ(std::get<ViscoelasticFoam>(read(law_62(
                "                 0.0         2         2                 0.0         1         2\n"))[0]
                                           .material.law),
            lasting);
  // Times are in the unit of the deck.
  const auto in_ms = read(law_62(law_62_flags), "kg-mm-ms");
  EXPECT_EQ(std::get<ViscoelasticFoam>(in_ms[0].material.law).first_time, 0.02e-3);
  EXPECT_EQ(std::get<ViscoelasticFoam>(in_ms[0].material.law).first_modulus, 30e6);
}

TEST_F(MaterialDeckTest, Law62WithoutBranchesIsElastic) {
  const auto all = read(
      "/MAT/VISC_HYP/7\nFoam\n             6.0E-11\n                 0.0         1         0\n"
      "                0.15\n                 0.0\n");
  EXPECT_EQ(std::get<ViscoelasticFoam>(all[0].material.law), (ViscoelasticFoam{0.15e6, 1, 0, 1, 0, 1, 0, 1}));
  EXPECT_THAT(all[0].assumptions, ElementsAre(HasSubstr("alpha_i"), HasSubstr("M = 0")));
}

TEST_F(MaterialDeckTest, WhatLaw62SaysMoreIsListed) {
  const auto all = read(law_62("                 0.3         2         2                 5.0         0\n",
                               "                 0.6                 0.2\n") +
                        "                 0.1                 0.2\n");
  EXPECT_THAT(all[0].differences,
              ElementsAre(HasSubstr("Nu = 0.3"), HasSubstr("mu_max = 5"), HasSubstr("nu_1 = 0.1"),
                          HasSubstr("nu_2 = 0.2"), HasSubstr("Flag_Visc = 0"), HasSubstr("Piola")));
  const std::string without_times = law_62(law_62_flags);
  const auto frozen = read(without_times.substr(0, without_times.size() - 41) + "                0.02\n");
  EXPECT_EQ(std::get<ViscoelasticFoam>(frozen[0].material.law).second_time, 1e15);
  EXPECT_THAT(frozen[0].assumptions, ElementsAre(HasSubstr("tau_i")));
}

TEST_F(MaterialDeckTest, Law62ThatACardCannotSayIsRefused) {
  EXPECT_THAT(faults(law_62("                 0.0         3         2\n")),
              ElementsAre(HasSubstr("5: /MAT/LAW62: N = 3: must be from 1 to 2")));
  EXPECT_THAT(faults(law_62("                 0.0         2         3\n")),
              ElementsAre(HasSubstr("5: /MAT/LAW62: M = 3: must be from 0 to 2")));
  for (const char* const ratios : {"                 0.6                 0.4\n", "                 1.1\n",
                                   "                -0.1                 0.2\n"})
    EXPECT_THAT(faults(law_62(law_62_flags, ratios)), ElementsAre(HasSubstr("8: /MAT/LAW62: gamma_i = ")));
  EXPECT_THAT(faults(law_62(law_62_flags, "                 0.6                   x\n")),
              ElementsAre(HasSubstr("8: /MAT/LAW62: gamma_2 = x")));
  EXPECT_THAT(faults("/MAT/LAW62/7\nFoam\n             6.0E-11\n" + law_62_flags),
              ElementsAre(HasSubstr("ends after only 2 lines")));
  std::string negative = law_62(law_62_flags);
  negative.replace(negative.find(" 0.04"), 5, "-0.04");
  EXPECT_THAT(faults(negative), ElementsAre(HasSubstr("1: /MAT/LAW62: parameters.second_modulus")));
}

TEST_F(MaterialDeckTest, TheUnitsOfARadiossDeckMustBeThoseStated) {
  const std::string begin =
      "/BEGIN\nrun\n      2022         0\n                  kg                  mm                  ms\n"
      "                  kg                  mm                  ms\n";
  EXPECT_NO_THROW(read(begin + law_90 + radioss_functions, "kg-mm-ms"));
  EXPECT_THAT(faults(begin + law_90 + radioss_functions),
              ElementsAre(HasSubstr("4: units = kg, mm, ms: are those of kg-mm-ms, but --units is t-mm-s")));
}

TEST_F(MaterialDeckTest, SeveralMaterialsHaveNamesOfTheirOwn) {
  const auto all =
      read("*MAT_057_TITLE\nFoam\n7,1e-10,0.5,1,,0.4\n2.5\n*MAT_057_TITLE\nFoam\n8,1e-10,0.5,1,,0.4\n2.5\n" +
           curve_1);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].material.name, "foam-7");
  EXPECT_EQ(all[1].material.name, "foam-8");
}

TEST_F(MaterialDeckTest, EachFaultNamesItsLine) {
  const auto curve = [&](const std::string& rows) {
    return faults(low_density_foam() + "*DEFINE_CURVE\n1\n" + rows);
  };
  EXPECT_THAT(curve("0.1,0.02\n0.4,nan\n0.7,0.11\n"),
              ElementsAre(HasSubstr("7: curve 1: O2 = nan: must be a finite")));
  EXPECT_THAT(curve("0.1,0.02\n0.1,0.03\n0.7,0.11\n"),
              ElementsAre(HasSubstr("7: curve 1: strain = 0.1: appears twice")));
  EXPECT_THAT(curve("0.1,0.02\n0.4,0.03\n1.0,0.11\n"),
              ElementsAre(HasSubstr("8: curve 1: strain = 1: must be less than 1")));
  EXPECT_THAT(
      curve("0.1,0.02\n0.4,0.01\n0.7,0.01\n"),
      ElementsAre(HasSubstr("7: curve 1: stress = 10000: must not be less than the previous stress, 20000"),
                  HasSubstr("8: curve 1: stress = 10000")));
  EXPECT_THAT(curve("0.1       0.02\n"),
              ElementsAre(HasSubstr("6: curve 1: A1 = 0.1       0.02: is not a number (columns 1 to 20)")));
  EXPECT_THAT(curve("0.1\t0.02\n"), Contains(HasSubstr("6: contains a tab")));
  EXPECT_THAT(curve("0.1,0.02\n0.4,0.03\n"), ElementsAre(HasSubstr("4: curve 1: has 2 points")));
  EXPECT_THAT(curve("0.1,&peak\n"), ElementsAre(HasSubstr("is not defined by any *PARAMETER in this deck")));
  EXPECT_THAT(curve("0.1,1e999\n"), ElementsAre(HasSubstr("is too large or too small")));
  EXPECT_THAT(curve("\xff\xfe,1\n"), Contains(HasSubstr("6: curve 1: A1 = ")));
}

TEST_F(MaterialDeckTest, ParametersStandForNumbers) {
  const std::string deck =
      "*PARAMETER\n  R    rho   5.0e-11  I     lc         7\nr hu,0.5,Rpeak,1\n"
      "*PARAMETER_EXPRESSION\nR      top2*(peak+sqrt(4)-2)^2/2-(-1+1)\n"
      "*MAT_057\n1,&rho,50.0,&LC,,&hu\n5\n*DEFINE_CURVE\n&lc,,,&peak\n0,0\n0.1,0.03\n0.5,0.07\n0.8,&top\n";
  const Material material = only(deck);
  const auto& law = std::get<Foam>(material.law);
  EXPECT_DOUBLE_EQ(*material.density, 50);
  EXPECT_EQ(law.unloading_factor, 0.5);
  EXPECT_DOUBLE_EQ(std::get<TableCurve>(law.curves.base).stress.back(), 1e6);
  EXPECT_THAT(faults(low_density_foam() + "*PARAMETER\nR a,-3\n*DEFINE_CURVE\n1\n0.1,0.02\n0.4,-&a\n0.7,4\n"),
              ElementsAre());
  for (const auto& [expression, rule] : std::vector<std::pair<std::string, std::string>>{
           {"1/(2-2)", "divides by zero"},
           {"2*b", "uses b, which is not defined above it"},
           {"a", "uses a, which is not defined above it"},
           {"(1+2", "an unclosed bracket"},
           {"1 2", "has unexpected text at its end: \"2\""},
           {"ln(2)", "uses the function ln, which is not supported"},
           {"exp(1000)", "is not a finite number"},
           {std::string(30, '(') + "1" + std::string(30, ')'), "is nested more than 20 levels deep"},
           {"", "ends where a number is needed"}})
    EXPECT_THAT(
        faults("*PARAMETER_EXPRESSION\nR a       " + expression + "\n" + low_density_foam() + curve_1),
        Contains(AllOf(HasSubstr("2: parameter a"), HasSubstr(rule))))
        << expression;
  EXPECT_THAT(faults("*PARAMETER\nR a,1,R a,2\n" + low_density_foam() + curve_1),
              ElementsAre(HasSubstr("parameter a: is defined twice")));
}

TEST_F(MaterialDeckTest, CurvesOutOfReachAreNamedForWhatTheyAre) {
  EXPECT_THAT(faults(low_density_foam() + "*DEFINE_CURVE_SMOOTH\n1,0,1,0,0.01,0.1\n"),
              ElementsAre(HasSubstr("curve 1 is a *DEFINE_CURVE_SMOOTH; only *DEFINE_CURVE is read")));
  EXPECT_THAT(
      faults(low_density_foam() + "-----BEGIN PGP MESSAGE-----\nhQEM\n-----END PGP MESSAGE-----\n*END\n"),
      ElementsAre(HasSubstr("part of the deck is encrypted, from line 4 on, so *DEFINE_CURVE 1 cannot")));
  EXPECT_THAT(faults("*MAT_063\n3,4e-11,50,0,1,0.1,0.1,1\n0.3,1.2,0.1\n" + curve_1),
              ElementsAre(HasSubstr("MODEL = 1: must be 0 (a curve against volumetric strain)")));
}

TEST_F(MaterialDeckTest, PlateausOfEqualStressAreRead) {
  const Material material =
      only("*MAT_063\n3,4e-11,50,0,1\n*DEFINE_CURVE\n1\n0,0.2\n0.1,0.2\n0.5,0.2\n0.7,0.5\n0.8,3\n");
  const auto& base = std::get<TableCurve>(std::get<CrushableFoam>(material.law).curves.base);
  EXPECT_DOUBLE_EQ(base.strain[2], 0.2e6 / 50e6);
  EXPECT_DOUBLE_EQ(base.stress[2], 0.2e6);
  EXPECT_EQ(base.stress[3], base.stress[2]);
}

/// As straight lines, which a deck means, the faster curve is not below the slower one.
TEST_F(MaterialDeckTest, CurvesThatShareTheirBeginningOrHaveOtherStrainsAreRead) {
  const std::string cards = "*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n0.01\n10\n";
  const std::string slow = "*DEFINE_CURVE\n1\n0,0\n0.02,0.02\n0.1,0.03\n0.5,0.07\n0.8,1\n";
  EXPECT_THAT(faults(cards + slow + "*DEFINE_CURVE\n2\n0,0\n0.02,0.02\n0.1,0.045\n0.5,0.105\n0.8,1.5\n"),
              ElementsAre());
  EXPECT_THAT(faults(cards + slow +
                     "*DEFINE_CURVE\n2\n0,0\n0.01,0.0102\n0.02,0.0204\n0.06,0.0255\n0.1,0.0306\n0.5,0.0714\n"
                     "0.8,1.02\n"),
              ElementsAre());
  EXPECT_THAT(faults(cards + slow + "*DEFINE_CURVE\n2\n0,0\n0.02,0.02\n0.1,0.02\n0.5,0.07\n0.8,1\n"),
              ElementsAre(HasSubstr("curve 2: stress = ")));
}

TEST_F(MaterialDeckTest, FoamsOfAbaqusAreRead) {
  const std::string begin = "*MATERIAL, NAME=Pad foam\n*DENSITY\n5e-11,\n";
  const std::string rows =
      "0,0,0\n0.02,0.02,0\n0.03,0.1,0\n1,0.8,0\n0,0,10\n0.03,0.02,10\n0.045,0.1,10\n1.5,0.8,10\n";
  const Material slow = only(begin + "*LOW DENSITY FOAM\n*UNIAXIAL TEST DATA, DIRECTION=TENSION\n0,0\n1,1\n" +
                             "** compression\n*Uniaxial Test Data, direction=compression\n" + rows);
  EXPECT_EQ(slow.title, "Pad foam");
  EXPECT_DOUBLE_EQ(*slow.density, 50);
  const auto& law = std::get<Foam>(slow.law);
  EXPECT_EQ(std::get<TableCurve>(law.curves.base).strain, (std::vector<double>{0.02, 0.1, 0.8}));
  EXPECT_EQ(std::get<CurvesRateEffect>(law.curves.rate_effect).curves.front().rate, 10);
  const Material loop =
      only(begin +
           "*LOW DENSITY FOAM, LATERAL STRAIN DATA=YES\n*UNIAXIAL TEST DATA, DIRECTION=COMPRESSION\n"
           "0,0,0,0.01\n0.02,0.02,0,0.01\n0.03,0.1,0,0.01\n1,0.8,0,0.01\n"
           "0.01,0.1,0,-0.01\n0.02,0.3,0,-0.01\n1,0.8,0,-0.01\n");
  EXPECT_EQ(std::get<Foam>(loop.law).curves.slowest_rate, 0.01);
  EXPECT_EQ(std::get<Foam>(loop.law).unloading_curve->strain, (std::vector<double>{0.1, 0.3, 0.8}));
  const Material tested = only(
      "*MATERIAL, NAME=F\n*HYPERFOAM, TEST DATA INPUT, N=2, POISSON=0\n*UNIAXIAL TEST DATA\n"
      "-1,-0.8\n-0.03,-0.1\n-0.02,-0.02\n0.1,0.1\n");
  EXPECT_EQ(std::get<TableCurve>(std::get<Foam>(tested.law).curves.base).stress,
            (std::vector<double>{2e4, 3e4, 1e6}));
  const Material fitted = only("*MATERIAL, NAME=F\n*HYPERFOAM, N=2\n0.03,6,0.01,-2,0,0\n");
  const auto& curve = std::get<HyperfoamCurve>(std::get<Foam>(fitted.law).curves.base);
  EXPECT_DOUBLE_EQ(curve.first_modulus, 3e4);
  EXPECT_EQ(curve.second_exponent, -2);
  const auto damped =
      read("*MATERIAL, NAME=F\n*HYPERFOAM, N=1\n0.03,6,0\n*MULLINS EFFECT\n1.5,0.1,0.1\n").at(0);
  EXPECT_THAT(damped.differences, Contains(HasSubstr("*MULLINS EFFECT and its energy loss are left out")));
  EXPECT_THAT(damped.assumptions, Contains(HasSubstr("without loss at that rate")));
  EXPECT_THAT(faults("*MATERIAL, NAME=F\n*HYPERFOAM, N=3\n1,2,3,4,5,6,0,0\n"),
              ElementsAre(HasSubstr("must be 1 or 2")));
  EXPECT_THAT(faults("*MATERIAL, NAME=F\n*LOW DENSITY FOAM\n"),
              ElementsAre(HasSubstr("has no *UNIAXIAL TEST DATA")));
  EXPECT_THAT(faults("*MATERIAL, NAME=F\n*ELASTIC\n1,0\n"),
              ElementsAre(HasSubstr("contains no Abaqus *LOW DENSITY FOAM")));
}

TEST_F(MaterialDeckTest, DecksThatAreCutShortAreRefused) {
  EXPECT_THAT(faults(low_density_foam()),
              ElementsAre(HasSubstr("2: *MAT_057: LCID = 1: there is no *DEFINE_CURVE 1")));
  EXPECT_THAT(faults("*INCLUDE\ncurves.k\n" + low_density_foam()), ElementsAre(HasSubstr("*INCLUDE")));
  EXPECT_THAT(faults("*MAT_057\n7,1e-10,0.5,1\n" + curve_1),
              ElementsAre(HasSubstr("1: *MAT_057: ends after 1 of 2 lines")));
  EXPECT_THAT(faults("*MAT_083\n" + fu_chang_cards), ElementsAre(HasSubstr("there is no *DEFINE_TABLE 3")));
  EXPECT_THAT(
      faults("*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n0.01\n10\n" + curve_1),
      ElementsAre(HasSubstr(
          "9: table 3: must be directly followed by one *DEFINE_CURVE per rate, 2 in all; number 2")));
  EXPECT_THAT(faults("*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n10\n0.01\n" + curve_1 + curve_2),
              ElementsAre(HasSubstr("9: *MAT_083: rate = 0.01: must be more than the previous rate")));
  EXPECT_THAT(faults(law_90), testing::SizeIs(2));
  EXPECT_THAT(faults("/MAT/LAW90/7\nFoam\n"),
              ElementsAre(HasSubstr("1: /MAT/LAW90: ends after only 0 lines")));
  EXPECT_THAT(faults("*MAT_ELASTIC\n1\n"),
              ElementsAre(AllOf(HasSubstr("contains no *MAT_057"), HasSubstr("*MAT_ELASTIC"))));
  EXPECT_THAT(faults("/MAT/LAW1/1\n"), ElementsAre(HasSubstr("/MAT/LAW1")));
  EXPECT_THAT(faults("title = \"a card\"\n"), ElementsAre(HasSubstr("is not a deck")));
  EXPECT_THAT(faults(""), ElementsAre(HasSubstr("is empty")));
  EXPECT_THAT(faults(std::string("*MAT\0", 5)), ElementsAre(HasSubstr("is not text")));
  EXPECT_THAT(faults(low_density_foam() + curve_1 + curve_1),
              ElementsAre(HasSubstr("10: curve 1: is defined twice, first on line 4")));
}

TEST_F(MaterialDeckTest, OptionsWithoutACounterpartAreRefused) {
  EXPECT_THAT(faults("*MAT_FU_CHANG_FOAM_DAMAGE_DECAY\n" + fu_chang_cards),
              ElementsAre(HasSubstr("DAMAGE_DECAY")));
  EXPECT_THAT(faults("*MAT_083_1\n" + fu_chang_cards), ElementsAre(HasSubstr("option")));
  EXPECT_THAT(faults("*MAT_063\n5,2e-11,4,0,1,,,1\n" + curve_1), ElementsAre(HasSubstr("MODEL = 1")));
  EXPECT_THAT(faults("*MAT_083\n9,5e-11,0.5\n\n\n\n"), ElementsAre(HasSubstr("TBID")));
}

TEST_F(MaterialDeckTest, RulesOfTheLawNameTheLineOfTheDeck) {
  EXPECT_THAT(faults(low_density_foam("       1.5") + curve_1),
              ElementsAre(AllOf(HasSubstr("1: *MAT_057: parameters.unloading_factor = 1.5"),
                                HasSubstr("at most 1"))));
  EXPECT_THAT(faults("*MAT_083\n" + fu_chang_cards + "*DEFINE_TABLE\n3\n0.01\n10\n" + curve_2 + curve_1),
              Contains(AllOf(HasSubstr("*MAT_083: curve 1: stress"), HasSubstr("crosses"))));
}

// --- And back ---

Foam some_foam() {
  Foam foam;
  foam.unloading_factor = 0.123456789012345;
  foam.unloading_shape = 1.3;
  foam.curves = {
      TableCurve{{0.01, 1.0 / 3, 0.7000000000000001}, {1234.5, 98765.4321, 2.0 / 3 * 1e6}}, 8.4e-5, {}};
  return foam;
}

FoamCurves with_rates(FoamCurves curves, bool linear) {
  TableCurve fast = std::get<TableCurve>(curves.base);
  for (double& stress : fast.stress) stress *= 1.25;
  curves.rate_effect = CurvesRateEffect{{{10.5, fast}}, linear};
  return curves;
}

Material material_of(PadLaw law) {
  Material material;
  material.name = "some-foam";
  material.title = "Some foam";
  material.source = "a test";
  material.density = 105.5;
  material.law = std::move(law);
  return material;
}

class RoundTrip : public MaterialDeckTest, public testing::WithParamInterface<const char*> {
 protected:
  template <class Law>
  Law there_and_back(const Law& law, const std::string& format) {
    output::MaterialDeckOptions options{format, consistent_system(GetParam()), 11};
    const Material material = material_of(law);
    const std::string deck = output::material_deck(material, options);
    const auto all = read(deck, GetParam());
    EXPECT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].material.title, material.title);
    EXPECT_EQ(all[0].material.density, material.density) << deck;
    EXPECT_EQ(all[0].id, 11);
    return std::get<Law>(all[0].material.law);
  }
};

TEST_P(RoundTrip, FoamOfOneRate) {
  Foam foam = some_foam();
  for (const char* const format : {"ls-dyna-083", "radioss-70", "radioss-90"})
    EXPECT_EQ(there_and_back(foam, format), foam) << format;
  foam.curves.slowest_rate = 0.01;  // which 057 cannot say
  EXPECT_EQ(there_and_back(foam, "ls-dyna-057"), foam);
}

TEST_P(RoundTrip, FoamOfSeveralRates) {
  Foam foam = some_foam();
  for (const bool linear : {false, true}) {
    foam.curves = with_rates(foam.curves, linear);
    EXPECT_EQ(there_and_back(foam, "ls-dyna-083"), foam);
  }
  for (const char* const format : {"radioss-70", "radioss-90"})
    EXPECT_EQ(there_and_back(foam, format), foam) << format;
}

TEST_P(RoundTrip, MeasuredUnloading) {
  Foam foam = some_foam();
  foam.unloading_factor = foam.unloading_shape = 1;
  foam.unloading_curve = TableCurve{{0.02, 0.3, 0.7000000000000001}, {1000, 40e3, 2.0 / 3 * 1e6}};
  EXPECT_EQ(there_and_back(foam, "radioss-70"), foam);
  const auto told = output::not_in_material_deck(material_of(foam), {"radioss-90"});
  EXPECT_THAT(told, Contains(HasSubstr("unloading curve is left out")));
}

TEST_P(RoundTrip, CrushableFoams) {
  CrushableFoam foam;
  foam.unloading_modulus = 7654321.5;
  foam.curves = some_foam().curves;
  foam.curves.slowest_rate = 0.01;
  for (const char* const format : {"ls-dyna-063", "ls-dyna-163", "radioss-33"})
    EXPECT_EQ(there_and_back(foam, format), foam) << format;
  foam.curves.slowest_rate = 0.002;
  foam.curves = with_rates(foam.curves, true);
  EXPECT_EQ(there_and_back(foam, "ls-dyna-163"), foam);
}

TEST_P(RoundTrip, ViscoelasticFoams) {
  ViscoelasticFoam foam{.first_modulus = 31234.5678,
                        .first_exponent = 17.3,
                        .second_modulus = 7654.321,
                        .second_exponent = -1.0 / 3,
                        .first_share = 2.718281828,
                        .first_time = 0.0123456789012345,
                        .second_share = 0.577215665,
                        .second_time = 0.3};
  EXPECT_EQ(there_and_back(foam, "radioss-62"), foam);
  const std::string deck =
      output::material_deck(material_of(foam), {"radioss-62", consistent_system(GetParam())});
  EXPECT_THAT(read(deck, GetParam())[0].differences, ElementsAre(HasSubstr("Piola")));  // Flag_Visc is 1
  EXPECT_THAT(deck, HasSubstr("# Difference from the card: In the solver the second Piola-Kirchhoff"));
  foam.first_share = 987.654321, foam.second_share = 0.123456789;
  EXPECT_EQ(there_and_back(foam, "radioss-62"), foam);
  foam.second_share = 0, foam.second_time = 1;
  foam.second_modulus = 0, foam.second_exponent = 1;
  EXPECT_EQ(there_and_back(foam, "radioss-62"), foam);
  foam.first_share = 0, foam.first_time = 1;
  EXPECT_EQ(there_and_back(foam, "radioss-62"), foam);
}

INSTANTIATE_TEST_SUITE_P(InEachSystem, RoundTrip, testing::Values("kg-mm-ms", "kg-m-s", "t-mm-s"),
                         [](const auto& given) {
                           std::string name = given.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_F(MaterialDeckTest, PoundsAndInchesComeBackToTheLastDigits) {
  const Foam foam = some_foam();
  const output::MaterialDeckOptions options{"radioss-90", consistent_system("lbf-s2/in-in-s"), 1};
  const Foam again = std::get<Foam>(
      read(output::material_deck(material_of(foam), options), "lbf-s2/in-in-s")[0].material.law);
  const auto& before = std::get<TableCurve>(foam.curves.base).stress;
  const auto& after = std::get<TableCurve>(again.curves.base).stress;
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-13 * before[i]);
}

TEST_F(MaterialDeckTest, FormulasBecomePoints) {
  Foam foam;
  foam.curves = {PowerCurve{5e5, 0.5, 1, 0.8}, 0.01, PowerRateEffect{0.05, 0, 100}};
  foam.friction = 0.1;
  const Material material = material_of(foam);
  const output::MaterialDeckOptions options{"ls-dyna-083", plain_si(), 1};
  const Foam again = std::get<Foam>(read(output::material_deck(material, options), "kg-m-s")[0].material.law);
  const TableCurve& curve = std::get<TableCurve>(again.curves.base);
  ASSERT_EQ(curve.strain.size(), 100u);
  EXPECT_EQ(curve.strain.back(), 0.8);
  EXPECT_NEAR(curve.stress.back(), std::get<PowerCurve>(foam.curves.base).stress(0.8), 1);
  const auto& rates = std::get<CurvesRateEffect>(again.curves.rate_effect);
  ASSERT_EQ(rates.curves.size(), 4u);  // 0.1, 1, 10, 100 1/s
  EXPECT_EQ(rates.curves.back().rate, 100);
  EXPECT_NEAR(rates.curves.back().curve.stress.back() / curve.stress.back(), std::pow(1e4, 0.05), 1e-8);
  EXPECT_FALSE(rates.linear);
  EXPECT_THAT(output::not_in_material_deck(material, options),
              AllOf(Contains(HasSubstr("100 points")), Contains(HasSubstr("\"power\"")),
                    Contains(HasSubstr("friction = 0.1"))));
}

TEST_F(MaterialDeckTest, OnlyWhatFitsIsExported) {
  const auto why = [](const Material& material, const char* format) {
    return output::why_no_material_deck(material, {format});
  };
  const Material foam = material_of(some_foam());
  EXPECT_EQ(why(foam, "ls-dyna-083"), "");
  EXPECT_THAT(why(foam, "ls-dyna-063"), HasSubstr("crushable-foam"));
  EXPECT_THAT(why(material_of(Elastic{}), "radioss-90"), HasSubstr("elastic"));
  EXPECT_THAT(why(foam, "radioss-62"), HasSubstr("viscoelastic-foam"));
  EXPECT_THAT(why(foam, "abaqus"), HasSubstr("abaqus"));
  Material weightless = foam;
  weightless.density.reset();
  EXPECT_THAT(why(weightless, "ls-dyna-057"), HasSubstr("density"));
  EXPECT_THROW(output::material_deck(weightless, {"ls-dyna-057"}), std::invalid_argument);
}

TEST_F(MaterialDeckTest, NoTitleBreaksADeck) {
  for (const char* const title :
       {"*END", "$ hidden", "/END", "#include x", "", "two\nlines", "Schaum ä & co"}) {
    Material material = material_of(some_foam());
    material.title = title;
    for (const char* const format : {"ls-dyna-083", "radioss-90"})
      EXPECT_EQ(std::get<Foam>(
                    read(output::material_deck(material, {format, plain_si()}), "kg-m-s")[0].material.law),
                some_foam())
          << title;
  }
}

// --- Cards ---

bool are_equal(const PadLaw& a, const PadLaw& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (std::equality_comparable<Law>) return law == std::get<Law>(b);
        for (const auto& parameter : Law::parameters)
          if (parameter.of(law) != parameter.of(std::get<Law>(b))) return false;
        return true;
      },
      a);
}

TEST_F(MaterialDeckTest, ACardIsReadAsTheSameMaterial) {
  Foam foam = some_foam();
  foam.friction = 0.07;
  foam.recoil = 0.45;
  foam.curves = with_rates(foam.curves, true);
  Foam measured = some_foam();
  measured.unloading_factor = measured.unloading_shape = 1;
  measured.unloading_curve = TableCurve{{0.02, 0.3, 0.6}, {1000, 40e3, 60e3}};
  Foam formula;
  formula.curves = {AvalleCurve{1e5, 3e6, 2, 1e4, 3, 0.75}, 0.004, FactorRateEffect{{0.1, 100}, {1.06, 1.3}}};
  CrushableFoam crushable;
  crushable.unloading_modulus = 1.52e6;
  crushable.curves = {GibsonAshbyCurve{1e6, 5e4, 0, 0.03, 0.8}, 0.01, PowerRateEffect{0.02, 0.01, 200}};
  for (const PadLaw& law :
       {PadLaw(foam), PadLaw(measured), PadLaw(formula), PadLaw(crushable), PadLaw(Elastic{3e5})}) {
    Material material = material_of(law);
    material.name = "card";
    material.title = "A \"quoted\" title";
    material.basis = "test";
    material.licence = "CC0";
    material.reservations = {"One.", "Two."};
    material.density_exponent = 1.5;
    material.temperature_table = {{263.15, 293.15, 313.15}, {1.4, 1, 0.9}};
    material.fitted = FittedRange{0.5, 0.1, 20};
    material.also_published = {{"modulus", "3 MPa"}, {"key with blanks", "1"}};
    const Material again = read_card(output::card_toml(material));
    EXPECT_TRUE(are_equal(again.law, law));
    EXPECT_EQ(again.title, material.title);
    EXPECT_EQ(again.basis, material.basis);
    EXPECT_EQ(again.licence, material.licence);
    EXPECT_EQ(again.density, material.density);
    EXPECT_EQ(again.reservations, material.reservations);
    EXPECT_EQ(again.density_exponent, material.density_exponent);
    EXPECT_EQ(again.temperature_table.temperature, material.temperature_table.temperature);
    EXPECT_EQ(again.temperature_table.factor, material.temperature_table.factor);
    EXPECT_EQ(again.fitted->highest_rate, 20);
    EXPECT_THAT(again.also_published, testing::UnorderedElementsAreArray(material.also_published));
  }
}

TEST_F(MaterialDeckTest, AnImportedMaterialIsACard) {
  const auto all = read(law_90 + radioss_functions);
  const Material again = read_card(output::card_toml(all[0].material));
  EXPECT_TRUE(are_equal(again.law, all[0].material.law));
  EXPECT_EQ(again.reservations, all[0].material.reservations);
}

}  // namespace
}  // namespace dashpad
