#include "output/text/study_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/text/capitals.hpp"

namespace dashpad::output {

namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::array<Words, 11> known{{{"pad.material", "material"},
                                       {static_stress, "static stress"},
                                       {"support.stiffness", "stiffness of the support"},
                                       {"support.scale", "scale of the support's force"},
                                       {"foam.continuation", "stress beyond the tested strain"},
                                       {"foam.rate", "stress beyond the tested rates"},
                                       {"foam.way_back", "unloading of the foam"},
                                       {"foam.lag_strain", "lag strain of the foam"},
                                       {"foam.scatter", "sample-to-sample scatter"},
                                       {"foam.misfit", "misfit of the law"},
                                       {"foam.neighbours", "error of the columns"}}};

/// The meaning of a number in the table of its owner; "" for another key.
template <class Owner>
std::string_view meaning_in(std::string_view prefix, std::string_view key) {
  if (!key.starts_with(prefix)) return "";
  for (const Parameter<Owner>& parameter : Owner::parameters)
    if (key.substr(prefix.size()) == parameter.key) return parameter.meaning;
  return "";
}

std::string_view meaning_of(std::string_view key) {
  for (const OtherWay& way : other_ways())
    if (key == way.key) return way.meaning;
  for (const std::string_view meaning :
       {meaning_in<Impactor>("impactor.", key), meaning_in<Pad>("pad.", key),
        meaning_in<PadCondition>("pad.", key), meaning_in<Blows>("blows.", key)})
    if (!meaning.empty()) return meaning;
  return "";
}

/// The owners of the numbers in the tables of a case.
constexpr std::array<Words, 6> owners{{{"pad.parameters.", " of the foam"},
                                       {"foam.", " of the foam"},
                                       {"pad.curve.", " of the foam"},
                                       {"pad.rate.", " of the foam's rate effect"},
                                       {"impactor.", " of the nose"},
                                       {"support.", " of the support"}}};

std::string with_blanks(std::string_view key) {
  std::string words{key};
  std::ranges::replace(words, '_', ' ');
  return words;
}

/// "density of the foam in layer 2" of pad.layers[2].density.
std::string words_of_layer(std::string_view key) {
  constexpr std::string_view begin = "pad.layers[";
  const std::size_t end = key.find("].");
  if (!key.starts_with(begin) || end == std::string_view::npos) return {};
  const std::string number{key.substr(begin.size(), end - begin.size())}, of{key.substr(end + 2)};
  return of == "thickness" ? "thickness of layer " + number
                           : factor_words("pad." + of) + " in layer " + number;
}

}  // namespace

std::string factor_words(const std::string& key) {
  for (const auto& [name, words] : known)
    if (key == name) return std::string{words};
  if (const std::string_view meaning = meaning_of(key); !meaning.empty()) return std::string{meaning};
  if (std::string words = words_of_layer(key); !words.empty()) return words;
  for (const auto& [begin, owner] : owners)
    if (key.starts_with(begin) && key.find('.', begin.size()) == std::string::npos)
      return with_blanks(std::string_view{key}.substr(begin.size())) + std::string{owner};
  return key;
}

std::string factor_title(const std::string& key) {
  const std::string words = factor_words(key);
  return words == key ? words : capitalised(words);
}

std::string four_digits(double value) {
  if (!std::isfinite(value)) return "-";
  if (std::abs(value) >= 1000 && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

std::string four_digits_or_struck(double value) {
  return value == HUGE_VAL ? "bottomed out" : four_digits(value);
}

std::string with_interval(const study::Estimate& estimate, double scale) {
  const auto shown = [&](double value) { return four_digits_or_struck(scale * value); };
  if (std::isnan(estimate.low) || std::isnan(estimate.value)) return shown(estimate.value);
  const bool has_low = std::isfinite(estimate.low), has_high = std::isfinite(estimate.high);
  if (estimate.low == HUGE_VAL) return shown(estimate.value);
  if (!has_low && !has_high) return shown(estimate.value) + " (too few rows)";
  if (!has_low) return fmt::format("{} (below {})", shown(estimate.value), shown(estimate.high));
  if (!has_high) return fmt::format("{} (above {})", shown(estimate.value), shown(estimate.low));
  return fmt::format("{} ({} to {})", shown(estimate.value), shown(estimate.low), shown(estimate.high));
}

std::string share_with_interval(const study::Estimate& share) {
  // Adding zero removes the sign of a value that rounds to zero.
  const auto rounded = [](double value) { return std::round(1000 * value) / 1000 + 0.0; };
  return fmt::format("{:.3f} ({:.3f} to {:.3f})", rounded(share.value), rounded(share.low),
                     rounded(share.high));
}

std::string per_cent(double share) {
  const int digits = share < 1 && share > 0.9995 ? 5 : 3;
  return std::isfinite(share) ? brief(100 * share, digits) + " %" : "undecided";
}

std::string percent_with_interval(const study::Estimate& estimate) { return with_interval(estimate, 100); }

const std::string& response_name(const study::StudyAnswers& answers, std::size_t i) {
  return answers.study.responses[answers.responses[i]];
}

std::string title_of(const std::string& name) {
  const ResultQuantity* quantity = find_result_quantity(name);
  return quantity == nullptr ? study::response_title(name) : quantity->title;
}

std::string si_unit_of(const std::string& response) {
  const ResultQuantity* quantity = study::find_response_kind(response);
  return quantity == nullptr ? "1" : quantity->si_unit;
}

std::string three_digits(const std::string& response, double value, const UnitSystem& units) {
  if (!std::isfinite(value)) return value == HUGE_VAL ? "bottomed out" : "unknown";
  const ScaledUnit shown = shown_as(si_unit_of(response), units);
  return with_unit(brief(rounded_to(shown.scale * value, 3)), shown.unit);
}

std::string three_digit_range(const std::string& response, double low, double high, const UnitSystem& units) {
  std::string from = three_digits(response, low, units);
  const std::string to = three_digits(response, high, units);
  if (from == to) return to;
  if (std::isfinite(low) && std::isfinite(high)) from.resize(std::min(from.find(' '), from.size()));
  return from + " to " + to;
}

std::string label(const std::string& response, const UnitSystem& units) {
  const std::string unit = shown_as(si_unit_of(response), units).unit;
  return title_of(response) + (unit.empty() ? "" : fmt::format(" ({})", unit));
}

std::vector<std::size_t> level_factors(const study::Study& study) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < study.factors.size(); ++i)
    if (!study.factors[i].is_sampled()) numbers.push_back(i);
  return numbers;
}

std::string level_text(const study::Study& study, std::size_t factor, double value, const UnitSystem& units) {
  const study::Factor& of = study.factors[factor];
  const auto number = static_cast<std::size_t>(std::max(value, 0.0));
  if (of.unit.empty() && number < study.materials.size()) return one_line(study.materials[number].name);
  const ScaledUnit shown = shown_as(of.unit, units);
  return with_unit(four_digits(shown.scale * value), shown.unit);
}

std::string factor_at(const study::Study& study, std::size_t factor, double value, const UnitSystem& units) {
  return fmt::format("{} {}", factor_words(study.factors[factor].key),
                     level_text(study, factor, value, units));
}

std::string turning_text(const study::StudyAnswers& answers, const study::TurningLevel& turn,
                         const UnitSystem& units) {
  const auto words = [&](double level) {
    return std::isfinite(level) ? level_text(answers.study, turn.factor, level, units)
                                : std::string("beyond the levels");
  };
  if (std::isinf(turn.level.value)) return "none of the study";
  const bool is_at_end = turn.level.value == (turn.kept_above ? turn.first : turn.last);
  if (is_at_end)
    return fmt::format("{} {}, {}", turn.kept_above ? "from" : "up to", words(turn.level.value),
                       turn.kept_above ? "the least level, or less" : "the greatest level, or more");
  return fmt::format("{} {} (95 % interval {} to {})", turn.kept_above ? "from" : "up to",
                     words(turn.level.value), words(turn.level.low), words(turn.level.high));
}

std::string levels_beside(const study::StudyAnswers& answers, const study::TurningLevel& turn,
                          const UnitSystem& units) {
  const std::vector<std::size_t> factors = level_factors(answers.study);
  const study::Group& example = answers.groups[turn.example].group;
  std::string text;
  for (std::size_t i = 0; i < example.levels.size(); ++i)
    if (factors[i] != turn.factor)
      text += (text.empty() ? "" : ", ") + factor_at(answers.study, factors[i], example.levels[i], units);
  return text;
}

std::string words_of_levels(const study::StudyAnswers& answers, const study::Group& group,
                            const UnitSystem& units) {
  const std::vector<std::size_t> factors = level_factors(answers.study);
  std::string text;
  if (!answers.study.labels.empty() && !group.places.empty()) {
    const study::RowLabel& label = answers.study.labels.front();
    const std::uint64_t row = answers.records.rows[group.places.front()];
    text = one_line(label.texts[study::table_row_of(answers.study, row)]) + ": ";
  }
  for (std::size_t i = 0; i < group.levels.size(); ++i)
    text += (i == 0 ? "" : ", ") + factor_at(answers.study, factors[i], group.levels[i], units);
  return text;
}

std::string shown_factor(const std::string& unit, double value, const Material& material,
                         const UnitSystem& units) {
  return unit.empty() ? one_line(material.name) : brief_quantity(value, unit, units);
}

}  // namespace dashpad::output
