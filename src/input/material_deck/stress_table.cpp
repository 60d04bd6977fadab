// Compression tests: columns of stress over a column of strain, of one or several files.

#include "dashpad/input/material_deck.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"
#include "input/measurement/test_columns.hpp"
#include "model/pad/foam/foam_rules.hpp"

namespace dashpad::input {

namespace {

/// Completes the rates that the header does not state.
void settle_rates_of(TestColumns& columns, std::optional<double> rate, MeasurementFaults& faults) {
  if (columns.stresses.size() == 1) {
    StressColumn& only = columns.stresses.front();
    if (rate && only.rate > 0 && *rate != only.rate)
      faults.add(columns.line, only.of.name, "",
                 fmt::format("the header gives {:g} 1/s, but --rate gives {:g} 1/s", only.rate, *rate));
    if (only.rate == 0) only.rate = rate.value_or(0);
    return;
  }
  if (rate)
    faults.add(
        columns.line, "", "",
        "there are several stress columns with their rates in the header; leave out --rate, or choose one "
        "with --stress");
}

/// Adds a row to each curve that has a stress in it.
void take_row(const CsvRow& row, const TestColumns& columns, std::vector<DeckCurve>& curves,
              bool& has_too_large, MeasurementFaults& faults) {
  if (row.line < columns.first_line) return;
  const std::optional<double> strain = strain_in(row, columns, faults);
  if (!strain) return;
  if (std::abs(*strain) >= 1) {
    if (!std::exchange(has_too_large, true))
      add_fault(row, columns.strain, too_large_strain(columns), faults);
    return;
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const injury::MeasuredColumn& column = columns.stresses[i].of;
    if (field_in(row, column).empty() && curves.size() > 1) continue;
    if (const auto stress = number_in(row, column, faults)) curves[i].add(*strain, *stress, row.line);
  }
}

/// The tests of a file as measured, with compression positive. Throws InputError.
std::vector<DeckRateCurve> tests_in(const std::filesystem::path& file, std::optional<double> rate,
                                    const StressStrainColumns& wanted, std::vector<std::string>& remarks) {
  MeasurementFaults faults(file.string());
  const std::string content = read_measurement(file);
  const CsvTable csv = csv_table_in(content, faults);
  TestColumns columns = find_test_columns(csv.header, wanted, Beside::stresses, faults);
  settle_rates_of(columns, rate, faults);
  faults.throw_if_any();
  std::vector<std::string> of_each;
  settle_beginning(csv, columns, of_each);
  std::vector<DeckCurve> curves;
  for (const StressColumn& column : columns.stresses) curves.push_back({column.of.name, columns.line});
  std::size_t count = 0;
  bool has_too_large = false;  // told once: the unit is the cause
  each_row(
      csv, faults,
      [&](const CsvRow& row) {
        if (count++ == max_rows_of_stresses)
          faults.refuse(row.line, "", "", fmt::format("has more than {} rows", max_rows_of_stresses));
        take_row(row, columns, curves, has_too_large, faults);
      },
      &of_each);
  faults.throw_if_any();
  std::vector<DeckRateCurve> tests;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    DeckCurve& curve = curves[i];
    make_compression_positive(curve.strain, columns.strain.name, of_each);
    make_compression_positive(curve.stress, curve.name, of_each);
    if (std::ranges::is_sorted(curve.strain, std::ranges::greater())) curve.reverse();
    if (curve.strain.size() < TableCurve::fewest_points || !(std::ranges::max(curve.strain) > 0) ||
        !(std::ranges::max(curve.stress) > 0))
      faults.add(columns.line, curve.name, "",
                 fmt::format("needs at least {} points, with strain and stress in compression",
                             TableCurve::fewest_points));
    else
      tests.push_back({columns.stresses[i].rate, columns.line, std::move(curve)});
  }
  faults.throw_if_any();
  for (std::string& remark : of_each)
    if (std::ranges::find(remarks, remark + ".") == remarks.end()) remarks.push_back(std::move(remark) + ".");
  return tests;
}

/// The tests of all files, the slowest first.
std::vector<DeckRateCurve> tests_in(const std::vector<std::filesystem::path>& files,
                                    const TestConditions& conditions, const StressStrainColumns& wanted,
                                    std::vector<std::string>& remarks) {
  const auto& [rates, temperatures] = conditions;
  std::vector<DeckRateCurve> tests;
  std::vector<Fault> errors;
  for (std::size_t i = 0; i < files.size(); ++i) try {
      const std::optional<double> rate = i < rates.size() ? std::optional{rates[i]} : std::nullopt;
      for (DeckRateCurve& test : tests_in(files[i], rate, wanted, remarks)) {
        if (files.size() > 1) {
          test.curve.name = to_utf8(files[i].filename().string());
          if (test.rate == 0)
            errors.push_back({files[i].string(), static_cast<int>(test.line), "", "",
                              "with several files, give a --rate for each, in the order of the files"});
        }
        if (i < temperatures.size()) test.temperature = temperatures[i];
        tests.push_back(std::move(test));
      }
    } catch (const InputError& error) {
      errors.insert(errors.end(), error.faults().begin(), error.faults().end());
    }
  if (!errors.empty()) throw InputError(std::move(errors));
  std::ranges::stable_sort(tests, {}, &DeckRateCurve::rate);
  return tests;
}

/// The file that a test has its name from; the only one if there are several tests in it.
std::string file_of(const std::string& test, const std::vector<std::filesystem::path>& files) {
  const auto found = std::ranges::find_if(
      files, [&](const std::filesystem::path& file) { return to_utf8(file.filename().string()) == test; });
  return (found == files.end() ? files.front() : *found).string();
}

/// Throws the faults, those of a test with its file.
void throw_if_any(MeasurementFaults& faults, const std::vector<std::string>& tests,
                  const std::vector<std::filesystem::path>& files) {
  std::vector<Fault> all = faults.split_off(0);
  for (Fault& fault : all)
    for (const std::string& test : tests) {
      if ((": " + fault.key + ": ").find(": " + test + ": ") == std::string::npos) continue;
      fault.file = file_of(test, files);
      if (fault.key == test && files.size() > 1) fault.key.clear();  // the name of the file
    }
  if (!all.empty()) throw InputError(std::move(all));
}

/// Reports tests that would be curves at one rate. They are sorted by their rates.
void judge_rates(const std::vector<DeckRateCurve>& tests, const std::vector<std::filesystem::path>& files) {
  if (files.size() == 1) return;
  std::vector<Fault> all;
  for (std::size_t i = 1; i < tests.size(); ++i)
    if (const auto& [rate, line, curve, temperature] = tests[i]; rate == tests[i - 1].rate)
      all.push_back({file_of(curve.name, files), 0, "", "",
                     fmt::format("has the rate of {}, {:g} 1/s{}; leave one of them out, or average them",
                                 tests[i - 1].curve.name, rate, temperature ? ", and its temperature" : "")});
  if (!all.empty()) throw InputError(std::move(all));
}

/// Reports a test, raised to the slower one, that falls by more than the curve of a higher rate may.
void judge_fall(const DeckCurve& curve, MeasurementFaults& faults) {
  double most = 0, fall = 0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < curve.stress.size(); ++i) {
    most = std::max(most, curve.stress[i]);
    if (most > 0 && 1 - curve.stress[i] / most > fall) {
      fall = 1 - curve.stress[i] / most;
      worst = i;
    }
  }
  if (fall > max_softening)
    faults.add(
        curve.lines[worst], curve.name, "",
        fmt::format("from its peak before, the stress falls by {:.0f} % at a strain of {:.3g}; the curve "
                    "of a higher rate may fall by at most {:.0f} %",
                    100 * fall, curve.strain[worst], 100 * max_softening));
}

}  // namespace

bool is_stress_table(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  const bool is_csv = extension == ".csv" || extension == ".tsv";
  constexpr std::size_t beginning = std::size_t{1} << 16;  // bytes
  const auto content = reading_of([&] { return read_measurement(file, largest_deck); });
  if (!content) return is_csv;
  LineReader lines(std::string_view(*content).substr(0, beginning));
  const auto begins_keyword = [](std::string_view line) {
    if (const std::string_view text = without_blanks(line); text.starts_with('*')) line = text;
    return line.size() > 1 && (line[0] == '*' || line[0] == '/') &&
           std::isalpha(static_cast<unsigned char>(line[1]));
  };
  bool has_digits = false;
  for (std::string_view line; lines.next(line);) {
    if (begins_keyword(line)) return false;
    has_digits = has_digits || line.find_first_of("0123456789") != std::string_view::npos;
  }
  return has_digits || is_csv;
}

Reading<DeckMaterial> read_stress_tables(const std::vector<std::filesystem::path>& files,
                                         const TestConditions& conditions,
                                         const StressStrainColumns& wanted) {
  return reading_of([&]() -> DeckMaterial {
    DeckFoam foam;
    std::vector<DeckRateCurve> tests = tests_in(files, conditions, wanted, foam.differences);
    std::vector<std::string> names;
    for (const DeckRateCurve& test : tests) names.push_back(test.curve.name);
    MeasurementFaults of_temperatures(files.front().string());
    if (!conditions.temperatures.empty())
      foam.temperature_table =
          take_temperatures(tests, conditions.temperatures.front(), foam.differences, of_temperatures);
    throw_if_any(of_temperatures, names, files);
    judge_rates(tests, files);
    MeasurementFaults faults(file_of(tests.front().curve.name, files));
    foam.card = "table";
    foam.title = to_utf8(files.front().stem().string());
    foam.line = tests.front().line;
    foam.linear_in_rate = false;
    foam.basis = "test";
    for (const std::filesystem::path& file : files)
      foam.source += (foam.source.empty() ? "Tests in " : ", ") + to_utf8(file.filename().string());
    for (std::size_t i = 0; i < tests.size(); ++i) {
      MeasuredCurves curves = curves_of_test(tests[i].curve, i == 0, foam.differences);
      if (i > 0) {
        raise_to(foam.loading.back().curve, curves.loading, foam.differences);
        judge_fall(curves.loading, faults);
      }
      if (i == 0)
        foam.unloading = std::move(curves.way_back);
      else if (curves.way_back)
        foam.differences.push_back(tests[i].curve.name +
                                   ": its unloading is not used; that of the slowest test is.");
      foam.loading.push_back({tests[i].rate, tests[i].line, std::move(curves.loading)});
    }
    if (!foam.unloading)
      foam.assumptions.emplace_back(
          "The unloading is not in the table, so the foam unloads along the curve for the lowest "
          "rate, without loss at that rate. Set unloading_factor and unloading_shape.");
    throw_if_any(faults, names, files);
    auto material = material_of(foam, faults);
    throw_if_any(faults, names, files);
    if (!material) faults.refuse(0, "", "", "contains no curve");
    return *std::move(material);
  });
}

}  // namespace dashpad::input
