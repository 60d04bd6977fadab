#include "study/limit.hpp"

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::app {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// With a g of acceleration, which elsewhere is a gram.
double value_in_si(const std::string& text, const std::string& si_unit) {
  if (si_unit == "m/s2" && text.size() > 1 && text.ends_with("g"))
    return standard_gravity * stated_si(trimmed(text.substr(0, text.size() - 1)), "1");
  return stated_si(text, si_unit);
}

std::string unit_of(const std::string& name, const study::Store& store) {
  for (const study::StoredColumn& response : store.responses())
    if (response.name == name) return response.unit;
  return "1";
}

}  // namespace

std::string response_rule(const std::string& name, const study::Store& store) {
  std::string names;
  for (const study::StoredColumn& response : store.responses()) {
    if (response.name == name) return "";
    names += (names.empty() ? "" : ", ") + response.name;
  }
  return "is no response of this study; it keeps " + names;
}

std::optional<study::StudyLimit> limit_of(const std::string& text, const study::Store& store,
                                          std::vector<std::string>& wrong) {
  const auto refuse = [&](const std::string& rule) {
    wrong.push_back(fmt::format("--limit \"{}\": {}", text, rule));
    return std::nullopt;
  };
  const std::size_t sign = text.find_first_of(">=");
  if (sign == std::string::npos) return refuse("must be a response, > and a value, such as \"hic15 > 1000\"");
  const std::string name = trimmed(text.substr(0, sign));
  if (const std::string rule = response_rule(name, store); !rule.empty()) return refuse(name + " " + rule);
  try {
    return study::StudyLimit{name, value_in_si(trimmed(text.substr(sign + 1)), unit_of(name, store))};
  } catch (const UnitError& error) {
    return refuse(error.what());
  }
}

}  // namespace dashpad::app
