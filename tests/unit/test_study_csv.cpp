// The CSV of a store.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

#include "dashpad/study/store.hpp"
#include "shared/temporary_folder.hpp"
#include "small_study.hpp"

namespace dashpad::test {
namespace {

using study::Store;
using ::testing::StartsWith;

std::string csv_of(const Store& store) {
  std::string text;
  study::export_csv(store, [&](std::string_view piece) { text += piece; });
  return text;
}

TEST(StudyCsv, has_a_line_a_row_with_units_and_empty_places) {
  const test::TemporaryFolder folder;
  Store store = Store::open_for(small_study(64), folder.path() / "s");
  fill(store);
  EXPECT_THAT(csv_of(store),
              StartsWith("row,status,extrapolated,extrapolated_strain,extrapolated_rate,bottomed,error,"
                         "impactor.speed_m_per_s,peak_force_N,"
                         "rebound_speed_m_per_s\n"
                         "0,time limit,1,1,0,1,0,1,1,\n"
                         "1,released,0,0,0,0,1e-05,1.001,1.0010005001667084,1.140175425099138\n"));
}

TEST(StudyCsv, reads_back_as_the_same_numbers) {
  const test::TemporaryFolder folder;
  Store store = Store::open_for(small_study(3000), folder.path() / "s");
  fill(store);
  std::istringstream text(csv_of(store));
  std::string line;
  std::getline(text, line);
  std::uint64_t row = 0;
  for (; std::getline(text, line); ++row) {
    const std::string speed = line.substr(0, line.rfind(','));
    ASSERT_EQ(std::stod(speed.substr(speed.rfind(',') + 1)), made_up_row(row).outcome.values[0]) << line;
  }
  EXPECT_EQ(row, 3000U);
}

TEST(StudyCsv, has_the_rows_done_only) {
  const test::TemporaryFolder folder;
  Store store = Store::open_for(small_study(640), folder.path() / "s");
  EXPECT_EQ(csv_of(store).find('\n'), csv_of(store).size() - 1) << "the heading";
  store.write_batch(2, made_up_batch(store, 2));
  EXPECT_THAT(csv_of(store).substr(csv_of(store).find('\n') + 1), StartsWith("20,released"));
}

TEST(StudyCsv, passes_on_what_the_writer_throws) {
  const test::TemporaryFolder folder;
  const Store store = Store::open_for(small_study(64), folder.path() / "s");
  EXPECT_THROW(study::export_csv(store, [](std::string_view) { throw std::runtime_error("full"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace dashpad::test
