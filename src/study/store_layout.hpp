#pragma once
/// The tables of a store (docs/studies.md): made, and read back with every value checked.

#include <cstdint>
#include <string>
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

/// Columns of `samples` from the first factor on, each with a comma before it.
std::string value_columns(const StoreHeading& heading);

inline constexpr std::uint64_t page_bytes = 16384;

/// At most so many bytes does a batch take in the log: whole pages, those of the index among them.
std::uint64_t log_bytes_of_batch(const StoreHeading& heading);

/// About how many bytes the tables take in the file before the first row.
std::uint64_t bytes_of_tables(const StoreHeading& heading);

/// About how many bytes must be free for so many rows: in the file, for the shortest log that will do, and
/// for the index of the log.
std::uint64_t bytes_of_rows(const StoreHeading& heading, std::uint64_t rows);

}  // namespace dashpad::study
