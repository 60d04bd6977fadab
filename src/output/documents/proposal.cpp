// The document of a proposed fit.

#include "dashpad/output/proposal.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dashpad/output/fit.hpp"
#include "output/layout.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

std::string percent(double share) {
  constexpr double least = 1e-4;
  return share > 0 && share < least ? "less than 0.01 %" : brief(100 * share, 2) + " %";
}

std::string rate_words(const std::string& rate) {
  if (rate == "none") return "";
  if (rate == "by relaxation") return " and relaxation";
  return rate == "power with slope" ? ", a power of the rate with a slope over the strain"
                                    : ", a power of the rate";
}

std::string base_words(const std::string& base) {
  if (base == "table") return "the measured curve as its base";
  return base == ViscoelasticFoam::name ? "a hyperfoam curve that relaxes"
                                        : fmt::format("the formula {} as its base", base);
}

/// "Proposed: law foam with the measured curve as its base, a power of the rate; it misses the tests by 0.4
/// %".
std::string answer(const fit::AutoFit& result) {
  const fit::Candidate& candidate = result.candidate();
  return fmt::format("Proposed: law {} with {}{}; it misses the tests by {}", candidate.law,
                     base_words(candidate.base), rate_words(candidate.rate),
                     percent(result.tried[result.chosen].misfit.value_or(0)));
}

Table table_of_tests(const fit::Proposal& proposal) {
  Table table{.caption = "What was measured",
              .columns = {"test", "rate", "points of loading", "highest strain", "largest stress",
                          "energy returned"}};
  for (const fit::Evidence& shown : proposal.tests)
    table.rows.push_back({one_line(shown.file), brief(shown.rate, 3) + " 1/s",
                          fmt::format("{}", shown.loading_points), brief(shown.highest_strain, 3),
                          brief(shown.largest_stress / 1000, 3) + " kPa",
                          shown.returned ? percent(*shown.returned) : "not measured"});
  return table;
}

Table table_of_tried(const fit::AutoFit& result) {
  Table table{.caption = "What was tried",
              .columns = {"law", "base curve", "rate", "unknowns", "not determined", "root mean square", ""}};
  for (std::size_t i = 0; i < result.tried.size(); ++i) {
    const fit::Tried& how = result.tried[i];
    table.rows.push_back({how.law, how.base, how.rate, fmt::format("{}", how.unknowns),
                          fmt::format("{}", how.open), how.misfit ? percent(*how.misfit) : "did not converge",
                          i == result.chosen ? "chosen" : ""});
  }
  return table;
}

std::vector<std::string> numbered(const std::vector<std::string>& sentences) {
  std::vector<std::string> all;
  for (const std::string& sentence : sentences)
    all.push_back(fmt::format("{}. {}", all.size() + 1, one_line(sentence)));
  return all;
}

}  // namespace

Document proposal_document(const fit::AutoFit& result, const UnitSystem& units, Pictures pictures) {
  Document document = fit_document(result.report, units, pictures);
  if (!result.report.converged) return document;
  document.title = document.lead->answer = answer(result);
  document.summary.insert(
      document.summary.begin(),
      "The misfit is the root mean square of model minus measurement over the largest stress of "
      "each test, on average over the tests.");
  std::vector<std::string> reasons;
  for (const std::string& reason : result.proposal.reasons) reasons.push_back(one_line(reason));
  const std::vector<Section> sections{{.heading = "Why",
                                       .seen = Seen::always,
                                       .paragraphs = std::move(reasons),
                                       .tables = {table_of_tests(result.proposal), table_of_tried(result)}},
                                      {.heading = "What these tests do not determine",
                                       .seen = Seen::always,
                                       .paragraphs = numbered(result.open)},
                                      {.heading = "What to measure next, the most valuable first",
                                       .seen = Seen::always,
                                       .paragraphs = numbered(result.next)}};
  document.sections.insert(document.sections.begin(), sections.begin(), sections.end());
  return document;
}

}  // namespace dashpad::output
