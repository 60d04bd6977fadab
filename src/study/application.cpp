#include "dashpad/study/application.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/study/design.hpp"
#include "input/spelling.hpp"

namespace dashpad::study {
namespace {

/// Whether the key is in a table of the case, or is the table itself, which TOML opens only for known keys.
bool is_in(const std::string& key, std::string_view table) { return (key + ".").starts_with(table); }

template <class Variant>
const char* form_of(const Variant& variant) {
  return std::visit([](const auto& form) { return form.name; }, variant);
}

/// What the pad has in place of a number of its curve or of its rate effect.
std::string rule_for_curves(const std::string& table, const PadLaw& law,
                            const std::vector<std::string>& known) {
  const auto there_are = [&](std::string_view prefix) {
    std::vector<std::string> names;
    std::ranges::copy_if(known, std::back_inserter(names),
                         [&](const std::string& name) { return name.starts_with(prefix); });
    return names.empty() ? ", which has no numbers that can vary" : "; there are " + input::listing(names);
  };
  return std::visit(
      [&]<class Law>(const Law& of) {
        if constexpr (SharesSlip<Law>)
          return (table == "pad.curve."
                      ? fmt::format("the curve of the pad has the form {}", form_of(of.curves.base))
                      : fmt::format("the rate effect of the pad has the form {}",
                                    form_of(of.curves.rate_effect))) +
                 there_are(table);
        else
          return fmt::format("the law of the pad, {}, is not made of curves", Law::name) +
                 there_are("pad.parameters.");
      },
      law);
}

}  // namespace

std::vector<FactorKey> factor_keys(const ImpactCase& base) {
  std::vector<FactorKey> keys;
  for (const CaseQuantity& of : quantities_of(base)) keys.push_back({of.key, of.unit});
  if (base.pad.layers.empty()) keys.push_back({"pad.material", ""});
  return keys;
}

std::string rule_for_unknown(const std::string& key, const ImpactCase& base) {
  if (key == "support.stiffness" || key == "support.scale")
    return base.support.is_rigid()
               ? "the support of the case is rigid"
               : "the support of the case is a curve: vary support.scale, which multiplies its forces";
  std::vector<std::string> known;
  for (const FactorKey& of : factor_keys(base)) known.push_back(of.key);
  for (const char* table : {"pad.curve.", "pad.rate."})
    if (is_in(key, table) && base.pad.layers.empty())
      return rule_for_curves(table, base.pad.material.law, known);
  const std::string meant = input::did_you_mean(key, known);
  return "is no quantity of the case that can vary" +
         (meant.empty() ? "; there are " + input::listing(known) : meant);
}

bool is_of_law(const std::string& key) {
  // Of a layer, "pad.layers[2].parameters.friction", as of a pad.
  const std::size_t bracket = key.starts_with("pad.layers[") ? key.find("].") : std::string::npos;
  const std::string of_pad = bracket == std::string::npos ? key : "pad." + key.substr(bracket + 2);
  return is_in(of_pad, "pad.parameters.") || is_in(of_pad, "pad.curve.") || is_in(of_pad, "pad.rate.");
}

Application::Application(const Study& study) {
  const CaseQuantities quantities = quantities_of(study.base);
  // What is nominal for one material may not be for another.
  const bool is_nominal = study.base.pad.neighbours == nominal_neighbours(study.base.pad) &&
                          std::ranges::count(study.factors, "pad.neighbours", &Factor::key) == 0;
  for (const Factor& factor : study.factors) {
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
    if (found == nullptr) throw std::invalid_argument("no quantity of the case: " + factor.key);
    steps_.push_back(found->set);
  }
}

void Application::operator()(std::span<const double> values, ImpactCase& into) const {
  for (std::size_t i = 0; i < steps_.size(); ++i) steps_[i](into, values[i]);
}

void apply(const Study& study, std::span<const double> values, ImpactCase& into) {
  const Application application(study);
  application(values, into);
}

}  // namespace dashpad::study
