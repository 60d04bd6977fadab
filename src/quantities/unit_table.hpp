#pragma once
/// The names of units and of their prefixes, with what they are worth (decision 4).

#include <array>
#include <numbers>
#include <string_view>

namespace dashpad {

/// Exponents of the base units.
struct UnitDimension {
  int m = 0, kg = 0, s = 0, K = 0, A = 0;
  bool operator==(const UnitDimension&) const = default;
};

enum class Prefixes : bool { no, yes };

struct UnitRow {
  std::string_view names;  ///< names separated by blanks
  long double number = 1;  ///< one of it is number times ten to a power, in base units
  int ten = 0;
  UnitDimension dimension;
  Prefixes prefixes = Prefixes::no;
  bool has_offset = false;  ///< a scale whose zero is another: not a multiple of the base unit
};

namespace unit_table {

constexpr UnitDimension none{}, length{.m = 1}, area{.m = 2}, volume{.m = 3}, time{.s = 1}, rate{.s = -1},
    speed{.m = 1, .s = -1}, acceleration{.m = 1, .s = -2}, mass{.kg = 1}, force{.m = 1, .kg = 1, .s = -2},
    stress{.m = -1, .kg = 1, .s = -2}, energy{.m = 2, .kg = 1, .s = -2}, power{.m = 2, .kg = 1, .s = -3},
    temperature{.K = 1}, current{.A = 1}, charge{.s = 1, .A = 1}, voltage{.m = 2, .kg = 1, .s = -3, .A = -1},
    resistance{.m = 2, .kg = 1, .s = -3, .A = -2};

// Whole numbers, so that the only rounding is that of the last division: the inch, the pound and standard
// gravity are exact (NIST Special Publication 811, Appendix B).
constexpr long double pound_force = 44482216152605.0L;  // 1e-13 N

/// Of several names, the first is the one to write.
inline constexpr std::array rows{
    UnitRow{"m metre metres meter meters", 1, 0, length, Prefixes::yes},
    UnitRow{"in inch inches", 254, -4, length},
    UnitRow{"thou mil mils", 254, -7, length},
    UnitRow{"ft foot feet", 3048, -4, length},
    UnitRow{"yd yard yards", 9144, -4, length},
    UnitRow{"mi mile miles", 1609344, -3, length},
    UnitRow{"nautical_mile nautical_miles", 1852, 0, length},
    UnitRow{"micron microns", 1, -6, length},

    UnitRow{"s sec second seconds", 1, 0, time, Prefixes::yes},
    UnitRow{"min minute minutes", 60, 0, time},
    UnitRow{"h hr hour hours", 3600, 0, time},
    UnitRow{"d day days", 86400, 0, time},
    UnitRow{"week weeks", 604800, 0, time},
    UnitRow{"Hz hertz", 1, 0, rate, Prefixes::yes},

    UnitRow{"g gram grams", 1, -3, mass, Prefixes::yes},
    UnitRow{"t tonne tonnes metric_ton metric_tons", 1, 3, mass},
    UnitRow{"lb lbs lbm pound pounds", 45359237, -8, mass},
    UnitRow{"short_ton short_tons", 2 * 45359237.0L, -5, mass},
    UnitRow{"long_ton long_tons", 224 * 45359237.0L, -7, mass},
    UnitRow{"grain grains", 6479891, -11, mass},
    UnitRow{"oz ounce ounces", 28349523125, -12, mass},
    UnitRow{"slug slugs", pound_force / 3048, -9, mass},

    UnitRow{"knot knots", 1852.0L / 3600, 0, speed},
    UnitRow{"mph", 44704, -5, speed},
    UnitRow{"kph kmh", 10.0L / 36, 0, speed},
    UnitRow{"fps", 3048, -4, speed},
    UnitRow{"ips", 254, -4, speed},
    UnitRow{"gravity standard_free_fall", 980665, -5, acceleration},

    UnitRow{"N newton newtons", 1, 0, force, Prefixes::yes},
    UnitRow{"dyn dyne dynes", 1, -5, force},
    UnitRow{"kgf kilogram_force kilograms_force", 980665, -5, force},
    UnitRow{"gf gram_force grams_force", 980665, -8, force},
    UnitRow{"pond ponds", 980665, -8, force, Prefixes::yes},
    UnitRow{"lbf pound_force pounds_force", pound_force, -13, force, Prefixes::yes},
    UnitRow{"ozf ounce_force", pound_force / 16, -13, force},
    UnitRow{"kip kips", pound_force, -10, force},

    UnitRow{"Pa pascal pascals", 1, 0, stress, Prefixes::yes},
    UnitRow{"bar bars", 1, 5, stress, Prefixes::yes},
    UnitRow{"atm atmosphere atmospheres", 101325, 0, stress},
    UnitRow{"psi", pound_force / (254 * 254), -5, stress, Prefixes::yes},
    UnitRow{"ksi", pound_force / (254 * 254), -2, stress},
    UnitRow{"psf", pound_force / (3048 * 3048), -5, stress},

    UnitRow{"J joule joules", 1, 0, energy, Prefixes::yes},
    UnitRow{"erg ergs", 1, -7, energy},
    UnitRow{"W watt watts", 1, 0, power, Prefixes::yes},

    UnitRow{"L l liter liters litre litres", 1, -3, volume, Prefixes::yes},
    UnitRow{"cc", 1, -6, volume},

    UnitRow{"K kelvin kelvins degK", 1, 0, temperature, Prefixes::yes},
    UnitRow{"degC celsius degree_Celsius degrees_Celsius", 1, 0, temperature, Prefixes::no, true},
    UnitRow{"degF fahrenheit degree_fahrenheit degrees_fahrenheit", 10.0L / 18, 0, temperature, Prefixes::no,
            true},

    UnitRow{"A ampere amperes amp amps", 1, 0, current, Prefixes::yes},
    UnitRow{"C coulomb coulombs", 1, 0, charge, Prefixes::yes},
    UnitRow{"V volt volts", 1, 0, voltage, Prefixes::yes},
    UnitRow{"ohm ohms", 1, 0, resistance, Prefixes::yes},

    UnitRow{"rad radian radians", 1, 0, none, Prefixes::yes},
    UnitRow{"deg degree degrees arc_degree", std::numbers::pi_v<long double> / 180, 0, none},
    UnitRow{"% percent", 1, -2, none},
    UnitRow{"ppm", 1, -6, none},
};

struct Prefix {
  std::string_view name;
  int ten;
};
inline constexpr Prefix prefixes[] = {
    {"Y", 24},    {"Z", 21},     {"E", 18},     {"P", 15},     {"T", 12},    {"G", 9},
    {"M", 6},     {"k", 3},      {"h", 2},      {"da", 1},     {"d", -1},    {"c", -2},
    {"m", -3},    {"u", -6},     {"µ", -6},     {"n", -9},     {"p", -12},   {"f", -15},
    {"a", -18},   {"z", -21},    {"y", -24},    {"exa", 18},   {"peta", 15}, {"tera", 12},
    {"giga", 9},  {"mega", 6},   {"kilo", 3},   {"hecto", 2},  {"deka", 1},  {"deca", 1},
    {"deci", -1}, {"centi", -2}, {"milli", -3}, {"micro", -6}, {"nano", -9}, {"pico", -12},
};

/// Names that elsewhere are a unit of another size than many who write them mean.
struct Ambiguous {
  std::string_view names, advice;
};
inline constexpr Ambiguous ambiguous[] = {
    {"ton tons", "write t for 1000 kg, short_ton or long_ton"},
    {"gr", "write g or grain"},
    {"cal calorie calories kcal", "write J; a calorie may be 4.184 or 4.1868 J"},
    {"hp", "write W; a horsepower may be 735.5 or 745.7 W"},
    {"rpm rps", "write 1/s (revolutions per second) or rad/s"},
    {"gal gallon gallons pint quart", "write L or in3; US and British measures differ"},
};

}  // namespace unit_table
}  // namespace dashpad
