#include "dashpad/case/case_quantity.hpp"

#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"

namespace dashpad {
namespace {

/// `place` gives a reference to the number, of a case that may be constant.
template <class Place>
CaseQuantity quantity_at(const std::string& key, const std::string& unit, Place place) {
  return {.key = key,
          .unit = unit,
          .get =
              [place](const ImpactCase& impact) {
                const std::optional<double> value = place(impact);
                return value.value_or(std::numeric_limits<double>::quiet_NaN());
              },
          .set = [place](ImpactCase& impact, double value) { place(impact) = value; }};
}

/// Adds every number of what `place` finds: a nose, a law, a form of a curve. The points of a table are not
/// among them.
template <class Place>
void add_parameters(const ImpactCase& base, const std::string& prefix, Place place,
                    std::vector<CaseQuantity>& into) {
  std::visit(
      [&]<class Of>(const Of&) {
        if constexpr (requires { Of::parameters; })
          for (const Parameter<Of>& parameter : Of::parameters)
            into.push_back(quantity_at(
                prefix + parameter.key, parameter.unit,
                [ place, member = parameter.member ](auto& impact) -> auto& {
                  return std::get<Of>(place(impact)).*member;
                }));
      },
      place(base));
}

/// What a material and its condition have. `of` gives a reference to the one or the other: a pad or a layer.
template <class Of>
void add_material(const ImpactCase& base, const std::string& prefix, Of of, std::vector<CaseQuantity>& into) {
  into.push_back(quantity_at(
      prefix + "scale", "1", [of](auto& impact) -> auto& { return of(impact).condition.scale; }));
  const Material& material = of(base).material;
  if (material.density_exponent)
    into.push_back(quantity_at(
        prefix + "density", "kg/m3", [of](auto& impact) -> auto& { return of(impact).condition.density; }));
  if (!material.temperature_table.temperature.empty())
    into.push_back(quantity_at(
        prefix + "temperature",
        "K", [of](auto& impact) -> auto& { return of(impact).condition.temperature; }));
  const auto law_in = [of](auto& impact) -> auto& { return of(impact).material.law; };
  add_parameters(base, prefix + "parameters.", law_in, into);
  std::visit(
      [&]<class Law>(const Law&) {
        if constexpr (SharesSlip<Law>) {
          const auto curves_in = [law_in](auto& impact) -> auto& {
            return std::get<Law>(law_in(impact)).curves;
          };
          add_parameters(
              base, prefix + "curve.", [curves_in](auto& impact) -> auto& { return curves_in(impact).base; },
              into);
          add_parameters(
              base,
              prefix + "rate.", [curves_in](auto& impact) -> auto& { return curves_in(impact).rate_effect; },
              into);
        }
      },
      material.law);
}

/// What earlier blows have left in the pad, and leave in it.
void add_blows(const ImpactCase& base, std::vector<CaseQuantity>& into) {
  if (base.pad.layers.empty() && blow_memory(base.pad.material.law) != BlowMemory::none)
    into.push_back(quantity_at(
        "pad.earlier_penetration", "m",
        [](auto& impact) -> auto& { return impact.pad.earlier_penetration; }));
  if (base.blows)
    into.push_back(quantity_at(
        "blows.recovery", "1", [](auto& impact) -> auto& { return impact.blows->recovery; }));
}

void add_layer(const ImpactCase& base, std::size_t i, std::vector<CaseQuantity>& into) {
  const std::string prefix = fmt::format("pad.layers[{}].", i + 1);
  into.push_back({.key = prefix + "thickness",
                  .unit = "m",
                  .get = [i](const ImpactCase& impact) { return impact.pad.layers.at(i).thickness; },
                  .set =
                      [i](ImpactCase& impact, double value) {
                        impact.pad.layers.at(i).thickness = value;
                        set_layers(impact.pad, std::move(impact.pad.layers));
                      }});
  add_material(
      base, prefix, [i](auto& impact) -> auto& { return impact.pad.layers.at(i); }, into);
}

void add_pad(const ImpactCase& base, std::vector<CaseQuantity>& into) {
  const bool is_layered = !base.pad.layers.empty();
  if (!is_layered)
    into.push_back(quantity_at(
        "pad.thickness", "m", [](auto& impact) -> auto& { return impact.pad.thickness; }));
  if (base.pad.area)
    into.push_back(quantity_at(
        "pad.area", "m2", [](auto& impact) -> auto& { return impact.pad.area; }));
  if (base.pad.sheet > 0)
    into.push_back(quantity_at(
        "pad.sheet_mass_per_area", "kg/m2", [](auto& impact) -> auto& { return impact.pad.sheet; }));
  into.push_back(quantity_at(
      "pad.neighbours", "1", [](auto& impact) -> auto& { return impact.pad.neighbours; }));
  if (!is_layered)
    add_material(
        base, "pad.", [](auto& impact) -> auto& { return impact.pad; }, into);
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

}  // namespace

std::vector<CaseQuantity> quantities_of(const ImpactCase& base) {
  std::vector<CaseQuantity> all;
  all.push_back(quantity_at(
      "impactor.mass", "kg", [](auto& impact) -> auto& { return impact.impactor.mass; }));
  all.push_back(
      {.key = "impactor.weight",
       .unit = "N",
       .get = [](const ImpactCase& impact) { return impact.impactor.mass * standard_gravity; },
       .set = [](ImpactCase& impact, double value) { impact.impactor.mass = value / standard_gravity; }});
  add_parameters(
      base, "impactor.", [](auto& impact) -> auto& { return impact.impactor.nose; }, all);
  all.push_back(quantity_at(
      "impactor.speed", "m/s", [](auto& impact) -> auto& { return impact.impactor.speed; }));
  add_pad(base, all);
  all.push_back(quantity_at(
      "impactor.gravity", "m/s2", [](auto& impact) -> auto& { return impact.impactor.gravity; }));
  add_support(base.support, all);
  for (const Parameter<Backing>& parameter : Backing::parameters)
    if (base.backing.*parameter.member != 0)
      all.push_back(quantity_at(
          std::string("support.") + parameter.key,
          parameter.unit, [member = parameter.member](auto& impact) -> auto& {
            return impact.backing.*member;
          }));
  add_blows(base, all);
  return all;
}

}  // namespace dashpad
