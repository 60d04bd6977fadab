#pragma once
/// Reads the entries of a TOML table and collects every fault instead of stopping at the first.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/model/pad/law.hpp"
#include "input/toml_tree.hpp"

namespace dashpad::input {

/// The faults of one file, which must outlive them.
class FaultList {
 public:
  explicit FaultList(const TomlFile& file) : file_(&file) {}

  void add(int line, std::string key, std::string value, std::string rule);
  /// Of an entry: of its value, or of the key itself.
  void add(const TomlNode& node, std::string key, std::string rule);
  void add_key(const TomlNode& node, std::string key, std::string rule);
  /// Of another file that this one names.
  void add(const std::vector<Fault>& faults);
  /// What another file that this one names gave; its faults are added.
  template <class T>
  std::optional<T> take(Reading<T> reading) {
    if (reading) return *std::move(reading);
    add(reading.faults());
    return std::nullopt;
  }
  /// The broken rules of what was made of the tree, with line and text of the keys; but not those of keys,
  /// or parts of keys, that have a fault already.
  void add(const std::vector<Violation>& violations);
  /// What was read or, if there is a fault, all of them in the order of lines.
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

enum class Presence { required, optional };

class TableReader {
 public:
  /// `path` is the table's dotted key; "" for the file itself. Both arguments must outlive the reader.
  TableReader(const TomlNode& table, std::string path, FaultList& faults);

  /// In SI. NaN if absent or at fault.
  double quantity(const std::string& key, const std::string& si_unit);
  /// A plain number. NaN if absent or at fault.
  double number(const std::string& key);
  /// Empty if absent or at fault; present text is never empty.
  std::string text(const std::string& key, Presence presence = Presence::required);
  /// One of the choices; empty if absent or at fault.
  std::string choice(const std::string& key, const std::vector<std::string>& choices);
  /// true or false; false after a fault.
  bool yes_or_no(const std::string& key);
  std::optional<TableReader> table(const std::string& key, Presence presence = Presence::required);
  const TomlNode* array(const std::string& key);

  /// Whether the entry is there; from now on it is known.
  bool has(const std::string& key);
  void fault(const std::string& key, std::string rule);
  /// Reports entries that nobody asked for.
  void refuse_others();

  [[nodiscard]] const TomlNode& node() const { return *table_; }
  [[nodiscard]] FaultList& faults() const { return *faults_; }
  [[nodiscard]] std::string full_key(const std::string& key) const {
    return path_.empty() ? key : path_ + "." + key;
  }

 private:
  const TomlNode* find(const std::string& key, Presence presence);

  const TomlNode* table_;
  std::string path_;
  FaultList* faults_;
  std::vector<std::string> known_;
};

/// In SI; NaN after a fault. For the entries of arrays; TableReader::quantity serves those of tables.
double read_quantity(const TomlNode& node, const std::string& key, const std::string& si_unit,
                     FaultList& faults);

}  // namespace dashpad::input
