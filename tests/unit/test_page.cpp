// The page as text: its data parse, no text of a user leaves them, the policy fits the script.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/page/page.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "model/parameter_values.hpp"
#include "output/page/data.hpp"
#include "output/text/case_toml.hpp"
#include "sample_case.hpp"

namespace dashpad::test {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const input::CaseFile& dashboard() {
  static const input::CaseFile input = input::read_case(source / "examples/dashboard-20mph.toml", materials);
  return input;
}

const Solution& solved() {
  static const Solution solution = solve(dashboard().impact, dashboard().options);
  return solution;
}

std::string data_of(const ImpactCase& impact, const Solution& solution = solved()) {
  return output::page_data(impact, {}, solution, unit_systems().front(),
                           contact_snapshots(impact, solution.history));
}

nlohmann::json parsed(const ImpactCase& impact, const Solution& solution = solved()) {
  return nlohmann::json::parse(data_of(impact, solution));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(page_data, names_units_with_the_factors_of_the_program) {
  const auto data = parsed(dashboard().impact);
  EXPECT_EQ(data["shown"], "si");
  ASSERT_EQ(data["systems"].size(), unit_systems().size());
  const auto& us = data["systems"][1];
  EXPECT_EQ(us["name"], "us");
  EXPECT_EQ(us["factors"]["N"]["unit"], "lbf");
  EXPECT_DOUBLE_EQ(us["factors"]["N"]["factor"], from_si(1, "N", "lbf"));
  EXPECT_EQ(us["factors"]["J"]["unit"], "in·lbf");
  EXPECT_EQ(us["figures"][0]["label"], "Peak force");
  EXPECT_EQ(us["figures"][0]["unit"], "lbf");
  EXPECT_THAT(us["words"].get<std::string>(), HasSubstr("20 mph"));
  EXPECT_EQ(us["warnings"].size(), 2U);
}

TEST(page_data, holds_the_history_and_its_energies) {
  // Fine enough for the trapezoids of the energies.
  static const Solution fine = solve(dashboard().impact, {.tolerance = 1e-5});
  const auto history = parsed(dashboard().impact, fine)["history"];
  const History& of = fine.history;
  ASSERT_EQ(history["time"].size(), of.size());
  EXPECT_NEAR(history["force"][60].get<double>(), of.force[60], 1e-6 * of.force[60]);
  EXPECT_NEAR(history["deceleration"][60].get<double>(), -of.acceleration[60] / standard_gravity, 1e-4);
  for (std::size_t i = 0; i < of.size(); ++i)
    EXPECT_NEAR(history["kinetic_energy"][i].get<double>() + history["support_energy"][i].get<double>() +
                    history["pad_energy"][i].get<double>(),
                fine.summary.energy.impact, 1e-4 * fine.summary.energy.impact);
}

TEST(page_data, thins_a_long_history_but_keeps_its_peak_and_end) {
  Solution solution = solved();
  History& history = solution.history;
  const std::size_t size = 100'000;
  for (auto* column :
       {&history.time, &history.force, &history.acceleration, &history.velocity, &history.motion,
        &history.penetration, &history.support_deflection, &history.contact_radius, &history.axis_strain})
    column->assign(size, 1.0);
  for (std::size_t i = 0; i < size; ++i) history.time[i] = 1e-6 * static_cast<double>(i + 1);
  history.force[54'321] = 7777;
  const auto data =
      nlohmann::json::parse(output::page_data(dashboard().impact, {}, solution, plain_si(), {}));
  EXPECT_LE(data["history"]["time"].size(), 1600U);
  EXPECT_THAT(data["history"]["force"].get<std::vector<double>>(), ::testing::Contains(7777));
  EXPECT_DOUBLE_EQ(data["history"]["time"].back(), 0.1);
}

TEST(page_data, has_injury_figures_of_a_whole_pulse_only) {
  const auto whole = parsed(dashboard().impact);
  const injury::InjuryFigures figures = injury::injury_figures(solved());
  EXPECT_NEAR(whole["injury"]["hic15"]["value"].get<double>(), figures.hic15.value, 1e-3);
  EXPECT_EQ(whole["systems"][0]["injury"][1]["label"], "HIC15");

  const input::CaseFile floor = input::read_case(source / "examples/rigid-floor-bottoming.toml", materials);
  const auto cut_off = parsed(floor.impact, solve(floor.impact, floor.options));
  EXPECT_TRUE(cut_off["injury"].is_null());
  EXPECT_TRUE(cut_off["systems"][0]["injury"].empty());
}

TEST(page_data, of_a_run_that_never_was) {
  const auto data = parsed(dashboard().impact, Solution{});
  EXPECT_TRUE(data["history"]["time"].empty());
  EXPECT_TRUE(data["snapshots"].empty());
}

TEST(page_data, keeps_hostile_text_inside) {
  ImpactCase impact = dashboard().impact;
  const std::string attack = "</script><script>window.pwned=1</script><!-- \"'\\ \xe2\x80\xa8 &amp; \xff";
  impact.title = impact.pad.material.name = impact.pad.material.title = impact.pad.material.source = attack;
  const std::string text = data_of(impact);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, Not(HasSubstr("\n")));
  const auto data = nlohmann::json::parse(text);
  // The line separator becomes a space, the byte that is no UTF-8 the replacement character.
  EXPECT_EQ(data["title"], "</script><script>window.pwned=1</script><!-- \"'\\   &amp; \xef\xbf\xbd");
}

TEST(case_toml, is_read_as_the_same_case) {
  for (const char* name :
       {"dashboard-20mph", "dashboard-20mph-21-parameter", "load-cell-drop", "rigid-floor-bottoming"}) {
    const input::CaseFile input =
        input::read_case(source / "examples" / (std::string{name} + ".toml"), materials);
    const input::CaseFile again =
        read(output::case_toml(input.impact, {.tolerance = 3e-6, .time_limit = 0.25}));
    EXPECT_EQ(again.impact.title, input.impact.title);
    EXPECT_EQ(again.impact.impactor.mass, input.impact.impactor.mass);
    EXPECT_EQ(std::get<Sphere>(again.impact.impactor.nose).radius,
              std::get<Sphere>(input.impact.impactor.nose).radius);
    EXPECT_EQ(again.impact.impactor.speed, input.impact.impactor.speed);
    EXPECT_EQ(again.impact.pad.thickness, input.impact.pad.thickness);
    EXPECT_EQ(again.impact.pad.material.law.index(), input.impact.pad.material.law.index());
    EXPECT_EQ(again.impact.support.points(), input.impact.support.points()) << name;
    EXPECT_EQ(again.options.tolerance, 3e-6);
    EXPECT_EQ(again.options.time_limit, 0.25);
    EXPECT_EQ(again.impact.pad.material.fitted->highest_rate, input.impact.pad.material.fitted->highest_rate);
    // The same numbers give the same impact, to the last bit.
    EXPECT_EQ(solve(again.impact, input.options).summary.peak_motion,
              solve(input.impact, input.options).summary.peak_motion);
  }
}

TEST(case_toml, keeps_every_nose_and_the_face_of_the_pad) {
  for (const Nose& nose :
       std::vector<Nose>{Sphere{0.1}, FlatDisc{0.05}, Cone{0.08, 1.1, 0.01}, Cone{0.08, 0.7},
                         Ellipsoid{0.06, 0.09, 0.05}, Rod{0.03, 0.08}, Platen{0.1, 0.08}}) {
    ImpactCase impact = dashboard().impact;
    impact.impactor.nose = nose;
    impact.pad.area = 0.0123;
    impact.pad.sheet = 4.7;
    const ImpactCase again = read(output::case_toml(impact, {})).impact;
    ASSERT_EQ(name_of(again.impactor.nose), name_of(nose));
    const auto numbers = parameter_values(nose), read_again = parameter_values(again.impactor.nose);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_EQ(read_again[i].value, numbers[i].value) << name_of(nose) << ", " << numbers[i].key;
    EXPECT_EQ(again.pad.area, 0.0123);
    EXPECT_EQ(again.pad.sheet, 4.7);
  }
}

TEST(case_toml, no_title_breaks_it) {
  ImpactCase impact = dashboard().impact;
  const std::string title = "a \"quoted\" \\ title\n[impactor]\nmass = \"1 kg\" \x7f \xff";
  impact.title = impact.pad.material.name = impact.pad.material.source = title;
  const input::CaseFile again = read(output::case_toml(impact, {}));
  EXPECT_EQ(again.impact.impactor.mass, impact.impactor.mass);
  EXPECT_EQ(again.impact.title, "a \"quoted\" \\ title [impactor] mass = \"1 kg\"   \xef\xbf\xbd");
}

class Page : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!output::has_page()) GTEST_SKIP() << output::no_page;
    text_ = output::page(dashboard().impact, dashboard().options, solved(), unit_system("us"),
                         contact_snapshots(dashboard().impact, solved().history));
  }

  /// Without a matcher: it would print the whole page.
  [[nodiscard]] bool has(const std::string& part) const { return text_.find(part) != std::string::npos; }

  std::string text_;
};

TEST_F(Page, is_one_small_file_that_names_no_other) {
  EXPECT_TRUE(text_.starts_with("<!DOCTYPE html>"));
  EXPECT_LT(text_.size(), 300'000U);
  EXPECT_EQ(count(text_, "<script"), 2U);
  EXPECT_EQ(count(text_, "</script>"), 2U);
  EXPECT_EQ(count(text_, "<style"), 3U) << "of the page, of drawings and of plots";
  for (const char* part : {"src=", "@import", "innerHTML", "eval(", "<iframe"}) EXPECT_FALSE(has(part)) << part;
  EXPECT_EQ(count(text_, "url("), count(text_, "url(#")) << "only what is in the page itself";
  const std::string opening = R"(<script type="application/json" id="data">)";
  const auto begin = text_.find(opening) + opening.size();
  const auto data = nlohmann::json::parse(text_.substr(begin, text_.find('<', begin) - begin));
  EXPECT_EQ(data["shown"], "us");
}

TEST_F(Page, has_a_policy_that_allows_its_own_script_only) {
  EXPECT_EQ(count(text_, "Content-Security-Policy"), 1U);
  EXPECT_TRUE(has("default-src 'none'; script-src 'sha256-"));
  EXPECT_TRUE(has("; style-src 'sha256-"));
  EXPECT_EQ(count(text_, "'sha256-"), 4U) << "a script and three styles";
  EXPECT_FALSE(has("unsafe"));
}

TEST_F(Page, names_the_license_of_the_plots) { EXPECT_TRUE(has("The MIT License")); }

TEST(page, where_it_was_not_built_says_how_to_get_it) {
  if (output::has_page()) GTEST_SKIP() << "it was built";
  EXPECT_THROW(output::page(dashboard().impact, {}, solved(), plain_si(), {}), std::runtime_error);
}

}  // namespace

}  // namespace dashpad::test
