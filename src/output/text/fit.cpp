// A fit for the terminal.

#include "dashpad/output/fit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string count_of(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// "7 unknowns from 150 points of 1 test."
std::string fit_answer(const fit::FitReport& report) {
  const auto fitted = static_cast<std::size_t>(
      std::ranges::count_if(report.tests, [](const fit::MetTest& test) { return !test.is_held_out; }));
  const auto figures = static_cast<std::size_t>(
      std::ranges::count_if(report.figures, [](const fit::MetFigure& of) { return !of.is_held_out; }));
  std::size_t open = 0;
  std::size_t unknowns = 0;
  for (const fit::FittedUnknown& unknown : report.unknowns) {
    unknowns += unknown.is_nuisance ? 0 : 1;
    open += unknown.is_nuisance || unknown.is_identified() ? 0 : 1;
  }
  std::string text = count_of(unknowns, "unknown");
  if (fitted > 0)
    text +=
        fmt::format(" from {} of {}", count_of(report.points - figures, "point"), count_of(fitted, "test"));
  if (figures > 0)
    text += fmt::format("{}{} of impacts", fitted > 0 ? " and " : " from ", count_of(figures, "figure"));
  if (report.priors > 0) text += " and " + count_of(report.priors, "prior");
  text += open == 0 ? ": the data determine all of them.\n"
                    : fmt::format(": the data determine {}, and leave {} open.\n", unknowns - open, open);
  if (report.starts_at_best == 0)
    return text + "The best fit was met away from all starts, on the way along a profile.\n";
  return text + fmt::format(
                    "{} of {} starts came to the same misfit{}.\n", report.starts_at_best, report.starts,
                    report.starts_failed > 0
                        ? fmt::format("; {} made no valid material or did not converge", report.starts_failed)
                        : "");
}

std::string interval_words(const fit::FittedUnknown& of, const UnitSystem& units) {
  const auto shown = [&](double value) { return brief_quantity(value, of.unit, units, 4); };
  if (of.low && of.high) return shown(*of.low) + " to " + shown(*of.high);
  if (of.low) return "above " + shown(*of.low) + ", open above";
  if (of.high) return "below " + shown(*of.high) + ", open below";
  return "open on both sides";
}

Table table_of_unknowns(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"unknown", "value", "standard error", "95 % interval", ""}};
  for (const fit::FittedUnknown& of : report.unknowns)
    table.rows.push_back({of.key, brief_quantity(of.value, of.unit, units, 4),
                          of.standard_error ? brief_quantity(*of.standard_error, of.unit, units, 2) : "none",
                          interval_words(of, units),
                          of.is_at_lowest    ? "at its lower bound"
                          : of.is_at_highest ? "at its upper bound"
                                             : ""});
  return table;
}

std::string rms_text(const std::optional<double>& rms, double largest, const UnitSystem& units) {
  if (!rms) return "not tested";
  return fmt::format("{}, {:.2g} %", brief_quantity(*rms, "Pa", units, 3), 100 * *rms / largest);
}

std::string loops_text(const fit::MetTest& test) {
  std::string text;
  for (const fit::Loop& loop : test.loops)
    text +=
        fmt::format("{}{:.3f}, {:.3f}", text.empty() ? "" : "; ", loop.measured_return, loop.computed_return);
  return text.empty() ? "no loop" : text;
}

Table table_of_tests(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"test", "points", "loading", "unloading", "energy return, test and model", ""}};
  for (const fit::MetTest& test : report.tests)
    table.rows.push_back({test.file, fmt::format("{}", test.points),
                          rms_text(test.rms_loading, test.largest_stress, units),
                          rms_text(test.rms_unloading, test.largest_stress, units), loops_text(test),
                          test.is_held_out ? "held out" : ""});
  return table;
}

Table table_of_figures(const fit::FitReport& report, const UnitSystem& units) {
  Table table{.columns = {"impact", "figure", "measured", "deviation", "model", "off by", ""}};
  for (const fit::MetFigure& of : report.figures) {
    const auto& names = fit::impact_figure_names();
    const auto name = std::ranges::find(names, of.figure, &fit::ImpactFigureName::figure);
    const auto shown = [&](double value, int digits) {
      return brief_quantity(value, name->unit, units, digits);
    };
    table.rows.push_back(
        {of.file, name->key, shown(of.measured, 4), shown(of.deviation, 2),
         of.computed ? shown(*of.computed, 4) : "none",
         of.computed ? fmt::format("{:+.1f} deviations", (*of.computed - of.measured) / of.deviation) : "",
         of.is_held_out ? "held out" : ""});
  }
  return table;
}

/// What cannot be told from the data, a sentence each.
std::vector<std::string> open_matters(const fit::FitReport& report) {
  std::vector<std::string> all;
  for (const std::vector<std::string>& keys : report.flat_directions) {
    std::string names;
    for (std::size_t i = 0; i < keys.size(); ++i)
      names += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + keys[i];
    all.push_back(keys.size() == 1 ? names + " is not determined by these data."
                                   : names + " are not told apart by these data.");
  }
  for (const fit::StrongCorrelation& of : report.correlations)
    all.push_back(fmt::format("The errors of {} and {} go together: correlation {:.3f}.", of.first, of.second,
                              of.value));
  return all;
}

std::vector<std::string> notes_on_noise(const fit::FitReport& report) {
  std::vector<std::string> all;
  if (!report.noise_is_stated)
    all.emplace_back(
        "Noise: not stated for all data; where it is not, it is taken from what the fit leaves, one share of "
        "the "
        "largest stress of each test.");
  else if (report.variance_scale > 1)
    all.push_back(
        fmt::format("Noise: chi-squared is {:.3g} per degree of freedom with the stated noise, so that the "
                    "model misses the "
                    "data by more than noise; errors are multiplied by {:.3g}.",
                    report.misfit_per_degree(), std::sqrt(report.variance_scale)));
  else
    all.push_back(fmt::format("Noise: chi-squared is {:.3g} per degree of freedom with the stated noise.",
                              report.misfit_per_degree()));
  for (const fit::MetTest& test : report.tests)
    if (!test.is_held_out && test.effective_points < static_cast<double>(test.points))
      all.push_back(
          fmt::format("{}: neighbouring residuals are correlated by {:.2f}, so that {} points are worth "
                      "{:.0f}; errors and "
                      "intervals are widened by that.",
                      test.file, test.autocorrelation, test.points, test.effective_points));
  return all;
}

}  // namespace

std::string fit_text(const fit::FitReport& report, const UnitSystem& units) {
  std::string text = report.title.empty() ? "" : one_line(report.title) + "\n";
  if (!report.converged)
    return text + "The fit did not converge: " + one_line(report.why_not) +
           ".\nThere is no card. Start nearer (start = ...), narrow the bounds, try more starts, or leave "
           "unknowns out that the data do not show.\n";
  text += fit_answer(report) + "\n" + plain_text(table_of_unknowns(report, units));
  if (const auto open = open_matters(report); !open.empty()) {
    text += "\n";
    for (const std::string& line : open) text += wrapped(line, 2) + "\n";
  }
  if (!report.tests.empty())
    text += "\nModel minus test, root mean square, and its share of the largest stress\n" +
            plain_text(table_of_tests(report, units));
  if (!report.figures.empty()) text += "\n" + plain_text(table_of_figures(report, units));
  text += "\n";
  for (const std::string& line : notes_on_noise(report)) text += wrapped(line, 2) + "\n";
  return text + fmt::format("{} evaluations in {:.2g} s (dashpad {})\n", report.evaluations, report.wall_time,
                            version());
}

std::string posterior_csv(const fit::FitReport& report) {
  std::string text;
  for (const fit::FittedUnknown& of : report.unknowns)
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", of.key,
                        of.unit == "1" ? "" : fmt::format(" [{}]", of.unit));
  text += "\n";
  for (const std::vector<double>& draw : report.posterior) {
    std::string row;
    for (const double value : draw) row += fmt::format("{}{}", row.empty() ? "" : ",", value);
    text += row + "\n";
  }
  return text;
}

}  // namespace dashpad::output
