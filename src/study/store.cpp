#include "dashpad/study/store.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "dashpad/result/result_quantity.hpp"
#include "dashpad/study/study_file.hpp"
#include "quantities/text.hpp"
#include "study/store_file.hpp"

namespace dashpad::study {

ExportedColumn exported(const StoredColumn& column) {
  const auto [scale, unit] = scaled_unit(column.unit, plain_si());
  return {name_with_unit(column.name, unit), column.unit.empty() ? "" : unit, scale};
}

namespace {

void check_rows(std::uint64_t batch, std::span<const StoredRow> rows, const StoreHeading& heading) {
  std::uint64_t expected = batch * heading.batch_size;
  for (const StoredRow& row : rows) {
    if (row.row != expected++)
      throw std::invalid_argument(fmt::format("row {} does not belong to its batch", row.row));
    if (row.factors.size() != heading.factors.size() || row.outcome.values.size() != heading.responses.size())
      throw std::invalid_argument(fmt::format("row {} does not have the store's columns", row.row));
  }
}

const std::string& lasting_name(Status status) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Status each : all_statuses) all.push_back(to_string(each));
    return all;
  }();
  return names.at(static_cast<std::size_t>(status));
}

/// Writes the log back while a nearly full disk has room for its content twice.
void keep_room(Database& database, const StoreHeading& heading) {
  std::error_code none;
  const std::filesystem::path log = database.log();
  const std::uintmax_t written = std::filesystem::file_size(log, none);
  if (none) return;  // there is no log to write back
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

std::string row_query(const StoreHeading& heading) {
  return "SELECT row, status, extrapolated, bottomed, error" + value_columns(heading, "samples.") +
         " FROM samples";
}

Status status_of(const std::string& name, const Database& database) {
  for (const Status status : all_statuses)
    if (to_string(status) == name) return status;
  database.damaged("unknown status");
}

/// The sum of all kinds.
constexpr std::uint64_t max_extrapolated =
    extrapolated_untold + extrapolated_strain + extrapolated_rate + extrapolated_otherwise;

[[noreturn]] void impossible(const Database& database, const std::string& column, double value) {
  database.damaged(fmt::format("{} = {} in a row, which is impossible", column,
                               std::isnan(value) ? "none" : fmt::format("{}", value)));
}

void read_row(const Statement& from, const Database& database, const StoreHeading& heading, StoredRow& row) {
  row.row = from.count(0, heading.rows - 1);
  row.outcome.status = status_of(from.text(1), database);
  row.outcome.extrapolated = static_cast<unsigned>(from.count(2, max_extrapolated));
  row.outcome.bottomed = from.count(3, 1) == 1;
  row.outcome.error = from.number(4);
  if (!(row.outcome.error >= 0)) impossible(database, "error", row.outcome.error);
  row.factors.resize(heading.factors.size());
  row.outcome.values.resize(heading.responses.size());
  int place = 5;
  for (std::size_t i = 0; i < row.factors.size(); ++i) {
    const double value = row.factors[i] = from.number(place++);
    if (!std::isfinite(value)) impossible(database, heading.factors[i].name, value);
  }
  for (std::size_t i = 0; i < row.outcome.values.size(); ++i) {
    const double value = row.outcome.values[i] = from.number(place++);
    const ResultQuantity* kind = find_response_kind(heading.responses[i].name);
    const bool possible = kind == nullptr ? std::isfinite(value) : is_possible(*kind, value);
    if (!std::isnan(value) && !possible) impossible(database, heading.responses[i].name, value);
  }
}

bool has_column(const StoreHeading& heading, const std::string& name) {
  if (name == "row" || name == "error") return true;
  for (const auto* list : {&heading.factors, &heading.responses})
    if (std::any_of(list->begin(), list->end(), [&](const auto& column) { return column.name == name; }))
      return true;
  return false;
}

void append(fmt::memory_buffer& text, const StoredRow& row, const std::vector<ExportedColumn>& columns,
            const std::vector<RowLabel>& labels, std::uint64_t rows_of_label) {
  const Outcome& outcome = row.outcome;
  fmt::format_to(std::back_inserter(text), "{},{},{:d},{:d},{:d},{:d},", row.row, to_string(outcome.status),
                 outcome.extrapolated != 0, (outcome.extrapolated & extrapolated_strain) != 0,
                 (outcome.extrapolated & extrapolated_rate) != 0, outcome.bottomed);
  if (!std::isnan(outcome.error)) fmt::format_to(std::back_inserter(text), "{}", outcome.error);
  auto column = columns.begin();
  for (const auto* values : {&row.factors, &outcome.values})
    for (const double value : *values) {
      text.push_back(',');
      if (const auto& names = column->names; value >= 0 && value < static_cast<double>(names.size()))
        text.append(csv_field(names[static_cast<std::size_t>(value)]));
      else if (!std::isnan(value))
        fmt::format_to(std::back_inserter(text), "{}", column->scale * value);
      ++column;
    }
  for (const RowLabel& label : labels)
    fmt::format_to(std::back_inserter(text), ",{}", csv_field(label.texts[row.row / rows_of_label]));
  text.push_back('\n');
}

}  // namespace

Store::Store(std::unique_ptr<File> file) : file_(std::move(file)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

/// Turns a written store into one plain file, readable in a read-only folder. If that fails (full disk, a
/// reader), the log stays beside the file and nothing is lost.
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
    throw std::runtime_error(file_->database.name() +
                             ": the file was deleted, renamed or replaced during the study, and its rows are "
                             "missing; repeat the command, and leave the file alone until it ends");
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
  if (!file_->insert_row) throw std::invalid_argument("the store is open for reading only");
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
  file_->insert_batch->run_with(static_cast<std::int64_t>(batch), static_cast<std::int64_t>(rows.size()));
  transaction.commit();
  file_->rows_done += rows.size();
}

std::optional<StoredRow> Store::row(std::uint64_t number) const {
  if (number >= file_->heading.rows) return std::nullopt;
  Statement query{file_->database, row_query(file_->heading) + " WHERE row = ?"};
  if (!query.bind(0, static_cast<std::int64_t>(number)).next()) return std::nullopt;
  StoredRow row;
  read_row(query, file_->database, file_->heading, row);
  return row;
}

void Store::visit_rows(const std::function<void(const StoredRow&)>& visit) const {
  Statement query{file_->database, row_query(file_->heading) + " ORDER BY row"};
  StoredRow row;
  while (query.next()) {
    read_row(query, file_->database, file_->heading, row);
    visit(row);
  }
}

std::vector<double> Store::column(const std::string& name) const {
  if (!has_column(file_->heading, name)) throw std::invalid_argument("no column \"" + name + "\"");
  Statement query{file_->database, "SELECT samples." + sql_name(name) + " FROM samples ORDER BY row"};
  std::vector<double> values;
  values.reserve(file_->rows_done);
  const ResultQuantity* kind = find_response_kind(name);
  while (query.next()) {
    values.push_back(query.number(0));
    if (kind != nullptr && !std::isnan(values.back()) && !is_possible(*kind, values.back()))
      impossible(file_->database, name, values.back());
  }
  return values;
}

std::vector<std::string> Store::materials() const {
  Statement query{file_->database, "SELECT name FROM materials ORDER BY number"};
  std::vector<std::string> names;
  while (query.next()) names.push_back(query.name(0));
  return names;
}

void export_csv(const Store& store, const std::function<void(std::string_view)>& write) {
  constexpr std::size_t piece = 1 << 16;
  std::string names = "row,status,extrapolated,extrapolated_strain,extrapolated_rate,bottomed,error";
  std::vector<ExportedColumn> columns;
  for (const auto* list : {&store.factors(), &store.responses()})
    for (const StoredColumn& column : *list) {
      columns.push_back(exported(column));
      if (column.name == "pad.material") columns.back().names = store.materials();
      names += "," + columns.back().name;
    }
  const std::vector<RowLabel> labels = row_labels(store);
  const std::uint64_t rows_of_label = labels.empty() ? 1 : store.rows() / labels.front().texts.size();
  for (const RowLabel& label : labels) names += "," + csv_field(label.name);
  write(names + "\n");
  fmt::memory_buffer text;
  store.visit_rows([&](const StoredRow& row) {
    append(text, row, columns, labels, rows_of_label);
    if (text.size() < piece) return;
    write({text.data(), text.size()});
    text.clear();
  });
  write({text.data(), text.size()});
}

}  // namespace dashpad::study
