// Bad input: refused at once with exit code 2, every fault on a line that says what to mend, nothing written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

class BadInputTest : public CommandTest {
 protected:
  /// Runs a case of that text, asking for a file as well; nothing may come of it but complaints.
  Outcome refused(const std::string& text, const std::vector<std::string>& more = {}) {
    write_file(file("bad.toml"), text);
    return refused_file("bad.toml", more);
  }

  Outcome refused_file(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", file(name), "--json", file("result.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, EndsWith("; nothing was run\n"));
    EXPECT_FALSE(fs::exists(file("result.json")));
    return outcome;
  }
};

TEST_F(BadInputTest, NamesFileLineKeyValueAndRule) {
  const Outcome outcome = refused(with(elastic_case(), "\"3 m/s\"", "\"3\""));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad.toml:5: impactor.speed = \"3\": "), HasSubstr("unit"),
                                 EndsWith("1 error; nothing was run\n")));
}

TEST_F(BadInputTest, NamesAllFaultsAtOnce) {
  std::string text = with(elastic_case(), "5 kg", "5 m");
  text = with(text, "80 mm", "-80 mm");
  text = with(text, "type = \"linear\"", "type = \"springy\"");
  write_file(file("taken.csv"), "");
  const Outcome outcome = refused(text, {"--csv", file("taken.csv"), "--tolerance", "5"});
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("impactor.mass"), HasSubstr("impactor.radius"),
                                 HasSubstr("support.type"), HasSubstr("--csv"), HasSubstr("--tolerance 5")));
}

TEST_F(BadInputTest, RefusesAToleranceOutOfRange) {
  for (const char* tolerance :
       {"0", "-1", "-1e-4", "1e-9", "0.1", "nan", "inf", "abc", "", "1e-4x", "1e400"}) {
    const Outcome outcome = dashpad({"run", case_file(), "--tolerance", tolerance});
    EXPECT_EQ(outcome.exit_code, 2) << tolerance;
    EXPECT_THAT(outcome.err, HasSubstr("tolerance")) << tolerance;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(dashpad({"run", case_file(), "--tolerance", "1e-2"}).exit_code, 0);
}

TEST_F(BadInputTest, RefusesAnUnknownMaterialAndNamesTheCards) {
  const Outcome outcome =
      refused(with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
                   "material = \"unobtainium\""));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("unobtainium"), HasSubstr("ensolite-aac-9")));
}

TEST_F(BadInputTest, RefusesAFolderOfMaterialsThatIsNotThere) {
  EXPECT_EQ(dashpad({"materials", "--materials", file("nowhere")}).exit_code, 2);
  EXPECT_EQ(shell("DASHPAD_MATERIALS=/nowhere $DASHPAD materials").exit_code, 2);
}

TEST_F(BadInputTest, RefusesAnEmptyFile) { EXPECT_THAT(refused("").err, HasSubstr("bad.toml")); }

TEST_F(BadInputTest, RefusesTextThatIsNoToml) {
  EXPECT_THAT(refused("once upon\na time").err, HasSubstr("bad.toml:1"));
}

TEST_F(BadInputTest, RefusesABinaryFile) {
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>((i * 167) % 256);
  refused(bytes);
  write_file(file("program.toml"), read_file("/bin/sh"));
  refused_file("program.toml");
}

TEST_F(BadInputTest, RefusesAFolder) {
  fs::create_directory(file("folder.toml"));
  EXPECT_THAT(refused_file("folder.toml").err, HasSubstr("folder"));
}

TEST_F(BadInputTest, RefusesAMissingFile) {
  EXPECT_THAT(refused_file("missing.toml").err, HasSubstr("missing.toml"));
}

TEST_F(BadInputTest, RefusesAHugeFileAtOnce) {
  write_file(file("huge.toml"), "");
  fs::resize_file(file("huge.toml"), std::uintmax_t{1} << 30);
  EXPECT_THAT(refused_file("huge.toml").err, HasSubstr("is larger than 1 MiB"));
  // The bytes that the shell and its children have read; 1.2 million when this was written.
  const Outcome read =
      shell("$DASHPAD run " + file("huge.toml") + " 2> /dev/null\n" + "sed -n 's/^rchar: //p' /proc/$$/io");
  EXPECT_LT(std::stoull(read.out), 20'000'000U) << "it reads on after it has seen enough";
}

TEST_F(BadInputTest, DoesNotWaitForADevice) {
  EXPECT_EQ(dashpad({"run", "/dev/zero"}).exit_code, 2);
  // What a case names is no pipe, even where somebody writes to it.
  ASSERT_EQ(::mkfifo(file("pipe.toml").c_str(), 0600), 0);
  write_file(file("named.toml"),
             with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
                  "material = \"pipe.toml\""));
  const Outcome named = shell("exec timeout 60 $DASHPAD run " + file("named.toml"));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_THAT(named.err, HasSubstr("pipe.toml: is not a regular file"));
}

TEST_F(BadInputTest, DoesNotFloodTheTerminal) {
  std::string text = elastic_case();
  for (int i = 0; i < 5000; ++i) text += "unknown" + std::to_string(i) + " = 1\n";
  const Outcome outcome = refused(text);
  EXPECT_LT(outcome.err.size(), 100'000u);
  EXPECT_THAT(outcome.err, HasSubstr(" errors; nothing was run\n"));
}

TEST_F(BadInputTest, RefusesACommandLineThatIsNotUnderstood) {
  const std::vector<std::vector<std::string>> lines{
      {},
      {"frobnicate"},
      {"run"},
      {"run", case_file(), "--bogus"},
      {"run", case_file(), case_file()},
      {"run", case_file(), "--units", "imperial"},
      {"run", case_file(), "--json"},
      {"run", case_file(), "--json", file("a"), "--json", file("b")},
      {"run", case_file(), "--force=7"},
      {"check"},
      {"materials", "a", "b"},
  };
  for (const auto& line : lines) {
    const Outcome outcome = dashpad(line);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(line);
    EXPECT_EQ(outcome.out, "") << testing::PrintToString(line);
    EXPECT_NE(outcome.err, "") << testing::PrintToString(line);
  }
  EXPECT_TRUE(other_files().empty());
}

TEST_F(BadInputTest, CheckNamesTheSameFaultsAsRun) {
  write_file(file("bad.toml"), with(elastic_case(), "80 mm", "80 kg"));
  const Outcome checked = dashpad({"check", file("bad.toml")});
  const Outcome run = dashpad({"run", file("bad.toml")});
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_EQ(checked.err, with(run.err, "; nothing was run", ""));
}

}  // namespace
}  // namespace dashpad::test
