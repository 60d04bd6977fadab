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

std::vector<std::size_t> seen_effects(const sensitivity::Answer& answer, std::size_t figure,
                                      std::size_t max) {
  constexpr double same = 1e-6;
  std::vector<std::size_t> seen;
  const auto effect = [&](std::size_t k) { return answer.inputs[k].elasticities[figure].value; };
  for (const std::size_t k : by_effect(answer, figure)) {
    if (seen.size() == max || !(std::abs(effect(k)) > unseen)) break;
    const bool is_other_name =
        decided_by(answer.inputs[k].key) != answer.inputs[k].key ||
        std::ranges::any_of(seen, [&](std::size_t one) { return std::abs(effect(one) - effect(k)) < same; });
    if (!is_other_name) seen.push_back(k);
  }
  return seen;
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
  const std::string title = answer.figures[figure]->title;
  std::string text;
  std::size_t place = 0;
  for (const std::size_t k : seen_effects(answer, figure, 3)) {
    const std::string name = factor_words(answer.inputs[k].key);
    const double effect = answer.inputs[k].elasticities[figure].value;
    text += place == 0   ? fmt::format("{} depends most on the {} (1 % more: {:+.3g} %)", title, name, effect)
            : place == 1 ? fmt::format(", then on the {} ({:+.3g} %)", name, effect)
                         : fmt::format(" and the {} ({:+.3g} %)", name, effect);
    ++place;
  }
  return text.empty() ? title + " depends on no number of the case" : text;
}

}  // namespace dashpad::output
