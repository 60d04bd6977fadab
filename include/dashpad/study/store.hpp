#pragma once
/// The results of a study in one SQLite file (write-ahead log): study, program, factors, responses, one row a
/// sample. Any SQLite tool opens it.
///
/// Rows are written in batches, each in one transaction with the note that it is done: after a kill or a full
/// disk a batch is there whole or not at all.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/study/responses.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

struct StoredRow {
  std::uint64_t row = 0;
  std::vector<double> factors;
  Outcome outcome;
};

/// The order is that of Status; the file contains their words.
inline constexpr std::array all_statuses{Status::not_run,    Status::released,          Status::bottomed_out,
                                         Status::time_limit, Status::tolerance_not_met, Status::at_rest};

/// A factor or a response as the file describes it.
struct StoredColumn {
  std::string name;     ///< "impactor.speed", "peak_force"
  std::string unit;     ///< SI; "" for a material
  std::string meaning;  ///< meaning of a response; "" for a factor
};

/// A file that is no store of a study, or that holds what no Dashpad wrote; what() names it.
class DamagedStore : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An open store. Members that read throw DamagedStore for a damaged file. Not safe for several threads.
class Store {
 public:
  /// Creates the file, or opens that of the very same study (text, named files, program version and commit)
  /// to continue; with `extend` also that of the study with fewer draws, whose rows stay. Rows of a Latin
  /// hypercube change with the number of draws, and those of a study with levels change their places: both
  /// are refused. While it is open only this store can write, but all can read. Throws std::runtime_error in
  /// the user's words for another study, a file that is no store or read-only, another writer, a full disk.
  static Store open_for(const Study& study, const std::filesystem::path& file, bool extend = false);
  /// The rows that are there now: what a running study adds later is not seen.
  static Store open_to_read(const std::filesystem::path& file);

  /// The file, as it was named.
  [[nodiscard]] const std::string& file() const;
  /// The study's text, for reading it again.
  [[nodiscard]] std::string study_text() const;
  /// Everything on which its rows depend, as JSON; stored_study() reads it.
  [[nodiscard]] const std::string& resolved_text() const;
  /// Whether its rows are those of this study: false where a card or data file has changed since.
  [[nodiscard]] bool is_of(const Study& study) const;
  /// The version and commit that computed it: "0.1.0 (0123456789ab)".
  [[nodiscard]] const std::string& program() const;
  [[nodiscard]] const std::vector<StoredColumn>& factors() const;
  [[nodiscard]] const std::vector<StoredColumn>& responses() const;
  /// The number of rows of the whole study, done or not.
  [[nodiscard]] std::uint64_t rows() const;
  [[nodiscard]] std::uint64_t rows_done() const;
  [[nodiscard]] std::uint64_t batch_size() const;
  /// Batches not yet done, increasing.
  [[nodiscard]] std::vector<std::uint64_t> missing_batches() const;

  /// Writes all rows of a batch in one transaction. Throws std::invalid_argument for rows that do not belong
  /// to the batch, std::runtime_error if the disk refuses or the batch is there; then nothing is written.
  void write_batch(std::uint64_t batch, std::span<const StoredRow> rows);

  /// Throws std::runtime_error if the file was deleted, renamed or replaced since it was opened, so that
  /// further rows would be lost. write_batch() calls it.
  void check_in_place() const;

  /// A row; absent if it is not done.
  [[nodiscard]] std::optional<StoredRow> row(std::uint64_t number) const;
  /// Calls `visit` for all rows done, by row number. Memory does not grow with their number.
  void visit_rows(const std::function<void(const StoredRow&)>& visit) const;
  /// A column (factor, response, "row" or "error") of all rows done, by row number; NaN for missing values.
  /// Throws std::invalid_argument for another name.
  [[nodiscard]] std::vector<double> column(const std::string& name) const;
  /// The names of the materials, to which the numbers in the column "pad.material" refer.
  [[nodiscard]] std::vector<std::string> materials() const;

  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

 private:
  struct File;
  std::unique_ptr<File> file_;
  explicit Store(std::unique_ptr<File> file);
};

/// A column as files have it: SI, but accelerations in g.
struct ExportedColumn {
  std::string name;                     ///< name with unit: "peak_force_N", "impactor.speed_m_per_s"
  std::string unit;                     ///< "" for a material
  double scale = 1;                     ///< factor on the values of the store
  std::vector<std::string> names = {};  ///< of the materials, whose numbers the store has
};
ExportedColumn exported(const StoredColumn& column);

/// Writes the rows done as CSV, in pieces so that memory does not grow: a heading, then a line per row by row
/// number. Columns: row, status, extrapolated, extrapolated_strain, extrapolated_rate and bottomed (0 or 1),
/// error, factors, responses; the heading has units: "impactor.speed_m_per_s". Numbers read back exactly,
/// except accelerations, which the store has in m/s2; materials have their names; missing values are empty.
/// Passes exceptions of `write`.
void export_csv(const Store& store, const std::function<void(std::string_view)>& write);

}  // namespace dashpad::study
