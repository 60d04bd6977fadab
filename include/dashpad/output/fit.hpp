#pragma once
/// A fit for people and for programs.

#include <string>

#include "dashpad/fit/report.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The document of a fit: what was found, how certain it is, and how well the model meets each test.
Document fit_document(const fit::FitReport& report, const UnitSystem& units,
                      Pictures pictures = Pictures::left_out);
/// Everything, in SI: schema/fit.schema.json.
std::string fit_json(const fit::FitReport& report);
/// The case with what was found of it and the foam in it, as a case file. Of a fit that has one.
std::string fitted_case_toml(const fit::FitReport& report);
/// The sample of the unknowns as CSV: a header of keys with SI units, a row a draw.
std::string posterior_csv(const fit::FitReport& report);

}  // namespace dashpad::output
