#pragma once
/// The figures of a lead, from the rows of a result.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/output/page/figures_page.hpp"
#include "output/result_rows.hpp"
#include "quantities/text.hpp"

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
      figures.push_back(
          {.label = row.label,
           .value = shown_value(row),
           .limit = row.interval + (row.interval.empty() || row.remark.empty() ? "" : "; ") + row.remark});
  return figures;
}

/// The speed that was left when the pad bottomed out, beside that of the impact; none if it did not.
inline std::vector<KeyFigure> bottoming_figures(const ImpactCase& impact, const Summary& summary,
                                                const UnitSystem& units) {
  if (!summary.bottomed) return {};
  const auto shown = [&](double value, const char* unit) { return brief_quantity(value, unit, units, 3); };
  return {{.label = "Speed when the pad bottomed",
           .value = shown(summary.bottomed->velocity, "m/s"),
           .limit = "after " + shown(summary.bottomed->time, "s")},
          {.label = "Impact speed", .value = shown(impact.impactor.speed, "m/s")}};
}

/// The first of the reservations, and how many there are below; empty without any.
inline std::string first_of(const std::vector<std::string>& reservations) {
  if (reservations.empty()) return "";
  const std::size_t others = reservations.size() - 1;
  return reservations.front() + (others == 0 ? "" : " (and " + std::to_string(others) + " more below)");
}

}  // namespace dashpad::output
