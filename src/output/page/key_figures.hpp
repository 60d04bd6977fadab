#pragma once
/// The figures of a lead, from the rows of a result.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/output/page/figures_page.hpp"
#include "output/result_rows.hpp"

namespace dashpad::output {

/// More are no longer the few that matter.
inline constexpr std::size_t most_key_figures = 6;

/// "76.3 g".
inline std::string shown_value(const ResultRow& row) {
  return row.unit.empty() ? row.value : row.value + " " + row.unit;
}

/// The first rows.
inline std::vector<KeyFigure> key_figures(const std::vector<ResultRow>& rows) {
  std::vector<KeyFigure> figures;
  for (const ResultRow& row : rows)
    if (figures.size() < most_key_figures)
      figures.push_back({.label = row.label, .value = shown_value(row), .limit = row.remark});
  return figures;
}

/// The first of the reservations, and how many there are below; empty without any.
inline std::string first_of(const std::vector<std::string>& reservations) {
  if (reservations.empty()) return "";
  const std::size_t others = reservations.size() - 1;
  return reservations.front() + (others == 0 ? "" : " (and " + std::to_string(others) + " more below)");
}

}  // namespace dashpad::output
