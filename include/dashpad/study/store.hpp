#pragma once
/// The results of a study in one SQLite file (write-ahead log): study, program, factors, responses, one row a
/// sample. Any SQLite tool opens it.
///
/// Rows are written in batches, each in one transaction with the note that it is done: after a kill or a full
/// disk a batch is there whole or not at all.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/study/responses.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

struct StoredRow {
  std::uint64_t row = 0;
  std::vector<double> factors;
  Outcome outcome;
};

class Store {
 public:
  /// Creates the file, or opens one of the very same study (text, seed, program's results version) to go on.
  /// Throws std::runtime_error in the user's words: another study, no store, read-only, locked, full disk.
  static Store open_for(const Study& study, const std::filesystem::path& file);
  static Store open_to_read(const std::filesystem::path& file);

  /// The study's text, for reading it again.
  [[nodiscard]] std::string study_text() const;
  [[nodiscard]] std::uint64_t batch_size() const;
  /// Batches not yet done, increasing.
  [[nodiscard]] std::vector<std::uint64_t> missing_batches() const;
  /// All rows of a batch in one transaction.
  void write_batch(std::uint64_t batch, std::span<const StoredRow> rows);
  [[nodiscard]] std::uint64_t rows_done() const;
  std::optional<StoredRow> row(std::uint64_t number) const;
  /// A column (factor key or response name) of all rows done, by row number.
  std::vector<double> column(const std::string& name) const;

  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

 private:
  struct File;
  std::unique_ptr<File> file_;
  explicit Store(std::unique_ptr<File> file);
};

}  // namespace dashpad::study
