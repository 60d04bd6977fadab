// Units as text against UDUNITS-2, which is used nowhere else: every name of ours with every prefix, every
// name of its database, and random products of powers.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <udunits2.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "dashpad/quantities/quantity.hpp"
#include "quantities/unit.hpp"
#include "quantities/unit_table.hpp"

namespace dashpad::test {
namespace {

/// Names that UDUNITS-2 lacks, cuts short, rounds, or takes for something else
/// (docs/decisions/0004-units.md).
const std::set<std::string> corrected{"mph",    "kph", "kmh", "fps",         "ips",  "oz",   "ounce",
                                      "ounces", "lbm", "lbs", "thou",        "kips", "slug", "slugs",
                                      "ozf",    "psf", "dyn", "ounce_force", "deg"};

struct Free {
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

class UnitsAgainstUdunits : public testing::Test {
 protected:
  UnitsAgainstUdunits() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
  }
  void SetUp() override { ASSERT_NE(system_, nullptr); }

  /// Of one `unit` in `si_unit`; nothing where that library does not know it or its dimension is another.
  std::optional<double> factor(const std::string& unit, const std::string& si_unit) {
    const std::unique_ptr<ut_unit, Free> from(ut_parse(system_.get(), unit.c_str(), UT_UTF8));
    const std::unique_ptr<ut_unit, Free> to(ut_parse(system_.get(), si_unit.c_str(), UT_UTF8));
    if (!from || !to) return std::nullopt;
    const std::unique_ptr<cv_converter, Free> converter(ut_get_converter(from.get(), to.get()));
    if (!converter || cv_convert_double(converter.get(), 0) != 0) return std::nullopt;
    return cv_convert_double(converter.get(), 1);
  }

  std::unique_ptr<ut_system, Free> system_;
};

std::vector<std::string> words_of(std::string_view list) {
  std::istringstream words{std::string(list)};
  return {std::istream_iterator<std::string>(words), {}};
}

std::string base_units(const UnitDimension& unit_dimension) {
  std::string text = "1";
  for (const auto& [name, exponent] : std::vector<std::pair<std::string, int>>{{"m", unit_dimension.m},
                                                                               {"kg", unit_dimension.kg},
                                                                               {"s", unit_dimension.s},
                                                                               {"K", unit_dimension.K},
                                                                               {"A", unit_dimension.A}})
    if (exponent != 0) text += (text == "1" ? "" : " ") + name + std::to_string(exponent);
  return text.size() > 1 ? text.substr(1) : text;
}

TEST_F(UnitsAgainstUdunits, EveryNameWithEveryPrefix) {
  int compared = 0;
  for (const UnitRow& row : unit_table::rows)
    for (const std::string& name : words_of(row.names)) {
      if (row.has_offset || corrected.contains(name)) continue;
      const std::string si = base_units(row.dimension);
      std::vector<std::string> spelled{name};
      if (row.prefixes == Prefixes::yes)
        for (const auto& prefix : unit_table::prefixes) spelled.push_back(std::string(prefix.name) + name);
      for (const std::string& unit : spelled) {
        const auto theirs = factor(unit, si);
        // Whole names come first, on both sides: "min" is no inch.
        if (!theirs && unit != name) continue;
        ASSERT_TRUE(theirs) << unit;
        const auto [match, ours] = unit_factor(unit, si);
        EXPECT_EQ(match, UnitMatch::same_dimension) << unit << " in " << si;
        EXPECT_NEAR(ours / *theirs, 1, 4e-15) << unit;
        ++compared;
      }
    }
  EXPECT_GT(compared, 1000);
}

TEST_F(UnitsAgainstUdunits, EveryNameOfTheirsIsTheSameOrIsAnsweredWithOthers) {
  const std::set<std::string> with_a_size_of_our_own{"oz", "slug", "slugs", "ozf", "ounce_force"};
  ut_status status = UT_SUCCESS;
  const std::filesystem::path folder = std::filesystem::path(ut_get_path_xml(nullptr, &status)).parent_path();
  int same = 0, refused = 0;
  for (const char* part : {"base", "derived", "accepted", "common"}) {
    std::ifstream file(folder / (std::string("udunits2-") + part + ".xml"));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(text.empty()) << folder << part;
    const std::regex name_in("<(symbol|singular|plural)[^>]*>([A-Za-z_%]+)</");
    for (std::sregex_iterator found(text.begin(), text.end(), name_in), end; found != end; ++found) {
      const std::string name = (*found)[2];
      for (const char* si : {"m", "m2", "m3", "s", "1/s", "kg", "m/s", "m/s2", "N", "Pa", "J", "W", "K", "V",
                             "A", "C", "ohm", "1"}) {
        const auto theirs = factor(name, si);
        if (!theirs || with_a_size_of_our_own.contains(name)) continue;
        const auto [match, ours] = unit_factor(name, si);
        if (match == UnitMatch::same_dimension) {
          EXPECT_NEAR(ours / *theirs, 1, 4e-15) << name;
          ++same;
        } else {
          EXPECT_EQ(match, UnitMatch::unknown) << name << " in " << si;
          ++refused;
          try {
            ADD_FAILURE() << to_si("1 " + name, si);
          } catch (const UnitError& error) {
            EXPECT_THAT(error.what(),
                        testing::AnyOf(testing::HasSubstr("; use "), testing::HasSubstr("write ")));
          }
        }
      }
    }
  }
  EXPECT_GT(same, 80);
  EXPECT_LT(refused, 320);
}

TEST_F(UnitsAgainstUdunits, RandomProductsOfPowers) {
  const std::vector<std::pair<std::string, std::string>> units{
      {"mm", "m"},   {"in", "m"},           {"ft", "m"},  {"ms", "s"},   {"h", "s"},    {"g", "kg"},
      {"lb", "kg"},  {"kN", "N"},           {"lbf", "N"}, {"MPa", "Pa"}, {"psi", "Pa"}, {"mJ", "J"},
      {"mV", "V"},   {"arc_degree", "rad"}, {"kgf", "N"}, {"µs", "s"},   {"L", "m3"},   {"mile", "m"},
      {"Hz", "1/s"}, {"t", "kg"},           {"K", "K"}};
  std::mt19937 random(36);
  const auto one_of = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  for (int i = 0; i < 3000; ++i) {
    std::string text, si;
    const int parts = 1 + one_of(4);
    for (int part = 0; part < parts; ++part) {
      const auto& [unit, base] = units[static_cast<std::size_t>(one_of(static_cast<int>(units.size())))];
      if (part > 0) {
        std::string sign = std::vector<std::string>{
            " ", "/", ".", "*", " / ", "·", " per "}[static_cast<std::size_t>(one_of(7))];
        // UDUNITS-2 takes the "-1." of "s-1.m" for a number.
        if (sign == "." && std::isdigit(static_cast<unsigned char>(text.back())) != 0) sign = " ";
        text += sign, si += sign;
      }
      const int exponent = one_of(7) - 3;
      const std::string raised = exponent == 0    ? ""
                                 : one_of(2) == 0 ? std::to_string(exponent)
                                                  : "^" + std::to_string(exponent);
      const bool is_bracketed = one_of(4) == 0;
      text += (is_bracketed ? "(" + unit + ")" : unit) + raised;
      si += "(" + base + ")" + raised;
    }
    const auto theirs = factor(text, si);
    ASSERT_TRUE(theirs) << text << " in " << si;
    const auto [match, ours] = unit_factor(text, si);
    EXPECT_EQ(match, UnitMatch::same_dimension) << text << " in " << si;
    EXPECT_NEAR(ours / *theirs, 1, 2e-14) << text << " in " << si;
  }
}

}  // namespace
}  // namespace dashpad::test
