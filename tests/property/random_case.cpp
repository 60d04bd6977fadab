#include "property/random_case.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/pad/layer/layer_law.hpp"
#include "property/draw.hpp"

namespace dashpad::test {
namespace {

/// tau* such that the unloading law is defined at the rates of the impact: tau* |rate| < 1.
double residual_strain_time(Draw& draw, double rate) {
  return std::min(draw.decades(1e-7, 1e-3), 0.3 / rate);
}

/// `rate` is the strain rate at first contact, 1/s.
PadLaw random_law(Draw& draw, double rate) {
  switch (draw.choice(5)) {
    case 0: return Elastic{draw.decades(1e3, 1e8)};
    case 1: {
      const double lasting = draw.decades(1e3, 1e7);
      return LinearViscoelastic{lasting, lasting * draw.decades(1, 1e3), draw.decades(1e-5, 1)};
    }
    case 2: {
      const double stress = draw.decades(1e3, 1e7);
      const double strain = draw.uniform(0.05, 0.9);
      return RigidFoam{stress, strain, stress * draw.decades(1, 20), draw.uniform(strain + 0.01, 0.99)};
    }
    case 3:
      return NineParameter{draw.decades(1e3, 1e7),
                           draw.uniform(0.2, 1),
                           draw.uniform(0, 3),
                           draw.decades(1e-5, 1),
                           draw.decades(1e2, 1e7),
                           draw.uniform(0.02, 1),
                           residual_strain_time(draw, rate),
                           draw.uniform(0.02, 0.8)};
    default: {
      const double m = draw.uniform(0.2, 1);
      return TwentyOneParameter{draw.decades(1e3, 1e7),
                                m,
                                draw.uniform(0, 3),
                                draw.uniform(0.05, 1),
                                draw.decades(0.01, 10),
                                draw.decades(0.3, 30),
                                draw.decades(1e2, 1e6),
                                draw.uniform(0.02, 0.6),
                                draw.uniform(1, 5),
                                draw.decades(0.1, 5),
                                draw.uniform(1, 4),
                                draw.decades(0.2, 2),
                                draw.uniform(m, 4),
                                draw.decades(1e-3, 1),
                                residual_strain_time(draw, rate),
                                draw.uniform(0.02, 0.8)};
    }
  }
}

Support random_support(Draw& draw) {
  switch (draw.choice(4)) {
    case 0: return Support::rigid();
    case 1: return Support::linear(draw.decades(1e3, 1e9));
    default: {
      std::vector<Support::Point> points;
      double deflection = 0;
      double force = 0;
      const int count = 1 + draw.choice(5);
      for (int i = 0; i < count; ++i) {
        deflection += draw.decades(1e-5, 1e-2);
        force += draw.decades(1, 1e5);
        points.push_back({deflection, force});
      }
      return Support::through(points);
    }
  }
}

constexpr double psi = 6894.757293168361;

PadLaw ordinary_law(Draw& draw, double rate) {
  const auto about = [&draw](double value, double factor) {
    return value * draw.decades(1 / factor, factor);
  };
  switch (draw.choice(5)) {
    case 0: return Elastic{draw.decades(3e4, 3e6)};
    case 1: {
      const double lasting = draw.decades(3e4, 1e6);
      return LinearViscoelastic{lasting, lasting * draw.uniform(1.2, 8), draw.decades(1e-3, 0.1)};
    }
    case 2: {
      const double stress = draw.decades(5e4, 2e6);
      const double strain = draw.uniform(0.3, 0.7);
      return RigidFoam{stress, strain, stress * draw.uniform(1, 5), strain + draw.uniform(0.05, 0.25)};
    }
    case 3:
      return NineParameter{about(7.96 * psi, 3),
                           draw.uniform(0.4, 1),
                           draw.uniform(0.5, 1.5),
                           about(8.81e-3, 3),
                           about(5.45 * psi, 3),
                           about(0.166, 2),
                           std::min(about(9.76e-6, 3), 0.3 / rate),
                           about(0.0987, 2)};
    default: {
      const double m = draw.uniform(0.4, 1);
      return TwentyOneParameter{about(7.96 * psi, 3),
                                m,
                                draw.uniform(0.5, 1.5),
                                about(0.13, 1.5),
                                about(0.156, 2),
                                about(3.08, 1.5),
                                about(4.153 * psi, 2),
                                about(0.19, 1.5),
                                about(3.17, 1.2),
                                about(0.58, 1.2),
                                about(2.57, 1.2),
                                about(0.296, 1.2),
                                about(2.23, 1.2),
                                about(1.64e-3, 2),
                                std::min(about(9.76e-6, 3), 0.3 / rate),
                                about(0.0987, 2)};
    }
  }
}

/// Rigid, linear, or a curve that stiffens or softens from corner to corner.
Support ordinary_support(Draw& draw) {
  switch (draw.choice(4)) {
    case 0: return Support::rigid();
    case 1: return Support::linear(draw.decades(1e4, 1e7));
    default: {
      std::vector<Support::Point> points;
      double deflection = 0;
      double force = 0;
      const int count = 2 + draw.choice(4);
      for (int i = 0; i < count; ++i) {
        const double advance = draw.decades(1e-3, 2e-2);
        deflection += advance;
        force += advance * draw.decades(1e4, 1e6);
        points.push_back({deflection, force});
      }
      return Support::through(points);
    }
  }
}

/// Laws 1 to 3 about foams of some 100 kPa; laws 4 and 5 are the Ensolite cards.
PadLaw plausible_law(Draw& draw) {
  const auto near = [&draw](double value) { return value * draw.uniform(0.5, 1.5); };
  const auto exponent = [&near](double value) { return std::min(near(value), 1.0); };
  switch (draw.choice(5)) {
    case 0: return Elastic{near(3e5)};
    case 1: {
      const double lasting = near(1.4e5);
      return LinearViscoelastic{lasting, lasting * draw.uniform(1.5, 4.5), near(5e-3)};
    }
    case 2: {
      const double stress = near(2e5);
      const double strain = draw.uniform(0.3, 0.7);
      return RigidFoam{stress, strain, stress * draw.uniform(1, 3), strain + draw.uniform(0.05, 0.25)};
    }
    case 3:
      return NineParameter{near(7.96 * psi), exponent(0.675), near(1.09),    near(8.81e-3),
                           near(5.45 * psi), exponent(0.166), near(9.76e-6), near(0.0987)};
    default: {
      const double m = exponent(0.675);
      return TwentyOneParameter{near(7.96 * psi),
                                m,
                                near(1.09),
                                exponent(0.13),
                                near(0.156),
                                near(3.08),
                                near(4.153 * psi),
                                exponent(0.19),
                                near(3.17),
                                near(0.58),
                                std::max(near(2.57), 1.01 * m),
                                near(0.296),
                                std::max(near(2.23), 1.01 * m),
                                near(1.64e-3),
                                near(9.76e-6),
                                near(0.0987)};
    }
  }
}

// --- Foams by curves
// -----------------------------------------------------------------------------------------

/// A curve that rises steeply, less so on a plateau, and steeply again.
TableCurve random_table(Draw& draw, double stress) {
  TableCurve table;
  const int count = 3 + draw.choice(18);
  const double last = draw.uniform(0.4, 0.9);
  const double knee = draw.uniform(0.02, 0.15);
  const double rise = draw.uniform(0.1, 2);
  const double sharp = draw.uniform(1.5, 4);
  for (int i = 1; i <= count; ++i) {
    const double share = double(i) / count;
    const double e = last * share * (0.4 + 0.6 * share);
    table.strain.push_back(e);
    table.stress.push_back(stress *
                           (1 - std::exp(-e / knee) + rise * e + 0.05 * std::pow(e / (1 - e), sharp)));
  }
  return table;
}

BaseCurve random_base(Draw& draw) {
  const double stress = draw.decades(1e4, 1e6);
  switch (draw.choice(5)) {
    case 0: return random_table(draw, stress);
    case 1:
      // The plateau gives way slowly enough for the curve to rise.
      return AvalleCurve{.plateau_stress = stress,
                         .modulus = stress * draw.uniform(5, 30),
                         .plateau_exponent = draw.uniform(0, 0.8),
                         .densification_stress = stress * draw.uniform(0.3, 2),
                         .densification_exponent = draw.uniform(0.8, 3),
                         .highest_strain = draw.uniform(0.5, 0.85)};
    case 2:
      return PowerCurve{.modulus = stress,
                        .contact_exponent = draw.uniform(0.3, 1.5),
                        .compaction_exponent = draw.uniform(0, 3),
                        .highest_strain = draw.uniform(0.3, 0.9)};
    case 3: {
      const double density = draw.uniform(0, 0.15);
      return GibsonAshbyCurve{.modulus = stress * draw.uniform(5, 40),
                              .plateau_stress = stress,
                              .gas_pressure = draw.uniform(0.05, 1) * stress,
                              .relative_density = density,
                              .highest_strain = draw.uniform(0.5, 0.95 * (1 - density))};
    }
    default:
      return HyperfoamCurve{.first_modulus = stress,
                            .first_exponent = draw.uniform(-2, 10),
                            .second_modulus = draw.choice(2) == 0 ? 0 : stress * draw.uniform(0.1, 1),
                            .second_exponent = draw.uniform(-4, 4),
                            .highest_strain = draw.uniform(0.4, 0.8)};
  }
}

double last_strain_of_form(const BaseCurve& base) {
  return std::visit(
      [](const auto& form) {
        if constexpr (requires { form.highest_strain; })
          return form.highest_strain;
        else
          return form.strain.back();
      },
      base);
}

/// Points of a base curve, times a factor that may change with the strain.
template <class Factor>
TableCurve points_of(const BaseCurve& base, double last, int count, Factor&& factor) {
  TableCurve points;
  if (const auto* table = std::get_if<TableCurve>(&base)) {
    points = *table;
    for (std::size_t i = 0; i < points.strain.size(); ++i) points.stress[i] *= factor(points.strain[i]);
    return points;
  }
  for (int i = 1; i <= count; ++i) {
    const double e = last * (double(i) / count) * (double(i) / count);
    points.strain.push_back(e);
    points.stress.push_back(factor(e) * std::visit(
                                            [&](const auto& form) {
                                              if constexpr (requires { form.stress(e); })
                                                return form.stress(e);
                                              else
                                                return 0.0;
                                            },
                                            base));
  }
  return points;
}

RateEffect random_rate_effect(Draw& draw, const BaseCurve& base, double slowest) {
  const double last = last_strain_of_form(base);
  switch (draw.choice(5)) {
    case 0: return NoRateEffect{};
    case 1:
      return PowerRateEffect{draw.uniform(0, 0.3), draw.uniform(-0.3, 0.3), slowest * draw.decades(10, 1e6)};
    case 2: {
      FactorRateEffect effect;
      double rate = slowest, factor = 1;
      for (int i = draw.choice(5); i >= 0; --i) {
        rate *= draw.decades(2, 100);
        factor *= draw.uniform(1, 2);
        effect.rate.push_back(rate);
        effect.factor.push_back(factor);
      }
      return effect;
    }
    default: {
      CurvesRateEffect effect;
      effect.linear = draw.choice(2) == 0;
      double rate = slowest, factor = 1.02, slope = 0;
      for (int i = draw.choice(3); i >= 0; --i) {
        rate *= draw.decades(3, 300);
        factor *= draw.uniform(1, 1.6);
        slope += draw.uniform(0, 0.4);
        const double top = last * (draw.choice(2) == 0 ? 1 : draw.uniform(0.6, 1));
        effect.curves.push_back(
            {rate, points_of(base, top, 30, [&](double e) { return factor + slope * e; })});
      }
      return effect;
    }
  }
}

FoamCurves random_curves(Draw& draw) {
  FoamCurves curves;
  curves.base = random_base(draw);
  curves.slowest_rate = draw.decades(1e-4, 1);
  curves.rate_effect = random_rate_effect(draw, curves.base, curves.slowest_rate);
  return curves;
}

Foam foam_of(Draw& draw) {
  Foam foam;
  foam.curves = random_curves(draw);
  foam.friction = draw.choice(2) == 0 ? 0 : draw.uniform(0, 0.45);
  foam.unloading_factor = draw.choice(3) == 0 ? 1 : draw.uniform(0, 1);
  foam.unloading_shape = draw.choice(3) == 0 ? 1 : draw.decades(0.1, 20);
  foam.recoil = draw.choice(3) == 0 ? 1 : draw.uniform(0, 1);
  foam.lag_strain = draw.decades(1e-4, 0.05);
  foam.continuation_exponent = draw.choice(3) == 0 ? 1 : draw.uniform(1, 6);
  foam.steepest_continuation = 6;
  if (draw.choice(3) == 0) {
    const double last = last_strain_of_form(foam.curves.base);
    const double least = draw.uniform(0.1, 0.9), power = draw.uniform(0.3, 4);
    foam.unloading_curve = points_of(foam.curves.base, last, 30, [&](double e) {
      return least + (1 - least) * std::pow(std::min(e / last, 1.0), power);
    });
  }
  return foam;
}

CrushableFoam crushable_of(Draw& draw) {
  CrushableFoam foam;
  do foam.curves = random_curves(draw);
  // A slope at strain zero without bound has no modulus above it.
  while (std::holds_alternative<PowerCurve>(foam.curves.base) &&
         std::get<PowerCurve>(foam.curves.base).contact_exponent < 1);
  foam.lag_strain = draw.decades(1e-4, 0.05);
  foam.continuation_exponent = draw.choice(3) == 0 ? 1 : draw.uniform(1, 6);
  foam.steepest_continuation = 6;
  const double last = last_strain_of_form(foam.curves.base);
  // At least the steepest slope: of a table no more than three times that of the lines between its points.
  const bool table = std::holds_alternative<TableCurve>(foam.curves.base);
  const TableCurve points = points_of(foam.curves.base, last, 400, [](double) { return 1.0; });
  double steepest = 0, strain = 0, stress = 0;
  for (std::size_t i = 0; i < points.strain.size(); ++i) {
    steepest = std::max(steepest, (points.stress[i] - stress) / (points.strain[i] - strain));
    strain = points.strain[i], stress = points.stress[i];
  }
  foam.unloading_modulus = steepest * draw.uniform(table ? 3 : 1.1, 5);
  return foam;
}

}  // namespace

Foam random_foam(std::uint64_t seed) {
  Draw draw(seed);
  return foam_of(draw);
}

CrushableFoam random_crushable_foam(std::uint64_t seed) {
  Draw draw(seed);
  return crushable_of(draw);
}

ImpactCase foam_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "foam case " + std::to_string(seed);
  impact.impactor.mass = draw.decades(0.5, 20);
  impact.impactor.speed = draw.decades(1, 10);
  if (draw.choice(3) == 0)
    impact.impactor.nose = FlatDisc{draw.decades(0.02, 0.15)};
  else
    impact.impactor.nose = Sphere{draw.decades(0.02, 0.25)};
  impact.pad.thickness = draw.decades(0.01, 0.1);
  impact.pad.material.name = foam_of_the_case;
  if (draw.choice(3) == 0)
    impact.pad.material.law = crushable_of(draw);
  else
    impact.pad.material.law = foam_of(draw);
  impact.support = ordinary_support(draw);
  return impact;
}

PadLaw random_layer_law(Draw& draw) {
  for (;;) {
    PadLaw law;
    switch (draw.choice(6)) {
      case 0: law = crushable_of(draw); break;
      case 1:
        if (draw.choice(2) == 0)
          law = Elastic{draw.decades(1e5, 1e7)};
        else
          law = LinearViscoelastic{draw.decades(1e5, 1e6), draw.decades(1e6, 1e7), draw.decades(1e-4, 0.1)};
        break;
      default: law = foam_of(draw);
    }
    if (violations(law).empty() && violations_as_layer(law).empty()) return law;
  }
}

ImpactCase layered_case(std::uint64_t seed) {
  ImpactCase impact = foam_case(seed);
  impact.title = "layered case " + std::to_string(seed);
  // Numbers of its own: the rest of the case is that of the foam case.
  Draw draw(seed + 0x6c617965);
  const double thickness = impact.pad.thickness;
  std::vector<PadLayer> layers(static_cast<std::size_t>(2 + draw.choice(3)));
  double sum = 0;
  for (PadLayer& layer : layers) {
    layer.material.name = foam_of_the_case;
    layer.material.law = random_layer_law(draw);
    sum += layer.thickness = draw.uniform(0.1, 0.9);
  }
  for (PadLayer& layer : layers) layer.thickness *= thickness / sum;
  set_layers(impact.pad, std::move(layers));
  return impact;
}

ImpactCase plausible_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "plausible case " + std::to_string(seed);
  impact.impactor = {draw.decades(0.5, 20), Sphere{draw.decades(0.0127, 0.254)}, draw.decades(1, 15)};
  impact.pad.thickness = draw.decades(0.005, 0.1);
  impact.pad.material.name = foam_of_the_case;
  impact.pad.material.law = plausible_law(draw);
  impact.support = ordinary_support(draw);
  return impact;
}

ImpactCase ordinary_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "ordinary case " + std::to_string(seed);
  impact.impactor = {draw.decades(0.5, 50), Sphere{draw.decades(0.03, 0.5)}, draw.decades(0.5, 15)};
  impact.pad.thickness = draw.decades(0.01, 0.1);
  impact.pad.material.name = foam_of_the_case;
  impact.pad.material.law = ordinary_law(draw, impact.impactor.speed / impact.pad.thickness);
  impact.support = ordinary_support(draw);
  return impact;
}

/// A cylinder on its side, or a profile of any increasing shape, also with a flat tip and flat stretches.
Nose shaped_nose(Draw& draw, double radius) {
  if (draw.choice(2) == 0) return Cylinder{radius, radius * draw.decades(0.3, 30)};
  Profile profile{.scale = draw.decades(0.5, 2),
                  .of = draw.choice(2) == 0 ? Profile::Of::radius : Profile::Of::area};
  double depth = 0, size = draw.choice(2) == 0 ? 0 : radius * draw.uniform(0, 0.5);
  const int count = 2 + draw.choice(15);
  for (int i = 0; i < count; ++i) {
    profile.points.push_back({depth, profile.of == Profile::Of::radius ? size : 3 * size * size});
    depth += radius * draw.decades(1e-3, 1);
    if (i == 0 || draw.choice(4) != 0) size += radius * draw.decades(1e-2, 0.5);
  }
  return profile;
}

ImpactCase nose_case(std::uint64_t seed) {
  ImpactCase impact = ordinary_case(seed);
  impact.title = "nose case " + std::to_string(seed);
  // Numbers of its own: the rest of the case is that of the ordinary one.
  Draw draw(seed + 0x6e6f7365);
  const double radius = draw.decades(0.02, 0.3);
  switch (draw.choice(5)) {
    case 0: impact.impactor.nose = Cone{radius, draw.uniform(0.5, 1.5)}; break;
    case 1:
      impact.impactor.nose = Cone{radius, draw.uniform(0.5, 1.5), radius * draw.uniform(0.01, 0.95)};
      break;
    case 2:
      impact.impactor.nose = Ellipsoid{radius, radius * draw.decades(0.3, 3), radius * draw.decades(0.3, 3)};
      break;
    case 3: impact.impactor.nose = Rod{radius, radius * draw.decades(1, 10)}; break;
    default: impact.impactor.nose = Platen{radius, radius * draw.uniform(0.3, 1)};
  }
  if (draw.choice(3) == 0) impact.impactor.nose = shaped_nose(draw, radius);
  if (draw.choice(3) == 0)
    impact.pad.area = sections_of(impact.impactor.nose).area_beyond() * draw.decades(0.05, 2);
  return impact;
}

ImpactCase moving_case(std::uint64_t seed) {
  // Numbers of its own: the rest of the case is that of the other kind.
  Draw draw(seed + 0x6d6f7665);
  ImpactCase impact = draw.choice(2) == 0 ? foam_case(seed) : ordinary_case(seed);
  impact.title = "moving case " + std::to_string(seed);
  Impactor& impactor = impact.impactor;
  if (draw.choice(3) == 0) impactor.gravity = 9.81;
  if (impact.support.is_rigid()) impact.support = Support::linear(draw.decades(1e4, 1e7));
  Backing& backing = impact.backing;
  double steepest = 0;
  Support::Point from;
  for (const Support::Point& to : impact.support.points()) {
    steepest = std::max(steepest, (to.force - from.force) / (to.deflection - from.deflection));
    from = to;
  }
  if (draw.choice(2) == 0) backing.unloading_stiffness = steepest * draw.decades(1, 10);
  if (draw.choice(2) == 0) backing.mass = impactor.mass * draw.decades(0.03, 10);
  if (draw.choice(2) == 0) backing.damping = 2 * std::sqrt(steepest * impactor.mass) * draw.decades(0.01, 2);
  const bool is_free = draw.choice(3) == 0;
  if (is_free && impactor.gravity == 0) backing.body_mass = impactor.mass * draw.decades(0.3, 30);
  if (draw.choice(4) == 0)
    backing.preload = impact.support.points().front().force * draw.decades(0.01, 1);
  else if (backing.mass > 0 && draw.choice(4) == 0)
    backing.gap = impact.pad.thickness * draw.decades(0.01, 0.3);
  return impact;
}

ImpactCase support_case(std::uint64_t seed) {
  // Numbers of its own: the rest of the case is that of the other kind.
  Draw draw(seed + 0x73757070);
  const int kind = draw.choice(8);
  ImpactCase impact = kind < 3 ? foam_case(seed) : kind < 6 ? ordinary_case(seed) : nose_case(seed);
  impact.title = "support case " + std::to_string(seed);
  Impactor& impactor = impact.impactor;
  if (kind == 0) {
    const double modulus = draw.decades(3e4, 1e6);
    impact.pad.material.law = ViscoelasticFoam{.first_modulus = modulus,
                                               .first_exponent = draw.uniform(2, 12),
                                               .first_share = draw.decades(0.1, 10),
                                               .first_time = draw.decades(1e-4, 1)};
  }
  if (draw.choice(4) == 0 && kind < 6) impactor.nose = FlatDisc{draw.decades(0.03, 0.2)};
  Backing& backing = impact.backing;
  if (impact.support.is_rigid() && draw.choice(2) == 0) {
    backing.body_mass = impactor.mass * draw.decades(0.1, 300);
  } else {
    if (impact.support.is_rigid()) impact.support = Support::linear(draw.decades(1e4, 1e7));
    double steepest = 0;
    Support::Point from;
    for (const Support::Point& to : impact.support.points()) {
      steepest = std::max(steepest, (to.force - from.force) / (to.deflection - from.deflection));
      from = to;
    }
    const double critical = 2 * std::sqrt(steepest * impactor.mass);
    if (draw.choice(2) == 0) backing.unloading_stiffness = steepest * draw.decades(1, 10);
    if (draw.choice(2) == 0) backing.mass = impactor.mass * draw.decades(0.03, 10);
    if (draw.choice(3) == 0)
      backing.damping = critical * draw.decades(0.01, 2);
    else if (draw.choice(4) == 0)
      backing.loss_factor = draw.decades(0.01, 1);
    if (draw.choice(3) == 0) backing.body_mass = impactor.mass * draw.decades(0.3, 30);
    const double usual = impactor.speed * std::sqrt(steepest * impactor.mass);
    if (draw.choice(3) == 0)
      backing.preload = usual * draw.decades(0.01, 2);
    else if (backing.mass > 0 && draw.choice(2) == 0)
      backing.gap = impact.pad.thickness * draw.decades(0.01, 1);
    if (backing.unloading_stiffness > 0 && draw.choice(4) == 0)
      backing.earlier_force = usual * draw.decades(0.01, 2);
  }
  if (backing.body_mass == 0 && draw.choice(3) == 0) impactor.gravity = 9.81;
  if (draw.choice(4) == 0) {
    const bool recovers = blow_memory(impact.pad.material.law) != BlowMemory::crater;
    impact.blows = Blows{2 + draw.choice(3), recovers ? draw.uniform(0, 1) : 0};
  } else if (draw.choice(4) == 0 && !std::holds_alternative<Cylinder>(impactor.nose)) {
    impact.pad.sheet = draw.decades(0.1, 20);
  }
  return impact;
}

ImpactCase random_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "random case " + std::to_string(seed);
  impact.impactor = {draw.decades(0.01, 100), Sphere{draw.decades(1e-3, 1)}, draw.decades(0.1, 50)};
  impact.pad.thickness = draw.decades(1e-3, 0.5);
  impact.pad.material.name = foam_of_the_case;
  impact.pad.material.law = random_law(draw, impact.impactor.speed / impact.pad.thickness);
  impact.support = random_support(draw);
  return impact;
}

}  // namespace dashpad::test
