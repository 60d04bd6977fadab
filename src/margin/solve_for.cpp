#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include <boost/math/tools/roots.hpp>

#include "dashpad/margin/margin.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "injury/short_spike.hpp"
#include "margin/crossings.hpp"
#include "margin/evaluation.hpp"
#include "margin/sampled_curve.hpp"

namespace dashpad::margin {

namespace {

/// An end of the intervals moved by less than this share of its value is found.
constexpr double end_precision = 5e-3;
constexpr int max_moves = 4;
/// Excesses beyond it are not drawn across zero by any interval that was seen.
constexpr double far_from_limit = 1.5;
constexpr std::size_t spread_looks = 3;
/// After so many impacts only what is unsettled is looked at again.
constexpr std::uint64_t enough_impacts = 125;

enum class Which { excess, low, high };

/// The range of the key, and places of it from 0 to 1.
struct Range {
  double low, high;
  bool logarithmic;

  [[nodiscard]] double value_at(double place) const {
    if (place <= 0 || place >= 1) return place <= 0 ? low : high;
    return logarithmic ? low * std::pow(high / low, place) : low + (high - low) * place;
  }
  [[nodiscard]] double place_of(double value) const {
    return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  }
};

class Solving {
 public:
  Solving(const Question& question, const Progress& progress)
      : range_{question.low, question.high, question.logarithmic}, progress_(progress), impacts_(question) {
    answer_.question = question;
    answer_.limits = limits_of(question);
    // What has no interval is not certain anywhere.
    for (const Limit& limit : answer_.limits)
      if (answer_.question.intervals && !question.chance && !limit.figure->has_interval()) {
        answer_.reservations.push_back(flag_of(
            "NO INTERVALS",
            title_in_sentence(*limit.figure) + " has no interval for the uncertainty of foam and model"));
        answer_.question.intervals = false;
      }
  }

  Answer run() {
    const auto begin = std::chrono::steady_clock::now();
    search();
    if (has_intervals()) find_intervals();
    add_reservations();
    add_kept();
    add_stretches();
    for (std::size_t i = 0; i < answer_.places.size(); ++i)
      if (const double excess = answer_.places[i].excess;
          !std::isnan(excess) &&
          (!answer_.nearest || is_nearer(answer_.places[i], answer_.places[*answer_.nearest])))
        answer_.nearest = i;
    answer_.doubtful =
        static_cast<std::size_t>(std::ranges::count(answer_.places, true, &Place::is_doubtful));
    if (answer_.question.chance) add_contributors();
    answer_.impacts += impacts_.solved();
    answer_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(answer_);
  }

 private:
  /// Of draws the share that passes counts, which quantiles of a few of them tell less well.
  [[nodiscard]] bool is_nearer(const Place& one, const Place& other) const {
    if (answer_.question.chance && one.share != other.share) return one.share > other.share;
    return one.excess < other.excess;
  }
  [[nodiscard]] bool has_intervals() const { return answer_.question.chance || answer_.question.intervals; }

  const Place& look(double value, bool intervals = false) {
    tell();
    std::vector<Place>& places = answer_.places;
    const auto at = std::ranges::lower_bound(places, value, {}, &Place::value);
    const bool is_known = at != places.end() && at->value == value;
    if (is_known && (!intervals || has_interval(*at))) return *at;
    Place place;
    if (answer_.question.chance) {
      place = place_of(answer_.question, value, draws_at(answer_.question, value));
      answer_.impacts += answer_.question.chance->draws * answer_.question.impacts.size();
    } else {
      place = impacts_.look(value, intervals);
      if (intervals) with_interval_.push_back(value);
    }
    ++looks_;
    if (!is_known) return *places.insert(at, std::move(place));
    *at = std::move(place);
    return *at;
  }
  [[nodiscard]] bool has_interval(const Place& place) const {
    return answer_.question.chance.has_value() ||
           std::ranges::find(with_interval_, place.value) != with_interval_.end();
  }
  [[nodiscard]] bool knows_interval_at(double value) const {
    return std::ranges::any_of(answer_.places, [&](const Place& place) {
      return std::abs(place.value - value) <= end_precision * std::abs(value) && has_interval(place);
    });
  }
  void tell() const {
    // The first looks, at the ends of the range, are no measure of the others.
    constexpr double first_looks = 12;
    if (!progress_ || looks_ < first_looks) return;
    const double expected = answer_.question.chance ? 30 : 60;
    if (!progress_(std::min(looks_ / expected, 0.99))) throw std::runtime_error("stopped");
  }

  void search() {
    const bool draws = answer_.question.chance.has_value();
    // A quantile of draws has a corner where another draw takes its place: its bends tell nothing below a
    // step.
    SearchSettings settings = draws ? SearchSettings{.grid = 12,
                                                     .max_looks = 40,
                                                     .precision = 1e-3,
                                                     .shortest = 1.0 / 150,
                                                     .caution = 8}
                                    : SearchSettings{.grid = 20, .max_looks = 90};
    settings.noise =
        study_of(answer_.question, answer_.question.impacts.front(), {range_.low}).options.tolerance;
    const CurvesAt curves_at = [&](double at) {
      const Place& place = look(range_.value_at(at));
      if (draws) return std::vector{place.excess};
      std::vector<double> curves;
      for (std::size_t i = 0; i < answer_.limits.size(); ++i)
        curves.push_back(excess_of(answer_.limits[i], place.figures[i]));
      return curves;
    };
    CrossingSearch found = find_crossings(curves_at, settings);
    answer_.is_complete = found.is_complete;
    gaps_ = std::move(found.gaps);
    for (const Crossing& crossing : found.crossings) {
      const double before = range_.value_at(crossing.before), after = range_.value_at(crossing.after);
      Turn turn{.value = range_.value_at(crossing.place),
                .precision = (after - before) / 2,
                .passes_above = !crossing.rises,
                .jumps = crossing.jumps};
      // A share of draws is to be reached, not nearly so.
      if (draws) turn.value = crossing.rises ? before : after;
      turn.limit = look(crossing.rises ? after : before).worst;
      answer_.turns.push_back(turn);
    }
  }

  /// The curve at a place from 0 to 1: of the excess itself between all places looked at, the ends of
  /// intervals from it by their distance, which changes less.
  class Curve {
   public:
    Curve(const Solving& solving, Which which) {
      for (const Place& place : solving.answer_.places) {
        const double at = solving.range_.place_of(place.value);
        excess_.push_back({at, place.excess});
        if (which != Which::excess && solving.has_interval(place) && std::isfinite(place.excess))
          distance_.push_back({at, (which == Which::high ? place.high : place.low) - place.excess});
      }
    }
    [[nodiscard]] double operator()(double place) const {
      const double excess = height_at(excess_, place);
      return distance_.empty() || !std::isfinite(excess) ? excess : excess + height_at(distance_, place);
    }

   private:
    std::vector<Point> excess_, distance_;
  };

  struct End {
    double value;
    bool rises;
  };
  /// Where a curve crosses zero, by the places looked at so far. Next to a place where it is infinite nothing
  /// tells how far: halfway, or, if that is to be the `last` word, where it is finite.
  [[nodiscard]] std::vector<End> ends_of(Which which, bool last) const {
    const std::vector<Place>& places = answer_.places;
    const Curve curve(*this, which);
    std::vector<End> ends;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      double a = range_.place_of(places[i].value), b = range_.place_of(places[i + 1].value);
      const double from = curve(a), to = curve(b);
      if (std::isnan(from) || std::isnan(to) || (from > 0) == (to > 0)) continue;
      if (std::isfinite(from) && std::isfinite(to)) {
        std::uintmax_t most = 60;
        std::tie(a, b) =
            boost::math::tools::bisect([&](double place) { return curve(place) > 0 ? 1.0 : -1.0; }, a, b,
                                       [](double low, double high) { return high - low < 1e-9; }, most);
      } else if (last) {
        (std::isfinite(to) ? a : b) = std::isfinite(to) ? b : a;
      }
      ends.push_back({range_.value_at((a + b) / 2), to > from});
    }
    return ends;
  }
  /// The same, each looked at until it stays in its place.
  std::vector<End> settled_ends(Which which) {
    const int moves = !answer_.question.chance && impacts_.solved() > enough_impacts ? 2 : max_moves;
    for (int move = 0; move < moves; ++move) {
      std::vector<End> ends = ends_of(which, false);
      std::erase_if(ends, [this](const End& end) { return knows_interval_at(end.value); });
      if (ends.empty()) break;
      for (const End& end : ends) look(end.value, true);
    }
    std::vector<End> ends = ends_of(which, true);
    // What is certain begins where it is found to be, and not as much before it as an end is known.
    if (which == Which::high && !answer_.question.chance)
      for (End& end : ends) end.value *= end.rises == (end.value > 0) ? 1 - end_precision : 1 + end_precision;
    return ends;
  }

  void find_intervals() {
    if (!answer_.question.chance) {
      for (const Turn& turn : answer_.turns) look(turn.value, true);
      std::vector<double> values;
      for (const Place& place : answer_.places)
        if (std::abs(place.excess) < far_from_limit) values.push_back(place.value);
      const std::size_t count = std::min(values.size(), spread_looks);
      for (std::size_t i = 0; i < count; ++i)
        if (const double value = values[count == 1 ? 0 : i * (values.size() - 1) / (count - 1)];
            !knows_interval_at(value))
          look(value, true);
    }
    high_ends_ = settled_ends(Which::high);
    low_ends_ = settled_ends(Which::low);
    if (look_into_long_undecided()) {
      high_ends_ = settled_ends(Which::high);
      low_ends_ = settled_ends(Which::low);
    }
    for (Turn& turn : answer_.turns) {
      // Below a turn that passes above, the first end at or below it; above it the first at or above.
      const auto nearest = [&](const std::vector<End>& ends, bool above) {
        double value = above ? infinite : -infinite;
        for (const End& end : ends) {
          const bool is_beyond =
              above ? end.value >= turn.value - turn.precision : end.value <= turn.value + turn.precision;
          if (end.rises == !turn.passes_above && is_beyond)
            value = above ? std::min(value, end.value) : std::max(value, end.value);
        }
        return value;
      };
      turn.interval = turn.passes_above ? std::pair(nearest(low_ends_, false), nearest(high_ends_, true))
                                        : std::pair(nearest(high_ends_, false), nearest(low_ends_, true));
    }
  }

  /// Between places whose intervals are known, one may be wide and the other narrow: the middle tells.
  bool look_into_long_undecided() {
    constexpr double long_stretch = 0.1;
    if (answer_.question.chance || impacts_.solved() > 2 * enough_impacts) return false;
    std::vector<double> bounds{0, 1};
    for (const std::vector<End>* ends : {&high_ends_, &low_ends_})
      for (const End& end : *ends) bounds.push_back(range_.place_of(end.value));
    std::ranges::sort(bounds);
    const Curve low(*this, Which::low), high(*this, Which::high);
    bool has_looked = false;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const double middle = (bounds[i] + bounds[i + 1]) / 2;
      if (bounds[i + 1] - bounds[i] < long_stretch || zone_at(middle, low, high) != Zone::undecided) continue;
      look(range_.value_at(middle), true);
      has_looked = true;
    }
    return has_looked;
  }

  /// The verdicts of the figures themselves.
  void add_kept() {
    std::vector<double> bounds{answer_.question.low, answer_.question.high};
    for (const Turn& turn : answer_.turns) bounds.push_back(turn.value);
    add_zones(bounds, Which::excess, Which::excess, answer_.kept);
  }
  void add_stretches() {
    std::vector<double> bounds{answer_.question.low, answer_.question.high};
    if (has_intervals()) {
      for (const End& end : high_ends_) bounds.push_back(end.value);
      for (const End& end : low_ends_) bounds.push_back(end.value);
    } else {
      for (const Turn& turn : answer_.turns) bounds.push_back(turn.value);
    }
    add_zones(bounds, has_intervals() ? Which::low : Which::excess,
              has_intervals() ? Which::high : Which::excess, answer_.stretches);
  }
  void add_zones(std::vector<double> bounds, Which low, Which high, std::vector<Stretch>& stretches) const {
    for (const Gap& gap : gaps_) {
      bounds.push_back(range_.value_at(gap.from));
      bounds.push_back(range_.value_at(gap.to));
    }
    std::ranges::sort(bounds);
    const Curve low_end(*this, low), high_end(*this, high);
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
      const double from = bounds[i], to = bounds[i + 1];
      if (!(to - from > 1e-9 * std::abs(to))) continue;
      const Zone zone = zone_at((range_.place_of(from) + range_.place_of(to)) / 2, low_end, high_end);
      if (!stretches.empty() && stretches.back().zone == zone)
        stretches.back().to = to;
      else
        stretches.push_back({from, to, zone});
    }
  }
  [[nodiscard]] Zone zone_at(double place, const Curve& low_end, const Curve& high_end) const {
    if (std::ranges::any_of(gaps_, [&](const Gap& gap) { return place > gap.from && place < gap.to; }))
      return Zone::unknown;
    const double high = high_end(place), low = low_end(place);
    if (std::isnan(high) || std::isnan(low)) return Zone::fail;
    return high <= 0 ? Zone::pass : low > 0 ? Zone::fail : Zone::undecided;
  }

  /// Those at the first turn, or at the place that comes nearest.
  void add_reservations() {
    double at = answer_.turns.empty() ? no_value : answer_.turns.front().value;
    if (answer_.turns.empty()) {
      double least = infinite;
      for (const Place& place : answer_.places)
        if (place.excess < least) least = place.excess, at = place.value;
    }
    if (std::isnan(at)) return;
    const std::vector<Flag> found = answer_.question.chance
                                        ? impacts_.look(at, false).reservations
                                        : look(at, answer_.question.intervals).reservations;
    answer_.reservations.insert(answer_.reservations.end(), found.begin(), found.end());
    add_short_spike();
    // Draws take the place of intervals.
    if (answer_.question.chance)
      std::erase_if(answer_.reservations, [](const Flag& flag) { return flag.name == "NO INTERVALS"; });
  }

  /// Of the places that pass that with the highest spike which no limit sees, wherever it is: the first turn
  /// may be free of it.
  void add_short_spike() {
    const Flag* highest = nullptr;
    for (const Place& place : answer_.places)
      if (const Flag* spike = spike_unseen_at(place);
          spike != nullptr &&
          (highest == nullptr || spike->figures.front().value > highest->figures.front().value))
        highest = spike;
    if (highest == nullptr) return;
    std::erase_if(answer_.reservations,
                  [](const Flag& flag) { return flag.name == injury::short_spike_name; });
    answer_.reservations.push_back(*highest);
  }

  void add_contributors() {
    if (!answer_.nearest) return;
    const Question& question = answer_.question;
    const double value =
        answer_.turns.empty() ? answer_.places[*answer_.nearest].value : answer_.turns.front().value;
    answer_.contributors = contributors_of(question, value, draws_at(question, value));
    answer_.impacts += question.chance->draws * question.impacts.size();
  }

  Range range_;
  const Progress& progress_;
  Answer answer_;
  Impacts impacts_;
  std::vector<double> with_interval_;
  std::vector<Gap> gaps_;
  std::vector<End> high_ends_, low_ends_;
  double looks_ = 0;
};

}  // namespace

Answer solve_for(const Question& question, const Progress& progress) {
  return Solving(question, progress).run();
}

}  // namespace dashpad::margin
