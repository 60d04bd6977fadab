#include "margin/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <boost/math/tools/toms748_solve.hpp>

#include "dashpad/quantities/constants.hpp"

namespace dashpad::margin {

namespace {

/// A curve that changes by more than this within the precision of a place jumps.
constexpr double jump = 0.02;
/// In place of an infinite excess, so that interpolation stays possible.
constexpr double beyond_all = 20;

enum class Side { kept, exceeded, unknown };
Side side_of(const Look& look) {
  const double worst = look.worst();
  return std::isnan(worst) ? Side::unknown : worst > 0 ? Side::exceeded : Side::kept;
}

class Search {
 public:
  Search(const CurvesAt& curves_at, const SearchSettings& settings, std::vector<Look> known)
      : curves_at_(curves_at), settings_(settings) {
    result_.looks = std::move(known);
    for (int i = 0; i <= settings.grid; ++i) look(static_cast<double>(i) / settings.grid);
    // Second differences of the first and the last step have one neighbour only.
    for (const double half : {0.5 / settings.grid, 1 - 0.5 / settings.grid}) look(half);
  }

  CrossingSearch run() {
    // A change of sign may hide two more: what its search has looked at tells.
    do {
      divide_where_two_may_hide();
      find_ends_of_gaps();
    } while (close_in_on_a_change());
    list_gaps();
    for (std::size_t i = 0; i + 1 < result_.looks.size(); ++i)
      if (changes_side(i)) result_.crossings.push_back(crossing_at(i));
    return std::move(result_);
  }

 private:
  const Look& look(double place) {
    const auto known = std::ranges::lower_bound(result_.looks, place, {}, &Look::place);
    if (known != result_.looks.end() && known->place == place) return *known;
    Look look{.place = place, .curves = curves_at_(place)};
    return *result_.looks.insert(known, std::move(look));
  }

  /// Half the second derivative of a curve between two neighbours, by a third place on either side that is
  /// not much nearer than they are: the noise of a solver would hide it. 0 without values.
  [[nodiscard]] double bend(std::size_t left, std::size_t curve) const {
    const std::vector<Look>& looks = result_.looks;
    const double apart = length_of(left) / 4;
    std::size_t before = left, behind = left + 1;
    while (before > 0 && looks[left].place - looks[before].place < apart) --before;
    while (behind + 1 < looks.size() && looks[behind].place - looks[left + 1].place < apart) ++behind;
    double largest = 0;
    const auto add = [&](const Look& a, const Look& b, const Look& c) {
      const double first = (b.curves[curve] - a.curves[curve]) / (b.place - a.place);
      const double second = (c.curves[curve] - b.curves[curve]) / (c.place - b.place);
      const double bend = std::abs(second - first) / (c.place - a.place);
      if (std::isfinite(bend)) largest = std::max(largest, bend);
    };
    if (before < left) add(looks[before], looks[left], looks[left + 1]);
    if (behind > left + 1) add(looks[left], looks[left + 1], looks[behind]);
    return largest;
  }

  /// Whether a parabola that sags by `room` below its chord comes down to zero between two heights above it.
  static bool may_reach_zero(double from, double to, double room) {
    const double roots = std::sqrt(from) + std::sqrt(to);
    return 4 * room > roots * roots;
  }
  /// Whether the worst curve may leave its side and come back between two neighbours of the same side.
  [[nodiscard]] bool may_hide_two(std::size_t left) const {
    const Look &a = result_.looks[left], &b = result_.looks[left + 1];
    const double length = b.place - a.place;
    const Side side = side_of(a);
    if (length < settings_.shortest || side != side_of(b) || side == Side::unknown) return false;
    if (std::max(std::abs(a.worst()), std::abs(b.worst())) < settings_.noise) return false;
    bool all_may_be_kept = true;
    for (std::size_t curve = 0; curve < a.curves.size(); ++curve) {
      const double from = a.curves[curve], to = b.curves[curve];
      if (!std::isfinite(from) || !std::isfinite(to)) {
        // Beyond all limits at one end: nothing tells how far it comes down, until the stretch is short.
        all_may_be_kept =
            all_may_be_kept && length > 4 * settings_.shortest && (std::isfinite(from) || std::isfinite(to));
        continue;
      }
      const double room = settings_.caution * bend(left, curve) * length * length / 4;
      if (side == Side::kept && may_reach_zero(-from, -to, room)) return true;
      all_may_be_kept = all_may_be_kept && (from <= 0 || to <= 0 || may_reach_zero(from, to, room));
    }
    return side == Side::exceeded && all_may_be_kept;
  }

  /// The top or bottom of the parabola through a stretch and its neighbour, if it lies well inside; else the
  /// middle.
  [[nodiscard]] double place_within(std::size_t left) const {
    const Look &a = result_.looks[left], &b = result_.looks[left + 1];
    const double middle = (a.place + b.place) / 2, length = b.place - a.place;
    const std::size_t third = left > 0 ? left - 1 : left + 2;
    if (third >= result_.looks.size()) return middle;
    const Look& c = result_.looks[third];
    const double ya = a.worst(), yb = b.worst(), yc = c.worst();
    const double slope = (yb - ya) / length;
    const double curvature = ((yc - yb) / (c.place - b.place) - slope) / (c.place - a.place);
    const double top = middle - slope / (2 * curvature);
    return std::abs(top - middle) < 0.35 * length ? top : middle;
  }

  void divide_where_two_may_hide() {
    while (true) {
      std::optional<std::size_t> longest;
      for (std::size_t i = 0; i + 1 < result_.looks.size(); ++i)
        if (may_hide_two(i) && (!longest || length_of(i) > length_of(*longest))) longest = i;
      if (!longest) return;
      if (result_.looks.size() >= static_cast<std::size_t>(settings_.max_looks)) {
        result_.is_complete = false;
        return;
      }
      look(place_within(*longest));
    }
  }
  [[nodiscard]] double length_of(std::size_t left) const {
    return result_.looks[left + 1].place - result_.looks[left].place;
  }

  /// Halves the stretches between a place with a value and one without.
  void find_ends_of_gaps() {
    constexpr double close_enough = 1.0 / 1000;
    for (std::size_t i = 0; i + 1 < result_.looks.size();) {
      const bool one_is_unknown =
          (side_of(result_.looks[i]) == Side::unknown) != (side_of(result_.looks[i + 1]) == Side::unknown);
      if (one_is_unknown && length_of(i) > close_enough)
        look((result_.looks[i].place + result_.looks[i + 1].place) / 2);
      else
        ++i;
    }
  }
  void list_gaps() {
    double last = 0;
    bool is_in_gap = false;
    for (const Look& look : result_.looks) {
      const bool is_unknown = side_of(look) == Side::unknown;
      if (is_unknown && !is_in_gap) result_.gaps.push_back({last, 1});
      if (!is_unknown && is_in_gap) result_.gaps.back().to = look.place;
      if (!is_unknown) last = look.place;
      is_in_gap = is_unknown;
    }
  }

  [[nodiscard]] bool changes_side(std::size_t left) const {
    const Side one = side_of(result_.looks[left]), other = side_of(result_.looks[left + 1]);
    return one != other && one != Side::unknown && other != Side::unknown;
  }

  /// Looks between two neighbours of different sides until they are within the precision. False if there are
  /// none farther apart.
  bool close_in_on_a_change() {
    for (std::size_t i = 0; i + 1 < result_.looks.size(); ++i) {
      if (!changes_side(i) || length_of(i) <= settings_.precision) continue;
      if (result_.looks.size() >= 2 * static_cast<std::size_t>(settings_.max_looks)) {
        result_.is_complete = false;
        return false;
      }
      const double a = result_.looks[i].place, b = result_.looks[i + 1].place;
      const double at_a = height_of(result_.looks[i]), at_b = height_of(result_.looks[i + 1]);
      const auto is_close = [this](double low, double high) { return high - low <= settings_.precision; };
      std::uintmax_t most = 60;
      if (at_a == 0 || at_b == 0) {
        // The limit itself, which is kept: what is beside it tells on which side it is left.
        look(at_a == 0 ? std::min(a + settings_.precision / 2, b) : std::max(b - settings_.precision / 2, a));
      } else {
        const auto [low, high] = boost::math::tools::toms748_solve(
            [this](double place) { return height_of(look(place)); }, a, b, at_a, at_b, is_close, most);
        if (low == high) look(at_a > 0 ? low - settings_.precision / 2 : low + settings_.precision / 2);
      }
      return true;
    }
    return false;
  }
  /// What a change of sign is looked for by. A place without a value counts as exceeded: the end of what can
  /// be kept is wanted.
  static double height_of(const Look& look) {
    const double worst = look.worst();
    return std::isnan(worst) ? beyond_all : std::clamp(worst, -beyond_all, beyond_all);
  }

  [[nodiscard]] Crossing crossing_at(std::size_t left) const {
    const Look &a = result_.looks[left], &b = result_.looks[left + 1];
    const double at_a = height_of(a), change = height_of(b) - at_a;
    const bool jumps = std::abs(change) > jump;
    return {.before = a.place,
            .after = b.place,
            .place = jumps ? (a.place + b.place) / 2 : a.place - at_a * length_of(left) / change,
            .rises = change > 0,
            .jumps = jumps};
  }

  const CurvesAt& curves_at_;
  SearchSettings settings_;
  CrossingSearch result_;
};

}  // namespace

double Look::worst() const {
  double largest = -infinite;
  bool has_gap = false;
  for (const double curve : curves) {
    has_gap = has_gap || std::isnan(curve);
    largest = std::max(largest, curve);  // leaves NaN out
  }
  return has_gap && !(largest > 0) ? std::numeric_limits<double>::quiet_NaN() : largest;
}

CrossingSearch find_crossings(const CurvesAt& curves_at, const SearchSettings& settings,
                              std::vector<Look> known) {
  return Search(curves_at, settings, std::move(known)).run();
}

}  // namespace dashpad::margin
