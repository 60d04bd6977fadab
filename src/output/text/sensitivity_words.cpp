#include "output/text/sensitivity_words.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

constexpr double unseen = 5e-4;  // of a third decimal

}  // namespace

std::vector<std::size_t> by_effect(const sensitivity::Answer& answer, std::size_t figure) {
  std::vector<std::size_t> order(answer.inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto effect = [&](std::size_t k) {
    const double value = answer.inputs[k].elasticities[figure].value;
    return std::isfinite(value) ? -std::abs(value) : 1.0;
  };
  std::ranges::stable_sort(order, {}, effect);
  return order;
}

std::string effect_words(const sensitivity::Elasticity& elasticity) {
  using sensitivity::Course;
  if (elasticity.course == Course::jump) return "jump";
  if (elasticity.course == Course::unknown || !std::isfinite(elasticity.value)) return "-";
  const std::string prefix = elasticity.course == Course::kink ? "kink, " : "";
  if (elasticity.error < unseen)
    return prefix + (std::abs(elasticity.value) < unseen ? "0" : fmt::format("{:+.3f} %", elasticity.value));
  return prefix + fmt::format("{:+.3f} ± {:.2g} %", elasticity.value, elasticity.error);
}

std::string interval_of_foam(const FigureInterval& interval) {
  const auto share = [&](double end) { return 100 * (end / interval.nominal - 1); };
  if (!std::isfinite(interval.high)) return fmt::format("{:+.2g} % to without bound", share(interval.low));
  return fmt::format("{:+.2g} % to {:+.2g} %", share(interval.low), share(interval.high));
}

std::string sensitivity_answer(const sensitivity::Answer& answer, std::size_t figure) {
  // A speed and the drop height that gives it are one thing.
  std::vector<std::size_t> order = by_effect(answer, figure);
  std::erase_if(order,
                [&](std::size_t k) { return decided_by(answer.inputs[k].key) != answer.inputs[k].key; });
  const std::string title = answer.figures[figure]->title;
  std::string text;
  for (std::size_t place = 0; place < std::min<std::size_t>(order.size(), 3); ++place) {
    const sensitivity::Input& input = answer.inputs[order[place]];
    const sensitivity::Elasticity& effect = input.elasticities[figure];
    if (!(std::abs(effect.value) > unseen)) break;
    text += place == 0 ? fmt::format("{} depends most on the {}: 1 % more changes it by {}", title,
                                     factor_words(input.key), effect_words(effect))
                       : fmt::format("{}{} by {}", place == 1 ? "; then on the " : ", the ",
                                     factor_words(input.key), effect_words(effect));
  }
  return text.empty() ? title + " depends on no number of the case" : text;
}

}  // namespace dashpad::output
