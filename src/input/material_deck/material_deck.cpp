#include "input/material_deck/deck_cards.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "dashpad/input/material_deck.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "input/material_deck/deck_foam.hpp"
#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t longest_number = 100;

/// A number as it is written: digits with a point among them, and the exponent behind.
struct WrittenNumber {
  std::string mantissa;
  int exponent = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<int> read_exponent(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || std::abs(value) > 9999) return std::nullopt;
  return value;
}

/// Absent where the text is no number.
std::optional<WrittenNumber> taken_apart(std::string_view text) {
  WrittenNumber number;
  std::size_t i = 0;
  if (text[0] == '+' || text[0] == '-') {
    if (text[0] == '-') number.mantissa = "-";
    ++i;
  }
  bool has_digit = false, has_point = false;
  for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !has_point)); ++i) {
    has_digit = has_digit || is_digit(text[i]);
    has_point = has_point || text[i] == '.';
    number.mantissa += text[i];
  }
  if (!has_digit) return std::nullopt;
  if (i == text.size()) return number;
  if (std::string_view("eEdD").find(text[i]) != std::string_view::npos) ++i;
  const auto exponent = read_exponent(text.substr(i));
  if (!exponent) return std::nullopt;
  number.exponent = *exponent;
  return number;
}

/// Significant digits, of which the first has the weight 10^exponent.
struct Digits {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Digits digits_of(double value, int precision) {
  std::array<char, 64> buffer{};
  const auto end = precision < 0 ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                 std::chars_format::scientific)
                                 : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                 std::chars_format::scientific, precision);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const auto mark = text.find('e');
  Digits result;
  for (const char c : text.substr(0, mark)) {
    if (c == '-') result.negative = true;
    if (is_digit(c)) result.digits += c;
  }
  while (result.digits.size() > 1 && result.digits.ends_with('0')) result.digits.pop_back();
  result.exponent = read_exponent(text.substr(mark + 1)).value_or(0);
  return result;
}

std::string in_fixed_notation(const Digits& number, bool with_zero) {
  const auto& [negative, digits, exponent] = number;
  const std::string sign = negative ? "-" : "";
  if (exponent < 0)
    return sign + (with_zero ? "0." : ".") + std::string(static_cast<std::size_t>(-exponent - 1), '0') +
           digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0') + ".0";
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string in_scientific_notation(const Digits& number) {
  return fmt::format("{}{}.{}e{}", number.negative ? "-" : "", number.digits.substr(0, 1),
                     number.digits.size() > 1 ? number.digits.substr(1) : "0", number.exponent);
}

/// Empty where no notation is short enough. One column is left blank where that is possible.
std::string fitting(const Digits& number, std::size_t width) {
  const bool is_handy = number.exponent > -6 && number.exponent < 16;
  for (const std::size_t room : {width - 1, width})
    for (const int notation : {0, 1, 2}) {
      if (notation != 1 && !is_handy) continue;
      const std::string text =
          notation == 1 ? in_scientific_notation(number) : in_fixed_notation(number, notation == 0);
      if (text.size() <= room) return text;
    }
  return "";
}

/// The number whose product with `factor` is `value`, if rounding has one.
double divided(double value, double factor) {
  const double quotient = value / factor;
  double below = quotient, above = quotient;
  for (int i = 0; i < 3; ++i) {
    if (below * factor == value) return below;
    if (above * factor == value) return above;
    below = std::nextafter(below, 0.0);
    above = std::nextafter(above, 2 * quotient);
  }
  return quotient;
}

constexpr std::size_t largest_deck = std::size_t{64} << 20;  // bytes

enum class Solver { ls_dyna, radioss, unknown };

/// By the first line that begins a keyword.
Solver solver_of(std::string_view text) {
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (line.starts_with('*')) return Solver::ls_dyna;
    if (line.starts_with('/')) return Solver::radioss;
  }
  return Solver::unknown;
}

/// The names of units that a system is called after, in alphabetical order.
std::vector<std::string> sorted_units(std::string_view name) {
  std::vector<std::string> units{""};
  for (const char c : name)
    if (c == '-')
      units.emplace_back();
    else
      units.back() += c;
  std::ranges::sort(units);
  return units;
}

/// Cards of one folder need different names.
void make_names_differ(std::vector<DeckMaterial>& materials) {
  std::map<std::string, int> count;
  for (const DeckMaterial& each : materials) ++count[each.material.name];
  std::map<std::string, int> taken;
  for (DeckMaterial& each : materials) {
    std::string& name = each.material.name;
    if (count[name] > 1) name += fmt::format("-{}", each.id);
    const std::string numbered = name;
    for (int i = 2; taken[name]++ > 0; ++i) name = fmt::format("{}-{}", numbered, i);
  }
}

constexpr double highest_number_of_anything = 2'147'483'647;

std::string rule_for_deck_number(NumberKind kind) {
  if (kind == NumberKind::not_finite) return "must be a finite number";
  if (kind == NumberKind::out_of_range) return "is too large or too small a number";
  return "is no number";
}

}  // namespace

DeckUnit deck_unit(const std::string& unit, const std::string& si_unit) {
  DeckUnit result{to_si("1 " + unit, si_unit), std::nullopt};
  const double power = std::round(std::log10(result.factor));
  if (std::abs(result.factor / std::pow(10, power) - 1) < 1e-12)
    result.power_of_ten = static_cast<int>(power);
  return result;
}

DeckUnits::DeckUnits(const UnitSystem& system)
    : stress(deck_unit(system.pressure, "Pa")),
      density(deck_unit("(" + system.mass + ")/" + system.length + "3", "kg/m3")),
      rate(deck_unit("1/" + system.time, "1/s")),
      time(deck_unit(system.time, "s")) {}

const DeckUnit& DeckUnits::of(Content content) const {
  switch (content) {
    case Content::stress: return stress;
    case Content::density: return density;
    case Content::rate: return rate;
    case Content::time: return time;
    case Content::number:
    case Content::whole: break;
  }
  return none;
}

ReadNumber read_deck_number(std::string_view text, const DeckUnit& unit) {
  text = without_blanks(text);
  if (text.empty()) return {};
  if (text.size() > longest_number) return {NumberKind::text};
  const std::string word = lower_case(text.substr(text[0] == '+' || text[0] == '-' ? 1 : 0));
  if (word.starts_with("nan") || word.starts_with("inf")) return {NumberKind::not_finite};
  auto number = taken_apart(text);
  if (!number) return {NumberKind::text};
  number->exponent += unit.power_of_ten.value_or(0);
  const std::string shifted = fmt::format("{}e{}", number->mantissa, number->exponent);
  double value = 0;
  const auto [end, error] = from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  if (error == std::errc::result_out_of_range) return {NumberKind::out_of_range};
  if (error != std::errc{} || end != shifted.data() + shifted.size()) return {NumberKind::text};
  if (!unit.power_of_ten) value *= unit.factor;
  return {std::isfinite(value) ? NumberKind::number : NumberKind::out_of_range, value};
}

std::string deck_number(double value, const DeckUnit& unit, std::size_t width) {
  if (value == 0) return "0.0";
  if (!unit.power_of_ten) value = divided(value, unit.factor);
  std::string text;
  for (int precision = -1; text.empty() && precision != 0; precision = precision < 0 ? 16 : precision - 1) {
    Digits digits = digits_of(value, precision);
    digits.exponent -= unit.power_of_ten.value_or(0);
    text = fitting(digits, width);
  }
  return text;
}

const UnitSystem& deck_system(std::string_view name) {
  for (const UnitSystem& system : consistent_systems())
    if (sorted_units(name) == sorted_units(system.name)) return system;
  return consistent_system(name);
}

Reading<std::vector<DeckMaterial>> read_material_deck(const std::filesystem::path& file,
                                                      const UnitSystem& units) {
  return reading_of([&]() -> std::vector<DeckMaterial> {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file, largest_deck);
    const std::string_view text = text_in(content, faults);
    if (without_blanks(text).empty()) faults.refuse(0, "", "", "is empty");
    const Solver solver = solver_of(text);
    if (solver == Solver::unknown)
      faults.refuse(0, "", "", "is no deck: no line begins with * (LS-DYNA) or / (Radioss)");
    const DeckUnits deck_units(units);
    std::vector<DeckFoam> foams = solver == Solver::ls_dyna ? read_ls_dyna(text, deck_units, faults)
                                                            : read_radioss(text, units, deck_units, faults);
    std::vector<DeckMaterial> materials;
    for (DeckFoam& foam : foams) {
      foam.source = fmt::format("{} {} of the deck {}, line {}, in the units {}", foam.card, foam.id,
                                to_utf8(file.filename().string()), foam.line, units.name);
      if (auto material = material_of(foam, faults)) materials.push_back(*std::move(material));
    }
    faults.throw_if_any();
    make_names_differ(materials);
    return materials;
  });
}

Widths equal_widths(std::size_t count, bool long_format) { return Widths(count, long_format ? 20 : 10); }

DeckFields::DeckFields(const DeckLine& line, const Widths& widths, bool free, MeasurementFaults& faults)
    : line_(line), faults_(faults) {
  std::string_view rest = line.text;
  if (free && rest.find(',') != std::string_view::npos) {
    while (fields_.size() < widths.size()) {
      const auto comma = rest.find(',');
      fields_.push_back(without_blanks(rest.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    return;
  }
  if (rest.find('\t') != std::string_view::npos)
    faults.add(line.number, "", "",
               "holds a tab, so that its columns cannot be told; put blanks in its place");
  widths_ = widths;
  for (const std::size_t width : widths) {
    fields_.push_back(without_blanks(rest.substr(0, width)));
    rest.remove_prefix(std::min(width, rest.size()));
  }
}

std::string_view DeckFields::text(std::size_t field) const {
  return field < fields_.size() ? fields_[field] : std::string_view{};
}

bool DeckFields::is_blank(std::size_t field) const { return text(field).empty(); }

std::string DeckFields::place_of(std::size_t field) const {
  if (widths_.empty()) return fmt::format("field {} between commas", field + 1);
  std::size_t first = 1;
  for (std::size_t i = 0; i < field; ++i) first += widths_[i];
  return fmt::format("columns {} to {}", first, first + widths_[field] - 1);
}

double DeckFields::number(std::size_t field, const std::string& key, const DeckUnit& unit) {
  const std::string_view written = text(field);
  const ReadNumber read = read_deck_number(written, unit);
  if (read.kind == NumberKind::number) return read.value;
  if (read.kind == NumberKind::empty) return 0;
  const std::string rule = written.starts_with('&')
                               ? "is a parameter; write the number in its place"
                               : rule_for_deck_number(read.kind) + " (" + place_of(field) + ")";
  faults_.add(line_.number, key, to_utf8(written), rule);
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<long> DeckFields::whole(std::size_t field, const std::string& key) {
  const double value = number(field, key);
  if (std::isnan(value)) return std::nullopt;
  if (value != std::floor(value) || std::abs(value) > highest_number_of_anything) {
    faults_.add(line_.number, key, to_utf8(text(field)), "must be a whole number (" + place_of(field) + ")");
    return std::nullopt;
  }
  return static_cast<long>(value);
}

void NumberedBlocks::add(long id, DeckBlock block, MeasurementFaults& faults) {
  const auto found = blocks_.find(id);
  if (found != blocks_.end()) {
    faults.add(block.head.number, fmt::format("{} {}", kind_, id), "",
               fmt::format("stands twice; first in line {}", found->second.head.number));
    return;
  }
  places_.emplace(block.place, id);
  blocks_.emplace(id, std::move(block));
}

const DeckBlock* NumberedBlocks::find(long id) const {
  const auto found = blocks_.find(id);
  return found == blocks_.end() ? nullptr : &found->second;
}

const DeckBlock* NumberedBlocks::at_place(std::size_t place) const {
  const auto found = places_.find(place);
  return found == places_.end() ? nullptr : find(found->second);
}

void tell_if_set(double value, const DeckField& field, DeckFoam& foam) {
  constexpr double no_cut_off = 1e19;  // a tension cut-off of that size is none
  if (value == value && value != 0 && std::abs(value) < no_cut_off)
    foam.differences.push_back(fmt::format("{} = {:g}: {}.", field.name, value, field.lost));
}

double or_one(double given, const std::string& solver_takes, DeckFoam& foam) {
  if (given != 0) return given;
  foam.assumptions.push_back(solver_takes);
  return 1;
}

void tell_of_exponent(double exponent, const char* name, DeckFoam& foam) {
  if (exponent == exponent && exponent != 0 && exponent != 1)
    foam.differences.push_back(fmt::format(
        "{} = {:g}: the unloading here has the exponent 1, so the foam loses another part of its work.", name,
        exponent));
}

std::string others_listed(const std::vector<std::string>& other_materials) {
  return other_materials.empty() ? "" : "; there are " + listing(other_materials);
}

std::string too_many_points(std::size_t count) {
  return fmt::format("has {} points; {} are the most", count, TableCurve::max_points);
}

}  // namespace dashpad::input
