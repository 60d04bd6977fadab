#pragma once
/// The answers of a study as people and programs read them: text, JSON, a page, a still.

#include <string>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

/// Everything, in SI; a figure that is absent or not finite is null.
std::string study_json(const study::StudyAnswers& answers);

/// The answer, what was studied, and all answers as tables.
Document study_document(const study::StudyAnswers& answers, const UnitSystem& units,
                        Pictures pictures = Pictures::left_out);

/// The figure that answers the study: cushion curves, Sobol' indices, a map, curves or distributions.
Plot study_plot(const study::StudyAnswers& answers, const UnitSystem& units);

/// A factor's value with its unit; for a material (unit "") its name.
std::string shown_factor(const std::string& unit, double value, const Material& material,
                         const UnitSystem& units);

}  // namespace dashpad::output
