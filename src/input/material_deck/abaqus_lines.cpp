#include "input/material_deck/abaqus.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace dashpad::input {
namespace {

/// "rho = 6.0E-11  # t/mm3"
void assign(const DeckLine& line, DeckParameters& parameters, MeasurementFaults& faults) {
  const std::string_view text = without_blanks(line.text.substr(0, line.text.find('#')));
  if (text.empty()) return;
  const auto equals = std::min(text.find('='), text.size());
  const std::string_view name = without_blanks(text.substr(0, equals));
  const std::string_view value = without_blanks(text.substr(std::min(equals + 1, text.size())));
  const bool is_name = !name.empty() && !std::isdigit(static_cast<unsigned char>(name.front())) &&
                       std::ranges::all_of(name, [](char c) {
                         return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
                       });
  if (!is_name || value.empty() || value.front() == '=') {
    faults.add(line.number, "*PARAMETER", to_utf8(text), "must be a name, = and a number or an expression");
    for (const std::string_view word : words_in(text)) parameters.add_unreadable(word);
    return;
  }
  if (value.front() == '\'' || value.front() == '"') return;
  define_parameter({.name = name, .value = value, .line = line.number}, parameters, parameters, faults);
}

}  // namespace

AbaqusKeyword abaqus_keyword(std::string_view text, std::size_t line) {
  AbaqusKeyword keyword{.name = {}, .parameters = {}, .line = line};
  const std::vector<std::string> parts = split_at(text.substr(1), ',');
  for (const std::string& word : split_at(upper_case(parts.front()), ' '))
    if (!word.empty()) keyword.name += (keyword.name.empty() ? "" : " ") + word;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string_view part = parts[i];
    const auto equals = std::min(part.find('='), part.size());
    keyword.parameters[upper_case(without_blanks(part.substr(0, equals)))] =
        without_blanks(part.substr(std::min(equals + 1, part.size())));
  }
  return keyword;
}

bool begins_abaqus_keyword(std::string_view line) {
  const std::string_view text = without_blanks(line);
  return text.starts_with('*') && !text.starts_with("**");
}

void each_abaqus_line(std::string_view text, const std::function<void(const AbaqusKeyword&)>& on_keyword,
                      const std::function<void(const DeckLine&)>& on_data) {
  LineReader lines(text);
  std::string begun;  // a keyword that goes on
  std::size_t first_line = 0;
  const auto finish = [&] {
    if (!begun.empty()) on_keyword(abaqus_keyword(begun, first_line));
    begun.clear();
  };
  for (std::string_view line; lines.next(line);) {
    const std::string_view written = without_blanks(line);
    if (written.empty() || written.starts_with("**")) continue;
    if (written.starts_with('*')) {
      finish();
      first_line = lines.number();
    } else if (begun.empty()) {
      on_data({lines.number(), line});
      continue;
    }
    begun += written;
    if (!begun.ends_with(',')) finish();
  }
  finish();
}

DeckParameters abaqus_parameters(std::string_view text, MeasurementFaults& faults) {
  DeckParameters parameters(abaqus_language);
  bool is_read = false;
  each_abaqus_line(
      text, [&](const AbaqusKeyword& keyword) { is_read = keyword.name == "PARAMETER"; },
      [&](const DeckLine& line) {
        if (is_read) assign(line, parameters, faults);
      });
  return parameters;
}

bool is_abaqus(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (!begins_abaqus_keyword(line)) continue;
    const AbaqusKeyword keyword = abaqus_keyword(without_blanks(line), 0);
    const std::string& name = keyword.name;
    if (name == "KEYWORD" || name.starts_with("MAT_") || name.starts_with("DEFINE_")) return false;
    if (name == "MATERIAL" || name == "HYPERFOAM" || name == "LOW DENSITY FOAM" || name == "HEADING" ||
        keyword.parameters.contains("INPUT"))
      return true;
  }
  return false;
}

}  // namespace dashpad::input
