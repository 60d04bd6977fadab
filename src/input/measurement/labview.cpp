// Headers of LabVIEW measurement files (.lvm), after NI's "Specification for the LabVIEW Measurement File":
// keys and their values, one for each channel, up to ***End_of_Header***.

#include <algorithm>

#include <fmt/format.h>

#include "input/measurement/csv_table.hpp"

namespace dashpad::input {

namespace {

constexpr std::string_view labview_title = "LabVIEW Measurement", labview_header_end = "***End_of_Header***";

/// The character behind the key, in the line of the first header that begins with "Separator".
char labview_separator(std::string_view text) {
  constexpr std::string_view key = "Separator";
  LineReader lines(text);
  for (std::string_view line; lines.next(line) && !line.starts_with(labview_header_end);)
    if (line.starts_with(key) && line.size() > key.size()) return line[key.size()];
  return '\t';
}

}  // namespace

std::optional<LabViewHeader> labview_header(std::string_view text, MeasurementFaults& faults) {
  if (!text.starts_with(labview_title)) return std::nullopt;
  std::size_t end = 0;
  int headers = 0;  // one of the file, and one of each segment
  for (std::size_t at = text.find(labview_header_end); at != std::string_view::npos;
       at = text.find(labview_header_end, at + 1))
    if (++headers <= 2) end = at + labview_header_end.size();
  if (headers == 0) faults.refuse(1, "", "", fmt::format("has no line {}", labview_header_end));
  if (headers > 2)
    faults.refuse(1, "", "",
                  fmt::format("contains {} measurements; put each in a separate file", headers - 1));
  LabViewHeader header{.separator = labview_separator(text)};
  std::vector<std::string> units, dimensions, first, interval, samples;
  CsvRows rows(text.substr(0, end), header.separator);
  for (CsvRow row; rows.next(row);) {
    if (row.fields.empty()) continue;
    const std::string_view key = without_blanks(row.fields.front());
    const auto values = [&] {
      std::vector<std::string> all;
      for (std::size_t i = 1; i < row.filled(); ++i) all.push_back(to_utf8(without_blanks(row.fields[i])));
      return all;
    };
    if (key == labview_header_end) {
      header.end = row.line;
    } else if (key == "X_Columns") {
      const auto words = values();
      const std::string word = words.empty() ? "" : lower_case(words.front());
      header.x_columns = word == "no"      ? LabViewHeader::XColumns::none
                         : word == "multi" ? LabViewHeader::XColumns::each
                                           : LabViewHeader::XColumns::one;
    } else if (key == "Y_Unit_Label") {
      units = values();
    } else if (key == "X_Dimension") {
      dimensions = values();
    } else if (key == "Samples") {
      samples = values();
    } else if (key == "X0") {
      first = values();
    } else if (key == "Delta_X") {
      interval = values();
    }
  }
  const auto number = [](const std::vector<std::string>& all, std::size_t i) {
    const ReadNumber read = i < all.size() ? read_csv_number(all[i]) : ReadNumber{};
    return read.kind == NumberKind::number ? std::optional{read.value} : std::nullopt;
  };
  const bool has_x = header.x_columns != LabViewHeader::XColumns::none;
  for (std::size_t i = 0; i < std::max({units.size(), interval.size(), samples.size()}); ++i) {
    const bool is_over_time = i >= dimensions.size() || lower_case(dimensions[i]) == "time";
    // A column of X comes first, or before each channel; without, the first column is empty.
    if (header.columns.empty() || header.x_columns == LabViewHeader::XColumns::each)
      header.columns.push_back({.unit = has_x && is_over_time ? "s" : ""});
    header.columns.push_back({i < units.size() ? units[i] : "", number(first, i).value_or(0),
                              is_over_time ? number(interval, i) : std::nullopt, number(samples, i)});
  }
  return header;
}

}  // namespace dashpad::input
