// Facts and writing; reading rows is store_rows.cpp.

#include "dashpad/study/store.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/study/resolved_study.hpp"
#include "study/store_file.hpp"

namespace dashpad::study {

namespace {

void check_rows(std::uint64_t batch, std::span<const StoredRow> rows, const StoreHeading& heading) {
  std::uint64_t expected = batch * heading.batch_size;
  for (const StoredRow& row : rows) {
    if (row.row != expected++)
      throw std::invalid_argument(fmt::format("row {} is not of its batch", row.row));
    if (row.factors.size() != heading.factors.size() || row.outcome.values.size() != heading.responses.size())
      throw std::invalid_argument(fmt::format("row {} has other columns than the store", row.row));
  }
}

/// In the order of Status.
const std::string& lasting_name(Status status) {
  static const std::array names{to_string(Status::not_run),           to_string(Status::released),
                                to_string(Status::bottomed_out),      to_string(Status::time_limit),
                                to_string(Status::tolerance_not_met), to_string(Status::at_rest)};
  return names.at(static_cast<std::size_t>(status));
}

/// On a nearly full disk the log is written back while there is room to do it: what it holds is then twice on
/// the disk until it is emptied.
void keep_room(Database& database, const StoreHeading& heading) {
  std::error_code none;
  const std::filesystem::path log = database.log();
  const std::uintmax_t written = std::filesystem::file_size(log, none);
  if (none) return;  // nothing to write back
  const std::filesystem::space_info space = std::filesystem::space(log, none);
  if (!none && space.available < written + 2 * log_bytes_of_batch(heading)) database.write_back_log();
}

void bind(Statement& insert, const StoredRow& row) {
  insert.bind(0, static_cast<std::int64_t>(row.row))
      .bind_lasting(1, lasting_name(row.outcome.status))
      .bind(2, std::int64_t{row.outcome.extrapolated})
      .bind(3, std::int64_t{row.outcome.bottomed})
      .bind(4, row.outcome.error);
  int place = 5;
  for (const auto* values : {&row.factors, &row.outcome.values})
    for (const double value : *values) insert.bind(place++, value);
}

}  // namespace

Store::Store(std::unique_ptr<File> file) : file_(std::move(file)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

/// A store that was written becomes one plain file, that can be read from a read-only folder. Where that
/// fails (a full disk, a reader), the log stays beside the file and nothing is lost.
Store::~Store() {
  if (!file_ || !file_->insert_row) return;
  file_->insert_row.reset();
  file_->insert_batch.reset();
  // The log of that name would be that of another file.
  if (file_->database.has_moved()) return;
  sqlite3_exec(file_->database.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
}

void Store::check_in_place() const {
  if (file_->database.has_moved())
    throw std::runtime_error(
        file_->database.name() +
        ": it was deleted, renamed or replaced while the study ran, and its rows are not "
        "there: give the same command again, and leave the file alone until it ends");
}

const std::string& Store::file() const { return file_->database.name(); }
std::string Store::study_text() const { return file_->heading.text; }
const std::string& Store::resolved_text() const { return file_->heading.resolved; }
bool Store::is_of(const Study& study) const {
  return study.text == file_->heading.text && study::resolved_text(study) == file_->heading.resolved;
}
const std::string& Store::program() const { return file_->heading.program; }
const std::vector<StoredColumn>& Store::factors() const { return file_->heading.factors; }
const std::vector<StoredColumn>& Store::responses() const { return file_->heading.responses; }
std::uint64_t Store::rows() const { return file_->heading.rows; }
std::uint64_t Store::rows_done() const { return file_->rows_done; }
std::uint64_t Store::batch_size() const { return file_->heading.batch_size; }

std::vector<std::uint64_t> Store::missing_batches() const {
  Statement done{file_->database, "SELECT batch FROM batches ORDER BY batch"};
  std::vector<std::uint64_t> missing;
  std::uint64_t next = 0;
  while (done.next()) {
    const std::uint64_t batch = done.count(0, file_->batches() - 1);
    for (; next < batch; ++next) missing.push_back(next);
    next = batch + 1;
  }
  for (; next < file_->batches(); ++next) missing.push_back(next);
  return missing;
}

void Store::write_batch(std::uint64_t batch, std::span<const StoredRow> rows) {
  if (!file_->insert_row) throw std::invalid_argument("the store is open to read");
  if (batch >= file_->batches() || rows.size() != file_->rows_of(batch))
    throw std::invalid_argument(fmt::format("batch {} does not have {} rows", batch, rows.size()));
  check_rows(batch, rows, file_->heading);
  check_in_place();
  keep_room(file_->database, file_->heading);
  Transaction transaction{file_->database};
  for (const StoredRow& row : rows) {
    bind(*file_->insert_row, row);
    file_->insert_row->run();
  }
  file_->insert_batch->bind(0, static_cast<std::int64_t>(batch))
      .bind(1, static_cast<std::int64_t>(rows.size()))
      .run();
  transaction.commit();
  file_->rows_done += rows.size();
}

}  // namespace dashpad::study
