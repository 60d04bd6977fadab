// dashpad compare: the accurate solver and the program of 1984 in a table and a picture.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::vector<std::string> run_names{"accurate",       "accurate, constants of 1984",
                                         "1984, pdp10",    "1984, binary32",
                                         "1984, binary64", "1984, mended, binary64"};

class CompareTest : public CommandTest {
 protected:
  /// Runs with both files asked for; nothing may come of it but complaints.
  Outcome refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "compare");
    const auto before = other_files();
    Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
    return outcome;
  }
};

/// Every tag of the text is closed, in order, and nothing stands outside the one root.
bool is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  bool seen_root = false;
  for (std::size_t place = text.find('<'); place != std::string::npos; place = text.find('<', place)) {
    const bool is_comment = text.compare(place, 4, "<!--") == 0;
    const std::size_t end = text.find(is_comment ? "-->" : ">", place);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(place + 1, end - place - 1);
    place = end;
    if (is_comment || tag.starts_with("?") || tag.starts_with("!")) continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t/", 1));
    if (tag.starts_with("/")) {
      if (open.empty() || "/" + open.back() != name) return false;
      open.pop_back();
      continue;
    }
    if (open.empty() && seen_root) return false;
    seen_root = true;
    if (!tag.ends_with("/")) open.push_back(name);
  }
  return seen_root && open.empty();
}

TEST_F(CompareTest, ShowsSixRowsAndRemarks) {
  const Outcome outcome = dashpad({"compare", nine});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const std::string& name : run_names) EXPECT_THAT(outcome.out, HasSubstr("\n" + name + " "));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\n1984, binary64: ABEND 900 (too many iterations) at "),
                                 HasSubstr("\n1984, binary32: PRECISION LIMIT: "),
                                 HasSubstr("% off is the difference from ")));
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(CompareTest, ShowsEachSystemOfUnits) {
  EXPECT_THAT(dashpad({"compare", nine, "--units", "us"}).out,
              AllOf(HasSubstr("(lbf)"), HasSubstr("(mph)"), HasSubstr("(in)")));
  EXPECT_THAT(dashpad({"compare", nine, "--units", "si"}).out,
              AllOf(HasSubstr("(N)"), HasSubstr("(m/s)"), HasSubstr("(mm)")));
  EXPECT_THAT(refused({nine, "--units", "imperial"}).err, HasSubstr("--units"));
}

TEST_F(CompareTest, WritesJson) {
  const Outcome outcome = dashpad({"compare", nine, "--json", "-", "--units", "us"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("1984, pdp10"));  // the table makes room
  const json result = json::parse(outcome.out);
  ASSERT_EQ(result["runs"].size(), run_names.size());
  for (std::size_t i = 0; i < run_names.size(); ++i) EXPECT_EQ(result["runs"][i]["name"], run_names[i]);
  EXPECT_EQ(result["reference"], run_names[1]);
  EXPECT_NEAR(result["runs"][1]["peak_force_N"].get<double>(), 5769, 5);
  EXPECT_EQ(result["runs"][4]["finished"], false);
  EXPECT_EQ(result["runs"][4]["end_time_s"], nullptr);
  EXPECT_THAT(result["runs"][4]["remark"].get<std::string>(), StartsWith("ABEND 900"));
}

TEST_F(CompareTest, TheFirstRowIsWhatRunAnswers) {
  const json compared = json::parse(dashpad({"compare", nine, "--json", "-"}).out);
  const json alone = json::parse(dashpad({"run", nine, "--json", "-"}).out);
  EXPECT_EQ(compared["runs"][0]["peak_force_N"], alone["peak_force_N"]);
  const json program = json::parse(dashpad({"spit1984", nine, "--json", "-"}).out);
  EXPECT_NEAR(compared["runs"][2]["peak_force_N"].get<double>(),
              -program["peak_force_lbf"].get<double>() * 4.4482216152605, 1e-6);
}

TEST_F(CompareTest, TakesTheTimeStepOfTheProgram) {
  const json coarse = json::parse(dashpad({"compare", nine, "--json", "-"}).out)["runs"];
  const json fine = json::parse(dashpad({"compare", nine, "--json", "-", "--time-step", "0.05"}).out)["runs"];
  EXPECT_EQ(coarse[1], fine[1]);
  EXPECT_NE(coarse[2], fine[2]);
  for (const char* step : {"0", "-1", "nan", "inf", "abc", ""})
    EXPECT_THAT(refused({nine, "--json", file("r.json"), "--time-step", step}).err, HasSubstr("--time-step"));
}

TEST_F(CompareTest, DrawsAPicture) {
  const Outcome outcome = dashpad({"compare", nine, "--picture", file("a.svg"), "--json", file("a.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1984, pdp10"));
  const std::string svg = read_file(file("a.svg"));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, AllOf(HasSubstr(">Time (ms)<"), HasSubstr(">Force (N)<"), HasSubstr(">Penetration (mm)<"),
                         HasSubstr("1984, pdp10")));
  EXPECT_TRUE(json::accept(read_file(file("a.json"))));
  ASSERT_EQ(dashpad({"compare", nine, "--picture", file("b.SVG"), "--units", "us"}).exit_code, 0);
  EXPECT_THAT(read_file(file("b.SVG")), AllOf(HasSubstr(">Force (lbf)<"), HasSubstr(">Penetration (in)<")));
}

TEST_F(CompareTest, WritesAPageAndMarkdown) {
  ASSERT_EQ(dashpad({"compare", nine, "--report", file("a.html"), "--markdown", file("a.md")}).exit_code, 0);
  for (const char* name : {"a.html", "a.md"})
    EXPECT_THAT(read_file(file(name)), AllOf(HasSubstr("The peak force of the 1984 program is "),
                                             HasSubstr("1984, mended, binary64"), HasSubstr("ABEND 900")));
  EXPECT_THAT(read_file(file("a.html")), HasSubstr("<svg"));
}

TEST_F(CompareTest, TheEndingSaysWhatThePictureBecomes) {
  ASSERT_EQ(dashpad({"compare", nine, "--picture", file("a.png")}).exit_code, 0);
  EXPECT_THAT(read_file(file("a.png")), StartsWith("\x89PNG\r\n\x1a\n"));
  ASSERT_EQ(dashpad({"compare", nine, "--picture", file("a.pdf")}).exit_code, 0);
  EXPECT_THAT(read_file(file("a.pdf")), StartsWith("%PDF-"));
}

TEST_F(CompareTest, RefusesAnotherEnding) {
  for (const char* name : {"a.jpg", "svg", "a.svg.gz", "a"})
    EXPECT_THAT(refused({nine, "--picture", file(name)}).err, HasSubstr("must end in .svg, .png or .pdf"));
  EXPECT_THAT(refused({nine, "--picture", "-"}).err, HasSubstr("must end in .svg, .png or .pdf"));
}

TEST_F(CompareTest, RefusesARigidSupportAndABadCase) {
  write_file(file("rigid.toml"),
             with(with(elastic_case(), "\"linear\"", "\"rigid\""), "stiffness = \"100 N/mm\"\n", ""));
  EXPECT_THAT(refused({file("rigid.toml"), "--picture", file("a.svg"), "--json", file("a.json")}).err,
              HasSubstr("rigid.toml: support.type: "));
  write_file(file("bad.toml"), with(elastic_case(), "80 mm", "80 kg"));
  EXPECT_THAT(refused({file("bad.toml"), "--json", file("a.json")}).err, HasSubstr("impactor.radius"));
  refused({});
  refused({nine, nine});
}

TEST_F(CompareTest, KeepsExistingFilesUnlessForced) {
  write_file(file("old.json"), "precious");
  EXPECT_THAT(refused({case_file(), "--json", file("old.json")}).err, HasSubstr("--force"));
  EXPECT_EQ(read_file(file("old.json")), "precious");
  EXPECT_EQ(dashpad({"compare", case_file(), "--json", file("old.json"), "--force"}).exit_code, 0);
  EXPECT_TRUE(json::accept(read_file(file("old.json"))));
  EXPECT_THAT(refused({nine, "--json", file("nowhere/a.json")}).err, HasSubstr("there is no folder"));
  EXPECT_THAT(refused({nine, "--json", file("a.svg"), "--picture", file("a.svg")}).err,
              HasSubstr("also given for --picture"));
  EXPECT_THAT(other_files(), ElementsAre("old.json"));
}

TEST_F(CompareTest, AFullDiskIsAnErrorAndAReaderThatGoesAwayIsNot) {
  for (const char* more : {"", " --json -"}) {
    const Outcome full = shell("$DASHPAD compare " + case_file() + more + " > /dev/full");
    EXPECT_EQ(full.exit_code, 1) << more;
    EXPECT_THAT(full.err, HasSubstr("could not write to standard output"));
  }
  EXPECT_EQ(shell("{ $DASHPAD compare " + case_file() + "; echo $? >&2; } | true").err, "0\n");
}

}  // namespace
}  // namespace dashpad::test
