/// Made-up playground mats whose law is known and none of Dashpad's (answers/true_mat.hpp): three drops each,
/// a fit to the three pulses, and the HIC that the fitted card gives with its 95 % interval at two other
/// heights.
///
///   mats_of_known_truth                       seeds 1 to 60 of both laws
///   mats_of_known_truth --from 101 --mats 60  sixty others
///   mats_of_known_truth --mats 4 --least 3    exits with 1 unless each line of the table has three hits or
///   more

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "answers/program.hpp"
#include "answers/true_mat.hpp"
#include "dashpad/case/case_quantity.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/uncertainty/intervals.hpp"

namespace dashpad::test {
namespace {

struct Settings {
  std::uint64_t from = 1, mats = 60;
  int least = 0;
  bool all = false;
};

/// What is sought of the law `foam`, as a user would: bounds far apart, and a start that fits no mat.
fit::Fit fit_of(const DrawnMat& drawn, std::uint64_t seed) {
  Foam foam;
  foam.friction = 0.05;
  foam.unloading_factor = 0.5;
  foam.recoil = 0.2;
  foam.curves.base = AvalleCurve{80e3, 1.5e6, 1, 80e3, 2, 0.9};
  foam.curves.slowest_rate = 0.01;
  foam.curves.rate_effect = PowerRateEffect{0.05, 0, 1000};
  fit::Fit fit;
  fit.title = "Mat";
  fit.has_case = true;
  fit.base.impactor = {missile_mass, Sphere{.radius = missile_radius}, 5, standard_gravity};
  fit.base.pad.thickness = drawn.mat.thickness;
  fit.base.pad.material.name = "mat";
  fit.base.pad.material.title = "Mat";
  fit.base.pad.material.law = foam;
  const auto seek = [&](const char* key, double lowest, double highest) {
    for (const CaseQuantity& quantity : quantities_of(fit.base))
      if (quantity.key == key)
        fit.unknowns.push_back({key,
                                quantity.unit,
                                lowest,
                                highest,
                                quantity.get(fit.base),
                                lowest > 0 && highest > 10 * lowest,
                                {}});
  };
  seek("pad.curve.plateau_stress", 5e3, 1e6);
  seek("pad.curve.densification_stress", 1e3, 2e6);
  seek("pad.curve.densification_exponent", 0.6, 6);
  seek("pad.parameters.unloading_factor", 0, 1);
  seek("pad.parameters.recoil", 0, 1);
  seek("pad.rate.exponent", 0, 0.3);
  std::uint64_t which = 0;
  for (const double share : {0.5, 0.75, 1.0}) {
    fit::ImpactMeasurement impact;
    impact.file = fmt::format("drop from {:.0f} % of the highest", 100 * share);
    impact.impact = fit.base;
    impact.impact.impactor.speed = std::sqrt(2 * standard_gravity * share * drawn.highest);
    impact.pulse =
        fit::deceleration_of({measured_pulse(dropped(drawn.mat, share * drawn.highest), seed, which++)});
    impact.pulse->file = "made up";
    impact.pulse->deviation = 0.02 * impact.pulse->peak;
    fit.impacts.push_back(impact);
  }
  fit.starts = 2;
  return fit;
}

/// HIC of any window by the card, with what is not known of it.
FigureInterval hic_of(const fit::Fit& fit, const Material& card, double height) {
  ImpactCase impact = fit.base;
  impact.pad.material = card;
  impact.impactor.speed = std::sqrt(2 * standard_gravity * height);
  Solution solution = solve(impact);
  uncertainty::add_intervals(impact, {}, solution);
  for (const FigureInterval& figure : solution.summary.intervals.value().figures)
    if (figure.key == "hic_unlimited") return figure;
  return {};
}

std::string words_of(const FigureInterval& figure) {
  std::string words;
  for (const Contribution& contribution : figure.sources)
    words += fmt::format("{} {} {:+.0f} {:+.0f} %", words.empty() ? "" : ",", to_string(contribution.source),
                         100 * (contribution.low / figure.nominal - 1),
                         100 * (contribution.high / figure.nominal - 1));
  return words;
}

/// One height of one law over all mats.
struct Line {
  std::string law, height;
  int hits = 0, mats = 0;
  std::vector<double> widths = {}, off = {};
  std::vector<std::uint64_t> missed = {};

  void add(std::uint64_t seed, const FigureInterval& interval, double truth) {
    ++mats;
    widths.push_back((interval.high - interval.low) / interval.nominal);
    off.push_back(std::abs(interval.nominal / truth - 1));
    if (interval.low <= truth && truth <= interval.high)
      ++hits;
    else
      missed.push_back(seed);
  }
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
}

double percent(double share) { return 100 * share; }

struct Law {
  TrueLaw law;
  const char* name;
};

void try_mat(const Law& law, std::uint64_t seed, const Settings& settings, Line& within, Line& beyond) {
  const auto start = std::chrono::steady_clock::now();
  const DrawnMat drawn = drawn_mat(law.law, seed);
  const fit::Fit fit = fit_of(drawn, seed);
  const fit::FitReport report = fit::run_fit(fit);
  const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!report.converged || !report.material.uncertainty.misfit) {
    // A mat without an answer is one that was missed.
    fmt::print("{}, seed {}: no fit: {}\n", law.name, seed, report.why_not);
    for (Line* line : {&within, &beyond}) {
      ++line->mats;
      line->missed.push_back(seed);
    }
    return;
  }
  const auto ask = [&](Line& line, double height) {
    const double truth = dropped(drawn.mat, height).hic;
    const FigureInterval interval = hic_of(fit, report.material, height);
    line.add(seed, interval, truth);
    if (settings.all)
      fmt::print("{}, seed {}, {:.2f} m: HIC {:.0f}, {:.0f} to {:.0f} ({} ); true {:.0f}{}\n", law.name, seed,
                 height, interval.nominal, interval.low, interval.high, words_of(interval), truth,
                 interval.low <= truth && truth <= interval.high ? "" : "  MISSED");
  };
  ask(within, drawn.within);
  ask(beyond, drawn.beyond);
  if (settings.all)
    fmt::print("  {:.0f} mm; misfit of HIC {:.1f} %, {} evaluations in {:.1f} s\n", 1e3 * drawn.mat.thickness,
               percent(report.material.uncertainty.misfit->hic), report.evaluations, time);
  std::fflush(stdout);
}

int run(CLI::App& app, int count, char** arguments) {
  Settings settings;
  app.add_option("--mats", settings.mats, "Number of mats of each law")->capture_default_str();
  app.add_option("--from", settings.from, "First seed")->capture_default_str();
  app.add_option("--least", settings.least,
                 "Exit with 1 unless so many hold the truth, at each height of each law");
  app.add_flag("--all", settings.all, "Print every mat");
  app.parse(count, arguments);
  std::vector<Line> table;
  for (const Law& law :
       {Law{TrueLaw::maxwell_branch, "Maxwell branch"}, Law{TrueLaw::enclosed_air, "enclosed air"}}) {
    Line within{law.name, "within"}, beyond{law.name, "20 % beyond"};
    for (std::uint64_t i = 0; i < settings.mats; ++i)
      try_mat(law, settings.from + i, settings, within, beyond);
    table.push_back(std::move(within));
    table.push_back(std::move(beyond));
  }
  fmt::print("law             height       truth held  median width  median error  missed seeds\n");
  bool is_good = true;
  for (const Line& line : table) {
    fmt::print("{:15} {:11} {:4} of {:3}  {:10.1f} %  {:10.1f} %  {}\n", line.law, line.height, line.hits,
               line.mats, percent(median(line.widths)), percent(median(line.off)),
               fmt::join(line.missed, " "));
    is_good = is_good && line.hits >= settings.least;
  }
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace dashpad::test

int main(int count, char** arguments) {
  return dashpad::test::run_program("mats_of_known_truth",
                                    "95 % intervals of HIC against made-up mats of known truth", count,
                                    arguments, dashpad::test::run);
}
