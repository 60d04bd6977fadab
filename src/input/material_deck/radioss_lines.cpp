#include "input/material_deck/radioss_lines.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace dashpad::input {

std::optional<DeckFields> LawLines::next(const Widths& widths) {
  if (taken_ + 1 < block_.lines.size()) return DeckFields(block_.lines[++taken_], widths, false, faults_);
  if (!told_)
    faults_.add(block_.head.number, name_, "",
                fmt::format("ends after {} {}", taken_, taken_ == 1 ? "line" : "lines"));
  told_ = true;
  return std::nullopt;
}

std::string LawLines::title() const {
  return block_.lines.empty() ? "" : to_utf8(without_blanks(block_.lines.front().text.substr(0, 100)));
}

void tell_if_filled(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                    const char* meaning, DeckFoam& foam) {
  const double value = line.number(field, of.key(name));
  if (value == value && value != 0 && std::abs(value) < 1e19)
    foam.differences.push_back(fmt::format("{} = {:g}: {}.", name, value, meaning));
}

double or_default(double given, const char* solver_takes, DeckFoam& foam) {
  if (given != 0) return given;
  foam.assumptions.emplace_back(solver_takes);
  return 1;
}

std::optional<DeckCurve> function_of(const RadiossSource& from, long id, double scale, const std::string& key,
                                     std::size_t asked) {
  const DeckBlock* const block = from.deck.functions.find(id);
  if (block == nullptr) {
    from.faults.add(
        asked, key, fmt::format("{}", id),
        fmt::format(
            "there is no /FUNCT/{}{}", id,
            from.deck.includes_files ? "; files of #include are not read: put it into this deck" : ""));
    return std::nullopt;
  }
  if (block->lines.size() > most_lines_of_curve) {
    from.faults.add(
        block->head.number, fmt::format("function {}", id), "",
        fmt::format("has {} points; {} are the most", block->lines.size() - 1, TableCurve::most_points));
    return std::nullopt;
  }
  DeckCurve curve{fmt::format("function {}", id), block->head.number, {}, {}, {}};
  for (std::size_t i = 1; i < block->lines.size(); ++i) {
    DeckFields point(block->lines[i], {20, 20}, false, from.faults);
    curve.strain.push_back(point.number(0, curve.name + ": X" + std::to_string(i)));
    const double stress = point.number(1, curve.name + ": Y" + std::to_string(i), from.units.stress);
    curve.stress.push_back(scale == 1 ? stress : scale * stress);
    curve.lines.push_back(point.line());
  }
  return curve;
}

namespace {

/// A line with function, rate and scale.
std::optional<DeckRateCurve> row_of(LawLines& lines, const RadiossSource& from) {
  auto row = lines.next({10, 20, 20});
  if (!row) return std::nullopt;
  const auto id = row->whole(0, lines.key("fct_ID"));
  DeckRateCurve at{row->number(1, lines.key("Eps_dot"), from.units.rate), row->line(), {}};
  const double scale = row->number(2, lines.key("Fscale"));
  if (!id || scale != scale) return std::nullopt;
  auto curve = function_of(from, *id, scale == 0 ? 1 : scale, lines.key("fct_ID"), row->line());
  if (!curve) return std::nullopt;
  at.curve = *std::move(curve);
  return at;
}

}  // namespace

bool read_rows(long count, LawLines& lines, const RadiossSource& from, std::vector<DeckRateCurve>& rows) {
  bool sound = true;
  for (long i = 0; i < count; ++i) {
    auto row = row_of(lines, from);
    sound = sound && row;
    if (row) rows.push_back(*std::move(row));
  }
  return sound;
}

std::optional<long> count_in(DeckFields& line, std::size_t field, const LawLines& of, const char* name,
                             long fewest, MeasurementFaults& faults, std::size_t most) {
  const auto count = line.whole(field, of.key(name));
  if (!count || (*count >= fewest && *count <= static_cast<long>(most))) return count;
  faults.add(line.line(), of.key(name), fmt::format("{}", *count),
             fmt::format("must be between {} and {}", fewest, most));
  return std::nullopt;
}

bool read_density_line(LawLines& lines, const RadiossSource& from, DeckFoam& foam) {
  auto line = lines.next({20, 20});
  if (line) foam.density = line->number(0, lines.key("RHO_I"), from.units.density);
  return line.has_value();
}

}  // namespace dashpad::input
