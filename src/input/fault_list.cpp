#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/table_reader.hpp"

namespace dashpad::input {
namespace {

constexpr const char* option = "--set";  ///< by which a value was given that is in no file

/// Faults that have one: more are not shown, and each costs a line of the file.
constexpr std::size_t most_excerpts = 1000;

}  // namespace

void FaultList::add(int line, TomlNode::Columns columns, std::string key, std::string value,
                    std::string rule) {
  const bool is_set = line == set_by_option;
  faults_.push_back({is_set ? option : file_->name,
                     is_set ? 0 : line,
                     std::move(key),
                     std::move(value),
                     std::move(rule),
                     {}});
  if (faults_.size() <= most_excerpts) faults_.back().excerpt = excerpt_of(file_->text, line, columns);
}

void FaultList::add(int line, std::string key, std::string value, std::string rule) {
  add(line, {}, std::move(key), std::move(value), std::move(rule));
}

void FaultList::add(const TomlNode& node, std::string key, std::string rule) {
  add(node.line, node.columns, std::move(key), node.written(), std::move(rule));
}

void FaultList::add_key(const TomlNode& node, std::string key, std::string rule) {
  add(node.line, node.key_columns, std::move(key), node.written(), std::move(rule));
}

void FaultList::add(const std::vector<Fault>& faults) {
  faults_.insert(faults_.end(), faults.begin(), faults.end());
}

void FaultList::add(const std::vector<Violation>& violations) {
  for (const Violation& violation : violations) {
    if (explains(violation.key)) continue;
    const TomlNode& node = file_->root.nearest(violation.key);
    std::string value = node.written();
    if (value.empty()) value = fmt::format("{}", violation.value);
    add(node.line, node.columns, violation.key, std::move(value), violation.rule);
  }
}

bool FaultList::explains(std::string_view key) const {
  return std::ranges::any_of(faults_, [&](const Fault& fault) {
    return (fault.file == file_->name || fault.file == option) && !fault.key.empty() &&
           key.starts_with(fault.key) &&
           (key.size() == fault.key.size() || key[fault.key.size()] == '.' || key[fault.key.size()] == '[');
  });
}

void FaultList::sort() {
  const auto place = [this](const Fault& fault) { return std::pair(fault.file != file_->name, fault.line); };
  std::ranges::stable_sort(faults_, {}, place);
}

}  // namespace dashpad::input
