// Compression tests: columns of stress over a column of strain.

#include "dashpad/input/material_deck.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/deck_foam.hpp"
#include "input/measurement/csv_table.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_rows_of_stresses = 10'000;

/// The parts of a header: "stress", "kPa" and "10 1/s" of "stress_kPa @ 10 1/s".
struct StressHeader {
  std::string name, unit, rate;
};

StressHeader taken_apart_at(const std::string& header) {
  StressHeader parts;
  const auto at = header.find('@');
  const std::string quantity(without_blanks(std::string_view(header).substr(0, at)));
  if (at != std::string::npos) parts.rate = without_blanks(std::string_view(header).substr(at + 1));
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
    if (const auto begin = quantity.find(open); begin != std::string::npos && quantity.ends_with(close)) {
      parts.name = without_blanks(std::string_view(quantity).substr(0, begin));
      parts.unit = without_blanks(std::string_view(quantity).substr(begin + 1, quantity.size() - begin - 2));
      return parts;
    }
  const auto mark = quantity.find_first_of("_ ");
  parts.name = quantity.substr(0, mark);
  if (mark != std::string::npos) parts.unit = without_blanks(std::string_view(quantity).substr(mark + 1));
  return parts;
}

struct StressColumn {
  injury::MeasuredColumn of;
  double rate = 0;  ///< 1/s; 0: not stated
};

struct StressColumns {
  injury::MeasuredColumn strain;
  double strains_in_one = 1;  ///< 100 where it is in %
  std::size_t line = 0;       ///< of the header
  std::vector<StressColumn> stresses;
};

/// A rate per second: "10 1/s", "10/s" or "10".
std::optional<double> rate_in(std::string text) {
  const auto end = text.find_first_not_of("0123456789.+-eE ");
  if (end == std::string::npos) text += " 1/s";
  const bool is_alone = text.find(' ') >= end;
  if (end != std::string::npos && text[end] == '/' && is_alone) text.insert(end, " 1");
  const auto [rate, rule] = read_si(text, "1/s");
  return rule.empty() && rate > 0 ? std::optional(rate) : std::nullopt;
}

void add_stress(const injury::MeasuredColumn& column, StressHeader header, std::size_t line,
                StressColumns& columns, MeasurementFaults& faults) {
  StressColumn stress{column};
  if (header.unit.empty()) header.unit = column.unit;
  if (header.unit.empty()) {
    faults.add(line, column.name, "",
               "a stress needs its unit in the header, such as stress_kPa or \"stress [MPa]\"");
  } else {
    const auto [factor, rule] = read_si("1 " + header.unit, "Pa");
    if (!rule.empty()) faults.add(line, column.name, "", rule);
    stress.of.factor = rule.empty() ? factor : 1;
  }
  if (!header.rate.empty()) {
    const auto rate = rate_in(header.rate);
    if (!rate) faults.add(line, column.name, header.rate, "is not a strain rate above 0, such as 10 1/s");
    stress.rate = rate.value_or(0);
  }
  columns.stresses.push_back(std::move(stress));
}

/// Finds the columns. Faults if the header is ambiguous or lacks units.
StressColumns choose_stresses(const CsvHeader& header, MeasurementFaults& faults) {
  const CsvColumns named = named_columns(header, " and their units: strain,stress_kPa", faults);
  StressColumns columns;
  columns.line = named.names->line;
  int strains = 0;
  for (const injury::MeasuredColumn& column : named.all) {
    const StressHeader parts = taken_apart_at(column.name);
    const std::string name = lower_case(parts.name);
    if (name == "strain") {
      ++strains;
      columns.strain = column;
      const auto factor = units_in_strain_one(parts.unit.empty() ? column.unit : parts.unit);
      if (!factor) faults.add(columns.line, column.name, "", "a strain is a pure number, or in %");
      columns.strains_in_one = factor.value_or(1);
    } else if (name == "stress") {
      add_stress(column, parts, columns.line, columns, faults);
    }
  }
  if (strains != 1)
    faults.add(
        columns.line, "", "",
        fmt::format("one column called strain is needed, such as strain or strain_percent; there are {}",
                    strains));
  if (columns.stresses.empty())
    faults.add(columns.line, "", "", "a column called stress is needed, such as stress_kPa; there is none");
  faults.throw_if_any();
  return columns;
}

/// Completes the rates that the header does not state.
void settle_rates_of(StressColumns& columns, std::optional<double> rate, MeasurementFaults& faults) {
  if (columns.stresses.size() == 1) {
    StressColumn& only = columns.stresses.front();
    if (rate && only.rate > 0 && *rate != only.rate)
      faults.add(columns.line, only.of.name, "",
                 fmt::format("the header gives {:g} 1/s, but --rate gives {:g} 1/s", only.rate, *rate));
    if (only.rate == 0) only.rate = rate.value_or(0);
    return;
  }
  if (rate)
    faults.add(columns.line, "", "",
               "there are several columns of stress; give each rate in its header, not with --rate");
  for (const StressColumn& column : columns.stresses)
    if (column.rate == 0)
      faults.add(columns.line, column.of.name, "",
                 "with several columns of stress each header must give its rate after an @, such as "
                 "\"stress_kPa @ 10 1/s\"");
  std::ranges::sort(columns.stresses, {}, &StressColumn::rate);
}

/// Adds a row to each curve that has a stress in it.
void take_row(const CsvRow& row, const StressColumns& columns, char separator, std::vector<DeckCurve>& curves,
              MeasurementFaults& faults) {
  const ReadNumber strain = read_csv_number(field_in(row, columns.strain), separator);
  if (strain.kind != NumberKind::number)
    return faults.add(row.line, "strain", to_utf8(field_in(row, columns.strain)), rule_for(strain.kind));
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const injury::MeasuredColumn& column = columns.stresses[i].of;
    if (field_in(row, column).empty() && curves.size() > 1) continue;
    if (const auto stress = number_in(row, column, separator, faults))
      curves[i].add(strain.value / columns.strains_in_one, *stress, row.line);
  }
}

}  // namespace

Reading<DeckMaterial> read_stress_table(const std::filesystem::path& file, std::optional<double> rate) {
  return reading_of([&]() -> DeckMaterial {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    StressColumns columns = choose_stresses(csv.header, faults);
    settle_rates_of(columns, rate, faults);
    faults.throw_if_any();

    std::vector<DeckCurve> curves;
    for (const StressColumn& column : columns.stresses) curves.push_back({column.of.name, columns.line});
    std::size_t count = 0;
    each_row(csv, faults, [&](const CsvRow& row) {
      if (count++ == max_rows_of_stresses)
        faults.refuse(row.line, "", "", fmt::format("more than {} rows", max_rows_of_stresses));
      take_row(row, columns, csv.separator, curves, faults);
    });
    faults.throw_if_any();

    DeckFoam foam;
    foam.card = "table";
    foam.title = to_utf8(file.stem().string());
    foam.line = columns.line;
    foam.linear_in_rate = false;
    foam.basis = "test";
    foam.source = "Table " + to_utf8(file.filename().string());
    foam.assumptions.emplace_back(
        "The unloading is not in the table; the foam unloads along its slowest curve, without loss on it. "
        "Set unloading_factor and unloading_shape.");
    for (std::size_t i = 0; i < curves.size(); ++i)
      foam.loading.push_back({columns.stresses[i].rate, columns.line, std::move(curves[i])});
    auto material = material_of(foam, faults);
    faults.throw_if_any();
    if (!material) faults.refuse(0, "", "", "holds no curve");
    return *std::move(material);
  });
}

}  // namespace dashpad::input
