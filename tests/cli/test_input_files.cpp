// Files that a command reads are never written to, not even with --force, under whatever name; and no two
// results share a file.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string soft_foam = R"(title = "Soft"
source = "made up"
law = "elastic"
[parameters]
modulus = "300 kPa"
)";

std::string with_card(const std::string& name) {
  return with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
              "material = \"" + name + "\"");
}

class InputFilesTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("card.toml"), soft_foam);
    write_file(file("with-card.toml"), with_card("card.toml"));
    fs::create_directory(file("links"));
  }

  /// Every name under which the file can be written to: as it is, in other words, a symbolic link, a link to
  /// that, a hard link.
  [[nodiscard]] std::vector<std::string> names_of(const std::string& input) {
    const fs::path whole{file(input)};
    const std::string link = file("links/" + std::to_string(++links_) + "-");
    fs::create_symlink(whole, link + "soft");
    fs::create_symlink(link + "soft", link + "soft-soft");
    fs::create_hard_link(whole, link + "hard");
    return {whole.string(),
            (whole.parent_path() / "." / whole.filename()).string(),
            (whole.parent_path() / "../" / whole.parent_path().filename() / whole.filename()).string(),
            link + "soft",
            link + "soft-soft",
            link + "hard"};
  }

  /// `command` with the last argument any name of `input`: refused with that kind of file, which is
  /// unchanged.
  void expect_kept(const std::vector<std::string>& command, const std::string& input,
                   const std::string& kind) {
    const std::string before = read_file(file(input));
    for (const std::string& name : names_of(input)) {
      std::vector<std::string> arguments = command;
      arguments.insert(arguments.end(), {name, "--force"});
      const Outcome outcome = dashpad(arguments);
      EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments);
      EXPECT_THAT(outcome.err, HasSubstr(fmt::format("{}: is {}; choose another name", name, kind)));
      EXPECT_EQ(outcome.out, "");
      EXPECT_EQ(read_file(file(input)), before) << testing::PrintToString(arguments);
    }
  }

 private:
  int links_ = 0;
};

TEST_F(InputFilesTest, TheCaseAndItsCardAreKept) {
  const std::string input = file("with-card.toml");
  const std::vector<std::vector<std::string>> commands{
      {"run", input, "--json"},
      {"run", input, "--csv"},
      {"run", input, "--report"},
      {"run", input, "--png"},
      {"run", input, "--drawing"},
      {"assess", input, "--standard", "en-1177", "--json"},
      {"export", input, "--format", "ls-dyna", "--out"},
      {"post-impact", input, "--json"},
      {"compare", input, "--json"},
      {"spit1984", input, "--json"},
      {"spit1984", input, "--listing"},
  };
  for (const auto& command : commands) {
    expect_kept(command, "with-card.toml", "the case file");
    expect_kept(command, "card.toml", "the material card");
  }
}

TEST_F(InputFilesTest, ACardOfAFolderIsKept) {
  fs::create_directory(file("cards"));
  write_file(file("cards/soft.toml"), soft_foam);
  write_file(file("soft-case.toml"), with_card("soft"));
  expect_kept({"run", file("soft-case.toml"), "--materials", file("cards"), "--json"}, "cards/soft.toml",
              "the material card");
  expect_kept({"material-test", "soft", "--materials", file("cards"), "--csv"}, "cards/soft.toml",
              "the material card");
}

TEST_F(InputFilesTest, TheStandardIsKept) {
  fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "standards/en-1177.toml", file("mine.toml"));
  expect_kept({"assess", case_file(), "--standard", file("mine.toml"), "--json"}, "mine.toml",
              "the standard");
}

TEST_F(InputFilesTest, TheHistoryOfAMaterialTestIsKept) {
  write_file(file("strains.csv"), "time_s,strain\n0,0\n0.1,0.5\n");
  const std::vector<std::string> command{"material-test", file("card.toml"),   "--test", "history",
                                         "--history",     file("strains.csv"), "--json"};
  expect_kept(command, "strains.csv", "the strain history");
  expect_kept(command, "card.toml", "the material card");
}

TEST_F(InputFilesTest, EveryTableAndTheCardOfTheValidationAreKept) {
  fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "data/validation", file("data"));
  fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "materials", file("cards"));
  const std::vector<std::string> command{"validate",    "--data",      file("data"),
                                         "--materials", file("cards"), "--json"};
  for (const char* table :
       {"table-3-1.csv", "table-3-1-unplaced.csv", "table-3-2.csv", "printed-constants.csv", "supports.csv"})
    expect_kept(command, std::string{"data/"} + table, "a table of the measured tests");
  expect_kept(command, "cards/ensolite-aac-9.toml", "the material card");
}

TEST_F(InputFilesTest, AStillOfTheValidationIsNoTable) {
  fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "data/validation", file("data"));
  fs::create_directory(file("figures"));
  fs::create_hard_link(file("data/supports.csv"), file("figures/figure-3-4.svg"));
  const Outcome outcome =
      dashpad({"validate", "--data", file("data"), "--figures", file("figures"), "--force"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              HasSubstr("figure-3-4.svg: is a table of the measured tests; choose another name"));
}

TEST_F(InputFilesTest, AMeasurementIsKept) {
  write_file(file("drop.csv"), "time_s,acceleration_g\n0,0\n0.001,50\n0.002,0\n");
  for (const char* option : {"--json", "--csv"})
    expect_kept({"pulse", file("drop.csv"), option}, "drop.csv", "the measurement");
}

TEST_F(InputFilesTest, EveryFileOfAnIsoMmeTestIsKept) {
  fs::create_directories(file("test/Channel"));
  write_file(file("test/v1.mme"), "Title :x\n");
  write_file(file("test/Channel/v1.chn"), "Number of channels :2\n");
  const auto channel = [](const std::string& axis) {
    return "Channel code :11HEAD0000H3AC" + axis +
           "A\nUnit :m/(s*s)\nTime of first sample :0\nSampling interval :0.001\nNumber of samples "
           ":3\n0\n5\n0\n";
  };
  write_file(file("test/Channel/v1.001"), channel("X"));
  write_file(file("test/Channel/v1.002"), channel("Y"));
  for (const std::string& test : {file("test"), file("test/v1.mme")}) {
    const std::vector<std::string> command{"pulse", test, "--channel", "1", "--json"};
    ASSERT_EQ(dashpad({"pulse", test, "--channel", "1"}).exit_code, 0);
    expect_kept(command, "test/v1.mme", "the .mme file of the test");
    expect_kept(command, "test/Channel/v1.chn", "the channel list of the test");
    expect_kept(command, "test/Channel/v1.001", "a channel of the test");
    expect_kept(command, "test/Channel/v1.002", "a channel of the test");
  }
}

TEST_F(InputFilesTest, AStoreAndItsPartsAreKept) {
  write_file(file("study.toml"),
             "case = \"with-card.toml\"\n[factors.\"impactor.speed\"]\n"
             "values = [\"2 m/s\", \"3 m/s\"]\n");
  const std::string store = file("store.db");
  ASSERT_EQ(dashpad({"study", file("study.toml"), "--out", store, "--quiet"}).exit_code, 0);
  const std::vector<std::vector<std::string>> commands{{"study", "export", store, "--csv"},
                                                       {"study", "export", store, "--hdf5"},
                                                       {"study", "summary", store, "--json"},
                                                       {"study", "replay", store, "0", "--json"}};
  for (const auto& command : commands) expect_kept(command, "store.db", "the store");
  write_file(file("store.db-wal"), "");
  expect_kept(commands.front(), "store.db-wal", "a part of the store");
}

/// It has no --force: a store is only ever a new file or that of the same study.
TEST_F(InputFilesTest, AStudyKeepsWhatItReads) {
  write_file(file("study.toml"),
             "case = \"with-card.toml\"\n[factors.\"impactor.speed\"]\n"
             "values = [\"2 m/s\", \"3 m/s\"]\n");
  for (const char* input : {"study.toml", "with-card.toml", "card.toml"}) {
    const std::string before = read_file(file(input));
    for (const std::string& name : names_of(input)) {
      EXPECT_EQ(dashpad({"study", file("study.toml"), "--out", name, "--quiet"}).exit_code, 2) << name;
      EXPECT_EQ(read_file(file(input)), before) << name;
    }
  }
}

TEST_F(InputFilesTest, FaultsOfTheCaseHideNotThatItWouldBeOverwritten) {
  write_file(file("bad.toml"), with(elastic_case(), "80 mm", "80 kg"));
  const Outcome outcome = dashpad({"run", file("bad.toml"), "--json", file("bad.toml"), "--force"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("impactor.radius"), HasSubstr("is the case file; choose another name")));
}

TEST_F(InputFilesTest, TwoResultsUnderTwoNamesAreOne) {
  const std::string folder = fs::path{case_file()}.parent_path().string();
  fs::create_symlink("a", file("dangling"));
  fs::create_symlink(".", file("here"));
  const auto expect_refused = [&](const std::string& one, const std::string& other) {
    const Outcome outcome =
        shell("cd " + folder + " && $DASHPAD run case.toml --force --json " + one + " --csv " + other);
    EXPECT_EQ(outcome.exit_code, 2) << one << " " << other;
    EXPECT_THAT(outcome.err, HasSubstr("--csv " + other + ": is also given for --json; choose another name"));
    EXPECT_FALSE(fs::is_regular_file(file("a")));
  };
  for (const std::string& other : {std::string{"./a"}, std::string{".//a"}, std::string{"links/../a"},
                                   std::string{"here/a"}, std::string{"dangling"}, folder + "/a"}) {
    expect_refused("a", other);
    expect_refused(other, "./././a");
  }
  write_file(file("one"), "mine");
  fs::create_hard_link(file("one"), file("two"));
  expect_refused("one", "two");
  EXPECT_EQ(read_file(file("one")), "mine");
}

TEST_F(InputFilesTest, AResultIsNotWrittenToWhereAStreamGoes) {
  const std::string folder = fs::path{case_file()}.parent_path().string();
  const std::string run = "cd " + folder + " && $DASHPAD run case.toml --force --json ";
  EXPECT_EQ(shell(run + "out.txt > out.txt").exit_code, 2);
  EXPECT_EQ(shell(run + "./out.txt >> out.txt").exit_code, 2);
  EXPECT_EQ(shell(run + "- --csv out.txt > out.txt").exit_code, 2);
  EXPECT_EQ(shell(run + "err.txt 2> err.txt").exit_code, 2);
  EXPECT_THAT(read_file(file("err.txt")),
              HasSubstr("is where standard error is redirected; choose another name"));
  EXPECT_EQ(shell(run + "/dev/null > /dev/null").exit_code, 0);
}

TEST_F(InputFilesTest, ADanglingLinkIsFollowedWithForce) {
  fs::create_symlink("real.json", file("link.json"));
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("link.json")}).exit_code, 2);
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("link.json"), "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.json")));
  EXPECT_TRUE(fs::is_regular_file(file("real.json")));
  fs::create_symlink("none/real.json", file("lost.json"));
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("lost.json"), "--force"}).exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
