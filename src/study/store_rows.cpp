// Reading rows back.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "study/store_file.hpp"

namespace dashpad::study {

namespace {

std::string row_query(const StoreHeading& heading) {
  return "SELECT row, status, extrapolated, bottomed, error" + value_columns(heading) + " FROM samples";
}

Status status_of(const std::string& name, const Database& database) {
  for (const Status status : {Status::released, Status::bottomed_out, Status::time_limit,
                              Status::tolerance_not_met, Status::not_run})
    if (to_string(status) == name) return status;
  database.damaged("a status that there is not");
}

void read_row(const Statement& from, const Database& database, const StoreHeading& heading, StoredRow& row) {
  row.row = from.count(0, heading.rows - 1);
  row.outcome.status = status_of(from.text(1), database);
  row.outcome.extrapolated = from.count(2, 1) == 1;
  row.outcome.bottomed = from.count(3, 1) == 1;
  row.outcome.error = from.number(4);
  row.factors.resize(heading.factors.size());
  row.outcome.values.resize(heading.responses.size());
  int place = 5;
  for (auto* values : {&row.factors, &row.outcome.values})
    for (double& value : *values) value = from.number(place++);
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
  while (query.next()) values.push_back(query.number(0));
  return values;
}

}  // namespace dashpad::study
