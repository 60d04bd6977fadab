// One document, three writers: what is said in one place is seen in all of them.

#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/output/document.hpp"
#include "output/layout.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Document of_a_drop() {
  return {.title = "A drop",
          .lead = Lead{.answer = "Passes: HIC15 has 20 to spare",
                       .tone = Tone::good,
                       .subject = {"A box", ""},
                       .figures = {{.label = "HIC15",
                                    .value = "980",
                                    .interval = "960 to 990",
                                    .limit = "at most 1000",
                                    .remark = "pass"},
                                   {.label = "Peak acceleration", .value = "93.5", .unit = "g"}}},
          .warnings = {"BOTTOMED at 5 ms", "a second"},
          .sections = {{.seen = Seen::in_brief, .paragraphs = {"Only in short."}},
                       {.heading = "Figures",
                        .rows = {{"The impact", {{.label = "HIC15", .value = "980.12", .error = 2e-3}}},
                                 {"The pulse", {{.label = "Width", .value = "5 ms"}}}}},
                       {.heading = "Why", .seen = Seen::always, .paragraphs = {"A line for all."}},
                       {.heading = "The case", .seen = Seen::on_pages, .copy = "mass = \"1 kg\"\n```\n"}}};
}

TEST(Document, ALineForAllIsSeenInAll) {
  const Document document = of_a_drop();
  const std::vector<std::string> all{to_html(document), to_markdown(document),
                                     to_terminal(document, Detail::main), to_terminal(document, Detail::all)};
  EXPECT_THAT(all, Each(AllOf(HasSubstr("Passes: HIC15 has 20 to spare"), HasSubstr("A box"),
                              HasSubstr("a second"), HasSubstr("A line for all."))));
}

TEST(Document, IsShortOnATerminalUnlessAllIsAskedFor) {
  EXPECT_EQ(to_terminal(of_a_drop(), Detail::main),
            "Passes: HIC15 has 20 to spare\nA box\nBOTTOMED at 5 ms\na second\n\n"
            "  HIC15                      980         960 to 990  at most 1000  pass\n"
            "  Peak acceleration         93.5 g\n\n"
            "Only in short.\n\nWhy:\nA line for all.\n");
  EXPECT_EQ(to_terminal(of_a_drop(), Detail::all),
            "Passes: HIC15 has 20 to spare\nA box\nBOTTOMED at 5 ms\na second\n\n"
            "The impact:\n  HIC15                   980.12         ± 0.2 %\n\n"
            "The pulse:\n  Width                        5 ms\n\n"
            "Why:\nA line for all.\n");
}

TEST(Document, IsWholeInMarkdown) {
  EXPECT_EQ(to_markdown(of_a_drop()),
            "# Passes: HIC15 has 20 to spare\n\nA box\n\n- **BOTTOMED** at 5 ms\n- a second\n\n"
            "## Figures\n\n**The impact**\n\n| Figure | Value | Numerical error |\n|---|---|---|\n"
            "| HIC15 | 980.12 | ± 0.2 % |\n\n"
            "**The pulse**\n\n| Figure | Value |\n|---|---|\n| Width | 5 ms |\n\n"
            "## Why\n\nA line for all.\n\n"
            "## The case\n\n````\nmass = \"1 kg\"\n```\n````\n");
}

/// Whatever a user has written is text, and a terminal is not told what to do.
TEST(Document, KeepsForeignTextFromBeingMarkup) {
  Document document = of_a_drop();
  const std::string attack = "# <b>*x*</b> [a](b) `c` _d_ a|b \x1b[31m";
  document.lead->answer = attack;
  document.lead->subject = {"1. first", "- second", "12 mm is no list"};
  document.sections = {
      {.heading = attack, .tables = {{.caption = attack, .columns = {attack}, .rows = {{attack}}}}}};
  const std::string markdown = to_markdown(document);
  const std::string safe = "\\<b>\\*x\\*\\</b> \\[a](b) \\`c\\` \\_d\\_ a\\|b  \\[31m";
  EXPECT_THAT(markdown,
              AllOf(StartsWith("# # " + safe), HasSubstr("| # " + safe + " |"), HasSubstr("\n1\\. first\n"),
                    HasSubstr("\n\\- second\n"), HasSubstr("\n12 mm is no list\n"), Not(HasSubstr("\x1b"))));
  document.sections.front().seen = Seen::always;
  EXPECT_THAT(to_terminal(document, Detail::main), Not(HasSubstr("\x1b")));
}

TEST(Document, ErrorsThatNobodyKnowsAreCalledUnknown) {
  Document document = of_a_drop();
  document.lead->figures = {
      {.label = "HIC15", .value = "1", .error = std::numeric_limits<double>::infinity()}};
  EXPECT_THAT(to_terminal(document, Detail::main), HasSubstr("± unknown"));
}

TEST(TablesOfTheTerminal, GiveWayWhereTheyAreWidest) {
  Table table{.columns = {"Name", "Value of the quantity", "Words"}};
  for (int i = 0; i < 2; ++i) {
    std::string words;
    for (int k = 0; k < 40; ++k) words += "word" + std::to_string(k) + " ";
    table.rows.push_back({"a name of three", "12.5 kN", words});
  }
  const std::string text = plain_text(table);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(width_of(line), 100U) << line;
  EXPECT_THAT(text, AllOf(HasSubstr("a name of three"), HasSubstr("12.5 kN"), HasSubstr("word39")));
}

TEST(TablesOfTheTerminal, HaveNumbersOnTheRight) {
  EXPECT_EQ(plain_text({.columns = {"Blow", "Peak"}, .rows = {{"1", "9.5"}, {"2", "10.5"}}}),
            "Blow  Peak\n1      9.5\n2     10.5\n");
  EXPECT_EQ(plain_text({.columns = {"", ""}, .rows = {{"Filter", "none"}}}), "Filter  none\n")
      << "without names there is no line for them";
}

/// A word that is too long stands as it is.
TEST(TablesOfTheTerminal, BreakNoWord) {
  const std::string word(150, 'x');
  EXPECT_THAT(plain_text({.columns = {"a", "b"}, .rows = {{"1", word}}}), HasSubstr(word));
}

}  // namespace
}  // namespace dashpad::output
