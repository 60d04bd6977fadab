#include "property/case_of_practice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/input/case_file.hpp"
#include "model/pad/layer/layer_law.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

/// One of each kind: law 4, law 5, crushable, one and several tested rates, conditioned, an unloading curve.
constexpr std::array cards{
    "ensolite-aac-9", "ensolite-aac-21",    "eps-12-geofoam",           "eps-29",
    "ff-leap",        "midsole-heel",       "plastazote-ld33",          "poron-low-density",
    "vn600",          "team-wendy-hard-pu", "ff-turbo-plus-conditioned"};

const Material& card(int index) {
  static const std::vector<Material> read = [] {
    std::vector<Material> all;
    for (const char* name : cards)
      all.push_back(
          input::read_material(std::string(DASHPAD_SOURCE_DIR) + "/materials/" + name + ".toml").value());
    return all;
  }();
  return read[static_cast<std::size_t>(index)];
}

std::uint64_t seed_of(Draw& draw) { return static_cast<std::uint64_t>(draw.choice(1 << 30)); }

ViscoelasticFoam slow_foam(Draw& draw) {
  const auto exponent = [&draw] {
    return draw.choice(3) == 0 ? draw.uniform(-2, -0.5) : draw.uniform(1, 15);
  };
  ViscoelasticFoam foam;
  foam.first_modulus = draw.decades(2e3, 1e5);
  foam.first_exponent = exponent();
  if (draw.choice(2) == 0) {
    foam.second_modulus = foam.first_modulus * draw.uniform(0.1, 1);
    foam.second_exponent = exponent();
  }
  foam.first_share = draw.decades(0.3, 20);
  foam.first_time = draw.decades(1e-3, 1);
  if (draw.choice(2) == 0) {
    foam.second_share = draw.decades(0.3, 5);
    foam.second_time = foam.first_time * draw.decades(3, 100);
  }
  return foam;
}

Material material_of(Draw& draw) {
  Material material;
  material.name = foam_of_the_case;
  switch (draw.choice(12)) {
    case 0:
    case 1:
    case 2:
    case 3: return card(draw.choice(static_cast<int>(cards.size())));
    case 4:
    case 5:
    case 6: material.law = plausible_case(seed_of(draw)).pad.material.law; break;
    case 7: material.law = slow_foam(draw); break;
    case 8:
    case 9: material.law = random_crushable_foam(seed_of(draw)); break;
    default: material.law = random_foam(seed_of(draw));
  }
  return material;
}

double stress_at(const BaseCurve& base, double strain) {
  if (const auto* table = std::get_if<TableCurve>(&base)) {
    const auto above = std::ranges::lower_bound(table->strain, strain);
    const auto i = std::min(above - table->strain.begin(), std::ssize(table->stress) - 1);
    return table->stress[static_cast<std::size_t>(i)];
  }
  return std::visit(
      [&](const auto& form) {
        if constexpr (requires { form.stress(strain); })
          return form.stress(std::min(strain, form.highest_strain));
        else
          return 0.0;
      },
      base);
}

/// What a law carries at a strain of 0.4, roughly.
double usual_stress(const PadLaw& law) {
  constexpr double strain = 0.4;
  return std::visit(
      []<class Law>(const Law& held) {
        if constexpr (SharesSlip<Law>)
          return stress_at(held.curves.base, strain);
        else if constexpr (std::is_same_v<Law, Elastic>)
          return held.modulus * strain;
        else if constexpr (std::is_same_v<Law, LinearViscoelastic>)
          return std::sqrt(held.asymptotic_modulus * held.initial_modulus) * strain;
        else if constexpr (std::is_same_v<Law, RigidFoam>)
          return held.crush_stress;
        else if constexpr (std::is_same_v<Law, ViscoelasticFoam>)
          return 2 * (held.first_modulus + held.second_modulus) * strain * (1 + held.first_share / 2);
        else
          return 3 * held.asymptotic_modulus;
      },
      law);
}

Profile profile_of(Draw& draw, double radius) {
  Profile profile{.of = draw.choice(2) == 0 ? Profile::Of::radius : Profile::Of::area};
  double depth = 0, size = draw.choice(2) == 0 ? 0 : radius * draw.uniform(0.05, 0.4);
  const int count = 3 + draw.choice(8);
  for (int i = 0; i < count; ++i) {
    profile.points.push_back({depth, profile.of == Profile::Of::radius ? size : 3 * size * size});
    depth += radius * draw.uniform(0.03, 0.3);
    size += radius * draw.uniform(0.02, 0.3);
  }
  return profile;
}

Nose nose_of(Draw& draw) {
  const double radius = draw.decades(0.02, 0.2);
  switch (draw.choice(12)) {
    case 0: return FlatDisc{radius};
    case 1: return Cone{radius, draw.uniform(0.5, 1.4)};
    case 2: return Cone{radius, draw.uniform(0.5, 1.4), radius * draw.uniform(0.1, 0.8)};
    case 3: return Ellipsoid{radius, radius * draw.decades(0.5, 2), radius * draw.decades(0.5, 2)};
    case 4: return Rod{radius, radius * draw.decades(1, 5)};
    case 5: return Platen{radius * 2, radius * draw.uniform(0.5, 2)};
    case 6: return Cylinder{radius, radius * draw.decades(0.5, 6)};
    case 7: return profile_of(draw, radius);
    default: return Sphere{radius};
  }
}

/// `force` and `length` are those of the pad in this impact, roughly.
Support support_of(Draw& draw, double force, double length) {
  const double stiffness = force / length * draw.decades(0.5, 50);
  const int kind = draw.choice(4);
  if (kind == 0) return Support::rigid();
  if (kind != 3) return Support::linear(stiffness);
  std::vector<Support::Point> points;
  Support::Point last;
  const int count = 2 + draw.choice(4);
  for (int i = 0; i < count; ++i) {
    const double advance = force / stiffness * draw.uniform(0.1, 0.6);
    last = {last.deflection + advance, last.force + advance * stiffness * draw.decades(0.2, 5)};
    points.push_back(last);
  }
  return Support::through(points);
}

/// What the support has beside its curve: of each part some have it.
Backing backing_of(Draw& draw, const ImpactCase& impact, double force) {
  Backing backing;
  const double mass = impact.impactor.mass;
  const bool is_free = impact.impactor.gravity == 0 && draw.choice(6) == 0;
  if (is_free) backing.body_mass = mass * draw.decades(0.5, 20);
  if (impact.support.is_rigid()) return backing;
  double steepest = 0;
  Support::Point from;
  for (const Support::Point& to : impact.support.points()) {
    steepest = std::max(steepest, (to.force - from.force) / (to.deflection - from.deflection));
    from = to;
  }
  if (draw.choice(4) == 0) backing.unloading_stiffness = steepest * draw.uniform(1.01, 5);
  if (draw.choice(4) == 0) backing.mass = mass * draw.decades(0.05, 2);
  switch (draw.choice(8)) {
    case 0: backing.loss_factor = draw.uniform(0.05, 0.6); break;
    case 1: backing.damping = 2 * std::sqrt(steepest * mass) * draw.decades(0.02, 0.5); break;
    default: break;
  }
  if (draw.choice(8) == 0)
    backing.preload = force * draw.decades(0.02, 0.5);
  else if (backing.mass > 0 && draw.choice(4) == 0)
    backing.gap = impact.pad.thickness * draw.uniform(0.02, 0.3);
  return backing;
}

std::vector<PadLayer> layers_of(Draw& draw, double thickness) {
  std::vector<PadLayer> layers(static_cast<std::size_t>(2 + draw.choice(2)));
  double sum = 0;
  for (PadLayer& layer : layers) {
    do layer.material = material_of(draw);
    while (!violations(layer.material).empty() || !violations_as_layer(layer.material.law).empty());
    sum += layer.thickness = draw.uniform(0.2, 0.8);
  }
  for (PadLayer& layer : layers) layer.thickness *= thickness / sum;
  return layers;
}

ImpactCase drawn(Draw& draw) {
  ImpactCase impact;
  Impactor& impactor = impact.impactor;
  impactor.mass = draw.decades(0.2, 20);
  impactor.nose = nose_of(draw);
  impactor.gravity = draw.choice(4) == 0 ? standard_gravity : 0;
  Pad& pad = impact.pad;
  pad.thickness = draw.decades(0.005, 0.15);
  double stress = 0;
  if (draw.choice(8) == 0) {
    set_layers(pad, layers_of(draw, pad.thickness));
    for (const PadLayer& layer : pad.layers)
      stress += usual_stress(layer.material.law) / static_cast<double>(pad.layers.size());
  } else {
    pad.material = material_of(draw);
    stress = usual_stress(pad.material.law);
    if (draw.choice(8) == 0) stress *= pad.condition.scale = draw.decades(0.5, 2);
  }
  const Sections nose = sections_of(impactor.nose);
  if (draw.choice(6) == 0) pad.area = nose.area_beyond() * draw.decades(0.1, 1.5);
  // The speed whose energy, over the volume that the nose displaces at a strain, is that stress.
  const double deep = pad.thickness * draw.uniform(0.1, 1.1);
  const double volume = sections_of(impact).volume(deep);
  impactor.speed = std::sqrt(2 * stress * volume / impactor.mass);
  if (impactor.speed < 0.5 || impactor.speed > 12) impactor.speed = draw.decades(0.5, 12);
  const double force = impactor.mass * impactor.speed * impactor.speed / deep;
  impact.support = support_of(draw, force, pad.thickness);
  impact.backing = backing_of(draw, impact, force);
  if (pad.layers.empty() && draw.choice(10) == 0) {
    const bool stays = blow_memory(pad.material.law) == BlowMemory::crater;
    impact.blows = Blows{2 + draw.choice(3), stays ? 0 : draw.uniform(0, 1)};
  } else if (draw.choice(10) == 0) {
    pad.sheet = draw.decades(0.2, 10);
  }
  return impact;
}

}  // namespace

ImpactCase case_of_practice(std::uint64_t seed) {
  Draw draw(seed);
  for (;;) {
    ImpactCase impact = drawn(draw);
    if (!violations(impact).empty()) continue;
    impact.title = "case of practice " + std::to_string(seed);
    return impact;
  }
}

}  // namespace dashpad::test
