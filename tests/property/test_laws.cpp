/// What every law whose columns have one stress must keep, whatever its parameters: a table of properties,
/// each with sample parameters and with every card in materials/ that has this law. A new law in the lists of
/// samples.hpp, or a new card, inherits all of it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

template <class Law>
struct Row {
  std::string name;
  Law law;
};

template <class Law>
std::vector<Row<Law>> rows() {
  std::vector<Row<Law>> result{{std::string(Law::name) + " sample", sample_law<Law>()}};
  for (const auto& card : input::list_materials(material_folder).value()) {
    const Material material = input::read_material(card).value();
    if (const Law* law = std::get_if<Law>(&material.law)) result.push_back({material.name, *law});
  }
  return result;
}

const std::vector<double> strains{1e-9, 1e-6, 1e-3, 0.05, 0.2,  0.4,   0.55,
                                  0.6,  0.7,  0.8,  0.9,  0.97, 0.999, 1 - 1e-9};
const std::vector<double> rates{1e-6, 1e-2, 1.0, 10.0, 60.0, 300.0, 2000.0};

template <class Law>
class LawTable : public testing::Test {
 protected:
  template <class Check>
  static void for_each_row(Check&& check) {
    for (const Row<Law>& row : rows<Law>()) {
      SCOPED_TRACE(row.name);
      check(row.law);
    }
  }
};
TYPED_TEST_SUITE(LawTable, LawsOfTheReport);

template <class... Laws>
std::size_t all_rows(const testing::Types<Laws...>&) {
  return (rows<Laws>().size() + ...);
}

TEST(LawTableOfCards, HasEveryCard) {
  const std::size_t samples = std::variant_size_v<PadLaw>;
  EXPECT_EQ(all_rows(AllLaws()), samples + input::list_materials(material_folder).value().size());
}

TYPED_TEST(LawTable, HasNoStressWithoutStrain) {
  this->for_each_row([](const auto& law) {
    EXPECT_EQ(envelope_at(law, 0, 0, 0), 0);
    // A column that has just been touched: its stress comes from strain alone, but for the crush stress of a
    // foam.
    if constexpr (!std::is_same_v<TypeParam, RigidFoam>) {
      for (const double rate : rates) {
        Column<TypeParam> column(law, 1e-3);
        column.go(1e-12, 1e-3 + 1e-12 / rate);
        const double touched = column.stress();
        column.go(0.5, 1e-3 + 0.5 / rate);
        EXPECT_GE(touched, 0);
        EXPECT_LT(touched, 1e-7 * column.stress()) << "rate " << rate;
      }
    }
  });
}

TYPED_TEST(LawTable, GrowsWithStrainOnLoading) {
  this->for_each_row([](const auto& law) {
    for (const double rate : rates)
      for (std::size_t i = 1; i < strains.size(); ++i)
        EXPECT_GE(envelope_at(law, strains[i], rate, strains[i]),
                  envelope_at(law, strains[i - 1], rate, strains[i - 1]))
            << "rate " << rate << ", strain " << strains[i];
  });
}

TYPED_TEST(LawTable, GrowsWithTheStrainRateOnLoading) {
  this->for_each_row([](const auto& law) {
    for (const double strain : strains) {
      double before = envelope_at(law, strain, 0, strain);
      for (const double rate : rates) {
        const double now = envelope_at(law, strain, rate, strain);
        EXPECT_GE(now, before) << "rate " << rate << ", strain " << strain;
        before = now;
      }
    }
  });
}

TYPED_TEST(LawTable, IsNotStifferOnUnloading) {
  this->for_each_row([](const auto& law) {
    for (const double rate : rates)
      for (const double strain : strains)
        for (const double largest : strains)
          if (strain <= largest) {
            EXPECT_LE(envelope_at(law, strain, -rate, largest),
                      envelope_at(law, strain, rate, largest) * (1 + 1e-12))
                << "rate " << rate << ", strain " << strain << " of " << largest;
          }
  });
}

template <class Law>
class LawWithMemory : public LawTable<Law> {};
TYPED_TEST_SUITE(LawWithMemory, LawsWithMemory);

TYPED_TEST(LawWithMemory, HasTheSlopeOfItsEnvelope) {
  this->for_each_row([](const auto& law) {
    const PowerShape power(law.exponents());
    for (const double rate : {0.0, 1e-6, 1.0, 60.0, 2000.0, -1e-6, -1.0, -60.0, -2000.0})
      for (const double strain : {1e-6, 1e-3, 0.05, 0.4, 0.7, 0.9, 0.97}) {
        const double largest = rate < 0 ? std::min(1.2 * strain, 0.98) : strain;
        const auto value = [&](double at) { return envelope_at(law, at, rate, largest); };
        // Central differences at two widths, extrapolated: order four.
        const double width = 1e-3 * std::min(strain, 1 - strain);
        const auto difference = [&](double w) { return (value(strain + w) - value(strain - w)) / (2 * w); };
        const double expected = (4 * difference(width / 2) - difference(width)) / 3;
        const double slope = envelope_slope(law, power, strain_of(strain), law.rate_part(rate), largest);
        EXPECT_NEAR(slope, expected, 1e-8 * (std::abs(expected) + std::abs(value(strain)) / strain))
            << "rate " << rate << ", strain " << strain;
      }
  });
}

template <class Law>
class UnloadingFactor : public LawTable<Law> {};
using LawsWithFactor = testing::Types<NineParameter, TwentyOneParameter>;
TYPED_TEST_SUITE(UnloadingFactor, LawsWithFactor);

TYPED_TEST(UnloadingFactor, IsOneAtTheLargestStrainAndZeroAtTheResidualOne) {
  this->for_each_row([](const auto& law) {
    for (const double rate : rates)
      for (const double largest : strains) {
        const double top = envelope_at(law, largest, rate, largest);
        expect_relative(envelope_at(law, largest, -rate, largest), top, 1e-9, "at the largest strain");
        const double ratio =
            residual_ratio(std::log(rate), law.residual_strain_time, law.residual_strain_exponent);
        EXPECT_NEAR(envelope_at(law, largest * ratio, -rate, largest), 0, 1e-6 * top)
            << "at the residual strain";
      }
  });
}

TYPED_TEST(LawWithMemory, OnlyEverForgets) {
  this->for_each_row([](const auto& law) {
    for (const double start : {0.0, 1e-9, 1e-3, 0.5})
      for (const double step : {1e-12, 1e-6, 1e-3, 0.1, 100.0})
        for (const double from : {0.0, 0.3, 0.9})
          for (const double to : {0.0, 0.31, 0.999}) {
            const double decay = decay_over(law, start, start + step, from, to);
            EXPECT_GE(decay, 0);
            EXPECT_LE(decay, 1) << start << " + " << step << ": " << from << " to " << to;
          }
  });
}

/// Two steps at one rate are one step. Where the relaxation depends on the strain, which a step takes at one
/// place, that holds as the steps shrink.
TYPED_TEST(LawTable, TakesAConstantRateInAnyNumberOfSteps) {
  this->for_each_row([](auto law) {
    constexpr double time = 4e-3;
    const auto difference = [&](double strain_step) {
      const double step = strain_step / 50;
      Column<TypeParam> once(law, time, 0.3, 5e4);
      Column<TypeParam> twice(law, time, 0.3, 5e4);
      once.go(0.3 + strain_step, time + step);
      twice.go(0.3 + 0.4 * strain_step, time + 0.4 * step);
      twice.go(0.3 + strain_step, time + step);
      return relative_error(twice.stress(), once.stress());
    };
    if constexpr (requires { law.relaxation_strain_base; }) {
      EXPECT_LT(difference(0.1), 1e-3);
      EXPECT_LT(difference(0.01), 1e-5);
      law.relaxation_strain_base = 1;
    }
    EXPECT_LT(difference(0.1), 1e-13);
  });
}

/// A cycle of strain takes energy out of the impact, not in. A column carries no tension.
/// Not asked of unloading slower than loading: the published laws 4 and 5 do not keep it there. Law 4 with
/// the Ensolite card, loaded at 300 per second to a strain of 0.95 and unloaded at 30, gives back 7 % more
/// than it took.
TYPED_TEST(LawTable, LosesEnergyInAClosedCycle) {
  this->for_each_row([](const auto& law) {
    constexpr int steps = 2000;
    for (const double up : rates)
      for (const double down : {up, 3 * up, 10 * up})
        for (const double largest : {0.1, 0.5, 0.95}) {
          Column<TypeParam> column(law);
          double work = 0;
          double most = 0;
          double time = 0;
          double before = 0;
          for (int i = 1; i <= 2 * steps; ++i) {
            const double share = i <= steps ? i : 2 * steps - i;
            time += largest / steps / (i <= steps ? up : down);
            column.go(largest * share / steps, time);
            const double stress = std::max(column.stress(), 0.0);
            work += (i <= steps ? 1 : -1) * (before + stress) / 2 * largest / steps;
            most = std::max(most, work);
            before = stress;
          }
          EXPECT_GE(work, -1e-6 * most) << "up at " << up << " to " << largest << ", down at " << down;
        }
  });
}

/// Also the laws by curves, whose other properties are in test_foams.cpp.
template <class Law>
class ParameterTable : public LawTable<Law> {};
using LawsOfPrintedTables = testing::Types<Elastic, LinearViscoelastic, RigidFoam, NineParameter,
                                           TwentyOneParameter, Foam, CrushableFoam>;
TYPED_TEST_SUITE(ParameterTable, LawsOfPrintedTables);

TYPED_TEST(ParameterTable, DescribesItsParameters) {
  std::set<std::string> keys;
  for (const auto& parameter : TypeParam::parameters) {
    EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " twice";
    EXPECT_NE(std::string(parameter.symbol), "") << parameter.key;
    EXPECT_NE(std::string(parameter.unit), "") << parameter.key;
    EXPECT_NE(std::string(parameter.meaning), "") << parameter.key;
    EXPECT_LT(parameter.bounds.lowest, parameter.bounds.highest) << parameter.key;
  }
  this->for_each_row([](const auto& law) {
    for (const auto& parameter : TypeParam::parameters)
      EXPECT_TRUE(parameter.bounds.contain(parameter.of(law))) << parameter.key;
    EXPECT_TRUE(violations(PadLaw(law)).empty());
  });
}

/// Every member is in the table: a parameter that is not could be neither read nor checked.
TYPED_TEST(LawTable, DescribesAllOfItsParameters) {
  EXPECT_EQ(sizeof(TypeParam), TypeParam::parameters.size() * sizeof(double));
}

}  // namespace
}  // namespace dashpad::test
