#include "input/material_deck/test_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dashpad::input {

namespace {

constexpr double turn_share = 0.01;      // of the largest strain: a shorter way back is noise
constexpr double fall_at_turn = 0.1;     // of the stress: less, without noise, is softening
constexpr double hold_share = 0.005;     // of the largest strain: the noise of a strain that is held
constexpr double same_share = 1e-4;      // of the largest strain: equal but for rounding
constexpr double relaxing_share = 0.02;  // of the stress, lost at a constant strain
constexpr std::size_t points_of_hold = 3, points_of_noisy_hold = 20;  // at least
constexpr double outlying_steps = 10, steps_between_neighbours = 3;   // median ones

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::optional<std::size_t> outlier_of(const std::vector<double>& strain) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < strain.size(); ++i)
    if (strain[i] != strain[i - 1]) steps.push_back(std::abs(strain[i] - strain[i - 1]));
  if (steps.empty()) return std::nullopt;
  const double step = median_of(std::move(steps));
  std::optional<std::size_t> outlier;
  double farthest = outlying_steps * step;
  for (std::size_t i = 1; i + 1 < strain.size(); ++i) {
    const double before = strain[i] - strain[i - 1], behind = strain[i] - strain[i + 1];
    const double distance = std::min(std::abs(before), std::abs(behind));
    const bool is_peak = before * behind > 0 && std::abs(before - behind) <= steps_between_neighbours * step;
    if (!is_peak || distance <= farthest) continue;
    farthest = distance;
    outlier = i;
  }
  return outlier;
}

/// Finds holds along the loading.
class HoldSearch {
 public:
  explicit HoldSearch(const DeckCurve& test)
      : strain_(test.strain), stress_(test.stress), largest_(std::ranges::max(test.strain)) {
    for (std::size_t i = 1; i < strain_.size(); ++i)
      if (strain_[i] != strain_[i - 1]) ++changes_;
  }

  [[nodiscard]] std::vector<Hold> holds() const {
    std::vector<Hold> found;
    const double noise = hold_share * largest_;
    double reached = -1;
    for (std::size_t i = 0; i < strain_.size(); ++i) {
      if (!(strain_[i] > reached)) continue;
      std::size_t end = i + 1;
      while (end < strain_.size() && std::abs(strain_[end] - strain_[i]) <= noise) ++end;
      reached = strain_[i] + noise / 4;  // so that each point is looked at a few times only
      if (const auto hold = hold_in(i, end)) {
        found.push_back(*hold);
        i = hold->last;
      }
    }
    return found;
  }

 private:
  /// The hold among points of about one strain, from `begin` to before `end`.
  [[nodiscard]] std::optional<Hold> hold_in(std::size_t begin, std::size_t end) const {
    const auto at = [&](std::size_t i) { return stress_.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto first = static_cast<std::size_t>(std::max_element(at(begin), at(end)) - stress_.begin());
    std::size_t same = first + 1;
    while (same < end && std::abs(strain_[same] - strain_[first]) <= same_share * largest_) ++same;
    const auto points = static_cast<double>(strain_.size());
    const bool is_long =
        same - first >= points_of_hold && static_cast<double>((same - first) * (changes_ + 1)) > 2 * points;
    const bool is_noisy = !is_long && is_level(first, end) && end - first >= points_of_noisy_hold &&
                          static_cast<double>(end - first) > 8 * hold_share * points;
    const std::size_t behind = is_long ? same : end;
    const double lost = 1 - *std::min_element(at(first), at(behind)) / stress_[first];
    if (!(is_long || is_noisy) || !(stress_[first] > 0) || !(lost > relaxing_share)) return std::nullopt;
    return Hold{first, behind - 1, lost};
  }

  /// Whether the strain does not go on but for its noise.
  [[nodiscard]] bool is_level(std::size_t begin, std::size_t end) const {
    const auto at = [&](std::size_t i) { return strain_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = (end - begin) / 2;
    if (half == 0) return false;
    const double change = std::reduce(at(end - half), at(end)) - std::reduce(at(begin), at(begin + half));
    return std::abs(change) <= hold_share / 4 * largest_ * static_cast<double>(half);
  }

  const std::vector<double>&strain_, &stress_;
  double largest_;
  std::size_t changes_ = 0;  ///< of the strain, from point to point
};

/// Follows the largest strain so far. Once the strain has turned back, it goes on only beyond the noise:
/// later cycles to the same strain do not belong to the first loading.
class FirstLoading {
 public:
  FirstLoading(const DeckCurve& test, TestParts& parts)
      : strain_(test.strain),
        stress_(test.stress),
        parts_(parts),
        turn_(turn_share * std::ranges::max(test.strain)) {}

  void add(std::size_t point) {
    const double strain = strain_[point];
    if (has_turned_) {
      if (strain <= most_ - turn_) return ahead_.clear();
      if (strain > most_) ahead_.push_back(point);
      if (strain > most_ + turn_) go_on();
    } else if (strain <= most_ - turn_) {
      end();
      drop_unloading();
      has_turned_ = true;
      if (!first_turn_) first_turn_ = parts_.top;
    } else {
      take(point);
    }
  }

  /// Drops what lies behind the largest strain.
  void end() {
    for (; !parts_.loading.empty() && parts_.loading.back() != parts_.top; --parts_.noisy)
      parts_.loading.pop_back();
  }

 private:
  void take(std::size_t point) {
    if (strain_[point] == most_) return;
    parts_.loading.push_back(point);
    if (strain_[point] < most_) {
      ++parts_.noisy;
    } else {
      most_ = strain_[point];
      parts_.top = point;
    }
  }

  /// Noise may give the first points of the way back the largest strains; their stress tells them.
  void drop_unloading() {
    std::vector<std::size_t>& loading = parts_.loading;
    const auto is_earlier = [&](std::size_t point) { return strain_[point] <= most_ - turn_; };
    const auto near_top = std::find_if(loading.rbegin(), loading.rend(), is_earlier).base();
    const auto stress_at = [&](std::size_t point) { return stress_[point]; };
    const auto turn = std::ranges::max_element(near_top, loading.end(), {}, stress_at);
    if (parts_.noisy == 0 && stress_[parts_.top] > (1 - fall_at_turn) * stress_[*turn]) return;
    loading.erase(turn + 1, loading.end());
    parts_.top = loading.back();
  }

  void go_on() {
    if (!parts_.cycle) parts_.cycle = first_turn_;
    has_turned_ = false;
    for (const std::size_t point : ahead_) take(point);
    ahead_.clear();
  }

  const std::vector<double>&strain_, &stress_;
  TestParts& parts_;
  double turn_;
  double most_ = -1;
  bool has_turned_ = false;
  std::optional<std::size_t> first_turn_;
  std::vector<std::size_t> ahead_;  ///< points beyond the largest strain after a turn, perhaps by noise
};

/// The way back from the largest strain, up to where the strain rises again.
void find_way_back(const std::vector<double>& strain, const std::vector<bool>& is_held, TestParts& parts) {
  const double turn = turn_share * std::ranges::max(strain);
  double least = strain[parts.top];
  for (std::size_t i = parts.top + 1; i < strain.size(); ++i) {
    if (is_held[i]) continue;
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
}

}  // namespace

TestParts parts_of(const DeckCurve& test) {
  TestParts parts;
  parts.outlier = outlier_of(test.strain);
  parts.holds = HoldSearch(test).holds();
  std::vector<bool> is_held(test.strain.size());
  for (const Hold& hold : parts.holds)
    for (std::size_t i = hold.first + 1; i <= hold.last; ++i) is_held[i] = true;
  FirstLoading loading(test, parts);
  for (std::size_t i = 0; i < test.strain.size(); ++i)
    if (!is_held[i]) loading.add(i);
  loading.end();
  find_way_back(test.strain, is_held, parts);
  return parts;
}

}  // namespace dashpad::input
