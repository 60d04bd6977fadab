/// Quantities at the door: exact factors, units that other programs take for something else, bad text.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad {
namespace {

struct Good {
  std::string text;
  std::string si_unit;
  double value;
};

/// Factors: NIST Special Publication 811 (2008), Appendix B; those of pound, foot, inch and mile are exact.
const std::vector<Good> good{
    {"20 mph", "m/s", 8.9408},
    {"20mph", "m/s", 8.9408},
    {"  20  mph  ", "m/s", 8.9408},
    {"+20 mph", "m/s", 8.9408},
    {"2e1 mph", "m/s", 8.9408},
    {"1 mile/hour", "m/s", 0.44704},
    {"1 mi/h", "m/s", 0.44704},
    {"36 km/h", "m/s", 10},
    {"36 kph", "m/s", 10},
    {"1 ft/s", "m/s", 0.3048},
    {"1 in/s", "m/s", 0.0254},
    {"1 m s-1", "m/s", 1},
    {"1 m.s^-1", "m/s", 1},
    {"1 m\u00b7s\u207b\u00b9", "m/s", 1},
    {"1 in", "m", 0.0254},
    {"1 inch", "m", 0.0254},
    {"2 inches", "m", 0.0508},
    {"1 ft", "m", 0.3048},
    {"1 yd", "m", 0.9144},
    {"1 mile", "m", 1609.344},
    {"1 mil", "m", 0.0000254},
    {".5 mm", "m", 0.0005},
    {"3 \u00b5m", "m", 3e-6},
    {"3 \u03bcm", "m", 3e-6},
    {"1 lb", "kg", 0.45359237},
    {"1 lbs", "kg", 0.45359237},
    {"1 lbm", "kg", 0.45359237},
    {"1 pound", "kg", 0.45359237},
    {"1 oz", "kg", 0.028349523125},
    {"1 g", "kg", 0.001},
    {"1 slug", "kg", 14.593902937206365},
    {"1 tonne", "kg", 1000},
    {"1 lbf", "N", 4.4482216152605},
    {"1 ozf", "N", 0.27801385095378125},
    {"1 kip", "N", 4448.2216152605},
    {"1 kgf", "N", 9.80665},
    {"1 kilopond", "N", 9.80665},
    {"1 dyn", "N", 1e-5},
    {"1 lbf/in", "N/m", 175.12683524647636},
    {"1 kN/cm", "N/m", 1e5},
    {"1 N/mm", "N/m", 1000},
    {"1e3 N/m", "N/m", 1000},
    {"1e3N/m", "N/m", 1000},
    {"1 psi", "Pa", 6894.7572931683613},
    {"1 lbf/in2", "Pa", 6894.7572931683613},
    {"1 lbf/in^2", "Pa", 6894.7572931683613},
    {"1 ksi", "Pa", 6894757.2931683613},
    {"1 psf", "Pa", 47.880258980335840},
    {"1 MPa", "Pa", 1e6},
    {"1 N/mm2", "Pa", 1e6},
    {"1 kgf/cm2", "Pa", 98066.5},
    {"1 kgf/cm\u00b2", "Pa", 98066.5},
    {"1 bar", "Pa", 1e5},
    {"1 ms", "s", 0.001},
    {"9.76e-6 s", "s", 9.76e-6},
    {"1 1/s", "1/s", 1},
    {"1 /s", "1/s", 1},
    {"1 s-1", "1/s", 1},
    {"1 1/ms", "1/s", 1000},
    {"1 in lbf", "J", 0.11298482902761668},
    {"1 gravity", "m/s2", 9.80665},
    {"0.95", "1", 0.95},
    {"95 %", "1", 0.95},
    {"23 \u00b0C", "K", 296.15},
    {"73.4 \u00b0F", "K", 296.15},
    {"1 kJ/(kg \u00b0C)", "J/(kg K)", 1000},
    {"1 m per s", "m/s", 1},
    {"1 kpsi", "Pa", 6894757.2931683613},
    {"3 m^+1", "m", 3},
    {"90 deg", "rad", 1.5707963267948966},
    {"2 (N s)/m", "N s/m", 2},
    {"1 N s / mm", "N s/m", 1000},
    {"-3 in", "m", -0.0762},
};

TEST(quantity, is_read_to_rounding) {
  for (const auto& [text, si_unit, value] : good)
    EXPECT_LE(std::abs(to_si(text, si_unit) / value - 1), 1e-15) << text << " gives " << to_si(text, si_unit);
}

TEST(quantity, the_speed_of_the_example_is_exact) { EXPECT_EQ(to_si("20 mph", "m/s"), 8.9408); }

TEST(quantity, goes_back_to_its_unit) {
  EXPECT_DOUBLE_EQ(from_si(8.9408, "m/s", "mph"), 20);
  EXPECT_DOUBLE_EQ(from_si(4.4482216152605, "N", "lbf"), 1);
  EXPECT_EQ(from_si(0.95, "1", "1"), 0.95);
  EXPECT_DOUBLE_EQ(from_si(0.95, "1", "%"), 95);
  EXPECT_THROW(from_si(1, "N", "lb"), UnitError);
  EXPECT_THROW(from_si(1, "N", "furlng"), UnitError);
}

struct BadText {
  std::string text;
  std::string si_unit;
  std::string rule;  ///< part of the message
};

const std::vector<BadText> bad_texts{
    {"20", "m/s", "a speed needs a unit, as in \"20 m/s\", \"20 km/h\", \"20 mph\""},
    {"", "m/s", "a speed must start with a number, as in \"20 m/s\""},
    {"mph", "m/s", "a speed must start with a number"},
    {"fast", "m/s", "a speed must start with a number"},
    {"3 in", "m/s", "a speed is needed (m/s, km/h, mph, in/s), but \"in\" denotes a length"},
    {"10 lb", "N",
     "a force is needed (N, kN, lbf, kgf), but \"lb\" denotes a mass; lb and kg are units of mass"},
    {"600 lb/in", "N/m", "lb and kg are units of mass, and lbf, kgf and N are units of force"},
    {"1 g", "m/s2", "but \"g\" denotes a mass"},
    {"5 s", "1/s", "but \"s\" denotes a time"},
    {"5 Hz", "s", "but \"Hz\" denotes a rate"},
    {"5 mm/N", "N/m", "a stiffness is needed"},
    {"5 m", "1", "a pure number is needed, but \"m\" denotes a length"},
    {"5", "m4", "a value in m4 needs a unit"},
    {"20 m", "K", "a temperature is needed"},
    {"20 degC", "Pa", "is needed"},
    {"20 lg(re Pa)", "Pa", "unknown unit"},
    {"2 ton", "kg", "\"ton\" is ambiguous: write t for 1000 kg"},
    {"20 kin", "m", "unknown unit \"kin\""},
    {"20 m/s)", "m/s", "unknown unit"},
    {"20 m9999", "m", "unknown unit"},
    {"20 ((((m99)99)99)99)99", "m", "unknown unit"},
    {"20 1/degC", "K", "a temperature is needed"},
    {"20 MPH", "m/s", "did you mean mph?"},
    {"20 Mph", "m/s", "did you mean mph?"},
    {"20 furlngs", "m", "unknown unit \"furlngs\"; use m, mm, in, ft"},
    {"20 m/", "m", "unknown unit"},
    {"20 ((((", "m", "unknown unit"},
    {"1,5 in", "m", "decimal point"},
    {"1,500 lbf", "N", "decimal point"},
    {"20 3 mph", "m/s", "one number and one unit are needed, but \"3 mph\" contains another number"},
    {"1 000 N", "N", "contains another number"},
    {"20 in 3", "m", "contains another number"},
    {"20 m*2", "m", "contains another number"},
    {"20 m since 2000", "m", "contains another number"},
    {"20 m @ 3", "m", "is not a unit"},
    {"20 m - in", "m", "is not a unit"},
    {"3\"", "m", "is not a unit"},
    {"1'000 m", "m", "is not a unit"},
    {"nan m", "m", "a finite number"},
    {"inf m", "m", "a finite number"},
    {"-inf m", "m", "a finite number"},
    {"1e400 m", "m", "too large or too small"},
    {"1e-400 m", "m", "too large or too small"},
    {"1e308 km", "m", "too large"},
    {std::string(101, '1'), "m", "longer than 100 characters"},
    {std::string(1'000'000, 'm'), "m", "longer than 100 characters"},
    {std::string("20 m\0", 5), "m", "a control character"},
};

TEST(quantity, bad_text_is_refused_with_the_rule) {
  for (const auto& [text, si_unit, rule] : bad_texts) {
    try {
      ADD_FAILURE() << text.substr(0, 40) << " was read as " << to_si(text, si_unit);
    } catch (const UnitError& error) {
      EXPECT_NE(std::string(error.what()).find(rule), std::string::npos)
          << text.substr(0, 40) << ": " << error.what();
    }
  }
}

TEST(quantity, examples_are_units_of_their_dimension) {
  EXPECT_EQ(examples_of_units("m/s"), "m/s, km/h, mph, in/s");
  EXPECT_EQ(examples_of_units("m4"), "m4");
  for (const std::string si_unit :
       {"m", "m/s", "m/s2", "s", "1/s", "kg", "N", "N/m", "Pa", "J", "N s", "kg/m3"}) {
    const std::string list = examples_of_units(si_unit) + ", ";
    for (std::size_t start = 0, end = 0; (end = list.find(", ", start)) != std::string::npos; start = end + 2)
      EXPECT_GT(to_si("1 " + list.substr(start, end - start), si_unit), 0) << list.substr(start, end - start);
  }
}

}  // namespace
}  // namespace dashpad
