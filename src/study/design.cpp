#include "dashpad/study/study.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "input/spelling.hpp"
#include "study/foam_factors.hpp"
#include "study/sampling.hpp"

namespace dashpad::study {

namespace {

/// Whether the key is in a table of the case, or is the table itself, which TOML opens only for known keys.
bool is_in(const std::string& key, std::string_view table) { return (key + ".").starts_with(table); }

template <class Variant>
const char* form_of(const Variant& variant) {
  return std::visit([](const auto& form) { return form.name; }, variant);
}

/// What the pad has instead of an unknown number of its curve or rate effect.
std::string rule_for_curves(const std::string& table, const PadLaw& law,
                            const std::vector<std::string>& known) {
  const auto available = [&](std::string_view prefix) {
    std::vector<std::string> names;
    std::ranges::copy_if(known, std::back_inserter(names),
                         [&](const std::string& name) { return name.starts_with(prefix); });
    return names.empty() ? ", which has no numbers that can vary" : "; available: " + input::listing(names);
  };
  const FoamCurves* const curves = foam_curves(law);
  if (curves == nullptr)
    return fmt::format("the law of the pad, {}, is not defined by curves", name_of(law)) +
           available("pad.parameters.");
  return (table == "pad.curve."
              ? fmt::format("the curve of the pad has the form {}", form_of(curves->base))
              : fmt::format("the rate effect of the pad has the form {}", form_of(curves->rate_effect))) +
         available(table);
}

std::uint64_t blocks_of(const Study& study) { return study.indices ? 2 + sampled_factors(study).size() : 1; }

}  // namespace

std::vector<FactorKey> factor_keys(const ImpactCase& base) {
  std::vector<FactorKey> keys;
  for (const CaseQuantity& case_quantity : quantities_of(base))
    keys.push_back({case_quantity.key, case_quantity.unit});
  if (base.pad.layers.empty()) keys.push_back({"pad.material", ""});
  return keys;
}

std::vector<FactorKey> factor_keys(const Study& study) {
  std::vector<FactorKey> keys = factor_keys(study.base);
  for (const FoamFactor& factor : foam_factors(study)) keys.push_back({factor.key, "1"});
  return keys;
}

std::string rule_for_unknown(const std::string& key, const ImpactCase& base,
                             const std::vector<FactorKey>& known_keys) {
  if (key == "support.stiffness" || key == "support.scale")
    return base.support.is_rigid()
               ? "the support of the case is rigid"
               : "the support of the case is a curve: vary support.scale, which multiplies its forces";
  std::vector<std::string> known;
  for (const FactorKey& each : known_keys) known.push_back(each.key);
  if (uncertainty::is_foam_factor(key)) {
    std::erase_if(known, [](const std::string& each) { return !uncertainty::is_foam_factor(each); });
    return known.empty() ? "the cards leave nothing uncertain that could be drawn"
                         : "is not among what the cards leave uncertain: " + input::listing(known);
  }
  for (const char* table : {"pad.curve.", "pad.rate."})
    if (is_in(key, table) && base.pad.layers.empty())
      return rule_for_curves(table, base.pad.material.law, known);
  return "is not a quantity of the case that can be varied" + input::meant_or_listed(key, known);
}

bool is_of_law(const std::string& key) {
  // The key of a layer, "pad.layers[2].parameters.friction", counts like that of a pad.
  const std::size_t bracket = key.starts_with("pad.layers[") ? key.find("].") : std::string::npos;
  const std::string of_pad = bracket == std::string::npos ? key : "pad." + key.substr(bracket + 2);
  return is_in(of_pad, "pad.parameters.") || is_in(of_pad, "pad.curve.") || is_in(of_pad, "pad.rate.");
}

Application::Application(const Study& study) {
  const CaseQuantities quantities = quantities_of(study.base);
  // The nominal value differs between materials.
  const bool is_nominal = study.base.pad.neighbours == nominal_neighbours(study.base.pad) &&
                          std::ranges::count(study.factors, "pad.neighbours", &Factor::key) == 0;
  for (const Factor& factor : study.factors) {
    if (uncertainty::is_foam_factor(factor.key)) {
      steps_.emplace_back([](ImpactCase&, double) {});  // known only once the impact is solved
      continue;
    }
    if (factor.key == "pad.material") {
      steps_.emplace_back([&study, is_nominal](ImpactCase& into, double value) {
        const Material& chosen = study.materials.at(static_cast<std::size_t>(value));
        if (into.pad.material.name == chosen.name) return;
        into.pad.material = chosen;
        if (is_nominal) into.pad.neighbours = nominal_neighbours(into.pad);
      });
      continue;
    }
    const CaseQuantity* const found = quantities.find(factor.key);
    if (found == nullptr) throw std::invalid_argument("not a quantity of the case: " + factor.key);
    if (factor.key == static_stress) last_ = steps_.size();
    steps_.push_back(found->set);
  }
}

void Application::operator()(std::span<const double> values, ImpactCase& into) const {
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (i != last_) steps_[i](into, values[i]);
  // The mass follows from the area that all others leave.
  if (last_ < steps_.size()) steps_[last_](into, values[last_]);
}

struct Design::Plan {
  /// The second matrix of Saltelli's design has dimensions of its own.
  explicit Plan(const Study& study)
      : samples(study.samples),
        blocks(blocks_of(study)),
        sampled(sampled_factors(study)),
        source(study, (study.indices ? 2 : 1) * sampled.size()) {
    if (!study.correlations.empty()) root = *root_of_correlations(study);
    for (const std::size_t i : sampled) quantiles.emplace_back(study.factors[i]);
    for (const Factor& factor : study.factors) {
      const auto* of = std::get_if<Levels>(&factor.spread);
      levels.push_back(of ? of->values : std::vector<double>());
      if (of) combinations *= of->values.size();
      const auto* in_row = std::get_if<ByRow>(&factor.spread);
      by_row.push_back(in_row ? in_row->values : std::vector<double>());
    }
    combinations *= table_rows(study);
    for (std::size_t k = 0; k < sampled.size(); ++k)
      if (const auto* drawn = std::get_if<ByDraw>(&study.factors[sampled[k]].spread))
        by_draw.push_back({k, drawn->values});
  }

  /// The factors that lie on a grid; the last one changes fastest, and those of a table of rows most slowly.
  void write_levels(std::uint64_t combination, std::span<double> values) const {
    for (std::size_t i = levels.size(); i-- > 0;) {
      if (levels[i].empty()) continue;
      values[i] = levels[i][combination % levels[i].size()];
      combination /= levels[i].size();
    }
    for (std::size_t i = 0; i < by_row.size(); ++i)
      if (!by_row[i].empty()) values[i] = by_row[i][combination];
  }

  /// The factors that are drawn together: the fraction of the first chooses the row for all.
  void write_drawn_together(std::uint64_t draw, std::uint64_t block, std::span<double> values) const {
    if (by_draw.empty()) return;
    const std::size_t rows = by_draw.front().values.size();
    const double place = fraction(draw, block, by_draw.front().which) * static_cast<double>(rows);
    for (const DrawnTogether& factor : by_draw)
      values[sampled[factor.which]] = factor.values[std::min(static_cast<std::size_t>(place), rows - 1)];
  }

  [[nodiscard]] double fraction(std::uint64_t draw, std::uint64_t block, std::size_t which) const {
    const bool from_second = block == 1 || block == 2 + which;
    return source.at(draw, which + (from_second ? sampled.size() : 0));
  }

  /// Gaussian copula: the fraction of a sum of independent normal scores.
  [[nodiscard]] double correlated_fraction(std::uint64_t draw, std::size_t which) const {
    double score = 0;
    for (std::size_t k = 0; k <= which; ++k)
      if (root[which][k] != 0) score += root[which][k] * quantile(StandardNormal(), source.at(draw, k));
    return cdf(StandardNormal(), score);
  }

  struct DrawnTogether {
    std::size_t which = 0;  ///< of the sampled factors
    std::vector<double> values;
  };

  std::uint64_t samples, blocks, combinations = 1;
  std::vector<std::size_t> sampled;
  FractionSource source;
  Matrix root;  ///< empty without correlations
  std::vector<Quantiles> quantiles;
  std::vector<std::vector<double>> levels, by_row;  ///< of each factor; empty for others
  std::vector<DrawnTogether> by_draw;
};

Design::Design(const Study& study) {
  const auto broken = violations(study);
  if (!broken.empty()) throw std::invalid_argument(broken.front().key + ": " + broken.front().rule);
  plan_ = std::make_unique<const Plan>(study);
}

Design::~Design() = default;
Design::Design(Design&&) noexcept = default;
Design& Design::operator=(Design&&) noexcept = default;

std::uint64_t Design::rows() const { return plan_->combinations * rows_of_combination(); }

std::uint64_t Design::rows_of_combination() const { return plan_->samples * plan_->blocks; }

int Design::block_of(std::uint64_t row) const { return static_cast<int>(row % plan_->blocks); }

std::uint64_t Design::draw_of(std::uint64_t row) const { return row / plan_->blocks % plan_->samples; }

void Design::factors_of(std::uint64_t row, std::span<double> values) const {
  if (row >= rows() || values.size() != plan_->levels.size())
    throw std::out_of_range("no such row of the study");
  plan_->write_levels(row / plan_->blocks / plan_->samples, values);
  const std::uint64_t draw = draw_of(row), block = row % plan_->blocks;
  for (std::size_t k = 0; k < plan_->sampled.size(); ++k) {
    const double fraction =
        plan_->root.empty() ? plan_->fraction(draw, block, k) : plan_->correlated_fraction(draw, k);
    values[plan_->sampled[k]] = plan_->quantiles[k].at(fraction);
  }
  plan_->write_drawn_together(draw, block, values);
}

}  // namespace dashpad::study
