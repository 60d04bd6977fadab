#include "report1986/validation/nominal_stress_placings.hpp"

#include <algorithm>
#include <cmath>

#include "quantities/special_numbers.hpp"
#include "report1986/validation/measured_tests_columns.hpp"

namespace dashpad::report1986 {

namespace {

constexpr std::array<const char*, 3> columns{"plug_strain", "diameter_strain", "peak_force_lb"};

/// How many readings of the current group of each column are placed.
using Placed = std::array<std::size_t, columns.size()>;

/// A test with some of the lost readings given to it.
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

/// Both ways to go on in a column, with the next reading and without it. At the end of its group all readings
/// must be placed.
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

}  // namespace

NominalStressPlacings::NominalStressPlacings(const MeasuredTests& measured,
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

std::map<std::size_t, LeastSum> NominalStressPlacings::least(
    const std::function<double(double)>& cost) const {
  struct Best {
    double sum = infinite;
    const Step* step = nullptr;
  };
  const std::size_t counts = steps_.size() + 1;  // numbers of points: 0 to that of the tests
  std::vector<std::vector<Best>> best;           // before each test: for each state and number of points
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

}  // namespace dashpad::report1986
