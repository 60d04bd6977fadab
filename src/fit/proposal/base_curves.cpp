// The slowest test as a table, and the formulas that might take its place, with where to start.

#include "fit/proposal/base_curves.hpp"

#include <algorithm>

#include "dashpad/case/case_quantity.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

namespace {

constexpr double gas = 100e3;  ///< Pa, of closed cells

double stress_at(const TableCurve& table, double strain) {
  return on_straight_lines(table.strain, table.stress, strain);
}

/// Where to start needs few digits.
double in_short(double value) { return rounded_to(value, 2); }

void seek_curve(Fit& fit, const char* key, double lowest, double highest, double start) {
  seek(fit, std::string("pad.curve.") + key, lowest, highest, start);
}

}  // namespace

std::optional<Beginning> beginning_of(const ReadTests& tests, std::vector<std::string>& remarks,
                                      std::vector<input::Fault>& faults) {
  Beginning found;
  const auto slowest = std::ranges::min_element(tests.evidence, {}, &Evidence::rate);
  found.slowest = std::size_t(slowest - tests.evidence.begin());
  const TestSource& source = tests.sources[found.slowest];
  const auto read =
      taken(input::read_stress_tables({source.file}, {.rates = {slowest->rate}}, source.columns), faults);
  if (!read) return std::nullopt;
  found.table = std::get<TableCurve>(std::get<Foam>(read->material.law).curves.base);
  // Those that begin with a name are about the test, the others about cards. The fit uses what a table leaves
  // out, and some are the reader's own.
  const std::vector<std::string>& known = tests.measurements[found.slowest].remarks;
  for (const std::string& each : read->differences) {
    const std::size_t name = each.find(": ");
    const bool is_known = std::ranges::count(known, each.substr(0, each.size() - 1)) > 0;
    if (name != std::string::npos && !is_known && each.find("left out") == std::string::npos)
      remarks.push_back(slowest->file + each.substr(name));
  }
  constexpr double small_strain = 0.05;
  const double near = std::min(small_strain, found.table.strain.back() / 4);
  found.modulus = in_short(stress_at(found.table, near) / near);
  found.plateau = in_short(stress_at(found.table, found.table.strain.back() / 3));
  for (const Evidence& shown : tests.evidence)
    found.highest_strain = std::max(found.highest_strain, shown.highest_strain);
  return found;
}

void seek(Fit& fit, const std::string& key, double lowest, double highest, double start) {
  const CaseQuantities quantities = quantities_of(fit.base);
  fit.unknowns.push_back({.key = key,
                          .unit = quantities.find(key)->unit,
                          .lowest = lowest,
                          .highest = highest,
                          .start = std::clamp(start, lowest, highest),
                          .is_logarithmic = lowest > 0 && highest > 10 * lowest});
}

std::vector<Base> formulas(const Beginning& from) {
  const double e = from.modulus, s = from.plateau, h = from.highest_strain;
  return {
      {"avalle",
       AvalleCurve{.plateau_stress = s,
                   .modulus = 1.5 * e,
                   .plateau_exponent = 1,
                   .densification_stress = s / 2,
                   .densification_exponent = 1.5,
                   .highest_strain = h},
       [](Fit& fit, const Beginning& begin) {
         seek_curve(fit, "plateau_stress", begin.plateau / 50, begin.plateau * 20, begin.plateau);
         seek_curve(fit, "modulus", begin.modulus / 20, begin.modulus * 50, 1.5 * begin.modulus);
         seek_curve(fit, "densification_stress", begin.plateau / 200, begin.plateau * 50, begin.plateau / 2);
         seek_curve(fit, "densification_exponent", 0.6, 6, 1.5);
       }},
      {"hyperfoam",
       HyperfoamCurve{.first_modulus = e / 2,
                      .first_exponent = 8,
                      .second_modulus = e / 50,
                      .second_exponent = -1,
                      .highest_strain = h},
       [](Fit& fit, const Beginning& begin) {
         seek_curve(fit, "first_modulus", begin.modulus / 100, begin.modulus * 20, begin.modulus / 2);
         seek_curve(fit, "first_exponent", 1, 50, 8);
         seek_curve(fit, "second_modulus", begin.modulus / 1e5, begin.modulus, begin.modulus / 50);
         seek_curve(fit, "second_exponent", -8, -0.1, -1);
       }},
      {"gibson-ashby",
       GibsonAshbyCurve{.modulus = 1.5 * e,
                        .plateau_stress = s,
                        .gas_pressure = std::min(gas, s),
                        .relative_density = std::min(0.05, 0.4 * (1 - h)),
                        .highest_strain = h},
       [](Fit& fit, const Beginning& begin) {
         seek_curve(fit, "modulus", begin.modulus / 20, begin.modulus * 50, 1.5 * begin.modulus);
         seek_curve(fit, "plateau_stress", begin.plateau / 50, begin.plateau * 20, begin.plateau);
         seek_curve(fit, "gas_pressure", 0, std::max(10 * gas, 10 * begin.plateau),
                    std::min(gas, begin.plateau));
         const double densest = std::min(0.5, 0.95 * (1 - begin.highest_strain));
         seek_curve(fit, "relative_density", 0, densest, std::min(0.05, 0.4 * (1 - begin.highest_strain)));
       }},
  };
}

}  // namespace dashpad::fit
