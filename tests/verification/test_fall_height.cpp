// Critical fall heights of made-up mats whose law is known: how often the interval of a few drops has the
// truth.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "answers/true_mat.hpp"
#include "dashpad/fall_height/fall_height.hpp"

namespace dashpad::test {
namespace {

/// The HIC of a mat over the height, and the height at which it is 1000.
struct KnownMat {
  double critical = 0;
  std::vector<double> logs;  ///< of HIC, at heights of equal ratios

  static constexpr double low = 0.5, high = 1.5;  ///< of the critical height
  static constexpr int steps = 24;

  [[nodiscard]] double hic(double height) const {
    const double place = std::log(height / (low * critical)) / std::log(high / low) * steps;
    const auto i = static_cast<std::size_t>(std::clamp(place, 0.0, steps - 1.0));
    return std::exp(std::lerp(logs[i], logs[i + 1], place - static_cast<double>(i)));
  }
};

KnownMat known_mat(TrueLaw law, std::uint64_t seed) {
  constexpr Fineness fineness{60, 2e-5};
  const TrueMat mat = drawn_mat(law, seed).mat;
  double low = std::log(0.2), high = std::log(8);
  for (int i = 0; i < 20; ++i) {
    const double middle = (low + high) / 2;
    (dropped(mat, std::exp(middle), fineness).hic < 1000 ? low : high) = middle;
  }
  KnownMat known{.critical = std::exp(low), .logs = {}};
  for (int i = 0; i <= KnownMat::steps; ++i)
    known.logs.push_back(std::log(
        dropped(mat, KnownMat::low * known.critical * std::pow(KnownMat::high / KnownMat::low, i / 24.0),
                fineness)
            .hic));
  return known;
}

TEST(FallHeightOfKnownMats, IsInTheIntervalNineteenTimesOfTwenty) {
  injury::Standard standard;
  standard.criteria = {
      {.quantity = &result_quantity("hic_unlimited"), .limit = 1000, .description = {}, .origin = {}}};
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<KnownMat> mats;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const TrueLaw law : {TrueLaw::maxwell_branch, TrueLaw::enclosed_air})
      mats.push_back(known_mat(law, seed));
  // Of HIC, a standard deviation of the drops, and one of the instrument for all drops of a mat.
  constexpr double scatter = 0.02, instrument = 0.025;
  for (const int drops : {4, 5, 6, 9}) {
    int hits = 0, tried = 0;
    for (const KnownMat& mat : mats)
      for (int repeat = 0; repeat < 40; ++repeat) {
        fall_height::DropTable table;
        const double off = instrument * normal(random), first = 0.05 * normal(random);
        for (int i = 0; i < drops; ++i) {
          const double height = mat.critical * (1 + first) * std::lerp(0.7, 1.25, i / (drops - 1.0));
          table.drops.push_back({.height = height,
                                 .figures = {mat.hic(height) * std::exp(off + scatter * normal(random))},
                                 .doubts = {2 * instrument}});
        }
        const fall_height::Answer answer = evaluated(table, standard);
        const auto& interval = answer.decides().interval;
        ++tried;
        if (interval && interval->first <= mat.critical && mat.critical <= interval->second) ++hits;
      }
    EXPECT_GE(hits, 0.93 * tried) << drops << " drops: " << hits << " of " << tried;
  }
}

}  // namespace
}  // namespace dashpad::test
