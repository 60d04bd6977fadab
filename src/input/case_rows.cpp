#include "input/case_rows.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/measurement_text.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

/// A header as a key and the unit behind it.
struct Header {
  const RowKey* key = nullptr;  ///< null for a label, or after a fault
  std::string text;
  std::string unit;  ///< of the header; empty if the cells have theirs
};

/// The unit that follows a key: " [mph]", ", mph", "_m_per_s".
std::string unit_behind(std::string_view rest) {
  rest = without_blanks(rest);
  if (rest.starts_with('_')) {
    std::string unit(rest.substr(1));
    for (auto at = unit.find("_per_"); at != std::string::npos; at = unit.find("_per_"))
      unit.replace(at, 5, "/");
    return unit.starts_with("per_") ? "1/" + unit.substr(4) : unit;
  }
  if (rest.starts_with(',') || rest.starts_with('/')) rest.remove_prefix(1);
  rest = without_blanks(rest);
  if ((rest.starts_with('[') && rest.ends_with(']')) || (rest.starts_with('(') && rest.ends_with(')')))
    rest = without_blanks(rest.substr(1, rest.size() - 2));
  return std::string(rest);
}

/// The longest key that the text begins with, up to a character that no key continues with.
const RowKey* key_in(std::string_view text, std::span<const RowKey> keys) {
  const RowKey* found = nullptr;
  for (const RowKey& each : keys) {
    if (!text.starts_with(each.key) || (found && found->key.size() > each.key.size())) continue;
    const char next = text.size() > each.key.size() ? text[each.key.size()] : ' ';
    if (const std::string_view rest = without_blanks(text.substr(each.key.size()));
        each.is_whole && !rest.empty()) {
      const bool has_unit = each.unit != "1" && !each.unit.empty();
      if (rest.front() != '[' && rest.front() != '(' &&
          !(has_unit && (rest.front() == ',' || rest.front() == '_' || rest.front() == '/')))
        continue;
    }
    if (!std::isalnum(static_cast<unsigned char>(next)) && next != '.') found = &each;
  }
  return found;
}

/// Whether a header begins like a key, with the name of a table of cases, in capitals or not.
bool begins_like_key(std::string_view text) {
  constexpr std::string_view tables[]{"impactor.", "pad.", "support.", "blows.", "solver.", "foam."};
  const std::string lower = lower_case(text);
  return std::ranges::any_of(tables, [&](std::string_view table) { return lower.starts_with(table); });
}

/// A unit as read_si() knows it: of an acceleration, g is gravity and no gram.
std::string known_unit(std::string unit, const std::string& si_unit) {
  if (si_unit == "m/s2" && unit == "g") return "gravity";
  return unit;
}

/// The value of a cell in SI, or the rule that it breaks.
SiValue value_of(std::string_view cell, const Header& header) {
  const std::string& unit = header.key->unit;
  const ReadNumber number = read_csv_number(cell);
  if (number.kind != NumberKind::number)
    return number.kind == NumberKind::text
               ? read_stated(cell.ends_with(" g") && unit == "m/s2"
                                 ? std::string(cell.substr(0, cell.size() - 1)) + "gravity"
                                 : std::string(cell),
                             unit)
               : SiValue{0, rule_for(number.kind)};
  if (!header.unit.empty()) return read_stated(fmt::format("{} {}", number.value, header.unit), unit);
  if (unit == "1") return read_stated(fmt::format("{}", number.value), unit);
  return {0, fmt::format("needs a unit, here or in the header: {} [{}]", header.key->key,
                         examples_of_units(unit).substr(0, examples_of_units(unit).find(',')))};
}

class RowReader {
 public:
  RowReader(std::span<const RowKey> keys, const std::function<std::string(const std::string&)>& unknown,
            MeasurementFaults& faults)
      : keys_(keys), unknown_(unknown), faults_(faults) {}

  void read_headers(const CsvRow& row) {
    rows_.header_line = static_cast<int>(row.line);
    for (const std::string_view field : row.fields) {
      Header header;
      header.text = to_utf8(without_blanks(field));
      header.key = key_in(header.text, keys_);
      if (header.key != nullptr)
        read_key(row, header);
      else if (begins_like_key(header.text))
        faults_.add(row.line, header.text, "",
                    unknown_(header.text.substr(0, header.text.find_first_of(" [(,"))));
      RowColumn& column = (header.key ? rows_.columns : rows_.labels).emplace_back();
      column.key = header.key ? header.key->key : header.text;
      if (header.key) column.unit = header.key->unit;
      headers_.push_back(std::move(header));
    }
    if (rows_.columns.empty() && faults_.none())
      faults_.refuse(
          row.line, "", "",
          fmt::format("has no column that is known: the first line must have names such as {} [{}]",
                      keys_.front().key, keys_.front().unit));
  }

  void read_row(const CsvRow& row) {
    if (!row.fault.empty()) return faults_.add(row.line, "", "", std::string(row.fault));
    if (row.filled() > headers_.size()) faults_.add(row.line, "", "", "has more fields than the header");
    if (rows_.lines.size() == max_case_rows)
      faults_.refuse(row.line, "", "", fmt::format("the table has more than {} rows", max_case_rows));
    rows_.lines.push_back(static_cast<int>(row.line));
    std::size_t key = 0, label = 0;
    for (std::size_t i = 0; i < headers_.size(); ++i) {
      const std::string_view cell =
          i < row.fields.size() ? without_blanks(row.fields[i]) : std::string_view();
      if (headers_[i].key == nullptr)
        rows_.labels[label++].texts.push_back(to_utf8(cell));
      else
        read_cell(row, headers_[i], cell, rows_.columns[key++]);
    }
  }

  CaseRows take() && { return std::move(rows_); }

 private:
  void read_key(const CsvRow& row, Header& header) {
    const std::string& key = header.key->key;
    if (std::ranges::any_of(rows_.columns, [&](const RowColumn& column) { return column.key == key; }))
      faults_.add(row.line, header.text, "", fmt::format("{} has two columns", key));
    header.unit = known_unit(unit_behind(std::string_view(header.text).substr(key.size())), header.key->unit);
    if (header.unit.empty()) return;
    if (header.key->unit.empty())
      faults_.add(row.line, header.text, "", fmt::format("{} is a name and has no unit", key));
    else if (const SiValue one = read_si("1 " + header.unit, header.key->unit); !one.rule.empty())
      faults_.add(row.line, header.text, "", one.rule);
  }

  void read_cell(const CsvRow& row, const Header& header, std::string_view cell, RowColumn& into) {
    if (cell.empty() && !header.key->may_be_empty) return faults_.add(row.line, header.text, "", "is empty");
    if (cell.empty() && !header.key->unit.empty()) {
      into.values.push_back(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    if (header.key->unit.empty()) {
      into.texts.push_back(to_utf8(cell));
      return;
    }
    const SiValue read = value_of(cell, header);
    if (!read.rule.empty()) faults_.add(row.line, header.text, cell, read.rule);
    into.values.push_back(read.value);
  }

  std::span<const RowKey> keys_;
  const std::function<std::string(const std::string&)>& unknown_;
  MeasurementFaults& faults_;
  std::vector<Header> headers_;
  CaseRows rows_;
};

}  // namespace

Reading<CaseRows> read_case_rows(const std::filesystem::path& file, std::span<const RowKey> keys,
                                 const std::function<std::string(const std::string& key)>& unknown) {
  return reading_of([&]() -> CaseRows {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const std::string_view text = text_in(content, faults);
    CsvRows rows(text, header_separator(text));
    CsvRow row;
    if (!rows.next(row)) faults.refuse(0, "", "", "is empty");
    RowReader reader(keys, unknown, faults);
    reader.read_headers(row);
    faults.throw_if_any();
    while (rows.next(row)) reader.read_row(row);
    faults.throw_if_any();
    CaseRows read = std::move(reader).take();
    if (read.lines.empty()) faults.refuse(row.line, "", "", "has a header, but no rows");
    return read;
  });
}

}  // namespace dashpad::input
