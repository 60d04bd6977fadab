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

/// The card of a fit: the material with its origin, and with what the data leave open as reservations. Its
/// stresses include a fitted scale of the pad.
Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report);

/// The case with the fitted values, but for its foam; none if only numbers of a card were sought.
std::optional<FittedCase> fitted_case_of(const Fit& fit, std::span<const double> values);

/// Whether a material comes from a card, or says itself where it was tested.
bool is_stated(const Material& material);

/// Largest strain rate of an impact with these values of the unknowns, 1/s.
double rate_of(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values);

/// The uncertainty for the card. Recoil and HU get the intervals of the fit, up to the limits of the law
/// where these are open or untested. Of the principal axes, at most max_posterior_axes are kept, those that
/// move the fitted figures most. A scale of a pad with a table counts as scatter. All else stays as on the
/// card from which the fit started. `card` is that of the fit.
dashpad::Uncertainty uncertainty_of(const Fit& fit, const Problem& problem, const Solved& solved,
                                    const FitReport& report, const Material& card);

/// The law with these values of the unknowns, and a fitted scale of the pad in its stresses.
PadLaw law_with(const Fit& fit, std::span<const double> values);

/// A sentence each; what the card said that the fit started from comes last, unless it is about an unknown.
std::vector<std::string> reservations_of(const Fit& fit, std::span<const double> values,
                                         const FitReport& report);

// Recoil is the share of the stress added by the rate that resists the way back. Its default is 1, with which
// a fast impact loses nearly all its energy; so the fit seeks it where the data show it.

/// Whether the file, its case or the card of its pad gives the number, and no card calls it uncertain.
/// `files` are those from which the pad was read.
bool states_recoil(const input::TomlNode& fit_file, const std::vector<input::InputFile>& files);

/// Whether the fitted data show how the foam unloads.
bool shows_way_back(const Fit& fit, const FitReport& report);

/// Whether the foam rests on a recoil that nobody stated and that is no unknown.
bool assumes_recoil(const Fit& fit);

/// Makes recoil an unknown from 0 to 1 if it is assumed and the fitted data show it, by pulses, rebound
/// speeds, contact times or velocity changes of impacts, or by a test that unloads faster than the base curve
/// was measured; and if there are enough data.
void seek_recoil(Fit& fit);

// How the material meets the measurements, fitted and held out (theory.md, section 6).

/// The comparison with a test at the points that count, at values of the unknowns; `offset` is in Pa.
MetTest met_test(const Fit& fit, const MaterialMeasurement& test, std::span<const double> values,
                 double offset);

/// The figures of an impact, to the tolerance of its case.
std::vector<MetFigure> met_figures(const Fit& fit, const ImpactMeasurement& impact,
                                   std::span<const double> values);

/// The pulse of an impact that has one, to the tolerance of its case; `shift` is the coordinate of its shift.
MetPulse met_pulse(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values,
                   std::optional<std::size_t> shift);

/// Strain rates between points that count, 1/s: 5th and 95th percentile by distance of their magnitudes.
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

/// Predicted figures: of held-out impacts, and of each fitted impact from a fit to the others, which
/// continues from the minimum. Of more than max_left_out impacts, several are left out together. Impacts
/// without which there is no fit are skipped.
std::vector<PredictedFigure> predicted_figures(const Fit& fit, const Problem& problem, const Solved& solved,
                                               int runs, Session& session,
                                               std::atomic<std::size_t>& evaluations);

/// The standard deviations of what the law misses (theory.md). `predicted` are impacts that were not fitted;
/// the `fitted` ones count if there are none. Nothing without impacts.
std::optional<Misfit> misfit_of(std::span<const PredictedFigure> predicted,
                                std::span<const ImpactComparison> fitted);

/// The radius of a round nose over the pad's thickness, if it varies by no more than the factor `alike`.
std::optional<double> nose_over_pad_of(const Fit& fit, double alike = 1.1);

}  // namespace dashpad::fit
