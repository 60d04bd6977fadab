#pragma once
/// One impact as a drawing to scale: nose, pad and support at first contact and at greatest penetration.

#include <string>
#include <string_view>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// One complete `<svg>` element, which is a file as it is and can stand in a page: it has no script and
/// refers to nothing outside itself. Columns are shaded by their strain; what is left of the pad, its
/// penetration and the deflection of its support are dimensions in `units`. Parts of the support are symbols.
///
/// `solution` is that of solve(), of a series that of the blow which `impact` is on its pad. A case that
/// breaks a rule (violations()) gives an element that says so.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units);

/// The same as the bytes of a picture file; PNG and PDF are for light paper. Throws std::runtime_error if
/// they cannot be made.
std::string impact_drawing(const ImpactCase& impact, const Solution& solution, const UnitSystem& units,
                           PictureFormat format);

/// The text of the drawing's `<style>`, always the same: for a page whose policy admits styles by their
/// hashes.
std::string_view impact_drawing_style();

}  // namespace dashpad::output
