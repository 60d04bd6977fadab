// Curves out of a compression test: the loading along the largest strain so far, made to rise within its
// noise, and the way back from the largest strain.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/material_deck/test_parts.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_bins = 200;     // of noisy strains
constexpr std::size_t points_of_bin = 5;  // at least, on average
constexpr double plateau_share = 0.02;  // of the largest strain: a shorter one is noise, and becomes a point
constexpr double softening_share = 0.02;  // of the largest stress: a smaller change is noise
constexpr std::size_t few_falls = 3;      // more of them, if small, are noise

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

/// How often the stress falls, each time for one or more points.
std::size_t falls_of(const std::vector<double>& stress) {
  std::size_t falls = 0;
  for (std::size_t i = 1; i < stress.size(); ++i)
    if (stress[i] < stress[i - 1] && (i == 1 || stress[i - 1] >= stress[i - 2])) ++falls;
  return falls;
}

std::string words_on_outlier(const DeckCurve& test, std::size_t outlier) {
  const std::vector<double>& strain = test.strain;
  return fmt::format(
      "the strain on line {}, {:.3g}, is far from those beside it, {:.3g} and {:.3g}; if it is wrong, remove "
      "the "
      "line, since {}.",
      test.lines[outlier], strain[outlier], strain[outlier - 1], strain[outlier + 1],
      strain[outlier] > strain[outlier - 1] ? "all smaller strains behind it were left out"
                                            : "it passes for a cycle");
}

std::string words_on_hold(const DeckCurve& test, const Hold& hold) {
  return fmt::format(
      "from line {} {}, the strain is held and the stress relaxes by {:.2g} %; these points were left out, "
      "but "
      "dashpad fit uses them.",
      test.lines[hold.first],
      hold.last + 1 < test.lines.size() ? fmt::format("to {}", test.lines[hold.last]) : "on",
      100 * hold.lost);
}

void tell_of_parts(const DeckCurve& test, const TestParts& parts, std::vector<std::string>& differences) {
  const auto say = [&](const std::string& what) {
    differences.push_back(fmt::format("{}: {}", test.name, what));
  };
  if (parts.outlier) say(words_on_outlier(test, *parts.outlier));
  const bool is_cycle_of_outlier =
      parts.outlier && parts.cycle && (*parts.cycle == *parts.outlier || *parts.cycle + 1 == *parts.outlier);
  if (parts.cycle && !is_cycle_of_outlier)
    say(fmt::format(
        "the strain reverses on line {} and rises again; points below the largest strain reached so far "
        "were left out, but dashpad fit uses them.",
        test.lines[*parts.cycle]));
  else if (!parts.cycle && !parts.back.empty())
    say(fmt::format("the strain reverses on line {}, where unloading begins.", test.lines[parts.top]));
  for (const Hold& hold : parts.holds) say(words_on_hold(test, hold));
}

}  // namespace

MeasuredCurves curves_of_test(const DeckCurve& test, bool is_slowest, std::vector<std::string>& differences) {
  MeasuredCurves curves;
  const auto say = [&](const std::string& what) {
    differences.push_back(fmt::format("{}: {}", test.name, what));
  };
  const TestParts parts = parts_of(test);
  tell_of_parts(test, parts, differences);
  curves.loading = sorted_points(test, parts.loading, parts.noisy > 0);
  if (parts.noisy > 0 || curves.loading.strain.size() < parts.loading.size())
    say(fmt::format("{} of the loading curve were averaged into {}.", plural(parts.loading.size(), "point"),
                    curves.loading.strain.size()));
  if (is_slowest) {
    Moved moved;
    const double top = std::ranges::max(curves.loading.stress);
    const std::size_t falls = falls_of(curves.loading.stress);
    curves.loading = risen(curves.loading, moved);
    if (moved.largest > softening_share * top ||
        (moved.largest > 0 && falls <= few_falls && parts.noisy == 0))
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
    say(fmt::format("{} before the first positive strain and stress {} left out.", plural(slack, "point"),
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
