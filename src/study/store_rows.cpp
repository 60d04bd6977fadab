// Reading rows back.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "study/store_file.hpp"

namespace dashpad::study {

namespace {

std::string row_query(const StoreHeading& heading) {
  return "SELECT row, status, extrapolated, bottomed, error" + value_columns(heading) + " FROM samples";
}

Status status_of(const std::string& name, const Database& database) {
  for (const Status status : {Status::released, Status::bottomed_out, Status::time_limit,
                              Status::tolerance_not_met, Status::at_rest, Status::not_run})
    if (to_string(status) == name) return status;
  database.damaged("a status that there is not");
}

/// All kinds at once.
constexpr std::uint64_t most_extrapolated =
    extrapolated_untold + extrapolated_strain + extrapolated_rate + extrapolated_otherwise;

[[noreturn]] void impossible(const Database& database, const std::string& column, double value) {
  database.damaged(fmt::format("{} = {} in a row, which cannot be", column,
                               std::isnan(value) ? "none" : fmt::format("{}", value)));
}

void read_row(const Statement& from, const Database& database, const StoreHeading& heading, StoredRow& row) {
  row.row = from.count(0, heading.rows - 1);
  row.outcome.status = status_of(from.text(1), database);
  row.outcome.extrapolated = static_cast<unsigned>(from.count(2, most_extrapolated));
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

}  // namespace

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

}  // namespace dashpad::study
