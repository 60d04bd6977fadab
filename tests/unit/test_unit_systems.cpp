// The table of unit systems against the units database and the definitions of the units.

#include <cctype>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {
namespace {

TEST(ConsistentUnits, NeedNoFactorInAnyEquation) {
  for (const UnitSystem& u : consistent_systems()) {
    const auto si = [](const std::string& unit, const char* given) { return to_si("1 " + unit, given); };
    const double mass = si(u.mass, "kg"), length = si(u.length, "m"), time = si(u.time, "s");
    const double force = mass * length / (time * time);
    const auto expect = [&](double actual, double expected) {
      EXPECT_NEAR(actual / expected, 1, 4e-16 * 4) << u.name;
    };
    expect(si(u.speed, "m/s"), length / time);
    expect(si(u.acceleration, "m/s2"), length / (time * time));
    expect(si(u.force, "N"), force);
    expect(si(u.stiffness, "N/m"), force / length);
    expect(si(u.pressure, "Pa"), force / (length * length));
    expect(si(u.energy, "J"), force * length);
  }
}

TEST(ConsistentUnits, AreTheTripleOfRadioss) {
  // Codes are a prefix and a unit (k, M, m and g, m, s); a number is in kg, m or s.
  for (const UnitSystem& u : consistent_systems()) {
    output::CurveFile file;
    file.units = u;
    const std::string text = output::radioss_text(file), before = "as in /BEGIN: ";
    ASSERT_NE(text.find(before), std::string::npos);
    std::istringstream triple(text.substr(text.find(before) + before.size()));
    std::string mass, length, time;
    triple >> mass >> length >> time;
    const auto value = [](const std::string& unit, const char* si_unit) {
      return std::isdigit(static_cast<unsigned char>(unit[0])) ? std::stod(unit)
                                                               : to_si("1 " + unit, si_unit);
    };
    EXPECT_NEAR(value(mass, "kg") / to_si("1 " + u.mass, "kg"), 1, 1e-14);
    EXPECT_EQ(value(length, "m"), to_si("1 " + u.length, "m"));
    EXPECT_EQ(value(time, "s"), to_si("1 " + u.time, "s"));
  }
}

TEST(ConsistentUnits, HaveTheKnownFactors) {
  const UnitSystem& crash = consistent_system("kg-mm-ms");
  EXPECT_DOUBLE_EQ(value_in(crash, 1, "N"), 1e-3);
  EXPECT_DOUBLE_EQ(value_in(crash, 1, "m/s"), 1);
  EXPECT_DOUBLE_EQ(value_in(crash, 1, "m/s2"), 1e-3);
  const UnitSystem& inches = consistent_system("lbf-s2/in-in-s");
  EXPECT_NEAR(value_in(inches, 1, "N"), 1 / 4.4482216152605, 1e-15);
  EXPECT_NEAR(value_in(inches, 1, "m/s2") * standard_gravity, 386.0885826771654, 1e-12);
  EXPECT_THROW(consistent_system("furlong-stone-fortnight"), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
