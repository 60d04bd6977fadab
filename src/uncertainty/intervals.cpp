#include "dashpad/uncertainty/intervals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include <tbb/parallel_for.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "result/possible_range.hpp"
#include "result/summary_values.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::uncertainty {

std::vector<Part> parts_of(const Pad& pad, const Summary& summary) {
  if (pad.layers.empty()) return {{&pad.material, summary.peak_strain, summary.peak_strain_rate}};
  std::vector<Part> parts;
  for (std::size_t i = 0; i < pad.layers.size(); ++i)
    parts.push_back({&pad.layers[i].material, i < summary.layers.size() ? summary.layers[i].peak_strain : 0,
                     i < summary.layers.size() ? summary.layers[i].peak_strain_rate : 0});
  return parts;
}

Open open_sources_of(const ImpactCase& impact, const Summary& summary) {
  Open open;
  add_continuation(impact, summary, open);
  add_rate(impact, summary, open);
  add_way_back(impact, summary, open);
  add_statistics(impact, summary, open);
  add_neighbours(impact, summary, open);
  return open;
}

namespace {

/// Runs of the impacts at the places of lines: the first of these numbers with which no error estimate of
/// theirs exceeds `error_of_few_runs`. What so few runs leave of the error is nearly alike at all places, and
/// cancels in the differences.
constexpr int few_runs[]{2, 3};
constexpr double error_of_few_runs = 0.03;
/// Tolerance of the impacts if with none of them they do.
constexpr double tolerance_of_ends = 1e-3;
/// Share of the nominal figure that a point between the ends must add to be solved.
constexpr double worth_solving = 3e-3;
/// Largest relative error of the peak force of an impact that is used.
constexpr double largest_error = 0.05;

/// A figure that gets an interval.
struct AskedFigure {
  const ResultQuantity* quantity;
  double level = 0;  ///< level of a dwell time, m/s2
};

/// All figures that get an interval, with a dwell time for each level.
std::vector<AskedFigure> asked_figures(std::span<const double> dwell_levels) {
  std::vector<AskedFigure> asked;
  for (const ResultQuantity& result_quantity : result_quantities())
    if (result_quantity.role.doubt == Doubt::of_level) {
      for (const double level : dwell_levels) asked.push_back({&result_quantity, level});
    } else if (result_quantity.has_interval()) {
      asked.push_back({&result_quantity});
    }
  return asked;
}

/// The values of the figures in SI; NaN where the impact has none.
std::vector<double> figures_of(const Solution& solution, std::span<const AskedFigure> asked) {
  const Summary& summary = solution.summary;
  const auto injury = injury::whole_pulse_figures(solution);
  const auto value_of = [&](const AskedFigure& figure) {
    for (const SummaryQuantity& summary_quantity : summary_quantities())
      if (figure.quantity == summary_quantity.quantity) return summary_quantity.of(summary).value;
    if (!injury) return no_value;
    if (figure.quantity->role.doubt == Doubt::of_level)
      return injury::cumulative_dwell(injury::pulse_of(solution.history), figure.level);
    const auto of = injury::injury_value(*injury, *figure.quantity);
    return of ? of->value : no_value;
  };
  std::vector<double> values;
  for (const AskedFigure& figure : asked) values.push_back(value_of(figure));
  return values;
}

/// A solved place of a line.
struct Place {
  double at = 0;
  std::vector<double> change;  ///< figures less those of the base
};

/// A line with its solved places.
struct Solved {
  const Line* line = nullptr;
  std::vector<Place> places = {};  ///< in order, the base among them
  bool is_mirrored = false;        ///< only one end of a symmetric line was solved
  bool failed = false;
};

/// The largest error estimate of the figures that get intervals, and of those of which they are made.
double largest_estimate(const ErrorEstimates& errors) {
  return std::max({errors.peak_force, errors.peak_motion, errors.peak_penetration, errors.rebound_speed,
                   errors.bottomed, errors.support});
}

/// The figures of a case; empty if it was not solved well enough, which a fixed number of runs decides by the
/// error estimates. Forces of a pad that bottoms are infinite.
std::vector<double> solved_figures(const ImpactCase& impact, const Options& options,
                                   const std::vector<AskedFigure>& asked) {
  if (!violations(impact).empty()) return {};
  const Solution solution = solve(impact, options);
  const Summary& summary = solution.summary;
  if (options.fixed_runs > 0 && !(largest_estimate(summary.errors) <= error_of_few_runs)) return {};
  std::vector<double> values = figures_of(solution, asked);
  if (bottomed_on_rigid_support(summary)) {
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (std::isnan(values[i])) values[i] = asked[i].quantity->role.needs == Needs::release ? 0 : infinite;
    return values;
  }
  if (summary.status == Status::not_run || is_cut(summary) || !(summary.errors.peak_force < largest_error))
    return {};
  return values;
}

class Search {
 public:
  Search(const ImpactCase& impact, const Options& options, const Solution& nominal,
         const std::vector<AskedFigure>& asked, const std::vector<Line>& lines)
      : impact_(impact), options_(options), asked_(asked), nominal_(figures_of(nominal, asked)) {
    options_.tolerance = std::max(options.tolerance, tolerance_of_ends);
    for (const int runs : few_runs) {
      options_.fixed_runs = runs;
      if (solve(lines)) return;
    }
    options_.fixed_runs = 0;
    solve(lines);
  }

  [[nodiscard]] const std::vector<Solved>& solved() const { return solved_; }
  [[nodiscard]] const std::vector<double>& nominal() const { return nominal_; }
  [[nodiscard]] int impacts() const { return impacts_; }

 private:
  struct Job {
    Solved* of;
    double at;
    std::vector<double> figures = {};
  };

  /// Returns whether every impact was solved well enough.
  bool solve(const std::vector<Line>& lines) {
    solved_.clear();
    impacts_ = 0;
    for (const Line& line : lines) solved_.push_back({.line = &line});
    solve_ends();
    solve_between();
    return std::ranges::none_of(solved_, &Solved::failed);
  }

  void solve_all(std::vector<Job>& jobs) {
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
      Job& job = jobs[i];
      ImpactCase impact = impact_;
      if (job.of) job.of->line->move(impact, job.at);
      job.figures = solved_figures(impact, options_, asked_);
    });
    impacts_ += static_cast<int>(jobs.size());
  }

  /// Adds solved places to their lines, in order.
  void take(const std::vector<Job>& jobs) {
    for (const Job& job : jobs) {
      if (job.of == nullptr) continue;
      if (job.figures.empty() || base_.empty()) {
        job.of->failed = true;
        continue;
      }
      Place place{job.at, job.figures};
      for (std::size_t i = 0; i < place.change.size(); ++i) place.change[i] -= base_[i];
      job.of->places.push_back(std::move(place));
      std::ranges::sort(job.of->places, {}, &Place::at);
    }
  }

  void solve_ends() {
    if (solved_.empty()) return;
    std::size_t ends = 0;
    for (const Solved& solved : solved_) ends += solved.line->ends.size();
    // If there are too many ends, axes of a posterior are taken to be symmetric.
    for (Solved& solved : solved_)
      if (ends > max_impacts - 1 && solved.line->source == Source::posterior) {
        solved.is_mirrored = true;
        --ends;
      }
    std::vector<Job> jobs{{nullptr, 0}};
    for (Solved& solved : solved_) {
      if (solved.is_mirrored) {
        jobs.push_back({&solved, solved.line->ends.back()});
        continue;
      }
      for (const double end : solved.line->ends) jobs.push_back({&solved, end});
    }
    for (Solved& solved : solved_)
      if (solved.line->ends.size() == 1 && jobs.size() < max_impacts)
        jobs.push_back({&solved, solved.line->ends.front() / 2});
    solve_all(jobs);
    base_ = std::move(jobs.front().figures);
    for (Solved& solved : solved_) solved.places.push_back({0, std::vector<double>(asked_.size(), 0.0)});
    take(jobs);
  }

  /// Solves one more place of each range that bends enough, at the vertex of a parabola.
  void solve_between() {
    std::vector<Job> jobs;
    for (Solved& solved : solved_) {
      if (solved.failed || is_statistical(solved.line->source) ||
          impacts_ + static_cast<int>(jobs.size()) >= max_impacts)
        continue;
      double most = worth_solving;
      std::optional<double> best;
      for (std::size_t figure = 0; figure < asked_.size(); ++figure)
        for (std::size_t i = 0; i + 2 < solved.places.size(); ++i)
          if (const auto turn = turning_point(solved, i, figure); turn && turn->second > most) {
            most = turn->second;
            best = turn->first;
          }
      if (best) jobs.push_back({&solved, *best});
    }
    if (jobs.empty()) return;
    solve_all(jobs);
    take(jobs);
  }

  /// Vertex of the parabola through three places, and how far it leaves their hull, over the nominal.
  [[nodiscard]] std::optional<std::pair<double, double>> turning_point(const Solved& solved,
                                                                       std::size_t first,
                                                                       std::size_t figure) const {
    const Place *a = &solved.places[first], *b = a + 1, *c = a + 2;
    const double fa = a->change[figure], fb = b->change[figure], fc = c->change[figure];
    if (!std::isfinite(fa) || !std::isfinite(fb) || !std::isfinite(fc)) return std::nullopt;
    const double slope_1 = (fb - fa) / (b->at - a->at), slope_2 = (fc - fb) / (c->at - b->at);
    const double bend = (slope_2 - slope_1) / (c->at - a->at);
    if (bend == 0) return std::nullopt;
    const double turn = (a->at + b->at) / 2 - slope_1 / (2 * bend);
    const double margin = 0.02 * (c->at - a->at);
    if (turn < a->at + margin || turn > c->at - margin || std::abs(turn - b->at) < margin)
      return std::nullopt;
    const double value = fa + (turn - a->at) * (slope_1 + bend * (turn - b->at));
    const auto [low, high] = std::minmax({fa, fb, fc});
    const double beyond = std::max(value - high, low - value);
    return std::pair{turn, beyond / std::max(std::abs(nominal_[figure]), 1e-300)};
  }

  const ImpactCase& impact_;
  Options options_;
  const std::vector<AskedFigure>& asked_;
  std::vector<double> nominal_, base_;
  std::vector<Solved> solved_;
  int impacts_ = 0;  ///< of the last attempt
};

/// Distances of the ends of an interval below and above the nominal figure.
struct Deviation {
  double down = 0, up = 0;

  void add(const Deviation& other) {
    down += other.down;
    up += other.up;
  }
  void add_in_quadrature(const Deviation& other) {
    down = std::hypot(down, other.down);
    up = std::hypot(up, other.up);
  }
};

/// The deviation by a line: the hull of its places for a range, else 1.96 standard deviations.
Deviation deviation_of(const Solved& solved, std::size_t figure) {
  Deviation deviation;
  for (const Place& place : solved.places) {
    const double change = place.change[figure];
    if (std::isnan(change)) continue;
    deviation.down = std::max(deviation.down, -change);
    deviation.up = std::max(deviation.up, change);
  }
  if (solved.is_mirrored) deviation.down = deviation.up = std::max(deviation.down, deviation.up);
  if (is_statistical(solved.line->source)) {
    const double factor = two_sided_95 / solved.line->deviations;
    deviation.down *= factor;
    deviation.up *= factor;
  }
  return deviation;
}

/// The deviation at 95 % by a source given as shares.
Deviation deviation_of(const Shares& shares, const AskedFigure& figure, double nominal,
                       const Solution& solution) {
  if (figure.quantity->role.doubt == Doubt::of_level) {
    // A pulse scaled up by a share exceeds a level as long as the pulse exceeds a lower one.
    const Pulse pulse = injury::pulse_of(solution.history);
    const double share = two_sided_95 * shares.acceleration;
    return {nominal - injury::cumulative_dwell(pulse, figure.level * (1 + share)),
            injury::cumulative_dwell(pulse, figure.level * std::max(1 - share, 0.0)) - nominal};
  }
  const auto change = [&](double deviations) {
    return change_of(*figure.quantity, nominal, solution.summary, shares, deviations);
  };
  return {-change(-two_sided_95), change(two_sided_95)};
}

constexpr std::array all_sources{Source::continuation, Source::rate,   Source::way_back,  Source::scatter,
                                 Source::posterior,    Source::misfit, Source::neighbours};

/// The ends of an interval, without what the figure cannot be; a law that allows more keeps its own figure.
std::pair<double, double> possible_ends(const ImpactCase& impact, const AskedFigure& asked, double nominal,
                                        const Deviation& deviation) {
  const PossibleRange range = possible_range(*asked.quantity);
  return {std::min(nominal, std::max(nominal - deviation.down, range.least)),
          std::max(nominal, std::min(nominal + deviation.up, max_in(impact, range.most)))};
}

/// The interval of a figure by Eq. 58.
FigureInterval interval_of(const ImpactCase& impact, const AskedFigure& asked, std::size_t figure,
                           double nominal, const Search& search, const Open& open, const Solution& solution) {
  FigureInterval interval{.key = asked.quantity->key, .level = asked.level, .nominal = nominal};
  Deviation ranges, statistics;
  for (const Source source : all_sources) {
    Deviation alone;
    const auto add = [&](const Deviation& more) {
      is_statistical(source) ? alone.add_in_quadrature(more) : alone.add(more);
    };
    for (const Solved& each : search.solved())
      if (each.line->source == source && !each.failed) add(deviation_of(each, figure));
    for (const Shares& shares : open.shares)
      if (shares.source == source) add(deviation_of(shares, asked, nominal, solution));
    if (alone.down <= 0 && alone.up <= 0) continue;
    const auto [low, high] = possible_ends(impact, asked, nominal, alone);
    interval.sources.push_back({source, low, high});
    is_statistical(source) ? statistics.add_in_quadrature(alone) : ranges.add(alone);
  }
  Deviation all = ranges;
  all.add(statistics);
  std::tie(interval.low, interval.high) = possible_ends(impact, asked, nominal, all);
  std::ranges::stable_sort(interval.sources, std::greater<>(), [](const Contribution& contribution) {
    return contribution.high - contribution.low;
  });
  return interval;
}

}  // namespace

void add_intervals(const ImpactCase& impact, const Options& options, Solution& solution,
                   std::span<const double> dwell_levels) {
  const Summary& summary = solution.summary;
  if (summary.status == Status::not_run) return;
  Open open = open_sources_of(impact, summary);
  Intervals intervals{.sources = std::move(open.sources), .warning = warning_of_model(impact)};
  if (!bottomed_on_rigid_support(summary) && !is_cut(summary)) {
    const std::vector<AskedFigure> asked = asked_figures(dwell_levels);
    const Search search(impact, options, solution, asked, open.lines);
    intervals.impacts = search.impacts();
    for (const Solved& each : search.solved())
      if (each.failed)
        for (OpenSource& source : intervals.sources)
          if (source.source == each.line->source && source.why_not.empty())
            source.why_not = "an impact at one end of its range could not be solved";
    for (std::size_t i = 0; i < asked.size(); ++i)
      if (std::isfinite(search.nominal()[i]))
        intervals.figures.push_back(
            interval_of(impact, asked[i], i, search.nominal()[i], search, open, solution));
  }
  solution.summary.intervals = std::move(intervals);
}

}  // namespace dashpad::uncertainty
