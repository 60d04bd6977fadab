#include <algorithm>
#include <set>

#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::report1986 {

namespace {

constexpr TestSupport supports[] = {TestSupport::load_cell, TestSupport::plate};

template <class Radii, class SetupsAt>
std::vector<Setup> at_radii(const Radii& radii, SetupsAt&& setups_at) {
  std::vector<Setup> setups;
  for (const double radius : radii)
    for (const Setup& setup : setups_at(radius)) setups.push_back(setup);
  return setups;
}

Verdict verdict_of(const Study& study, double radius_in, Program program, TestSupport support,
                   Quantity quantity, std::optional<Projectile> projectile) {
  const auto score_at = [&](double radius) {
    return score(study.data.measured, study.at_tests, program, support, quantity, radius, projectile);
  };
  Verdict verdict;
  verdict.score = score_at(radius_in);
  verdict.bias_over_radii = verdict.scatter_over_radii = nowhere;
  for (const double radius : study.radius.radii_in) {
    const Score score = score_at(radius);
    ++verdict.radii;
    verdict.radii_passed += score.passed ? 1 : 0;
    if (score.errors.empty()) continue;
    verdict.bias_over_radii.include(score.bias);
    verdict.scatter_over_radii.include(score.scatter);
  }
  if (verdict.bias_over_radii.low > verdict.bias_over_radii.high)
    verdict.bias_over_radii = verdict.scatter_over_radii = {};
  return verdict;
}

/// Forces and times were not measured on the plate.
bool measured_on(const Study& study, TestSupport support, Quantity quantity) {
  if (support == TestSupport::load_cell) return true;
  return std::ranges::any_of(study.data.measured.tests, [&](const MeasuredTest& test) {
    return test.support == support && measured(test, quantity);
  });
}

AnomalyVerdict anomaly_at(const Study& study, double radius, const std::vector<Prediction>& on_curves,
                          const std::vector<Program>& which) {
  std::vector<ForceTrend> trends;
  for (const Program program : which)
    trends.push_back(force_trend(study.data, study.at_tests, on_curves, program, radius));
  const Score force = score(study.data.measured, study.at_tests, Program::accurate, TestSupport::load_cell,
                            Quantity::peak_force, radius);
  return judge_anomaly(study.data, std::move(trends), force.passed);
}

/// `others`: the first slope at the report's speeds, at all radii.
void judge_anomaly_of(Study& study, const std::vector<Prediction>& others) {
  study.anomaly = anomaly_at(study, study.radius.favoured_in(), study.on_curves, programs);
  study.anomaly_at_the_reports_radius =
      anomaly_at(study, study.radius.of_the_report_in(), study.on_curves, programs);
  for (const double radius : study.radius.radii_in)
    study.anomaly.over_radii.push_back(
        anomaly_at(study, radius, others, {Program::accurate, Program::accurate_first_slope}).explanation);
}

void judge_all(Study& study) {
  const double favoured = study.radius.favoured_in(), of_the_report = study.radius.of_the_report_in();
  for (const Program program : programs)
    for (const TestSupport support : supports)
      for (const Quantity quantity : quantities) {
        if (!measured_on(study, support, quantity)) continue;
        study.verdicts.push_back(verdict_of(study, favoured, program, support, quantity, {}));
        study.at_the_reports_radius.push_back(
            verdict_of(study, of_the_report, program, support, quantity, {}));
        if (support == TestSupport::plate) continue;
        for (const Projectile projectile : {Projectile::aluminium, Projectile::steel})
          study.by_projectile.push_back(verdict_of(study, favoured, program, support, quantity, projectile));
      }
  for (const Program program : programs) {
    const auto placed = placed_scores(study.data.measured, study.at_tests, program, favoured);
    study.placed.insert(study.placed.end(), placed.begin(), placed.end());
    study.rebounds.push_back(admissible_rebounds(study.data, study.at_tests, program, favoured));
  }
}

}  // namespace

std::vector<Setup> setups_of_tests(const MeasuredTests& measured, double radius_in) {
  std::vector<Setup> setups;
  for (const MeasuredTest& test : measured.tests) {
    const Setup setup = setup_of(test, radius_in);
    if (std::ranges::count(setups, setup) == 0) setups.push_back(setup);
  }
  return setups;
}

std::vector<Setup> setups_of_curves(double radius_in) {
  std::vector<Setup> setups;
  for (const TestSupport support : supports)
    for (int speed = 10; speed <= 20; speed += 2)
      setups.push_back({Projectile::aluminium, support, static_cast<double>(speed), radius_in});
  for (int speed = 10; speed <= 15; ++speed)
    setups.push_back({Projectile::steel, TestSupport::load_cell, static_cast<double>(speed), radius_in});
  return setups;
}

Study run_study(const ValidationData& data, const Material& ensolite, const Progress& progress) {
  Study study;
  study.data = data;
  study.constants = fit_trends(data);
  study.nominal_stress = fit_nominal_stress(data, ensolite);
  const auto tests_at = [&](double radius) { return setups_of_tests(data.measured, radius); };
  study.at_tests = predict_all(data, ensolite, programs, at_radii(radii_of_the_study(), tests_at), progress);
  const std::vector<Prediction> others = predict_for_radius(data, ensolite, progress);
  study.radius = study_radius(data, study.at_tests, others);

  const double favoured = study.radius.favoured_in(), of_the_report = study.radius.of_the_report_in();
  if (std::ranges::count(study.radius.radii_in, favoured) == 0) {
    const std::vector<Prediction> more = predict_all(data, ensolite, programs, tests_at(favoured), progress);
    study.at_tests.insert(study.at_tests.end(), more.begin(), more.end());
  }
  const std::set<double> radii{min_radius_in, of_the_report, favoured, greatest_radius_in};
  study.on_curves = predict_all(data, ensolite, programs, at_radii(radii, setups_of_curves), progress);
  judge_all(study);
  judge_anomaly_of(study, others);
  study.held_out = hold_out(data, progress);
  return study;
}

}  // namespace dashpad::report1986
