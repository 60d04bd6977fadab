/// The cards that Dashpad brings along, and how they are shown: the numbers of Appendix C, digit by digit,
/// and where all of them come from.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/materials.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::filesystem::path folder = std::filesystem::path(DASHPAD_SOURCE_DIR) / "materials";
constexpr double psi = 6894.757293168361;  // Pa

/// Compares with numbers of the report, in the order of the parameter table; stresses in psi.
template <class Law, std::size_t size>
void expect_published(const PadLaw& law, const std::array<double, size>& published) {
  ASSERT_EQ(Law::parameters.size(), size);
  const Law& read = std::get<Law>(law);
  for (std::size_t i = 0; i < size; ++i) {
    const auto& parameter = Law::parameters[i];
    const double unit = std::string(parameter.unit) == "Pa" ? psi : 1;
    EXPECT_NEAR(parameter.of(read) / unit, published[i], 1e-15 * published[i]) << parameter.key;
  }
}

TEST(materials, ensolite_9_has_the_parameters_of_appendix_c) {
  expect_published<NineParameter, 8>(input::read_material(folder / "ensolite-aac-9.toml").value().law,
                                     {7.96, 0.675, 1.09, 8.81e-3, 5.45, 0.166, 9.76e-6, 0.0987});
}

TEST(materials, ensolite_21_has_the_parameters_of_appendix_c) {
  expect_published<TwentyOneParameter, 16>(input::read_material(folder / "ensolite-aac-21.toml").value().law,
                                           {7.96, 0.675, 1.09, 0.13, 0.156, 3.08, 4.153, 0.19, 3.17, 0.58,
                                            2.57, 0.296, 2.23, 1.64e-3, 9.76e-6, 0.0987});
}

std::vector<Material> all_cards() {
  std::vector<Material> cards;
  for (const auto& card : input::list_materials(folder).value())
    cards.push_back(input::read_material(card).value());
  return cards;
}

bool is_of_report(const Material& material) { return material.name.starts_with("ensolite-aac"); }

TEST(materials, all_cards_are_sourced_and_fitted) {
  const auto cards = input::list_materials(folder).value();
  ASSERT_EQ(cards.size(), 20U);
  for (const auto& card : cards) {
    const Material material = input::read_material(card).value();
    EXPECT_EQ(material.name, card.stem());
    EXPECT_FALSE(material.source.empty()) << card;
    EXPECT_FALSE(material.title.empty()) << card;
    ASSERT_TRUE(material.fitted) << card;
    EXPECT_TRUE(violations(material).empty()) << card;
  }
}

TEST(materials, ensolite_is_of_appendix_c) {
  for (const Material& material : all_cards()) {
    if (!is_of_report(material)) continue;
    EXPECT_NE(material.source.find("Appendix C"), std::string::npos) << material.name;
    EXPECT_FALSE(material.also_published.empty()) << material.name;
    EXPECT_EQ(material.fitted->highest_strain, 0.95);
    EXPECT_EQ(material.fitted->lowest_rate, 1);
    EXPECT_EQ(material.fitted->highest_rate, 100);
  }
}

TEST(materials, other_cards_say_what_they_are_worth) {
  for (const Material& material : all_cards()) {
    if (is_of_report(material)) continue;
    EXPECT_FALSE(material.basis.empty()) << material.name;
    EXPECT_FALSE(material.licence.empty()) << material.name;
    EXPECT_FALSE(material.reservations.empty()) << material.name;
    const std::vector<double> rates = laboratory::tested_rates(material);
    EXPECT_LE(material.fitted->lowest_rate, rates.front()) << material.name;
    EXPECT_GE(material.fitted->highest_rate, rates.back()) << material.name;
  }
}

TEST(materials, published_values_that_no_law_uses_are_kept_as_text) {
  const Material material = input::read_material(folder / "ensolite-aac-9.toml").value();
  ASSERT_EQ(material.also_published.size(), 1U);
  EXPECT_EQ(material.also_published.front(),
            (std::pair<std::string, std::string>{"zero_time_modulus", "22.127 psi"}));
}

TEST(materials, a_folder_is_listed_by_name) {
  const test::TemporaryFolder temporary;
  for (const std::string name : {"b.toml", "a.toml", "notes.txt"}) temporary.write(name, "");
  std::filesystem::create_directory(temporary.path() / "c.toml");
  const auto cards = input::list_materials(temporary.path()).value();
  ASSERT_EQ(cards.size(), 2U);
  EXPECT_EQ(cards[0].stem(), "a");
  EXPECT_EQ(cards[1].stem(), "b");
  EXPECT_THROW(input::list_materials(temporary.path() / "none").value(), input::InputError);
}

// --- How they are shown ---

Material sample() {
  Material foam;
  foam.name = "my-foam";
  foam.title = "Some foam";
  foam.source = "a laboratory";
  foam.basis = "test";
  foam.licence = "CC0";
  foam.density = 100;
  foam.reservations = {"Unloading assumed: nothing is known.", "One specimen."};
  Foam law;
  law.curves.slowest_rate = 0.01;
  law.curves.base = TableCurve{{0.1, 0.3, 0.6}, {10e3, 30e3, 60e3}};
  law.curves.rate_effect = FactorRateEffect{{10}, {2}};
  foam.law = law;
  foam.fitted = FittedRange{0.6, 0.01, 10};
  return foam;
}

TEST(materials, are_listed_in_a_table) {
  Material plain = sample();
  plain.name = "plain";
  plain.law = Elastic{};
  plain.basis.clear();
  plain.density.reset();
  plain.reservations.clear();
  plain.fitted.reset();
  const std::string text = output::to_terminal(
      output::materials_document({sample(), plain}, unit_system("si")), output::Detail::main);
  EXPECT_THAT(text,
              AllOf(ContainsRegex("\nName +Law +kg/m3 +Strain +Rates"),
                    ContainsRegex("my-foam +foam +100 +0.6 +0.01 to 10 +test +Unloading assumed .\\+1.\n"),
                    ContainsRegex("plain +elastic +- +- +- +- +-\n")));
}

std::string text_of(const Material& material) {
  return output::to_terminal(output::material_document(material, unit_system("si")), output::Detail::main);
}

TEST(materials, are_shown_whole) {
  const std::string text = text_of(sample());
  EXPECT_THAT(text, AllOf(ContainsRegex("\nBasis +test\n"), ContainsRegex("\nLicence +CC0\n"),
                          ContainsRegex("\nDensity +100 kg/m3\n"),
                          HasSubstr("\nUnloading assumed: nothing is known.\nOne specimen.\n"),
                          ContainsRegex("\nCurve +table, 3 points up to a strain of 0.6, at 0.01 1/s\n"),
                          ContainsRegex("\nRate +factor 2 at 10 1/s\n"), ContainsRegex("friction +f +0 ")));
}

/// The made-up curve is a straight line of 100 kPa, twice as steep at 10 1/s.
TEST(materials, have_stresses_at_a_few_strains) {
  const std::string text = text_of(sample());
  EXPECT_THAT(
      text,
      AllOf(ContainsRegex("Stress in first loading +at strain 0.1 +at strain 0.25 +at strain 0.5\n"),
            ContainsRegex("at 0.01 1/s +10 kPa +25 kPa +50 kPa\n"),
            ContainsRegex("at 10 1/s +20 kPa +50 kPa +100 kPa\n"), Not(HasSubstr("beyond the last strain"))));
  Material short_curve = sample();
  std::get<Foam>(short_curve.law).curves.base = TableCurve{{0.1, 0.2, 0.3}, {10e3, 20e3, 30e3}};
  EXPECT_THAT(text_of(short_curve),
              AllOf(HasSubstr("at strain 0.5 *\n"), HasSubstr("* beyond the last strain of the curve\n")));
}

TEST(materials, have_a_line_and_a_dashed_continuation_each_in_the_colour_of_their_family) {
  std::vector<Material> materials{sample(), sample(), sample()};
  materials[1].name = "my-other";
  materials[2].name = "yours";
  const output::Plot plot = output::materials_plot(materials, unit_system("si"));
  ASSERT_EQ(plot.panels.size(), 1U);
  const std::vector<output::Series>& series = plot.panels.front().series;
  ASSERT_EQ(series.size(), 6U);
  EXPECT_EQ(series[0].style, output::SeriesStyle::solid_line);
  EXPECT_EQ(series[1].style, output::SeriesStyle::dashed_line);
  EXPECT_NEAR(series[0].x.back(), 0.6, 1e-6);
  EXPECT_EQ(series[0].x.back(), series[1].x.front());
  EXPECT_NEAR(series[1].x.back(), 0.8, 1e-6);
  EXPECT_EQ(series[1].end_label, "my-foam");
  EXPECT_EQ(series[0].palette_index, series[2].palette_index);
  EXPECT_NE(series[0].palette_index, series[4].palette_index);
  EXPECT_TRUE(plot.panels.front().y.logarithmic);
}

}  // namespace
}  // namespace dashpad
