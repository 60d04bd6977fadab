#pragma once
/// SQLite's C interface with owners and exceptions. Messages name the file and say what to do.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

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
  /// Writes the log back into the file and empties it, as far as readers and the disk let it: what stays in
  /// the log is not lost.
  void write_back_log();
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] sqlite3* get() const { return handle_.get(); }

  /// Throws std::runtime_error for what SQLite reports, DamagedStore for damage: `code` in the user's words.
  [[noreturn]] void fail(int code) const;
  /// Throws DamagedStore: the file holds what no Dashpad writes.
  [[noreturn]] void damaged(const std::string& what) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  std::string name_;  ///< as the user gave it
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

}  // namespace dashpad::study
