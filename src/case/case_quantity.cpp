#include "dashpad/case/case_quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

namespace {

/// Adds a number of the owner that `place` returns for a case, constant or not: a nose, a law, a pad.
/// `parameter` must outlive the quantity.
template <class Owner, class Place>
void add_parameter(const std::string& prefix, const Parameter<Owner>& parameter, Place place,
                   std::vector<CaseQuantity>& into) {
  into.push_back(
      {.key = prefix + parameter.key,
       .unit = parameter.unit,
       .get = [place, &parameter](const ImpactCase& impact) { return parameter.of(place(impact)); },
       .set = [place, &parameter](ImpactCase& impact,
                                  double value) { parameter.set(place(impact), value); }});
}

/// Adds every number of an owner that is not absent and not excluded by `is_excluded`.
template <class Owner, class Place, class Leave>
void add_parameters(const ImpactCase& base, const std::string& prefix, Place place, Leave is_excluded,
                    std::vector<CaseQuantity>& into) {
  const Owner& owner = place(base);
  for (const Parameter<Owner>& parameter : Owner::parameters)
    if (!parameter.is_none(owner) && !is_excluded(parameter)) add_parameter(prefix, parameter, place, into);
}

constexpr auto none = [](const auto&) { return false; };

/// The same for the alternative of a variant: a nose, a law, a form of a curve, but not points of tables.
template <class Place>
void add_alternative(const ImpactCase& base, const std::string& prefix, Place place,
                     std::vector<CaseQuantity>& into) {
  std::visit(
      [&]<class Of>(const Of&) {
        if constexpr (requires { Of::parameters; })
          add_parameters<Of>(
              base, prefix, [place](auto& impact) -> auto& { return std::get<Of>(place(impact)); }, none,
              into);
      },
      place(base));
}

/// Adds the numbers of a material and its condition. `owner` returns the pad or layer that has them.
template <class Of>
void add_material(const ImpactCase& base, const std::string& prefix, Of owner,
                  std::vector<CaseQuantity>& into) {
  // Density and temperature need data in the card; they may then vary without being given in the case.
  const Material& material = owner(base).material;
  for (const Parameter<PadCondition>& parameter : PadCondition::parameters) {
    const bool is_silent =
        (parameter.member == &PadCondition::density && !material.density_exponent) ||
        (parameter.member == &PadCondition::temperature && material.temperature_table.temperature.empty());
    if (is_silent) continue;
    add_parameter(
        prefix, parameter, [owner](auto& impact) -> auto& { return owner(impact).condition; }, into);
    if (parameter.member == &PadCondition::density)
      into.back().get = [owner](const ImpactCase& impact) {
        const auto& part = owner(impact);
        return part.condition.density.value_or(part.material.density.value_or(no_value));
      };
  }
  const auto law_in = [owner](auto& impact) -> auto& { return owner(impact).material.law; };
  add_alternative(base, prefix + "parameters.", law_in, into);
  std::visit(
      [&]<class Law>(const Law&) {
        if constexpr (SharesSlip<Law>) {
          const auto curves_in = [law_in](auto& impact) -> auto& {
            return std::get<Law>(law_in(impact)).curves;
          };
          add_alternative(
              base, prefix + "curve.", [curves_in](auto& impact) -> auto& { return curves_in(impact).base; },
              into);
          add_alternative(
              base,
              prefix + "rate.", [curves_in](auto& impact) -> auto& { return curves_in(impact).rate_effect; },
              into);
        }
      },
      material.law);
}

void add_layer(const ImpactCase& base, std::size_t i, std::vector<CaseQuantity>& into) {
  const std::string prefix = fmt::format("pad.layers[{}].", i + 1);
  for (const Parameter<PadLayer>& parameter : PadLayer::parameters)
    into.push_back(
        {.key = prefix + parameter.key,
         .unit = parameter.unit,
         .get = [i, &parameter](const ImpactCase& impact) { return parameter.of(impact.pad.layers.at(i)); },
         .set =
             [i, &parameter](ImpactCase& impact, double value) {
               parameter.set(impact.pad.layers.at(i), value);
               set_layers(impact.pad, std::move(impact.pad.layers));  // whose thickness is their sum
             }});
  add_material(
      base, prefix, [i](auto& impact) -> auto& { return impact.pad.layers.at(i); }, into);
}

/// Adds the numbers of a pad; the earlier penetration only where the law remembers blows.
void add_pad(const ImpactCase& base, std::vector<CaseQuantity>& into) {
  const auto pad_in = [](auto& impact) -> auto& { return impact.pad; };
  const bool is_layered = !base.pad.layers.empty();
  const bool remembers = !is_layered && blow_memory(base.pad.material.law) != BlowMemory::none;
  const auto is_excluded = [&](const Parameter<Pad>& parameter) {
    return (is_layered && parameter.member == &Pad::thickness) ||
           (!remembers && parameter.member == &Pad::earlier_penetration);
  };
  add_parameters<Pad>(base, "pad.", pad_in, is_excluded, into);
  if (!is_layered) add_material(base, "pad.", pad_in, into);
  for (std::size_t i = 0; i < base.pad.layers.size(); ++i) add_layer(base, i, into);
}

void add_support(const Support& base, std::vector<CaseQuantity>& into) {
  if (base.points().size() == 1)
    into.push_back(
        {.key = "support.stiffness",
         .unit = "N/m",
         .get =
             [](const ImpactCase& impact) {
               const Support::Point& point = impact.support.points().front();
               return point.force / point.deflection;
             },
         .set = [](ImpactCase& impact, double value) { impact.support = Support::linear(value); }});
  if (!base.is_rigid())
    into.push_back({.key = "support.scale",
                    .unit = "1",
                    .get =
                        [base](const ImpactCase& impact) {
                          return impact.support.points().back().force / base.points().back().force;
                        },
                    .set =
                        [base](ImpactCase& impact, double factor) {
                          std::vector<Support::Point> points = base.points();
                          for (Support::Point& point : points) point.force *= factor;
                          impact.support = Support::through(std::move(points));
                        }});
}

/// Gravity of the fall, m/s2; standard gravity for a case without, whose weight does no work in contact.
double gravity_of_fall(const ImpactCase& impact) {
  return impact.impactor.gravity > 0 ? impact.impactor.gravity : standard_gravity;
}

constexpr std::array<OtherWay, 2> all_other_ways{{
    {.key = "impactor.weight",
     .unit = "N",
     .instead_of = "impactor.mass",
     .meaning = "weight of the impactor",
     .what_follows = "the mass",
     .get = [](const ImpactCase& impact) { return impact.impactor.mass * standard_gravity; },
     .set = [](ImpactCase& impact, double value) { impact.impactor.mass = value / standard_gravity; },
     .rule_if_missing = "is missing; give a mass, such as \"4.5 kg\", or a weight, such as \"10 lbf\""},
    {.key = "impactor.drop_height",
     .unit = "m",
     .bounds = in_words(0, infinite, "more than 0", false),
     .instead_of = "impactor.speed",
     .meaning = "drop height",
     .what_follows = "the speed after the fall",
     .get =
         [](const ImpactCase& impact) {
           return std::pow(impact.impactor.speed, 2) / (2 * gravity_of_fall(impact));
         },
     .set =
         [](ImpactCase& impact, double value) {
           impact.impactor.speed =
               std::copysign(std::sqrt(2 * gravity_of_fall(impact) * std::abs(value)), value);
         }},
}};

/// The area that a flat nose loads, m2: its tip, or the pad if that is smaller; 0 for other noses.
double loaded_area(const ImpactCase& impact) {
  const double tip = sections_of(impact).tip;
  return impact.pad.area ? std::min(tip, *impact.pad.area) : tip;
}

/// Adds the static stress, M g / A, in place of the mass, for a flat nose: A is the area that it loads.
void add_static_stress(const ImpactCase& base, std::vector<CaseQuantity>& into) {
  if (!(loaded_area(base) > 0)) return;
  into.push_back(
      {.key = static_stress,
       .unit = "Pa",
       .get =
           [](const ImpactCase& impact) {
             return impact.impactor.mass * standard_gravity / loaded_area(impact);
           },
       .set = [](ImpactCase& impact,
                 double value) { impact.impactor.mass = value * loaded_area(impact) / standard_gravity; }});
}

template <class Owner>
void add_fields(const std::string& table, std::vector<CaseField>& into) {
  for (const Parameter<Owner>& parameter : Owner::parameters)
    into.push_back({table, parameter.key, parameter.unit, rule_of(parameter.bounds, parameter.unit),
                    parameter.left_out, parameter.of(Owner()), parameter.meaning, parameter.since});
}

}  // namespace

std::span<const OtherWay> other_ways() { return all_other_ways; }

std::string decided_by(const std::string& key) {
  if (key == static_stress) return "impactor.mass";
  for (const OtherWay& way : other_ways())
    if (key == way.key) return way.instead_of;
  return key;
}

CaseQuantities quantities_of(const ImpactCase& base) {
  std::vector<CaseQuantity> all;
  add_parameters<Impactor>(
      base, "impactor.", [](auto& impact) -> auto& { return impact.impactor; }, none, all);
  for (const OtherWay& way : other_ways()) all.push_back({way.key, way.unit, way.get, way.set});
  add_static_stress(base, all);
  add_alternative(
      base, "impactor.", [](auto& impact) -> auto& { return impact.impactor.nose; }, all);
  add_pad(base, all);
  add_support(base.support, all);
  add_parameters<Backing>(
      base, "support.", [](auto& impact) -> auto& { return impact.backing; }, none, all);
  // The number of blows is no such quantity: it would change the columns of a study.
  if (base.blows)
    add_parameters<Blows>(
        base, "blows.", [](auto& impact) -> auto& { return *impact.blows; },
        [](const Parameter<Blows>& parameter) { return parameter.member.is_count(); }, all);
  return CaseQuantities(std::move(all));
}

double case_value(const ImpactCase& impact, const std::string& key) {
  const CaseQuantities quantities = quantities_of(impact);
  const CaseQuantity* const quantity = quantities.find(key);
  return quantity == nullptr ? std::numeric_limits<double>::quiet_NaN() : quantity->get(impact);
}

CaseQuantities::CaseQuantities(std::vector<CaseQuantity> all) : all_(std::move(all)) {
  for (std::size_t i = 0; i < all_.size(); ++i) places_.emplace(all_[i].key, i);
}

const CaseQuantity* CaseQuantities::find(const std::string& key) const {
  const auto place = places_.find(key);
  return place == places_.end() ? nullptr : &all_[place->second];
}

std::vector<CaseField> case_fields() {
  std::vector<CaseField> all;
  add_fields<Impactor>("impactor", all);
  add_fields<Pad>("pad", all);
  add_fields<PadCondition>("pad", all);
  add_fields<PadLayer>("pad.layers", all);
  add_fields<PadCondition>("pad.layers", all);
  add_fields<Backing>("support", all);
  add_fields<Blows>("blows", all);
  add_fields<Options>("solver", all);
  return all;
}

}  // namespace dashpad
