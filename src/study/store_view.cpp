// The view `results` of a store: the columns of the CSV export for readers of plain SQL. It takes no room but
// that of its text, and is computed when it is read.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/model/pad/material.hpp"
#include "study/store_file.hpp"

namespace dashpad::study {

namespace {

std::string value_of(const StoredColumn& column, double scale) {
  const std::string stored = "samples." + sql_name(column.name);
  if (column.name == "pad.material") return "(SELECT name FROM materials WHERE number = " + stored + ")";
  // Of a factor with 17 digits the last bit would depend on the version of SQLite.
  return scale == 1 ? stored : fmt::format("{} * (1 / {})", stored, 1 / scale);
}

/// The flags of a row in the words of results: "EXTRAPOLATED RATE, BOTTOMED".
std::string flags_of_row() {
  std::string words;
  for (const auto& [kinds, name] : {std::pair{+extrapolated_strain, name_of(Beyond::strain)},
                                    {+extrapolated_rate, name_of(Beyond::rate)},
                                    {extrapolated_untold | extrapolated_otherwise, name_of(Beyond::other)}})
    words += fmt::format("CASE WHEN samples.extrapolated & {} THEN ', {}' ELSE '' END || ", kinds, name);
  return "substr(" + words + "CASE WHEN samples.bottomed THEN ', BOTTOMED' ELSE '' END, 3)";
}

/// Joins the texts of a label, one a row of the study's table, each of which has as many rows of the store.
std::string join_of_label(std::size_t number, std::size_t texts) {
  return fmt::format(
      " LEFT JOIN (SELECT each.key AS place, each.value AS text FROM study, "
      "json_each(study.value, '$.labels[{0}][1]') AS each WHERE study.key = 'resolved') AS label_{0} "
      "ON label_{0}.place = samples.row / ((SELECT value FROM study WHERE key = 'rows') / {1})",
      number, texts);
}

}  // namespace

std::string results_view(const StoreHeading& heading, const std::vector<RowLabel>& labels) {
  std::string columns = "samples.row, samples.status, samples.extrapolated <> 0 AS extrapolated";
  for (const auto& [kind, name] :
       {std::pair{+extrapolated_strain, "extrapolated_strain"}, {+extrapolated_rate, "extrapolated_rate"}})
    columns += fmt::format(", (samples.extrapolated & {}) <> 0 AS {}", kind, name);
  columns += ", samples.bottomed, samples.error";
  for (const auto* list : {&heading.factors, &heading.responses})
    for (const StoredColumn& column : *list) {
      const ExportedColumn shown = exported(column);
      columns += fmt::format(", {} AS {}", value_of(column, shown.scale), sql_name(shown.name));
    }
  std::string joins;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    columns += fmt::format(", label_{}.text AS {}", i, sql_name(labels[i].name));
    joins += join_of_label(i, labels[i].texts.size());
  }
  return fmt::format("CREATE VIEW IF NOT EXISTS results AS SELECT {}, {} AS flags FROM samples{}", columns,
                     flags_of_row(), joins);
}

}  // namespace dashpad::study
