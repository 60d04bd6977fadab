#include "dashpad/report1986/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "dashpad/spit1984/run.hpp"
#include "dashpad/version.hpp"
#include "json/json_values.hpp"
#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "quantities/text.hpp"

namespace dashpad::report1986 {

namespace {

ComparedRun accurate(std::string name, const ImpactCase& impact, const Options& options) {
  Solution solution = solve(impact, options);
  const Summary& summary = solution.summary;
  ComparedRun run;
  run.name = std::move(name);
  if (!summary.trustworthy()) run.remark = "TOLERANCE NOT MET: " + to_string(summary.status);
  if (summary.bottomed)
    run.remark +=
        std::string{run.remark.empty() ? "" : "; "} + "BOTTOMED: the pad was fully compressed for a while";
  run.finished = summary.release.has_value();
  run.trustworthy = summary.trustworthy();
  run.peak_force = summary.peak_force;
  run.time_of_peak_force = summary.time_of_peak_force;
  run.peak_penetration = summary.peak_penetration;
  run.peak_motion = summary.peak_motion;
  if (run.finished && summary.force_below_weight) {
    run.end_time = summary.force_below_weight->time;
    run.end_speed = -summary.force_below_weight->velocity;
  }
  run.time = std::move(solution.history.time);
  run.force = std::move(solution.history.force);
  run.penetration = std::move(solution.history.penetration);
  return run;
}

std::string remark_on(const spit1984::Run& run, double tolerance) {
  using namespace spit1984;
  std::string remark;
  if (run.abend != Abend::none)
    remark = fmt::format("ABEND {} ({}) at {:.4g} ms", static_cast<int>(run.abend),
                         text_of(run.abend).message, run.duration_ms);
  if (run.precision_stops.empty()) return remark;
  if (!remark.empty()) remark += "; ";
  return remark + fmt::format("PRECISION LIMIT: {} {} out of equilibrium by more than {:.2g} % of the force",
                              plural(run.precision_stops.size(), "step"),
                              run.precision_stops.size() == 1 ? "is" : "are", 100 * tolerance);
}

ComparedRun historical(std::string name, const spit1984::Deck& deck, const spit1984::Settings& settings,
                       const spit1984::Progress& progress) {
  const spit1984::Run program = spit1984::run(deck, settings, progress);
  const double inch = to_si("1 in", "m"), pound = to_si("1 lbf", "N");
  ComparedRun run;
  run.name = std::move(name);
  run.remark = remark_on(program, settings.equilibrium_tolerance);
  run.finished = program.abend == spit1984::Abend::none;
  if (std::isfinite(program.peak_force_lb)) {
    run.peak_force = -program.peak_force_lb * pound;
    run.time_of_peak_force = program.time_of_peak_force_ms * 1e-3;
  }
  const std::size_t accepted = program.history.size() - (program.last_step_accepted ? 0 : 1);
  for (std::size_t i = 0; i < accepted; ++i) {
    const spit1984::Step& step = program.history[i];
    run.time.push_back(step.time_ms * 1e-3);
    run.force.push_back(-step.force_lb * pound);
    run.penetration.push_back(step.penetration_in * inch);
    run.peak_penetration = std::max(run.peak_penetration, step.penetration_in * inch);
    run.peak_motion = std::max(run.peak_motion, step.motion_in * inch);
  }
  if (run.finished) {
    run.end_time = program.duration_ms * 1e-3;
    run.end_speed = -program.history.back().speed_in_per_s * inch;
  }
  return run;
}

/// The time steps that the program of 1984 takes if its impact lasts as long as the accurate one.
std::size_t expected_steps(const ComparedRun& accurate, double time_step, int dimension) {
  if (!accurate.end_time) return static_cast<std::size_t>(dimension);
  return static_cast<std::size_t>(std::min(*accurate.end_time / time_step, 1.0 * dimension)) + 1;
}

/// A value in the units shown, or a dash.
std::string shown(std::optional<double> value, const char* si_unit, const UnitSystem& units) {
  return value ? significant(value_in(units, *value, si_unit)) : "-";
}

/// The signed difference from the reference, %.
std::string deviation(std::optional<double> value, std::optional<double> reference) {
  if (!value || !reference || *reference == 0) return "";
  const double percent = 100 * (*value / *reference - 1);
  return std::abs(percent) < 1000 ? fmt::format("{:+.2f}", percent) : "far off";
}

/// "The peak force of the 1984 program is 5.30 % above that of the accurate solution ...", or no end.
std::string answer(const Comparison& comparison) {
  const ComparedRun& program = comparison.runs[Comparison::program];
  const std::string off = deviation(program.peak_force, comparison.runs[Comparison::reference].peak_force);
  if (!program.finished || off.empty()) return "The 1984 program does not reach the end of the impact";
  return fmt::format(
      "The peak force of the 1984 program is {} that of the accurate solution of its equations",
      off == "far off" ? "far above" : off.substr(1) + (off[0] == '-' ? " % below" : " % above"));
}

output::Table table_of(const Comparison& comparison, const UnitSystem& units) {
  const auto in_unit = [&](const char* what, const char* si_unit) {
    return fmt::format("{} ({})", what, shown_unit(unit_for(units, si_unit)));
  };
  const ComparedRun& reference = comparison.runs[Comparison::reference];
  output::Table table{.columns = {"Run", in_unit("Peak force", "N"), "% off", in_unit("Time to peak", "s"),
                                  in_unit("Peak penetration", "m"), in_unit("Peak displacement", "m"),
                                  in_unit("End speed", "m/s"), "% off", in_unit("End", "s")}};
  for (const ComparedRun& run : comparison.runs) {
    const bool is_reference = &run == &reference;
    table.rows.push_back({run.name, shown(run.peak_force, "N", units),
                          is_reference ? "" : deviation(run.peak_force, reference.peak_force),
                          shown(run.time_of_peak_force, "s", units), shown(run.peak_penetration, "m", units),
                          shown(run.peak_motion, "m", units), shown(run.end_speed, "m/s", units),
                          is_reference ? "" : deviation(run.end_speed, reference.end_speed),
                          shown(run.end_time, "s", units)});
  }
  return table;
}

/// A column of all runs over time. Each run is drawn up to twice the reference peak, because absurd forces
/// may precede an ABEND.
output::Panel panel(const Comparison& comparison, const char* title, const char* quantity,
                    const char* si_unit, std::vector<double> ComparedRun::*values, double peak,
                    const UnitSystem& units) {
  const auto axis = [&](const char* text, const char* unit) {
    return output::Axis{.label = fmt::format("{} ({})", text, shown_unit(unit_for(units, unit)))};
  };
  output::Panel panel{title, axis("Time", "s"), axis(quantity, si_unit), {}};
  for (const ComparedRun& run : comparison.runs) {
    if (&run == &comparison.runs.front()) continue;  // looks the same as the reference at this scale
    output::Series& drawn = panel.series.emplace_back();
    drawn.label = run.name;
    for (std::size_t i = 0; i < run.time.size() && std::abs((run.*values)[i]) <= 2 * peak; ++i)
      drawn.add(value_in(units, run.time[i], "s"), value_in(units, (run.*values)[i], si_unit));
  }
  return panel;
}

}  // namespace

Comparison compare(const ImpactCase& impact, const Options& options, double time_step,
                   const ComparisonProgress& progress) {
  using namespace spit1984;
  if (const auto broken = what_a_deck_cannot_say(impact); !broken.empty())
    throw std::invalid_argument(broken.front().key + ": " + broken.front().rule);
  Deck deck = deck_of(impact);
  deck.time_step_ms = 1e3 * time_step;

  Comparison comparison;
  comparison.time_step = time_step;
  comparison.dimension = std::max(1000, static_cast<int>(std::min(0.1 / time_step, 1e6)));
  comparison.runs.push_back(accurate("accurate", impact, options));
  comparison.runs.push_back(
      accurate("accurate, constants of 1984", with_the_constants_of_1984(impact), options));
  constexpr std::size_t runs = 4;
  const std::size_t expected =
      expected_steps(comparison.runs[Comparison::reference], time_step, comparison.dimension);
  std::size_t runs_done = 0;
  const auto add = [&](std::string name, const Settings& settings) {
    comparison.runs.push_back(historical(std::move(name), deck, settings, [&](int step) {
      if (progress)
        progress(runs_done * expected + std::min(static_cast<std::size_t>(step), expected), runs * expected);
    }));
    ++runs_done;
  };
  Settings settings;
  settings.max_steps = settings.max_stations = comparison.dimension;
  for (const Arithmetic arithmetic : {Arithmetic::pdp10, Arithmetic::binary32, Arithmetic::binary64}) {
    settings.arithmetic = arithmetic;
    add(fmt::format("1984, {}", to_string(arithmetic)), settings);
  }
  settings.defects = all_mended;
  add("1984, mended, binary64", settings);
  return comparison;
}

output::Document comparison_document(const Comparison& comparison, const ImpactCase& impact,
                                     const UnitSystem& units, output::Pictures pictures) {
  output::Document document{.title = impact.title, .lead = output::Lead{.answer = answer(comparison)}};
  for (const ComparedRun& run : comparison.runs)
    if (!run.remark.empty())  // the answer is about the program: its remark comes first
      document.warnings.insert(
          &run == &comparison.runs[Comparison::program] ? document.warnings.begin() : document.warnings.end(),
          run.name + ": " + run.remark);
  document.lead->subject = {one_line(impact.title)};
  if (pictures == output::Pictures::drawn)
    document.lead->curve = output::untitled(comparison_plot(comparison, impact, units));
  document.sections = {
      {.heading = "Runs",
       .seen = output::Seen::always,
       .paragraphs =
           {fmt::format("% off is the difference from \"{}\", the solution of the same equations with the "
                        "constants of the 1984 program (1 mph = 17.64 in/s, g = 386.4 in/s2).",
                        comparison.runs[Comparison::reference].name),
            "The impact ends when the force falls below the sphere's weight on rebound. If a run ends in an "
            "ABEND, its results may have become meaningless some time before."},
       .tables = {table_of(comparison, units)}},
      {.heading = output::basis_heading,
       .seen = output::Seen::always,
       .paragraphs = output::case_lines(impact, units)}};
  return document;
}

std::string comparison_json(const Comparison& comparison) {
  Json runs = Json::array();
  for (const ComparedRun& run : comparison.runs)
    runs.push_back({{"name", run.name},
                    {"finished", run.finished},
                    {"trustworthy", run.trustworthy},
                    {"remark", run.remark},
                    {"peak_force_N", number(run.peak_force)},
                    {"time_to_peak_force_s", number(run.time_of_peak_force)},
                    {"peak_penetration_m", number(run.peak_penetration)},
                    {"peak_motion_m", number(run.peak_motion)},
                    {"end_time_s", number(run.end_time)},
                    {"end_speed_m_per_s", number(run.end_speed)}});
  const Json result{{"runs", runs},
                    {"reference", comparison.runs[Comparison::reference].name},
                    {"time_step_of_1984_s", comparison.time_step},
                    {"dimension_of_1984", comparison.dimension},
                    {"program", program_json()}};
  return result_json_text(result);
}

output::Plot comparison_plot(const Comparison& comparison, const ImpactCase& impact,
                             const UnitSystem& units) {
  const ComparedRun& reference = comparison.runs[Comparison::reference];
  output::Panel force =
      panel(comparison, "Force", "Force", "N", &ComparedRun::force, reference.peak_force.value_or(0), units);
  force.y.low = 0;
  const output::Panel penetration = panel(comparison, "Penetration of the pad", "Penetration", "m",
                                          &ComparedRun::penetration, reference.peak_penetration, units);
  return {impact.title.empty() ? "The 1984 program and the accurate solver" : impact.title,
          {force, penetration},
          fmt::format("dashpad {}; unfinished runs are drawn up to twice the reference peak", version())};
}

}  // namespace dashpad::report1986
