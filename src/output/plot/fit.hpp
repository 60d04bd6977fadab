#pragma once
/// What a fit met, as plots.

#include "dashpad/fit/report.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Stress over strain, and what the model is off by over strain.
CaptionedPlot fit_test_figure(const fit::MetTest& test, const UnitSystem& units);
/// Deceleration over time, and what the model is off by over time.
CaptionedPlot fit_pulse_figure(const fit::MetPulse& pulse, const UnitSystem& units);

}  // namespace dashpad::output
