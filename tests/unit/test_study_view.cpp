// The view `results` of a store, read as any program with SQLite reads it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/study/store.hpp"
#include "quantities/text.hpp"
#include "shared/temporary_folder.hpp"
#include "small_study.hpp"

namespace dashpad::test {
namespace {

using study::Store;
using testing::ElementsAre;

/// A value of SQLite as the CSV export writes it.
std::string field(sqlite3_stmt* row, int column) {
  switch (sqlite3_column_type(row, column)) {
    case SQLITE_NULL: return "";
    case SQLITE_INTEGER: return std::to_string(sqlite3_column_int64(row, column));
    case SQLITE_FLOAT: return fmt::format("{}", sqlite3_column_double(row, column));
    default: return csv_field(reinterpret_cast<const char*>(sqlite3_column_text(row, column)));
  }
}

/// The heading and the rows of a query, each as a line of CSV.
std::vector<std::string> lines_of(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
  sqlite3_stmt* query = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), -1, &query, nullptr);
  const std::string message = sqlite3_errmsg(database);
  std::vector<std::string> lines(1);
  const int columns = sqlite3_column_count(query);
  for (int i = 0; i < columns; ++i) lines[0] += (i > 0 ? "," : "") + csv_field(sqlite3_column_name(query, i));
  while (sqlite3_step(query) == SQLITE_ROW) {
    lines.emplace_back();
    for (int i = 0; i < columns; ++i) lines.back() += (i > 0 ? "," : "") + field(query, i);
  }
  sqlite3_finalize(query);
  sqlite3_close(database);
  if (columns == 0) throw std::runtime_error(message);
  return lines;
}

std::vector<std::string> csv_of(const std::filesystem::path& file) {
  std::string text;
  study::export_csv(Store::open_to_read(file), [&](std::string_view piece) { text += piece; });
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class StudyView : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "s"; }
  test::TemporaryFolder folder_;
};

/// A table of two rows with labels, a choice of two materials, an acceleration, and blank results.
TEST_F(StudyView, has_the_names_and_the_numbers_of_the_csv) {
  study::Study study = small_study(150);
  study.responses = {"peak_acceleration", "rebound_speed"};
  study.factors.push_back(
      {.key = "pad.material", .unit = "", .spread = study::ByRow{{1, 0}}, .lowest = {}, .highest = {}});
  study.materials.resize(2, study.base.pad.material);
  study.materials[0].name = "soft, grey";
  study.materials[1].name = "hard";
  study.labels = {{"the test's \"number\"", {"b'7", "a, 1"}}, {"remark", {"", "new"}}};
  {
    Store store = Store::open_for(study, file());
    ASSERT_EQ(store.rows(), 300U);
    for (const std::uint64_t batch : store.missing_batches()) {
      std::vector<study::StoredRow> rows = made_up_batch(store, batch);
      for (study::StoredRow& row : rows) row.factors.push_back(row.row < 150 ? 1 : 0);
      store.write_batch(batch, rows);
    }
  }
  const std::vector<std::string> expected = csv_of(file());
  std::vector<std::string> columns = lines_of(file(), "SELECT * FROM results");
  ASSERT_EQ(columns.size(), expected.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& line = columns[i];
    EXPECT_TRUE(line.starts_with(expected[i] + ",")) << line << "\n" << expected[i];
  }
  EXPECT_THAT(lines_of(file(),
                       "SELECT row, peak_acceleration_g * 9.80665 > 1, \"impactor.speed_m_per_s\", "
                       "\"pad.material\", remark FROM results WHERE row IN (149, 150)"),
              ElementsAre(testing::_, "149,1,1.149,hard,", "150,1,1.15,\"soft, grey\",new"));
}

TEST_F(StudyView, says_in_words_what_is_doubtful) {
  {
    Store store = Store::open_for(small_study(4), file());
    using namespace study;
    const unsigned kinds[]{0, extrapolated_strain | extrapolated_rate, extrapolated_untold,
                           extrapolated_rate | extrapolated_otherwise};
    for (const std::uint64_t batch : store.missing_batches()) {
      std::vector<StoredRow> rows = made_up_batch(store, batch);
      for (StoredRow& row : rows) {
        row.outcome.extrapolated = kinds[row.row];
        row.outcome.bottomed = row.row == 3;
      }
      store.write_batch(batch, rows);
    }
  }
  EXPECT_THAT(
      lines_of(file(), "SELECT status, flags FROM results"),
      ElementsAre("status,flags", "time limit,", "released,\"EXTRAPOLATED STRAIN, EXTRAPOLATED RATE\"",
                  "released,EXTRAPOLATED", "released,\"EXTRAPOLATED RATE, EXTRAPOLATED, BOTTOMED\""));
}

/// Such as a store of an earlier commit with the same rows; a table of that name is somebody's own.
TEST_F(StudyView, is_made_where_it_is_missing_and_takes_no_name) {
  { Store::open_for(small_study(64), file()); }
  edit(file(), "DROP VIEW results");
  EXPECT_THROW(lines_of(file(), "SELECT * FROM results"), std::runtime_error);
  {
    Store store = Store::open_for(small_study(64), file());
    fill(store);
  }
  EXPECT_EQ(lines_of(file(), "SELECT * FROM results").size(), 65U);
  edit(file(), "DROP VIEW results; CREATE TABLE results (mine); INSERT INTO results VALUES (7)");
  { Store::open_for(small_study(64), file()); }
  EXPECT_THAT(lines_of(file(), "SELECT * FROM results"), ElementsAre("mine", "7"));
  EXPECT_EQ(Store::open_to_read(file()).rows_done(), 64U);
}

}  // namespace
}  // namespace dashpad::test
