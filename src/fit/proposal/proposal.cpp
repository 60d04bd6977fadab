// Proposing fits to tests, trying them, and choosing.

#include "dashpad/fit/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dashpad/quantities/constants.hpp"
#include "fit/proposal/candidates.hpp"
#include "fit/proposal/open_matters.hpp"

namespace dashpad::fit {

namespace {

constexpr double for_fewer_open = 1.2;  ///< a misfit so many times as large is taken for fewer open unknowns
constexpr double worth_a_slope = 0.95;

std::optional<double> misfit_of(const FitReport& report) {
  if (!report.converged) return std::nullopt;
  double sum = 0;
  std::size_t tests = 0;
  for (const MetTest& test : fitted(report.tests)) {
    double squares = 0;
    for (std::size_t i = 0; i < test.measured.size(); ++i) {
      const double miss = (test.computed[i] - test.measured[i]) / test.largest_stress;
      squares += miss * miss;
    }
    sum += squares / double(test.measured.size());
    ++tests;
  }
  return std::sqrt(sum / double(tests));
}

Tried tried(const Candidate& candidate, const FitReport& report) {
  Tried result{candidate.law, candidate.base, candidate.rate, misfit_of(report), 0, 0};
  for (const FittedUnknown& unknown : report.unknowns) {
    if (unknown.is_nuisance) continue;
    ++result.unknowns;
    result.open += unknown.is_identified() ? 0 : 1;
  }
  return result;
}

bool has_clear_slope(const FitReport& report) {
  const auto slope = std::ranges::find(report.unknowns, "pad.rate.exponent_slope", &FittedUnknown::key);
  return slope != report.unknowns.end() &&
         ((slope->low && *slope->low > 0) || (slope->high && *slope->high < 0));
}

/// Whether they differ by the slope of the rate's exponent alone.
bool is_variant(const Tried& first, const Tried& second) {
  return first.law == second.law && first.base == second.base;
}

/// Whether the second is to be taken rather than the first.
bool is_better(const Tried& first, const Tried& second, const FitReport& of_second) {
  if (!second.misfit || !first.misfit) return second.misfit.has_value();
  if (is_variant(first, second))
    return *second.misfit < worth_a_slope * *first.misfit && has_clear_slope(of_second);
  if (second.law != first.law) return *second.misfit < *first.misfit;
  if (second.open < first.open) return *second.misfit <= for_fewer_open * *first.misfit;
  if (second.open > first.open) return for_fewer_open * *second.misfit < *first.misfit;
  return *second.misfit < *first.misfit;
}

}  // namespace

input::Reading<Proposal> propose(const std::vector<std::filesystem::path>& files,
                                 std::span<const double> rates, const input::StressStrainColumns& wanted) {
  std::vector<input::Fault> faults;
  ReadTests tests = read_tests(files, rates, wanted, faults);
  if (!faults.empty()) return faults;
  Proposal proposal = proposal_for(std::move(tests), faults);
  if (!faults.empty()) return faults;
  return proposal;
}

AutoFit run_proposal(Proposal proposal, const RunOptions& options) {
  AutoFit result;
  std::vector<FitReport> reports;
  RunOptions without_draws = options;
  without_draws.posterior = 0;
  double least = infinite;
  for (const Candidate& candidate : proposal.candidates) {
    const bool is_spare = !candidate.if_others_miss.empty();
    if (is_spare && least <= misfit_of_others) break;
    if (is_spare) proposal.reasons.push_back(candidate.if_others_miss);
    reports.push_back(run_fit(candidate.fit, without_draws));
    result.tried.push_back(tried(candidate, reports.back()));
    least = std::min(least, result.tried.back().misfit.value_or(infinite));
  }
  proposal.candidates.resize(reports.size());
  // A base curve with and without slope first, then the best of each.
  std::vector<std::size_t> of_bases;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (of_bases.empty() || !is_variant(result.tried[of_bases.back()], result.tried[i]))
      of_bases.push_back(i);
    else if (is_better(result.tried[of_bases.back()], result.tried[i], reports[i]))
      of_bases.back() = i;
  }
  result.chosen = of_bases.front();
  for (const std::size_t i : of_bases)
    if (i != result.chosen && is_better(result.tried[result.chosen], result.tried[i], reports[i]))
      result.chosen = i;
  result.report = options.posterior > 0 ? run_fit(proposal.candidates[result.chosen].fit, options)
                                        : std::move(reports[result.chosen]);
  result.proposal = std::move(proposal);
  say_what_is_open(result);
  for (std::vector<std::string>& to = result.report.material.reservations;
       const std::string& doubt : doubts_of(result))
    to.push_back(doubt);
  return result;
}

}  // namespace dashpad::fit
