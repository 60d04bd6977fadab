// Derivatives of figures: closed forms, differences at a far higher accuracy, and a kink that is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/sensitivity/sensitivity.hpp"
#include "dashpad/study/responses.hpp"

namespace dashpad::test {
namespace {

using sensitivity::Answer;
using sensitivity::Course;
using sensitivity::Elasticity;

ImpactCase example(const std::string& name) {
  const std::filesystem::path root(DASHPAD_SOURCE_DIR);
  return input::read_case(root / "examples" / (name + ".toml"), root / "materials").value().impact;
}

Elasticity elasticity_of(const Answer& answer, const std::string& input, const std::string& figure) {
  const auto of_input = std::ranges::find(answer.inputs, input, &sensitivity::Input::key);
  const auto of_figure = std::ranges::find_if(
      answer.figures, [&](const ResultQuantity* quantity) { return figure == quantity->key; });
  if (of_input == answer.inputs.end() || of_figure == answer.figures.end()) return {};
  return of_input->elasticities[static_cast<std::size_t>(of_figure - answer.figures.begin())];
}

double figure_of(const Solution& solution, const std::string& name) {
  const std::vector<std::string> names{name};
  study::ResponseReader reader(names);
  study::Outcome outcome;
  reader(solution, outcome);
  return outcome.values.front();
}

constexpr double spring_stiffness = 1e6 * 3.141592653589793 * 0.05 * 0.05 / 0.05;  // N/m, of the spring below

/// A flat nose on a linear elastic pad: F = v sqrt(k m) with k = E A / T.
ImpactCase spring() {
  ImpactCase impact;
  impact.impactor = {5, FlatDisc{.radius = 0.05}, 2, 0};
  impact.pad.thickness = 0.05;
  impact.pad.material.law = Elastic{.modulus = 1e6};
  return impact;
}

TEST(Sensitivity, OfASpringIsThatOfItsClosedForm) {
  const Answer answer = sensitivity::sensitivities(spring(), {}, false);
  for (const auto& [input, force, penetration, time] : {std::tuple{"impactor.speed", 1.0, 1.0, 0.0},
                                                        {"impactor.mass", 0.5, 0.5, 0.5},
                                                        {"pad.parameters.modulus", 0.5, -0.5, -0.5},
                                                        {"pad.thickness", -0.5, 0.5, 0.5},
                                                        {"impactor.radius", 1.0, -1.0, -1.0}}) {
    EXPECT_NEAR(elasticity_of(answer, input, "peak_force").value, force, 1e-4) << input;
    EXPECT_NEAR(elasticity_of(answer, input, "peak_penetration").value, penetration, 1e-4) << input;
    EXPECT_NEAR(elasticity_of(answer, input, "contact_end").value, time, 1e-4) << input;
    EXPECT_EQ(elasticity_of(answer, input, "peak_force").course, Course::smooth) << input;
  }
  // d F / d v = sqrt(k m), SI.
  const auto speed = std::ranges::find(answer.inputs, "impactor.speed", &sensitivity::Input::key);
  const auto force = std::ranges::find_if(answer.figures, [](const ResultQuantity* quantity) {
    return std::string(quantity->key) == "peak_force";
  });
  EXPECT_NEAR(sensitivity::derivative(answer, static_cast<std::size_t>(speed - answer.inputs.begin()),
                                      static_cast<std::size_t>(force - answer.figures.begin())),
              std::sqrt(spring_stiffness * 5), 1e-4 * std::sqrt(spring_stiffness * 5));
}

TEST(Sensitivity, IsThatOfMoreAccurateImpacts) {
  const std::vector<std::string> figures{"peak_acceleration", "hic15", "peak_penetration", "rebound_speed"};
  for (const char* name : {"dashboard-20mph", "disc-on-mat", "package-corner"}) {
    const ImpactCase impact = example(name);
    const Answer answer = sensitivity::sensitivities(impact, {}, false);
    for (const char* key : {"impactor.speed", "impactor.mass", "pad.thickness"}) {
      const CaseQuantities quantities = quantities_of(impact);
      const CaseQuantity& quantity = *quantities.find(key);
      const auto changed = [&](double multiple) {
        ImpactCase other = impact;
        quantity.set(other, multiple * quantity.get(impact));
        return solve(other, {.tolerance = 1e-7});
      };
      constexpr double step = 4e-3;
      const Solution up = changed(1 + step), down = changed(1 - step), middle = changed(1);
      const Solution far_up = changed(1 + 2 * step), far_down = changed(1 - 2 * step);
      for (const std::string& figure : figures) {
        const double f = figure_of(middle, figure);
        const double near = (figure_of(up, figure) - figure_of(down, figure)) / (2 * step * f);
        const double far = (figure_of(far_up, figure) - figure_of(far_down, figure)) / (4 * step * f);
        const Elasticity elasticity = elasticity_of(answer, key, figure);
        EXPECT_NEAR(elasticity.value, (4 * near - far) / 3, 1e-4) << name << ", " << key << ", " << figure;
        EXPECT_LT(elasticity.error, 1e-3) << name << ", " << key << ", " << figure;
      }
    }
  }
}

TEST(Sensitivity, NamesAKink) {
  // The spring on a support that is four times as stiff from 1 kN on, at the speed at which that force is
  // just reached: m v dv = F (1/k + c) dF, where c, the compliance, leaps.
  ImpactCase impact = spring();
  constexpr double corner = 1000, soft = 1e-5, hard = 2.5e-6;
  impact.support = Support::through({{corner * soft, corner}, {corner * soft + 1000 * hard, 2 * corner}});
  impact.impactor.speed = corner * std::sqrt((1 / spring_stiffness + soft) / impact.impactor.mass);
  const Answer answer = sensitivity::sensitivities(impact, {}, false);
  const Elasticity at_corner = elasticity_of(answer, "impactor.speed", "peak_force");
  EXPECT_EQ(at_corner.course, Course::kink);
  EXPECT_NEAR(at_corner.value, (1 + (1 / spring_stiffness + soft) / (1 / spring_stiffness + hard)) / 2, 0.01);
  impact.impactor.speed *= 0.9;
  const Elasticity below =
      elasticity_of(sensitivity::sensitivities(impact, {}, false), "impactor.speed", "peak_force");
  EXPECT_EQ(below.course, Course::smooth);
  EXPECT_NEAR(below.value, 1, 1e-4);
}

TEST(Sensitivity, MovesANumberAtItsBoundToOneSide) {
  ImpactCase impact = example("dashboard-20mph");
  const Answer answer = sensitivity::sensitivities(impact, {}, false);
  for (const sensitivity::Input& input : answer.inputs) {
    if (!input.is_one_sided) continue;
    for (const Elasticity& elasticity : input.elasticities)
      EXPECT_NE(elasticity.course, Course::jump) << input.key;
  }
  EXPECT_EQ(answer.inputs.size() + answer.left_out.size(),
            static_cast<std::size_t>(std::ranges::count_if(
                quantities_of(impact),
                [&](const CaseQuantity& quantity) { return !std::isnan(quantity.get(impact)); })));
}

}  // namespace
}  // namespace dashpad::test
