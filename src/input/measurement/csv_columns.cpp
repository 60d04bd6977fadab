// The columns that a header names, with their units.

#include "input/measurement/csv_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

/// The unit in a field without a name: "ms", "[ms]", "(g)".
std::optional<std::string> lone_unit(const std::string& field) {
  const auto [name, unit] = split_header(field);
  if (name.empty() && !unit.empty()) return unit;
  return is_customary_unit(field) ? std::optional{field} : std::nullopt;
}

/// The unit of a column in a row of units; there it need not be customary.
std::string unit_in_row(const std::string& field) {
  return lone_unit(field).value_or(is_known_unit(field) ? field : "");
}

bool is_row_of_units(const CsvHeader::Row& row) {
  bool any = false;
  for (const std::string& field : row.fields) {
    const bool is_unit = lone_unit(field).has_value();
    any = any || is_unit;
    if (!is_unit && !field.empty() && field != "-" && field.size() > 12) return false;
    if (!is_unit && looks_like(ColumnKind::time, injury::MeasuredColumn{.name = field})) return false;
  }
  return any && (row.fields.front().empty() || !unit_in_row(row.fields.front()).empty());
}

/// The most telling row: with most columns known, then with fewest numbers, then the last one.
const CsvHeader::Row* row_of_names(const CsvHeader& header) {
  const CsvHeader::Row* best = nullptr;
  std::pair<int, std::ptrdiff_t> highest;
  for (const CsvHeader::Row& row : header.rows) {
    if (row.fields.size() < std::min<std::size_t>(header.width, 2) || is_row_of_units(row)) continue;
    const std::pair own{known_names(row), -std::ranges::count_if(row.fields, reads_as_number)};
    if (best == nullptr || own >= highest) {
      best = &row;
      highest = own;
    }
  }
  return best;
}

}  // namespace

int known_names(const CsvHeader::Row& row) {
  int known = 0;
  for (const std::string& field : row.fields) {
    const auto [name, unit] = split_header(field);
    const injury::MeasuredColumn column{.name = field, .unit = unit};
    known += looks_like(ColumnKind::time, column) || looks_like(ColumnKind::acceleration, column) ? 1 : 0;
  }
  return known;
}

void add_fault(const CsvRow& row, const injury::MeasuredColumn& column, std::string rule,
               MeasurementFaults& faults) {
  faults.add(row.line, column.name, field_in(row, column), std::move(rule));
}

std::optional<double> number_in(const CsvRow& row, const injury::MeasuredColumn& column,
                                MeasurementFaults& faults) {
  const ReadNumber read = read_csv_number(field_in(row, column));
  if (read.kind == NumberKind::number) return read.value * column.factor;
  add_fault(row, column, rule_for(read.kind), faults);
  return std::nullopt;
}

void require_no_numbers(const CsvHeader& header, const CsvHeader::Row* names,
                        const std::vector<injury::MeasuredColumn>& chosen, MeasurementFaults& faults,
                        std::size_t first) {
  const auto kind_in = [](const CsvHeader::Row& row, const injury::MeasuredColumn& column) {
    return read_csv_number(field_in(row, column)).kind;
  };
  const auto holds_any = [&](const CsvHeader::Row& row) {
    return std::any_of(chosen.begin() + static_cast<std::ptrdiff_t>(first), chosen.end(),
                       [&](const auto& column) { return kind_in(row, column) == NumberKind::number; });
  };
  const auto is_count = [&](const CsvHeader::Row& row) {
    return row.fields.size() == 1 && header.width > 1 &&
           row.fields.front().find_first_not_of("0123456789") == std::string::npos;
  };
  auto begin = header.rows.begin();
  for (auto row = begin; row != header.rows.end(); ++row)
    if (names != nullptr ? row->line <= names->line : is_count(*row) || !holds_any(*row)) begin = row + 1;
  for (auto row = begin; row != header.rows.end(); ++row) {
    if (!holds_any(*row)) continue;
    for (const injury::MeasuredColumn& column : chosen)
      if (const NumberKind kind = kind_in(*row, column); kind != NumberKind::number)
        faults.add(row->line, column.name, field_in(*row, column), rule_for(kind));
  }
}

CsvColumns name_columns(const CsvHeader& header, const std::optional<LabViewHeader>& labview) {
  CsvColumns columns;
  columns.names = row_of_names(header);
  const std::size_t named_columns = columns.names != nullptr ? columns.names->fields.size() : 0;
  std::vector<const CsvHeader::Row*> unit_rows;
  for (const CsvHeader::Row& row : header.rows)
    if (is_row_of_units(row)) unit_rows.push_back(&row);
  // Names beyond the fields of the first row name nothing.
  const std::size_t count = std::max(header.width, std::min(named_columns, header.first_row.size()));
  for (std::size_t i = 0; i < count; ++i) {
    injury::MeasuredColumn column{.name = fmt::format("column {}", i + 1), .number = static_cast<int>(i + 1)};
    if (i < named_columns && !columns.names->fields[i].empty()) {
      column.unit = split_header(columns.names->fields[i]).unit;
      column.name = quoted_part(columns.names->fields[i], longest_column_name);
    }
    for (const CsvHeader::Row* row : unit_rows)
      if (i < row->fields.size() && !is_known_unit(column.unit))  // "Acc (head)" has none
        if (const std::string unit = unit_in_row(row->fields[i]); !unit.empty()) column.unit = unit;
    if (labview && i < labview->columns.size() && !labview->columns[i].unit.empty())
      column.unit = labview->columns[i].unit;
    columns.all.push_back(std::move(column));
  }
  return columns;
}

CsvColumns named_columns(const CsvHeader& header, const std::string& what, MeasurementFaults& faults) {
  CsvColumns columns = name_columns(header);
  if (columns.names == nullptr)
    faults.refuse(header.first_line, "", "", "needs a header line that names the columns" + what);
  return columns;
}

}  // namespace dashpad::input
