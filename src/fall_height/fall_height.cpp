// Critical fall heights of limits and places.

#include "dashpad/fall_height/fall_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "input/measurement/csv_table.hpp"
#include "quantities/text.hpp"

namespace dashpad::fall_height {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double same_height = 1e-6;  // relative
/// How far beyond the drops a curve is followed, as a ratio of heights, and in how many steps.
constexpr double max_ratio = 2;
constexpr int steps = 400;
/// The share of the height by which a drop may lie on the wrong side of it.
constexpr double scatter = 0.1;
/// Largest logarithm of the ratio of two heights that are near each other.
constexpr double nearness = 0.35;

bool keeps(const injury::Criterion& criterion, double value) {
  return criterion.strict ? value < criterion.limit : value <= criterion.limit;
}

/// The mean of the counted drops of each height; of a height without all of them that of all its drops, with
/// a flag. Without a series each drop is a point.
std::vector<Point> points_of(Place& place, std::size_t criterion, const std::vector<int>& counted) {
  std::vector<Point> points;
  std::string uncounted;
  for (std::size_t begin = 0, end = 0; begin < place.drops.size(); begin = end) {
    const double height = place.drops[begin].height;
    std::vector<double> values, chosen;
    while (end < place.drops.size() && place.drops[end].height <= height * (1 + same_height)) {
      const Drop& drop = place.drops[end++];
      const double value = drop.figures[criterion];
      if (!std::isfinite(value)) continue;
      values.push_back(value);
      if (std::ranges::find(counted, drop.number) != counted.end()) chosen.push_back(value);
    }
    if (counted.empty()) {
      for (const double value : values) points.push_back({height, value});
      continue;
    }
    if (values.empty()) continue;
    if (chosen.size() != counted.size()) {
      uncounted += fmt::format("{}{:.4g} m", uncounted.empty() ? "" : ", ", height);
      chosen = values;
    }
    double mean = 0;
    for (const double value : chosen) mean += value / static_cast<double>(chosen.size());
    points.push_back({height, mean});
  }
  if (!uncounted.empty() &&
      std::ranges::find(place.flags, "DROPS NOT COUNTED", &Flag::name) == place.flags.end())
    place.flags.push_back(flag_of(
        "DROPS NOT COUNTED",
        fmt::format("the mean of drops {} counts; where these are missing or not unique, the mean of all "
                    "drops is used: at {}",
                    fmt::join(counted, " and "), uncounted)));
  return points;
}

/// The heights at which the curve is looked at, from low to high.
double height_of(const std::vector<Point>& points, int step) {
  const double low = points.front().height / max_ratio, high = points.back().height * max_ratio;
  return low * std::pow(high / low, static_cast<double>(step) / steps);
}

/// Where `is_above` turns between two heights.
template <class Above>
double turn_between(double low, double high, const Above& is_above) {
  const bool at_low = is_above(low);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (is_above(middle) == at_low ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// The first height at which the curve rises over the limit.
std::optional<double> first_rise(const std::vector<Point>& points, const Curve& curve, double limit) {
  const auto is_above = [&](double height) { return curve.at(height) > limit; };
  for (int i = 1; i <= steps; ++i) {
    const double from = height_of(points, i - 1), to = height_of(points, i);
    if (!is_above(from) && is_above(to)) return turn_between(from, to, is_above);
  }
  return std::nullopt;
}

/// From the height at which the curve meets the limit down and up to where it differs from the limit by half
/// its width and the doubt of the instrument, together.
std::pair<double, double> interval_about(const Crossing& crossing, double limit) {
  const auto may_be_above = [&](double height) {
    return std::log(crossing.curve->at(height) / limit) + crossing.half_width(height) > 0;
  };
  const auto is_surely_above = [&](double height) {
    return std::log(crossing.curve->at(height) / limit) - crossing.half_width(height) > 0;
  };
  std::pair<double, double> ends{0, infinite};
  double inner = *crossing.height;
  for (int i = steps; i >= 0 && ends.first == 0; --i) {
    const double outer = height_of(crossing.near, i);
    if (outer >= inner) continue;
    if (!may_be_above(outer)) ends.first = turn_between(outer, inner, may_be_above);
    inner = outer;
  }
  inner = *crossing.height;
  for (int i = 0; i <= steps && std::isinf(ends.second); ++i) {
    const double outer = height_of(crossing.near, i);
    if (outer <= inner) continue;
    if (is_surely_above(outer)) ends.second = turn_between(inner, outer, is_surely_above);
    inner = outer;
  }
  return ends;
}

/// The points near the height, if they are enough for a curve that bends; else all. Over a wide range the
/// figures of a foam follow no curve of three terms.
std::vector<Point> points_near(const Crossing& crossing) {
  if (!crossing.height) return crossing.points;
  std::vector<Point> near;
  std::size_t heights = 0, below = 0;
  for (const Point& point : crossing.points) {
    if (std::abs(std::log(point.height / *crossing.height)) > nearness) continue;
    if (near.empty() || point.height > near.back().height * (1 + same_height)) ++heights;
    if (point.height < *crossing.height) ++below;
    near.push_back(point);
  }
  const bool is_enough = near.size() > 5 && heights > 3 && below > 1 && near.size() - below > 1;
  return is_enough ? near : crossing.points;
}

Crossing crossing_of(Place& place, std::size_t which, const injury::Standard& standard) {
  const injury::Criterion& criterion = standard.criteria[which];
  Crossing crossing;
  crossing.criterion = which;
  crossing.points =
      points_of(place, which, standard.drop_series ? standard.drop_series->counted : std::vector<int>{});
  if (crossing.points.empty()) return crossing;
  double squares = 0, count = 0;
  for (const Drop& drop : place.drops)
    if (std::isfinite(drop.figures[which])) squares += drop.doubts[which] * drop.doubts[which], ++count;
  if (count > 0) crossing.doubt = std::sqrt(squares / count);
  for (const Point& point : crossing.points)
    (keeps(criterion, point.value) ? crossing.is_kept : crossing.is_exceeded) = true;
  crossing.near = crossing.points;
  crossing.curve = fitted(crossing.near);
  if (!crossing.curve) return crossing;
  crossing.height = first_rise(crossing.near, *crossing.curve, criterion.limit);
  if (std::vector<Point> nearest = points_near(crossing); nearest.size() < crossing.points.size()) {
    const std::optional<Curve> curve = fitted(nearest);
    if (const auto height = first_rise(nearest, *curve, criterion.limit)) {
      crossing.curve = curve, crossing.height = height;
      crossing.near = std::move(nearest);
    }
  }
  if (!crossing.height) return crossing;
  for (const Point& point : crossing.points) {
    const bool is_kept = keeps(criterion, point.value);
    if (is_kept && point.height <= *crossing.height) crossing.below = point.height;
    if (!is_kept && point.height >= *crossing.height && !crossing.above) crossing.above = point.height;
  }
  // The last drop may just exceed the limit, and the first just keep it, on the other side of a curve through
  // all.
  const Point &first = crossing.points.front(), &last = crossing.points.back();
  if (!crossing.above && !keeps(criterion, last.value) && last.height >= (1 - scatter) * *crossing.height)
    crossing.above = last.height;
  if (!crossing.below && keeps(criterion, first.value) && first.height <= (1 + scatter) * *crossing.height)
    crossing.below = first.height;
  if (crossing.curve->freedom > 0) crossing.interval = interval_about(crossing, criterion.limit);
  return crossing;
}

/// Points that exceed the limit far below the height, or keep it far above: beyond its interval, or by a
/// tenth.
std::string scattered(const Crossing& crossing, const injury::Criterion& criterion) {
  const auto [low, high] = crossing.interval.value_or(std::pair{*crossing.height, *crossing.height});
  std::string text;
  for (const Point& point : crossing.points) {
    const bool is_kept = keeps(criterion, point.value);
    if (is_kept ? point.height <= std::min(high, (1 + scatter) * *crossing.height)
                : point.height >= std::max(low, (1 - scatter) * *crossing.height))
      continue;
    text +=
        fmt::format("{}{:.4g} m ({})", text.empty() ? "" : ", ", point.height, is_kept ? "kept" : "exceeded");
    if (text.size() > 120) return text + ", ...";
  }
  return text;
}

/// What is in doubt about each limit at a place, beside the height of the answer.
void add_flags(Place& place, const injury::Standard& standard, const Crossing& answer) {
  const double height = order_of(answer).first;
  for (const Crossing& crossing : place.crossings) {
    const injury::Criterion& criterion = standard.criteria[crossing.criterion];
    const std::string limit = injury::limit_of(criterion);
    const auto add = [&](const char* name, const std::string& words) {
      place.flags.push_back(flag_of(name, words));
    };
    if (crossing.points.empty()) {
      add("FIGURE MISSING", "no drop has a figure for the " + limit);
    } else if (crossing.is_enclosed()) {
      if (&crossing == &answer && !crossing.interval)
        add("FEW DROPS",
            fmt::format(
                "{} for the {} are too few to show the scatter, so there is no interval; four heights "
                "are usual, two on either side of the limit",
                plural(crossing.points.size(), "point"), limit));
      if (const std::string points = scattered(crossing, criterion); !points.empty())
        add("SCATTERED DROPS",
            fmt::format("the {} is exceeded below the height that the curve gives, {:.3g} m, or "
                        "kept above it: {}",
                        limit, *crossing.height, points));
    } else if (!crossing.is_exceeded) {
      if (&crossing == &answer || crossing.points.back().height < height)
        add("LIMIT NOT ENCLOSED",
            fmt::format("the {} is kept up to {:.4g} m, the greatest height tested; drops "
                        "from greater heights are needed",
                        limit, crossing.points.back().height));
    } else if (!crossing.is_kept) {
      add("LIMIT NOT ENCLOSED",
          fmt::format("the {} is exceeded from {:.4g} m on, the lowest height tested; drops from "
                      "lower heights are needed",
                      limit, crossing.points.front().height));
    } else {
      add("LIMIT NOT ENCLOSED",
          fmt::format("no curve meets the {} between drops that keep it and drops that exceed it", limit));
    }
  }
}

/// A number as numbers are written, so that 23 and 23.0 are one temperature; other text as it is.
std::string normal(const std::string& text) {
  const input::ReadNumber number = input::read_csv_number(text);
  return number.kind == input::NumberKind::number ? fmt::format("{}", number.value) : text;
}

std::vector<Remark> remarks_of_place(const Drop& drop) {
  std::vector<Remark> remarks;
  for (const auto& [header, words] : drop.remarks)
    if (tells_places_apart(header)) remarks.emplace_back(header, normal(words));
  return remarks;
}

std::vector<Place> places_of(const DropTable& table) {
  std::vector<Place> places;
  std::map<std::vector<Remark>, std::size_t> known;
  for (const Drop& drop : table.drops) {
    std::vector<Remark> remarks = remarks_of_place(drop);
    const auto [found, is_new] = known.try_emplace(remarks, places.size());
    if (is_new) places.push_back({.remarks = std::move(remarks), .drops = {}, .crossings = {}});
    places[found->second].drops.push_back(drop);
  }
  for (Place& place : places) {
    std::ranges::stable_sort(place.drops, {},
                             [](const Drop& drop) { return std::pair(drop.height, drop.number); });
    // In the order of the table, where it does not number them.
    for (std::size_t i = 0; i < place.drops.size(); ++i) {
      Drop& drop = place.drops[i];
      const bool is_first = i == 0 || place.drops[i - 1].height < drop.height / (1 + same_height);
      if (drop.number == 0) drop.number = is_first ? 1 : place.drops[i - 1].number + 1;
    }
  }
  return places;
}

}  // namespace

double Crossing::half_width(double at) const { return std::hypot(curve->half_width(at), std::log1p(doubt)); }

bool tells_places_apart(std::string_view header) {
  const std::string lower = input::lower_case(header);
  for (const char* name : {"position", "surface", "temperature", "sample", "specimen", "spot"})
    if (lower.starts_with(name)) return true;
  return false;
}

std::pair<double, double> order_of(const Crossing& crossing) {
  if (crossing.points.empty()) return {infinite, infinite};
  const double lowest = crossing.points.front().height, highest = crossing.points.back().height;
  if (crossing.is_enclosed()) return {*crossing.height, highest};
  return {crossing.is_exceeded ? lowest : infinite, highest};
}

bool Answer::is_sure() const {
  const auto is_doubt = [](const Flag& flag) { return severity_of(flag.name) != Severity::note; };
  const auto& interval = decides().interval;
  return decides().is_enclosed() && interval && interval->first > 0 && std::isfinite(interval->second) &&
         std::ranges::none_of(places, [&](const Place& place) {
           return std::ranges::any_of(place.flags, is_doubt) ||
                  std::ranges::any_of(place.drops, [&](const Drop& drop) {
                    return std::ranges::any_of(drop.flags, is_doubt);
                  });
         });
}

std::pair<double, double> heights_of(const Answer& answer) {
  std::pair<double, double> heights{infinite, 0};
  for (const Place& place : answer.places) {
    heights.first = std::min(heights.first, place.drops.front().height);
    heights.second = std::max(heights.second, place.drops.back().height);
  }
  return heights;
}

const Place& lowest_for(const Answer& answer, std::size_t criterion) {
  return *std::ranges::min_element(answer.places, {},
                                   [&](const Place& place) { return order_of(place.crossings[criterion]); });
}

Answer evaluated(const DropTable& table, const injury::Standard& standard) {
  Answer answer{.standard = standard, .places = places_of(table), .reservations = {}, .common = {}};
  for (Place& place : answer.places) {
    for (std::size_t i = 0; i < standard.criteria.size(); ++i)
      place.crossings.push_back(crossing_of(place, i, standard));
    const auto lowest = std::ranges::min_element(place.crossings, {}, order_of);
    place.lowest = static_cast<std::size_t>(lowest - place.crossings.begin());
  }
  const auto lowest = std::ranges::min_element(answer.places, {},
                                               [](const Place& place) { return order_of(place.decides()); });
  answer.lowest = static_cast<std::size_t>(lowest - answer.places.begin());
  for (Place& place : answer.places) add_flags(place, standard, answer.decides());
  const std::vector<Drop>& drops = table.drops;
  for (const Remark& remark : drops.front().remarks)
    if (std::ranges::all_of(drops, [&](const Drop& drop) {
          return std::ranges::find(drop.remarks, remark) != drop.remarks.end();
        }))
      answer.common.push_back(remark);
  for (Place& place : answer.places)
    std::erase_if(place.remarks, [&](const Remark& remark) {
      return std::ranges::find(answer.common, remark) != answer.common.end();
    });
  if (!table.calibration)
    answer.reservations.push_back(
        flag_of("NO CALIBRATION",
                "the intervals do not contain the calibration of the accelerometer: give --calibration"));
  for (Flag& flag : injury::reservations_about_limits(standard))
    answer.reservations.push_back(std::move(flag));
  return answer;
}

}  // namespace dashpad::fall_height
