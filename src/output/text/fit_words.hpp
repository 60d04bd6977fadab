#pragma once
/// What is said of a fit, in the terminal and on the page.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// By how much the model misses what is held out, or what is fitted, at most; absent where there is none.
struct Misses {
  std::optional<double> tests;    ///< root mean square over the largest stress
  std::optional<double> figures;  ///< over the stated deviation
  std::optional<double> pulses;   ///< root mean square over the measured peak
};
Misses misses(const fit::FitReport& report, bool held_out);

/// "7 unknowns from 150 points of 1 test: the data determine all of them." and how many starts came to it.
std::string fit_answer(const fit::FitReport& report);

/// What was sought though the fit file does not name it, and why; empty without.
std::string words_on_added(const fit::FitReport& report);

/// "The data determine all 5 unknowns; the model misses the tests by 1.2 % of their largest stress (root mean
/// square)."
std::string fit_headline(const fit::FitReport& report);

/// What was predicted, not fitted, and by how much that is off; empty where nothing was held out.
std::string prediction_words(const fit::FitReport& report);

/// "1.2 to 3.4 kPa", "above 1.2 kPa, open above", "open on both sides"; a natural bound ends it as well.
std::string interval_words(const fit::FittedUnknown& fitted_unknown, const UnitSystem& units);

/// What cannot be told from the data, a sentence each.
std::vector<std::string> open_matters(const fit::FitReport& report);

/// Where the noise comes from, and what correlated residuals are worth; a sentence each.
std::vector<std::string> notes_on_noise(const fit::FitReport& report);

/// "1.5 s", "15 min", "2.5 h".
std::string duration_words(double seconds);

Table table_of_unknowns(const fit::FitReport& report, const UnitSystem& units);
Table table_of_tests(const fit::FitReport& report, const UnitSystem& units);
Table table_of_figures(const fit::FitReport& report, const UnitSystem& units);
/// Peak, HIC and rebound of impacts, measured and of the model.
Table table_of_comparison(const fit::FitReport& report, const UnitSystem& units);
/// A row a loop: energy given back over energy put in.
Table table_of_loops(const fit::FitReport& report);
Table table_of_pulses(const fit::FitReport& report, const UnitSystem& units);

}  // namespace dashpad::output
