#pragma once
/// SQLite's C interface with owners and exceptions. Messages name the file and say what to do.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sqlite3.h>

#include "dashpad/study/store.hpp"

namespace dashpad::study {

enum class Access { read, write };

/// A text in quotes, as SQL names a column: pad.thickness gives "pad.thickness".
std::string sql_name(std::string_view name);

class Database {
 public:
  /// Opens a file; with Access::write it is made where it is missing. Throws std::runtime_error.
  Database(const std::filesystem::path& file, Access access);

  /// Runs statements without parameters or rows.
  void execute(const std::string& sql);
  [[nodiscard]] bool is_read_only() const;
  /// Whether the file was deleted, renamed or replaced since it was opened.
  [[nodiscard]] bool has_moved() const;
  /// The write-ahead log beside the file; it need not be there.
  [[nodiscard]] std::filesystem::path log() const;
  /// Writes the log back into the file and empties it, as far as readers and the disk allow.
  void write_back_log();
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* get() const { return handle_.get(); }

  /// Throws std::runtime_error with SQLite's error in the user's words, DamagedStore for damage.
  [[noreturn]] void fail(int code) const;
  /// Throws DamagedStore for content that Dashpad does not write.
  [[noreturn]] void damaged(const std::string& what) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  std::string name_;  ///< name given by the user
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Columns and parameters count from 0 here.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);

  Statement& bind(int parameter, double value);  ///< NaN becomes NULL
  Statement& bind(int parameter, std::int64_t value);
  Statement& bind(int parameter, std::string_view text);
  /// A text that outlives the statement, and is not copied.
  Statement& bind_lasting(int parameter, std::string_view text);
  /// The next row; false after the last.
  bool next();
  /// Runs a statement that has no rows, ready for other parameters.
  void run();
  /// The same with these values for the parameters, from the first on.
  template <class... Values>
  void run_with(const Values&... values) {
    int parameter = 0;
    (bind(parameter++, values), ...);
    run();
  }
  void reset() { sqlite3_reset(handle_.get()); }

  /// Values of the row; std::runtime_error where the type is another.
  [[nodiscard]] double number(int column) const;  ///< NaN for NULL
  [[nodiscard]] std::int64_t integer(int column) const;
  /// An integer in [0, most].
  [[nodiscard]] std::uint64_t count(int column, std::uint64_t most) const;
  [[nodiscard]] std::string text(int column) const;
  /// A name: a text without line breaks and other control characters, which a terminal would obey.
  [[nodiscard]] std::string name(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }
  };
  [[noreturn]] void wrong_value(int column) const;

  const Database* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// BEGIN to COMMIT; rolled back where an exception comes between.
class Transaction {
 public:
  explicit Transaction(Database& database, const char* begin = "BEGIN IMMEDIATE");
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

// The file of a store (docs/studies.md): its tables, the lock of its writer, and the state of an open Store.

/// The content of the tables beside `samples` and `batches`.
struct StoreHeading {
  std::string program;
  std::string text;      ///< the study file
  std::string resolved;  ///< resolved_text() of the study
  std::uint64_t rows = 0;
  std::uint64_t batch_size = 0;
  std::vector<StoredColumn> factors, responses;
};

StoreHeading heading_of(const Study& study);

/// Whether there is nothing in the file yet: it is new, or its making was cut short.
bool is_empty(const Database& database);

/// Creates all tables within the caller's transaction.
void create_tables(Database& database, const Study& study, const StoreHeading& heading);

/// The statement that makes the view `results` unless it is there: the columns of export_csv(), and `flags`.
std::string results_view(const StoreHeading& heading, const std::vector<RowLabel>& labels);

/// Throws std::runtime_error for a file that is no store, has another layout or is damaged.
StoreHeading read_heading(const Database& database);

/// Columns of `samples` from the first factor on, each with a comma and `before` it and `after` it.
std::string value_columns(const StoreHeading& heading, const std::string& before,
                          const std::string& after = "");

inline constexpr std::uint64_t page_bytes = 16384;

/// The largest number of bytes that a batch takes in the log, in whole pages with those of the index.
std::uint64_t log_bytes_of_batch(const StoreHeading& heading);

/// About how many bytes the tables take in the file before the first row.
std::uint64_t bytes_of_tables(const StoreHeading& heading);

/// The approximate number of free bytes for so many rows: file, shortest log, and index of the log.
std::uint64_t bytes_of_rows(const StoreHeading& heading, std::uint64_t rows);

/// A system lock on one byte far beyond the end of the file and the bytes that SQLite locks. It ends with the
/// process and does not affect readers. Two locks in one process exclude each other, too.
class WriterLock {
 public:
  /// Makes a missing file. Throws std::runtime_error if another run has the lock or it cannot be opened.
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

  std::optional<WriterLock> writer_lock;  ///< for writing only; stands before the database to outlive it
  Database database;
  StoreHeading heading;
  std::uint64_t rows_done = 0;
  std::optional<Statement> insert_row, insert_batch;  ///< for writing only
  [[nodiscard]] std::uint64_t batches() const {
    return heading.rows / heading.batch_size + (heading.rows % heading.batch_size > 0 ? 1 : 0);
  }
  /// The number of rows of a batch below batches().
  [[nodiscard]] std::uint64_t rows_of(std::uint64_t batch) const {
    return std::min(heading.batch_size, heading.rows - batch * heading.batch_size);
  }
};

}  // namespace dashpad::study
