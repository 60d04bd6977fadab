// How deep TOML may nest: what a user writes is read, what would overflow the stack is refused.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dashpad/input/fault.hpp"
#include "input/toml_tree.hpp"

namespace dashpad {
namespace {

using ::testing::HasSubstr;

input::TomlNode read(const std::string& text) { return input::read_toml_text("a.toml", text).value().root; }

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

/// The refusal of a text; empty if it is read.
std::string refusal_of(const std::string& text) {
  try {
    read(text);
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "";
}

int depth_of(const input::TomlNode& node) {
  int deepest = 0;
  for (const input::TomlNode& child : node.children) deepest = std::max(deepest, depth_of(child));
  return 1 + deepest;
}

TEST(toml_tree, dots_in_comments_and_strings_are_text) {
  const std::string dots(100'000, '.');
  EXPECT_EQ(read("# " + dots + "\na = 1 # " + dots).children.size(), 1U);
  for (const std::string quote : {"\"", "'", "\"\"\"", "'''"}) {
    const input::TomlNode root = read(fmt::format("a = {0}{1}{0}\n\"b{1}\" = 1\n", quote, dots));
    ASSERT_EQ(root.children.size(), 2U);
    EXPECT_EQ(root.children[0].text, dots);
    EXPECT_EQ(root.children[1].key, "b" + dots);
  }
  EXPECT_EQ(read("a = [\"" + dots + "\", '" + dots + "'] # " + dots).children[0].children.size(), 2U);
  EXPECT_EQ(read("a = \"\"\"x\n" + dots + "\n" + dots + "\"\"\"\"\"\nb = 1").children.size(), 2U);
}

TEST(toml_tree, a_name_of_64_dots_is_read) {
  EXPECT_EQ(depth_of(read("a" + repeated(".a", 64) + " = 1")), 66);
  EXPECT_THAT(refusal_of("b = 1\na" + repeated(".a", 65) + " = 1"), HasSubstr("a.toml:2: a name has more"));
}

/// toml++ would read each of these and overflow the stack.
TEST(toml_tree, deep_names_are_refused_in_any_disguise) {
  const std::string deep = repeated("a.", 100'000) + "a";
  for (const std::string& text : {
           deep + " = 1",
           "[" + deep + "]",
           "[[" + deep + "]]",
           "a = {" + deep + " = 1}",
           "a = [1, {" + deep + " = 1}]",
           repeated("a . ", 100'000) + "a = 1",
           repeated("\"=\".", 100'000) + "a = 1",
           repeated("','.", 100'000) + "a = 1",
           repeated("'{'.", 100'000) + "a = 1",
           repeated("\"#\".", 100'000) + "a = 1",
           repeated("\"\\\"\".", 100'000) + "a = 1",
           repeated("'\\'.", 100'000) + "a = 1",
           repeated("\"\".", 100'000) + "a = 1",
           "# \"\n" + deep + " = 1",
           "# '''\n" + deep + " = 1",
           "a = [\"\"\"x\"\"\"\", {" + deep + " = 1}]",
           "a = [\"\"\"x\"\"\"\"\", {" + deep + " = 1}]",
           "a = ['''x'''', {" + deep + " = 1}]",
           "a = [\"\"\"\"\"\", {" + deep + " = 1}]",
           "a = [\"\"\"\\\"\"\"\", {" + deep + " = 1}]",
           "a = [\"\\\\\", {" + deep + " = 1}]",
           "a = ['\\', {" + deep + " = 1}]",
           "a = [\"\", '', {" + deep + " = 1}]",
       })
    EXPECT_THAT(refusal_of(text), HasSubstr("a name has more than 64 dots")) << text.substr(0, 60);
}

TEST(toml_tree, deep_values_are_refused) {
  for (const char* part : {"[", "{a=", "[{a=", "{a.a.a.a=["})
    EXPECT_THAT(refusal_of("a = " + repeated(part, 100'000)), HasSubstr("nested value depth of 16"));
  EXPECT_THAT(refusal_of(std::string(100'000, '[')), HasSubstr("is not valid TOML"));
  EXPECT_THAT(refusal_of("a = " + repeated("[", 100'000) + repeated("]", 100'000)),
              HasSubstr("nested value depth of 16"));
}

/// Sixteen values within each other, each below a name of 65 parts, are the deepest text that is read.
TEST(toml_tree, no_text_nests_deeper_than_names_and_values_allow) {
  const std::vector<std::string> parts{"\"",   "'", "\"\"\"", "'''", "\\",  "#",     "\n",
                                       "\r\n", ".", "a",      "=",   " = ", ",",     "[",
                                       "]",    "{", "}",      "1",   " ",   "a = [", "a = "};
  const std::string deep = repeated("a.", 1500) + "a = 1";
  std::mt19937 random(8);
  int read_texts = 0;
  for (int i = 0; i < 1'000; ++i) {
    std::string text;
    for (auto count = random() % 12; count > 0; --count) text += parts[random() % parts.size()];
    text += deep;
    for (auto count = random() % 6; count > 0; --count) text += parts[random() % parts.size()];
    try {
      EXPECT_LE(depth_of(read(text)), 16 * 66) << text.substr(0, 60);
      ++read_texts;
    } catch (const input::InputError&) {
      continue;
    }
  }
  EXPECT_GT(read_texts, 5);  // a comment before it, or quotes around it
}

}  // namespace
}  // namespace dashpad
