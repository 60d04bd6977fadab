// What reading a case gives as data: the case, or every fault with the line that it is about.

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include <fmt/format.h>
#include "input/case_tables.hpp"
#include "quantities/text.hpp"

#include "dashpad/output/text/case.hpp"
#include "shared/temporary_folder.hpp"
#include "unit/sample_case.hpp"

namespace dashpad {
namespace {

using input::Fault;
using test::edited;
using test::good_case;
using test::materials;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> shown(const std::vector<Fault>& faults) {
  std::vector<std::string> all;
  for (const Fault& fault : faults) all.push_back(with_excerpt(fault));
  return all;
}

std::vector<std::string> faults_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  return shown(input::read_case_text(text, "case.toml", materials, settings).faults());
}

/// All but the first line.
std::string excerpt_of_only(const std::string& text) {
  const std::vector<std::string> all = faults_of(text);
  return all.size() == 1 ? all[0].substr(all[0].find('\n') + 1) : std::to_string(all.size()) + " faults";
}

TEST(reading, of_a_text_is_that_of_a_file_with_it) {
  const auto read = input::read_case_text(good_case, "case.toml", materials);
  ASSERT_TRUE(read);
  EXPECT_THAT(read.faults(), IsEmpty());
  EXPECT_EQ(output::case_in_si(read->impact, read->options),
            output::case_in_si(test::read(good_case).impact, test::read(good_case).options));
  EXPECT_EQ(read->files.front().file, "case.toml");
}

TEST(reading, of_a_text_finds_what_it_names_beside_its_place) {
  const test::TemporaryFolder folder;
  folder.write("nose.csv", "depth_mm,radius_mm\n0,0\n10,30\n");
  const std::string text = edited(good_case, "radius = \"3 in\"", "nose = \"profile\"\nfile = \"nose.csv\"");
  EXPECT_TRUE(input::read_case_text(text, folder.path() / "not-there.toml", materials));
  EXPECT_FALSE(input::read_case_text(text, "elsewhere/case.toml", materials));
}

TEST(reading, gives_all_faults_with_their_lines_and_throws_nothing) {
  std::string text = edited(good_case, "\"20 mph\"", "\"20 mpj\"");
  text = edited(text, "thickness = ", "thicknes = ");
  EXPECT_THAT(
      faults_of(text, {"solver.tolerance=1"}),
      ElementsAre("case.toml:5: impactor.speed = \"20 mpj\": unknown unit \"mpj\"; use m/s, km/h, mph, "
                  "in/s\n"
                  "  5 | speed = \"20 mpj\"\n"
                  "    |         ^^^^^^^^",
                  "case.toml:6: pad.thickness: is missing\n"
                  "  6 | [pad]",
                  "case.toml:7: pad.thicknes = \"1 in\": unknown key; did you mean \"thickness\"?\n"
                  "  7 | thicknes = \"1 in\"\n"
                  "    | ^^^^^^^^",
                  "--set: solver.tolerance = 1: must be at least 1e-8 and at most 1e-2"));
}

TEST(reading, of_what_is_no_toml_is_a_fault_too) {
  EXPECT_THAT(shown(input::read_case_text("[impactor\nspeed = 1\n", "case.toml", materials).faults()),
              ElementsAre(::testing::StartsWith("case.toml:1: is not valid TOML: ")));
  EXPECT_FALSE(input::read_case_text(std::string(20'000, '.') + " = 1", "case.toml", materials));
  EXPECT_FALSE(input::read_case_text("", "case.toml", materials));
}

TEST(reading, keeps_the_right_for_those_who_want_an_exception) {
  EXPECT_THROW(input::read_case_text("", "case.toml", materials).value(), input::InputError);
}

TEST(excerpt, marks_what_is_meant_among_characters_of_any_length) {
  EXPECT_EQ(excerpt_of_only(edited(good_case, "thickness = \"1 in\"\nmaterial",
                                   "\"é²\" = 1\nthickness = \"1 in\"\nmaterial")),
            "  7 | \"é²\" = 1\n"
            "    | ^^^^");
  EXPECT_EQ(excerpt_of_only(edited(good_case, "[support]\ntype = \"linear\"\nstiffness = \"600 lbf/in\"",
                                   "[support]\n  type = \"linear\"  # é\n\tstiffness = 600")),
            "  11 |  stiffness = 600\n"
            "     |              ^^^");
}

TEST(excerpt, is_the_same_whatever_lines_end_in) {
  std::string text = edited(good_case, "\"20 mph\"", "\"20\"");
  const std::vector<std::string> expected = faults_of(text);
  replace_all(text, "\n", "\r\n");
  EXPECT_EQ(faults_of(text), expected);
}

TEST(excerpt, of_a_long_line_shows_what_is_meant) {
  const std::string list = "[\"0 mm\", \"0 mm\"], ";
  std::string points;
  for (int i = 1; i < 20; ++i) points += fmt::format("[\"{} mm\", \"{} mm\"], ", i, 2 * i);
  const std::string text =
      edited(good_case, "radius = \"3 in\"",
             "nose = \"profile\"\nradii = [" + list + points + "[\"20 mm\", 7], [\"30 mm\", \"90 mm\"]]");
  EXPECT_EQ(excerpt_of_only(text),
            "  4 | ...[\"19 mm\", \"38 mm\"], [\"20 mm\", 7], [\"30 mm\", \"90 mm\"]]\n"
            "    |                                  ^");
}

TEST(excerpt, is_safe_for_a_terminal) {
  EXPECT_EQ(with_excerpt(Fault{"a.toml", 2, "", "", "is wrong", {"x = \"\x1b[2J\"\r", 4, 6}}),
            "a.toml:2: is wrong\n  2 | x = \" [2J\" \n    |     ^^^^^^");
  EXPECT_EQ(with_excerpt(Fault{"a.toml", 2, "", "", "is wrong", {"short", 40, 6}}), "a.toml:2: is wrong");
}

TEST(excerpt, of_a_table_of_numbers_marks_the_field) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("nose.csv", "depth_mm,radius_mm\n0,0\n10,thirty\n20,40\n");
  EXPECT_THAT(shown(input::read_profile_csv(file).faults()),
              ElementsAre(file.string() + ":3: radius_mm = thirty: must be a number\n"
                                          "  3 | 10,thirty\n"
                                          "    |    ^^^^^^"));
}

}  // namespace
}  // namespace dashpad
