#include "property/random_case.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace dashpad::test {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    // 53 bits of the generator: the same on every platform, unlike the distributions of the standard library.
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double decades(double low, double high) { return std::pow(10, uniform(std::log10(low), std::log10(high))); }
  int choice(int count) { return static_cast<int>(generator_() % static_cast<std::uint64_t>(count)); }

 private:
  std::mt19937_64 generator_;
};

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

}  // namespace

ImpactCase plausible_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "plausible case " + std::to_string(seed);
  impact.impactor = {draw.decades(0.5, 20), Sphere{draw.decades(0.0127, 0.254)}, draw.decades(1, 15)};
  impact.pad.thickness = draw.decades(0.005, 0.1);
  impact.pad.material.name = "in line";
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
  impact.pad.material.name = "in line";
  impact.pad.material.law = ordinary_law(draw, impact.impactor.speed / impact.pad.thickness);
  impact.support = ordinary_support(draw);
  return impact;
}

ImpactCase random_case(std::uint64_t seed) {
  Draw draw(seed);
  ImpactCase impact;
  impact.title = "random case " + std::to_string(seed);
  impact.impactor = {draw.decades(0.01, 100), Sphere{draw.decades(1e-3, 1)}, draw.decades(0.1, 50)};
  impact.pad.thickness = draw.decades(1e-3, 0.5);
  impact.pad.material.name = "in line";
  impact.pad.material.law = random_law(draw, impact.impactor.speed / impact.pad.thickness);
  impact.support = random_support(draw);
  return impact;
}

}  // namespace dashpad::test
