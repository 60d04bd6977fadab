// What is shown of many faults.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

std::vector<input::Fault> many(int count, const std::string& key, const std::string& rule) {
  std::vector<input::Fault> faults;
  for (int i = 0; i < count; ++i)
    faults.push_back({"drop.csv", i + 2, key, std::to_string(i) + "x: y", rule});
  return faults;
}

std::vector<std::string> shown(const std::vector<input::Fault>& faults) {
  std::vector<std::string> lines;
  for (const input::Fault& fault : faults) lines.push_back(to_string(fault));
  return input::abridged(lines);
}

TEST(fault, of_one_kind_five_are_shown_and_the_rest_is_counted) {
  EXPECT_THAT(
      shown(many(200, "acc", "must be a number")),
      ElementsAre("drop.csv:2: acc = 0x: y: must be a number", "drop.csv:3: acc = 1x: y: must be a number",
                  "drop.csv:4: acc = 2x: y: must be a number", "drop.csv:5: acc = 3x: y: must be a number",
                  "drop.csv:6: acc = 4x: y: must be a number", "and 195 more of this kind"));
  EXPECT_EQ(shown(many(5, "acc", "must be a number")).size(), 5U);
  EXPECT_THAT(shown(many(6, "acc", "must be a number")).back(), "and 1 more of this kind");
}

TEST(fault, another_key_or_rule_is_another_kind) {
  std::vector<input::Fault> faults = many(7, "acc", "must be a number");
  for (const input::Fault& fault : many(7, "time", "must be a number")) faults.push_back(fault);
  for (const input::Fault& fault : many(2, "acc", "is missing")) faults.push_back(fault);
  const std::vector<std::string> lines = shown(faults);
  ASSERT_EQ(lines.size(), 14U);
  EXPECT_EQ(lines[5], "and 2 more of this kind");
  EXPECT_EQ(lines[11], "and 2 more of this kind");
  EXPECT_THAT(lines[13], EndsWith("is missing"));
}

TEST(fault, numbers_in_a_rule_make_no_other_kind) {
  std::vector<input::Fault> faults;
  for (int i = 0; i < 8; ++i)
    faults.push_back(
        {"a.csv", i + 2, "", "", "has " + std::to_string(i + 3) + " fields where 2.5 are expected"});
  EXPECT_EQ(shown(faults).size(), 6U);
}

TEST(fault, an_error_shows_the_same_and_keeps_all) {
  const input::InputError error(many(200, "acc", "must be a number"));
  EXPECT_THAT(error.what(), EndsWith("\nand 195 more of this kind"));
  EXPECT_EQ(error.faults().size(), 200U);
}

}  // namespace
}  // namespace dashpad
