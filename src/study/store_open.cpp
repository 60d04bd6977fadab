// Opening a store: new, to go on, to read.

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "dashpad/study/study_file.hpp"
#include "study/store_file.hpp"

namespace dashpad::study {

namespace fs = std::filesystem;

namespace {

constexpr off_t place_of_lock = off_t{1} << 62;

[[noreturn]] void refuse(const std::filesystem::path& file, int error) {
  std::string why = std::string{"cannot be opened ("} + std::strerror(error) + ")";
  if (error == EACCES || error == EPERM || error == EROFS)
    why = "cannot be written: the file or its folder is read-only";
  if (error == EAGAIN)
    why = "another run is writing to it; wait until that run ends, or stop it, and try again";
  throw std::runtime_error(file.string() + ": " + why);
}

constexpr std::uint64_t log_bytes = 16 << 20;  ///< the write-ahead log is written back at this size

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why);
}

void check_room(const fs::path& file, std::uint64_t needed) {
  std::error_code error;
  const fs::space_info space = fs::space(fs::absolute(file).parent_path(), error);
  if (!error && needed > space.available)
    refuse(file,
           fmt::format("the study needs about {:.1f} MB of disk space, but only {:.1f} MB is free; free some "
                       "space, or reduce the number of rows or responses",
                       1e-6 * static_cast<double>(needed), 1e-6 * static_cast<double>(space.available)));
}

/// Checks everything that can be known before a file is made.
void check_place(const fs::path& file, const StoreHeading& heading) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(file, "not a file; give the name of a file");
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder, error))
    refuse(file, "there is no folder " + folder.string() + "; create it first");
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
    refuse(file, "the folder is read-only; choose another folder, or change its permissions");
  if (!fs::exists(status)) check_room(file, bytes_of_tables(heading) + bytes_of_rows(heading, heading.rows));
}

/// Checks the list of batches against itself and against the rows. Returns the number of rows done.
std::uint64_t count_rows(const Database& database, const StoreHeading& heading) {
  Statement noted{database,
                  "SELECT total(rows), coalesce(min(batch), 0), coalesce(max(batch), 0) FROM batches"};
  noted.next();
  const double expected = noted.number(0);
  if (noted.integer(1) < 0 || noted.count(2, heading.rows) * heading.batch_size >= heading.rows)
    database.damaged("it contains a batch that the study does not have");
  Statement stored{database, "SELECT count(*), coalesce(min(row), 0), coalesce(max(row), 0) FROM samples"};
  stored.next();
  const std::uint64_t rows = stored.count(0, heading.rows);
  if (stored.integer(1) < 0 || stored.count(2, heading.rows) >= heading.rows)
    database.damaged("it contains a row that the study does not have");
  if (static_cast<double>(rows) != expected)
    database.damaged(fmt::format("it contains {} rows instead of the {} recorded", rows, expected));
  return rows;
}

/// Rows of two programs are never mixed: they may differ in the last digits, or by a mended fault.
std::string of_another_program(const Database& database, const StoreHeading& stored,
                               const StoreHeading& wanted) {
  return fmt::format(
      "Dashpad {} computed the existing {} of {} rows, and this is Dashpad {}; a store can hold rows from "
      "one version only. To keep these rows, continue with that version; to compute all rows with this "
      "version, give another name or delete the file. Either version can read the store (summary, export)",
      stored.program, count_rows(database, stored), stored.rows, wanted.program);
}

/// Whether a store is that of the study but for the number of its draws.
bool is_of_other_draws(const Study& study, const StoreHeading& stored, const StoreHeading& wanted) {
  if (stored.rows == 0 || wanted.rows % study.samples != 0) return false;
  const std::uint64_t rows_of_draw = wanted.rows / study.samples;
  Study other = study;
  other.samples = stored.rows / rows_of_draw;
  return stored.rows % rows_of_draw == 0 && other.samples != study.samples &&
         resolved_text(other) == stored.resolved;
}

/// The rule for a store with another number of draws that cannot be taken up; "" if it can.
std::string rule_for_draws(const Study& study, const StoreHeading& stored, const StoreHeading& wanted,
                           bool extend) {
  const std::string has = fmt::format(
      "the store belongs to this study, but has {} rows where the study has {}", stored.rows, wanted.rows);
  if (stored.rows > wanted.rows) return has + "; give another name";
  if (study.sampling == Sampling::latin_hypercube)
    return has +
           "; the draws of a Latin hypercube change with their number, so none can be kept; give another "
           "name";
  if (sampled_factors(study).size() < study.factors.size())
    return has + "; in a study with levels, more draws would renumber the rows; give another name";
  return extend ? "" : has + "; use --extend to keep these rows and compute the others";
}

/// Makes room for more draws: the last batch is taken back if it was not a whole one.
void extend_store(Database& database, StoreHeading& stored, const StoreHeading& wanted) {
  const std::uint64_t whole = stored.rows / stored.batch_size;
  if (stored.rows % stored.batch_size > 0) {
    Statement{database, "DELETE FROM samples WHERE row >= ?"}.run_with(
        static_cast<std::int64_t>(whole * stored.batch_size));
    Statement{database, "DELETE FROM batches WHERE batch = ?"}.run_with(static_cast<std::int64_t>(whole));
  }
  Statement change{database, "UPDATE study SET value = ? WHERE key = ?"};
  change.run_with(wanted.text, "text");
  change.run_with(wanted.resolved, "resolved");
  change.run_with(static_cast<std::int64_t>(wanted.rows), "rows");
  stored.text = wanted.text;
  stored.resolved = wanted.resolved;
  stored.rows = wanted.rows;
}

void check_same(const Database& database, const Study& study, const StoreHeading& stored,
                const StoreHeading& wanted, bool extend) {
  const auto refuse_for = [&](const std::string& why) {
    throw std::runtime_error(database.name() + ": " + why);
  };
  if (is_of_other_draws(study, stored, wanted)) {
    if (const std::string rule = rule_for_draws(study, stored, wanted, extend); !rule.empty())
      refuse_for(rule);
    if (stored.program != wanted.program) refuse_for(of_another_program(database, stored, wanted));
    return;
  }
  if (stored.text != wanted.text)
    refuse_for("the store belongs to a different study (the text differs); give another name");
  if (stored.program != wanted.program) refuse_for(of_another_program(database, stored, wanted));
  if (stored.resolved != wanted.resolved)
    refuse_for(
        "the store belongs to this study, but the base case, a card or a data file that the study uses has "
        "since changed; undo the change, or give another name");
  if (stored.rows != wanted.rows) database.damaged("it has a different number of rows");
}

/// With synchronous = NORMAL a kill loses nothing that was committed. A power cut may lose the last batches,
/// which are computed again, but never damages the file.
void start_log(Database& database) {
  database.execute(
      fmt::format("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; "
                  "PRAGMA wal_autocheckpoint = {}; PRAGMA journal_size_limit = {};",
                  log_bytes / page_bytes, log_bytes));
  Transaction{database, "BEGIN IMMEDIATE"}.commit();  // fails here if the log cannot be used
}

std::string insert_text(const StoreHeading& heading) {
  std::string marks = "?, ?, ?, ?, ?";
  for (std::size_t i = 0; i < heading.factors.size() + heading.responses.size(); ++i) marks += ", ?";
  return "INSERT INTO samples (row, status, extrapolated, bottomed, error" + value_columns(heading, "") +
         ") VALUES (" + marks + ")";
}

/// SQLite would read a truncated last page as one that ends in zeros, and a file shorter than its heading as
/// a new one. With a log beside it, the page is whole there.
void require_whole(const Database& database) {
  constexpr std::string_view heading{"SQLite format 3\0", 16};
  constexpr std::uintmax_t smallest_page = 512;  // bytes; all are multiples
  std::error_code error;
  const std::uintmax_t size = fs::file_size(database.name(), error);
  if (error || size == 0) return;
  std::string begin(heading.size(), ' ');
  std::ifstream(database.name(), std::ios::binary)
      .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin != heading) database.fail(SQLITE_NOTADB);
  if (size % smallest_page == 0) return;
  for (const char* log : {"-wal", "-journal"})
    if (fs::exists(database.name() + log, error)) return;
  database.damaged("the end of the file is missing");
}

void make_or_check(Database& database, const Study& study, StoreHeading& heading, bool extend) {
  require_whole(database);
  Transaction transaction{database, "BEGIN IMMEDIATE"};
  if (is_empty(database)) {
    create_tables(database, study, heading);
  } else {
    StoreHeading stored = read_heading(database);
    check_same(database, study, stored, heading, extend);
    if (stored.resolved != heading.resolved) extend_store(database, stored, heading);
    heading = std::move(stored);
  }
  database.execute(results_view(heading, study.labels));
  transaction.commit();
}

/// With the write-ahead log others can read while this run writes, through a shared index in memory
/// (FILE-shm). Where the disk does not support that, the index is private and readers have to wait.
Database open_to_write(const fs::path& file, const Study& study, StoreHeading& heading, bool extend) {
  const auto open = [&](bool shared) {
    Database database{file, Access::write};
    if (database.is_read_only()) database.fail(SQLITE_READONLY);
    if (!shared) database.execute("PRAGMA locking_mode = EXCLUSIVE");
    database.execute(fmt::format("PRAGMA page_size = {}; PRAGMA cache_size = -16000;", page_bytes));
    make_or_check(database, study, heading, extend);
    start_log(database);
    return database;
  };
  try {
    return open(true);
  } catch (const std::runtime_error&) {
    return open(false);  // any other fault is reported now
  }
}

/// Removes the files of a store that could not be made.
void remove_new_file(const fs::path& file) {
  std::error_code ignored;
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + suffix, ignored);
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) refuse(file, errno);
  // The lock belongs to the open file, not the process (F_SETLK): SQLite closes the file itself.
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = place_of_lock;
  lock.l_len = 1;
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
  const int error = errno == EACCES ? EAGAIN : errno;
  ::close(descriptor_);
  refuse(file, error);
}

WriterLock::~WriterLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

WriterLock::WriterLock(WriterLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

Store Store::open_for(const Study& study, const fs::path& file, bool extend) {
  StoreHeading heading = heading_of(study);
  check_place(file, heading);
  const bool is_new = !fs::exists(file);
  WriterLock lock{file};
  try {
    Database database = open_to_write(file, study, heading, extend);
    auto opened = std::make_unique<File>(std::move(database), std::move(heading));
    opened->writer_lock.emplace(std::move(lock));
    opened->rows_done = count_rows(opened->database, opened->heading);
    opened->database.write_back_log();  // left by a kill or a full disk
    const std::uint64_t missing = opened->heading.rows - opened->rows_done;
    if (!is_new && missing > 0) check_room(file, bytes_of_rows(opened->heading, missing));
    opened->insert_row.emplace(opened->database, insert_text(opened->heading));
    opened->insert_batch.emplace(opened->database, "INSERT INTO batches (batch, rows) VALUES (?, ?)");
    return Store{std::move(opened)};
  } catch (...) {
    if (is_new) remove_new_file(file);
    throw;
  }
}

Store Store::open_to_read(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) refuse(file, "there is no such file");
  if (!fs::is_regular_file(file, error)) refuse(file, "not a file");
  Database database{file, Access::read};
  require_whole(database);
  // The transaction keeps one view of the file while the store is open, whatever a running study adds.
  database.execute("BEGIN");
  if (is_empty(database)) refuse(file, "not the store of a study: the file is empty");
  StoreHeading heading = read_heading(database);
  auto opened = std::make_unique<File>(std::move(database), std::move(heading));
  opened->rows_done = count_rows(opened->database, opened->heading);
  return Store{std::move(opened)};
}

}  // namespace dashpad::study
