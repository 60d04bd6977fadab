#include "dashpad/report1986/validation/trends.hpp"

#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/report1986/validation/energy.hpp"
#include "dashpad/report1986/validation/verdict.hpp"
#include "report1986/validation/placings.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::report1986 {

namespace {

using Residuals = std::vector<std::optional<double>>;

constexpr double step_in = 0.25;

/// The minimum of the sum of squares, by a parabola through three radii.
struct Least {
  std::size_t index = 0;
  double radius_in = 0;
  double sum = 0;
};

Least min_of(const std::vector<double>& radii, const std::vector<double>& sums) {
  Least least{0, no_value, infinite};
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] < least.sum) least = {i, radii[i], sums[i]};
  const std::size_t i = least.index;
  if (i == 0 || i + 1 == radii.size() || std::isnan(sums[i - 1]) || std::isnan(sums[i + 1])) return least;
  const double bend = sums[i - 1] - 2 * sums[i] + sums[i + 1];
  if (!(bend > 0)) return least;
  const double shift = (sums[i - 1] - sums[i + 1]) / (2 * bend);
  least.radius_in += shift * step_in;
  least.sum = std::max(0.0, sums[i] - bend * shift * shift / 2);
  return least;
}

/// Whether no radius with a figure is left on one side of the minimum.
bool is_at_an_end(const std::vector<double>& sums, std::size_t least) {
  const auto has_figure = [](double sum) { return !std::isnan(sum); };
  const auto place = sums.begin() + static_cast<std::ptrdiff_t>(least);
  return std::none_of(sums.begin(), place, has_figure) || std::none_of(place + 1, sums.end(), has_figure);
}

/// The radius at which the sum of squares crosses the limit, from the minimum towards one end. Radii without
/// a figure are skipped.
double border(const std::vector<double>& radii, const std::vector<double>& sums, const Least& least,
              double limit, int direction) {
  double radius = least.radius_in, sum = least.sum;
  for (auto i = static_cast<std::ptrdiff_t>(least.index); i >= 0 && i < std::ssize(radii); i += direction) {
    const auto at = static_cast<std::size_t>(i);
    if ((radii[at] - least.radius_in) * direction <= 0 || std::isnan(sums[at])) continue;
    if (sums[at] > limit) return radius + (radii[at] - radius) * (limit - sum) / (sums[at] - sum);
    radius = radii[at], sum = sums[at];
  }
  return direction < 0 ? radii.front() : radii.back();
}

/// NaN if a reading has no figure.
double sum_of_squares(const Residuals& residuals) {
  double sum = 0;
  for (const std::optional<double>& residual : residuals) {
    if (!residual) return no_value;
    sum += *residual * *residual;
  }
  return sum;
}

/// Speeds at which curve "B" is above its tail, mph.
constexpr double speeds_on_the_plate[] = {14, 16, 18, 20};

/// A value that predictions are compared with, at any radius.
struct Expected {
  Setup setup;
  double value = 0;
};

/// The criterion whose residuals are the errors of a program's predictions, by the rule of the quantity.
RadiusCriterion criterion_of(std::string name, std::string remark, const std::vector<Prediction>& predictions,
                             Program program, Quantity quantity, const std::vector<Expected>& expected) {
  const Rule& rule = rule_of(quantity);
  const auto residuals_at = [&](double radius) {
    Residuals residuals;
    for (auto [setup, value] : expected) {
      setup.radius_in = radius;
      const auto figure = predicted(predictions, program, setup, quantity);
      residuals.push_back(figure ? std::optional(error_of(rule, value, *figure)) : std::nullopt);
    }
    return residuals;
  };
  return radius_criterion(std::move(name), std::move(remark), rule.logarithmic ? "ln" : "1", residuals_at);
}

/// Compares the accurate solver with the certain readings of a quantity on a support.
RadiusCriterion of_tests(const ValidationData& data, const std::vector<Prediction>& at_tests,
                         std::string name, TestSupport support, Quantity quantity) {
  std::vector<Expected> expected;
  for (const MeasuredTest& test : data.measured.tests)
    if (const auto reading = measured(test, quantity); reading && test.support == support)
      expected.push_back({setup_of(test, 0), *reading});
  return criterion_of(std::move(name), "readings in Table 3-1 whose test is known; accurate solver", at_tests,
                      Program::accurate, quantity, expected);
}

/// Strains of the steel projectile, of which no row is known: root mean squares over all placings.
RadiusCriterion strains_on_the_load_cell(const ValidationData& data,
                                         const std::vector<Prediction>& at_tests) {
  MeasuredTests group{data.measured.tests, {}};
  for (const UnplacedReadings& unplaced : data.measured.unplaced)
    if (unplaced.column == "plug_strain" && unplaced.first_test == 28) group.unplaced.push_back(unplaced);
  const auto residuals_at = [&](double radius) -> Residuals {
    if (group.unplaced.empty()) return {};
    std::vector<double> squares(group.unplaced.front().readings.size());
    std::size_t ways = 0;
    for_each_placing(group, "plug_strain", [&](const std::vector<MeasuredTest>& tests) {
      std::size_t reading = 0;
      ++ways;
      for (const MeasuredTest& test : tests) {
        if (test.number < 28 || test.number > 33 || !test.plug_strain) continue;
        const auto value =
            predicted(at_tests, Program::accurate, setup_of(test, radius), Quantity::peak_strain);
        squares[reading++] += value ? std::pow(*value - *test.plug_strain, 2) : no_value;
      }
    });
    Residuals residuals;
    for (const double square : squares)
      residuals.push_back(std::isnan(square) ? std::nullopt
                                             : std::optional(std::sqrt(square / static_cast<double>(ways))));
    return residuals;
  };
  return radius_criterion("strains on the load cell",
                          "plug readings from tests 28 to 33, mean over all assignments; accurate solver",
                          "1", residuals_at);
}

RadiusCriterion forces_of_curve_b(const ValidationData& data, const std::vector<Prediction>& others,
                                  std::string name, Program program) {
  std::vector<Expected> expected;
  for (const double speed : speeds_on_the_plate)
    expected.push_back({{Projectile::aluminium, TestSupport::plate, speed, 0},
                        curve_b_force_lb(data, Projectile::aluminium, speed)});
  return criterion_of(std::move(name),
                      fmt::format("curve \"B\" (the report's estimate) at 14 to 20 mph; {}",
                                  program == Program::accurate ? "accurate solver" : to_string(program)),
                      others, program, Quantity::peak_force, expected);
}

/// The report's statements about its simulations concern the load cell.
RadiusCriterion ratios_of_the_report(const ValidationData& data, const std::vector<Prediction>& others,
                                     Program program) {
  std::vector<Expected> expected;
  for (const auto& [projectile, speed, constant, ratio] : printed_ratios)
    expected.push_back({{projectile, TestSupport::load_cell, speed, 0},
                        data.constant(constant) * curve_a_force_lb(data, projectile, speed)});
  return criterion_of(
      "the report's force ratios",
      fmt::format("1 to 0.4 and 1.4 to 0.4 times curve \"A\" (section 4); {}", to_string(program)), others,
      program, Quantity::peak_force, expected);
}

RadiusCriterion times_of_the_report(const ValidationData& data, const std::vector<Prediction>& others,
                                    Program program) {
  std::vector<Expected> expected;
  for (const Setup& setup : setups_of_curves(0))
    if (setup.support == TestSupport::load_cell)
      expected.push_back(
          {setup, 1e3 * data.constant("expected_travel_in") / (inch_per_s_of_mph * setup.speed_mph) +
                      data.constant("excess_of_predicted_time_ms")});
  return criterion_of("the report's times to peak",
                      fmt::format("2 ms above the line VT = 1.25 in (section 4); {}", to_string(program)),
                      others, program, Quantity::time_to_peak, expected);
}

}  // namespace

std::vector<double> radii_of_the_study() {
  std::vector<double> radii;
  for (int i = 0; min_radius_in + i * step_in <= greatest_radius_in; ++i)
    radii.push_back(min_radius_in + i * step_in);
  return radii;
}

RadiusCriterion radius_criterion(
    std::string name, std::string remark, std::string unit,
    const std::function<std::vector<std::optional<double>>(double radius_in)>& residuals_at) {
  RadiusCriterion criterion;
  criterion.name = std::move(name);
  criterion.remark = std::move(remark);
  criterion.unit = std::move(unit);
  const std::vector<double> radii = radii_of_the_study();
  std::vector<double> sums;
  for (const double radius : radii) {
    const auto residuals = residuals_at(radius);
    criterion.readings = static_cast<int>(residuals.size());
    sums.push_back(residuals.empty() ? no_value : sum_of_squares(residuals));
    criterion.misfit.push_back(std::sqrt(sums.back() / criterion.readings));
  }
  const Least least = min_of(radii, sums);
  criterion.favoured_in = std::round(100 * least.radius_in) / 100;
  criterion.at_an_end = std::isfinite(least.sum) && is_at_an_end(sums, least.index);
  criterion.admitted = {radii.front(), radii.back()};
  const auto missing = std::ranges::count_if(sums, [](double sum) { return std::isnan(sum); });
  if (missing > 0) criterion.remark += fmt::format("; no result at {} of {} radii", missing, radii.size());
  if (criterion.readings < 2 || std::ssize(radii) - missing < 3) return criterion;
  const int freedom = criterion.readings - 1;
  const double quantile = std::pow(uncertainty::student_95(freedom), 2);  // of F(1, freedom)
  const double limit = least.sum * (1 + quantile / freedom);
  criterion.admitted = {border(radii, sums, least, limit, -1), border(radii, sums, least, limit, 1)};
  return criterion;
}

std::vector<Prediction> predict_for_radius(const ValidationData& data, const Material& ensolite,
                                           const Progress& progress) {
  std::vector<Setup> load_cell, plate;
  for (const double radius : radii_of_the_study()) {
    for (const Setup& setup : setups_of_curves(radius))
      if (setup.support == TestSupport::load_cell) load_cell.push_back(setup);
    for (const double speed : speeds_on_the_plate)
      plate.push_back({Projectile::aluminium, TestSupport::plate, speed, radius});
  }
  std::vector<Prediction> all = predict_all(
      data, ensolite, {Program::printed_1984, Program::accurate_first_slope}, load_cell, progress);
  const std::vector<Prediction> on_plate =
      predict_all(data, ensolite, {Program::printed_1984, Program::accurate}, plate, progress);
  all.insert(all.end(), on_plate.begin(), on_plate.end());
  return all;
}

RadiusStudy study_radius(const ValidationData& data, const std::vector<Prediction>& at_tests,
                         const std::vector<Prediction>& others) {
  RadiusStudy study;
  study.radii_in = radii_of_the_study();
  study.criteria = {
      of_tests(data, at_tests, "strains on the plate", TestSupport::plate, Quantity::peak_strain),
      forces_of_curve_b(data, others, "forces on the plate", Program::accurate),
      of_tests(data, at_tests, "forces on the load cell", TestSupport::load_cell, Quantity::peak_force),
      of_tests(data, at_tests, "times on the load cell", TestSupport::load_cell, Quantity::time_to_peak),
      strains_on_the_load_cell(data, at_tests),
  };
  study.criteria.push_back(
      forces_of_curve_b(data, others, "the report's forces on the plate", Program::printed_1984));
  study.criteria.back().of_the_report = true;
  for (const Program program : {Program::printed_1984, Program::accurate_first_slope}) {
    for (RadiusCriterion criterion :
         {ratios_of_the_report(data, others, program), times_of_the_report(data, others, program)}) {
      criterion.of_the_report = program == Program::printed_1984;
      study.criteria.push_back(std::move(criterion));
    }
  }
  return study;
}

double RadiusStudy::of_the_report_in() const {
  double sum = 0;
  int estimates = 0;
  for (const RadiusCriterion& criterion : criteria)
    if (criterion.of_the_report && !criterion.at_an_end && std::isfinite(criterion.favoured_in))
      sum += criterion.favoured_in, ++estimates;
  if (estimates == 0) return favoured_in();
  return *std::ranges::min_element(radii_in, {},
                                   [&](double radius) { return std::abs(radius - sum / estimates); });
}

}  // namespace dashpad::report1986
