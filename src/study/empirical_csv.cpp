#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/column_units.hpp"
#include "input/measurement/csv_rows.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/spelling.hpp"
#include "study/factor_table.hpp"

namespace dashpad::study {
namespace {

constexpr std::size_t most_values = 1'000'000;

/// That of the header: a semicolon, a tab, or else a comma.
char separator_of(std::string_view text) {
  input::LineReader lines(text);
  std::string_view line;
  while (lines.next(line) &&
         (input::without_blanks(line).empty() || input::without_blanks(line).front() == '#')) {
  }
  for (const char c : {';', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ',';
}

struct Column {
  std::size_t place = 0;
  std::size_t width = 1;  ///< columns of the header
  std::string name;
  double factor = 1;
};

/// One unit of a header in SI.
double unit_factor(const std::string& written, const std::string& unit, const Column& column,
                   std::size_t line, input::MeasurementFaults& faults) {
  if (unit == "1") {
    if (written.empty() || written == "1" || written == "-") return 1;
    faults.add(line, column.name, written, "is a pure number and has no unit");
    return 1;
  }
  try {
    if (!written.empty()) return to_si("1 " + written, unit);
    faults.add(line, column.name, "",
               "the header must give the unit in brackets, such as [" +
                   examples_of_units(unit).substr(0, examples_of_units(unit).find(',')) + "]");
  } catch (const UnitError& error) {
    faults.add(line, column.name, written, error.what());
  }
  return 1;
}

Column choose(const input::CsvRow& header, const std::string& wanted, const std::string& unit,
              input::MeasurementFaults& faults) {
  std::vector<std::string> names, titles;
  for (const std::string_view field : header.fields) {
    titles.push_back(input::to_utf8(input::without_blanks(field)));
    names.push_back(input::split_header(titles.back()).name);
  }
  std::size_t place = 0;
  if (!wanted.empty()) {
    while (place < names.size() && names[place] != wanted && titles[place] != wanted) ++place;
    if (place == names.size())
      faults.refuse(
          header.line, "", wanted,
          "no such column; there are " + input::listing(titles) + input::did_you_mean(wanted, names));
  } else if (header.filled() > 1) {
    faults.refuse(header.line, "", "",
                  "has several columns; name one with column = \"...\": " + input::listing(titles));
  }
  if (input::read_number(titles[place]).kind == input::NumberKind::number)
    faults.refuse(header.line, "", titles[place],
                  "needs a line above the numbers that names the column and its unit");
  Column column{place, header.fields.size(), titles[place], 1};
  column.factor = unit_factor(input::split_header(titles[place]).unit, unit, column, header.line, faults);
  return column;
}

}  // namespace

input::Reading<std::vector<double>> read_empirical(const std::filesystem::path& file,
                                                   const std::string& column, const std::string& unit) {
  return input::reading_of([&]() -> std::vector<double> {
    input::MeasurementFaults faults(file.string());
    const std::string content = input::read_measurement(file);
    const std::string_view text = input::text_in(content, faults);
    const char separator = separator_of(text);
    input::CsvRows rows(text, separator);
    input::CsvRow row;
    if (!rows.next(row)) faults.refuse(0, "", "", "is empty");
    const Column chosen = choose(row, column, unit, faults);
    std::vector<double> values;
    while (rows.next(row)) {
      const bool there = chosen.place < row.fields.size();
      const std::string_view field =
          there ? input::without_blanks(row.fields[chosen.place]) : std::string_view();
      const input::ReadNumber read = input::read_csv_number(field, separator);
      if (!row.fault.empty())
        faults.add(row.line, "", "", std::string(row.fault));
      else if (row.filled() > chosen.width)
        faults.add(row.line, "", "", "has more fields than the header");
      else if (read.kind != input::NumberKind::number)
        faults.add(row.line, chosen.name, field, input::rule_for(read.kind));
      else
        values.push_back(read.value * chosen.factor);
      if (values.size() > most_values)
        faults.refuse(row.line, "", "", fmt::format("has more than {} values", most_values));
    }
    faults.throw_if_any();
    std::ranges::sort(values);
    return values;
  });
}

}  // namespace dashpad::study
