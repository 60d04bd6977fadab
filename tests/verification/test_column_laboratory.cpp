/// The material laboratory: every law under every history, against closed forms and against CVODE.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/laboratory/column_test.hpp"
#include "oracle/driven_column.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using laboratory::ColumnTest;
using laboratory::drive;

double peak(const ColumnTest& test) { return *std::max_element(test.stress.begin(), test.stress.end()); }

/// Of every row, as a fraction of the peak, from what `exact(row)` gives.
template <class Exact>
double largest_difference(const ColumnTest& test, Exact&& exact) {
  double most = 0;
  for (std::size_t i = 0; i < test.size(); ++i) most = std::max(most, std::abs(test.stress[i] - exact(i)));
  return most / peak(test);
}

struct Named {
  std::string name;
  laboratory::StrainHistory history;
};

std::vector<Named> histories() {
  std::vector<Named> all;
  for (const double rate : {0.1, 1.0, 100.0}) {
    const std::string at = fmt::format(" at {}/s", rate);
    all.push_back({"ramp and hold" + at, laboratory::ramp_and_hold_test(rate, 0.7, 2 / rate)});
    all.push_back({"low cycles" + at, laboratory::cyclic_test(rate, 0.8, 0.1, 2)});
    all.push_back({"high cycles" + at, laboratory::cyclic_test(rate, 0.8, 0.7, 3)});
    for (const double strain : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
      all.push_back(
          {fmt::format("constant{} to {}", at, strain), laboratory::constant_rate_test(rate, strain)});
      all.push_back({fmt::format("parabolic{} to {}", at, strain), laboratory::parabolic_test(rate, strain)});
    }
  }
  all.push_back({"measured", laboratory::measured_test({1, 1.01, 1.015, 1.03, 1.035, 1.05, 1.06, 1.08},
                                                       {0, 0.3, 0.35, 0.35, 0.7, 0.65, 0.9, 0.2})});
  laboratory::StrainHistory waves{{{0.02, 0, 60, -3000}, {0.02, 0.6, -10, 1000}, {0.01, 0.6, 10, -4000}}};
  all.push_back({"waves", waves});
  return all;
}

template <class Formulas>
void expect_as_cvode() {
  const auto law = sample_law<typename Formulas::Law>();
  double worst = 0;
  for (const Named& named : histories()) {
    const ColumnTest test = drive(law, named.history, 40);
    std::vector<double> times(test.time.begin() + 1, test.time.end());
    const auto expected =
        oracle::DrivenColumn<Formulas>(law).stresses(named.history.pieces, times, peak(test));
    const double difference =
        largest_difference(test, [&](std::size_t i) { return i == 0 ? 0 : expected[i - 1]; });
    EXPECT_LT(difference, 1e-6) << named.name;
    EXPECT_LT(test.stress_error, 1e-9) << named.name;
    EXPECT_GT(test.stress_error, 0) << named.name;
    worst = std::max(worst, difference);
  }
  fmt::print("{}: largest difference from CVODE {:.1e} of the peak\n", Formulas::Law::name, worst);
}

TEST(ColumnLaboratory, AgreesWithCvodeLaw2) { expect_as_cvode<oracle::LinearFormulas>(); }
TEST(ColumnLaboratory, AgreesWithCvodeLaw4) { expect_as_cvode<oracle::NineFormulas>(); }
TEST(ColumnLaboratory, AgreesWithCvodeLaw5) { expect_as_cvode<oracle::TwentyOneFormulas>(); }

TEST(ColumnLaboratory, ElasticFollowsTheStrain) {
  for (const Named& named : histories()) {
    const ColumnTest test = drive(sample_law<Elastic>(), named.history);
    EXPECT_LT(largest_difference(test, [&](std::size_t i) { return 3e5 * test.strain[i]; }), 1e-15)
        << named.name;
    const double end = test.strain.back();
    EXPECT_NEAR(test.work.back(), 1.5e5 * end * end, 1e-9 * peak(test)) << named.name;
  }
}

TEST(ColumnLaboratory, RigidFoamCrushesOnceOnly) {
  const auto law = sample_law<RigidFoam>();
  const laboratory::StrainHistory history = laboratory::cyclic_test(10, 0.7, 0.1, 1);
  laboratory::StrainHistory further = history;
  further.pieces.push_back({0.065, 0.1, 10, 0});
  further.pieces.push_back({0.01, 0.75, 0, 0});
  const ColumnTest test = drive(law, further, 100);
  for (std::size_t i = 0; i < test.size(); ++i) {
    const double before_turn = test.time[i] - 0.07, after_recrush = test.time[i] - 0.19;
    if (std::abs(before_turn) < 1e-12 || std::abs(after_recrush) < 1e-12 || i < 2) continue;
    const bool crushes = before_turn < 0 || after_recrush > 0;
    EXPECT_NEAR(test.stress[i], crushes ? law.curve().at(test.strain[i]) : 0, 1e-6) << test.time[i];
  }
  EXPECT_EQ(test.stress[0], 0);
  EXPECT_EQ(test.time[1], 0);
  EXPECT_EQ(test.stress[1], 2e5);
  ASSERT_EQ(test.events.size(), 4u);
  EXPECT_EQ(test.events[0].kind, laboratory::ColumnEvent::Kind::turned);
  EXPECT_NEAR(test.events[0].stress_before, 3e5, 1e-6);
  EXPECT_EQ(test.events[0].stress_after, 0);
  EXPECT_EQ(test.events[1].kind, laboratory::ColumnEvent::Kind::contact_lost);
  EXPECT_EQ(test.events[2].kind, laboratory::ColumnEvent::Kind::reloaded);
  EXPECT_EQ(test.events[3].kind, laboratory::ColumnEvent::Kind::contact_taken_up);
  EXPECT_NEAR(test.events[3].strain, 0.7, 1e-12);
  EXPECT_NEAR(test.events[3].stress_after, 3e5, 1e-6);
  // 2e5 up to 0.6, then a slope of 1e6 up to 0.75.
  EXPECT_NEAR(test.work.back(), 2e5 * 0.75 + 0.5e6 * 0.15 * 0.15, 1e-3);
}

TEST(ColumnLaboratory, LinearSolidRelaxesInClosedForm) {
  const auto law = sample_law<LinearViscoelastic>();
  const ColumnTest test = drive(law, laboratory::ramp_and_hold_test(50, 0.6, 0.03));
  const double loaded = 0.6 / 50, viscous = 280e3 * 5e-3 * 50;
  const auto exact = [&](std::size_t i) {
    const double t = test.time[i], up = std::min(t, loaded);
    return 140e3 * test.strain[i] - viscous * std::expm1(-up / 5e-3) * std::exp(-(t - up) / 5e-3);
  };
  EXPECT_LT(largest_difference(test, exact), 1e-13);
}

/// Up and down at one rate the stress of law 4 is its envelope, and the residual strain is e* D.
TEST(ColumnLaboratory, NineParameterLawIsItsEnvelopeAtOneRate) {
  const auto law = sample_law<NineParameter>();
  for (const double rate : {1.0, 100.0})
    for (const double strain : {0.1, 0.6, 0.95}) {
      const ColumnTest test = drive(law, laboratory::constant_rate_test(rate, strain));
      const double D = std::pow(9.76e-6 * rate, 0.0987);
      const double B = law.asymptotic_modulus + law.rate_modulus * std::pow(rate, 0.166);
      const auto exact = [&](std::size_t i) {
        const double e = test.strain[i];
        const double AB = std::pow(e, 0.675) / std::pow(1 - e, 1.09) * B;
        if (test.rate[i] > 0) return AB;
        return e > strain * D ? AB * (e - strain * D) / (e * (1 - D)) : 0;
      };
      EXPECT_LT(largest_difference(test, exact), 1e-12);
      ASSERT_EQ(test.events.size(), 2u);
      EXPECT_EQ(test.events[1].kind, laboratory::ColumnEvent::Kind::contact_lost);
      expect_relative(test.events[1].strain, strain * D, 1e-12, "residual strain");
    }
}

/// Many relaxation times in a parabola: the stress is the envelope, but for a part of the order of tau.
TEST(ColumnLaboratory, FollowsTheEnvelopeWhereRelaxationIsFast) {
  for (const double tau : {1e-5, 1e-7, 1e-9, 1e-11}) {
    NineParameter law = sample_law<NineParameter>();
    law.relaxation_time = tau;
    const ColumnTest test = drive(law, laboratory::parabolic_test(1, 0.9), 50);
    for (std::size_t i = 1; i < 25; ++i) {
      const double e = test.strain[i];
      const double B = law.asymptotic_modulus + law.rate_modulus * std::pow(test.rate[i], 0.166);
      expect_relative(test.stress[i], std::pow(e, 0.675) / std::pow(1 - e, 1.09) * B, 10 * tau + 1e-11,
                      fmt::format("tau {}, strain {}", tau, e));
    }
  }
}

TEST(ColumnLaboratory, NineParameterLawRelaxesInClosedForm) {
  const auto law = sample_law<NineParameter>();
  const ColumnTest test = drive(law, laboratory::ramp_and_hold_test(10, 0.6, 0.05));
  const double A = std::pow(0.6, 0.675) / std::pow(0.4, 1.09);
  for (std::size_t i = 0; i < test.size(); ++i)
    if (test.time[i] >= 0.06) {
      const double left = law.rate_modulus * std::pow(10, 0.166) * std::exp((0.06 - test.time[i]) / 8.81e-3);
      expect_relative(test.stress[i], A * (law.asymptotic_modulus + left), 1e-12, "relaxing stress");
    }
}

template <class Law>
class Laboratory : public testing::Test {};
TYPED_TEST_SUITE(Laboratory, LawsOfTheReport);

TYPED_TEST(Laboratory, GivesTheSameStressAtAnyPlaces) {
  const auto law = sample_law<TypeParam>();
  for (const laboratory::StrainHistory& history :
       {laboratory::parabolic_test(30, 0.9), laboratory::cyclic_test(30, 0.9, 0.3, 2)}) {
    const ColumnTest few = drive(law, history, 2);
    const ColumnTest many = drive(law, history, 60);
    ASSERT_EQ(few.events.size(), many.events.size());
    for (std::size_t i = 0; i < few.events.size(); ++i) EXPECT_EQ(few.events[i].time, many.events[i].time);
    for (std::size_t i = 0; i < few.size(); ++i) {
      bool found = false;
      for (std::size_t j = 0; j < many.size() && !found; ++j)
        found = std::abs(many.time[j] - few.time[i]) <= 1e-12 * few.time.back() &&
                std::abs(many.stress[j] - few.stress[i]) <= 1e-10 * peak(many);
      EXPECT_TRUE(found) << "t = " << few.time[i];
    }
    EXPECT_NEAR(few.work.back(), many.work.back(), 1e-8 * peak(many));
  }
}

TYPED_TEST(Laboratory, HoldsAColumnAtStrainZero) {
  laboratory::StrainHistory history{{{0.1, 0, 0, 0}, {0.01, 0, 50, 0}, {0.01, 0.5, -50, 0}, {0.1, 0, 0, 0}}};
  const ColumnTest test = drive(sample_law<TypeParam>(), history, 20);
  EXPECT_EQ(test.stress.front(), 0);
  EXPECT_EQ(test.stress[20], 0);
  EXPECT_EQ(test.stress.back(), 0);
  EXPECT_GT(peak(test), 1e4);
}

// --- Creep ---

TEST(Creep, OfTheLinearSolidIsAClosedForm) {
  const auto law = sample_law<LinearViscoelastic>();
  const laboratory::CreepTest asked{5e4, 100, 0.1};
  const auto test = laboratory::creep(law, asked);
  ASSERT_TRUE(test);
  std::size_t loaded = 200;
  EXPECT_NEAR(test->stress[loaded], 5e4, 1e-8 * 5e4);
  const double lasting = 5e4 / 140e3, first = test->strain[loaded];
  for (std::size_t i = loaded; i < test->size(); ++i) {
    const double t = test->time[i] - test->time[loaded];
    const double exact = lasting - (lasting - first) * std::exp(-t * 140e3 / (420e3 * 5e-3));
    EXPECT_NEAR(test->strain[i], exact, 1e-14);
    if (i > loaded) {
      EXPECT_EQ(test->stress[i], 5e4);
    }
  }
  EXPECT_NEAR(test->strain.back(), lasting, 0.01);
}

TEST(Creep, OfElasticPadAndRigidFoamIsAtOnce) {
  const auto elastic = laboratory::creep(sample_law<Elastic>(), {6e4, 10, 1});
  ASSERT_TRUE(elastic);
  EXPECT_NEAR(elastic->strain.back(), 0.2, 1e-14);
  EXPECT_EQ(elastic->strain.back(), elastic->strain[200]);
  const auto plateau = laboratory::creep(sample_law<RigidFoam>(), {1e5, 10, 1});
  ASSERT_TRUE(plateau);
  EXPECT_EQ(plateau->largest_strain, 0);
  const auto crushed = laboratory::creep(sample_law<RigidFoam>(), {3e5, 10, 1});
  ASSERT_TRUE(crushed);
  EXPECT_NEAR(crushed->strain.back(), 0.7, 1e-13);
  EXPECT_FALSE(laboratory::creep(sample_law<Elastic>(), {3e5, 10, 1}));
}

/// The independent formulas, with the rate by bisection, in CVODE.
template <class Formulas>
class CreepOde final : public oracle::OdeSystem {
 public:
  CreepOde(const typename Formulas::Law& law, double stress) : formulas_(law), stress_(stress) {}
  [[nodiscard]] double rate(double time, double strain) const {
    const auto point = oracle::strain_point(strain, 1 - strain, formulas_.m(), formulas_.n());
    const auto balance = [&](double rate) {
      const auto envelope =
          formulas_.envelope(point, formulas_.at_strain(point), formulas_.at_rate(rate), strain);
      return envelope.slope * rate + formulas_.relaxation(time, strain) * (envelope.value - stress_);
    };
    double low = -60, high = 15;
    for (int i = 0; i < 70; ++i) (balance(std::exp((low + high) / 2)) < 0 ? low : high) = (low + high) / 2;
    return std::exp(low);
  }
  bool derivative(double time, const double* state, double* slope) override {
    slope[0] = rate(time, state[0]);
    return state[0] < 1;
  }
  void allowances(const double*, double* allowance) override { allowance[0] = 1e-12; }
  void events(double time, const double*, double* values) override { values[0] = time - target; }
  [[nodiscard]] int event_count() const override { return 1; }
  double target = 0;

 private:
  Formulas formulas_;
  double stress_;
};

template <class Formulas>
void expect_creep_as_cvode(double rate, double strain_below) {
  const auto law = sample_law<typename Formulas::Law>();
  for (const double stress : {2e4, 1e5, 4e5}) {
    const auto test = laboratory::creep(law, {stress, rate, 10}, 30);
    ASSERT_TRUE(test);
    EXPECT_NEAR(test->stress[30], stress, 1e-9 * stress);
    CreepOde<Formulas> ode(law, stress);
    double time = test->time[30], strain = test->strain[30];
    for (std::size_t i = 31; i < test->size(); ++i) {
      ode.target = test->time[i];
      oracle::OdeSession session(ode, oracle::Method::bdf_dense, time, {strain});
      while (session.step() && !session.at_event()) {
      }
      time = session.time(), strain = session.state()[0];
      EXPECT_NEAR(test->strain[i], strain, 1e-8) << stress << " Pa, " << time << " s";
      expect_relative(test->rate[i], ode.rate(time, test->strain[i]), 1e-8, "rate");
    }
    EXPECT_GT(test->strain.back(), test->strain[30] + strain_below);
    EXPECT_LT(test->stress_error, 1e-8);
  }
}

TEST(Creep, AgreesWithCvode) {
  expect_creep_as_cvode<oracle::NineFormulas>(10, 0.01);
  expect_creep_as_cvode<oracle::TwentyOneFormulas>(10, 0.01);
}

TEST(Creep, TendsToTheLastingStress) {
  const auto law = sample_law<NineParameter>();
  const auto test = laboratory::creep(law, {1e5, 10, 1e7}, 20);
  ASSERT_TRUE(test);
  const double e = test->strain.back();
  expect_relative(law.asymptotic_modulus * std::pow(e, 0.675) / std::pow(1 - e, 1.09), 1e5, 0.1, "lasting");
  NineParameter still = law;
  still.rate_modulus = 0;
  const auto settled = laboratory::creep(still, {1e5, 10, 1e7}, 20);
  ASSERT_TRUE(settled);
  const double end = settled->strain.back();
  expect_relative(law.asymptotic_modulus * std::pow(end, 0.675) / std::pow(1 - end, 1.09), 1e5, 1e-11,
                  "lasting");
}

}  // namespace
}  // namespace dashpad::test
