#pragma once
/// The results of a fit: a material card with its reservations and uncertainty, and a case.

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/model/pad/material.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"
#include "input/toml_tree.hpp"

namespace dashpad::fit {

/// Significant digits of what a card says was found: figures by it are those of the fit to 1e-4 and better.
inline constexpr int card_digits = 6;

/// The material with its origin: files, points, misfit, and what the data leave open as reservations. A scale
/// of the pad that was fitted is in all its stresses.
Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report);

/// The case with what was found of it, but for its foam, which is that of the finished card; nothing where
/// only numbers of a card were sought.
std::optional<FittedCase> fitted_case_of(const Fit& fit, std::span<const double> values);

/// Whether a material comes from a card, or says itself where it was tested.
bool is_stated(const Material& material);

/// Largest strain rate of an impact with these values of the unknowns, 1/s.
double rate_of(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values);

/// Ranges of recoil and HU: intervals of the fit, to the ends of what the law admits where they are open or
/// nothing tests them. Axes of what goes into the card, at most most_posterior_axes, those that move the
/// fitted figures most. A scale of the pad with a table, which has no numbers, counts as scatter. What the
/// card that the fit started from says of the rest stays. `card` is that of the fit.
dashpad::Uncertainty uncertainty_of(const Fit& fit, const Problem& problem, const Solved& solved,
                                    const FitReport& report, const Material& card);

/// The law with these values of the unknowns, and a fitted scale of the pad in its stresses.
PadLaw law_with(const Fit& fit, std::span<const double> values);

/// A sentence each; what the card said that the fit started from comes last, unless it is about an unknown.
std::vector<std::string> reservations_of(const Fit& fit, std::span<const double> values,
                                         const FitReport& report);

// Recoil: how much of the stress that the rate adds resists the way back. It is 1 where nobody says so, which
// loses nearly all energy of a fast impact. So it is sought where the data show it.

/// Whether the file, the case that it names or the card of its pad gives the number, and no card calls it
/// uncertain. `files` are those that the pad was read from.
bool states_recoil(const input::TomlNode& fit_file, const std::vector<input::InputFile>& files);

/// Whether the fitted data show how the foam unloads.
bool shows_way_back(const Fit& fit, const FitReport& report);

/// Whether the foam rests on a recoil that nobody stated and that is no unknown.
bool assumes_recoil(const Fit& fit);

/// Makes it an unknown from 0 to 1 where it is assumed and the fitted data show it: by pulses, rebound
/// speeds, contact times or velocity changes of impacts, or by a test that unloads at a higher rate than that
/// of the base curve; and where there are as many data as unknowns then.
void seek_recoil(Fit& fit);

/// Fills the report with the minimum, its uncertainty and the measurements, but not with times.
void describe(const Fit& fit, const Problem& problem, const Solved& solved, FitReport& report);

// How the material meets the measurements, fitted and held out (theory.md, section 6).

/// The comparison with a test at the points that count. `values` are those of the unknowns, `offset` is in
/// Pa.
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

/// The comparison of figures with an impact at these values of the unknowns, to the tolerance of its case.
std::vector<ImpactComparison> compared(const Fit& fit, const ImpactMeasurement& impact,
                                       std::span<const double> values);

// The misfit of impacts to which the law was not fitted, as a card states it (theory.md, section 6).

/// The kinds of figures with a misfit of their own.
enum class FigureKind { acceleration, hic, rebound, penetration };
/// The kind of a figure; none if no verdict rests on it.
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

inline constexpr std::size_t max_left_out = 8;

/// Standard deviations of what the law misses, as theory.md has them. `predicted`: of impacts that were not
/// fitted; `fitted`: the others, which count where nothing was predicted. Nothing without impacts.
std::optional<Misfit> misfit_of(std::span<const PredictedFigure> predicted,
                                std::span<const ImpactComparison> fitted);

/// Radius of a round nose over the thickness of the pad, where that differs among the impacts of the fit by
/// no more than the factor `alike`.
std::optional<double> nose_over_pad_of(const Fit& fit, double alike = 1.1);

}  // namespace dashpad::fit
