/// The observed order of the solver: one run at each of several halved resolutions, no extrapolation.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>

#include "shared/run_once.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

struct Figure {
  const char* name;
  std::function<double(const Figures&)> read;
  double lowest_order;
  double highest_order;
};

const std::vector<Figure> figures_read{
    {"peak force", [](const Figures& f) { return f.peak_force; }, 1.6, 2.5},
    {"time of peak force", [](const Figures& f) { return f.time_of_peak_force; }, 1.3,
     2.8},  // of a flat peak
    {"peak motion", [](const Figures& f) { return f.peak_motion; }, 1.4,
     2.5},  // in law 4 parts of orders 2 and 3 have opposite signs
    {"release time", [](const Figures& f) { return f.release.value().time; }, 1.6,
     3.2},  // errors cancel in law 5
};

constexpr double coarsest = 0.05;  // radians of the momentary oscillation
constexpr int runs = 5;            // compared
constexpr double exact = 1e-11;    // a pad without memory gets its peaks from the energy: no order to observe

/// Slope of log2(error) over the halvings, by least squares: single steps depend on where in them the events
/// fall.
double observed_order(const std::vector<double>& error) {
  const double middle = static_cast<double>(error.size() - 1) / 2;
  double above = 0;
  double below = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    above -= x * std::log2(error[i]);
    below += x * x;
  }
  return above / below;
}

/// `error[i]` at the resolution i.
void expect_order(const std::vector<double>& error, const Figure& figure) {
  fmt::print("  {:20}", figure.name);
  for (const double e : error) fmt::print(" {:8.1e}", e);
  if (*std::max_element(error.begin(), error.end()) < exact) {
    fmt::print("   exact\n");
    return;
  }
  const double order = observed_order(error);
  fmt::print("   order {:.2f}\n", order);
  EXPECT_GT(order, figure.lowest_order) << figure.name;
  EXPECT_LT(order, figure.highest_order) << figure.name;
}

template <class Law>
class Convergence : public testing::Test {};
TYPED_TEST_SUITE(Convergence, SmoothLaws);

/// The largest errors over several speeds, so that none is small because two parts of it happen to cancel.
TYPED_TEST(Convergence, IsOfSecondOrder) {
  for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
    std::vector<std::vector<double>> error(figures_read.size(), std::vector<double>(runs, 0.0));
    for (const double speed : {1.6, 2.0, 2.4, 2.8}) {
      ImpactCase impact = impact_on(sample_law<TypeParam>(), support);
      impact.impactor.speed = speed;
      std::vector<Figures> sequence;
      double resolution = coarsest;
      for (int i = 0; i < runs; ++i, resolution /= 2)
        sequence.push_back(run_once(impact, resolution).figures);
      ASSERT_EQ(sequence.back().ending, Status::released);
      const Figures fine = run_once(impact, resolution).figures;
      const Figures finest = run_once(impact, resolution / 2).figures;
      for (std::size_t k = 0; k < figures_read.size(); ++k) {
        const auto& read = figures_read[k].read;
        const double best = read(finest) + (read(finest) - read(fine)) / 3;
        for (std::size_t i = 0; i < runs; ++i)
          error[k][i] = std::max(error[k][i], relative_error(read(sequence[i]), best));
      }
    }
    fmt::print("{}, {} support: relative errors\n", TypeParam::name, support.is_rigid() ? "rigid" : "linear");
    for (std::size_t k = 0; k < figures_read.size(); ++k) expect_order(error[k], figures_read[k]);
  }
}

}  // namespace
}  // namespace dashpad::test
