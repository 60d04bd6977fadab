#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/report1986/validation/energy.hpp"
#include "dashpad/report1986/validation/trends.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation/trends_least_squares.hpp"

namespace dashpad::report1986 {

namespace {

constexpr std::array<const char*, 3> columns{"plug_strain", "diameter_strain", "peak_force_lb"};

/// For each column, how many readings of its current group are placed.
using Placed = std::array<std::size_t, columns.size()>;

/// A test to which some lost readings have been assigned.
struct Served {
  MeasuredTest test;
  Placed placed{};
  bool is_certain = true;
};

const UnplacedReadings* group_at(const MeasuredTests& measured, const std::string& column, int test) {
  const auto found = std::ranges::find_if(measured.unplaced, [&](const UnplacedReadings& group) {
    return group.column == column && group.first_test <= test && test <= group.last_test;
  });
  return found == measured.unplaced.end() ? nullptr : &*found;
}

/// Both continuations in a column, with the next reading and without it. At the end of a group all its
/// readings must be placed.
std::vector<Served> served(const MeasuredTests& measured, const std::vector<Served>& before,
                           std::size_t column) {
  std::vector<Served> after;
  for (const Served& way : before) {
    const UnplacedReadings* group = group_at(measured, columns[column], way.test.number);
    const auto add = [&](Served next) {
      if (group && next.test.number == group->last_test) {
        if (next.placed[column] < group->readings.size()) return;
        next.placed[column] = 0;
      }
      after.push_back(next);
    };
    add(way);
    if (!group || way.placed[column] == group->readings.size()) continue;
    Served with = way;
    with.test.*measured_column(columns[column]).reading = group->readings[with.placed[column]++];
    with.is_certain = false;
    add(with);
  }
  return after;
}

struct LeastSum {
  double sum = 0;
  std::vector<NominalStressPoint> points;
};

/// All placings of strains and forces at once. They are far too many to enumerate; but a sum over the points
/// of a placing is least along a path through the tests, which dynamic programming finds.
class NominalStressPlacings {
 public:
  /// Tests with strain and force become points. `stress` is the nominal stress of a test.
  NominalStressPlacings(const MeasuredTests& measured,
                        const std::function<double(const MeasuredTest&)>& stress) {
    std::map<Placed, std::size_t> here{{Placed{}, 0}};
    states_.push_back(1);
    for (const MeasuredTest& test : measured.tests) {
      std::map<Placed, std::size_t> next;
      std::vector<Step>& steps = steps_.emplace_back();
      for (const auto& [placed, number] : here) {
        std::vector<Served> ways{{test, placed, true}};
        for (std::size_t column = 0; column < columns.size(); ++column) ways = served(measured, ways, column);
        for (const Served& way : ways) {
          Step step{number, next.emplace(way.placed, next.size()).first->second, false, {}};
          step.has_point = peak_strain(way.test) && way.test.peak_force_lb;
          if (step.has_point)
            step.point = {way.is_certain ? test.number : 0, stress(way.test), *way.test.peak_force_lb};
          steps.push_back(step);
        }
      }
      states_.push_back(next.size());
      here = std::move(next);
    }
  }

  /// For each possible number of points, the placing with the least sum of cost(ln(force / stress)).
  [[nodiscard]] std::map<std::size_t, LeastSum> least(const std::function<double(double)>& cost) const {
    struct Best {
      double sum = infinite;
      const Step* step = nullptr;
    };
    const std::size_t counts = steps_.size() + 1;  // numbers of points: 0 to that of the tests
    std::vector<std::vector<Best>> best;           // before each test, by state and number of points
    for (const std::size_t states : states_) best.emplace_back(states * counts);
    best.front().front().sum = 0;

    for (std::size_t test = 0; test < steps_.size(); ++test)
      for (const Step& step : steps_[test]) {
        const std::size_t more = step.has_point ? 1 : 0;
        const double added = step.has_point ? cost(std::log(step.point.force_lb / step.point.stress_psi)) : 0;
        for (std::size_t points = 0; points + more < counts; ++points) {
          const double sum = best[test][step.from * counts + points].sum + added;
          Best& there = best[test + 1][step.to * counts + points + more];
          if (sum < there.sum) there = {sum, &step};
        }
      }

    std::map<std::size_t, LeastSum> found;
    for (std::size_t points = 0; states_.back() > 0 && points < counts; ++points) {
      if (best.back()[points].sum == infinite) continue;
      LeastSum& least = found[points];
      least.sum = best.back()[points].sum;
      std::size_t state = 0;
      std::size_t left = points;
      for (std::size_t test = steps_.size(); test-- > 0;) {
        const Step& step = *best[test + 1][state * counts + left].step;
        if (step.has_point) least.points.push_back(step.point);
        left -= step.has_point ? 1 : 0;
        state = step.from;
      }
      std::ranges::reverse(least.points);
    }
    return found;
  }

 private:
  /// A way to assign readings to one test, from one state of placed readings to the next.
  struct Step {
    std::size_t from = 0, to = 0;
    bool has_point = false;
    NominalStressPoint point;
  };
  std::vector<std::vector<Step>> steps_;  ///< for each test
  std::vector<std::size_t> states_;       ///< their number before each test, and after the last
};

constexpr double pound_per_square_inch = 4.4482216152605 / (0.0254 * 0.0254);  // Pa
constexpr std::size_t fewest_points = 3;                                       // for a slope with an interval

/// Number of trial lines of unit slope between the extreme ones; the minimum is found to within half a step.
constexpr int lines = 500;

std::vector<Point> logarithms(const std::vector<NominalStressPoint>& points) {
  std::vector<Point> logs;
  for (const NominalStressPoint& point : points)
    logs.push_back({std::log(point.stress_psi), std::log(point.force_lb)});
  return logs;
}

double mean_log_ratio(const std::vector<NominalStressPoint>& points) {
  double sum = 0;
  for (const Point& point : logarithms(points)) sum += point.y - point.x;
  return sum / static_cast<double>(points.size());
}

double deviation(double squares, std::size_t points) {
  return std::sqrt(squares / static_cast<double>(points - 1));
}

double scatter_of(const std::vector<NominalStressPoint>& points) {
  const double mean = mean_log_ratio(points);
  double squares = 0;
  for (const Point& point : logarithms(points)) squares += std::pow(point.y - point.x - mean, 2);
  return deviation(squares, points.size());
}

/// The least and the greatest mean of ln(F / stress) over all placings with points.
Interval means_over(const NominalStressPlacings& placings) {
  Interval means = nowhere;
  for (const auto& [points, least] : placings.least([](double ratio) { return ratio; }))
    if (points > 0) means.include(least.sum / static_cast<double>(points));
  for (const auto& [points, least] : placings.least([](double ratio) { return -ratio; }))
    if (points > 0) means.include(-least.sum / static_cast<double>(points));
  return means;
}

/// Finds the placing of least scatter, and the range of the scatter. A placing scatters least about its own
/// mean, so the least scatter about any line is the least of all, and the greatest about one an upper bound.
void scan_lines(const NominalStressPlacings& placings, const Interval& means, NominalStressFit& fit) {
  fit.scatter = infinite;
  std::map<std::size_t, double> bounds;
  for (int i = 0; i <= lines; ++i) {
    const double line = means.low + (means.high - means.low) * i / lines;
    const auto square = [line](double ratio) { return (ratio - line) * (ratio - line); };
    for (const auto& [count, least] : placings.least(square)) {
      if (count < fewest_points) continue;
      const double scatter = scatter_of(least.points);
      if (scatter >= fit.scatter) continue;
      fit.scatter = scatter;
      fit.points = least.points;
    }
    for (const auto& [count, least] : placings.least([&](double ratio) { return -square(ratio); })) {
      if (count < fewest_points) continue;
      const double bound = deviation(-least.sum, count);
      const auto known = bounds.emplace(count, bound).first;
      known->second = std::min(known->second, bound);
    }
  }
  if (fit.points.empty()) fit.scatter = 0;
  fit.scatter_over_placings = {fit.scatter, fit.scatter};
  for (const auto& [count, bound] : bounds)
    fit.scatter_over_placings.high = std::max(fit.scatter_over_placings.high, bound);
}

std::string remark_on(const ValidationData& data, const NominalStressFit& fit) {
  double ways = 1;
  for (const char* const column : columns) ways *= placings(data.measured, column);
  return fmt::format(
      "Shown is the assignment with the least scatter ({} points) out of {:.2g}, since the tests of nearly "
      "all strains and of some forces are unknown. It is the most favourable choice and not the "
      "report's Figure 3-5, which shows {:g} tests, {:g} of them fitted, and cannot be reconstructed.",
      fit.points.size(), ways, data.constant("nominal_stress_tests"),
      data.constant("nominal_stress_clustered_tests"));
}

}  // namespace

double nominal_stress_psi(const Material& ensolite, double peak_strain, double speed_mph,
                          double thickness_in) {
  const auto* law = std::get_if<NineParameter>(&ensolite.law);
  if (!law) throw std::invalid_argument("the nominal stress requires the nine-parameter law");
  const double rate = inch_per_s_of_mph * speed_mph / thickness_in;
  const double shape =
      std::pow(peak_strain, law->contact_exponent) / std::pow(1 - peak_strain, law->compaction_exponent);
  const double modulus = law->asymptotic_modulus + law->rate_modulus * std::pow(rate, law->rate_exponent);
  return shape * modulus / pound_per_square_inch;
}

NominalStressFit fit_nominal_stress(const ValidationData& data, const Material& ensolite) {
  const NominalStressPlacings placings(data.measured, [&](const MeasuredTest& test) {
    return nominal_stress_psi(ensolite, *peak_strain(test), test.speed_mph, data.pad_thickness_in);
  });
  const Interval means = means_over(placings);
  NominalStressFit fit;
  if (!(means.low <= means.high)) {
    fit.remark = "No test has both a strain and a force.";
    return fit;
  }
  scan_lines(placings, means, fit);
  if (fit.points.empty()) {
    fit.remark = "Too few tests have both a strain and a force.";
    return fit;
  }
  fit.area_in2 = std::exp(mean_log_ratio(fit.points));
  fit.area_over_placings = {std::exp(means.low), std::exp(means.high)};
  const LineFit line = fit_line(logarithms(fit.points));
  fit.slope = line.slope.value;
  fit.slope_confidence = {line.slope.low, line.slope.high};
  fit.remark = remark_on(data, fit);
  return fit;
}

}  // namespace dashpad::report1986
