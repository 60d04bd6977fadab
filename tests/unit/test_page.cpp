// The page of one impact as text: one small file that names no other, with all plots and all units in it.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "output/plot/impact_figures.hpp"
#include "sample_case.hpp"

namespace dashpad::test {

namespace {

const input::CaseFile& dashboard() {
  static const input::CaseFile input =
      input::read_case(source / "examples/dashboard-20mph.toml", materials).value();
  return input;
}

const Solution& solved() {
  static const Solution solution = solve(dashboard().impact, dashboard().options);
  return solution;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class Page : public ::testing::Test {
 protected:
  static std::string page_of(const ImpactCase& impact, const Solution& solution) {
    return output::impact_page({impact,
                                dashboard().options,
                                solution,
                                injury::whole_pulse_figures(solution),
                                {},
                                contact_snapshots(impact, solution.history)},
                               unit_system("us"));
  }

  /// Without a matcher: it would print the whole page.
  [[nodiscard]] bool has(const std::string& part) const { return text_.find(part) != std::string::npos; }

  std::string text_ = page_of(dashboard().impact, solved());
};

TEST_F(Page, is_one_small_file_that_names_no_other) {
  EXPECT_TRUE(text_.starts_with("<!DOCTYPE html>"));
  EXPECT_LT(text_.size(), 200'000U);
  EXPECT_EQ(count(text_, "<script"), 1U);
  EXPECT_EQ(count(text_, "<style"), 3U) << "of the page, of drawings and of plots";
  for (const char* part : {"src=", "@import", "innerHTML", "eval(", "<iframe"})
    EXPECT_FALSE(has(part)) << part;
  EXPECT_EQ(count(text_, "url("), count(text_, "url(#")) << "only what is in the page itself";
}

TEST_F(Page, has_a_policy_that_allows_its_own_script_only) {
  EXPECT_EQ(count(text_, "Content-Security-Policy"), 1U);
  EXPECT_TRUE(has("default-src 'none'; script-src 'sha256-"));
  EXPECT_TRUE(has("; style-src 'sha256-"));
  EXPECT_EQ(count(text_, "'sha256-"), 4U) << "a script and three styles";
  EXPECT_FALSE(has("unsafe"));
}

TEST_F(Page, has_all_plots_without_its_script) {
  EXPECT_EQ(count(text_, "class=\"dp-plot\""), 10U) << "the curve that decides, the foam's, and all others";
  for (const char* heading : {"Force over time", "Deceleration over time", "Force against penetration",
                              "Force against displacement", "Penetration and displacement over time",
                              "Energy over time", "Stress across the contact", "Strain across the contact"})
    EXPECT_TRUE(has("<h3>" + std::string{heading} + "</h3>")) << heading;
}

TEST_F(Page, has_every_unit_system) {
  EXPECT_TRUE(has("<main data-one-impact data-units=\"US\" data-order=\"1\""));
  EXPECT_EQ(count(text_, "<template data-units="), unit_systems().size() - 1);
  EXPECT_TRUE(has("&quot;N&quot;:[&quot;kN&quot;,0.001]"));
  EXPECT_TRUE(has("data-y-unit=\"N\""));
  // What changes with them is there once for each.
  for (const char* part : {"answer", "figures", "words", "section-1", "section-2"})
    EXPECT_EQ(count(text_, "data-part=\"" + std::string{part} + "\""), unit_systems().size()) << part;
  EXPECT_EQ(count(text_, "data-part=\"drawing\""), 1U);
  EXPECT_EQ(count(text_, "data-texts-of=\"drawing\""), unit_systems().size() - 1);
}

TEST_F(Page, of_a_long_history_is_small_and_keeps_its_peak) {
  Solution solution = solved();
  History& history = solution.history;
  const std::size_t size = 100'000;
  for (auto* column :
       {&history.time, &history.force, &history.acceleration, &history.velocity, &history.motion,
        &history.penetration, &history.support_deflection, &history.contact_radius, &history.axis_strain})
    column->assign(size, 0.01);
  for (std::size_t i = 0; i < size; ++i) history.time[i] = 1e-6 * static_cast<double>(i + 1);
  history.force[54'321] = 7777;
  const std::string page = output::impact_page({dashboard().impact,
                                                {},
                                                solution,
                                                injury::whole_pulse_figures(solution),
                                                {},
                                                contact_snapshots(dashboard().impact, {})},
                                               plain_si());
  EXPECT_LT(page.size(), 200'000U);
  EXPECT_NE(page.find("data-y-high=\"8243.62\""), std::string::npos);
}

TEST_F(Page, of_a_run_that_never_was_has_no_plots) {
  EXPECT_EQ(count(page_of(dashboard().impact, Solution{}), "class=\"dp-plot\""), 0U);
}

TEST(impact_energies, add_up_to_the_energy_of_the_impact) {
  // Fine enough for the trapezoids of the energies.
  const Solution fine = solve(dashboard().impact, {.tolerance = 1e-5});
  const output::ImpactEnergies energies = output::impact_energies(dashboard().impact, fine.history);
  const double impact = fine.summary.energy.impact;
  ASSERT_EQ(energies.total.size(), fine.history.size());
  for (std::size_t i = 0; i < fine.history.size(); ++i)
    EXPECT_NEAR(energies.kinetic[i] + energies.support[i] + energies.pad[i], impact, 1e-4 * impact);
  EXPECT_LT(energies.largest_deviation, 1e-4);
  EXPECT_GT(energies.largest_deviation, 0);
}

/// The weight does a third of the work.
TEST(impact_energies, of_a_heavy_impactor_count_the_work_of_its_weight) {
  ImpactCase impact = dashboard().impact;
  impact.impactor.gravity = standard_gravity;
  impact.impactor.mass = 40;
  impact.impactor.speed = 0.5;
  const Solution fine = solve(impact, {.tolerance = 1e-5});
  ASSERT_GT(fine.summary.energy.weight, 0.5 * fine.summary.energy.impact);
  const output::ImpactEnergies energies = output::impact_energies(impact, fine.history);
  EXPECT_LT(energies.largest_deviation, 1e-3);
  for (const double total : energies.total)
    EXPECT_NEAR(total, fine.summary.energy.impact, 1e-3 * fine.summary.energy.impact);
}

}  // namespace

}  // namespace dashpad::test
