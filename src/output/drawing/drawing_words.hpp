#pragma once
/// What the drawing says in words.

#include <string>
#include <vector>

#include "dashpad/quantities/unit_system.hpp"
#include "output/drawing/layout.hpp"
#include "output/drawing/moment.hpp"

namespace dashpad::output {

/// "cylinder on its side, 120 mm across, 150 mm long"
std::string nose_words(const Nose& nose, const UnitSystem& units);

/// "Struck through", or the layers that are; empty for a pad that is not.
std::string alarm_words(const DrawnMoments& moments);

/// "Strain on the axis 0.81"; of layers, each one's or the largest.
std::string strain_words(const DrawnMoments& moments);

/// The title: that of the case, or what strikes what.
std::string drawing_title(const ImpactCase& impact);

/// The whole drawing for who does not see it, and what in it is not to scale.
std::string drawing_description(const ImpactCase& impact, const DrawnMoments& moments, const Layout& layout,
                                const UnitSystem& units);

}  // namespace dashpad::output
