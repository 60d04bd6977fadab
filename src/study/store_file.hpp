#pragma once
/// What a Store keeps while it is open.

#include <optional>
#include <string>
#include <utility>

#include "dashpad/study/store.hpp"
#include "study/sqlite.hpp"
#include "study/store_layout.hpp"
#include "study/writer_lock.hpp"

namespace dashpad::study {

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
