/// The cards of foams against the tests that they were made from: stresses, and the energy that comes back in
/// the first and in later cycles. The figures were read off the tables named in the cards
/// (docs/materials.md).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "dashpad/laboratory/column_test.hpp"

namespace dashpad {
namespace {

Material card(const std::string& name) {
  return input::read_material(std::filesystem::path(DASHPAD_SOURCE_DIR) / "materials" / (name + ".toml"))
      .value();
}

struct Loading {
  const char* card;
  double rate;  ///< 1/s
  double strain;
  double stress;  ///< kPa
};

// Avalle curves and factors are within a few per cent of the points that they were fitted to.
constexpr Loading loadings[] = {
    {"vn600", 8.4e-5, 0.2515, 57.70},
    {"vn600", 10.5, 0.2491, 215.7},
    {"vn600", 10.5, 0.5007, 303.2},
    {"team-wendy-hard-pu", 2e-4, 0.3007, 32.66},
    {"team-wendy-hard-pu", 0.02, 0.3007, 85.54},
    {"team-wendy-hard-pu", 3000, 0.2999, 327.7},
    {"plastazote-ld33", 0.03, 0.25, 40},
    {"plastazote-ld33", 0.03, 0.40, 75},
    {"plastazote-ld33", 0.03, 0.50, 115},
    {"plastazote-ld33", 0.03, 0.60, 175},
    {"poron-low-density", 1e-3, 0.3002, 10.389},
    {"poron-low-density", 1e-3, 0.5005, 16.424},
    {"eps-12-geofoam", 1e-3, 0.1051, 43.23},
    {"eps-12-geofoam", 1e-3, 0.5029, 135.55},
    {"eps-22", 1.67e-3, 0.01, 50},
    {"eps-22", 1.67e-3, 0.10, 135},
    {"ff-leap", 0.246, 0.5, 185.97},
    {"ff-turbo-plus", 0.246, 0.5, 239.99},
};

TEST(FoamCards, LoadAsTheirTests) {
  for (const Loading& loading : loadings) {
    const laboratory::StrainHistory up{
        {{.duration = loading.strain / loading.rate, .strain = 0, .rate = loading.rate}}};
    const laboratory::ColumnTest test = laboratory::drive(card(loading.card).law, up, 50);
    EXPECT_NEAR(test.stress.back() / 1e3, loading.stress, 0.05 * loading.stress)
        << loading.card << " at " << loading.rate << " 1/s and a strain of " << loading.strain;
  }
}

struct Cycles {
  const char* card;
  double rate;                  ///< 1/s
  double strain;                ///< the largest
  double first_return;          ///< energy returned over energy put in
  std::optional<double> later;  ///< the same, mean of cycles 2 to 5
  double stress_on_way_back;    ///< of the first cycle at a strain of 0.3, kPa
};

constexpr Cycles measured[] = {
    {"ff-leap", 0.246, 0.6, 0.703, 0.847, 69.99},
    {"ff-turbo-plus", 0.246, 0.6, 0.628, 0.811, 79.71},
    {"midsole-heel", 0.246, 0.6, 0.698, 0.848, 83.52},
    {"midsole-mid", 0.246, 0.6, 0.691, 0.836, 68.32},
    {"midsole-toe", 0.246, 0.6, 0.750, 0.862, 54.77},
    {"ff-leap-conditioned", 0.246, 0.6, 0.847, 0.847, 66.86},
    {"ff-turbo-plus-conditioned", 0.246, 0.6, 0.811, 0.811, 75.47},
    {"vn600", 8.4e-5, 0.5528, 0.728, std::nullopt, 44.65},
};

struct CycleEnergy {
  double put_in = 0;
  double returned = 0;
};

std::vector<CycleEnergy> energies(const laboratory::ColumnTest& test) {
  std::vector<CycleEnergy> cycles;
  bool rises = false;
  for (std::size_t i = 1; i < test.size(); ++i) {
    const double step = test.strain[i] - test.strain[i - 1];
    if (step == 0) continue;
    if (step > 0 && !rises) cycles.emplace_back();
    rises = step > 0;
    const double work = std::abs(step) * (test.stress[i] + test.stress[i - 1]) / 2;
    (rises ? cycles.back().put_in : cycles.back().returned) += work;
  }
  return cycles;
}

double first_way_back(const laboratory::ColumnTest& test, double strain) {
  for (std::size_t i = 1; i < test.size(); ++i)
    if (test.strain[i] < test.strain[i - 1] && test.strain[i] <= strain) {
      const double part = (test.strain[i - 1] - strain) / (test.strain[i - 1] - test.strain[i]);
      return std::lerp(test.stress[i - 1], test.stress[i], part);
    }
  return 0;
}

TEST(FoamCards, ReturnTheEnergyOfTheirTests) {
  constexpr double allowed = 0.03;
  for (const Cycles& each : measured) {
    const laboratory::ColumnTest test =
        laboratory::drive(card(each.card).law, laboratory::cyclic_test(each.rate, each.strain, 0, 5), 500);
    const std::vector<CycleEnergy> cycles = energies(test);
    ASSERT_EQ(cycles.size(), 5U);
    EXPECT_NEAR(cycles[0].returned / cycles[0].put_in, each.first_return, allowed) << each.card;
    for (std::size_t i = 1; i < cycles.size() && each.later; ++i)
      EXPECT_NEAR(cycles[i].returned / cycles[i].put_in, *each.later, allowed)
          << each.card << ", cycle " << i + 1;
  }
}

TEST(FoamCards, UnloadAsTheirTests) {
  for (const Cycles& cycles : measured) {
    const laboratory::ColumnTest test = laboratory::drive(
        card(cycles.card).law, laboratory::cyclic_test(cycles.rate, cycles.strain, 0, 1), 500);
    double peak = 0;
    for (const double stress : test.stress) peak = std::max(peak, stress);
    EXPECT_NEAR(first_way_back(test, 0.3) / 1e3, cycles.stress_on_way_back, 0.03 * peak / 1e3) << cycles.card;
  }
}

}  // namespace
}  // namespace dashpad
