/// The presets of standards that Dashpad brings along, and what is said about a bad one.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/input/standard_file.hpp"
#include "dashpad/output/assessment.hpp"
#include "sample_case.hpp"
#include "shared/generated_text.hpp"
#include "shared/gravity.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using injury::SourceKind;
using injury::Standard;
using test::edited;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path folder = test::source / "standards";
constexpr double kmh = 1 / 3.6;

Standard preset(const std::string& text) {
  const input::StandardChoice choice = input::standard_choice(text);
  return injury::with_variants(
      input::read_standard(input::find_standard(choice.name, folder).value()).value(), choice.variants);
}

std::string text_of(const Standard& standard) {
  return output::to_terminal(output::standard_document(standard, unit_systems().front()),
                             output::Detail::all);
}

std::vector<Standard> all_presets() {
  std::vector<Standard> presets;
  for (const auto& file : input::list_standards(folder).value())
    presets.push_back(input::read_standard(file).value());
  return presets;
}

std::vector<const injury::StandardValue*> values_of(const Standard& standard) {
  std::vector<const injury::StandardValue*> values{&standard.mass, &standard.radius, &standard.speed};
  for (const injury::StandardVariant& variant : standard.variants)
    for (const auto* value : {&variant.mass, &variant.radius, &variant.speed})
      if (*value) values.push_back(&**value);
  return values;
}

std::vector<const injury::Origin*> origins_of(const Standard& standard) {
  std::vector<const injury::Origin*> origins;
  for (const injury::StandardValue* value : values_of(standard)) origins.push_back(&value->origin);
  for (const injury::Criterion& criterion : standard.criteria) origins.push_back(&criterion.origin);
  return origins;
}

TEST(standards, every_preset_names_a_source_for_every_value) {
  const auto presets = all_presets();
  EXPECT_GE(presets.size(), 12U);
  for (const Standard& standard : presets) {
    SCOPED_TRACE(standard.name);
    EXPECT_FALSE(standard.title.empty());
    EXPECT_FALSE(standard.source.empty());
    EXPECT_FALSE(standard.criteria.empty());
    for (const injury::Origin* origin : origins_of(standard)) EXPECT_FALSE(origin->source.empty());
  }
}

TEST(standards, every_preset_has_its_row_in_the_documents) {
  const std::string document = test::text_of(test::source / "docs" / "standards.md");
  for (const auto& file : input::list_standards(folder).value())
    EXPECT_THAT(document, ContainsRegex("\n\\|[^|]*`" + file.stem().string() + "`[^|]*\\|"));
}

TEST(standards, every_preset_names_the_text_that_binds) {
  for (const Standard& standard : all_presets()) EXPECT_FALSE(standard.article.empty()) << standard.name;
}

/// What is the law's own text and what repeats it, typed a second time.
TEST(standards, sources_are_told_apart) {
  const auto limit = [](const std::string& name) { return preset(name).criteria.front().origin.kind; };
  EXPECT_EQ(limit("fmvss-201-instrument-panel"), SourceKind::secondary);
  EXPECT_EQ(limit("fmvss-201-seat-back"), SourceKind::secondary);
  EXPECT_EQ(limit("fmvss-201u"), SourceKind::secondary);
  EXPECT_EQ(limit("ece-r21"), SourceKind::none);
  EXPECT_EQ(limit("cpsc-1203"), SourceKind::own_text);
  EXPECT_EQ(limit("fmvss-208-hic15"), SourceKind::own_text);
  EXPECT_EQ(limit("fmvss-218"), SourceKind::none);
  EXPECT_EQ(preset("fmvss-218").mass.origin.kind, SourceKind::own_text);
  EXPECT_EQ(preset("fmvss-218").radius.origin.kind, SourceKind::none);
  EXPECT_THAT(text_of(preset("fmvss-201-instrument-panel")),
              AllOf(ContainsRegex("\nText +49 CFR 571.201 S5.1\n"),
                    ContainsRegex("\nSource +secondary: 15 NYCRR 55.2 "),
                    ContainsRegex("\nSpeed +[0-9.]+ m/s +secondary: 15 NYCRR 55.2\n")));
}

/// A guess must never pass for something that was read.
TEST(standards, general_knowledge_and_choices_are_no_source_and_unverified) {
  for (const Standard& standard : all_presets())
    for (const injury::Origin* origin : origins_of(standard)) {
      const bool guessed =
          origin->source.starts_with("general knowledge") || origin->source.starts_with("chosen");
      EXPECT_EQ(guessed, origin->kind == SourceKind::none) << standard.name << ": " << origin->source;
      EXPECT_FALSE(guessed && origin->verified) << standard.name << ": " << origin->source;
    }
}

TEST(standards, unverified_values_warn) {
  for (const Standard& standard : all_presets()) {
    SCOPED_TRACE(standard.name);
    const auto origins = origins_of(standard);
    const bool doubt = !std::ranges::all_of(origins, &injury::Origin::verified);
    const std::string text = text_of(standard);
    EXPECT_EQ(text.find("\nUNVERIFIED: ") != std::string::npos, doubt);
    EXPECT_EQ(text.find("  UNVERIFIED; ") != std::string::npos, doubt);
    EXPECT_EQ(output::standard_line(standard).find("unverified)") != std::string::npos, doubt);
    EXPECT_THAT(text, ContainsRegex("nor\\s+a\\s+certification"));
  }
}

/// With variants in force the others say nothing about the result.
TEST(standards, unverified_values_of_variants_not_in_force_do_not_warn) {
  Standard standard = preset("fmvss-201-instrument-panel");
  injury::StandardVariant doubtful{
      .name = "doubtful", .title = "Not read", .mass = injury::StandardValue{}, .radius = {}, .speed = {}};
  standard.variants.push_back(doubtful);
  EXPECT_THAT(text_of(standard), AllOf(HasSubstr("UNVERIFIED: 1 value, marked below"),
                                       HasSubstr("Variant doubtful"), HasSubstr("Variant air-bag")));
  const std::string chosen = text_of(injury::with_variants(standard, {"air-bag"}));
  EXPECT_THAT(chosen, AllOf(Not(HasSubstr("UNVERIFIED")), Not(HasSubstr("Variant ")),
                            HasSubstr("\nVariants not chosen: doubtful\n")));
  EXPECT_THAT(text_of(injury::with_variants(standard, {"doubtful"})), HasSubstr("UNVERIFIED: 1 value, "));
  EXPECT_THAT(text_of(injury::with_variants(standard, {"air-bag", "doubtful"})),
              Not(HasSubstr("not chosen")));
}

TEST(standards, below_a_limit_is_strict) {
  for (const Standard& standard : all_presets())
    for (const injury::Criterion& criterion : standard.criteria) {
      const bool below = criterion.description.find("below") != std::string::npos;
      EXPECT_EQ(criterion.strict, below) << standard.name << ": " << criterion.description;
      EXPECT_EQ(text_of(standard).find("  below ") != std::string::npos, below);
    }
  EXPECT_TRUE(preset("en-1078").criteria[0].strict);
  EXPECT_TRUE(preset("fmvss-201u").criteria[0].strict);
}

TEST(standards, every_variant_can_be_chosen) {
  for (const Standard& standard : all_presets())
    for (const injury::StandardVariant& variant : standard.variants)
      EXPECT_NO_THROW(injury::with_variants(standard, {variant.name}))
          << standard.name << ":" << variant.name;
}

struct Row {
  std::string name;
  double mass, radius, speed;  ///< 0 where the case decides
  const char* metric;
  double limit;
};

/// The figures of the sources, typed a second time.
TEST(standards, presets_have_the_figures_of_their_sources) {
  const std::vector<Row> rows{
      {"fmvss-201-instrument-panel", 6.8, 0.0825, 24 * kmh, "clip_3ms", 80 * g},
      {"fmvss-201-instrument-panel:air-bag", 6.8, 0.0825, 19.3 * kmh, "clip_3ms", 80 * g},
      {"fmvss-201-seat-back", 6.8, 0.0825, 24 * kmh, "clip_3ms", 80 * g},
      {"fmvss-201u", 4.54, 0.08, 24 * kmh, "hic_d", 1000},
      {"fmvss-201u:deployed", 4.54, 0.08, 19 * kmh, "hic_d", 1000},
      {"ece-r21", 6.8, 0.0825, 24.1 * kmh, "clip_3ms", 80 * g},
      {"en-1078", 4.7, 0.091, 5.52, "peak_acceleration", 250 * g},
      {"en-1078:kerbstone:a", 3.1, 0.080, 16.5 * kmh, "peak_acceleration", 250 * g},
      {"cpsc-1203", 5, 0.091, 6.2, "peak_acceleration", 300 * g},
      {"cpsc-1203:hemispherical", 5, 0.048, 4.8, "peak_acceleration", 300 * g},
      {"ece-22-05:o", 6.1, 0.099, 7.5, "peak_acceleration", 275 * g},
      {"ece-22-06:a", 3.1, 0.080, 7.5, "hic_unlimited", 2400},
      {"ece-22-06-low-energy", 4.7, 0.091, 6, "peak_acceleration", 180 * g},
      {"ece-22-06-low-energy", 4.7, 0.091, 6, "hic_unlimited", 1300},
      {"ece-22-06-high-energy", 4.7, 0.091, 8.2, "peak_acceleration", 275 * g},
      {"ece-22-06-high-energy", 4.7, 0.091, 8.2, "hic_unlimited", 2880},
      {"fmvss-218", 5, 0.088, 6, "peak_acceleration", 400 * g},
      {"fmvss-218:hemispherical:small", 3.5, 0.048, 5.2, "peak_acceleration", 400 * g},
      {"nocsae-football", 4.9, 0.09, std::sqrt(2 * g * 1.524), "severity_index", 1200},
      {"nocsae-football-1970s", 4.9, 0.09, std::sqrt(2 * g * 1.524), "severity_index", 1500},
      {"en-1177", 4.6, 0.08, 0, "peak_acceleration", 200 * g},
      {"en-1177", 4.6, 0.08, 0, "hic_unlimited", 1000},
      {"astm-f1292", 4.6, 0.08, 0, "peak_acceleration", 200 * g},
      {"astm-f1936", 20 * 0.45359237, 0, std::sqrt(2 * g * 24 * 0.0254), "peak_acceleration", 200 * g},
      {"fmvss-208-hic15", 0, 0, 0, "hic15", 700},
      {"fmvss-208-hic36", 0, 0, 0, "hic36", 1000},
      {"fmvss-202a-hic15", 0, 0, 0, "hic15", 500},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const Standard standard = preset(row.name);
    EXPECT_DOUBLE_EQ(standard.mass.value.value_or(0), row.mass);
    EXPECT_DOUBLE_EQ(standard.radius.value.value_or(0), row.radius);
    EXPECT_DOUBLE_EQ(standard.speed.value.value_or(0), row.speed);
    const auto limit = std::ranges::find_if(
        standard.criteria, [&](const injury::Criterion& criterion) { return criterion.limits(row.metric); });
    ASSERT_NE(limit, standard.criteria.end());
    EXPECT_DOUBLE_EQ(limit->limit, row.limit);
  }
}

TEST(standards, fmvss_218_limits_two_dwell_times) {
  const Standard standard = preset("fmvss-218");
  ASSERT_EQ(standard.criteria.size(), 3U);
  EXPECT_DOUBLE_EQ(standard.criteria[1].level, 200 * g);
  EXPECT_DOUBLE_EQ(standard.criteria[1].limit, 2e-3);
  EXPECT_DOUBLE_EQ(standard.criteria[2].level, 150 * g);
  EXPECT_DOUBLE_EQ(standard.criteria[2].limit, 4e-3);
}

/// A criterion for each of those that sports mats have to keep, at `share` of what the impact gives.
Standard mat_standard(const Summary& summary, double share) {
  Standard standard;
  standard.title = standard.name = "made up";
  for (const auto& [key, value] :
       {std::pair{"peak_acceleration", *summary.peak_acceleration},
        {"peak_penetration", summary.peak_penetration},
        {"rebound_height", *summary.rebound_speed * *summary.rebound_speed / (2 * g)},
        {"restitution", *summary.restitution}})
    standard.criteria.push_back(
        {.quantity = &result_quantity(key), .limit = share * value, .description = {}, .origin = {}});
  return standard;
}

TEST(standards, a_mat_may_be_limited_in_penetration_and_rebound) {
  const ImpactCase impact = test::read(test::good_case).impact;
  const Solution solution = solve(impact);
  const injury::Assessment kept = injury::assess(mat_standard(solution.summary, 1.01), impact, solution);
  ASSERT_EQ(kept.results.size(), 4U);
  for (const injury::CriterionResult& result : kept.results) {
    SCOPED_TRACE(result.criterion.quantity->key);
    EXPECT_NEAR(*result.value, result.criterion.limit / 1.01, 1e-12 * result.criterion.limit);
    EXPECT_GT(result.error, 0);
    EXPECT_EQ(result.verdict, injury::Verdict::pass);
  }
  const injury::Assessment exceeded = injury::assess(mat_standard(solution.summary, 0.99), impact, solution);
  for (const injury::CriterionResult& result : exceeded.results)
    EXPECT_EQ(result.verdict, injury::Verdict::fail) << result.criterion.quantity->key;
}

TEST(standards, a_choice_is_a_name_with_variants) {
  const auto expect = [](const std::string& text, const std::string& name,
                         const std::vector<std::string>& variants) {
    const input::StandardChoice choice = input::standard_choice(text);
    EXPECT_EQ(choice.name, name) << text;
    EXPECT_EQ(choice.variants, variants) << text;
  };
  expect("en-1078", "en-1078", {});
  expect("en-1078:kerbstone:a", "en-1078", {"kerbstone", "a"});
  expect("./my.toml", "./my.toml", {});
  expect("./a:b/my.toml:fast", "./a:b/my.toml", {"fast"});
  expect("./a:b/my.toml", "./a:b/my.toml", {});
  expect("en-1078:", "en-1078", {""});
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(standards, unknown_names_and_variants_are_refused_with_those_there_are) {
  EXPECT_THAT(message_of([] { preset("en-1079"); }), HasSubstr("did you mean \"en-1078\"?"));
  // Capitals and blanks are of no account, however many there are.
  EXPECT_THAT(message_of([] { preset("EN 1078"); }), HasSubstr("did you mean \"en-1078\"?"));
  EXPECT_THAT(message_of([] { preset("FMVSS_208 HIC15"); }), HasSubstr("did you mean \"fmvss-208-hic15\"?"));
  EXPECT_THAT(message_of([] { preset("ECE-22-06"); }), HasSubstr("did you mean \"ece-22-06\"?"));
  EXPECT_THAT(message_of([] { preset("fmvss-201"); }),
              HasSubstr("did you mean \"fmvss-201-instrument-panel\", \"fmvss-201-seat-back\" or "
                        "\"fmvss-201u\"?"));
  EXPECT_THAT(message_of([] { preset("nocsae-football-1"); }),
              HasSubstr("did you mean \"nocsae-football-1970s\"?"));
  EXPECT_THAT(message_of([] { preset("en-1078:curb"); }),
              HasSubstr("its variants are kerbstone, a, c, e, m, o"));
  EXPECT_THAT(message_of([] { preset("fmvss-201-seat-back:any"); }), HasSubstr("it has none"));
  EXPECT_THAT(message_of([] { preset("en-1078:a:o"); }), HasSubstr("both set the mass"));
  EXPECT_THAT(message_of([] { preset("en-1078:a:a"); }), HasSubstr("both set the mass"));
  EXPECT_THROW(input::list_standards(folder / "none").value(), input::InputError);
  EXPECT_THAT(message_of([] { preset("../standards/en-1177"); }), HasSubstr("a path must end in .toml"));
}

TEST(standards, the_impactor_takes_the_place_of_that_of_the_case) {
  const ImpactCase impact = test::read(test::good_case).impact;
  const ImpactCase assessed = injury::with_impactor_of(preset("en-1177"), impact);
  EXPECT_DOUBLE_EQ(assessed.impactor.mass, 4.6);
  EXPECT_DOUBLE_EQ(std::get<Sphere>(assessed.impactor.nose).radius, 0.08);
  EXPECT_EQ(assessed.impactor.speed, impact.impactor.speed);
  EXPECT_EQ(assessed.pad.thickness, impact.pad.thickness);
}

TEST(standards, what_the_user_gives_takes_the_place_of_the_standard) {
  const Standard standard = injury::with_user_values(
      preset("fmvss-201-seat-back"), {.mass = 7, .radius = {}, .speed = {}, .drop_height = 2});
  EXPECT_EQ(standard.mass.value, 7);
  EXPECT_EQ(standard.mass.instead, 6.8);
  EXPECT_TRUE(standard.mass.chosen_by_user);
  EXPECT_FALSE(standard.radius.chosen_by_user);
  EXPECT_DOUBLE_EQ(*standard.speed.value, std::sqrt(4 * g));
  EXPECT_EQ(standard.speed.drop_height, 2);
  EXPECT_DOUBLE_EQ(*standard.speed.instead, 24 * kmh);
}

TEST(standards, a_value_that_is_the_standards_own_replaces_nothing) {
  const Standard standard =
      injury::with_user_values(preset("fmvss-201-seat-back"),
                               {.mass = 6.8, .radius = 0.0825 * (1 + 1e-15), .speed = 7, .drop_height = {}});
  EXPECT_FALSE(standard.mass.chosen_by_user || standard.mass.instead);
  EXPECT_FALSE(standard.radius.chosen_by_user || standard.radius.instead);
  EXPECT_TRUE(standard.speed.chosen_by_user && standard.speed.instead);
}

// --- Bad presets ---

const std::string good_preset = R"(title = "A standard"
source = "made up"
kind = "secondary"
[mass]
value = "5 kg"
source = "made up"
kind = "secondary"
verified = true
[radius]
value = "80 mm"
source = "made up"
kind = "secondary"
verified = false
[speed]
drop_height = "1 m"
source = "made up"
kind = "secondary"
verified = true
[[criteria]]
metric = "dwell_time"
level_g = 150
limit = "4 ms"
description = "short"
source = "made up"
kind = "secondary"
verified = true
[variants.light]
title = "a light one"
[variants.light.mass]
value = "4 kg"
source = "made up"
kind = "secondary"
verified = true
)";

std::vector<input::Fault> faults_of(const std::string& text) {
  const test::TemporaryFolder temporary;
  try {
    input::read_standard(temporary.write("made-up.toml", text)).value();
  } catch (const input::InputError& error) {
    return error.faults();
  }
  return {};
}

struct Expected {
  int line;
  std::string key;
  std::string rule;
};

void expect_faults(const std::string& text, const std::vector<Expected>& expected) {
  const std::vector<input::Fault> faults = faults_of(text);
  const std::string all = faults.empty() ? "no fault" : input::InputError(faults).what();
  ASSERT_EQ(faults.size(), expected.size()) << all;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_EQ(faults[i].line, expected[i].line) << all;
    EXPECT_EQ(faults[i].key, expected[i].key) << all;
    EXPECT_THAT(faults[i].rule, HasSubstr(expected[i].rule)) << all;
  }
}

TEST(standard_faults, a_good_preset_has_none) {
  const test::TemporaryFolder temporary;
  const Standard standard = input::read_standard(temporary.write("made-up.toml", good_preset)).value();
  EXPECT_EQ(standard.name, "made-up");
  EXPECT_DOUBLE_EQ(*standard.speed.value, std::sqrt(2 * g));
  EXPECT_EQ(injury::with_variants(standard, {"light"}).mass.value, 4);
  EXPECT_FALSE(standard.criteria[0].strict);
  for (const std::string value : {"true", "false"}) {
    const std::string text = edited(good_preset, "limit =", "strict = " + value + "\nlimit =");
    EXPECT_EQ(
        input::read_standard(temporary.write("strict-" + value + ".toml", text)).value().criteria[0].strict,
        value == "true");
  }
}

TEST(standard_faults, each_fault_is_named_with_line_key_and_rule) {
  struct Edit {
    std::string from, to;
    std::vector<Expected> faults;
  };
  const std::vector<Edit> edits{
      {"source = \"made up\"\nkind = \"secondary\"\n[mass]",
       "kind = \"secondary\"\n[mass]",
       {{0, "source", "is missing"}}},
      {"kind = \"secondary\"\n[mass]", "[mass]", {{0, "kind", "is missing"}}},
      {"kind = \"secondary\"\n[mass]",
       "kind = \"law\"\n[mass]",
       {{3, "kind", "must be one of own text, secondary, no source"}}},
      {"kind = \"secondary\"\nverified = true\n[radius]",
       "kind = \"no source\"\nverified = true\n[radius]",
       {{8, "mass.verified", "cannot be true without a source"}}},

      {"title =", "titel =", {{0, "title", "is missing"}, {1, "titel", "did you mean"}}},
      {"5 kg", "5 m", {{5, "mass.value", "a mass is needed"}}},
      {"5 kg", "0 kg", {{5, "mass.value", "must be more than 0"}}},
      {"\"5 kg\"", "5", {{5, "mass.value", "needs a unit"}}},
      {"value = \"5 kg\"\n", "", {{4, "mass.value", "give either value or from_case"}}},
      {"value = \"5 kg\"", "from_case = false", {{4, "mass.value", "give either value or from_case"}}},
      {"value = \"5 kg\"",
       "from_case = 1",
       {{4, "mass.value", "give either value"}, {5, "mass.from_case", "must be true or false"}}},
      {"value = \"5 kg\"",
       "drop_height = \"1 m\"",
       {{4, "mass.value", "give either value"}, {5, "mass.drop_height", "unknown key"}}},
      {"drop_height =",
       "value = \"3 m/s\"\ndrop_height =",
       {{15, "speed.value", "give exactly one of value, drop_height"}}},
      {"verified = false\n", "", {{9, "radius.verified", "is missing; must be true or false"}}},
      {"verified = false", "verified = \"no\"", {{13, "radius.verified", "must be true or false"}}},
      {"metric = \"dwell_time\"",
       "metric = \"dwel_time\"",
       {{20, "criteria[1].metric", "did you mean \"dwell_time\"?"}}},
      {"metric = \"dwell_time\"",
       "metric = \"peak_acceleration\"",
       {{19, "criteria[1].limit_g", "is missing"},
        {21, "criteria[1].level_g", "unknown key"},
        {22, "criteria[1].limit", "unknown key"}}},
      {"level_g = 150", "level_g = -1", {{21, "criteria[1].level_g", "must be more than 0"}}},
      {"level_g = 150", "level_g = 1e308", {{21, "criteria[1].level_g", "too large to compute with"}}},
      {"\"1 m\"", "\"1e308 m\"", {{15, "speed.drop_height", "must have a magnitude between"}}},
      {"limit = \"4 ms\"",
       "strict = 1\nlimit = \"4 ms\"",
       {{22, "criteria[1].strict", "must be true or false"}}},
      {"\"4 ms\"", "4", {{22, "criteria[1].limit", "needs a unit"}}},
      {"description = \"short\"\n", "", {{19, "criteria[1].description", "is missing"}}},
      {"title = \"a light one\"\n", "", {{27, "variants.light.title", "is missing"}}},
      {"[variants.light]",
       "[variants.\"a:b\"]",
       {{27, "variants.a:b", "lower-case letters"}, {29, "variants.light.title", "is missing"}}},
      {"light.mass",
       "light.weight",
       {{27, "variants.light.mass", "must replace"}, {29, "variants.light.weight", "unknown key"}}},
  };
  for (const auto& [from, to, expected] : edits) {
    SCOPED_TRACE(fmt::format("{} -> {}", from, to));
    expect_faults(edited(good_preset, from, to), expected);
  }
}

TEST(standard_faults, criteria_are_needed) {
  const std::string values = good_preset.substr(0, good_preset.find("[[criteria]]"));
  expect_faults(values, {{0, "criteria", "is missing"}});
  expect_faults("criteria = []\n" + values, {{1, "criteria", "at least one criterion"}});
  expect_faults("criteria = [3]\n" + values, {{1, "criteria[1]", "must be a table"}});
}

TEST(standard_faults, all_faults_come_at_once_in_the_order_of_lines) {
  std::string text = edited(good_preset, "5 kg", "5 s");
  text = edited(text, "80 mm", "-80 mm");
  text = edited(text, "level_g", "level");
  expect_faults(text, {{5, "mass.value", "a mass is needed"},
                       {10, "radius.value", "must be more than 0"},
                       {19, "criteria[1].level_g", "is missing"},
                       {21, "criteria[1].level", "did you mean"}});
}

}  // namespace
}  // namespace dashpad
