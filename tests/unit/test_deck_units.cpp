// Units that a deck states, and those that the user gives for it.

#include "sample_decks.hpp"

namespace dashpad::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string in_kg_mm_ms = fields_of_20({"kg", "mm", "ms"});

std::string begin_with(const std::string& input, const std::string& work = "") {
  return "/BEGIN\nrun\n      2022         0\n" + input + work;
}

std::string control_units(const std::string& line) { return "*CONTROL_UNITS\n" + line + "\n"; }

TEST_F(DeckTest, UnitsThatTheDeckStatesAreUsed) {
  const auto expect = [&](const std::string& statement, const std::string& deck, const char* system,
                          const char* line) {
    const auto stated = only(statement + deck, ""), given = only(deck, system);
    EXPECT_EQ(stated.units, fmt::format("{}, as the deck states on line {}", system, line));
    EXPECT_THAT(stated.material.source, HasSubstr("; units " + stated.units + ")"));
    EXPECT_EQ(stated.material.density, given.material.density);
    EXPECT_EQ(stresses_of(stated), stresses_of(given));
    EXPECT_EQ(given.units, system);
  };
  const std::string radioss = foam_33() + function_8, ls_dyna = foam_57 + curve_31;
  expect(begin_with(in_kg_mm_ms, in_kg_mm_ms), radioss, "kg-mm-ms", "4");
  expect(begin_with(fields_of_20({"Mg", "mm", "s"})), radioss, "t-mm-s", "4");
  expect(begin_with(fields_of_20({"0.001", "0.01", "1e-6"})), radioss, "g-cm-us", "4");
  expect(begin_with(fields_of_20({"g", "cm", "mus"})), radioss, "g-cm-us", "4");
  expect(begin_with(fields_of_20({"175.126835246476", "0.0254", "1"})), radioss, "lbf-s2/in-in-s", "4");
  expect(begin_with("\n", in_kg_mm_ms), radioss, "kg-mm-ms", "5");
  expect(control_units("        mm        ms        kg         K"), ls_dyna, "kg-mm-ms", "2");
  expect(control_units("mm,sec,mtrc_ton"), ls_dyna, "t-mm-s", "2");
  expect(control_units("in,sec,slinch"), ls_dyna, "lbf-s2/in-in-s", "2");
  expect(control_units("CM,MICRO_S,G"), ls_dyna, "g-cm-us", "2");
  expect(control_units(",sec"), ls_dyna, "kg-m-s", "2");
}

TEST_F(DeckTest, SystemsInGramsAreConsistent) {
  EXPECT_DOUBLE_EQ(*only(foam_57 + curve_31, "g-mm-ms").material.density, 6e-5);
  EXPECT_THAT(stresses_of(only(foam_57 + curve_31, "g-mm-ms")), ElementsAre(20e3, 30e3, 110e3));
  EXPECT_DOUBLE_EQ(*only("*MAT_057\n1,0.09,4,31,,0.1\n5\n" + curve_31, "g-cm-us").material.density, 90);
  EXPECT_DOUBLE_EQ(stresses_of(only(foam_57 + "*DEFINE_CURVE\n31,,,1e-5\n" + rows_31, "g-cm-us")).front(),
                   20e3);
}

TEST_F(DeckTest, UnitsOfADeckThatContradictThoseGivenAreOneFault) {
  EXPECT_THAT(
      faults(begin_with(in_kg_mm_ms) + foam_33("7") + foam_33("9") + function_8),
      ElementsAre("4: units = kg, mm, ms: are those of kg-mm-ms, but --units is t-mm-s; leave out --units to "
                  "use what the deck states"));
  EXPECT_THAT(faults(control_units("m,sec,kg") + foam_57 + curve_31),
              ElementsAre(HasSubstr("2: units = kg, m, sec: are those of kg-m-s, but --units is t-mm-s")));
  const std::string mixed = begin_with(fields_of_20({"g", "mm", "s"})) + foam_33() + function_8;
  EXPECT_THAT(faults(mixed), ElementsAre("4: units = g, mm, s: are not those of --units t-mm-s"));
  EXPECT_THAT(faults(mixed, ""),
              ElementsAre(HasSubstr("are those of no system that can be read: kg-mm-ms, kg-m-s")));
}

TEST_F(DeckTest, StatementsOfUnitsThatContradictEachOtherAreOneFault) {
  const std::string ls_dyna = foam_57 + curve_31, radioss = foam_33("7") + foam_33("9") + function_8;
  const std::string in_mm_ms = control_units("mm,ms,kg"), in_mm_s = control_units("mm,sec,mtrc_ton");
  for (const char* const given : {"", "kg-mm-ms", "t-mm-s"})
    EXPECT_THAT(faults(in_mm_ms + in_mm_s + ls_dyna, given),
                ElementsAre("4: units = mtrc_ton, mm, sec: contradict kg, mm, ms on line 2"));
  EXPECT_EQ(only(in_mm_s + control_units("mm,s,t") + ls_dyna, "").units,
            "t-mm-s, as the deck states on line 2");
  const std::string in_t_mm_s = fields_of_20({"Mg", "mm", "s"});
  EXPECT_THAT(faults(begin_with(in_kg_mm_ms) + begin_with(in_t_mm_s) + radioss, ""),
              ElementsAre("8: units = Mg, mm, s: contradict kg, mm, ms on line 4"));
  EXPECT_THAT(faults(begin_with(in_t_mm_s) + begin_with(in_t_mm_s) + radioss, ""), ElementsAre());
}

TEST_F(DeckTest, UnitsThatNobodyStatesAreAskedFor) {
  for (const std::string& deck : {foam_57 + curve_31, foam_33() + function_8,
                                  begin_with(fields_of_20({"1", "1.0", "1"})) + foam_33() + function_8,
                                  std::string("*MATERIAL, NAME=F\n*HYPERFOAM, N=1\n0.03,6,0\n")})
    EXPECT_THAT(faults(deck, ""),
                ElementsAre(" --units: is required, as in --units t-mm-s; the deck does not state "
                            "its units"))
        << deck;
  EXPECT_EQ(only(begin_with(fields_of_20({"1", "1", "1"})) + foam_33() + function_8, "kg-mm-ms").units,
            "kg-mm-ms");
  // What is missing beside the units is said first.
  EXPECT_THAT(faults("*KEYWORD\n*END\n", ""), ElementsAre(HasSubstr("contains no *MAT_057")));
}

TEST_F(DeckTest, UnitsThatAreNotKnownAreNamed) {
  const std::string ls_dyna = control_units("furlong,s,kg") + foam_57 + curve_31,
                    radioss = begin_with(fields_of_20({"XX", "mm", "s"})) + foam_33("7") + foam_33("9") +
                              function_8;
  EXPECT_THAT(
      faults(ls_dyna, ""),
      ElementsAre("2: units = kg, furlong, s: furlong is not a unit of length that is known; give the "
                  "units, as in --units t-mm-s"));
  EXPECT_THAT(
      faults(radioss, ""),
      ElementsAre("4: units = XX, mm, s: XX is not a unit of mass that is known; give the units, as in "
                  "--units t-mm-s"));
  EXPECT_THAT(faults(begin_with(fields_of_20({"kg", "m", "0"})) + foam_33() + function_8, ""),
              ElementsAre(HasSubstr("0 is not a unit of time")));
  EXPECT_EQ(only(ls_dyna).units, "t-mm-s");
  EXPECT_EQ(reading(radioss).value().front().units, "t-mm-s");
}

TEST_F(DeckTest, AMaterialWithUnitsOfItsOwnIsReadInThem) {
  const std::string own = "/UNIT/2\nof the foam\n" + fields_of_20({"Mg", "mm", "s"});
  const std::string deck = begin_with(fields_of_20({"kg", "m", "s"})) + own + foam_33("7/2") + function_8;
  EXPECT_EQ(only(deck, "").units, "t-mm-s, as the deck states on line 7");
  EXPECT_EQ(only(deck).units, "t-mm-s");
  EXPECT_EQ(*only(deck, "").material.density, 90);
  EXPECT_THAT(stresses_of(only(deck, "")), ElementsAre(0.2e6, 0.3e6, 0.5e6));
  const auto both = reading(deck + foam_33("9", "90"), "").value();
  ASSERT_EQ(both.size(), 2);
  EXPECT_EQ(*both[0].material.density, 90);
  EXPECT_EQ(*both[1].material.density, 90);
  EXPECT_THAT(stresses_of(both[1]), ElementsAre(0.2, 0.3, 0.5));
  EXPECT_THAT(faults(foam_33("7/3") + function_8, ""),
              ElementsAre("1: /MAT/LAW33: unit = 3: there is no /UNIT/3"));
  EXPECT_EQ(only(foam_33("7/3") + function_8).units, "t-mm-s");
}

}  // namespace
}  // namespace dashpad::test
