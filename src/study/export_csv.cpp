#include "dashpad/study/store.hpp"

#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "dashpad/result/result_quantity.hpp"

namespace dashpad::study {

ExportedColumn exported(const StoredColumn& column) {
  const auto [scale, unit] = scaled_unit(column.unit, plain_si());
  return {name_with_unit(column.name, unit), column.unit.empty() ? "" : unit, scale};
}

namespace {

void append(fmt::memory_buffer& text, const StoredRow& row, const std::vector<ExportedColumn>& columns) {
  const Outcome& outcome = row.outcome;
  fmt::format_to(std::back_inserter(text), "{},{},{:d},{:d},{:d},{:d},", row.row, to_string(outcome.status),
                 outcome.extrapolated != 0, (outcome.extrapolated & extrapolated_strain) != 0,
                 (outcome.extrapolated & extrapolated_rate) != 0, outcome.bottomed);
  if (!std::isnan(outcome.error)) fmt::format_to(std::back_inserter(text), "{}", outcome.error);
  auto column = columns.begin();
  for (const auto* values : {&row.factors, &outcome.values})
    for (const double value : *values) {
      text.push_back(',');
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", column->scale * value);
      ++column;
    }
  text.push_back('\n');
}

}  // namespace

void export_csv(const Store& store, const std::function<void(std::string_view)>& write) {
  constexpr std::size_t piece = 1 << 16;
  std::string names = "row,status,extrapolated,extrapolated_strain,extrapolated_rate,bottomed,error";
  std::vector<ExportedColumn> columns;
  for (const auto* list : {&store.factors(), &store.responses()})
    for (const StoredColumn& column : *list) {
      columns.push_back(exported(column));
      names += "," + columns.back().name;
    }
  write(names + "\n");
  fmt::memory_buffer text;
  store.visit_rows([&](const StoredRow& row) {
    append(text, row, columns);
    if (text.size() < piece) return;
    write({text.data(), text.size()});
    text.clear();
  });
  write({text.data(), text.size()});
}

}  // namespace dashpad::study
