// The table of drops.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "dashpad/fall_height/fall_height.hpp"
#include "dashpad/quantities/constants.hpp"
#include "input/case_rows.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::fall_height {

namespace {

constexpr const char* height_key = "drop_height";
constexpr const char* pulse_key = "file";
constexpr const char* number_key = "drop";
constexpr double max_height = 100;  // m
constexpr double max_number = 1000;

std::string capitalised(std::string word) {
  if (!word.empty() && word.front() >= 'a' && word.front() <= 'z')
    word.front() = static_cast<char>(word.front() - 'a' + 'A');
  return word;
}

std::string in_capitals(std::string word) {
  for (char& c : word)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return word;
}

/// The headers of the table, each with what it means. A g-max is a number of g by its name.
class Headers {
 public:
  explicit Headers(const injury::Standard& standard) {
    add(height_key, "m", {"drop_height", "drop height", "fall_height", "fall height", "height"}, false);
    add(pulse_key, "", {"file", "pulse"});
    add(number_key, "1", {"drop", "drop number", "drop_number", "drop no", "drop no."});
    for (const injury::Criterion& criterion : standard.criteria) {
      const ResultQuantity& quantity = *criterion.quantity;
      add(quantity.key, quantity.si_unit, {quantity.key});
      if (criterion.limits("hic_unlimited")) add(quantity.key, "1", {"hic", "HIC"});
      if (!criterion.limits("peak_acceleration")) continue;
      for (const char* name : {"gmax", "g_max", "g-max", "g max"})
        for (const char* unit : {"", " [g]", " (g)", ", g", "_g"})
          add(quantity.key, "1", {std::string(name) + unit}), in_g_.push_back(std::string(name) + unit);
    }
  }

  [[nodiscard]] const std::vector<input::RowKey>& keys() const { return keys_; }
  /// What a header of the table means.
  [[nodiscard]] const std::string& meaning(const std::string& header) const { return meanings_.at(header); }
  [[nodiscard]] double scale(const std::string& header) const {
    const auto same = [&](const std::string& name) {
      return header == name || header == capitalised(name) || header == in_capitals(name);
    };
    return std::ranges::any_of(in_g_, same) ? standard_gravity : 1;
  }

 private:
  void add(const std::string& meaning, const std::string& unit, const std::vector<std::string>& names,
           bool may_be_empty = true) {
    for (const std::string& name : names)
      for (const std::string& shown : {name, capitalised(name), in_capitals(name)})
        if (meanings_.try_emplace(shown, meaning).second)
          keys_.push_back({.key = shown, .unit = unit, .may_be_empty = may_be_empty, .is_whole = true});
  }

  std::vector<input::RowKey> keys_;
  std::map<std::string, std::string> meanings_;
  std::vector<std::string> in_g_;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, const injury::Standard& standard, const input::CaseRows& rows,
         const Headers& headers)
      : file_(file), standard_(standard), rows_(rows), headers_(headers) {}

  input::Reading<DropTable> read() {
    check_columns();
    DropTable table;
    if (faults_.empty())
      for (std::size_t i = 0; i < rows_.lines.size(); ++i) table.drops.push_back(drop_in(i));
    if (faults_.empty()) check_places();
    if (!faults_.empty()) return std::move(faults_);
    return table;
  }

 private:
  void fault(int line, const std::string& key, std::string rule) {
    faults_.push_back(input::Fault{file_.string(), line, key, "", std::move(rule)});
  }

  [[nodiscard]] const input::RowColumn* column(const std::string& meaning) const {
    const auto found = std::ranges::find_if(
        rows_.columns, [&](const input::RowColumn& each) { return headers_.meaning(each.key) == meaning; });
    return found == rows_.columns.end() ? nullptr : &*found;
  }

  void check_columns() {
    for (const input::RowColumn& each : rows_.columns)
      if (column(headers_.meaning(each.key)) != &each)
        fault(rows_.header_line, each.key, "means the same as another column");
    if (column(height_key) == nullptr)
      fault(rows_.header_line, height_key, "is missing: a column such as drop_height [m]");
    const bool has_figures = std::ranges::any_of(standard_.criteria, [&](const injury::Criterion& criterion) {
      return column(criterion.quantity->key) != nullptr;
    });
    if (column(pulse_key) == nullptr && !has_figures) {
      std::string figures;
      for (const injury::Criterion& criterion : standard_.criteria)
        figures += std::string(", ") + criterion.quantity->key;
      fault(rows_.header_line, "",
            "names neither files of pulses nor a figure that the standard limits: file" + figures);
    }
  }

  /// A drop without a place, where others have one, belongs to none.
  void check_places() {
    for (const input::RowColumn& remark : rows_.labels) {
      if (!tells_places_apart(remark.key) || std::ranges::all_of(remark.texts, &std::string::empty)) continue;
      for (std::size_t i = 0; i < remark.texts.size(); ++i)
        if (remark.texts[i].empty())
          fault(rows_.lines[i], remark.key,
                "is empty, so that it is not known to which place this drop belongs");
    }
  }

  Drop drop_in(std::size_t row) {
    Drop drop{.height = column(height_key)->values[row],
              .figures = {},
              .doubts = std::vector<double>(standard_.criteria.size(), 0),
              .line = rows_.lines[row]};
    if (!(drop.height > 0 && drop.height <= max_height))
      fault(drop.line, column(height_key)->key,
            fmt::format("is {:g} m; must be more than 0, up to {:g} m", drop.height, max_height));
    if (const input::RowColumn* const numbers = column(number_key);
        numbers && std::isfinite(numbers->values[row])) {
      const double number = numbers->values[row];
      if (number >= 1 && number <= max_number && number == std::floor(number))
        drop.number = static_cast<int>(number);
      else
        fault(drop.line, numbers->key, "must be a whole number from 1 on");
    }
    if (const input::RowColumn* const pulses = column(pulse_key)) drop.pulse = pulses->texts[row];
    bool has_figure = false;
    for (const injury::Criterion& criterion : standard_.criteria) {
      const input::RowColumn* const figures = column(criterion.quantity->key);
      const double figure = figures ? headers_.scale(figures->key) * figures->values[row] : no_value;
      if (figure <= 0) fault(drop.line, figures->key, "must be more than 0");
      has_figure = has_figure || !std::isnan(figure);
      drop.figures.push_back(figure);
    }
    if (has_figure == !drop.pulse.empty())
      fault(drop.line, "",
            has_figure ? "has the file of a pulse and figures; give one of them"
                       : "has neither the file of a pulse nor a figure");
    for (const input::RowColumn& remark : rows_.labels)
      if (!remark.key.empty()) drop.remarks.emplace_back(remark.key, remark.texts[row]);
    return drop;
  }

  const std::filesystem::path& file_;
  const injury::Standard& standard_;
  const input::CaseRows& rows_;
  const Headers& headers_;
  std::vector<input::Fault> faults_;
};

}  // namespace

input::Reading<DropTable> read_drops(const std::filesystem::path& file, const injury::Standard& standard) {
  const Headers headers(standard);
  const auto unknown = [](const std::string&) { return std::string("is a key of cases: drops have none"); };
  const input::Reading<input::CaseRows> rows = input::read_case_rows(file, headers.keys(), unknown);
  if (!rows) return rows.faults();
  return Reader(file, standard, *rows, headers).read();
}

}  // namespace dashpad::fall_height
