#include "output/text/toml_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "quantities/text.hpp"

namespace dashpad::output {

std::string toml_string(const std::string& text) {
  // What JSON writes, but for what TOML forbids.
  return nlohmann::json(one_line(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string toml_value(double number, const std::string& unit) {
  return unit == "1" ? fmt::format("{}", number) : fmt::format("\"{} {}\"", number, unit);
}

std::string toml_line(const std::string& key, double number, const std::string& unit) {
  return fmt::format("{} = {}\n", key, toml_value(number, unit));
}

std::string toml_line(const std::string& key, const std::string& text) {
  return fmt::format("{} = {}\n", key, toml_string(text));
}

std::string toml_line(const std::string& key, const std::vector<double>& numbers) {
  constexpr std::size_t widest = 110;
  std::string text;
  std::string line = key + " = [";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string number = fmt::format("{}{}", numbers[i], i + 1 < numbers.size() ? "," : "]");
    const bool begins = line.ends_with('[');
    if (!begins && line.size() + 1 + number.size() > widest) {
      text += line + "\n";
      line = "  " + number;
    } else {
      line += (begins ? "" : " ") + number;
    }
  }
  return text + line + (numbers.empty() ? "]\n" : "\n");
}

}  // namespace dashpad::output
