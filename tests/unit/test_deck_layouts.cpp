// Lines and blocks of decks that stand differently from one program to the other.

#include "sample_decks.hpp"

namespace dashpad::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string tests_of_abaqus =
    "*UNIAXIAL TEST DATA,\nDIRECTION=TENSION\n0,0,0,0.01\n9,0.5,0,0.01\n"
    " *UNIAXIAL TEST DATA, DIRECTION=COMPRESSION\n"
    "0,0,0,0.01\n0.02,0.1,0,0.01\n0.03,0.4,0,0.01\n0.11,0.7,0,0.01\n";

TEST_F(DeckTest, KeywordsOfAbaqusMayBeIndentedOrGoOn) {
  const std::string deck =
      "  *HEADING\nFoam cube\n *MATERIAL,  NAME = \"Seat foam\"\n\t*DENSITY\n6e-11\n"
      "*LOW DENSITY FOAM, RATE EXTRAPOLATION=YES,\n  LATERAL STRAIN DATA=YES,\n** a comment\n "
      "FAIL=NO\n1e-4,5e-3,2.\n" +
      tests_of_abaqus;
  const auto found = only(deck);
  EXPECT_EQ(found.material.title, "Seat foam");
  EXPECT_EQ(found.line, 6);
  EXPECT_DOUBLE_EQ(*found.material.density, 60);
  EXPECT_THAT(stresses_of(found), ElementsAre(20e3, 30e3, 110e3));
  EXPECT_EQ(std::get<Foam>(found.material.law).curves.slowest_rate, 0.01);
  EXPECT_FALSE(input::is_stress_table(folder_.write("indented.inp", deck)));
  EXPECT_TRUE(input::is_stress_table(folder_.write("table.txt", " * strain, stress\n0.1,20\n")));
  // A keyword ends at the next one, also behind a comma.
  EXPECT_THAT(
      stresses_of(only("*MATERIAL, NAME=F,\n*LOW DENSITY FOAM, LATERAL STRAIN DATA=YES\n" + tests_of_abaqus)),
      SizeIs(3));
}

TEST_F(DeckTest, OtherMaterialsOfAbaqusAreNamedOnce) {
  EXPECT_THAT(faults("*MATERIAL, NAME=F\n*DENSITY\n5e-11\n*ELASTIC\n3,0\n*CRUSHABLE FOAM, "
                     "HARDENING=VOLUMETRIC\n1.1,0.1\n"
                     "*CRUSHABLE FOAM HARDENING\n0.2,0\n*MATERIAL, NAME=G\n*ELASTIC\n3,0\n"),
              ElementsAre(" contains no Abaqus *LOW DENSITY FOAM or *HYPERFOAM; it contains *ELASTIC, "
                          "*CRUSHABLE FOAM"));
}

std::string move_of_function(const std::string& number, std::initializer_list<const char*> fields) {
  return "/MOVE_FUNCT/" + number + "\nmove\n# Ascalex Fscaley Ashiftx Fshifty\n" + fields_of_20(fields);
}

TEST_F(DeckTest, MovesOfFunctionsAreApplied) {
  const auto moved = [&](const std::string& moves) {
    return std::get<TableCurve>(
        std::get<CrushableFoam>(only(foam_33() + moves + function_8).material.law).curves.base);
  };
  const TableCurve plain{{0.1, 0.5, 0.7}, {0.2e6, 0.3e6, 0.5e6}};
  const std::string function_9 = "/FUNCT/9\nother\n" + fields_of_20({"0", "0"});
  EXPECT_EQ(moved(function_9 + move_of_function("9", {"1", "2", "0", "0"})), plain) << "another function";
  EXPECT_EQ(moved(move_of_function("8", {"0", "", "0", ""})), plain) << "a scale of 0 is 1";
  EXPECT_EQ(moved(move_of_function("8", {"1", "2", "0", "0"})),
            (TableCurve{{0.1, 0.5, 0.7}, {0.4e6, 0.6e6, 1e6}}));
  // Scaled first and shifted afterwards, one move after the other.
  const TableCurve twice = moved(move_of_function("8", {"0.5", "2", "-0.05", "0.1"}) +
                                 move_of_function("8", {"1", "0.5", "0", "0"}));
  const std::vector<double> strain{0.1, 0.3, 0.4}, stress{0.25e6, 0.35e6, 0.55e6};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(twice.strain.at(twice.strain.size() - 3 + i), strain[i], 1e-12);
    EXPECT_NEAR(twice.stress.at(twice.stress.size() - 3 + i), stress[i], 1e-6);
  }
  EXPECT_THAT(faults(foam_33() + move_of_function("8", {"x"}) + function_8),
              ElementsAre("10: move of function 8: Ascalex = x: is not a number (columns 1 to 20)"));
}

TEST_F(DeckTest, AMoveOfNoFunctionIsAFault) {
  const std::string deck = foam_33() + function_8;
  EXPECT_THAT(faults(deck + move_of_function("9", {"1", "2"}) + move_of_function("9", {"1", "3"})),
              ElementsAre("13: /MOVE_FUNCT/9: there is no /FUNCT/9"));
  for (const char* const number : {"x", "1.5", "0", ""})
    EXPECT_THAT(faults(deck + move_of_function(number, {"1", "2"})),
                ElementsAre(HasSubstr("must have the number of a function, as in /MOVE_FUNCT/3")))
        << number;
  EXPECT_THAT(faults(deck + "#include functions.inc\n" + move_of_function("9", {"1", "2"})), IsEmpty())
      << "it may be in that file";
  EXPECT_THAT(faults(deck + "/FUNCT_SMOOTH/9\nsmooth\n" + move_of_function("9", {"1", "2"})), IsEmpty());
}

/// A function of compression becomes one of LAW33, in which compression is negative.
TEST_F(DeckTest, AMoveMayMirrorAFunction) {
  const std::string mirrored = "/FUNCT/8\ncompression\n" + fields_of_20({"0", "0"}) +
                               fields_of_20({"0.1", "0.2"}) + fields_of_20({"0.5", "0.3"}) +
                               fields_of_20({"0.7", "0.5"});
  EXPECT_EQ(stresses_of(only(foam_33() + mirrored + move_of_function("8", {"-1", "1"}))),
            (std::vector<double>{0.2e6, 0.3e6, 0.5e6}));
}

TEST_F(DeckTest, AMoveThatBreaksARuleIsOneFaultThatNamesIt) {
  EXPECT_THAT(faults(foam_33() + function_8 + move_of_function("8", {"2", "1"})),
              ElementsAre("10: function 8 after /MOVE_FUNCT/8: strain = 1: must be less than 1, at which no "
                          "thickness is left; is it in per cent?"));
}

TEST_F(DeckTest, FunctionsOfOtherKindsAreNamed) {
  EXPECT_THAT(faults(foam_33() + "/FUNCT_SMOOTH/8\nsmooth\n" + fields_of_20({"1", "1"})),
              ElementsAre(HasSubstr("fct_IDf = 8: function 8 is a /FUNCT_SMOOTH; only /FUNCT is read")));
}

/// A foam of LAW90 with function 8 at two rates, and that function.
std::string foam_90_at_two_rates() {
  const std::string row = "         8{:>20}                   0\n";
  return "/MAT/LAW90/7\nFoam\n" + fields_of_20({"6E-11"}) + fields_of_20({"0.5", "0"}) +
         "         2         0                   0                   5                 0.1\n" +
         fmt::format(fmt::runtime(row), "0.01") + fmt::format(fmt::runtime(row), "1") + "/FUNCT/8\nsoft\n" +
         fields_of_20({"-0.5", "-0.3"}) + fields_of_20({"0", "0"}) + fields_of_20({"0.1", "0.02"}) +
         fields_of_20({"0.4", "0.03"}) + fields_of_20({"0.7", "0.11"});
}

TEST_F(DeckTest, AFunctionThatServesTwoRatesHasItsDifferencesOnce) {
  const auto found = only(foam_90_at_two_rates());
  std::vector<std::string> cuts;
  for (const std::string& difference : found.differences)
    if (difference.find("left out") != std::string::npos) cuts.push_back(difference);
  EXPECT_THAT(cuts, ElementsAre("function 8: 1 point in tension was left out."));
}

TEST_F(DeckTest, AFunctionThatServesTwoRatesHasItsFaultsOnce) {
  EXPECT_THAT(faults(foam_90_at_two_rates() + fields_of_20({"1.5", "0.2"}) + fields_of_20({"0.6", "0.2"})),
              ElementsAre(HasSubstr("15: function 8: strain = 1.5: must be less than 1"),
                          HasSubstr("16: function 8: strain = 0.6: must be more than the previous strain")));
  EXPECT_THAT(
      faults(foam_90_at_two_rates() + move_of_function("8", {"3", "1"})),
      ElementsAre(HasSubstr("13: function 8 after /MOVE_FUNCT/8: strain = 1.2: must be less than 1")));
}

}  // namespace
}  // namespace dashpad::test
