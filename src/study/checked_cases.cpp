#include "study/checked_cases.hpp"

#include <algorithm>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "study/sampling.hpp"

namespace dashpad::study {
namespace {

constexpr std::uint64_t max_combinations = 100'000;
constexpr std::size_t max_violations = 20;

/// The factor that a broken rule of the case is about: itself, or one that it follows from.
const Factor* factor_behind(const Study& study, const std::string& key) {
  const auto find = [&](auto&& fits) -> const Factor* {
    const auto found =
        std::ranges::find_if(study.factors, [&](const Factor& factor) { return fits(factor.key); });
    return found == study.factors.end() ? nullptr : &*found;
  };
  if (const Factor* same = find([&](const std::string& text) { return text == key; })) return same;
  for (const OtherWay& way : other_ways())
    if (key == way.instead_of) return find([&](const std::string& text) { return text == way.key; });
  if (key == "impactor.mass") return find([](const std::string& text) { return text == static_stress; });
  if (key.starts_with("support."))
    return find([](const std::string& text) { return text.starts_with("support."); });
  if (!key.starts_with("pad.")) return nullptr;
  // A rule between several numbers is told of one of them: rather of another one in the same table.
  const std::string table = key.substr(0, key.rfind('.') + 1);
  const Factor* of_table =
      find([&](const std::string& text) { return is_of_law(text) && text.starts_with(table); });
  if (of_table) return of_table;
  return find([](const std::string& text) { return text == "pad.material" || is_of_law(text); });
}

/// Whether two laws are the same foam; of laws without curves, whose rules take no time, it is not known.
bool is_same(const PadLaw& a, const PadLaw& b) {
  return a.index() == b.index() && std::visit(
                                       [&]<class Law>(const Law& law) {
                                         if constexpr (std::equality_comparable<Law>)
                                           return law == std::get<Law>(b);
                                         else
                                           return false;
                                       },
                                       a);
}

class Checker {
 public:
  explicit Checker(const Study& study) : study_(study), application_(study), impact_(study.base) {
    for (const Factor& factor : study.factors)
      values_.push_back(factor.is_sampled() ? Quantiles(factor).at(0.5) : factor.given_values()->front());
  }

  std::vector<Violation> all() {
    check_rows<ByDraw>("samples_from");
    check_rows<ByRow>("rows");
    check_grid();
    for (std::size_t i = 0; i < study_.factors.size(); ++i)
      if (study_.factors[i].is_sampled() && !std::holds_alternative<ByDraw>(study_.factors[i].spread))
        check_ends(i);
    return std::move(found_);
  }

 private:
  static bool has_levels(const Factor& factor) { return std::holds_alternative<Levels>(factor.spread); }
  static const std::vector<double>& levels_of(const Factor& factor) {
    return std::get<Levels>(factor.spread).values;
  }

  /// Checks each row of a table, with the other factors where they are, and leaves the first row. Broken
  /// rules have keys such as "rows[3].impactor.speed".
  template <class Column>
  void check_rows(const char* key) {
    const auto column = [&](std::size_t i) { return std::get_if<Column>(&study_.factors[i].spread); };
    std::size_t rows = 0;
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (column(i)) rows = column(i)->values.size();
    const auto go_to = [&](std::size_t row) {
      for (std::size_t i = 0; i < values_.size(); ++i)
        if (column(i)) values_[i] = column(i)->values[row];
    };
    for (std::size_t row = 0; row < rows; ++row) {
      go_to(row);
      for (Violation& broken : broken_here()) {
        broken.key = fmt::format("{}[{}].{}", key, row + 1, broken.key);
        add(std::move(broken));
      }
    }
    if (rows > 0) go_to(0);
  }

  void check_grid() {
    const std::vector<double> first = values_;
    std::uint64_t combinations = 1;
    for (const Factor& factor : study_.factors)
      if (has_levels(factor) && combinations <= max_combinations) combinations *= levels_of(factor).size();
    if (combinations <= max_combinations) {
      check_combinations(0);
    } else {
      for (std::size_t i = 0; i < study_.factors.size(); ++i) {
        if (!has_levels(study_.factors[i])) continue;
        for (const double level : levels_of(study_.factors[i])) {
          values_[i] = level;
          check_here("");
        }
        values_[i] = first[i];
      }
    }
    values_ = first;
  }

  void check_combinations(std::size_t factor) {
    if (factor == study_.factors.size()) return check_here("");
    if (!has_levels(study_.factors[factor])) return check_combinations(factor + 1);
    for (const double level : levels_of(study_.factors[factor])) {
      values_[factor] = level;
      check_combinations(factor + 1);
    }
  }

  void check_ends(std::size_t i) {
    const double centre = values_[i];
    const CheckedRange range = checked_range(study_.factors[i]);
    values_[i] = range.low;
    check_here(range.low_is_tail ? "6 standard deviations below the centre; use lowest to cut it off"
                                 : "at the lower end");
    values_[i] = range.high;
    check_here(range.high_is_tail ? "6 standard deviations above the centre; use highest to cut it off"
                                  : "at the upper end");
    values_[i] = centre;
  }

  std::vector<Violation> broken_here() {
    try {
      application_(values_, impact_);
      // Most rows have one law, whose rules take longer to check than all others.
      if (sound_law_ && is_same(*sound_law_, impact_.pad.material.law)) return violations_beside_law(impact_);
      std::vector<Violation> broken = violations(impact_);
      if (broken.empty()) sound_law_ = impact_.pad.material.law;
      return broken;
    } catch (const std::invalid_argument& error) {
      impact_ = study_.base;
      return {{"support.stiffness", 0, error.what()}};
    }
  }

  void check_here(const std::string& where) {
    for (const Violation& broken : broken_here()) {
      const Factor* factor = factor_behind(study_, broken.key);
      Violation violation{factor ? "factors." + factor->key : broken.key, broken.value,
                          fmt::format("{} = {:.6g}{}: {}", broken.key, broken.value,
                                      where.empty() ? "" : " (" + where + ")", broken.rule)};
      add(std::move(violation));
    }
  }

  void add(Violation violation) {
    const auto same = [&](const Violation& given) {
      return given.key == violation.key && given.rule == violation.rule;
    };
    if (found_.size() < max_violations && std::ranges::none_of(found_, same))
      found_.push_back(std::move(violation));
  }

  const Study& study_;
  Application application_;
  ImpactCase impact_;
  std::optional<PadLaw> sound_law_;
  std::vector<double> values_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> violations_of_cases(const Study& study) { return Checker(study).all(); }

}  // namespace dashpad::study
