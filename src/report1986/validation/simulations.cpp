#include "dashpad/report1986/validation/simulations.hpp"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "dashpad/report1986/validation/energy.hpp"
#include "dashpad/spit1984/run.hpp"

namespace dashpad::report1986 {

namespace {

/// The support of a setup, with its whole curve or only its first slope.
Support support_of(const ValidationData& data, TestSupport support, bool first_slope) {
  const double inch = to_si("1 in", "m"), pound = to_si("1 lbf", "N");
  if (support == TestSupport::plate) return Support::linear(data.plate_stiffness_lb_per_in * pound / inch);
  std::vector<Support::Point> points;
  for (const StaticPoint& point : data.load_cell)
    points.push_back({point.deflection_in * inch, point.force_lb * pound});
  if (first_slope) points.resize(1);
  return Support::through(std::move(points));
}

std::string remark_on(const spit1984::Run& run) {
  using namespace spit1984;
  std::string remark;
  if (run.abend != Abend::none)
    remark = fmt::format("ABEND {} ({}) at {:.1f} ms; ", static_cast<int>(run.abend),
                         text_of(run.abend).message, run.duration_ms);
  if (!run.precision_stops.empty())
    remark +=
        fmt::format("{} of {} steps out of equilibrium; ", run.precision_stops.size(), run.history.size());
  if (!remark.empty()) remark.resize(remark.size() - 2);
  return remark;
}

/// The number of rows before a run breaks down: before the first tensile force, the first step out of
/// equilibrium, and a last step that was not accepted.
std::size_t sound_rows(const spit1984::Run& run) {
  std::size_t rows = run.history.size() - (run.last_step_accepted ? 0 : 1);
  for (std::size_t i = 0; i < rows; ++i)
    if (run.history[i].force_lb > 0) rows = i;
  for (const spit1984::PrecisionStop& stop : run.precision_stops)
    rows = std::min(rows, static_cast<std::size_t>(std::max(stop.step - 2, 0)));
  return rows;
}

/// A run that breaks down on the rebound has passed its peaks. At this fraction of the peak force it has yet
/// to gain 0.9 % of its speed (the median of the tests' complete runs), and at most 6 %.
constexpr double little_force_left = 0.1;

void read_broken_run(const spit1984::Run& run, double thickness_in, Prediction& prediction) {
  const auto begin = run.history.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(sound_rows(run));
  if (begin == end || !(end[-1].speed_in_per_s < 0)) return;
  const auto peak = std::min_element(begin, end, [](auto& a, auto& b) { return a.force_lb < b.force_lb; });
  const auto deepest =
      std::max_element(begin, end, [](auto& a, auto& b) { return a.penetration_in < b.penetration_in; });
  prediction.peak_force_lb = -peak->force_lb;
  prediction.time_to_peak_ms = peak->time_ms;
  prediction.peak_strain = deepest->penetration_in / thickness_in;
  const double left = end[-1].force_lb / peak->force_lb;
  if (left <= little_force_left) prediction.rebound_mph = -end[-1].speed_in_per_s / inch_per_s_of_mph;
  prediction.remark += fmt::format("{}used up to {:.1f} ms, when the force is {:.0f} % of its peak",
                                   prediction.remark.empty() ? "" : "; ", end[-1].time_ms, 100 * left);
}

/// The plate is linear, so it has no later slopes.
Program that_runs(Program program, TestSupport support) {
  if (support == TestSupport::load_cell) return program;
  if (program == Program::mended_support_1984) return Program::printed_1984;
  if (program == Program::accurate_first_slope) return Program::accurate;
  return program;
}

void run_the_program(const ImpactCase& impact, Program program, Prediction& prediction) {
  spit1984::Settings settings;
  settings.defects.idle_segments = program == Program::printed_1984;
  const spit1984::Deck deck = spit1984::deck_of(impact);
  const spit1984::Run run = spit1984::run(deck, settings);
  prediction.remark = remark_on(run);
  const bool pulls = std::ranges::any_of(run.history, [](const auto& step) { return step.force_lb > 0; });
  if (run.abend != spit1984::Abend::none || pulls) {
    read_broken_run(run, deck.thickness_in, prediction);
    return;
  }
  prediction.peak_force_lb = -run.peak_force_lb;
  prediction.time_to_peak_ms = run.time_of_peak_force_ms;
  double penetration = 0;
  for (const spit1984::Step& step : run.history) penetration = std::max(penetration, step.penetration_in);
  prediction.peak_strain = penetration / deck.thickness_in;
  prediction.rebound_mph = -run.rebound_speed_mph;
}

}  // namespace

Prediction figures_of(const Summary& summary) {
  Prediction prediction;
  if (summary.peak_force) prediction.peak_force_lb = *summary.peak_force / to_si("1 lbf", "N");
  if (summary.time_of_peak_force) prediction.time_to_peak_ms = 1e3 * *summary.time_of_peak_force;
  if (summary.force_below_weight)
    prediction.rebound_mph = -summary.force_below_weight->velocity / to_si("1 mph", "m/s");
  prediction.peak_strain = summary.peak_strain;
  prediction.bottomed = summary.bottomed.has_value();
  prediction.error = summary.errors.peak_force;
  if (!summary.trustworthy() || summary.status == Status::time_limit)
    prediction.remark = to_string(summary.status);
  return prediction;
}

const char* to_string(Program program) {
  switch (program) {
    case Program::printed_1984: return "1984 program";
    case Program::mended_support_1984: return "1984 program, support mended";
    case Program::accurate: return "accurate";
    case Program::accurate_first_slope: break;
  }
  return "accurate, first slope";
}

Setup setup_of(const MeasuredTest& test, double radius_in) {
  return {test.projectile, test.support, test.speed_mph, radius_in};
}

ImpactCase impact_case(const ValidationData& data, const Material& ensolite, const Setup& setup) {
  const double inch = to_si("1 in", "m");
  ImpactCase impact;
  impact.title = fmt::format("{} at {:.4g} mph on the {}", to_string(setup.projectile), setup.speed_mph,
                             to_string(setup.support));
  impact.impactor = {.mass = weight_of(data, setup.projectile) * to_si("1 lb", "kg"),
                     .nose = Sphere{setup.radius_in * inch},
                     .speed = setup.speed_mph * to_si("1 mph", "m/s")};
  impact.pad = {data.pad_thickness_in * inch, ensolite};
  impact.support = support_of(data, setup.support, false);
  return impact;
}

Prediction predict(const ValidationData& data, const Material& ensolite, Program program,
                   const Setup& setup) {
  Prediction prediction;
  ImpactCase impact = impact_case(data, ensolite, setup);
  if (program == Program::printed_1984 || program == Program::mended_support_1984) {
    run_the_program(impact, program, prediction);
  } else {
    if (program == Program::accurate_first_slope) impact.support = support_of(data, setup.support, true);
    prediction = figures_of(solve(impact).summary);
  }
  prediction.program = program;
  prediction.setup = setup;
  return prediction;
}

void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work, const Progress& progress) {
  std::mutex mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    work(i);
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, count);
  });
}

std::vector<Prediction> predict_all(const ValidationData& data, const Material& ensolite,
                                    const std::vector<Program>& which, const std::vector<Setup>& setups,
                                    const Progress& progress) {
  std::vector<std::pair<Program, Setup>> jobs;
  std::vector<std::size_t> job_of;
  for (const Setup& setup : setups)
    for (const Program program : which) {
      const std::pair job{that_runs(program, setup.support), setup};
      const auto place = std::ranges::find(jobs, job);
      job_of.push_back(static_cast<std::size_t>(place - jobs.begin()));
      if (place == jobs.end()) jobs.push_back(job);
    }
  std::vector<Prediction> results(jobs.size());
  const auto run = [&](std::size_t i) {
    results[i] = predict(data, ensolite, jobs[i].first, jobs[i].second);
  };
  on_all_cores(jobs.size(), run, progress);
  std::vector<Prediction> predictions;
  for (std::size_t i = 0; i < job_of.size(); ++i) {
    predictions.push_back(results[job_of[i]]);
    predictions.back().program = which[i % which.size()];
  }
  return predictions;
}

const Prediction* find(const std::vector<Prediction>& predictions, Program program, const Setup& setup) {
  const auto found = std::ranges::find_if(predictions, [&](const Prediction& prediction) {
    return prediction.program == program && prediction.setup == setup;
  });
  return found == predictions.end() ? nullptr : &*found;
}

}  // namespace dashpad::report1986
