#pragma once
/// The effect of each number of a case on the figures of its impact, as people and programs read it.

#include <string>

#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/sensitivity/sensitivity.hpp"

namespace dashpad::output {

/// "Peak acceleration depends most on the impact speed (1 % more: +1.12 %), then on ...".
/// `figure` is one of the answer's.
std::string sensitivity_answer(const sensitivity::Answer& answer, std::size_t figure);

/// The answer about one figure, then what 1 % of each number does to all figures, and what the foam's doubt
/// does. `file` is the case file.
Document sensitivity_document(const sensitivity::Answer& answer, std::size_t figure, const std::string& file,
                              const UnitSystem& units, Pictures pictures = Pictures::left_out);

/// A tornado: what 1 % of each number does to the figure, the largest on top.
Plot sensitivity_plot(const sensitivity::Answer& answer, std::size_t figure);

/// Everything in SI, accelerations in m/s2, as derivatives are; what is unknown is null.
std::string sensitivity_json(const sensitivity::Answer& answer, const std::string& file);

/// A row for each number and figure: values, elasticity with its error, course, derivative.
std::string sensitivity_csv(const sensitivity::Answer& answer);

}  // namespace dashpad::output
