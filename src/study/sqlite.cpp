#include "study/store_file.hpp"

#include <cstring>
#include <limits>
#include <new>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::study {

namespace {

constexpr int milliseconds_for_others = 2000;

/// Whether the file is no store, or holds what no Dashpad wrote.
bool is_damage(int code) {
  const int kind = code & 0xff;
  return kind == SQLITE_CORRUPT || kind == SQLITE_NOTADB || kind == SQLITE_ERROR || kind == SQLITE_MISMATCH ||
         kind == SQLITE_TOOBIG || kind == SQLITE_FORMAT || code == SQLITE_IOERR_SHORT_READ;
}

std::string advice(int code, int system_error) {
  if (code == SQLITE_READONLY_ROLLBACK || code == SQLITE_READONLY_RECOVERY ||
      code == SQLITE_READONLY_CANTINIT)
    return "a run was interrupted and the store must be recovered, but the file or its folder is read-only; "
           "copy the file, together with its -wal or -journal file, to a writable folder";
  const std::string reason = system_error == 0 ? "" : fmt::format(" ({})", std::strerror(system_error));
  switch (code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program has the file open; wait or close that program, then try again";
    case SQLITE_FULL:
      return "the disk is full, but all rows written so far are kept; free some space and repeat the command";
    case SQLITE_NOTADB: return "not the store of a study; give another name";
    case SQLITE_ERROR:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
    case SQLITE_FORMAT:
    case SQLITE_CORRUPT: return "the store is damaged; delete it and run the study again";
    case SQLITE_READONLY:
    case SQLITE_PERM: return "cannot be written: the file or its folder is read-only";
    case SQLITE_CANTOPEN: return "cannot be opened" + reason;
    case SQLITE_IOERR:
      return "the disk cannot be read or written" + reason +
             ", but all rows written so far are kept; check the disk (free space, limits on file size) and "
             "repeat the command";
    default: return fmt::format("cannot be read or written (SQLite error {})", code);
  }
}

}  // namespace

std::string sql_name(std::string_view name) {
  std::string text = "\"";
  for (const char character : name) text += character == '"' ? "\"\"" : std::string(1, character);
  return text + '"';
}

Database::Database(const std::filesystem::path& file, Access access) : name_(file.string()) {
  // Readers also open for writing if they may, to recover what a killed run left.
  const int flags = SQLITE_OPEN_READWRITE | (access == Access::write ? SQLITE_OPEN_CREATE : 0);
  sqlite3* handle = nullptr;
  // The whole path: SQLite takes names such as ":memory:" for something else than files.
  const int code =
      sqlite3_open_v2(std::filesystem::absolute(file).c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(code);
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, milliseconds_for_others);
  // Views and triggers in the file may do nothing but SQL.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (access == Access::read) execute("PRAGMA query_only = ON");
}

// They change the file, though no member.
// NOLINTNEXTLINE(readability-make-member-function-const)
void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

bool Database::has_moved() const {
  int moved = 0;
  sqlite3_file_control(get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
  return moved != 0;
}

std::filesystem::path Database::log() const {
  return sqlite3_filename_wal(sqlite3_db_filename(get(), "main"));
}

// NOLINTNEXTLINE(readability-make-member-function-const)
void Database::write_back_log() {
  sqlite3_busy_timeout(get(), 0);  // a reader may stay for hours
  sqlite3_wal_checkpoint_v2(get(), "main", SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  sqlite3_busy_timeout(get(), milliseconds_for_others);
}

bool Database::is_read_only() const { return sqlite3_db_readonly(get(), "main") == 1; }

void Database::fail(int code) const {
  const int system_error = get() == nullptr ? 0 : sqlite3_system_errno(get());
  if ((code & 0xff) == SQLITE_NOMEM) throw std::bad_alloc();
  const std::string message = name_ + ": " + advice(code, system_error);
  if (is_damage(code)) throw DamagedStore(message);
  throw std::runtime_error(message);
}

void Database::damaged(const std::string& what) const {
  throw DamagedStore(name_ + ": the store is damaged (" + one_line(what) +
                     "); delete it and run the study again");
}

Statement::Statement(const Database& database, const std::string& sql) : database_(&database) {
  sqlite3_stmt* handle = nullptr;
  const int code = sqlite3_prepare_v3(database.get(), sql.c_str(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &handle, nullptr);
  handle_.reset(handle);
  // A table or column that is missing is the file's fault, not the statement's.
  if (code == SQLITE_ERROR) database.damaged("a table or a column is missing");
  if (code != SQLITE_OK) database.fail(code);
}

Statement& Statement::bind(int parameter, double value) {
  sqlite3_bind_double(handle_.get(), parameter + 1, value);
  return *this;
}

Statement& Statement::bind(int parameter, std::int64_t value) {
  sqlite3_bind_int64(handle_.get(), parameter + 1, value);
  return *this;
}

Statement& Statement::bind(int parameter, std::string_view text) {
  sqlite3_bind_text64(handle_.get(), parameter + 1, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  return *this;
}

Statement& Statement::bind_lasting(int parameter, std::string_view text) {
  sqlite3_bind_text64(handle_.get(), parameter + 1, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8);
  return *this;
}

bool Statement::next() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) {
    sqlite3_reset(handle_.get());
    database_->fail(code);
  }
  return false;
}

void Statement::run() {
  next();
  reset();
}

double Statement::number(int column) const {
  switch (sqlite3_column_type(handle_.get(), column)) {
    case SQLITE_FLOAT:
    case SQLITE_INTEGER: return sqlite3_column_double(handle_.get(), column);
    case SQLITE_NULL: return std::numeric_limits<double>::quiet_NaN();
    default: wrong_value(column);
  }
}

std::int64_t Statement::integer(int column) const {
  if (sqlite3_column_type(handle_.get(), column) != SQLITE_INTEGER) wrong_value(column);
  return sqlite3_column_int64(handle_.get(), column);
}

std::uint64_t Statement::count(int column, std::uint64_t most) const {
  const std::int64_t value = integer(column);
  if (value < 0 || static_cast<std::uint64_t>(value) > most) wrong_value(column);
  return static_cast<std::uint64_t>(value);
}

std::string Statement::text(int column) const {
  if (sqlite3_column_type(handle_.get(), column) != SQLITE_TEXT) wrong_value(column);
  const auto* characters = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return {characters, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

std::string Statement::name(int column) const {
  std::string name = text(column);
  if (one_line(name) != name) wrong_value(column);
  return name;
}

void Statement::wrong_value(int column) const {
  // A value computed from several rows has only its SQL as a name.
  const std::string name = sqlite3_column_name(handle_.get(), column);
  database_->damaged(name.find('(') == std::string::npos
                         ? fmt::format("column {} contains an invalid value", quoted_part(name))
                         : "the number of rows or batches is wrong");
}

Transaction::Transaction(Database& database, const char* begin) : database_(database) {
  database_.execute(begin);
}

Transaction::~Transaction() {
  if (open_ && sqlite3_get_autocommit(database_.get()) == 0)
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace dashpad::study
