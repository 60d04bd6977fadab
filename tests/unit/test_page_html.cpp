// The page as it is without a script: every text escaped, answers with signs, bars in proportion, tables that
// can become rows.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/layout.hpp"
#include "output/page/html.hpp"
#include "output/page/html_elements.hpp"

namespace dashpad::output {

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string attack = "</h1><script>x</script> \"'&";
const std::string harmless = "&lt;/h1&gt;&lt;script&gt;x&lt;/script&gt; &quot;&#39;&amp;";

std::string body_of(const Document& page) { return html_of({{nullptr, page}}).body; }

Plot rising() { return {.panels = {{.x = {"x"}, .y = {"y"}, .series = {{.x = {0, 1}, .y = {0, 1}}}}}}; }

TEST(PageHtml, EscapesWhateverItIsGiven) {
  Document page;
  page.title = attack;
  page.lead = Lead{.answer = attack, .subject = {attack}};
  page.lead->figures = {{.label = attack, .value = attack, .limit = attack}};
  page.summary = page.warnings = {attack};
  Section section{.heading = attack, .paragraphs = {attack}, .copy = attack + "\n" + attack};
  section.tables = {{.caption = attack, .columns = {attack, attack}, .rows = {{attack, attack}}}};
  section.ranges = {{.label = attack, .value = attack, .words = attack, .lowest = attack, .highest = attack}};
  section.figures = {{.name = attack, .plot = rising(), .note = attack}};
  page.sections = {section};
  const PageHtml html = html_of({{nullptr, page}});
  for (const std::string& text : {html.title, html.body}) {
    EXPECT_THAT(text, Not(HasSubstr("<script")));
    EXPECT_THAT(text, HasSubstr(harmless));
  }
}

TEST(PageHtml, SaysWhatAnAnswerMeansWithoutItsColour) {
  Document page;
  page.lead = Lead{.answer = "Fails", .tone = Tone::bad};
  EXPECT_THAT(body_of(page), HasSubstr("<h1 class=\"bad\"><span class=\"sign\">✕</span> Fails</h1>"));
  page.lead->tone = Tone::good;
  EXPECT_THAT(body_of(page), HasSubstr("<span class=\"sign\">✓</span>"));
  page.lead->tone = Tone::plain;
  EXPECT_THAT(body_of(page), Not(HasSubstr("sign")));
  EXPECT_EQ(html_of({{nullptr, page}}).title, "Fails - Dashpad");
}

/// The limit lies at 1 / 1.3 of the track.
TEST(PageHtml, DrawsBarsTowardsTheirLimit) {
  Document page;
  page.lead = Lead{.answer = "Passes"};
  page.lead->figures = {{.label = "HIC", .value = "500", .share = 0.5, .tone = Tone::good},
                        {.label = "Peak", .value = "900 g", .share = 9, .tone = Tone::bad},
                        {.label = "No limit", .value = "1"}};
  const std::string lead = body_of(page);
  EXPECT_THAT(lead, HasSubstr("50 % of the limit"));
  EXPECT_THAT(lead, HasSubstr("<rect class=\"good\" x=\"0\" width=\"38.46\""));
  EXPECT_THAT(lead, HasSubstr("<rect class=\"bad\" x=\"0\" width=\"100\"")) << "no longer than the track";
  EXPECT_THAT(lead, HasSubstr("x=\"76.52\""));
}

/// A bar fades where its interval has no end, and there only.
TEST(PageHtml, FadesOpenEnds) {
  Document page;
  page.sections = {{.ranges = {{.label = "modulus", .place = 0.4, .from = 0.2}}}};
  EXPECT_THAT(body_of(page), HasSubstr("x=\"92\" width=\"8\" height=\"10\" opacity=\"0.55\""));
  page.sections[0].ranges[0].open_above = true;
  EXPECT_THAT(body_of(page), HasSubstr("x=\"92\" width=\"8\" height=\"10\" opacity=\"0.05\""));
  EXPECT_THAT(body_of(page), HasSubstr("x=\"20\" width=\"8\" height=\"10\" opacity=\"0.55\""));
}

TEST(PageHtml, HasEachStyleOnceAndNamesIt) {
  Document page;
  page.sections = {{.figures = {{.plot = rising()}, {.plot = rising()}}}};
  const PageHtml html = html_of({{nullptr, page}});
  ASSERT_EQ(html.styles.size(), 1U);
  const std::string element = "<style>" + *html.styles.begin() + "</style>";
  // In the head: whatever of the body is taken away or put in its place, it stays.
  EXPECT_THAT(html.body, Not(HasSubstr("<style>")));
  const std::string head = framed(html).substr(0, framed(html).find("</head>"));
  const std::size_t first = head.find(element);
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(head.find(element, first + 1), std::string::npos);
}

TEST(PageHtml, SaysWhereThereIsNothingToDraw) {
  Document page;
  page.sections = {{.figures = {{.plot = {.panels = {{.x = {"x"}, .y = {"y"}}}}}}}};
  EXPECT_THAT(body_of(page), HasSubstr("There is nothing to draw."));
}

TEST(PageHtml, ALimitAloneIsNothingToDraw) {
  Document page;
  const Series limit{.label = "limit", .style = SeriesStyle::vertical_line, .x = {1000}};
  page.sections = {{.figures = {{.plot = {.panels = {{.x = {"x"}, .y = {"y"}, .series = {limit}}}}}}}};
  EXPECT_THAT(body_of(page), HasSubstr("There is nothing to draw."));
}

TEST(PageHtml, LeavesPointsOutAndSaysSo) {
  Plot many = rising();
  Series& series = many.panels[0].series[0];
  series.style = SeriesStyle::points;
  series.x.assign(25'000, 0.5);
  series.y.assign(25'000, 0.5);
  Document page;
  page.sections = {{.figures = {{.plot = many}}}};
  const std::string body = body_of(page);
  EXPECT_THAT(body, HasSubstr("Only one point in 25 is drawn."));
  EXPECT_LT(body.size(), 40'000U);
}

TEST(PageHtml, TellsNumbersFromWords) {
  for (const char* cell :
       {"352.00 1/s", "12.5", "-3e-4", "< 0.1 %", "4.1 ± 0.2", "+12 %", "-", "none", "", "12 mm", "8.94 m/s"})
    EXPECT_TRUE(is_number_or_none(cell)) << cell;
  for (const char* cell : {"pass", "layer 2", "1 to 2", "3 ms clip"})
    EXPECT_FALSE(is_number_or_none(cell)) << cell;
}

TEST(InlineSvgs, TellTextsFromWhatIsDrawn) {
  const std::string metric =
      "<svg id=\"dd-0123abcd-x\"><title>A</title><desc>1 m</desc><path d=\"M0 1\"/><text x=\"1\">1 "
      "m</text></svg>";
  const std::string us =
      "<svg id=\"dd-aaaa0000-x\"><title>B</title><desc>3 ft</desc><path d=\"M0 1\"/><text x=\"1\">3.28 "
      "ft</text></svg>";
  EXPECT_TRUE(differ_in_texts_only(metric, us));
  EXPECT_THAT(texts_in(us), ::testing::ElementsAre("3 ft", "3.28 ft"));
  std::string moved = us;
  moved.replace(moved.find("M0 1"), 4, "M0 2");
  EXPECT_FALSE(differ_in_texts_only(metric, moved));
}

/// The known digests of FIPS 180-2, of one block and of two, and that of the empty text.
TEST(PolicyHash, IsThatOfTheStandard) {
  EXPECT_EQ(policy_hash(""), "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  EXPECT_EQ(policy_hash("abc"), "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
  EXPECT_EQ(policy_hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "sha256-JI1qYdIGOLjlwCaTDD5gOaM85Flk/yFn9uzt1BnbBsE=");
}

}  // namespace

}  // namespace dashpad::output
