#include "output/layout.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <utility>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Whether the text is one number, perhaps with an exponent, a deviation or a unit of one word.
bool is_number(const std::string& text) {
  constexpr std::size_t longest = 100;
  static const std::regex number{
      "(?:[<>~+ -]|≤|≥|≈|±|−)*\\.?[0-9][0-9.,]*(?:[eE][-+]?[0-9]+)? *"
      "(?:±.*|(?:1/)?[^ 0-9][^ ]* *)?"};
  return text.size() <= longest && std::regex_match(text, number);
}

bool is_none(const std::string& cell) {
  return cell.empty() || cell == "-" || cell == "–" || cell == "none" || cell == "n/a";
}

}  // namespace

bool is_number_or_none(const std::string& cell) { return is_none(cell) || is_number(cell); }

bool is_column_of_numbers(const Table& table, std::size_t column) {
  bool has_number = false;
  for (const auto& row : table.rows) {
    if (column >= row.size()) continue;
    if (!is_number_or_none(row[column])) return false;
    has_number = has_number || is_number(row[column]);
  }
  return has_number;
}

std::string shown_value(const ValueRow& row) { return with_unit(row.value, row.unit); }

std::string shown_error(double error) { return error < 1e-6 ? "< 0.0001 %" : percentage(error); }

std::string words_beside(const ValueRow& row) {
  std::string text = row.interval.empty() ? "" : row.interval + " at 95 %";
  // Colour and sign already say what the comparison with the limit comes to.
  const std::string& last = row.limit.empty() ? row.remark : row.limit;
  return text + (text.empty() || last.empty() ? "" : "; ") + last;
}

Table table_of(const RowGroup& group) {
  const std::vector<ValueRow>& rows = group.rows;
  using Cell = std::string (*)(const ValueRow&);
  const std::array<std::pair<const char*, Cell>, 4> optional{{
      {"95 % interval", [](const ValueRow& row) { return row.interval; }},
      {group.error,
       [](const ValueRow& row) { return row.error ? "± " + shown_error(*row.error) : std::string{}; }},
      {"Limit", [](const ValueRow& row) { return row.limit; }},
      {"Remark", [](const ValueRow& row) { return row.remark; }},
  }};
  Table table{.caption = group.caption, .columns = {"Figure", "Value"}};
  for (const ValueRow& row : rows) table.rows.push_back({row.label, shown_value(row)});
  for (const auto& [title, cell] : optional) {
    if (std::ranges::all_of(rows, &std::string::empty, cell)) continue;
    table.columns.emplace_back(title);
    for (std::size_t i = 0; i < rows.size(); ++i) table.rows[i].push_back(cell(rows[i]));
  }
  return table;
}

std::vector<Table> tables_of(const Section& section) {
  std::vector<Table> tables;
  for (const RowGroup& group : section.rows) tables.push_back(table_of(group));
  tables.insert(tables.end(), section.tables.begin(), section.tables.end());
  for (Table& table : tables)
    if (table.caption == section.heading) table.caption.clear();  // it stands above already
  return tables;
}

Table captioned(std::string caption, Table table) {
  table.caption = std::move(caption);
  return table;
}

Plot untitled(Plot plot) {
  plot.title.clear();
  plot.source.clear();
  return plot;
}

std::vector<std::string> by_severity(std::vector<Flag> flags) {
  const auto severity = [](const Flag& flag) {
    return largest_effect(flag) > 0 ? std::min(severity_of(flag.name), Severity::doubtful)
                                    : severity_of(flag.name);
  };
  std::ranges::stable_sort(flags, {}, severity);
  std::vector<std::string> texts;
  for (const Flag& flag : flags) texts.push_back(one_line(flag.text));
  return texts;
}

std::size_t capitals_in_front(std::string_view text) {
  const auto is_capital = [](char c) { return (c >= 'A' && c <= 'Z') || c == ' '; };
  auto end = static_cast<std::size_t>(std::ranges::find_if_not(text, is_capital) - text.begin());
  while (end > 0 && text[end - 1] == ' ') --end;
  return end < 2 ? 0 : end;
}

bool is_seen(const Section& section, Detail detail) {
  switch (section.seen) {
    case Seen::always: return true;
    case Seen::in_brief: return detail == Detail::main;
    case Seen::in_full: return detail == Detail::all;
    case Seen::on_pages: break;
  }
  return false;
}

}  // namespace dashpad::output
