/// Pads of layers in case files: what they are read as, how they are written again, and what is said about
/// each kind of bad one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/spit1984/deck.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study_file.hpp"
#include "impact_text.hpp"
#include "output/text/case_toml.hpp"
#include "sample_case.hpp"
#include "shared/samples.hpp"
#include "small_study.hpp"

namespace dashpad::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string layered_case = R"([impactor]
radius = "3 in"
weight = "10 lbf"
speed = "3 m/s"
[pad]
area = "0.02 m2"
[[pad.layers]]
thickness = "20 mm"
material = "team-wendy-hard-pu"
[[pad.layers]]
thickness = "30 mm"
law = "elastic"
scale = 1.5
[pad.layers.parameters]
modulus = "300 kPa"
[support]
type = "rigid"
)";

TEST(LayerCases, AreReadFromTheStruckFaceOn) {
  const Pad pad = read(layered_case).impact.pad;
  ASSERT_EQ(pad.layers.size(), 2U);
  EXPECT_DOUBLE_EQ(pad.thickness, 0.05);
  EXPECT_EQ(pad.area, 0.02);
  EXPECT_EQ(pad.layers[0].material.name, "team-wendy-hard-pu");
  EXPECT_EQ(pad.layers[1].thickness, 0.03);
  EXPECT_EQ(std::get<Elastic>(pad.layers[1].material.law).modulus, 300e3);
  EXPECT_EQ(pad.layers[1].condition.scale, 1.5);
}

TEST(LayerCases, AreWrittenAsTheyAreRead) {
  const ImpactCase once = read(layered_case).impact;
  const ImpactCase again = read(output::case_toml(once, {})).impact;
  ASSERT_EQ(again.pad.layers.size(), 2U);
  EXPECT_EQ(again.pad.area, once.pad.area);
  EXPECT_EQ(again.pad.layers[0].thickness, once.pad.layers[0].thickness);
  EXPECT_EQ(std::get<Foam>(again.pad.layers[0].material.law),
            std::get<Foam>(once.pad.layers[0].material.law));
  // Stresses are written as used.
  EXPECT_EQ(std::get<Elastic>(again.pad.layers[1].material.law).modulus, 450e3);
}

TEST(LayerCases, AreShown) {
  const input::CaseFile file = read(layered_case);
  const UnitSystem units = unit_system("si");
  EXPECT_THAT(output::case_text(file.impact, units),
              HasSubstr("a pad of 2 layers, 20 mm of team-wendy-hard-pu (foam law), then 30 mm of foam of "
                        "the case (elastic "
                        "law), 50 mm thick in all, cut to an area of 0.02 m2, on"));
  const std::string si = output::case_in_si(file.impact, file.options);
  EXPECT_THAT(si, HasSubstr("pad.layers[2].scale = 1.5\n"));
  EXPECT_THAT(si, HasSubstr("pad.layers[2].parameters.modulus = 300000 Pa\n"));
}

struct BadCase {
  std::string from, to, key, rule;
};

TEST(LayerCases, ThatAreBadAreRefusedWithOneFault) {
  const std::string first = "material = \"team-wendy-hard-pu\"";
  const std::string law = "law = \"elastic\"\nscale = 1.5\n[pad.layers.parameters]\nmodulus = \"300 kPa\"";
  std::string many = "area = \"0.02 m2\"";
  for (int i = 0; i < 7; ++i) many += "\n[[pad.layers]]\nthickness = \"5 mm\"\nmaterial = \"eps-15\"";
  const std::vector<BadCase> cases{
      {"20 mm", "1e-9 mm", "pad.layers[1].thickness", "at least 1e-06 times the pad thickness"},
      {"20 mm", "-1 mm", "pad.layers[1].thickness", "more than 0"},
      {"20 mm", "20 s", "pad.layers[1].thickness", "a length is needed"},
      {"20 mm", "200 m", "pad.thickness", "between"},
      {"area = \"0.02 m2\"", "thickness = \"50 mm\"", "pad.thickness", "the layers determine it"},
      {"area = \"0.02 m2\"", "material = \"eps-15\"", "pad.material", "each layer has its own"},
      {"area = \"0.02 m2\"", "scale = 2", "pad.scale", "each layer has its own"},
      {"area = \"0.02 m2\"", many, "pad.layers", "1 to 8 layers"},
      {first, "material = \"no-such-card\"", "pad.layers[1].material", "no such card"},
      {first, "", "pad.layers[1].material", "is missing"},
      {first, first + "\ndensity = \"1e9 kg/m3\"", "pad.layers[1].density", ""},
      {first, first + "\ncolour = \"red\"", "pad.layers[1].colour", "unknown key"},
      {"300 kPa", "-1 Pa", "pad.layers[2].parameters.modulus", "more than 0"},
      {first, "material = \"ensolite-aac-9\"", "pad.layers[1].material",
       "nine-parameter law jumps and falls"},
      {first, "material = \"ensolite-aac-21\"", "pad.layers[1].material",
       "twenty-one-parameter law jumps and falls"},
      {first, "material = \"vn600\"", "pad.layers[1].material", "at 10.5 per second falls"},
      {law,
       "law = \"rigid-foam\"\n[pad.layers.parameters]\ncrush_stress = \"200 kPa\"\ncrush_strain = 0.6\n"
       "second_stress = \"400 kPa\"\nsecond_strain = 0.8",
       "pad.layers[2].law", "rigid on unloading"},
      {law,
       "law = \"viscoelastic-foam\"\n[pad.layers.parameters]\nfirst_modulus = \"30 kPa\"\nfirst_exponent = "
       "6\n"
       "first_share = 3\nfirst_time = \"20 ms\"",
       "pad.layers[2].law", "viscoelastic-foam is not available in layers"},
  };
  for (const BadCase& bad : cases) {
    SCOPED_TRACE(bad.to);
    try {
      read(edited(layered_case, bad.from, bad.to));
      ADD_FAILURE() << "was read";
    } catch (const input::InputError& error) {
      ASSERT_EQ(error.faults().size(), 1U) << error.what();
      EXPECT_EQ(error.faults().front().key, bad.key);
      EXPECT_THAT(error.faults().front().rule, HasSubstr(bad.rule));
    }
  }
}

TEST(LayerCases, WithoutLayersAreRefused) {
  const auto begin = layered_case.find("[[pad.layers]]"), end = layered_case.find("[support]");
  std::string none = layered_case;
  none.replace(begin, end - begin, "layers = []\n");
  EXPECT_THROW(read(none), input::InputError);
}

/// On the way back from an unloading curve with a hump.
TEST(LayerCases, OfAFoamThatPressesHarderOnTheWayBackAreRefused) {
  Foam foam = sample_law<Foam>();
  foam.curves.rate_effect = NoRateEffect{};
  foam.friction = 0;
  foam.unloading_curve = soft_table();
  for (double& stress : foam.unloading_curve->stress) stress *= 0.2;
  foam.unloading_curve->stress[1] = 0.95 * soft_table().stress[1];
  ImpactCase impact = impact_on(foam);
  ASSERT_TRUE(violations(impact).empty());
  PadLayer layer{.thickness = 0.03, .material = impact.pad.material};
  set_layers(impact.pad, {layer, layer});
  const std::vector<Violation> broken = violations(impact);
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken.front().key, "pad.layers[1].unloading");
}

TEST(LayerCases, AreRefusedByTheProgramOf1984) {
  ImpactCase impact = read(layered_case).impact;
  impact.pad.area.reset();
  impact.support = Support::linear(1e5);
  const std::vector<Violation> unsaid = spit1984::what_a_deck_cannot_say(impact);
  ASSERT_EQ(unsaid.size(), 1U);
  EXPECT_EQ(unsaid.front().key, "pad.layers");
}

TEST(LayerCases, VaryLayerByLayer) {
  ImpactCase impact = read(layered_case).impact;
  const CaseQuantities all = quantities_of(impact);
  const auto find = [&](const std::string& key) { return std::ranges::find(all, key, &CaseQuantity::key); };
  for (const char* key :
       {"pad.layers[1].thickness", "pad.layers[1].scale", "pad.layers[1].parameters.friction",
        "pad.layers[2].parameters.modulus", "pad.area"})
    ASSERT_NE(find(key), all.end()) << key;
  for (const char* key : {"pad.thickness", "pad.scale", "pad.parameters.modulus", "pad.layers[3].thickness"})
    EXPECT_EQ(find(key), all.end()) << key;
  find("pad.layers[1].thickness")->set(impact, 0.04);
  EXPECT_DOUBLE_EQ(impact.pad.thickness, 0.07);
  EXPECT_DOUBLE_EQ(find("pad.layers[1].thickness")->get(impact), 0.04);
  find("pad.layers[2].scale")->set(impact, 3);
  EXPECT_EQ(impact.pad.layers[1].condition.scale, 3);
  EXPECT_TRUE(violations(impact).empty());
}

TEST(LayerCases, ComeOutOfAStoreAsTheyWentIn) {
  const TemporaryFolder folder;
  study::Study study = small_study(3);
  study.base = read(layered_case).impact;
  study.factors.push_back({.key = "pad.layers[2].thickness",
                           .unit = "m",
                           .spread = study::Levels{{0.02, 0.03}},
                           .lowest = {},
                           .highest = {}});
  const study::Store store = study::Store::open_for(study, folder.path() / "layers.db");
  const study::Study again = study::stored_study(store);
  ASSERT_EQ(again.base.pad.layers.size(), 2U);
  EXPECT_EQ(again.base.pad.layers[1].condition, study.base.pad.layers[1].condition);
  EXPECT_EQ(std::get<Foam>(again.base.pad.layers[0].material.law),
            std::get<Foam>(study.base.pad.layers[0].material.law));
  EXPECT_EQ(again.factors.size(), 2U);
}

TEST(LayerCases, StruckThroughAreNamedInTheirOrder) {
  Summary summary;
  summary.status = Status::released;
  summary.layers.resize(3);
  EXPECT_TRUE(
      std::ranges::none_of(flags(summary), [](const Flag& flag) { return flag.name == "STRUCK THROUGH"; }));
  summary.layers[0].struck_through = 4e-3;
  summary.layers[2].struck_through = 3e-3;
  EXPECT_THAT(flags(summary),
              Contains(testing::Field(&Flag::text, HasSubstr("layer 3 at 3 ms, then layer 1 at 4 ms"))));
}

/// What is said of a layer that is used beyond its tests, and its strain in text and table.
TEST(LayerCases, SayWhatEachLayerWentThrough) {
  ImpactCase impact = read(layered_case).impact;
  impact.impactor.speed = 5;
  const Solution solution = solve(impact, {.tolerance = 1e-2});
  ASSERT_EQ(solution.summary.layers.size(), 2U);
  ASSERT_TRUE(solution.summary.layers[0].beyond_tested.has_value());
  EXPECT_FALSE(solution.summary.layers[1].beyond_tested.has_value());
  EXPECT_GT(solution.summary.layers[0].peak_strain_rate, 50);
  const std::string text =
      test::impact_text(impact, solution.summary, std::nullopt, unit_system("si"), output::Detail::main);
  EXPECT_THAT(text, HasSubstr("EXTRAPOLATED STRAIN: in layer 1 (team-wendy-hard-pu), the strain reaches"));
  EXPECT_THAT(text, HasSubstr("Peak strain in layer 2"));
  EXPECT_THAT(text, testing::ContainsRegex("rate\\s+up\\s+to\\s+[0-9]+"));
  const std::string all =
      test::impact_text(impact, solution.summary, std::nullopt, unit_system("si"), output::Detail::all);
  EXPECT_THAT(all,
              testing::ContainsRegex("Peak strain rate +[0-9.]+ 1/s [^\n]*of\\s+the\\s+whole\\s+pad,\\s+on"));
  const std::string csv = output::history_csv(solution.history, unit_system("si"));
  EXPECT_THAT(csv.substr(0, csv.find('\n')), HasSubstr("axis_strain_layer_1,axis_strain_layer_2"));
}

}  // namespace
}  // namespace dashpad::test
