/// Profiles of noses from tables: what is read, and what is said about each kind of bad one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "input/case_tables.hpp"
#include "sample_case.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

class ProfileCsvTest : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const auto file = folder_.path() / "nose.csv";
    std::ofstream{file, std::ios::binary} << text;
    return file;
  }
  Profile read(const std::string& text) { return input::read_profile_csv(write(text)).value(); }
  /// "line: rule", one fault a line.
  std::string faults(const std::string& text) {
    try {
      read(text);
    } catch (const input::InputError& error) {
      std::string all;
      for (const input::Fault& fault : error.faults()) {
        EXPECT_EQ(std::filesystem::path(fault.file).filename(), "nose.csv");
        all += fmt::format("{}: {}\n", fault.line, fault.rule);
      }
      return all;
    }
    ADD_FAILURE() << "accepted: " << text;
    return "";
  }
  /// One fault, whose line and part of whose rule are these.
  void expect_fault(const std::string& text, int line, const std::string& rule) {
    const std::string all = faults(text);
    EXPECT_EQ(std::ranges::count(all, '\n'), 1) << text << all;
    EXPECT_TRUE(all.starts_with(fmt::format("{}: ", line))) << text << all;
    EXPECT_NE(all.find(rule), std::string::npos) << text << all;
  }

  test::TemporaryFolder folder_;
};

TEST_F(ProfileCsvTest, ReadsUnitsFromTheHeader) {
  for (const char* text :
       {"depth_mm,radius_mm\n0,10\n5,20\n", "depth [mm];radius [cm]\n0;1\n5;2\n",
        "Depth (m)\tRadius (m)\n0\t0.01\n0.005\t0.02\n", "depth,radius\n[mm],[mm]\n0,10\n5,20\n",
        "# of a headform\nnote,radius_mm,depth_mm\ntip,10,0\nend,20,5\n",
        "\357\273\277depth_mm;radius_mm\r\n0;10\r\n5,0;20\r\n"}) {
    const Profile profile = read(text);
    ASSERT_EQ(profile.points.size(), 2) << text;
    EXPECT_EQ(profile.of, Profile::Of::radius) << text;
    EXPECT_EQ(profile.points[0].depth, 0) << text;
    EXPECT_DOUBLE_EQ(profile.points[0].size, 0.01) << text;
    EXPECT_DOUBLE_EQ(profile.points[1].depth, 0.005) << text;
    EXPECT_DOUBLE_EQ(profile.points[1].size, 0.02) << text;
  }
  const Profile areas = read("depth_mm,area_cm2\n0,0\n5,20\n");
  EXPECT_EQ(areas.of, Profile::Of::area);
  EXPECT_DOUBLE_EQ(areas.points[1].size, 0.002);
}

TEST_F(ProfileCsvTest, SaysWhatIsWrongWithTheHeader) {
  expect_fault("", 0, "is empty");
  expect_fault("0,0\n5,20\n", 1, "names the columns");
  expect_fault("depth_mm,width_mm\n0,0\n5,20\n", 1, "needs a radius or area column in the header");
  expect_fault("s_mm,radius_mm\n0,0\n5,20\n", 1, "needs a depth column in the header");
  expect_fault("depth_mm,radius_mm,area_mm2\n0,0,0\n5,20,30\n", 1, "not both");
  expect_fault("depth,radius_mm\n0,0\n5,20\n", 1, "the depth column needs a unit");
  expect_fault("depth_mm,radius_kg\n0,0\n5,20\n", 1, "a length is needed");
  expect_fault("depth_mm,depth_cm,radius_mm\n0,0,0\n5,20,30\n", 1, "is a second column called depth");
}

TEST_F(ProfileCsvTest, SaysWhatIsWrongWithARow) {
  const std::string head = "depth_mm,radius_mm\n0,0\n";
  expect_fault(head, 0, "needs at least two rows");
  expect_fault("depth_mm,radius_mm\n1,0\n5,20\n", 2, "the first depth must be 0");
  expect_fault(head + "5,20\n4,30\n", 4, "the depth must exceed the previous depth");
  expect_fault(head + "5,20\n5,30\n", 4, "the depth must exceed the previous depth");
  expect_fault(head + "5,20\n6,19\n", 4, "the radius must not decrease");
  expect_fault("depth_mm,radius_mm\n0,-1\n5,20\n", 2, "the radius must not be negative");
  expect_fault(head + "5,nan\n", 3, "finite");
  expect_fault(head + "5,wide\n", 3, "number");
  expect_fault(head + "5\n", 3, "");
  expect_fault(head + "5,0\n", 3, "must be more than 0");
  std::string many = head;
  for (int i = 1; i <= 10'000; ++i) many += fmt::format("{0},{0}\n", i);
  expect_fault(many, 10'002, "has more than 10000 rows; thin them out");
  expect_fault(head + std::string(2 << 20, '1'), 0, "larger than 1 MiB");
}

TEST_F(ProfileCsvTest, IsNamedFromTheFolderOfTheCase) {
  write("depth_mm,radius_mm\n0,0\n5,20\n");
  const auto file = folder_.path() / "case.toml";
  const auto write_case = [&](const std::string& name) {
    std::ofstream{file} << test::edited(test::good_case, "radius = \"3 in\"",
                                        "nose = \"profile\"\nfile = \"" + name + "\"");
  };
  write_case("nose.csv");
  const input::CaseFile read = input::read_case(file, test::materials).value();
  EXPECT_EQ(std::get<Profile>(read.impact.impactor.nose).points.size(), 2);
  ASSERT_EQ(read.files.size(), 3);
  EXPECT_EQ(read.files[1].file.filename(), "nose.csv");
  // The faults of the table, and none of the case.
  write("depth_mm,radius_mm\n0,0\n5,20\n6,10\n");
  try {
    input::read_case(file, test::materials).value();
    FAIL();
  } catch (const input::InputError& error) {
    ASSERT_EQ(error.faults().size(), 1) << error.what();
    EXPECT_EQ(error.faults()[0].line, 4);
    EXPECT_EQ(std::filesystem::path(error.faults()[0].file).filename(), "nose.csv");
  }
}

}  // namespace
}  // namespace dashpad
