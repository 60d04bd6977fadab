/// The field of columns under a sphere that moves as told, against quadrature of the columns' stress.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>

#include "model/contact/column_field.hpp"
#include "model/contact/nine_parameter_contact.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double thickness = 0.03;
constexpr double speed = 2;  // of the penetration, m/s

/// Drives a field to a depth at constant speed, in even steps; returns the force and the time.
template <class Law>
double drive(ColumnField<Law>& field, double depth, double resolution) {
  field.start(resolution, depth);
  double at = 0;
  double force = 0;
  while (at < depth) {
    double step = std::max(0.2 * resolution * at, 1e-4 * resolution * thickness);
    step = std::min({step, resolution * (thickness - at), depth - at});
    const PadTrial trial = field.trial(step, at / speed, step / speed);
    field.accept(trial);
    force = trial.force;
    at = depth - at - step < 1e-14 ? depth : at + step;
  }
  return force;
}

/// Stress of a column after loading from rest at the constant rate of the test.
double stress(const NineParameter& law, double strain) {
  return envelope_at(law, strain, speed / thickness, strain);
}
double stress(const LinearViscoelastic& law, double strain) {
  const double time = strain * thickness / speed;
  return law.asymptotic_modulus * strain - (law.initial_modulus - law.asymptotic_modulus) *
                                               law.relaxation_time * speed / thickness *
                                               std::expm1(-time / law.relaxation_time);
}

/// 2 pi times the integral of `value(strain)` (R - s) over the contact.
template <class Value>
double contact_integral(double depth, double radius, const Value& value) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const double edge = std::min(depth, radius);
  const auto f = [&](double s, double to_end) {
    // Near the edge, which is where to_end is positive, from there: without cancellation.
    const double above = to_end > 0 ? to_end + (depth - edge) : depth - s;
    return above > 0 ? value(above / thickness) * (radius - s) : 0;
  };
  return 2 * std::numbers::pi * quadrature.integrate(f, 0.0, edge);
}

template <class Law>
void expect_force(const Law& law, double radius) {
  for (const double share : {0.1, 0.6, 0.95}) {
    const double depth = share * thickness;
    const double expected = contact_integral(depth, radius, [&](double e) { return stress(law, e); });
    double error[2];
    for (const int fine : {0, 1}) {
      ColumnField<Law> field(law, thickness, Sphere{radius}.sections());
      error[fine] = relative_error(drive(field, depth, fine == 1 ? 0.02 : 0.08), expected);
    }
    fmt::print("{} R {} Y/L {}: {:.1e} {:.1e}\n", Law::name, radius, share, error[0], error[1]);
    EXPECT_LT(error[0], 2e-3);
    EXPECT_LT(error[1], std::max(error[0] / 8, 1e-7)) << "not of second order at Y/L = " << share;
  }
}

TEST(column_field, integrates_the_stress_of_a_constant_rate) {
  expect_force(sample_law<LinearViscoelastic>(), 0.08);
  expect_force(sample_law<NineParameter>(), 0.08);
}

TEST(column_field, integrates_it_beyond_the_radius_too) {
  expect_force(sample_law<LinearViscoelastic>(), 0.01);
  expect_force(sample_law<NineParameter>(), 0.01);
}

/// The rate at which the force falls if the penetration is held, against holding it for a moment. What a
/// sudden stop does to the envelope is no matter of time and is left out by taking two moments.
template <class Law>
void expect_held_rate(const Law& law, double radius) {
  const double depth = 0.7 * thickness;
  ColumnField<Law> field(law, thickness, Sphere{radius}.sections());
  drive(field, depth, 0.02);
  const double time = depth / speed;
  constexpr double moment = 1e-7;  // s
  field.accept(field.trial(0, time, moment));
  const PadTrial first = field.trial(0, time + moment, moment);
  const double rate = field.force_rate_when_held(first);
  field.accept(first);
  const PadTrial second = field.trial(0, time + 2 * moment, moment);
  EXPECT_LT(rate, 0);
  expect_relative(rate, (second.force - first.force) / moment, 2e-3,
                  fmt::format("{}, R {}", Law::name, radius));
}

TEST(column_field, knows_how_fast_its_force_falls_when_held) {
  for (const double radius : {0.08, 0.01}) {
    expect_held_rate(sample_law<LinearViscoelastic>(), radius);
    expect_held_rate(sample_law<NineParameter>(), radius);
    expect_held_rate(sample_law<TwentyOneParameter>(), radius);
  }
}

TEST(column_field, tries_without_changing_its_state) {
  const auto law = sample_law<TwentyOneParameter>();
  ColumnField<TwentyOneParameter> field(law, thickness, Sphere{0.08}.sections());
  drive(field, 0.4 * thickness, 0.05);
  const double time = 0.4 * thickness / speed;
  const PadTrial forth = field.trial(1e-3, time, 5e-4);
  const PadTrial back = field.trial(-1e-3, time, 5e-4);
  EXPECT_LT(back.force, forth.force);
  EXPECT_EQ(field.trial(1e-3, time, 5e-4).force, forth.force);
  EXPECT_EQ(field.trial(-1e-3, time, 5e-4).force, back.force);
}

/// Loads a contact in even steps, then tries steps forth and back and accepts the one forth, though it was
/// not tried last; returns the force of a further step.
template <class Contact>
double force_after_probes(Contact& contact, bool probe) {
  constexpr double step = 2e-4;
  contact.start(0.05, thickness);
  double time = 0;
  for (; time < 0.3 * thickness / speed; time += step)
    contact.accept(contact.trial(speed * step, time, step));
  const PadTrial forth = contact.trial(speed * step, time, step);
  const double held = contact.force_rate_when_held(forth);
  if (probe) {
    const PadTrial back = contact.trial(-speed * step, time, step);
    EXPECT_LT(back.force, forth.force);
    EXPECT_EQ(contact.force_rate_when_held(forth), held);
    EXPECT_NE(contact.force_rate_when_held(back), held);
  }
  contact.accept(forth);
  return contact.trial(speed * step, time + step, step).force;
}

TEST(column_field, a_trial_leaves_no_trace) {
  ColumnField<TwentyOneParameter> field(sample_law<TwentyOneParameter>(), thickness, Sphere{0.08}.sections());
  EXPECT_EQ(force_after_probes(field, true), force_after_probes(field, false));
  NineParameterContact contact(sample_law<NineParameter>(), thickness, Sphere{0.08}.sections());
  EXPECT_EQ(force_after_probes(contact, true), force_after_probes(contact, false));
  EXPECT_EQ(contact.stations(), 0U) << "a pad that was only loaded has no columns";
}

/// Law 5's envelope on the way back returns to zero with the strain: without a rule a column in tension would
/// press again before the sphere leaves it, the harder the faster the pad recovers.
TEST(column_field, a_column_that_let_go_does_not_press_again) {
  for (const ColumnMath math : {ColumnMath::vector, ColumnMath::plain}) {
    ColumnField<TwentyOneParameter> field(sample_law<TwentyOneParameter>(), thickness,
                                          Sphere{0.08}.sections(), math);
    drive(field, 0.6 * thickness, 0.02);
    double time = 0.6 * thickness / speed;
    constexpr double slow = 0.2, fast = 20;  // m/s, back
    const auto go_back = [&](double rate, double by) {
      const double step = by / rate;
      field.accept(field.trial(-by, time, step));
      time += step;
    };
    for (int i = 0; i < 100; ++i) go_back(slow, 1e-3 * thickness);
    std::size_t let_go = field.strained_columns();
    while (let_go > 0 && field.column(let_go - 1).stress <= 0) --let_go;
    ASSERT_LT(let_go, field.strained_columns()) << "columns at the edge are in tension";
    for (int i = 0; i < 20; ++i) {
      go_back(fast, 5e-3 * thickness);
      for (std::size_t j = let_go; j < field.strained_columns(); ++j)
        EXPECT_LE(field.column(j).stress, 0) << "column " << j << ", step " << i;
    }
  }
}

TEST(column_field, starts_anew) {
  ColumnField<NineParameter> field(sample_law<NineParameter>(), thickness, Sphere{0.08}.sections());
  const double once = drive(field, 0.4 * thickness, 0.05);
  const std::size_t stations = field.stations();
  EXPECT_EQ(drive(field, 0.4 * thickness, 0.05), once);
  EXPECT_EQ(field.stations(), stations);
}

TEST(column_field, touches_as_far_as_the_sphere_reaches) {
  ColumnField<LinearViscoelastic> field(sample_law<LinearViscoelastic>(), thickness, Sphere{0.08}.sections());
  const double depth = 0.5 * thickness;
  drive(field, depth, 0.02);
  expect_relative(field.contact_radius(), std::sqrt(depth * (2 * 0.08 - depth)), 1e-12, "contact radius");
}

}  // namespace
}  // namespace dashpad::test
