#pragma once
/// The rules that what is asked of a test breaks, thrown together.

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/model/parameter.hpp"

namespace dashpad::laboratory {

class Rules {
 public:
  Rules& require(bool is_kept, const std::string& name, double value, const std::string& rule) {
    if (!is_kept) text_ += fmt::format("{}{} is {}: {}", text_.empty() ? "" : "; ", name, value, rule);
    return *this;
  }
  Rules& positive(const char* name, double value, const char* unit) {
    return require(value > 0 && std::isfinite(value), name, value,
                   fmt::format("must be more than 0 ({})", unit));
  }
  Rules& rate(double value) { return positive("rate", value, "1/s"); }
  Rules& peak(double value) {
    return require(value > 0 && value < 1, "strain", value, "must be more than 0 and less than 1");
  }
  Rules& none_of(const std::vector<Violation>& broken) {
    for (const Violation& violation : broken) require(false, violation.key, violation.value, violation.rule);
    return *this;
  }
  /// Throws std::invalid_argument that says them all; nothing where none is broken.
  void done() const {
    if (!text_.empty()) throw std::invalid_argument(text_);
  }

 private:
  std::string text_;
};

}  // namespace dashpad::laboratory
