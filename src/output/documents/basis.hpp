#pragma once
/// The basis of a result: a row each with its value, its source and the doubts about it.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/documents/method.hpp"

namespace dashpad::output {

inline constexpr const char* basis_heading = "Basis";

struct Basis {
  std::string what;
  std::string value;
  std::string source = {};
  std::string doubt = {};
};

/// The rows as a table. Columns that are empty in all rows are left out.
Table basis_table(const std::vector<Basis>& rows);

/// Impactor, pad with its foams, support, and blows if there are several.
std::vector<Basis> case_basis(const ImpactCase& impact, const UnitSystem& units);
/// "tested up to a strain of 0.63, ..." with its density before it; empty if neither is stated.
std::string known_of(const Material& material, const UnitSystem& units);
/// The source as its card states it, or that there is none.
std::string source_of(const Material& material);
/// A foam: how far it was tested, where it comes from, what to keep in mind.
Basis foam_basis(const Material& material, const UnitSystem& units);
/// The reservations of its card, one after the other.
std::string doubts_about(const Material& material);
/// The sources of the method, and what the result takes from each.
std::vector<Basis> method_basis(const ImpactCase& impact, const Computed& computed);
/// The numerical accuracy of the solution.
Basis solver_basis(const Summary& summary);

/// The case in short, without its title.
std::vector<std::string> case_lines(const ImpactCase& impact, const UnitSystem& units);

}  // namespace dashpad::output
