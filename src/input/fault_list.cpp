#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/table_reader.hpp"

namespace dashpad::input {
namespace {

constexpr const char* option = "--set";  ///< by which a value was given that is in no file

}  // namespace

void FaultList::add(int line, std::string key, std::string value, std::string rule) {
  const bool is_set = line == set_by_option;
  faults_.push_back(
      {is_set ? option : file_, is_set ? 0 : line, std::move(key), std::move(value), std::move(rule)});
}

void FaultList::add(const std::vector<Fault>& faults) {
  faults_.insert(faults_.end(), faults.begin(), faults.end());
}

void FaultList::add(const std::vector<Violation>& violations, const TomlNode& root) {
  for (const Violation& violation : violations) {
    if (explains(violation.key)) continue;
    const TomlNode& node = root.nearest(violation.key);
    const std::string value = node.written();
    add(node.line, violation.key, value.empty() ? fmt::format("{}", violation.value) : value, violation.rule);
  }
}

bool FaultList::explains(std::string_view key) const {
  return std::ranges::any_of(faults_, [&](const Fault& fault) {
    return (fault.file == file_ || fault.file == option) && !fault.key.empty() &&
           key.starts_with(fault.key) &&
           (key.size() == fault.key.size() || key[fault.key.size()] == '.' || key[fault.key.size()] == '[');
  });
}

void FaultList::throw_if_any() {
  if (faults_.empty()) return;
  const auto place = [this](const Fault& fault) { return std::pair(fault.file != file_, fault.line); };
  std::ranges::stable_sort(faults_, {}, place);
  throw InputError(faults_);
}

}  // namespace dashpad::input
