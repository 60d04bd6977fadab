/// An elastic pad on a rigid support against its energy integral.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "oracle/closed_forms.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

struct ElasticPad {
  const char* what;
  Impactor impactor;
  double modulus;
  double thickness;
};

const std::vector<ElasticPad> elastic_pads{
    {"head on a thick pad", {4, Sphere{0.08}, 3}, 6e5, 0.1},
    {"slow and shallow", {4, Sphere{0.08}, 0.01}, 6e5, 0.1},
    {"deeper than its radius", {2, Sphere{0.05}, 3}, 3e5, 0.5},
    {"much deeper than its radius", {1, Sphere{0.002}, 5}, 2e7, 0.4},
    {"nearly flat", {50, Sphere{10}, 1}, 1e5, 0.1},
    {"close to full compression", {4, Sphere{0.08}, 2.8}, 6e5, 0.0221},
    {"a grain", {1e-5, Sphere{1e-3}, 20}, 1e6, 5e-3},
};

class ElasticOnRigid : public testing::TestWithParam<ElasticPad> {};

TEST_P(ElasticOnRigid, FollowsTheEnergyIntegral) {
  const ElasticPad& g = GetParam();
  const oracle::ElasticBounce bounce(g.impactor.mass, std::get<Sphere>(g.impactor.nose).radius,
                                     g.impactor.speed, g.modulus, g.thickness);
  ASSERT_LT(bounce.peak_penetration(), g.thickness);
  ImpactCase impact = impact_on(Elastic{g.modulus});
  impact.impactor = g.impactor;
  impact.pad.thickness = g.thickness;
  const Summary s = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(s.status, Status::released);
  constexpr double limit = 2e-6;
  fmt::print("{}: Y/L {:.3f}, Y/R {:.3f}\n", g.what, s.peak_strain,
             s.peak_penetration / std::get<Sphere>(g.impactor.nose).radius);
  expect_relative(s.peak_force.value(), bounce.peak_force(), limit, "peak force");
  expect_relative(s.peak_penetration, bounce.peak_penetration(), limit, "peak penetration");
  expect_relative(s.peak_motion, bounce.peak_penetration(), limit, "peak motion");
  expect_relative(s.release.value().time, bounce.contact_time(), limit, "contact time");
  // A flat peak: the moment is only as good as its estimate, which is relative to the release time.
  EXPECT_LE(std::abs(s.time_of_peak_force.value() - bounce.contact_time() / 2) / bounce.contact_time(),
            limit + s.errors.time_of_peak_force);
  expect_relative(s.rebound_speed.value(), g.impactor.speed, 1e-9, "rebound");
}

INSTANTIATE_TEST_SUITE_P(Geometries, ElasticOnRigid, testing::ValuesIn(elastic_pads),
                         [](const auto& parameter) {
                           std::string name = parameter.param.what;
                           for (char& c : name)
                             if (c == ' ') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace dashpad::test
