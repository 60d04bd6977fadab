#include "quantities/unit_factor.hpp"

#include <udunits2.h>

#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad {
namespace {

struct Deleter {
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
template <class T>
using Owned = std::unique_ptr<T, Deleter>;

/// A unit that the database lacks (lbm), cuts short (slug), rounds (in) or takes for something else: mph and
/// kph for thousandths and thousands of a phot, oz for a fluid ounce.
struct Definition {
  const char* name;
  double factor;
  const char* si_unit;
};

constexpr double inch = 0.0254;                                    // m
constexpr double pound = 0.45359237;                               // kg
constexpr double ounce = 0.028349523125;                           // kg
constexpr double pound_force = 4.4482216152605;                    // N
constexpr double ounce_force = 0.27801385095378125;                // N
constexpr double pound_force_per_square_inch = 6894.757293168361;  // Pa
constexpr double slug = 14.593902937206364;                        // kg
constexpr double degree = std::numbers::pi / 180;                  // rad

constexpr Definition definitions[] = {
    {"in", inch, "m"},
    {"inch", inch, "m"},
    {"inches", inch, "m"},
    {"thou", inch / 1000, "m"},
    {"mil", inch / 1000, "m"},
    {"ft", 0.3048, "m"},
    {"foot", 0.3048, "m"},
    {"feet", 0.3048, "m"},
    {"yd", 0.9144, "m"},
    {"mi", 1609.344, "m"},
    {"mile", 1609.344, "m"},
    {"miles", 1609.344, "m"},
    {"mph", 0.44704, "m/s"},
    {"kph", 1 / 3.6, "m/s"},
    {"kmh", 1 / 3.6, "m/s"},
    {"fps", 0.3048, "m/s"},
    {"ips", inch, "m/s"},
    {"lb", pound, "kg"},
    {"lbs", pound, "kg"},
    {"lbm", pound, "kg"},
    {"pound", pound, "kg"},
    {"pounds", pound, "kg"},
    {"oz", ounce, "kg"},
    {"ounce", ounce, "kg"},
    {"ounces", ounce, "kg"},
    {"slug", slug, "kg"},
    {"slugs", slug, "kg"},
    {"lbf", pound_force, "N"},
    {"ozf", ounce_force, "N"},
    {"kip", 1000 * pound_force, "N"},
    {"kips", 1000 * pound_force, "N"},
    {"dyn", 1e-5, "N"},
    {"psi", pound_force_per_square_inch, "Pa"},
    {"ksi", 1000 * pound_force_per_square_inch, "Pa"},
    {"psf", pound_force / (0.3048 * 0.3048), "Pa"},
    {"deg", degree, "rad"},
};

Owned<ut_unit> parse(const ut_system* system, const char* text) {
  return Owned<ut_unit>(ut_parse(system, text, UT_UTF8));
}

/// Symbols are looked up before the database's prefixes, so that "mph" is no longer milli and phot; names are
/// looked up before symbols, so that an older name has to go.
void define(ut_system* system, const Definition& definition) {
  ut_unmap_name_to_unit(system, definition.name, UT_UTF8);
  ut_unmap_symbol_to_unit(system, definition.name, UT_UTF8);
  const Owned<ut_unit> si_unit = parse(system, definition.si_unit);
  const Owned<ut_unit> unit(ut_scale(definition.factor, si_unit.get()));
  if (!unit || ut_map_symbol_to_unit(definition.name, UT_UTF8, unit.get()) != UT_SUCCESS)
    throw UnitDatabaseError(std::string("UDUNITS-2 did not accept the unit ") + definition.name);
}

Owned<ut_system> read_system() {
  ut_set_error_message_handler(ut_ignore);
  Owned<ut_system> system(ut_read_xml(nullptr));
  if (!system) {
    ut_status status = UT_SUCCESS;
    const char* path = ut_get_path_xml(nullptr, &status);
    throw UnitDatabaseError(std::string("cannot read the units database of UDUNITS-2, ") + path +
                            "; install it, or give its place in UDUNITS2_XML_PATH");
  }
  for (const Definition& definition : definitions) define(system.get(), definition);
  return system;
}

UnitFactor looked_up(const ut_system* system, const std::string& unit, const std::string& si_unit) {
  const Owned<ut_unit> from = parse(system, unit.c_str());
  const Owned<ut_unit> to = parse(system, si_unit.c_str());
  if (!from || !to) return {UnitMatch::unknown};
  const Owned<cv_converter> converter(ut_get_converter(from.get(), to.get()));
  if (!converter || cv_convert_double(converter.get(), 0) != 0) return {UnitMatch::other_dimension};
  return {UnitMatch::same_dimension, cv_convert_double(converter.get(), 1)};
}

constexpr std::size_t most_known = 1000;

}  // namespace

UnitFactor unit_factor(const std::string& unit, const std::string& si_unit) {
  static std::mutex mutex;  // the library parses one text at a time
  const std::lock_guard lock(mutex);
  static const Owned<ut_system> system = read_system();

  // The columns of a table ask for the same units again and again.
  static std::map<std::pair<std::string, std::string>, UnitFactor> known;
  const std::pair asked{unit, si_unit};
  if (const auto found = known.find(asked); found != known.end()) return found->second;
  if (known.size() == most_known) known.clear();
  return known[asked] = looked_up(system.get(), unit, si_unit);
}

}  // namespace dashpad
