#pragma once
/// The file of a store (docs/studies.md): its tables, made, and read back with every value checked; one
/// writer at a time, however many read it; and what a Store keeps while it is open.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/study/store.hpp"
#include "study/sqlite.hpp"

namespace dashpad::study {

/// What the tables beside `samples` and `batches` say.
struct StoreHeading {
  std::string program;
  std::string text;      ///< the study file
  std::string resolved;  ///< resolved_text() of the study
  std::uint64_t rows = 0;
  std::uint64_t batch_size = 0;
  std::vector<StoredColumn> factors, responses;
};

StoreHeading heading_of(const Study& study);

/// "0.1.0 (0123456789ab)" of this program.
std::string this_program();

/// Whether there is nothing in the file yet: it is new, or its making was cut short.
bool is_empty(const Database& database);

/// All tables, within the caller's transaction.
void create_tables(Database& database, const Study& study, const StoreHeading& heading);

/// Throws std::runtime_error: no store, a store of another layout, damaged.
StoreHeading read_heading(const Database& database);

/// Columns of `samples` from the first factor on, each with a comma and `before` it and `after` it.
std::string value_columns(const StoreHeading& heading, const std::string& before,
                          const std::string& after = "");

inline constexpr std::uint64_t page_bytes = 16384;

/// At most so many bytes does a batch take in the log: whole pages, those of the index among them.
std::uint64_t log_bytes_of_batch(const StoreHeading& heading);

/// About how many bytes the tables take in the file before the first row.
std::uint64_t bytes_of_tables(const StoreHeading& heading);

/// About how many bytes must be free for so many rows: in the file, for the shortest log that will do, and
/// for the index of the log.
std::uint64_t bytes_of_rows(const StoreHeading& heading, std::uint64_t rows);

/// A lock of the system on one byte of the file, far beyond its end and the bytes that SQLite locks. It goes
/// with the process, keeps no reader out, and leaves nothing behind. Two in one process exclude each other,
/// too.
class WriterLock {
 public:
  /// Makes the file where it is missing. Throws std::runtime_error: another run has the lock, or the file
  /// cannot be opened.
  explicit WriterLock(const std::filesystem::path& file);
  /// Closing a file drops the locks that SQLite has on it in this process: it must be closed before.
  ~WriterLock();
  WriterLock(WriterLock&& other) noexcept;
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  WriterLock& operator=(WriterLock&&) = delete;

 private:
  int descriptor_ = -1;
};

struct Store::File {
  File(Database opened, StoreHeading read) : database(std::move(opened)), heading(std::move(read)) {}

  std::optional<WriterLock> writer_lock;  ///< of a store to write; before the database, to outlive it
  Database database;
  StoreHeading heading;
  std::uint64_t rows_done = 0;
  std::optional<Statement> insert_row, insert_batch;  ///< of a store to write
  [[nodiscard]] std::uint64_t batches() const {
    return heading.rows / heading.batch_size + (heading.rows % heading.batch_size > 0 ? 1 : 0);
  }
  /// The number of rows of a batch below batches().
  [[nodiscard]] std::uint64_t rows_of(std::uint64_t batch) const {
    return std::min(heading.batch_size, heading.rows - batch * heading.batch_size);
  }
};

/// Checks the list of batches against itself and against the rows. Returns the number of rows done.
std::uint64_t count_rows(const Database& database, const StoreHeading& heading);

}  // namespace dashpad::study
