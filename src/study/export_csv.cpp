#include "dashpad/study/export_csv.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace dashpad::study {

namespace {

std::string heading(const StoredColumn& column) {
  return column.unit.empty() || column.unit == "1" ? column.name : column.name + " (" + column.unit + ")";
}

void append(fmt::memory_buffer& text, const StoredRow& row) {
  const Outcome& outcome = row.outcome;
  fmt::format_to(std::back_inserter(text), "{},{},{:d},{:d},", row.row, to_string(outcome.status),
                 outcome.extrapolated, outcome.bottomed);
  if (!std::isnan(outcome.error)) fmt::format_to(std::back_inserter(text), "{}", outcome.error);
  for (const auto* values : {&row.factors, &outcome.values})
    for (const double value : *values) {
      text.push_back(',');
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
  text.push_back('\n');
}

}  // namespace

void export_csv(const Store& store, const std::function<void(std::string_view)>& write) {
  constexpr std::size_t piece = 1 << 16;
  std::string names = "row,status,extrapolated,bottomed,error";
  for (const auto* list : {&store.factors(), &store.responses()})
    for (const StoredColumn& column : *list) names += "," + heading(column);
  write(names + "\n");
  fmt::memory_buffer text;
  store.visit_rows([&](const StoredRow& row) {
    append(text, row);
    if (text.size() < piece) return;
    write({text.data(), text.size()});
    text.clear();
  });
  write({text.data(), text.size()});
}

}  // namespace dashpad::study
