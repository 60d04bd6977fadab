#include "output/documents/study_key_figures.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "output/document.hpp"
#include "output/documents/study_value_figures.hpp"
#include "output/text/capitals.hpp"
#include "output/text/factor_words.hpp"
#include "output/text/study_answer.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using study::StudyAnswers;
using Figures = std::vector<ValueRow>;

/// Of a variance: its estimate has no more digits.
std::string share_of_variance(double share) {
  return fmt::format("{:.{}f} %", 100 * share, share < 0.1 ? 1 : 0);
}

std::string part_of_rows(std::uint64_t count, std::uint64_t rows) {
  return fmt::format("{} of {} rows", count, rows);
}

/// A probability for each limit, or where levels vary the strictest limit at each of them.
void add_probabilities(Figures& figures, const StudyAnswers& answers, const UnitSystem& units) {
  constexpr std::size_t most_limits = 2, most_groups = 4;
  const bool has_levels = answers.groups.size() > 1;
  const std::size_t strictest = strictest_limit(answers);
  // The first and the last of the levels are among them.
  const std::size_t groups = std::min(answers.groups.size(), most_groups);
  for (std::size_t k = 0; k < groups; ++k) {
    const std::size_t place = groups < 2 ? 0 : k * (answers.groups.size() - 1) / (groups - 1);
    const StudyAnswers::OfGroup& group = answers.groups[place];
    for (std::size_t i = 0, shown = 0; i < answers.limits.size() && shown < most_limits; ++i) {
      const study::StudyLimit& limit = answers.limits[i];
      if (has_levels && i != strictest) continue;
      ++shown;
      const study::Exceedance& of = group.exceedances[i];
      const std::string above = fmt::format("{} above {}", title_of(limit.response),
                                            in_unit_of(limit.response, units)(limit.value));
      ValueRow figure{.label = has_levels ? words_of_levels(answers, group.group, units) : above};
      figure.value = group.group.drawn ? per_cent(of.probability.value) : part_of_rows(of.exceeding, of.rows);
      figure.remark = has_levels ? above : "";
      const std::string interval = group.group.drawn  ? interval_of(of.probability, per_cent)
                                   : of.undecided > 0 ? fmt::format("{} undecided", of.undecided)
                                                      : "";
      if (!interval.empty()) figure.remark += (figure.remark.empty() ? "" : "; ") + interval;
      figures.push_back(std::move(figure));
    }
  }
}

void add_indices(Figures& figures, const StudyAnswers& answers) {
  constexpr std::size_t most_factors = 4;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const auto& of = answers.groups.front().sensitivities[i];
    if (!of || of->indices.empty()) continue;
    std::vector<study::Sensitivity::Index> indices = of->indices;
    std::ranges::stable_sort(indices, std::ranges::greater(),
                             [](const study::Sensitivity::Index& index) { return index.total.value; });
    for (const study::Sensitivity::Index& index : indices)
      if (figures.size() < most_factors)
        figures.push_back(
            {.label =
                 fmt::format("{} by {}", title_of(response_name(answers, i)), factor_words(index.factor)),
             .value = share_of_variance(std::max(index.total.value, 0.0)),
             .remark = fmt::format("of its variance, {}", interval_of(index.total, share_of_variance))});
    return;
  }
}

/// What counts against the answer: struck through, or used beyond what the foam was tested for.
void add_counts(Figures& figures, const StudyAnswers& answers) {
  const std::uint64_t rows = answers.records.rows.size();
  const auto add = [&](const char* label, std::uint64_t count, Tone tone) {
    if (count > 0 && rows > 0)
      figures.push_back({.label = label,
                         .value = per_cent(static_cast<double>(count) / static_cast<double>(rows)),
                         .remark = part_of_rows(count, rows),
                         .tone = tone});
  };
  add("Bottomed out", answers.records.struck_through, Tone::bad);
  add("Beyond the tested strain", answers.records.beyond_strain, Tone::doubtful);
  add("Beyond the tested rates", answers.records.beyond_rate, Tone::plain);
}

}  // namespace

std::vector<ValueRow> study_key_figures(const StudyAnswers& answers, const UnitSystem& units) {
  Figures figures;
  if (answers.groups.empty() || answers.responses.empty() || answers.records.rows.empty()) return figures;
  const bool drawn = answers.groups.front().group.drawn;
  if (!answers.limits.empty())
    add_probabilities(figures, answers, units);
  else
    add_indices(figures, answers);
  if (answers.cushion_curves && !answers.cushion_curves->drops.empty())
    add_least_peaks(figures, *answers.cushion_curves, units);
  else if (answers.groups.size() == 1 && drawn) {
    add_quantiles(figures, answers, leading_response(answers), units);
    add_spreads(figures, answers, leading_response(answers), units);
  } else if (answers.groups.size() == 1)
    add_ranges(figures, answers, units);
  else if (drawn && answers.limits.empty())
    add_medians(figures, answers, units);
  // They have a place of their own: what else there is makes room for them.
  Figures counts;
  add_counts(counts, answers);
  figures.resize(std::min(figures.size(), most_key_figures - counts.size()));
  figures.insert(figures.end(), counts.begin(), counts.end());
  return figures;
}

}  // namespace dashpad::output
