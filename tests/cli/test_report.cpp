// dashpad run --report: the page goes where the user says, and nowhere else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Report : public CommandTest {};

TEST_F(Report, is_written_beside_the_summary) {
  const Outcome run = dashpad({"run", case_file(), "--report", file("page.html"), "--units", "us"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Peak force"));
  EXPECT_THAT(other_files(), ElementsAre("page.html"));
  const std::string page = read_file(file("page.html"));
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page.find(R"(<main data-one-impact data-units="US")"), std::string::npos);
}

TEST_F(Report, goes_to_standard_output) {
  const Outcome run = dashpad({"run", case_file(), "--report", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("<!DOCTYPE html>"));
  EXPECT_THAT(run.err, HasSubstr("Peak force"));
}

TEST_F(Report, takes_no_other_file_s_place) {
  write_file(file("page.html"), "mine");
  const Outcome kept = dashpad({"run", case_file(), "--report", file("page.html")});
  EXPECT_EQ(kept.exit_code, 2);
  EXPECT_THAT(kept.err, HasSubstr("already exists"));
  EXPECT_EQ(read_file(file("page.html")), "mine");
  const Outcome forced = dashpad({"run", case_file(), "--report", file("page.html"), "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_TRUE(read_file(file("page.html")).starts_with("<!DOCTYPE html>"));
}

TEST_F(Report, and_the_other_results_need_files_of_their_own) {
  const Outcome run = dashpad({"run", case_file(), "--json", "-", "--report", "-"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("only one result can go to standard output"));
  EXPECT_THAT(other_files(), IsEmpty());
}

}  // namespace

}  // namespace dashpad::test
