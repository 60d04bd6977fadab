#include "dashpad/io/fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "io/text.hpp"

namespace dashpad {
namespace {

constexpr std::size_t most_lines = 200;

std::string message(const std::vector<Fault>& faults) {
  std::string lines;
  for (const Fault& fault : std::span(faults).first(std::min(faults.size(), most_lines))) {
    if (!lines.empty()) lines += '\n';
    lines += to_string(fault);
  }
  if (faults.size() > most_lines) lines += fmt::format("\nand {} more faults", faults.size() - most_lines);
  return lines;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string line = fault.file;
  if (fault.line > 0) line += fmt::format(":{}", fault.line);
  if (!fault.key.empty()) line += ": " + fault.key;
  if (!fault.value.empty()) line += " = " + fault.value;
  return one_line(line + ": " + fault.rule);
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(message(faults)), faults_(std::move(faults)) {}

}  // namespace dashpad
