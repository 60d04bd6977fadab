/// What a reader is told before relying on a result.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/impact.hpp"
#include "example_result.hpp"
#include "output/json/parts.hpp"

namespace dashpad {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> names(const Summary& summary) {
  std::vector<std::string> all;
  for (const Flag& flag : flags(summary)) {
    EXPECT_THAT(flag.text, StartsWith(flag.name));
    all.push_back(flag.name);
  }
  return all;
}

TEST(Flags, NameWhatIsNotToBeReliedOn) {
  EXPECT_THAT(names({}), ElementsAre("NOT RUN"));
  EXPECT_THAT(names(test::example_summary()), ElementsAre());
  Summary summary = test::example_summary();
  summary.status = Status::time_limit;
  summary.contact_end.reset();
  EXPECT_THAT(names(summary), ElementsAre("TIME LIMIT", "PULSE CUT"));
  summary = test::example_summary();
  summary.status = Status::tolerance_not_met;
  summary.bottomed = Moment{.time = 0.005, .velocity = 1};
  summary.extrapolations = {{Beyond::strain, "one"}, {Beyond::rate, "two"}, {Beyond::other, "three"}};
  EXPECT_THAT(names(summary), ElementsAre("TOLERANCE NOT MET", "BOTTOMED", "EXTRAPOLATED STRAIN",
                                          "EXTRAPOLATED RATE", "EXTRAPOLATED"));
  EXPECT_EQ(flags(summary)[3].text, "EXTRAPOLATED RATE: two");
}

TEST(Flags, SayThatAPadIsStruckThroughUnlessItBottomedOut) {
  Summary summary = test::example_summary();
  summary.peak_strain = 0.9989;
  EXPECT_THAT(names(summary), ElementsAre());
  summary.peak_strain = 0.9995;
  EXPECT_THAT(names(summary), ElementsAre("STRUCK THROUGH"));
  summary.bottomed = Moment{.time = 0.005, .velocity = 1};
  EXPECT_THAT(names(summary), ElementsAre("BOTTOMED"));
}

TEST(Flags, SayByHowMuchWhatIsBeyondTheTestsMovesADecisiveFigure) {
  Summary summary = test::example_summary();
  summary.extrapolations = {{Beyond::strain, "strain"}};
  const auto text_with = [&](double low, double high) {
    summary.intervals = Intervals{.figures = {{.key = "peak_acceleration",
                                               .nominal = 100,
                                               .sources = {{Source::continuation, low, high}}}},
                                  .sources = {{Source::continuation, "how it goes on", ""}},
                                  .warning = {}};
    const std::vector<Flag> all = flags(summary, {"peak_acceleration"});
    return all.empty() ? std::string() : all[0].text;
  };
  EXPECT_EQ(text_with(99.5, 100.5), "");
  EXPECT_EQ(text_with(98, 130),
            "EXTRAPOLATED STRAIN: strain; depending on the extrapolation, which is a guess, the peak may be "
            "anywhere from 2 % lower to 30 % higher");
  EXPECT_THAT(text_with(100, std::numeric_limits<double>::infinity()),
              HasSubstr("the peak may be arbitrarily high"));
  EXPECT_THAT(flags(summary, {"hic15"}), ElementsAre());
}

/// A rigid foam on a rigid support: the impactor comes to rest and the force stays up.
TEST(Flags, SayThatAPulseWithoutItsFallingFlankIsCut) {
  Summary summary = test::example_summary();
  EXPECT_TRUE(pulse_is_whole(summary));
  summary.contact_end.reset();
  EXPECT_FALSE(pulse_is_whole(summary));
  EXPECT_THAT(names(summary), ElementsAre("PULSE CUT"));
  EXPECT_THAT(names(test::bottomed_out_summary()), ElementsAre("BOTTOMED"));
}

TEST(Flags, SayThatEnergyWasGainedWhereItIsMoreThanTheErrors) {
  Summary summary = test::example_summary();
  const double error = summary.errors.energy_absorbed + summary.energy.residual / summary.energy.impact;
  summary.energy_absorbed_fraction = -0.9 * error;
  EXPECT_THAT(names(summary), ElementsAre());
  summary.energy_absorbed_fraction = -1.1 * error;
  EXPECT_THAT(names(summary), ElementsAre("ENERGY GAINED"));
  summary.energy_absorbed_fraction = -0.0652;
  EXPECT_THAT(flags(summary)[0].text,
              HasSubstr("more energy than it received, by 6.5 % of the impact energy"));
}

TEST(Flags, SayThatThePeakCameOnTheWayBack) {
  Summary summary = test::example_summary();
  summary.force_on_way_in = 1330;
  EXPECT_THAT(names(summary), ElementsAre("PEAK ON THE WAY BACK"));
  EXPECT_THAT(flags(summary)[0].text, HasSubstr("the force reached only 1330 N"));
}

TEST(Flags, TellARigidSupportFromOneThatYields) {
  Summary summary = test::example_summary();
  summary.bottomed = Moment{.time = 0.005, .velocity = 1};
  EXPECT_THAT(flags(summary)[0].text,
              AllOf(StartsWith("BOTTOMED at 5 ms: "), HasSubstr("the support yielded")));
  summary = test::bottomed_out_summary();
  EXPECT_THAT(flags(summary)[0].text, HasSubstr("no finite value"));
  summary.status = Status::tolerance_not_met;  // on the way there
  EXPECT_THAT(flags(summary)[1].text, HasSubstr("no finite value"));
}

/// What a text says in a person's units, in SI.
TEST(Flags, HaveTheFiguresOfTheirTexts) {
  Summary summary = test::example_summary();
  summary.bottomed = Moment{.time = 0.005, .velocity = 1};
  summary.force_on_way_in = 1330;
  summary.energy_absorbed_fraction = -0.0652;
  summary.softening_rates = {0.5, 20};
  summary.extrapolations = {{Beyond::strain, "strain"}};
  summary.intervals =
      Intervals{.figures = {{.key = "hic15", .nominal = 128, .sources = {{Source::continuation, 96, 160}}}},
                .sources = {{Source::continuation, "how it goes on", ""}},
                .warning = {}};
  EXPECT_EQ(output::flags_json(flags(summary, {"hic15"})).dump(),
            R"([{"name":"ENERGY GAINED","severity":"doubtful","text":")" + flags(summary)[0].text +
                R"(","figures":{"energy_gained_fraction":0.0652}},)"
                R"({"name":"PEAK ON THE WAY BACK","severity":"doubtful","text":")" +
                flags(summary)[1].text +
                R"(","figures":{"force_on_way_in_N":1330.0}},)"
                R"({"name":"BOTTOMED","severity":"doubtful","text":")" +
                flags(summary)[2].text +
                R"(","figures":{"time_s":0.005,"velocity_m_per_s":1.0}},)"
                R"({"name":"SOFTENING","severity":"note","text":")" +
                flags(summary)[3].text +
                R"(","figures":{"rate_per_s":0.5}},)"
                R"({"name":"EXTRAPOLATED STRAIN","severity":"doubtful","text":")" +
                flags(summary, {"hic15"})[4].text +
                R"(","figures":{"hic15_lower_fraction":0.25,"hic15_higher_fraction":0.25}}])");
}

TEST(Flags, NameEachLayerThatWasStruckThrough) {
  Summary summary = test::example_summary();
  summary.layers.resize(3);
  summary.layers[0].struck_through = 0.004;
  summary.layers[2].struck_through = 0.002;
  const std::vector<Flag> all = flags(summary);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].figures.size(), 2U);
  EXPECT_EQ(all[0].figures[0].key, "layer_3_s");
  EXPECT_EQ(all[0].figures[0].value, 0.002);
  EXPECT_EQ(all[0].figures[1].key, "layer_1_s");
  EXPECT_EQ(all[0].figures[1].value, 0.004);
}

/// Every name that a source gives a flag has a severity of its own, and is made by some source.
TEST(Flags, HaveASeverity) {
  std::set<std::string> made;
  const std::filesystem::path root = std::filesystem::path(DASHPAD_SOURCE_DIR) / "src";
  const std::regex text_of_flag(R"re("([A-Z][A-Z ]*[A-Z])(?:: | at \{| for \{|"))re");
  for (const char* room : {"impact", "injury", "laboratory", "model"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      for (std::sregex_iterator found(text.begin(), text.end(), text_of_flag), end; found != end; ++found)
        made.insert((*found)[1].str());
    }
  const auto kinds = flag_kinds();
  for (const std::string& name : made) {
    if (name.size() <= 6) continue;  // "HIC", "CFC", "SAE"
    EXPECT_EQ(std::ranges::count(kinds, name, &FlagKind::name), 1) << name;
  }
  for (const FlagKind& kind : kinds) EXPECT_TRUE(made.contains(kind.name)) << kind.name;
  EXPECT_STREQ(to_string(severity_of("TOLERANCE NOT MET")), "unusable");
  EXPECT_STREQ(to_string(severity_of("EXTRAPOLATED RATE")), "note");
  EXPECT_STREQ(to_string(severity_of("SOMETHING ELSE")), "doubtful");
}

/// Also the end of the time.
TEST(Flags, ComeWithTheMotionAfterAnImpact) {
  const ImpactCase impact = test::example_case();
  Solution solution;
  solution.history.force = {1};
  solution.history.velocity = {1};
  solution.summary = test::example_summary();
  const auto text = [&] {
    return output::to_terminal(
        output::post_impact_document({.mass = 4.5, .velocity = 8}, {.mass = 9, .velocity = 0}, impact,
                                     solution, unit_systems().front()),
        output::Detail::main);
  };
  solution.summary.extrapolations = {{Beyond::strain, "strain\nis large"}};
  solution.summary.status = Status::time_limit;
  EXPECT_THAT(text(),
              AllOf(HasSubstr("\nEXTRAPOLATED STRAIN: strain is large\n"), HasSubstr("\nTIME LIMIT: ")));
}

}  // namespace
}  // namespace dashpad
