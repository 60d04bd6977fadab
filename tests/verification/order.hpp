#pragma once
/// Orders of convergence: of errors over sizes, and impacts led by even steps.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "impact/contacts.hpp"
#include "impact/equilibrium.hpp"
#include "impact/motion.hpp"
#include "impact/predictor.hpp"

namespace dashpad::test {

/// Slope of log(error) over log(size), by least squares.
inline double observed_order(const std::vector<double>& size, const std::vector<double>& error) {
  double x_mean = 0, y_mean = 0;
  const auto count = static_cast<double>(size.size());
  for (std::size_t i = 0; i < size.size(); ++i)
    x_mean += std::log(size[i]) / count, y_mean += std::log(error[i]) / count;
  double above = 0, below = 0;
  for (std::size_t i = 0; i < size.size(); ++i) {
    const double x = std::log(size[i]) - x_mean;
    above += x * (std::log(error[i]) - y_mean);
    below += x * x;
  }
  return above / below;
}

/// At least second order; at most `highest`.
inline void expect_order(const std::vector<double>& size, const std::vector<double>& error,
                         const std::string& what, double highest = 2.2) {
  fmt::print("{:44}", what);
  for (const double e : error) fmt::print(" {:8.1e}", e);
  const double order = observed_order(size, error);
  fmt::print("   order {:.2f}\n", order);
  EXPECT_GE(order, 1.8) << what;
  EXPECT_LE(order, highest) << what;
}

/// The state after `steps` even steps of loading. The integral over the contact is at one resolution: all
/// columns are laid at once, or all panels are as many.
inline State loaded_for(const ImpactCase& impact, double time, int steps, double resolution = 0.01) {
  State end;
  Contacts().visit(impact, ColumnMath::vector, [&]<class Contact>(Contact& contact) {
    const Foundation foundation(impact.support, impact.backing, impact.impactor.mass);
    Motion<Contact> motion(impact.impactor, foundation, contact);
    Equilibrium<Contact> equilibrium(contact, foundation, motion, impact.pad.thickness);
    Predictor predictor;
    const double step = time / steps;
    contact.start(resolution, impact.impactor.speed * time);
    motion.start(impact.impactor.speed, 0);
    equilibrium.start(1e-4);  // residuals far below the errors of the steps
    predictor.start(impact.impactor.speed, contact.trial(impact.impactor.speed * step, 0, step).force /
                                               (impact.impactor.speed * step));
    for (int i = 0; i < steps; ++i) {
      const Trial trial = equilibrium.loading(step, predictor);
      ASSERT_EQ(trial.obstacle, Event::none);
      const State before = motion.now();
      contact.accept(trial.pad);
      predictor.learn(Phase::loading, before, trial, Event::none);
      motion.accept(trial.end, step, true);
    }
    end = motion.now();
  });
  return end;
}

}  // namespace dashpad::test
