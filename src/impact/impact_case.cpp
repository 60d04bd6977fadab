#include "dashpad/impact/impact_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "dashpad/quantities/constants.hpp"
#include "model/pad/layer/layer_law.hpp"

#include "model/parameter_values.hpp"

namespace dashpad {
namespace {

/// Ranges within which the solver's arithmetic cannot overflow, wider than any real impact.
constexpr Bounds lengths = Pad::parameters[0].bounds;
constexpr Bounds stiffnesses = wide(1e-3, 1e15);

/// Adds a violation if the value is out of bounds; NaN always is. `must`: first words of the rule.
void check(std::vector<Violation>& broken, std::string key, double value, const Bounds& bounds,
           std::string_view unit, const std::string& must = "must be ") {
  constexpr std::string_view begin = "must be ";
  if (const auto rule = broken_rule(value, bounds, unit))
    broken.push_back({std::move(key), value, must + rule->substr(begin.size())});
}

// The rules between the numbers of a nose. NaN breaks its range already.

template <class Shape>
void check_rules(const Shape&, std::vector<Violation>&) {}

void check_rules(const Cone& cone, std::vector<Violation>& broken) {
  if (cone.tip_radius >= cone.radius)
    broken.push_back({"impactor.tip_radius", cone.tip_radius, "must be less than radius"});
}

void check_rules(const Rod& rod, std::vector<Violation>& broken) {
  if (rod.tip_radius < rod.radius)
    broken.push_back({"impactor.tip_radius", rod.tip_radius, "must be at least radius"});
}

void check_rules(const Profile& profile, std::vector<Violation>& broken) {
  const std::string list = profile.of == Profile::Of::radius ? "impactor.radii" : "impactor.areas";
  const std::vector<Profile::Fault> faults = profile.faults();
  for (const Profile::Fault& fault : faults) {
    const bool is_point = fault.point < profile.points.size() && profile.points.size() > 1;
    broken.push_back(
        {is_point ? fmt::format("{}[{}]", list, fault.point + 1) : list,
         is_point ? profile.points[fault.point].size : static_cast<double>(profile.points.size()),
         fault.rule});
  }
  if (!faults.empty() || !Profile::parameters[0].bounds.contain(profile.scale)) return;
  const double widest = profile.sections().radius(infinite);
  check(broken, list, widest, lengths, "m", "the largest radius must be ");
  check(broken, list, profile.scale * profile.points.back().depth, lengths, "m", "the last depth must be ");
}

/// Checks the numbers of a nose: lengths against their common range (or 0 if admitted), others by the table.
void check_nose(std::vector<Violation>& broken, const Nose& nose) {
  std::visit(
      [&]<class Shape>(const Shape& shape) {
        for (const Parameter<Shape>& parameter : Shape::parameters) {
          const std::string key = std::string("impactor.") + parameter.key;
          const double value = parameter.of(shape);
          const bool may_vanish = parameter.bounds.contain(0);
          if (may_vanish && value == 0) continue;
          if (std::string_view(parameter.unit) == "m")
            check(broken, key, value, lengths, "m", may_vanish ? "must be 0, or " : "must be ");
          else if (const auto rule = broken_rule(value, parameter.bounds, parameter.unit))
            broken.push_back({key, value, *rule});
        }
        check_rules(shape, broken);
      },
      nose);
}

void check_support(std::vector<Violation>& broken, const Support& support) {
  const auto& points = support.points();
  Support::Point before;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double stiffness = (points[i].force - before.force) / (points[i].deflection - before.deflection);
    check(broken, points.size() == 1 ? "support.stiffness" : fmt::format("support.points[{}]", i + 1),
          stiffness, stiffnesses, "N/m", "the stiffness up to this point must be ");
    before = points[i];
  }
}

/// Checks the earlier penetration; NaN breaks the rule.
void check_earlier_penetration(std::vector<Violation>& broken, const Pad& pad) {
  const double earlier = pad.earlier_penetration;
  const bool has_thickness = lengths.contain(pad.thickness);
  const char* const key = "pad.earlier_penetration";
  if (!(earlier >= 0) || (has_thickness && !(earlier < pad.thickness)))
    broken.push_back({key, earlier, "must be at least 0 and less than pad.thickness"});
  else if (earlier > 0 && blow_memory(pad.material.law) == BlowMemory::none)
    broken.push_back({key, earlier,
                      "must be 0: a pad with the " + name_of(pad.material.law) +
                          " law recovers fully, so earlier blows leave no trace in it"});
}

void check_blows(std::vector<Violation>& broken, const ImpactCase& impact) {
  if (!impact.blows) return;
  check_bounds(*impact.blows, "blows.", broken);
  const double recovery = impact.blows->recovery;
  const PadLaw& law = impact.pad.material.law;
  if (recovery > 0 && recovery <= 1 && blow_memory(law) == BlowMemory::crater)
    broken.push_back(
        {"blows.recovery", recovery, "must be 0: a pad with the " + name_of(law) + " law does not recover"});
}

void check_sheet(std::vector<Violation>& broken, const ImpactCase& impact) {
  const char* const key = "pad.sheet_mass_per_area";
  if (impact.blows || impact.pad.earlier_penetration != 0)
    broken.push_back({key, impact.pad.sheet,
                      "must be left out for repeated blows: how the sheet lies after one is not known"});
  if (std::holds_alternative<Cylinder>(impact.impactor.nose))
    broken.push_back({key, impact.pad.sheet,
                      "must be left out for a cylinder: it meets the sheet along a line, and the force of "
                      "that collision is unbounded"});
}

/// Checks the parts of a support; those that are 0 are absent.
void check_backing(std::vector<Violation>& broken, const Support& support, const Backing& backing) {
  const std::size_t before = broken.size();
  check_bounds(backing, "support.", broken);
  if (broken.size() > before) return;
  if (support.is_rigid()) {
    for (const Parameter<Backing>& parameter : Backing::parameters)
      if (parameter.member != &Backing::body_mass && parameter.of(backing) != 0)
        broken.push_back({std::string("support.") + parameter.key, parameter.of(backing),
                          "must be left out: a rigid support can only have a free body behind it"});
    return;
  }
  if (backing.damping > 0 && backing.loss_factor > 0)
    broken.push_back({"support.loss_factor", backing.loss_factor, "give damping or loss_factor, not both"});
  if (backing.gap > 0 && backing.preload > 0)
    broken.push_back({"support.gap", backing.gap, "must be left out: a support with a preload has no gap"});
  if (backing.gap > 0 && !(backing.mass > 0))
    broken.push_back({"support.gap", backing.gap,
                      "needs the mass of the panel: in the gap, only inertia resists its motion"});
  if (backing.earlier_force > 0 && !(backing.unloading_stiffness > 0))
    broken.push_back({"support.earlier_force", backing.earlier_force,
                      "needs an unloading_stiffness: earlier forces leave no trace in an elastic support"});
  double steepest = 0;
  for (double force : {0.0, support.points().back().force})
    steepest = std::max(steepest, 1 / support.compliance(force));
  for (const double corner : support.corners()) steepest = std::max(steepest, 1 / support.compliance(corner));
  if (backing.unloading_stiffness > 0 && backing.unloading_stiffness < steepest)
    broken.push_back(
        {"support.unloading_stiffness", backing.unloading_stiffness,
         fmt::format("must be at least the steepest slope of the support, {:.6g} N/m", steepest)});
}

void add(std::vector<Violation>& broken, std::vector<Violation> more, const std::string& prefix) {
  for (Violation& violation : more) {
    violation.key = prefix + violation.key;
    broken.push_back(std::move(violation));
  }
}

/// Least thickness of a layer as a share of the pad's.
constexpr double min_share = 1e-6;

void check_layers(std::vector<Violation>& broken, const Pad& pad) {
  if (pad.layers.size() > max_layers)
    broken.push_back({"pad.layers", double(pad.layers.size()),
                      fmt::format("there must be at most {} layers", max_layers)});
  double sum = 0;
  for (const PadLayer& layer : pad.layers) sum += layer.thickness;
  if (std::abs(sum - pad.thickness) > 1e-9 * sum)
    broken.push_back({"pad.thickness", pad.thickness, "must equal the total thickness of the layers"});
  for (std::size_t i = 0; i < pad.layers.size(); ++i) {
    const PadLayer& layer = pad.layers[i];
    const std::string prefix = fmt::format("pad.layers[{}].", i + 1);
    const std::size_t before = broken.size();
    for (const Parameter<PadLayer>& parameter : PadLayer::parameters)
      if (parameter.member != &PadLayer::thickness) check_bounds(layer, parameter, prefix, broken);
    if (!(layer.thickness > 0) || layer.thickness < min_share * sum)
      broken.push_back(
          {prefix + "thickness", layer.thickness,
           fmt::format("must be more than 0 and at least {} times the pad thickness", min_share)});
    add(broken, violations(layer.material), prefix);
    add(broken, violations(layer.condition, layer.material), prefix);
    if (broken.size() == before) add(broken, violations_as_layer(layer.material.law), prefix);
  }
}

std::vector<Violation> violations_with(std::vector<Violation> of_material, const ImpactCase& impact) {
  std::vector<Violation> broken;
  check_bounds(impact.impactor, "impactor.", broken);
  check_nose(broken, impact.impactor.nose);
  for (const Parameter<Pad>& parameter : Pad::parameters) {
    // The sum of layers is checked if each has a thickness; earlier blows are checked below.
    const bool is_sum_of_faults =
        parameter.member == &Pad::thickness &&
        !std::ranges::all_of(impact.pad.layers, [](const PadLayer& layer) { return layer.thickness > 0; });
    if (!is_sum_of_faults && parameter.member != &Pad::earlier_penetration)
      check_bounds(impact.pad, parameter, "pad.", broken);
  }
  if (impact.pad.sheet != 0) check_sheet(broken, impact);
  if (impact.pad.layers.empty()) {
    add(broken, std::move(of_material), "pad.");
    add(broken, violations(impact.pad.condition, impact.pad.material), "pad.");
  } else {
    check_layers(broken, impact.pad);
  }
  if (impact.pad.layers.empty())
    check_earlier_penetration(broken, impact.pad);
  else if (impact.pad.earlier_penetration != 0)
    broken.push_back({"pad.earlier_penetration", impact.pad.earlier_penetration,
                      "must be 0: the state of a layered pad after earlier blows is not known"});
  check_support(broken, impact.support);
  check_backing(broken, impact.support, impact.backing);
  if (impact.impactor.gravity > 0 && impact.backing.body_mass > 0)
    broken.push_back({"impactor.gravity", impact.impactor.gravity,
                      "must be 0 with a free body behind the support, because that body would fall too"});
  if (impact.pad.layers.empty())
    check_blows(broken, impact);
  else if (impact.blows)
    broken.push_back({"blows.count", double(impact.blows->count),
                      "a layered pad can be struck only once: its state after a blow is not known"});
  return broken;
}

}  // namespace

void set_layers(Pad& pad, std::vector<PadLayer> layers) {
  pad.layers = std::move(layers);
  pad.thickness = 0;
  for (const PadLayer& layer : pad.layers) pad.thickness += layer.thickness;
}

Sections sections_of(const ImpactCase& impact) {
  const Sections nose = sections_of(impact.impactor.nose);
  return impact.pad.area ? nose.limited_to(*impact.pad.area) : nose;
}

std::vector<Violation> violations(const ImpactCase& impact) {
  const bool is_layered = !impact.pad.layers.empty();
  return violations_with(is_layered ? std::vector<Violation>() : violations(impact.pad.material), impact);
}

std::vector<Violation> violations_beside_law(const ImpactCase& impact) {
  return violations_with(violations_beside_law(impact.pad.material), impact);
}

}  // namespace dashpad
