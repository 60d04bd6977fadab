#pragma once
/// How a material meets the measurements, those that it was fitted to and others (theory.md, section 6).

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "dashpad/model/pad/material.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

/// Of the points of a test that count; `values` of the unknowns, `offset` in Pa.
MetTest met_test(const Fit& fit, const MaterialMeasurement& test, std::span<const double> values,
                 double offset);

/// The figures of an impact, to the tolerance of its case.
std::vector<MetFigure> met_figures(const Fit& fit, const ImpactMeasurement& impact,
                                   std::span<const double> values);

/// The pulse of an impact that has one, to the tolerance of its case; `shift` is the coordinate of its shift.
MetPulse met_pulse(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values,
                   std::optional<std::size_t> shift);

/// Rates of the pieces between points that count, 1/s: the 5th and the 95th percentile of their magnitudes
/// by the way that they go.
struct RateRange {
  double lowest = 0, highest = 0;
};
RateRange rates_of(const MaterialMeasurement& test);

/// Of an impact with these values of the unknowns, to the tolerance of its case.
std::vector<ImpactComparison> compared(const Fit& fit, const ImpactMeasurement& impact,
                                       std::span<const double> values);

// By what the law misses impacts that it was not fitted to: what a card says of that (theory.md, section 6).

/// What a misfit is told of.
enum class FigureKind { acceleration, hic, rebound, penetration };
/// Nothing for figures on which no verdict rests.
std::optional<FigureKind> kind_of(ImpactFigure figure);

/// A figure of an impact that was predicted.
struct PredictedFigure {
  ImpactComparison of;
  double by_unknowns = 0;  ///< standard deviation of it by the uncertainty of the unknowns, a share
};

/// The figures of the impacts that are held out, and of each fitted impact as a fit to the others predicts
/// it: the search goes on without it from the minimum. Of more than most_left_out impacts, several are left
/// out together. Nothing of impacts without which there is no fit.
std::vector<PredictedFigure> predicted_figures(const Fit& fit, const Problem& problem, const Solved& solved,
                                               int runs, Session& session,
                                               std::atomic<std::size_t>& evaluations);

inline constexpr std::size_t most_left_out = 8;

/// Standard deviations of what the law misses. `predicted`: of impacts that were not fitted; `fitted`: the
/// others, which count where nothing was predicted. Nothing without impacts.
///
///   s^2 = (n0 s0^2 + sum of max(e^2 - u^2, 0)) / (n0 + n),   times t(n0 + n) / t(infinity), both at 97.5 %
///
/// e are the shares by which they were missed, u what the unknowns and the noise of the measurement explain.
/// s0 is how sure a law of few numbers is at best, 2 % of stresses, and counts like n0 impacts.
std::optional<Misfit> misfit_of(std::span<const PredictedFigure> predicted,
                                std::span<const ImpactComparison> fitted);

/// Radius of a round nose over the thickness of the pad, where that differs among the impacts of the fit by
/// no more than the factor `alike`.
std::optional<double> nose_over_pad_of(const Fit& fit, double alike = 1.1);

}  // namespace dashpad::fit
