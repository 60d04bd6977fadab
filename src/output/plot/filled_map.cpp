#include "output/plot/filled_map.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

struct Vertex {
  double x = 0, y = 0, value = 0;
};
using Outline = std::vector<Vertex>;

/// The part of a convex outline where sign * (value - level) >= 0 (Sutherland and Hodgman).
Outline clipped(const Outline& outline, double level, double sign) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex &from = outline[i], &to = outline[(i + 1) % outline.size()];
    const bool from_in = sign * (from.value - level) >= 0, to_in = sign * (to.value - level) >= 0;
    if (from_in) kept.push_back(from);
    if (from_in == to_in) continue;
    const double part = (level - from.value) / (to.value - from.value);
    kept.push_back({std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part), level});
  }
  return kept;
}

void add(const Outline& outline, Series& area) {
  if (outline.size() < 3) return;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  if (!area.x.empty()) {
    area.x.push_back(gap);
    area.y.push_back(gap);
  }
  for (const Vertex& corner : outline) {
    area.x.push_back(corner.x);
    area.y.push_back(corner.y);
  }
}

using CellCorners = std::array<Vertex, 4>;  ///< around the cell

bool is_whole(const CellCorners& cell) {
  for (const Vertex& corner : cell)
    if (!std::isfinite(corner.value)) return false;
  return true;
}

bool is_within(const CellCorners& cell, double low, double high) {
  for (const Vertex& corner : cell)
    if (!(low <= corner.value && corner.value <= high)) return false;
  return true;
}

/// Cells side by side that are all within the class become one rectangle.
class Areas {
 public:
  Areas(double low, double high, Series& area) : low_(low), high_(high), area_(area) {}

  void add_cell(const CellCorners& cell) {
    if (is_whole(cell) && is_within(cell, low_, high_)) {
      if (pending_.empty()) pending_.assign(cell.begin(), cell.end());
      pending_[1] = cell[1];
      pending_[2] = cell[2];
      return;
    }
    flush();
    if (!is_whole(cell)) return;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      const auto at = [&](int i) { return cell[static_cast<std::size_t>(i)]; };
      add(clipped(clipped({at(a), at(b), at(c)}, low_, 1), high_, -1), area_);
    }
  }
  void flush() {
    add(pending_, area_);
    pending_.clear();
  }

 private:
  double low_, high_;
  Series& area_;
  Outline pending_;
};

}  // namespace

std::vector<double> round_levels(double least, double greatest) {
  constexpr double about = 9;
  constexpr double rounding = 1e-9;  // of the numbers: what differs by less does not differ
  const double range = greatest - least;
  if (!std::isfinite(range) || !(range > rounding * std::max(std::abs(least), std::abs(greatest)))) return {};
  const double rough = range / about;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double part : {5.0, 2.0, 1.0})
    if (part * power >= rough) step = part * power;
  const double first = std::floor(least / step);
  std::vector<double> levels{first * step};
  while (levels.back() < greatest) levels.push_back((first + static_cast<double>(levels.size())) * step);
  return levels;
}

Series class_of_levels(const std::vector<double>& levels, std::size_t i, const std::string& unit) {
  const std::size_t classes = levels.size() - 1;
  return {.label = fmt::format("{} to {}{}{}", four_digits(levels[i]), four_digits(levels[i + 1]),
                               unit.empty() ? "" : " ", unit),
          .style = SeriesStyle::area,
          .turn = 0,
          .shade = classes < 2 ? 0 : static_cast<double>(i) / static_cast<double>(classes - 1)};
}

std::vector<Series> lone_dots(const std::vector<double>& across, const std::vector<double>& up,
                              const std::vector<std::vector<double>>& values,
                              const std::vector<double>& levels, const std::string& unit) {
  const auto is_finite = [&](std::size_t line, std::size_t place) {
    return line < up.size() && place < across.size() && std::isfinite(values[line][place]);
  };
  /// Of the cell below and before the corner.
  const auto is_whole_before = [&](std::size_t line, std::size_t place) {
    return line > 0 && place > 0 && is_finite(line, place) && is_finite(line - 1, place) &&
           is_finite(line, place - 1) && is_finite(line - 1, place - 1);
  };
  std::vector<Series> list;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    Series dots = class_of_levels(levels, i, unit);
    dots.style = SeriesStyle::points;
    const bool is_last = i + 2 == levels.size();
    for (std::size_t line = 0; line < up.size(); ++line)
      for (std::size_t place = 0; place < across.size(); ++place) {
        const double value = values[line][place];
        if (!(value >= levels[i] && (value < levels[i + 1] || (is_last && value == levels[i + 1])))) continue;
        if (is_whole_before(line, place) || is_whole_before(line, place + 1) ||
            is_whole_before(line + 1, place) || is_whole_before(line + 1, place + 1))
          continue;
        dots.x.push_back(across[place]);
        dots.y.push_back(up[line]);
      }
    if (!dots.x.empty()) list.push_back(std::move(dots));
  }
  return list;
}

std::vector<Series> filled_areas(const std::vector<double>& across, const std::vector<double>& up,
                                 const std::vector<std::vector<double>>& values,
                                 const std::vector<double>& levels, const std::string& unit) {
  std::vector<Series> list;
  const auto corner = [&](std::size_t line, std::size_t place) {
    return Vertex{across[place], up[line], values[line][place]};
  };
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    Series area = class_of_levels(levels, i, unit);
    for (std::size_t line = 0; line + 1 < up.size(); ++line) {
      Areas row{levels[i], levels[i + 1], area};
      for (std::size_t place = 0; place + 1 < across.size(); ++place)
        row.add_cell({corner(line, place), corner(line, place + 1), corner(line + 1, place + 1),
                      corner(line + 1, place)});
      row.flush();
    }
    if (!area.x.empty()) list.push_back(std::move(area));
  }
  return list;
}

}  // namespace dashpad::output
