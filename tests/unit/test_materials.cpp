/// The cards that Dashpad brings along: the numbers of Appendix C, digit by digit, and where they come from.

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <variant>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

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
    EXPECT_NEAR(read.*parameter.member / unit, published[i], 1e-15 * published[i]) << parameter.key;
  }
}

TEST(materials, ensolite_9_has_the_parameters_of_appendix_c) {
  expect_published<NineParameter, 8>(input::read_material(folder / "ensolite-aac-9.toml").law,
                                     {7.96, 0.675, 1.09, 8.81e-3, 5.45, 0.166, 9.76e-6, 0.0987});
}

TEST(materials, ensolite_21_has_the_parameters_of_appendix_c) {
  expect_published<TwentyOneParameter, 16>(input::read_material(folder / "ensolite-aac-21.toml").law,
                                           {7.96, 0.675, 1.09, 0.13, 0.156, 3.08, 4.153, 0.19, 3.17, 0.58,
                                            2.57, 0.296, 2.23, 1.64e-3, 9.76e-6, 0.0987});
}

TEST(materials, all_cards_are_sourced_and_fitted) {
  const auto cards = input::list_materials(folder);
  ASSERT_EQ(cards.size(), 2U);
  for (const auto& card : cards) {
    const Material material = input::read_material(card);
    EXPECT_EQ(material.name, card.stem());
    EXPECT_NE(material.source.find("Appendix C"), std::string::npos) << card;
    EXPECT_FALSE(material.title.empty()) << card;
    EXPECT_FALSE(material.also_published.empty()) << card;
    ASSERT_TRUE(material.fitted) << card;
    EXPECT_EQ(material.fitted->highest_strain, 0.95);
    EXPECT_EQ(material.fitted->lowest_rate, 1);
    EXPECT_EQ(material.fitted->highest_rate, 100);
    EXPECT_TRUE(violations(material).empty()) << card;
  }
}

TEST(materials, published_values_that_no_law_uses_are_kept_as_text) {
  const Material material = input::read_material(folder / "ensolite-aac-9.toml");
  ASSERT_EQ(material.also_published.size(), 1U);
  EXPECT_EQ(material.also_published.front(),
            (std::pair<std::string, std::string>{"zero_time_modulus", "22.127 psi"}));
}

TEST(materials, a_folder_is_listed_by_name) {
  const test::TemporaryFolder temporary;
  for (const std::string name : {"b.toml", "a.toml", "notes.txt"}) temporary.write(name, "");
  std::filesystem::create_directory(temporary.path() / "c.toml");
  const auto cards = input::list_materials(temporary.path());
  ASSERT_EQ(cards.size(), 2U);
  EXPECT_EQ(cards[0].stem(), "a");
  EXPECT_EQ(cards[1].stem(), "b");
  EXPECT_THROW(input::list_materials(temporary.path() / "none"), input::InputError);
}

}  // namespace
}  // namespace dashpad
