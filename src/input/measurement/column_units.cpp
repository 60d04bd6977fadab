#include "input/measurement/csv_table.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "quantities/text.hpp"
#include "quantities/unit.hpp"

namespace dashpad::input {

namespace {

constexpr std::array<std::string_view, 4> time_units{"s", "ms", "us", "µs"};
constexpr std::array<std::string_view, 17> acceleration_units{
    "g",      "mg",      "gn",     "m/s2",  "m/s^2",  "m/s²",  "mm/s2",  "mm/s^2", "mm/s²",
    "mm/ms2", "mm/ms^2", "mm/ms²", "ft/s2", "ft/s^2", "in/s2", "in/s^2", "in/s²"};
/// Names of g and its thousandth, in lower case. Of an acceleration, mg can only be a thousandth of g.
constexpr std::array<std::string_view, 9> names_of_g{"g",  "gs",  "g's", "g’s", "gee",
                                                     "gn", "g_n", "g_0", "g0"};
constexpr std::array<std::string_view, 6> names_of_milli_g{"mg",      "mgs",     "mg's",
                                                           "milli-g", "milli g", "millig"};
/// Names of units of time, in lower case.
constexpr std::array<std::pair<std::string_view, std::string_view>, 17> names_of_times{
    {{"sec", "s"},
     {"secs", "s"},
     {"second", "s"},
     {"seconds", "s"},
     {"sek", "s"},
     {"msec", "ms"},
     {"msecs", "ms"},
     {"millis", "ms"},
     {"millisec", "ms"},
     {"millisecond", "ms"},
     {"milliseconds", "ms"},
     {"usec", "us"},
     {"usecs", "us"},
     {"microsec", "us"},
     {"microsecond", "us"},
     {"microseconds", "us"},
     {"micros", "us"}}};

/// Names of units of voltage, in lower case.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> names_of_voltages{
    {{"volt", "V"},
     {"volts", "V"},
     {"mvolt", "mV"},
     {"mvolts", "mV"},
     {"millivolt", "mV"},
     {"millivolts", "mV"}}};

bool is_among(std::string_view word, const auto& words) {
  return std::ranges::find(words, word) != words.end();
}

/// The unit in the notation of the table of units: "ms" for "msec", "m/s2" for "m_per_s2".
std::string standard_unit(std::string_view unit) {
  std::string text(without_blanks(unit));
  replace_all(text, "**", "^");
  replace_all(text, "_per_", "/");
  replace_all(text, "/s/s", "/s2");
  const std::string lower = lower_case(text);
  if (lower == "m_s2" || lower == "mps2" || lower == "m/sec2" || lower == "m/sec^2") return "m/s2";
  for (const auto& [name, unit_of_time] : names_of_times)
    if (lower == name) return std::string(unit_of_time);
  for (const auto& [name, unit_of_voltage] : names_of_voltages)
    if (lower == name) return std::string(unit_of_voltage);
  if (text == "S" || text == "MS" || text == "US") return lower;  // headers in capitals
  return text;
}

bool is_name_of_g(std::string_view unit) { return is_among(lower_case(unit), names_of_g); }
bool is_name_of_milli_g(std::string_view unit) { return is_among(lower_case(unit), names_of_milli_g); }

const char* si_unit_of(ColumnKind kind) { return kind == ColumnKind::time ? "s" : "m/s2"; }

constexpr const char* words_for(ColumnKind kind) {
  return kind == ColumnKind::time ? "time" : "acceleration";
}

/// The place of the bracket that matches the one at the end of `text`.
std::size_t opening_bracket(std::string_view text) {
  if (!text.ends_with(')') && !text.ends_with(']')) return std::string_view::npos;
  const char close = text.back();
  const char open = close == ')' ? '(' : '[';
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == close) ++depth;
    if (text[i] == open && --depth == 0) return i;
  }
  return std::string_view::npos;
}

/// Whether the text before a slash belongs to a unit: "v m" in "v m/s" does, "Time " in "Time / s" does not.
bool ends_in_unit(std::string_view before) {
  if (before == "t" || before == "a") return false;  // "t/ms", "a/g": a quantity over its unit
  const auto last = before.substr(before.find_last_of(" _") + 1);
  return !last.empty() && last.size() <= 2;
}

/// Like to_si(), but without a message, since a table may have thousands of columns.
bool is_unit_of(const std::string& text, const char* si_unit) {
  return unit_factor(tidy_unit(text), si_unit).match == UnitMatch::same_dimension;
}

/// Whether this is a unit of another quantity, as in a column of degrees called T.
bool is_other_unit(const std::string& text) {
  return unit_factor(tidy_unit(standard_unit(text)), "s").match == UnitMatch::other_dimension;
}

bool begins_with_word(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) {
    if (!name.starts_with(word)) return false;
    const char after = name.size() > word.size() ? name[word.size()] : ' ';
    return !(after >= 'a' && after <= 'z');
  });
}

/// The end of a header that resembles a unit but is unknown, such as "mm_per_fortnight2"; else "".
std::string unknown_unit(const std::string& header) {
  const auto at = header.find_first_of("_ ,");
  if (at == std::string::npos) return "";
  const std::string end(without_blanks(std::string_view(header).substr(at + 1)));
  const auto holds = [&](std::string_view sign) { return end.find(sign) != std::string::npos; };
  return holds("_per_") || holds("/") || holds("^") || holds("²") ? end : "";
}

}  // namespace

double pulse_unit_factor(ColumnKind kind, const std::string& unit) {
  const std::string text = standard_unit(unit);
  if (kind == ColumnKind::acceleration) {
    if (is_name_of_g(text)) return standard_gravity;
    if (is_name_of_milli_g(text)) return 1e-3 * standard_gravity;
  }
  if (text.empty()) throw UnitError("needs a unit");
  try {
    return to_si("1 " + text, si_unit_of(kind));
  } catch (const UnitError& error) {
    std::string rule = error.what();
    if (kind == ColumnKind::acceleration) replace_all(rule, "gravity", "g");
    throw UnitError(rule);
  }
}

bool is_pulse_unit(ColumnKind kind, const std::string& unit) {
  const std::string text = standard_unit(unit);
  if (is_name_of_g(text) || is_name_of_milli_g(text))
    return kind == ColumnKind::acceleration;  // no gigasecond
  return is_unit_of(text, si_unit_of(kind));
}

bool is_voltage(const std::string& unit) { return is_unit_of(standard_unit(unit), "V"); }

bool is_known_unit(const std::string& text) {
  const std::string unit = standard_unit(text);
  return !unit.empty() &&
         (is_unit_of(unit, "s") || is_other_unit(unit) || is_name_of_g(unit) || is_name_of_milli_g(unit));
}

bool is_customary_unit(std::string_view text) {
  const std::string unit = standard_unit(text);
  return is_among(unit, time_units) || is_among(unit, acceleration_units) || is_name_of_g(unit) ||
         is_name_of_milli_g(unit);
}

HeaderText split_header(std::string_view header) {
  const std::string text = to_utf8(without_blanks(header));
  if (const auto open = opening_bracket(text); open != std::string::npos) {
    const std::string_view whole = text;
    return {std::string(without_blanks(whole.substr(0, open))),
            std::string(without_blanks(whole.substr(open + 1, whole.size() - open - 2)))};
  }
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (std::string_view("_ ,/").find(text[i]) == std::string_view::npos) continue;
    const std::string_view whole = text;
    const auto name = without_blanks(whole.substr(0, i));
    const auto unit = without_blanks(whole.substr(i + 1));
    const bool is_quotient = name.ends_with("_per") || (text[i] == '/' && ends_in_unit(whole.substr(0, i)));
    if (!name.empty() && !is_quotient && is_customary_unit(unit))
      return {std::string(name), std::string(unit)};
  }
  return {text, ""};
}

std::optional<double> units_in_strain_one(const std::string& unit) {
  if (unit.empty() || unit == "1" || unit == "-") return 1;
  if (unit == "%" || lower_case(unit) == "percent") return 100;
  constexpr std::array<std::string_view, 6> names_of_millionths{"microstrain", "ustrain", "µstrain",
                                                                "um/m",        "µm/m",    "µε"};
  if (is_among(lower_case(tidy_unit(unit)), names_of_millionths)) return 1e6;
  return std::nullopt;
}

bool looks_like(ColumnKind kind, const injury::MeasuredColumn& column) {
  const bool has_time_unit = is_pulse_unit(ColumnKind::time, column.unit);
  const bool has_acceleration_unit = is_pulse_unit(ColumnKind::acceleration, column.unit);
  if (!has_time_unit && !has_acceleration_unit && is_other_unit(column.unit)) return false;
  const std::string name = lower_case(split_header(column.name).name);
  if (kind == ColumnKind::time) {
    const bool is_named = begins_with_word(name, {"time", "t", "timestamp", "datetime", "zeit", "zeitstempel",
                                                  "uhrzeit", "temps", "tiempo", "tempo"});
    return has_time_unit || (is_named && !has_acceleration_unit);
  }
  const bool is_named =
      begins_with_word(name, {"a", "ax", "ay", "az", "ar", "ares", "acc", "accx", "accy", "accz"}) ||
      name.find("accel") != std::string::npos || name.find("beschl") != std::string::npos;
  return has_acceleration_unit || (is_named && !has_time_unit);
}

std::string settle_unit(injury::MeasuredColumn& column, ColumnKind kind, const std::string& given,
                        const std::string& option, const std::optional<Sensitivity>& sensitivity) {
  const std::string unit = given.empty() ? column.unit : given;
  const char* const examples = kind == ColumnKind::time ? "s, ms, ..."
                               : sensitivity            ? "V, mV"
                                                        : "g, m/s2, ...";
  if (const std::string unknown = unknown_unit(column.name); unit.empty() && !unknown.empty())
    return fmt::format("\"{}\" in the header is not a known unit of {}; give one with {} ({})", unknown,
                       words_for(kind), option, examples);
  if (unit.empty())
    return fmt::format("the {} has no unit in the header; give one with {} ({})", words_for(kind), option,
                       examples);
  const bool in_volts = kind == ColumnKind::acceleration && is_voltage(unit);
  if (in_volts && !sensitivity)
    return fmt::format("is in {} and needs a sensitivity, such as --sensitivity \"10 mV/g\"", unit);
  if (sensitivity && !in_volts)
    return fmt::format("is in {}, but --sensitivity applies only to voltages (V, mV)", unit);
  try {
    column.factor = in_volts ? to_si("1 " + standard_unit(unit), "V") / sensitivity->volts_per_acceleration
                             : pulse_unit_factor(kind, unit);
  } catch (const UnitError& error) {
    return given.empty() ? fmt::format("{}; give another unit with {}", error.what(), option)
                         : fmt::format("{} {}: {}", option, given, error.what());
  }
  if (!(column.factor > 0)) return fmt::format("\"{}\" is not a unit", unit);
  column.unit_origin = given.empty() ? "header" : "given";
  column.unit = unit;
  if (in_volts) column.sensitivity = sensitivity->text;
  return "";
}

std::string wrong_number_of_sensitivities(std::size_t given, std::size_t accelerations) {
  return fmt::format("{} sensitivities were given for {}; give one for all or one for each", given,
                     plural(accelerations, "acceleration signal"));
}

std::optional<Sensitivity> sensitivity_at(const std::vector<Sensitivity>& given, std::size_t place) {
  if (given.size() == 1) return given.front();
  return place < given.size() ? std::optional{given[place]} : std::nullopt;
}

std::optional<std::string> overruled_unit(const injury::MeasuredColumn& column,
                                          const std::string& unit_of_file) {
  if (column.unit_origin != "given" || unit_of_file.empty() || unit_of_file == column.unit)
    return std::nullopt;
  for (const ColumnKind kind : {ColumnKind::time, ColumnKind::acceleration})
    if (is_pulse_unit(kind, unit_of_file) && is_pulse_unit(kind, column.unit) &&
        pulse_unit_factor(kind, unit_of_file) == pulse_unit_factor(kind, column.unit))
      return std::nullopt;
  return fmt::format("{}: the unit in the file is {}, but {} was given and is used", column.name,
                     unit_of_file, column.unit);
}

Sensitivity sensitivity_of(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos)
    throw UnitError("must be a voltage per unit of acceleration, such as \"10 mV/g\" or \"1.02 mV/(m/s2)\"");
  std::string_view unit = without_blanks(std::string_view(text).substr(slash + 1));
  if (unit.starts_with('(') && unit.ends_with(')')) unit = unit.substr(1, unit.size() - 2);
  const double volts = to_si(std::string_view(text).substr(0, slash), "V");
  const double acceleration = pulse_unit_factor(ColumnKind::acceleration, std::string(unit));
  const double sensitivity = volts / acceleration;
  if (!(sensitivity > 0)) throw UnitError("must be more than 0");
  return {text, sensitivity};
}

}  // namespace dashpad::input
