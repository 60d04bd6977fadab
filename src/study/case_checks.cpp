#include "study/distribution.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/design.hpp"

namespace dashpad::study {
namespace {

constexpr std::uint64_t most_combinations = 100'000;
constexpr std::size_t most_violations = 20;

/// The factor that a broken rule of the case is about: itself, or one that it follows from.
const Factor* factor_behind(const Study& study, const std::string& key) {
  const auto find = [&](auto&& fits) -> const Factor* {
    const auto found = std::ranges::find_if(study.factors, [&](const Factor& of) { return fits(of.key); });
    return found == study.factors.end() ? nullptr : &*found;
  };
  if (const Factor* same = find([&](const std::string& of) { return of == key; })) return same;
  for (const OtherWay& way : other_ways())
    if (key == way.instead_of) return find([&](const std::string& of) { return of == way.key; });
  if (key.starts_with("support."))
    return find([](const std::string& of) { return of.starts_with("support."); });
  if (!key.starts_with("pad.")) return nullptr;
  // A rule between several numbers is told of one of them: rather of another one in the same table.
  const std::string table = key.substr(0, key.rfind('.') + 1);
  const Factor* of_table =
      find([&](const std::string& of) { return is_of_law(of) && of.starts_with(table); });
  if (of_table) return of_table;
  return find([](const std::string& of) { return of == "pad.material" || is_of_law(of); });
}

class Checker {
 public:
  explicit Checker(const Study& study) : study_(study), application_(study), impact_(study.base) {
    for (const Factor& factor : study.factors)
      values_.push_back(factor.is_sampled() ? Quantiles(factor).at(0.5) : levels_of(factor).front());
  }

  std::vector<Violation> all() {
    check_grid();
    for (std::size_t i = 0; i < study_.factors.size(); ++i)
      if (study_.factors[i].is_sampled()) check_ends(i);
    return std::move(found_);
  }

 private:
  static const std::vector<double>& levels_of(const Factor& factor) {
    return std::get<Levels>(factor.spread).values;
  }

  void check_grid() {
    const std::vector<double> first = values_;
    std::uint64_t combinations = 1;
    for (const Factor& factor : study_.factors)
      if (!factor.is_sampled() && combinations <= most_combinations) combinations *= levels_of(factor).size();
    if (combinations <= most_combinations) {
      check_combinations(0);
    } else {
      for (std::size_t i = 0; i < study_.factors.size(); ++i) {
        if (study_.factors[i].is_sampled()) continue;
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
    if (study_.factors[factor].is_sampled()) return check_combinations(factor + 1);
    for (const double level : levels_of(study_.factors[factor])) {
      values_[factor] = level;
      check_combinations(factor + 1);
    }
  }

  void check_ends(std::size_t i) {
    const double centre = values_[i];
    const CheckedRange range = checked_range(study_.factors[i]);
    values_[i] = range.low;
    check_here(range.low_is_tail ? "6 deviations below the middle; cut it off with lowest" : "the lower end");
    values_[i] = range.high;
    check_here(range.high_is_tail ? "6 deviations above the middle; cut it off with highest"
                                  : "the upper end");
    values_[i] = centre;
  }

  std::vector<Violation> broken_here() {
    try {
      application_(values_, impact_);
      return violations(impact_);
    } catch (const std::invalid_argument& error) {
      impact_ = study_.base;
      return {{"support.stiffness", 0, error.what()}};
    }
  }

  void check_here(const std::string& where) {
    for (const Violation& broken : broken_here()) {
      if (found_.size() >= most_violations) return;
      const Factor* factor = factor_behind(study_, broken.key);
      Violation violation{factor ? "factors." + factor->key : broken.key, broken.value,
                          fmt::format("{} = {:.6g}{}: {}", broken.key, broken.value,
                                      where.empty() ? "" : " (" + where + ")", broken.rule)};
      const auto same = [&](const Violation& of) {
        return of.key == violation.key && of.rule == violation.rule;
      };
      if (std::ranges::none_of(found_, same)) found_.push_back(std::move(violation));
    }
  }

  const Study& study_;
  Application application_;
  ImpactCase impact_;
  std::vector<double> values_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> case_violations(const Study& study) { return Checker(study).all(); }

}  // namespace dashpad::study
