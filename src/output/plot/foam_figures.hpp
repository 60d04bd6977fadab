#pragma once
/// Plots of foams: their curves, tests of them, and the data of fits.

#include <optional>

#include "dashpad/fit/report.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// How an impact uses its foam: stress against strain in first loading at the slowest tested rate, in the
/// condition of the pad; solid and shaded up to the largest strain of the impact, dashed beyond, with a line
/// where the tests end. Of several layers, the most compressed one is shown. For a foam with a rate effect
/// the curve at the highest rate of the impact is added, and the whole range of strains is shaded.
///
/// The title says how far the foam is used. None if nothing was run or the law breaks a rule.
std::optional<Plot> foam_curve_plot(const Pad& pad, const Summary& summary, const UnitSystem& units);

/// A line across where the foam's tests end; nothing where that is not known, or at full compression.
std::optional<Series> line_of_range(const Material& material);

// The panels of a material test: one curve a rate, in the colour of its turn everywhere.

Panel stress_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// Stress over time, logarithmic for relaxation, for creep, and for runs of very different durations.
Panel stress_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units);
Panel strain_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units);
/// This panel and the following ones show the first loading.
Panel energy_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units);
Panel efficiency_over_strain(const laboratory::MaterialTestReport& report);
Panel ideality_over_strain(const laboratory::MaterialTestReport& report);
/// Efficiency over stress, with lines at the requested stress limits.
Panel efficiency_over_stress(const laboratory::MaterialTestReport& report, const UnitSystem& units);

/// Stress over strain, and what the model of a fit is off by over strain.
CaptionedPlot fit_test_figure(const fit::MetTest& test, const UnitSystem& units);
/// Deceleration over time, and what the model is off by over time.
CaptionedPlot fit_pulse_figure(const fit::MetPulse& pulse, const UnitSystem& units);

}  // namespace dashpad::output
