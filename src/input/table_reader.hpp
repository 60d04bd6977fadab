#pragma once
/// Reads the entries of TOML tables and collects all faults.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/model/pad/law.hpp"
#include "dashpad/model/parameter.hpp"
#include "input/toml_tree.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::input {

/// The faults of one file, which must outlive them.
class FaultList {
 public:
  explicit FaultList(const TomlFile& file) : file_(&file) {}

  void add(int line, std::string key, std::string value, std::string rule) {
    add(line, {}, std::move(key), std::move(value), std::move(rule));
  }
  /// Adds a fault of an entry: of its value, or of its key.
  void add(const TomlNode& node, std::string key, std::string rule) {
    add(node.line, node.columns, std::move(key), node.written(), std::move(rule));
  }
  void add_key(const TomlNode& node, std::string key, std::string rule) {
    add(node.line, node.key_columns, std::move(key), node.written(), std::move(rule));
  }
  /// Adds the faults of another file.
  void add(const std::vector<Fault>& faults) { faults_.insert(faults_.end(), faults.begin(), faults.end()); }
  /// The value read from another file, whose faults are added.
  template <class T>
  std::optional<T> take(Reading<T> reading) {
    if (reading) return *std::move(reading);
    add(reading.faults());
    return std::nullopt;
  }
  /// Adds broken rules with line and text of their keys, except for keys or parts that have a fault.
  void add(const std::vector<Violation>& violations);
  /// The value or, if there are faults, all of them by line.
  template <class T>
  Reading<T> reading(T value) {
    if (faults_.empty()) return value;
    sort();
    return std::move(faults_);
  }
  [[nodiscard]] std::size_t size() const { return faults_.size(); }

 private:
  [[nodiscard]] bool explains(std::string_view key) const;
  void add(int line, TomlNode::Columns columns, std::string key, std::string value, std::string rule);
  void sort();

  const TomlFile* file_;
  std::vector<Fault> faults_;
};

/// The folders in which named files and materials are looked up.
struct Folders {
  std::filesystem::path of_file;
  std::filesystem::path materials;
};

enum class Presence { required, optional };

class TableReader {
 public:
  /// `path` is the dotted key of the table; "" for the file itself. Both references must outlive the reader.
  TableReader(const TomlNode& table, std::string path, FaultList& faults)
      : table_(&table), path_(std::move(path)), faults_(&faults) {}

  /// A quantity in SI; NaN if absent or at fault.
  double quantity(const std::string& key, const std::string& si_unit);
  /// A plain number; NaN if absent or at fault.
  double number(const std::string& key) { return value(key, "1"); }
  /// A plain number if `unit` is "1", else a quantity; NaN if absent or at fault.
  double value(const std::string& key, const std::string& unit);
  /// A whole number in a range; nothing if absent or at fault.
  std::optional<double> whole_number(const std::string& key, double lowest, double highest);
  /// A text, which is empty only if absent or at fault.
  std::string text(const std::string& key, Presence presence = Presence::required);
  /// One of the choices; empty if absent or at fault.
  std::string choice(const std::string& key, const std::vector<std::string>& choices);
  bool yes_or_no(const std::string& key);
  /// The value of an optional entry; false if absent.
  bool flag(const std::string& key) { return has(key) && yes_or_no(key); }
  /// An existing file, relative to `folder`; nothing if absent or at fault.
  std::optional<std::filesystem::path> file(const std::string& key, const std::filesystem::path& folder);
  std::optional<TableReader> table(const std::string& key, Presence presence = Presence::required);
  const TomlNode* array(const std::string& key);
  /// Calls `read` for each table of the array at `key`. Others break `rule`, or "must be a table: [[key]]".
  template <class Read>
  void each_table(const std::string& key, const TomlNode& array, Read&& read, const char* rule = nullptr) {
    for (const TomlNode& node : array.children) {
      TableReader reader(node, full_key(key) + node.key, *faults_);
      if (node.kind == TomlNode::Kind::table)
        read(reader);
      else
        faults_->add(node, reader.path_, rule ? rule : "must be a table: [[" + full_key(key) + "]]");
    }
  }

  /// An entry of the table; null if absent, which is a fault if it is required.
  const TomlNode* find(const std::string& key, Presence presence = Presence::required);

  /// Whether the entry is there. Marks it as known.
  bool has(const std::string& key) { return find(key, Presence::optional) != nullptr; }
  void fault(const std::string& key, std::string rule);
  /// Reports entries that nobody asked for.
  void refuse_others();

  [[nodiscard]] const TomlNode& node() const { return *table_; }
  [[nodiscard]] FaultList& faults() const { return *faults_; }
  [[nodiscard]] std::string full_key(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }

 private:
  const TomlNode* table_;
  std::string path_;
  FaultList* faults_;
  std::vector<std::string> known_;
};

/// The largest whole number that TOML gives exactly, since it is read as binary64.
inline constexpr double largest_whole_number = 9007199254740991;  // 2^53 - 1

/// A quantity in SI; NaN after a fault. For entries of arrays.
double read_quantity(const TomlNode& node, const std::string& key, const std::string& si_unit,
                     FaultList& faults);
/// A plain number if `unit` is "1", else a quantity; NaN after a fault.
double read_value(const TomlNode& node, const std::string& key, const std::string& unit, FaultList& faults);
/// A list of two quantities, such as a point of a curve. Anything else breaks `rule`. NaN after a fault.
std::optional<std::array<double, 2>> read_pair(const TomlNode& node, const std::string& key,
                                               const std::array<const char*, 2>& units, const char* rule,
                                               FaultList& faults);

/// Up to 2000 plain numbers, times `scale`; those at fault are NaN. Nothing without a list.
std::optional<std::vector<double>> read_numbers(TableReader& table, const std::string& key, double scale = 1);

/// Up to `most` quantities in SI, likewise.
std::optional<std::vector<double>> read_quantities(TableReader& table, const std::string& key,
                                                   const std::string& si_unit, std::size_t most);

/// Reads a number into its owner, where it stays as it is if it is left out. After a fault a number is NaN,
/// and a count as it was.
template <class Owner>
void read_parameter(TableReader& table, const Parameter<Owner>& parameter, Owner& into) {
  if (parameter.may_be_left_out() && !table.has(parameter.key)) return;
  const Bounds& bounds = parameter.bounds;
  if (parameter.member.is_count())
    parameter.set(
        into, table.whole_number(parameter.key, bounds.lowest, bounds.highest).value_or(parameter.of(into)));
  else
    parameter.set(into, table.value(parameter.key, parameter.unit));
  if (parameter.left_out == LeftOut::none && parameter.is_none(into))
    table.fault(parameter.key, "must be more than 0; if there is none, leave the key out");
}

/// Numbers at fault are NaN.
template <class Owner>
Owner read_parameters(TableReader& table) {
  Owner result;
  for (const Parameter<Owner>& parameter : Owner::parameters) read_parameter(table, parameter, result);
  return result;
}

/// The alternative named by the text at `key`, with its numbers still to be read; nothing after a fault.
template <class Variant>
std::optional<Variant> read_alternative(TableReader& table, const std::string& key) {
  return alternative_named<Variant>(table.choice(key, names_of_alternatives<Variant>()));
}

/// An alternative with its numbers.
template <class Variant>
Variant with_parameters(const Variant& alternative, TableReader& table) {
  return std::visit([&]<class Of>(const Of&) { return Variant(read_parameters<Of>(table)); }, alternative);
}

}  // namespace dashpad::input
