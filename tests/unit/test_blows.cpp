/// Repeated blows: what a case may ask for, how it is read, named and told, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/spit1984/deck.hpp"
#include "impact_text.hpp"
#include "output/result_rows.hpp"
#include "output/text/case_toml.hpp"
#include "sample_case.hpp"
#include "shared/samples.hpp"
#include "shown_values.hpp"

namespace dashpad::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// "key: rule", a line each.
std::string broken(const ImpactCase& impact) {
  std::string text;
  for (const Violation& violation : violations(impact)) text += violation.key + ": " + violation.rule + "\n";
  return text;
}

ImpactCase struck(const PadLaw& law, int count, double recovery) {
  ImpactCase impact = impact_on(law);
  impact.impactor.speed = 2;
  impact.blows = Blows{.count = count, .recovery = recovery};
  return impact;
}

ImpactCase struck_before(const PadLaw& law, double earlier) {
  ImpactCase impact = impact_on(law);
  impact.pad.earlier_penetration = earlier;
  return impact;
}

std::string fault_of(const std::string& blows, const std::string& material = "vn600") {
  try {
    read(edited(good_case, "\"ensolite-aac-9\"", "\"" + material + "\"") + blows);
  } catch (const input::InputError& error) {
    std::string text;
    for (const input::Fault& fault : error.faults()) text += fault.key + ": " + fault.rule + "\n";
    return text;
  }
  return "";
}

TEST(BlowRules, AreOneFaultEach) {
  const Foam foam = sample_law<Foam>();
  EXPECT_EQ(broken(struck(foam, 2, 0)), "");
  EXPECT_EQ(broken(struck(foam, 100, 1)), "");
  EXPECT_EQ(broken(struck(foam, 1, 0)), "blows.count: must be from 2 to 100\n");
  EXPECT_EQ(broken(struck(foam, 101, 0)), "blows.count: must be from 2 to 100\n");
  for (const double recovery : {-0.1, 1.1, nan})
    EXPECT_EQ(broken(struck(foam, 2, recovery)), "blows.recovery: must be from 0 (none) to 1 (full)\n");
  EXPECT_EQ(broken(struck(sample_law<CrushableFoam>(), 2, 0)), "");
  EXPECT_EQ(broken(struck(sample_law<CrushableFoam>(), 2, 0.5)),
            "blows.recovery: must be 0: a pad with the crushable-foam law does not recover\n");
  EXPECT_EQ(broken(struck(sample_law<RigidFoam>(), 2, 1)),
            "blows.recovery: must be 0: a pad with the rigid-foam law does not recover\n");
  EXPECT_EQ(broken(struck(sample_law<Elastic>(), 2, 0.5)), "");
}

TEST(BlowRules, OfWhatEarlierOnesLeft) {
  const Foam foam = sample_law<Foam>();
  EXPECT_EQ(broken(struck_before(foam, 0.02)), "");
  const std::string range = "pad.earlier_penetration: must be at least 0 and less than pad.thickness\n";
  for (const double earlier : {-1e-6, 0.03, 1.0, nan}) EXPECT_EQ(broken(struck_before(foam, earlier)), range);
  EXPECT_THAT(broken(struck_before(sample_law<Elastic>(), 0.01)), HasSubstr("elastic law recovers fully"));
  EXPECT_THAT(broken(struck_before(sample_law<NineParameter>(), 0.01)), HasSubstr("recovers fully"));
  EXPECT_EQ(broken(struck_before(sample_law<RigidFoam>(), 0.01)), "");
  // A thickness that is wrong itself says nothing about what is less than it.
  ImpactCase thick = struck_before(foam, 0.02);
  thick.pad.thickness = nan;
  EXPECT_THAT(broken(thick), Not(HasSubstr("earlier")));
}

TEST(BlowRules, StopTheSolver) {
  EXPECT_THROW(solve(struck(sample_law<Foam>(), 1, 0)), std::invalid_argument);
  EXPECT_THROW(solve_blows(struck(sample_law<RigidFoam>(), 2, 1)), std::invalid_argument);
}

TEST(BlowTable, IsRead) {
  const ImpactCase impact =
      read(edited(good_case, "\"ensolite-aac-9\"", "\"vn600\"\nearlier_penetration = \"2 mm\"") +
           "[blows]\ncount = 3\nrecovery = 0.25\n")
          .impact;
  ASSERT_TRUE(impact.blows);
  EXPECT_EQ(impact.blows->count, 3);
  EXPECT_EQ(impact.blows->recovery, 0.25);
  EXPECT_DOUBLE_EQ(impact.pad.earlier_penetration, 2e-3);
  EXPECT_FALSE(read(good_case).impact.blows);
  EXPECT_EQ(read(good_case).impact.pad.earlier_penetration, 0);
}

TEST(BlowTable, HasItsFaults) {
  EXPECT_THAT(fault_of("[blows]\ncount = 3\n"), HasSubstr("blows.recovery: is missing"));
  EXPECT_THAT(fault_of("[blows]\nrecovery = 0\n"), HasSubstr("blows.count: is missing"));
  for (const char* count : {"1", "101", "2.5", "1e300", "-3"})
    EXPECT_EQ(fault_of(std::string("[blows]\nrecovery = 0\ncount = ") + count + "\n"),
              "blows.count: must be a whole number from 2 to 100\n")
        << count;
  EXPECT_EQ(fault_of("[blows]\ncount = 2\nrecovery = 1.5\n"),
            "blows.recovery: must be from 0 (none) to 1 (full)\n");
  EXPECT_THAT(fault_of("[blows]\ncount = 2\nrecovery = 0\nrest = \"60 s\"\n"), HasSubstr("blows.rest"));
  EXPECT_THAT(fault_of("[blows]\ncount = 2\nrecovery = 0.5\n", "eps-19"), HasSubstr("does not recover"));
  EXPECT_THAT(fault_of("[blows]\ncount = \"two\"\nrecovery = 0\n"), HasSubstr("blows.count"));
}

/// Also where the case gives no blows: what they left may be given by hand.
TEST(BlowQuantities, AreThoseThatThePadRemembers) {
  const auto has = [](const ImpactCase& impact, const std::string& key) {
    const auto all = quantities_of(impact);
    return std::ranges::count(all, key, &CaseQuantity::key) == 1;
  };
  EXPECT_TRUE(has(impact_on(sample_law<Foam>()), "pad.earlier_penetration"));
  EXPECT_FALSE(has(impact_on(sample_law<Foam>()), "blows.recovery"));
  EXPECT_FALSE(has(impact_on(sample_law<Elastic>()), "pad.earlier_penetration"));
  ImpactCase impact = struck(sample_law<Foam>(), 3, 0.5);
  ASSERT_TRUE(has(impact, "blows.recovery"));
  for (const CaseQuantity& case_quantity : quantities_of(impact))
    if (case_quantity.key == "blows.recovery") case_quantity.set(impact, 0.75);
  EXPECT_EQ(impact.blows->recovery, 0.75);
}

TEST(BlowTexts, TellTheCase) {
  const UnitSystem& si = unit_system("si");
  EXPECT_THAT(output::case_text(struck(sample_law<Foam>(), 3, 0.25), si),
              HasSubstr("It strikes 3 times; between blows the pad recovers by 25 %."));
  EXPECT_THAT(output::case_text(struck(sample_law<Foam>(), 3, 0), si), HasSubstr("does not recover"));
  EXPECT_THAT(output::case_text(struck(sample_law<RigidFoam>(), 3, 0), si), HasSubstr("stays crushed"));
  EXPECT_THAT(output::case_text(struck(sample_law<Elastic>(), 3, 0), si), HasSubstr("according to its law"));
  EXPECT_THAT(output::case_text(struck_before(sample_law<Foam>(), 0.012), si),
              HasSubstr("already compressed to a depth of 12 mm"));
  const std::string in_si = output::case_in_si(struck(sample_law<Foam>(), 3, 0.25), {});
  EXPECT_THAT(in_si, HasSubstr("blows.count = 3\n"));
  EXPECT_THAT(in_si, HasSubstr("blows.recovery = 0.25\n"));
}

TEST(BlowTexts, AreACaseAgain) {
  ImpactCase impact = struck(sample_law<Foam>(), 7, 0.3);
  impact.pad.earlier_penetration = 0.0123;
  const ImpactCase again = read(output::case_toml(impact, {})).impact;
  EXPECT_EQ(again.blows->count, 7);
  EXPECT_EQ(again.blows->recovery, 0.3);
  EXPECT_EQ(again.pad.earlier_penetration, 0.0123);
}

/// As fits ask for them: the accuracy then decides nothing.
TEST(BlowSeries, GoesOnWithAFixedNumberOfRuns) {
  const ImpactCase impact = struck(sample_law<Foam>(), 4, 0);
  for (const int runs : {1, 2})
    EXPECT_EQ(solve_blows(impact, {.tolerance = 1e-8, .fixed_runs = runs}).size(), 4u);
}

/// A weak blow on a pad that was struck deep does not reach the depth of the earlier one, which is kept.
TEST(BlowSeries, RemembersTheDeepestOfTheBlowsSoFar) {
  for (const double recovery : {0.0, 0.25}) {
    ImpactCase impact = struck(sample_law<Foam>(), 2, recovery);
    impact.impactor.speed = 0.3;
    impact.pad.earlier_penetration = 0.02;
    const auto blows = solve_blows(impact, {.tolerance = 1e-3});
    ASSERT_EQ(blows.size(), 2u);
    ASSERT_LT(blows[0].solution.summary.peak_penetration, 0.019);
    EXPECT_DOUBLE_EQ(blows[1].impact.pad.earlier_penetration, (1 - recovery) * 0.02);
  }
}

std::string told(const ImpactCase& impact) {
  const auto blows = solve_blows(impact, {.tolerance = 1e-3});
  const Solution& last = blows.back().solution;
  return test::impact_text(impact, last.summary, injury::whole_pulse_figures(last), unit_system("si"),
                           output::Detail::main, output::blow_results(blows));
}

TEST(BlowTexts, AnswerFirstHowThePeaksGrow) {
  const std::string text = told(struck(sample_law<Foam>(), 3, 0));
  EXPECT_THAT(text, testing::ContainsRegex(
                        "^Blow 3 peaks at [0-9.]+ g, [0-9.]+ % higher than blow 1; its HIC15 is "));
  EXPECT_LT(text.find("\nBlow 3: the "), text.find("  Peak acceleration"));
  EXPECT_LT(text.find("  Peak acceleration"), text.find("Peak acceleration, g"));
  EXPECT_THAT(told(struck(sample_law<Foam>(), 3, 1)),
              HasSubstr("All 3 blows are identical: the pad recovers"));
  EXPECT_THAT(told(struck(sample_law<Elastic>(), 3, 0)),
              HasSubstr("according to the elastic law, the pad recovers fully"));
}

TEST(BlowTexts, HaveATableOfTheFiguresOfEachBlow) {
  ImpactCase impact = struck(sample_law<Foam>(), 2, 0);
  std::vector<output::BlowResult> blows(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto more = static_cast<double>(i);
    Summary& summary = blows[i].summary;
    summary.blow = static_cast<int>(i) + 1;
    summary.peak_acceleration = (40 + more) * standard_gravity;
    summary.peak_force = 1500 + more;
    summary.peak_penetration = 0.012 + 0.003 * more;  // of 30 mm
    summary.peak_motion = 0.02;
    summary.energy_absorbed_fraction = 0.81 + 0.01 * more;
    blows[i].injury = injury::InjuryFigures{};
    blows[i].injury->hic15.value = 123 + more;
  }
  const output::Table si = blow_table(impact, blows, unit_system("si"), output::Detail::all);
  const output::Table us = blow_table(impact, blows, unit_system("us"), output::Detail::all);
  const std::vector<double> expected{1, 40 * standard_gravity, 123, 1500, 0.012, 40, 81,
                                     2, 41 * standard_gravity, 124, 1501, 0.015, 50, 82};
  for (const output::Table& table : {si, us}) {
    const std::vector<double> shown = numbers_in(table);
    ASSERT_EQ(shown.size(), expected.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
      EXPECT_NEAR(shown[i], expected[i], 1e-4 * expected[i]) << i;
  }
}

TEST(BlowTexts, TellOfASeriesThatIsCut) {
  ImpactCase impact = struck(sample_law<Foam>(), 4, 0);
  impact.impactor.mass = 400;
  impact.impactor.speed = 20;
  EXPECT_THAT(told(impact), HasSubstr("SERIES CUT: blow 1 of 4"));
}

TEST(BlowJson, HasARowABlow) {
  const ImpactCase impact = struck(sample_law<Foam>(), 3, 0.5);
  const auto blows = solve_blows(impact, {.tolerance = 1e-3});
  const Solution& last = blows.back().solution;
  const auto json = nlohmann::json::parse(
      output::result_json(impact, last.summary, std::nullopt, output::blow_results(blows)));
  ASSERT_EQ(json["blows"].size(), 3u);
  EXPECT_EQ(json["blows"][2]["blow"], 3);
  EXPECT_EQ(json["blows"][2]["peak_force_N"], json["peak_force_N"]);
  EXPECT_EQ(json["blows"][0]["earlier_penetration_m"], 0);
  EXPECT_EQ(json["case"]["blows"]["count"], 3);
  EXPECT_EQ(json["case"]["pad"]["earlier_penetration_m"], 0);
  const auto once = nlohmann::json::parse(output::result_json(impact_on(sample_law<Foam>()), last.summary));
  EXPECT_TRUE(once["blows"].is_null());
  EXPECT_TRUE(once["case"]["blows"].is_null());
}

TEST(BlowDeck, IsRefusedByTheProgramOf1984) {
  ImpactCase impact = impact_on(sample_law<NineParameter>(), Support::linear(1e5));
  EXPECT_TRUE(spit1984::what_a_deck_cannot_say(impact).empty());
  impact.blows = Blows{.count = 2, .recovery = 1};
  const auto unsaid = spit1984::what_a_deck_cannot_say(impact);
  ASSERT_EQ(unsaid.size(), 1u);
  EXPECT_EQ(unsaid[0].key, "blows");
}

}  // namespace
}  // namespace dashpad::test
