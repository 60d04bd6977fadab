// Curves out of a compression test: the loading along the largest strain so far, made to rise within its
// noise, and the way back from the largest strain.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr double turn_share = 0.01;       // of the largest strain: a shorter way back is noise
constexpr std::size_t max_bins = 200;     // of noisy strains
constexpr std::size_t points_of_bin = 5;  // at least, on average
constexpr double plateau_share = 0.02;  // of the largest strain: a shorter one is noise, and becomes a point
constexpr double softening_share = 0.02;  // of the largest stress: a smaller change is noise
constexpr double relaxing_share = 0.02;   // of the stress, lost at a constant strain

/// The parts of a test, as indices of its points.
struct Parts {
  std::vector<std::size_t> loading, back;  ///< back: from the largest strain down
  std::size_t top = 0;                     ///< of the largest strain
  std::size_t noisy = 0;             ///< points of the loading below the largest strain before, by noise
  std::optional<std::size_t> cycle;  ///< where the strain first turns back and comes back
};

Parts parts_of(const DeckCurve& test) {
  Parts parts;
  const std::vector<double>& strain = test.strain;
  parts.top = static_cast<std::size_t>(std::ranges::max_element(strain) - strain.begin());
  const double turn = turn_share * strain[parts.top];
  double most = -1;
  std::size_t of_most = 0;
  bool is_below = false;  // on a way back, or coming back to the largest strain
  for (std::size_t i = 0; i <= parts.top; ++i) {
    if (strain[i] > most) {
      most = strain[i];
      of_most = i;
      is_below = false;
      parts.loading.push_back(i);
    } else if (strain[i] <= most - turn) {
      is_below = true;
      if (!parts.cycle) parts.cycle = of_most;
    } else if (!is_below && strain[i] < most) {
      ++parts.noisy;
      parts.loading.push_back(i);
    }
  }
  double least = strain[parts.top];
  for (std::size_t i = parts.top + 1; i < strain.size(); ++i) {
    if (strain[i] > least + turn) {
      if (!parts.cycle) parts.cycle = parts.top;
      break;
    }
    if (strain[i] < least) {
      least = strain[i];
      parts.back.push_back(i);
    }
  }
  if (least > strain[parts.top] - turn) parts.back.clear();
  return parts;
}

/// The points in ascending order of strain, in bins of equal width where the strains go to and fro.
DeckCurve sorted_points(const DeckCurve& test, std::vector<std::size_t> places, bool is_noisy) {
  DeckCurve curve{test.name, test.line};
  std::ranges::sort(places, {}, [&](std::size_t i) { return test.strain[i]; });
  const std::size_t most =
      is_noisy ? std::min(max_bins, places.size() / points_of_bin + 1) : TableCurve::max_points;
  const bool in_bins = is_noisy || places.size() > most;
  const double first = test.strain[places.front()], last = test.strain[places.back()];
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    const auto bin_of = [&](std::size_t place) {
      return std::floor((test.strain[place] - first) / (last - first) * static_cast<double>(most));
    };
    double strain = 0, stress = 0;
    for (; end < places.size() && (end == begin || (in_bins && bin_of(places[end]) == bin_of(places[begin])));
         ++end) {
      strain += test.strain[places[end]];
      stress += test.stress[places[end]];
    }
    const auto count = static_cast<double>(end - begin);
    curve.add(strain / count, stress / count, test.lines[places[begin]]);
  }
  return curve;
}

/// How far the stresses of a curve moved when it was made to rise.
struct Moved {
  double largest = 0, strain = 0;  ///< Pa, and where
};

/// The closest curve in the mean square that does not fall (pool adjacent violators). A short stretch of
/// equal stress becomes a point, of a long one its ends stay.
DeckCurve risen(const DeckCurve& curve, Moved& moved) {
  struct Block {
    std::size_t begin = 0, end = 0;
    double sum = 0;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(end - begin); }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < curve.stress.size(); ++i) {
    blocks.push_back({i, i + 1, curve.stress[i]});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().end = last.end;
      blocks.back().sum += last.sum;
    }
  }
  DeckCurve result{curve.name, curve.line};
  for (const Block& block : blocks) {
    const double mean = block.mean();
    for (std::size_t i = block.begin; i < block.end; ++i)
      if (const double change = std::abs(curve.stress[i] - mean); change > moved.largest)
        moved = {change, curve.strain[i]};
    const double from = curve.strain[block.begin], to = curve.strain[block.end - 1];
    if (to - from > plateau_share * curve.strain.back()) {
      result.add(from, mean, curve.lines[block.begin]);
      result.add(to, mean, curve.lines[block.end - 1]);
    } else {
      result.add((from + to) / 2, mean, curve.lines[block.begin]);
    }
  }
  return result;
}

/// Leaves out what comes before the first stress above 0.
std::size_t without_slack(DeckCurve& curve) {
  std::size_t slack = 0;
  while (slack < curve.stress.size() && (curve.stress[slack] <= 0 || curve.strain[slack] <= 0)) ++slack;
  const bool has_origin = slack == 1 && curve.strain[0] == 0 && curve.stress[0] == 0;
  const auto cut = static_cast<std::ptrdiff_t>(slack);
  curve.strain.erase(curve.strain.begin(), curve.strain.begin() + cut);
  curve.stress.erase(curve.stress.begin(), curve.stress.begin() + cut);
  curve.lines.erase(curve.lines.begin(), curve.lines.begin() + cut);
  return has_origin ? 0 : slack;
}

double kpa(double stress) { return stress / 1000; }

void tell_of_parts(const DeckCurve& test, const Parts& parts, std::vector<std::string>& differences) {
  const auto say = [&](const std::string& what) {
    differences.push_back(fmt::format("{}: {}", test.name, what));
  };
  if (parts.cycle)
    say(fmt::format(
        "the strain reverses on line {} and rises again; points below the largest strain reached so far "
        "were left out, but dashpad fit uses them.",
        test.lines[*parts.cycle]));
  else if (!parts.back.empty())
    say(fmt::format("the strain reverses on line {}, where unloading begins.", test.lines[parts.top]));
  if (!parts.back.empty() || parts.top + 1 >= test.stress.size()) return;
  const double lost = 1 - test.stress.back() / test.stress[parts.top];
  if (lost > relaxing_share)
    say(fmt::format(
        "from line {} on, the strain is held and the stress relaxes by {:.2g} %; these points were left "
        "out, but dashpad fit uses them.",
        test.lines[parts.top], 100 * lost));
}

}  // namespace

MeasuredCurves curves_of_test(const DeckCurve& test, bool is_slowest, std::vector<std::string>& differences) {
  MeasuredCurves curves;
  const auto say = [&](const std::string& what) {
    differences.push_back(fmt::format("{}: {}", test.name, what));
  };
  const Parts parts = parts_of(test);
  tell_of_parts(test, parts, differences);
  curves.loading = sorted_points(test, parts.loading, parts.noisy > 0);
  if (parts.noisy > 0 || curves.loading.strain.size() < parts.loading.size())
    say(fmt::format("{} of the loading curve were averaged into {}.", plural(parts.loading.size(), "point"),
                    curves.loading.strain.size()));
  if (is_slowest) {
    Moved moved;
    const double top = std::ranges::max(curves.loading.stress);
    curves.loading = risen(curves.loading, moved);
    if (moved.largest > softening_share * top)
      say(fmt::format(
          "the stress falls near a strain of {:.3g}, which the curve for the lowest rate must not do; it was "
          "levelled there, changing by up to {:.3g} kPa, or {:.2g} % of the largest stress.",
          moved.strain, kpa(moved.largest), 100 * moved.largest / top));
    else if (moved.largest > 0)
      say(fmt::format(
          "noise makes the stress rise and fall; it was smoothed so that it never falls, changing by "
          "at most {:.3g} kPa, or {:.2g} % of the largest stress.",
          kpa(moved.largest), 100 * moved.largest / top));
  }
  if (const std::size_t slack = without_slack(curves.loading); slack > 0)
    say(fmt::format("{} before the first positive stress {} left out.", plural(slack, "point"),
                    slack == 1 ? "was" : "were"));
  if (parts.back.empty() || curves.loading.strain.empty()) return curves;
  Moved ignored;
  DeckCurve back = risen(sorted_points(test, parts.back, false), ignored);
  without_slack(back);
  std::size_t above = 0;
  for (std::size_t i = 0; i < back.strain.size(); ++i)
    if (const double loading =
            on_straight_lines(curves.loading.strain, curves.loading.stress, back.strain[i]);
        back.stress[i] > loading) {
      back.stress[i] = loading;
      ++above;
    }
  if (above > 0)
    say(fmt::format("{} of the unloading curve above the loading curve {} moved onto it.",
                    plural(above, "point"), above == 1 ? "was" : "were"));
  back.name = test.name + ", unloading";
  if (back.strain.empty() || back.strain.back() < curves.loading.strain.back())
    back.add(curves.loading.strain.back(), curves.loading.stress.back(), test.lines[parts.top]);
  if (back.strain.size() >= TableCurve::fewest_points) curves.way_back = std::move(back);
  return curves;
}

void raise_to(const DeckCurve& slower, DeckCurve& curve, std::vector<std::string>& differences) {
  double largest = 0, at = 0;
  for (std::size_t i = 0; i < curve.strain.size() && curve.strain[i] <= slower.strain.back(); ++i)
    if (const double below =
            on_straight_lines(slower.strain, slower.stress, curve.strain[i]) - curve.stress[i];
        below > 0) {
      curve.stress[i] += below;
      if (below > largest) {
        largest = below;
        at = curve.strain[i];
      }
    }
  if (largest > 0)
    differences.push_back(fmt::format(
        "{}: the curve lay below the one for the next lower rate, by up to {:.3g} kPa at a strain of {:.3g}, "
        "and was raised to meet it.",
        curve.name, kpa(largest), at));
}

}  // namespace dashpad::input
