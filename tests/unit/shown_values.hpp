#pragma once
/// What was shown, back as numbers: of JSON each with its place, of plots and tables in SI. For tests that
/// compare all of it with the values that it was made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::test {

/// Each number of `written` is that of the same place in `expected`, to rounding, and there are no others.
/// Places as "/bodies/0/mass_kg". Lists of numbers count, too.
inline void expect_numbers(const nlohmann::json& written, std::map<std::string, double> expected) {
  const nlohmann::json flat = written.flatten();
  for (const auto& [place, value] : flat.items()) {
    if (!value.is_number()) continue;
    const auto found = expected.find(place);
    if (found == expected.end()) {
      ADD_FAILURE() << place << " = " << value << " is not looked at";
      continue;
    }
    EXPECT_NEAR(value.get<double>(), found->second, 1e-14 * std::abs(found->second)) << place;
    expected.erase(found);
  }
  for (const auto& [place, value] : expected) ADD_FAILURE() << place << " is not there";
}

/// What one of a unit is in SI; 1 for none, and for words that are no unit.
inline double in_si(const std::string& unit) {
  static const std::map<std::string, double> units = [] {
    std::map<std::string, double> all;
    for (const UnitSystem& system : unit_systems()) {
      for (const char* si : {"m", "kg", "s", "m/s", "m/s2", "N", "N/m", "Pa", "J", "kg/m2", "kg/m3"}) {
        const ScaledUnit shown = shown_as(si, system);
        all[shown.unit] = 1 / shown.scale;
      }
      all[output::energy_density_unit(system)] = 1 / shown_as("Pa", system).scale;
    }
    return all;
  }();
  const auto found = units.find(unit);
  return found == units.end() ? 1 : found->second;
}

/// "kN" of "Force (kN)" and of "Force, kN".
inline std::string unit_in(const std::string& label) {
  if (label.ends_with(')')) {
    const auto open = label.rfind('(');
    return label.substr(open + 1, label.size() - open - 2);
  }
  const auto comma = label.rfind(", ");
  return comma == std::string::npos ? "" : label.substr(comma + 2);
}

inline std::vector<output::Plot> plots_of(const std::vector<output::CaptionedPlot>& figures) {
  std::vector<output::Plot> plots;
  for (const output::CaptionedPlot& figure : figures) plots.push_back(figure.plot);
  return plots;
}

/// A panel whose series are in SI.
inline output::Panel panel_in_si(output::Panel panel) {
  const double x = in_si(unit_in(panel.x.label)), y = in_si(unit_in(panel.y.label));
  for (output::Series& series : panel.series) {
    for (double& value : series.x) value *= x;
    for (auto* column : {&series.y, &series.y2})
      for (double& value : *column) value *= y;
  }
  return panel;
}

/// The series with that label or, of those without, that belongs to it.
inline const output::Series& series_of(const output::Panel& panel, const std::string& label) {
  for (const output::Series& series : panel.series)
    if (series.label == label || (series.label.empty() && series.of == label)) return series;
  throw std::invalid_argument("no series " + label);
}

/// The same, to rounding of the largest.
inline void expect_values(const std::vector<double>& values, const std::vector<double>& expected,
                          const std::string& what) {
  ASSERT_EQ(values.size(), expected.size()) << what;
  double largest = 0;
  for (const double value : expected)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == expected[i] || (std::isnan(values[i]) && std::isnan(expected[i]))) continue;
    ASSERT_NEAR(values[i], expected[i], 1e-9 * largest) << what << ", " << i;
  }
}

/// Of all series with that label or that belong to it, one after the other.
inline output::Series joined(const output::Panel& panel, const std::string& label) {
  output::Series all;
  for (const output::Series& series : panel.series)
    if (series.label == label || series.of == label) {
      // A way back begins where the way there ends.
      const std::size_t skipped = all.x.empty() ? 0 : 1;
      all.x.insert(all.x.end(), series.x.begin() + std::ptrdiff_t(skipped), series.x.end());
      all.y.insert(all.y.end(), series.y.begin() + std::ptrdiff_t(skipped), series.y.end());
    }
  return all;
}

/// In SI, whatever the units of the panel.
inline void expect_series(const output::Panel& panel, const std::string& label, const std::vector<double>& x,
                          const std::vector<double>& y) {
  const output::Series series = joined(panel_in_si(panel), label);
  expect_values(series.x, x, panel.title + ": " + label + ", x");
  expect_values(series.y, y, panel.title + ": " + label + ", y");
}

/// `figures` gives plots with a unit system: the same values in each, whatever the unit.
template <class Figures>
void expect_same_in_all_units(Figures&& figures) {
  const std::vector<output::Plot> first = figures(unit_systems().front());
  ASSERT_FALSE(first.empty());
  for (const UnitSystem& units : unit_systems().subspan(1)) {
    const std::vector<output::Plot> other = figures(units);
    ASSERT_EQ(other.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_EQ(other[i].panels.size(), first[i].panels.size());
      for (std::size_t k = 0; k < first[i].panels.size(); ++k) {
        const output::Panel a = panel_in_si(first[i].panels[k]), b = panel_in_si(other[i].panels[k]);
        ASSERT_EQ(a.series.size(), b.series.size()) << first[i].title;
        for (std::size_t s = 0; s < a.series.size(); ++s) {
          const std::string what = units.name + ": " + first[i].title + ": " + a.title + ": " +
                                   a.series[s].label + a.series[s].of + a.series[s].end_label;
          expect_values(b.series[s].x, a.series[s].x, what + ", x");
          expect_values(b.series[s].y, a.series[s].y, what + ", y");
          expect_values(b.series[s].y2, a.series[s].y2, what + ", y2");
        }
      }
    }
  }
}

/// Without breaks of lines, and with single blanks.
inline std::string in_one_line(const std::string& lines) {
  std::string text;
  for (const char c : lines)
    if (const bool is_blank = c == ' ' || c == '\n'; !is_blank || !text.ends_with(' '))
      text += is_blank ? ' ' : c;
  return text;
}

/// All numbers in a text, in SI where one of the units follows that people are shown: also behind the end of
/// a range, "2080 to 9170 N".
inline std::vector<double> numbers_in(const std::string& lines) {
  const std::string text = in_one_line(lines);
  std::vector<double> numbers;
  std::size_t without_unit = 0;  // those of a range, of which the unit is still to come
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  bool within_word = false;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const bool begins = is_digit(c) || (c == '-' && at + 1 < text.size() && is_digit(text[at + 1]));
    if (within_word || !begins) {
      within_word = std::isalpha(static_cast<unsigned char>(c)) != 0 || (within_word && is_digit(c));
      ++at;
      continue;
    }
    char* end = nullptr;
    numbers.push_back(std::strtod(text.c_str() + at, &end));
    at = static_cast<std::size_t>(end - text.c_str());
    ++without_unit;
    if (text.compare(at, 4, " to ") == 0 && at + 4 < text.size() &&
        (is_digit(text[at + 4]) || text[at + 4] == '-')) {
      at += 4;
      continue;
    }
    if (at < text.size() && text[at] == ' ') {
      std::string unit = text.substr(at + 1, text.find_first_of(" ,;:()", at + 1) - at - 1);
      if (unit.ends_with('.')) unit.pop_back();
      for (std::size_t i = numbers.size() - without_unit; i < numbers.size(); ++i) numbers[i] *= in_si(unit);
    }
    without_unit = 0;
  }
  return numbers;
}

/// The numbers of a table, cell by cell, in SI by the unit in the cell, at the head of its column or, but for
/// counts, in the first cell of its row.
inline std::vector<double> numbers_in(const output::Table& table) {
  std::vector<double> all;
  for (const std::vector<std::string>& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& head = table.columns.at(i);
      const bool is_count = head.starts_with("Rows") || head == "Bottomed out";
      const double of_row = i > 0 && !is_count ? in_si(unit_in(row[0])) : 1;
      for (const double number : numbers_in(row[i])) all.push_back(number * in_si(unit_in(head)) * of_row);
    }
  return all;
}

/// `shown` gives numbers with a unit system: the same in each, but for their rounding.
template <class Shown>
void expect_same_numbers_in_all_units(Shown&& shown, double relative) {
  const std::vector<double> first = shown(unit_systems().front());
  ASSERT_FALSE(first.empty());
  for (const UnitSystem& units : unit_systems().subspan(1)) {
    const std::vector<double> other = shown(units);
    ASSERT_EQ(other.size(), first.size()) << units.name;
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_NEAR(other[i], first[i], relative * std::abs(first[i])) << units.name << ", number " << i + 1;
  }
}

}  // namespace dashpad::test
